#!/usr/bin/python3
"""Segments of circles, and what is left in sight of an even and of a limb-darkened disc behind another."""

from mpmath import acos, mpf, pi, quad, sqrt

from reference import Sampler, f32, figure, write_table

sampler = Sampler(31)
rows = []


def lens_share(gap, curvature):
    """Area of the unit disc beside a disc of radius 1 / curvature, by the two sectors and the kite between them."""
    if gap >= 1:
        return mpf(1)
    if curvature == 0:
        return 1 - (acos(gap) - gap * sqrt(1 - gap**2)) / pi if gap > -1 else mpf(0)
    other = 1 / curvature
    between = other + gap
    if between <= abs(1 - other):
        return 1 - other**2 if other < 1 else mpf(0)
    mine = acos((between**2 + 1 - other**2) / (2 * between))
    its = acos((between**2 + other**2 - 1) / (2 * between * other))
    kite = sqrt((-between + 1 + other) * (between + 1 - other) * (between - 1 + other) * (between + 1 + other)) / 2
    return 1 - (mine + other**2 * its - kite) / pi


def ring_share(radius, gap, curvature):
    """Share of a circle of that radius, around the disc's centre, that the other disc leaves in sight."""
    if curvature == 0:
        cosine = gap / radius
    else:
        between = 1 / curvature + gap
        cosine = (radius**2 + gap * (2 / curvature + gap)) / (2 * radius * between)
    return mpf(1) if cosine >= 1 else mpf(0) if cosine <= -1 else 1 - acos(cosine) / pi


def light_share(gap, curvature, exponent):
    """Rings of light: the integral over z, the cosine on the sun's sphere, with radius^2 = 1 - z^2."""
    contacts = [mpf(0), mpf(1)]
    edges = [abs(gap)] if curvature == 0 else [abs(gap), abs(2 / curvature + gap)]
    contacts += [sqrt(1 - r * r) for r in edges if r < 1]
    contacts = sorted(set(contacts))
    seen = quad(lambda z: z ** (1 + exponent) * ring_share(sqrt((1 - z) * (1 + z)), gap, curvature), contacts)
    return seen * (2 + exponent)


def condition(gap, curvature, value):
    """sum |df/dx| |x| + |f|, by differences that 65 digits make exact enough."""
    step = mpf(10) ** -20
    total = abs(value)
    if abs(gap) < 1:
        total += abs(lens_share(gap + step, curvature) - value) / step * abs(gap)
        total += abs(lens_share(gap, curvature + step) - value) / step * curvature
    return total


for t in (0.0, 1.0, f32(1 - 2**-24), f32(1e-6), 0.25, 0.5, 0.75):
    x = mpf(t)
    area = acos(x) - x * sqrt(1 - x * x)
    rows.append(["segment", t, 0.0, 0.0, area / sqrt(1 - x * x) ** 3 if t < 1 else mpf(2) / 3, figure(mpf(1))])

curvatures = [0.0, f32(1e-3), f32(0.0047), 0.25, 0.5, f32(0.95), 1.0, f32(1.05), 1.5, 2.0, 8.0, 1024.0]
gaps = [-1.0, f32(-0.9999), f32(-0.9), -0.5, f32(-1e-3), 0.0, f32(1e-3), 0.5, f32(0.9), f32(0.9999), 1.0]
for curvature in curvatures:
    for gap in gaps + [sampler.uniform(-1, 1) for _ in range(6)]:
        if curvature * gap > -1:
            value = lens_share(mpf(gap), mpf(curvature))
            rows.append(["share", gap, curvature, 0.0, value, figure(condition(mpf(gap), mpf(curvature), value))])

for curvature in (0.0, f32(0.0047), f32(0.95), f32(1.05), 1.5, 4.0):
    # The worst found: a disc two thirds as wide that touches the rim from within.
    for gap in (f32(-0.95), f32(-0.7), f32(-0.66), f32(-0.34), -0.25, 0.0, f32(0.3), 0.75, f32(0.97)):
        for exponent in (f32(0.397), f32(0.652)):
            if curvature * gap > -1:
                value = light_share(mpf(gap), mpf(curvature), mpf(exponent))
                rows.append(["light", gap, curvature, exponent, value, figure(mpf(1))])

write_table(
    "occultation",
    """segment: a = distance of the chord [1]; share and light: a = gap, b = curvature, c = limb exponent [1]""",
    ["function", "a", "b", "c", "expected", "condition"],
    rows,
)
