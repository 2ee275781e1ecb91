"""Light of strips that a habitat's air turns into a view ray, once scattered, by brute force.

The strip is the rectangle that it is: rules of Gauss and Legendre over its length, its width, the view ray and, for what
passes, over every way between strip, place and eye. Finer rules, cut elsewhere, move results
within four widths of the strip by less than 1e-4, others by less than 1e-5; no formula of the library is used. Needs Debian's python3-numpy.
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


def from_foot(foot, begin, end, reach, parts, count):
    """Points and weights from begin to end, evenly in v of nearest +- reach sinh(v); nearest to the foot."""
    nearest = min(max(foot, begin), end)
    xs, ws = [], []
    for to in (begin, end):
        extent = abs(to - nearest)
        if extent > 0:
            v, w = pieces(numpy.linspace(0, numpy.arcsinh(extent / reach), parts + 1), count)
            xs.append(nearest + numpy.sign(to - nearest) * reach * numpy.sinh(v))
            ws.append(w * reach * numpy.cosh(v))
    return numpy.concatenate(xs), numpy.concatenate(ws)


def source(q, direction, isotropic):
    """At one place; the strip cut where the place is nearest, in both its directions."""
    height = max(q[2] + R, 1e-9)
    beside = max(abs(q[1]) - WIDTH / 2, 0)
    beyond = max(abs(q[0] - CENTRE[0]) - HALF, 0)
    if numpy.sqrt(height**2 + beside**2 + beyond**2) > 10 * WIDTH:
        y, wy = rule(6, -WIDTH / 2, WIDTH / 2)
    else:
        y, wy = from_foot(q[1], -WIDTH / 2, WIDTH / 2, numpy.hypot(height, beside), 2, 20)
    reach = numpy.sqrt(height**2 + (q[1] - y) ** 2 + beyond**2)
    lines = [from_foot(q[0] - CENTRE[0], -HALF, HALF, r, 2, 24) for r in reach]
    u, wu = numpy.array([x for x, _ in lines]), numpy.array([w for _, w in lines])
    s = numpy.empty((*u.shape, 3))
    s[..., 0] = CENTRE[0] + u
    s[..., 1] = y[:, None]
    s[..., 2] = -R
    d = q - s
    r = numpy.sqrt((d * d).sum(-1))
    weight = wu * wy[:, None] * d[..., 2] / r**3
    mu = -(d @ direction) / r
    light = passed(column(s, q))
    if isotropic:
        scattering = (RAYLEIGH + MIE_SCATTERING) / (4 * numpy.pi)
    else:
        scattering = phases(mu)
    return density(q) * (weight[..., None] * light * scattering).sum((0, 1))


def scattering(eye, direction, distance, isotropic, count=24):
    # Nearest approach to the strip, by search: only where the rule is cut hangs on it.
    t = numpy.linspace(0, distance, 2001)
    p = eye + t[:, None] * direction
    du = numpy.clip(p[:, 0] - CENTRE[0], -HALF, HALF)
    dv = numpy.clip(p[:, 1], -WIDTH / 2, WIDTH / 2)
    gap = numpy.sqrt((p[:, 0] - CENTRE[0] - du) ** 2 + (p[:, 1] - dv) ** 2 + (p[:, 2] + R) ** 2)
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


def to_wall(eye, unit):
    """The way to the wall or a cap."""
    a = unit[1] ** 2 + unit[2] ** 2
    b = eye[1] * unit[1] + eye[2] * unit[2]
    far = (-b + numpy.sqrt(b * b - a * (eye[1] ** 2 + eye[2] ** 2 - R * R))) / a
    return min(far, ((L if unit[0] > 0 else -L) - eye[0]) / unit[0])


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
    far = to_wall(eye, unit)
    far = f32(far * (1 if i % 2 else sampler.uniform(0.05, 1)))
    for isotropic in (False, True):
        rows.append(["scattering", "isotropic" if isotropic else "phase", *map(float, eye), *map(float, d), far, *cells(scattering(eye, unit, far, isotropic))])

# Within four widths of the strip, where it is brightest and its width shows.
def beside_strip():
    while True:
        q = numpy.array([f32(sampler.uniform(4.6e3, 16.4e3)), f32(sampler.uniform(-400, 400)), f32(-R + sampler.log_uniform(2, 400))])
        beyond = max(abs(q[0] - CENTRE[0]) - HALF, 0)
        if beyond**2 + q[1] ** 2 + (q[2] + R) ** 2 < (4 * WIDTH) ** 2 and q[1] ** 2 + q[2] ** 2 < (R - 2) ** 2:
            return q


for i in range(100):
    for what in ("source", "scattering"):
        q = beside_strip()
        d = direction()
        unit = d / numpy.sqrt((d * d).sum())
        if what == "source":
            far, light = 0.0, source(q, unit, False)
        else:
            far = f32(to_wall(q, unit) * (1 if i % 2 else sampler.uniform(0.05, 1)))
            light = scattering(q, unit, far, False, count=48)
        rows.append([what, "phase", *map(float, q), *map(float, d), far, *cells(light)])

write_table(
    "strip_scattering",
    """radiance per unit radiance of the strip: of the source [1/m], of the air before a surface at `distance` [1];
    the eye or place at (x, y, z), the direction (dx, dy, dz) not yet normalised. To 1e-5, within four widths 1e-4.""",
    ["what", "kind", "x", "y", "z", "dx", "dy", "dz", "distance", "red", "green", "blue"],
    rows,
)
