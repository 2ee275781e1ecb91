"""Writes the measured errors of study/results/classes.csv into include/airlight/nodes_for.hpp, rounded up.

    python3 study/nodes_table.py

Run it after study/run; the unit tests of nodes_for compare the two.
"""
import csv
import math
import pathlib

ROOT = pathlib.Path(__file__).resolve().parent.parent
HEADER = ROOT / "include/airlight/nodes_for.hpp"
COUNTS = ("4", "5", "6", "8", "10", "12", "16", "24")
AIRS = ("no ozone", "ozone", "thick")
SUNS = ("sun_mu >= 0.1", "0 <= sun_mu < 0.1", "-0.1 <= sun_mu < 0", "sun_mu < -0.1")
KINDS = [("air", air, sun) for air in AIRS for sun in SUNS] + [("space", air, "any") for air in AIRS]


def up(text):
    """Rounded up to two digits, as a literal."""
    value = float(text)
    unit = 10 ** (math.floor(math.log10(value)) - 1)
    return f"{math.ceil(value / unit - 1e-9) * unit:.1e}"


def main():
    with open(ROOT / "study/results/classes.csv") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    found = {(r["nodes"], r["eye"], r["air"], r["sun"]): r for r in rows}
    text = HEADER.read_text()
    for name in ("p95", "max"):
        lines = []
        for eye, air, sun in KINDS:
            values = ", ".join(up(found[n, eye, air, sun][name]) for n in COUNTS)
            label = f"{'thick' if air == 'thick' else air}, {'from space' if eye == 'space' else sun}"
            lines.append(f"    {{{values}}},  // {label}")
        begin = text.index(f"node_error_{name}[15][8] = {{\n") + len(f"node_error_{name}[15][8] = {{\n")
        end = text.index("};", begin)
        text = text[:begin] + "\n".join(lines) + "\n" + text[end:]
    HEADER.write_text(text)


if __name__ == "__main__":
    main()
