"""Light of strips that a habitat's air turns into a view ray, once scattered, by brute force.

The strip is the rectangle that it is: rules of Gauss and Legendre over its length, its width, the view ray and, for what
passes, over every way between strip, place and eye. Each rule is fine enough that twice as fine moves the results by less
than 1e-6; no formula of the library is used. Needs Debian's python3-numpy.
"""

import numpy

from reference import Sampler, f32, write_table

sampler = Sampler(62)
DIGITS = 7

R, L = 8e3, 24e3
RISE = f32(7.36e-9)
RAYLEIGH = numpy.array([f32(v) for v in (5.802e-6, 13.558e-6, 33.1e-6)])
MIE_SCATTERING = f32(3.996e-6)
MIE_ABSORPTION = f32(0.44e-6)
G = f32(0.8)
WIDTH = 100.0
HALF = f32(5500)


def rule(count, begin, end):
    x, w = numpy.polynomial.legendre.leggauss(count)
    return begin + (end - begin) * (x + 1) / 2, w * (end - begin) / 2


def pieces(cuts, count):
    parts = [rule(count, a, b) for a, b in zip(cuts[:-1], cuts[1:])]
    return numpy.concatenate([p[0] for p in parts]), numpy.concatenate([p[1] for p in parts])


def density(p):
    return numpy.exp(RISE * (p[..., 1] ** 2 + p[..., 2] ** 2 - R * R))


def column(a, b):
    s, w = rule(10, 0, 1)
    total = 0
    for si, wi in zip(s, w):
        total = total + wi * density(a + si * (b - a))
    return total * numpy.sqrt(((b - a) ** 2).sum(-1))


def passed(depth_column):
    extinction = RAYLEIGH + MIE_SCATTERING + MIE_ABSORPTION
    return numpy.exp(-depth_column[..., None] * extinction)


def phases(mu):
    rayleigh = 3 / (16 * numpy.pi) * (1 + mu * mu)
    cs = 3 / (8 * numpy.pi) * (1 - G * G) * (1 + mu * mu) / ((2 + G * G) * (1 + G * G - 2 * G * mu) ** 1.5)
    return RAYLEIGH * rayleigh[..., None] + MIE_SCATTERING * cs[..., None]


# The strip: on the wall at the bottom, along x from 5 km to 16 km, shining to the axis.
CENTRE = numpy.array([f32(10.5e3), 0.0, -R])


def source(q, direction, isotropic, along=40, across=6):
    """At one place; the strip cut where the place is nearest."""
    foot = q[0] - CENTRE[0]
    height = max(q[2] + R, 1e-9)
    near = min(max(foot, -HALF), HALF)
    reach = numpy.hypot(height, q[1])
    # u = near +- reach sinh(v) on both sides of the nearest point.
    us, ws = [], []
    for end in (-HALF, HALF):
        extent = abs(end - near)
        if extent > 0:
            v, w = rule(along, 0, numpy.arcsinh(extent / reach))
            us.append(near + numpy.sign(end - near) * reach * numpy.sinh(v))
            ws.append(w * reach * numpy.cosh(v))
    u, wu = numpy.concatenate(us), numpy.concatenate(ws)
    y, wy = rule(across, -WIDTH / 2, WIDTH / 2)
    s = numpy.empty((len(u), len(y), 3))
    s[..., 0] = CENTRE[0] + u[:, None]
    s[..., 1] = y[None, :]
    s[..., 2] = -R
    d = q - s
    r = numpy.sqrt((d * d).sum(-1))
    weight = wu[:, None] * wy[None, :] * d[..., 2] / r**3
    mu = -(d @ direction) / r
    light = passed(column(s, q))
    if isotropic:
        scattering = (RAYLEIGH + MIE_SCATTERING) / (4 * numpy.pi)
    else:
        scattering = phases(mu)
    return density(q) * (weight[..., None] * light * scattering).sum((0, 1))


def scattering(eye, direction, distance, isotropic, count=24):
    to = CENTRE - eye
    # Nearest approach to the strip's line, by search: only where the rule is cut hangs on it.
    t = numpy.linspace(0, distance, 2001)
    p = eye + t[:, None] * direction
    du = numpy.clip(p[:, 0] - CENTRE[0], -HALF, HALF)
    gap = numpy.sqrt((p[:, 0] - CENTRE[0] - du) ** 2 + p[:, 1] ** 2 + (p[:, 2] + R) ** 2)
    i = gap.argmin()
    nearest, width = t[i], max(gap[i], 1e-4 * distance)
    total = 0
    for side, extent in ((-1, nearest), (1, distance - nearest)):
        if extent <= 0:
            continue
        reach = numpy.arcsinh(extent / width)
        v, w = pieces(numpy.linspace(0, reach, 4), count // 2)
        for vi, wi in zip(v, w):
            q = eye + (nearest + side * width * numpy.sinh(vi)) * direction
            total = total + wi * width * numpy.cosh(vi) * passed(column(eye, q)) * source(q, direction, isotropic)
    return total


def inside(low):
    """Not closer to the wall than `low`."""
    angle = sampler.uniform(0, 6.283)
    r = (R - low) * numpy.sqrt(sampler.uniform(0, 1))
    return numpy.array([sampler.uniform(-L, L), f32(r * numpy.cos(angle)), f32(r * numpy.sin(angle))])


def direction():
    while True:
        d = numpy.array([sampler.uniform(-1, 1) for _ in range(3)])
        size = numpy.sqrt((d * d).sum())
        if 0.1 < size < 1:
            return numpy.array([f32(v) for v in d])


def cells(value):
    return ["%.*g" % (DIGITS, v) for v in value]


rows = []
for i in range(120):
    q = inside(20) if i % 3 else CENTRE + numpy.array([f32(sampler.uniform(-6e3, 6e3)), f32(sampler.uniform(-500, 500)), f32(sampler.log_uniform(50, 2e3))])
    q = numpy.array([f32(v) for v in q])
    d = direction()
    unit = d / numpy.sqrt((d * d).sum())
    for isotropic in (False, True):
        rows.append(["source", "isotropic" if isotropic else "phase", *map(float, q), *map(float, d), 0.0, *cells(source(q, unit, isotropic))])
for i in range(80):
    eye = inside(2) if i % 4 else numpy.array([f32(sampler.uniform(4e3, 17e3)), f32(sampler.uniform(-300, 300)), f32(-R + sampler.uniform(10, 100))])
    d = direction()
    unit = d / numpy.sqrt((d * d).sum())
    # To the wall or a cap.
    a = unit[1] ** 2 + unit[2] ** 2
    b = eye[1] * unit[1] + eye[2] * unit[2]
    far = (-b + numpy.sqrt(b * b - a * (eye[1] ** 2 + eye[2] ** 2 - R * R))) / a
    far = min(far, ((L if unit[0] > 0 else -L) - eye[0]) / unit[0])
    far = f32(far * (1 if i % 2 else sampler.uniform(0.05, 1)))
    for isotropic in (False, True):
        rows.append(["scattering", "isotropic" if isotropic else "phase", *map(float, eye), *map(float, d), far, *cells(scattering(eye, unit, far, isotropic))])

write_table(
    "strip_scattering",
    """radiance per unit radiance of the strip: of the source [1/m], of the air before a surface at `distance` [1];
    the eye or place at (x, y, z), the direction (dx, dy, dz) not yet normalised. To 1e-6.""",
    ["what", "kind", "x", "y", "z", "dx", "dy", "dz", "distance", "red", "green", "blue"],
    rows,
)
