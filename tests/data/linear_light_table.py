"""Solid angle and irradiance of a strip of light, exactly: as the rectangle that it is.

The strip lies in the plane z = 0 along x with its middle in the origin and shines to z > 0. The solid angle is that of a
rectangle; the irradiance is Lambert's sum over the edges of the polygon that is left above the surface's own plane.
"""

from mpmath import acos, atan, mpf, pi, sqrt

from reference import Sampler, f32, write_table

sampler = Sampler(61)


def solid_angle(half_length, width, p):
    x, y, z = (mpf(v) for v in p)
    if z <= 0:
        return mpf(0)
    total = mpf(0)
    for sx in (1, -1):
        for sy in (1, -1):
            a = sx * half_length - x
            b = sy * width / 2 - y
            total += sx * sy * atan(a * b / (z * sqrt(a * a + b * b + z * z)))
    return total


def dot(a, b):
    return sum(u * v for u, v in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def irradiance(half_length, width, p, normal):
    """Over radiance."""
    x, y, z = (mpf(v) for v in p)
    if z <= 0:
        return mpf(0)
    n = [mpf(v) for v in normal]
    size = sqrt(dot(n, n))
    n = [v / size for v in n]
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    polygon = [[sx * half_length - x, sy * width / 2 - y, -z] for sx, sy in corners]
    above = []
    for i, here in enumerate(polygon):
        there = polygon[(i + 1) % 4]
        h, t = dot(n, here), dot(n, there)
        if h >= 0:
            above.append(here)
        if (h < 0) != (t < 0):
            s = h / (h - t)
            above.append([u + s * (v - u) for u, v in zip(here, there)])
    total = mpf(0)
    for i, here in enumerate(above):
        there = above[(i + 1) % len(above)]
        edge = cross(here, there)
        size = sqrt(dot(edge, edge))
        if size == 0:
            continue
        angle = acos(min(mpf(1), max(mpf(-1), dot(here, there) / sqrt(dot(here, here) * dot(there, there)))))
        total += angle * dot(n, edge) / size
    return abs(total) / 2


def place(half_length, near, far):
    """At a distance from the strip's line, over any part of it and past its ends."""
    d = sampler.log_uniform(near, far)
    angle = sampler.uniform(0.03, float(pi) - 0.03)
    from mpmath import cos, sin

    return [f32(sampler.uniform(-2.5, 2.5) * half_length), f32(d * cos(angle)), f32(d * sin(angle))]


rows = []
for width in (100.0, 1.0):
    for kind, near, far, count in (("far", 30, 300, 120), ("middle", 4, 30, 120), ("near", 0.05, 4, 80)):
        for i in range(count):
            half_length = f32(sampler.log_uniform(50, 200) * width)
            p = place(half_length, near * width, far * width)
            n = [sampler.uniform(-1, 1) for _ in range(3)]
            rows.append([kind, half_length, width, *p, *n, solid_angle(mpf(half_length), mpf(width), p),
                         irradiance(mpf(half_length), mpf(width), p, n)])

write_table(
    "linear_light",
    """solid angle [sr] and irradiance over radiance [sr] at (x, y, z), for a surface with the normal (nx, ny, nz), not
    yet normalised, of a strip in z = 0 along x; near: within 4 widths of its line, middle 4 to 30, far 30 to 300""",
    ["kind", "half_length", "width", "x", "y", "z", "nx", "ny", "nz", "solid_angle", "irradiance"],
    rows,
)
