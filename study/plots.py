#!/usr/bin/python3
"""Draws study/results/*.png from the tables beside them (Debian: python3-matplotlib).

usage: plots.py [folder]      default: the folder results beside this script
"""

import csv
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

STYLE = {  # method: title, colour
    "single_scattering": ("airlight, nodes", "#c0392b"),
    "single_scattering_marched": ("airlight, marched", "#e59866"),
    "leenman": ("Leenman, to 256x64", "#1f618d"),
    "cs562": ("CS562, table", "#7d3c98"),
    "double_loop": ("double loop", "#117864"),
    "hillaire": ("Hillaire, table", "#b7950b"),
    "schueler": ("Schueler", "#707b7c"),
    "hdrp": ("HDRP", "#2e86c1"),
}
WORLDS = {
    "leenman": "Leenman's Earth, Lorentzian ozone",
    "cs562": "CS562's hazy Earth",
    "earth": "Earth, ozone as a tent",
    "mars": "Mars",
    "thick": "ten times the molecules",
}


def read(folder, name):
    with open(os.path.join(folder, name), encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def save(figure, folder, name):
    path = os.path.join(folder, name)
    temporary = path + ".part"
    figure.savefig(temporary, format="png", dpi=100)
    os.replace(temporary, path)
    plt.close(figure)
    print(path)


def plain(number, _):
    return "%g" % number


def bare(axes):
    axes.xaxis.set_major_formatter(plain)
    axes.yaxis.set_major_formatter(plain)
    axes.spines[["top", "right"]].set_visible(False)
    axes.grid(True, which="major", alpha=0.3)


def first_number(setting):
    return int("".join(c if c.isdigit() else " " for c in setting).split()[0])


def spread(places, gap):
    """The places moved apart so that neighbours in a column are `gap` apart."""
    order = sorted(range(len(places)), key=lambda i: places[i])
    moved = list(places)
    for _ in range(200):
        for a, b in zip(order, order[1:]):
            lack = gap - (moved[b] - moved[a])
            if lack > 0:
                moved[a] -= lack / 2
                moved[b] += lack / 2
    return moved


def label_ends(axes, ends):
    """Names right of the lines' last points, moved apart where they would overlap."""
    transform, inverse = axes.transData, axes.transAxes.inverted()
    points = [inverse.transform(transform.transform((x, y))) for x, y, _, _ in ends]
    heights = spread([p[1] for p in points], 0.045)
    for (_, _, text, colour), point, height in zip(ends, points, heights):
        axes.annotate(text, point, (1.02, height), "axes fraction", "axes fraction", color=colour, fontsize=9,
                      va="center", arrowprops={"arrowstyle": "-", "color": colour, "lw": 0.5, "alpha": 0.6},
                      annotation_clip=False)


def gpu_cycles(folder):
    """Inverse throughput of each setting as a multiple of Leenman's 16x6; CS562's samples are steps and one more."""
    path = os.path.join(folder, "..", "..", "bench", "shader_cost")
    if not os.path.exists(os.path.join(path, "results.csv")):
        return {}
    cycles = {}
    for row in read(path, "results.csv"):
        if row["flags"] == "default" and row["method"] in STYLE:
            setting = row["setting"]
            if row["method"] == "cs562":
                setting = str(int(setting) - 1)
            if row["method"] == "double_loop":
                setting = "{0}x({0}+{0})".format(setting)
            cycles[row["method"], setting] = float(row["inverse_throughput_cycles"])
    unit = cycles.get(("leenman", "16x6"))
    return {key: value / unit for key, value in cycles.items()} if unit else {}


def error_over_cost(folder, cost, what, name):
    errors = {(r["method"], r["setting"]): r for r in read(folder, "errors.csv") if r["views"] == "suite"}
    cost = {key: value for key, value in cost.items() if key in errors}
    figure, both = plt.subplots(1, 2, figsize=(13, 5.6))
    figure.subplots_adjust(left=0.06, right=0.87, wspace=0.62, bottom=0.11, top=0.92)
    for axes, column, title in zip(both, ("p95", "max"), ("95 % of the views are better", "the worst view")):
        ends = []
        for method, (method_title, colour) in STYLE.items():
            rows = sorted((c, s) for (m, s), c in cost.items() if m == method)
            if not rows:
                continue
            xs = [c for c, _ in rows]
            ys = [100 * float(errors[method, s][column]) for _, s in rows]
            bold = method == "single_scattering"
            axes.plot(xs, ys, "o-", color=colour, lw=2.6 if bold else 1.4, ms=6 if bold else 4, zorder=3 if bold else 2)
            for i, (x, y, (_, setting)) in enumerate(zip(xs, ys, rows)):
                if not bold and (method != "leenman" or i == len(xs) - 1):
                    continue
                # Left of a falling line; above it where it lies flat.
                flat = bold and i > 0 and ys[i - 1] < 1.4 * y
                left = not flat and (bold or i == 0)
                place = {"xytext": (2, 5), "ha": "left"} if flat else {"xytext": (-6, -4), "ha": "right"}
                place = place if flat or left else {"xytext": (4, 5), "ha": "left"}
                axes.annotate(setting, (x, y), textcoords="offset points", fontsize=8 if bold else 7, color=colour, **place)
            ends.append((xs[-1], ys[-1], method_title, colour))
        axes.set(xscale="log", yscale="log", xlabel=what, ylabel="error of the luminance, %")
        axes.set_title(title, fontsize=10)
        bare(axes)
        figure.canvas.draw()
        label_ends(axes, ends)
    save(figure, folder, name)


def convergence(folder):
    figure, axes = plt.subplots(figsize=(8.2, 5.6))
    figure.subplots_adjust(left=0.1, right=0.76, bottom=0.11, top=0.93)
    rows = [r for r in read(folder, "errors.csv") if r["views"] == "suite"]
    ends = []
    for method, (name, colour) in STYLE.items():
        points = sorted((first_number(r["setting"]), 100 * float(r["rms"])) for r in rows if r["method"] == method)
        if not points:
            continue
        xs, ys = zip(*points)
        bold = method == "single_scattering"
        axes.plot(xs, ys, "o-", color=colour, lw=2.6 if bold else 1.4, ms=6 if bold else 4)
        ends.append((xs[-1], ys[-1], name, colour))
    axes.set(xscale="log", yscale="log", xlabel="steps or nodes along the view ray", ylabel="error, root mean square, %")
    axes.set_title("What more steps bring", fontsize=10)
    for order, start in ((1, 60), (2, 12)):
        xs = (16, 128)
        axes.plot(xs, [start, start / 8**order], "--", color="0.6", lw=1)
        axes.annotate("order %d" % order, (xs[1], start / 8**order), (3, -3), textcoords="offset points", color="0.45", fontsize=8)
    bare(axes)
    figure.canvas.draw()
    label_ends(axes, ends)
    save(figure, folder, "convergence.png")


def error_per_view(folder):
    rows = read(folder, "views.csv")
    shown = [
        ("leenman 16x6", STYLE["leenman"][1]),
        ("double_loop 64x(64+64)", STYLE["double_loop"][1]),
        ("single_scattering 8", STYLE["single_scattering"][1]),
        ("single_scattering 16", "#f1948a"),
    ]
    shown = [s for s in shown if s[0] in rows[0]]
    figure, all_axes = plt.subplots(len(WORLDS), 1, figsize=(11, 12), sharex=True)
    figure.subplots_adjust(left=0.08, right=0.83, hspace=0.22, top=0.965, bottom=0.05)
    for axes, (world, title) in zip(all_axes, WORLDS.items()):
        here = [r for r in rows if r["world"] == world]
        ends = []
        for column, colour in shown:
            ys = [max(100 * float(r[column]), 1e-5) for r in here]
            axes.plot(range(len(here)), ys, ".", ms=4.5, color=colour)
            median = sorted(ys)[len(ys) // 2]
            ends.append((len(here) - 1, median, column.replace("single_scattering", "airlight, nodes"), colour))
        groups = [r["kind"] + r["view"].split(";")[0] for r in here]
        starts = [i for i in range(len(here)) if i == 0 or groups[i] != groups[i - 1]]
        for start in starts[1:]:
            axes.axvline(start - 0.5, color="0.8", lw=0.8)
        if axes is all_axes[-1]:
            middles = [(a + b - 1) / 2 for a, b in zip(starts, starts[1:] + [len(here)])]
            names = {"surface200 m": "surfaces"}
            axes.set_xticks(middles, [names.get(groups[i], here[i]["view"].split(";")[0]) for i in starts], fontsize=9)
            axes.tick_params(axis="x", length=0)
        axes.set(yscale="log", ylabel="error, %", xlim=(-1, len(here)))
        axes.set_title(title, fontsize=10, loc="left")
        axes.spines[["top", "right"]].set_visible(False)
        axes.grid(True, axis="y", alpha=0.3)
        figure.canvas.draw()
        label_ends_wide(axes, ends)
    save(figure, folder, "error_per_view.png")


def label_ends_wide(axes, ends):
    """The same for low panels: names at their median's height, without a line to it."""
    transform, inverse = axes.transData, axes.transAxes.inverted()
    heights = spread([inverse.transform(transform.transform((x, y)))[1] for x, y, _, _ in ends], 0.13)
    for (_, _, text, colour), height in zip(ends, heights):
        axes.text(1.01, height, text, color=colour, fontsize=9, va="center", transform=axes.transAxes)


def main():
    if "-h" in sys.argv or "--help" in sys.argv:
        print(__doc__.strip())
        return
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(os.path.abspath(__file__)), "results")
    for name in ("errors.csv", "cost.csv", "views.csv"):
        if not os.path.exists(os.path.join(folder, name)):
            sys.exit("plots.py: %s is not there; run study --all first" % os.path.join(folder, name))
    cpu = {(r["method"], r["setting"]): float(r["ratio"]) for r in read(folder, "cost.csv")}
    error_over_cost(folder, cpu, "CPU time, Leenman's 16x6 = 1", "error_over_cpu.png")
    gpu = gpu_cycles(folder)
    if gpu:
        error_over_cost(folder, gpu, "GPU cycles, Leenman's 16x6 = 1", "error_over_gpu.png")
    convergence(folder)
    error_per_view(folder)


if __name__ == "__main__":
    main()
