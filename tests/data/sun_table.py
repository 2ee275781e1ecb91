#!/usr/bin/python3
"""The sun's disc: solid angle, spread limb darkening, the middle of a setting disc, and the lobe of the Elek notes."""

from mpmath import acos, mpf, pi, quad, sqrt

from reference import Sampler, f32, figure, write_table

sampler = Sampler(32)
rows = []


def add(name, value, condition, *arguments):
    cells = [float(a) for a in arguments] + [0.0] * (3 - len(arguments))
    rows.append([name, *cells, value, figure(condition)])


def solid_angle(sine):
    return 2 * pi * (1 - sqrt(1 - sine * sine))


def windowed(x, half_width, power):
    """The mean of max(s, 0)^power over the window, by its integral."""
    if half_width == 0:
        return mpf(0) if x < 0 else x**power
    above, below = max(x + half_width, 0), max(x - half_width, 0)
    return (above ** (power + 1) - below ** (power + 1)) / (2 * half_width * (power + 1))


def limb(square, exponent, spread):
    """Mean over the window, and the same of the whole disc's light, each by its integral."""
    power = exponent / 2
    if spread == 0:
        return (1 + power) * (1 - square) ** power if square < 1 else mpf(0)
    below, above = max(square - spread, -10**9), min(square + spread, 1)
    if below >= 1:
        return mpf(0)
    here = quad(lambda q: (1 - q) ** power, [below, above]) / (2 * spread)
    edges = sorted({mpf(0), abs(1 - spread), 1 + spread})
    whole = quad(lambda q: windowed(1 - q, spread, power), edges)
    return here / whole


def limb_condition(square, exponent, spread, value):
    """1 / (1 - q) bounds how the rim amplifies the square's rounding; a window softens it."""
    away = max(abs(1 - square), spread, mpf(2) ** -24)
    return (value + 1) * (1 + 1 / away)


def middle(gap):
    """Centroid of what lies above the horizon, by the integral of height times width."""
    if gap >= 1:
        return mpf(0)
    area = quad(lambda y: 2 * sqrt((1 - y) * (1 + y)), [-gap, 1])
    return quad(lambda y: 2 * y * sqrt((1 - y) * (1 + y)), [-gap, 1]) / area


def lobe(cos_theta, g):
    return (1 - g) ** 2 / (4 * pi * (1 + g * g - 2 * g * cos_theta) ** mpf(1.5))


def lobe_condition(c, g):
    d = 1 + g * g - 2 * g * c
    by_g = abs(-2 / (1 - g) - 3 * (g - c) / d) * abs(g)
    return lobe(c, g) * (1 + by_g + 3 * abs(g * c) / d)


for s in (0.0, f32(1e-6), f32(0.00465), 0.25, 0.5, f32(0.9), 1.0):
    # d/ds is 2 pi s / cos, which is infinite at 1: there only the value counts.
    slope = 2 * pi * mpf(s) ** 2 / sqrt(1 - mpf(s) ** 2) if s < 1 else mpf(0)
    add("solid_angle", solid_angle(mpf(s)), solid_angle(mpf(s)) + slope, s)

squares = [0.0, 0.25, 0.5, f32(0.9), f32(0.99), f32(0.9999), 1.0, f32(1.001), 1.5]
for exponent in (0.0, f32(0.397), f32(0.652), 1.0, 2.0):
    for spread in (0.0, f32(1e-4), f32(0.01), 0.25, 1.0, 4.0, 512.0):
        for square in squares + [sampler.uniform(0, 1), f32(1 + spread / 2)]:
            value = limb(mpf(square), mpf(exponent), mpf(spread))
            add("limb", value, limb_condition(mpf(square), mpf(exponent), mpf(spread), value), square, exponent, spread)

for gap in (-1.0, f32(-0.999), -0.5, 0.0, 0.5, f32(0.9), 1.0):
    add("middle", middle(mpf(gap)) if gap > -1 else mpf(1), mpf(1), gap)

for g in (f32(0.99), f32(0.9), 0.0, -0.5):
    for c in (1.0, f32(0.9998), 0.5, 0.0, -1.0):
        add("lobe", lobe(mpf(c), mpf(g)), lobe_condition(mpf(c), mpf(g)), c, g)

write_table(
    "sun",
    """solid_angle: a = sine; limb: a = square, b = exponent, c = spread; middle: a = gap; lobe: a = cosine, b = g""",
    ["function", "a", "b", "c", "expected", "condition"],
    rows,
)
