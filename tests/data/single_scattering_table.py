"""Single scattering by nested Gauss-Legendre quadrature in mpmath, independent of the library's marching.

Both integrals are cut where the integrand has a corner or jumps: edges of the ozone tent, perigees, ground, the
edges of the planet's shadow. Each view is computed twice, with more nodes the second time, and
the script fails when the two differ by more than 1e-7 of the value.
"""

from mpmath import cos, exp, inf, legendre, mp, mpf, nstr, pi, sqrt

import air
from reference import f32, write_table

mp.dps = 20


def gauss_legendre(n):
    nodes = []
    for i in range(n):
        x = cos(pi * (i + mpf(3) / 4) / (n + mpf(1) / 2))
        for _ in range(12):
            p, q = legendre(n, x), legendre(n - 1, x)
            slope = n * (x * p - q) / (x * x - 1)
            x -= p / slope
        p, q = legendre(n, x), legendre(n - 1, x)
        slope = n * (x * p - q) / (x * x - 1)
        nodes.append((x, 2 / ((1 - x * x) * slope * slope)))
    return nodes


RULES = {n: gauss_legendre(n) for n in (8, 14)}


def panels(cuts, parts):
    for a, b in zip(cuts, cuts[1:]):
        for i in range(parts):
            yield a + (b - a) * i / parts, a + (b - a) * (i + 1) / parts


def rule(f, cuts, order, parts):
    """Integral of the vector-valued f."""
    total = None
    for a, b in panels(cuts, parts):
        for x, w in RULES[order]:
            weight = w * (b - a) / 2
            value = [weight * v for v in f((a + b) / 2 + x * (b - a) / 2)]
            total = value if total is None else [s + v for s, v in zip(total, value)]
    return total


def column(ray, begin, end, order, parts):
    if end <= begin:
        return [mpf(0)] * 3
    return rule(lambda t: air.densities(ray.altitude(t))[:3], ray.cuts(begin, end), order, parts)


def optical_depth(column):
    mie = air.MIE_SCATTERING + air.MIE_ABSORPTION
    return [air.RAYLEIGH[k] * column[0] + mie * column[1] + air.OZONE[k] * column[2] for k in range(3)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def normalised(v):
    length = sqrt(dot(v, v))
    return [x / length for x in v]


def view(altitude, direction, to_sun, distance, order, parts):
    start = [mpf(0), mpf(0), air.RADIUS + mpf(altitude)]
    d = normalised([mpf(x) for x in direction])
    s = normalised([mpf(x) for x in to_sun])
    nu = dot(d, s)
    ray = air.Ray(start[2], d[2])
    inside = ray.air(inf if distance is None else mpf(distance))
    if inside is None:
        return [mpf(0)] * 3 + [mpf(1)] * 3
    begin, end = inside
    if ray.meets_ground():
        end = min(end, ray.crossings(mpf(0))[0])

    # Where the ray crosses the shadow's edge, a cylinder around the line from the sun through the centre; and where
    # the sun's rays touch the corners of the tent, cylinders too: the integrand goes like a root there.
    cuts = ray.cuts(begin, end)
    height = dot(start, s)
    a, b = 1 - nu * nu, dot(start, d) - height * nu
    edges = []
    for corner in (0, 10000, 25000, 40000):
        c = dot(start, start) - height**2 - (air.RADIUS + corner) ** 2
        if a > mpf(10) ** -15 and b * b > a * c:
            roots = [(-b + sign * sqrt(b * b - a * c)) / a for sign in (-1, 1)]
            edges += [t for t in roots if height + t * nu <= 0 and begin <= t <= end]
    for t in edges[:]:
        for k in range(1, 7):
            edges += [t + (end - begin) / mpf(4) ** k, t - (end - begin) / mpf(4) ** k]
    cuts = sorted(set(cuts + [t for t in edges if begin < t < end]))

    rayleigh_phase = 3 * (1 + nu * nu) / (16 * pi)
    g = air.G
    mie_phase = 3 * (1 - g * g) * (1 + nu * nu) / (8 * pi * (2 + g * g) * (1 + g * g - 2 * g * nu) ** mpf(1.5))
    passed = {}

    def integrand(t):
        r = sqrt(ray.r**2 + t * (2 * ray.along + t))
        towards_sun = air.Ray(r, (height + t * nu) / r)
        if towards_sun.meets_ground():
            return [mpf(0)] * 3
        # The eye's column grows along the ray: start from the last place where it is known.
        known = max((k for k in passed if k <= t), default=None)
        eye = column(ray, begin if known is None else known, t, order, parts)
        if known is not None:
            eye = [x + y for x, y in zip(eye, passed[known])]
        passed[t] = eye
        sun_air = towards_sun.air(inf)
        sun = column(towards_sun, mpf(0), sun_air[1], order, parts) if sun_air else [mpf(0)] * 3
        tau = [x + y for x, y in zip(optical_depth(eye), optical_depth(sun))]
        rho = air.densities(ray.altitude(t))
        return [
            exp(-tau[k])
            * (air.RAYLEIGH[k] * rho[0] * rayleigh_phase + air.MIE_SCATTERING * rho[1] * mie_phase)
            for k in range(3)
        ]

    radiance = rule(integrand, cuts, order, parts)
    transmittance = [exp(-x) for x in optical_depth(column(ray, begin, end, order, parts))]
    return radiance + transmittance


def direction(elevation_degrees, azimuth_degrees=0):
    e, a = mpf(elevation_degrees) * pi / 180, mpf(azimuth_degrees) * pi / 180
    from mpmath import sin

    return [f32(cos(e) * cos(a)), f32(cos(e) * sin(a)), f32(sin(e))]


def limb(altitude, perigee):
    sine = (air.RADIUS + perigee) / (air.RADIUS + altitude)
    return [f32(sine), 0.0, f32(-sqrt(1 - sine * sine))]


VIEWS = [
    ("noon_zenith", 2.0, direction(90), direction(90), None),
    ("noon_45", 2.0, direction(45), direction(90), None),
    ("noon_horizon", 2.0, direction(0), direction(90), None),
    ("morning_zenith", 2.0, direction(90), direction(45), None),
    ("morning_opposite", 2.0, direction(45), direction(45, 180), None),
    ("morning_into_sun", 2.0, direction(45), direction(45), None),
    ("low_sun_10", 2.0, direction(20), direction(10, 30), None),
    ("low_sun_2", 200.0, direction(5), direction(2, 60), None),
    ("sunset_zenith", 2.0, direction(90), direction(0), None),
    ("sunset_horizon", 2.0, direction(1), direction(0, 20), None),
    ("twilight_zenith", 2.0, direction(90), direction(-3), None),
    ("twilight_horizon", 200.0, direction(2), direction(-6), None),
    ("night", 2.0, direction(90), direction(-30), None),
    ("mountains_1km", 2.0, direction(1), direction(45, 90), 1000.0),
    ("mountains_20km", 200.0, direction(2), direction(30, 150), 20000.0),
    ("mountains_100km", 200.0, direction(1), direction(10, 120), 100000.0),
    ("aeroplane_level", 10000.0, direction(0), direction(20, 40), None),
    ("aeroplane_down", 10000.0, direction(-30), direction(60, 90), None),
    ("orbit_nadir", 400000.0, direction(-90), direction(50), None),
    ("orbit_limb", 400000.0, limb(400000, 15000), direction(-10, 70), None),
    ("orbit_terminator", 400000.0, limb(400000, -50000), direction(-15, 10), None),
    ("far_limb", 36000000.0, limb(36000000, 10000), direction(10, 100), None),
]

rows = []
for name, altitude, d, s, distance in VIEWS:
    coarse = view(altitude, d, s, distance, 8, 1)
    fine = view(altitude, d, s, distance, 14, 1)
    for x, y in zip(coarse, fine):
        assert abs(x - y) <= mpf(10) ** -7 * max(abs(y), mpf(10) ** -9), (name, nstr(x, 18), nstr(y, 18))
    rows.append([name, altitude, *d, *s, "none" if distance is None else distance, *[nstr(x, 10) for x in fine]])

write_table(
    "single_scattering",
    """radiance [1/sr] per solar irradiance and transmittance, three channels; 7 digits at least; the air of air.py; eye at
    altitude [m] on the z axis, directions are normalised by the reader""",
    ["view", "altitude", "dx", "dy", "dz", "sx", "sy", "sz", "distance", "r0", "r1", "r2", "t0", "t1", "t2"],
    rows,
)
