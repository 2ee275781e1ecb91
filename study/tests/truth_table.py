#!/usr/bin/python3
"""Writes truth.csv: radiances of single scattering at 30 digits, which the study's own truth is held to.

Nested Gauss-Legendre quadrature in mpmath (Debian: python3-mpmath), from textbook geometry: shares nothing with the
study but the numbers of the atmospheres. Panels end where an integrand has a corner or jumps, and shrink towards
the places where it goes like a root. Each view is computed twice, with more points the second time; the script
fails when the two differ by more than 1e-15 of the largest channel. Takes four minutes.

usage: truth_table.py [view ...]      without names all views; with names prints them and writes nothing
"""

import multiprocessing
import os
import sys

from mpmath import cos, exp, mp, mpf, nstr, pi, sin, sqrt

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
sys.path.insert(0, os.path.join(ROOT, "tests", "data"))
from reference import f32, write_table  # noqa: E402

mp.dps = 30
COARSE, FINE = 16, 22


class World:
    """Coefficients as printed, per metre."""

    def __init__(self, radius, rayleigh, rayleigh_height, mie, absorption, mie_height, g, ozone, shape, centre, width):
        spectrum = lambda cells: [mpf(x) for x in cells.split()]
        self.radius, self.top = mpf(radius), mpf(radius) + 100000
        self.rayleigh, self.mie, self.ozone = spectrum(rayleigh), spectrum(mie), spectrum(ozone)
        self.mie_extinction = [a + b for a, b in zip(self.mie, spectrum(absorption))]
        self.rayleigh_height, self.mie_height, self.g = mpf(rayleigh_height), mpf(mie_height), mpf(g)
        self.shape, self.centre, self.width = shape, mpf(centre), mpf(width)
        self.shells = []
        if shape == "tent":
            self.shells = [self.centre - self.width, self.centre, self.centre + self.width]
        # Not corners: heights between which the densities are easily followed.
        self.heights = [mpf(h) for h in (1000, 2500, 5000, 9000, 15000, 22000, 27000, 30000, 33000, 38000, 50000, 70000)]

    def densities(self, h):
        h = max(h, mpf(0))
        molecules = exp(-h / self.rayleigh_height)
        off = (h - self.centre) / self.width
        ozone = mpf(0)
        if self.shape == "tent":
            ozone = max(mpf(0), 1 - abs(off))
        elif self.shape == "lorentzian":
            ozone = molecules / (1 + off * off)
        return molecules, exp(-h / self.mie_height), ozone

    def depth(self, column):
        return [
            self.rayleigh[k] * column[0] + self.mie_extinction[k] * column[1] + self.ozone[k] * column[2]
            for k in range(3)
        ]


NO_OZONE = ("0 0 0", "none", 25000, 15000)
NINTHS = "2.2222222222222222222e-6 " * 3
WORLDS = {
    "leenman": World(6371000, "5.5e-6 13.0e-6 22.4e-6", 8000, "21e-6 21e-6 21e-6", "0 0 0", 1200, "0.7",
                     "20.4e-6 49.7e-6 1.95e-6", "lorentzian", 30000, 4000),
    "cs562": World(6371000, "5.8e-6 13.5e-6 33.1e-6", 8000, "20e-6 20e-6 20e-6", NINTHS, 1200, "0.76", *NO_OZONE),
    "earth": World(6360000, "5.802e-6 13.558e-6 33.1e-6", 8000, "3.996e-6 3.996e-6 3.996e-6",
                   "0.444e-6 0.444e-6 0.444e-6", 1200, "0.8", "0.65e-6 1.881e-6 0.085e-6", "tent", 25000, 15000),
    "mars": World(3389500, "0.10006e-6 0.23379e-6 0.57078e-6", 11100, "40.0e-6 34.71e-6 27.11e-6",
                  "2.86e-6 6.37e-6 12.18e-6", 10800, "0.635", *NO_OZONE),
    "thick": World(6360000, "58.02e-6 135.58e-6 331e-6", 8000, "3.996e-6 3.996e-6 3.996e-6",
                   "0.444e-6 0.444e-6 0.444e-6", 1200, "0.8", *NO_OZONE),
}


def gauss_legendre(n):
    """Points and weights on [0, 1]."""
    from mpmath import legendre

    rule = []
    for i in range(n):
        x = cos(pi * (i + mpf(3) / 4) / (n + mpf(1) / 2))
        for _ in range(12):
            p, q = legendre(n, x), legendre(n - 1, x)
            x -= p * (x * x - 1) / (n * (x * p - q))
        p, q = legendre(n, x), legendre(n - 1, x)
        slope = n * (x * p - q) / (x * x - 1)
        rule.append(((1 + x) / 2, 1 / ((1 - x * x) * slope * slope)))
    return sorted(rule)


def rule(f, cuts, points):
    total = [mpf(0)] * 3
    for a, b in zip(cuts, cuts[1:]):
        for x, w in points:
            weight = w * (b - a)
            total = [s + weight * v for s, v in zip(total, f(a + x * (b - a)))]
    return total


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def normalised(v):
    length = sqrt(dot(v, v))
    return [x / length for x in v]


class Line:
    """From distance r of the centre; `along` is r times the cosine to the vertical."""

    def __init__(self, world, r, along):
        self.world, self.r, self.along = world, r, along

    def distance(self, t):
        return sqrt(self.r**2 + t * (2 * self.along + t))

    def crossings(self, radius):
        square = self.along**2 - self.r**2 + radius**2
        return [] if square <= 0 else [-self.along - sqrt(square), -self.along + sqrt(square)]

    def cuts(self, begin, end):
        heights = self.world.shells + self.world.heights
        found = [t for h in heights for t in self.crossings(self.world.radius + h)] + [-self.along]
        found += self.crossings(self.world.radius)
        return sorted({begin, end} | {t for t in found if begin < t < end})

    def column(self, begin, end, points):
        if end <= begin:
            return [mpf(0)] * 3
        densities = lambda t: self.world.densities(self.distance(t) - self.world.radius)
        return rule(densities, self.cuts(begin, end), points)


def graded(edges, begin, end):
    """Edges, and panels that shrink towards each from both sides."""
    cuts = list(edges)
    for t in edges:
        for k in range(1, 26):
            cuts += [t + (end - begin) / mpf(4) ** k, t - (end - begin) / mpf(4) ** k]
    return [t for t in cuts if begin < t < end]


def radiance(world, altitude, direction, to_sun, distance, points):
    d, s = normalised([mpf(x) for x in direction]), normalised([mpf(x) for x in to_sun])
    r = world.radius + mpf(altitude)
    ray, height, nu = Line(world, r, r * d[2]), r * s[2], dot(d, s)
    begin, end = ray.crossings(world.top)
    begin = max(begin, mpf(0))
    if distance is not None:
        end = min(end, mpf(distance))
    ground = ray.crossings(world.radius)
    if ground and ray.along < 0:
        end = min(end, ground[0])

    # Sun rays that graze the ground, a shell or the air's top make a cylinder around the sun's direction.
    edges = []
    for radius in [world.radius, world.top] + [world.radius + h for h in world.shells]:
        a, b, c = 1 - nu * nu, ray.along - height * nu, r * r - height**2 - radius**2
        if b * b > a * c and a > 0:
            edges += [(-b + sign * sqrt(b * b - a * c)) / a for sign in (-1, 1)]
    edges = [t for t in edges if begin - 1 < t < end + 1]
    # Where the sun stands level, its ray's closest approach moves onto the ray itself.
    level = [-height / nu] if nu != 0 else []
    cuts = sorted(set(ray.cuts(begin, end) + graded(edges, begin, end) + [t for t in level if begin < t < end]))

    rayleigh_phase = 3 * (1 + nu * nu) / (16 * pi)
    g = world.g
    mie_phase = 3 * (1 - g * g) * (1 + nu * nu) / (8 * pi * (2 + g * g) * (1 + g * g - 2 * g * nu) ** mpf("1.5"))
    known = [(begin, [mpf(0)] * 3)]  # the rule goes along the ray, so the eye's column grows with it

    def light(t):
        from_t, eye = known[-1]
        eye = [x + y for x, y in zip(eye, ray.column(from_t, t, points))]
        known.append((t, eye))
        sun = Line(world, ray.distance(t), height + t * nu)
        if sun.along < 0 and sun.crossings(world.radius):
            return [mpf(0)] * 3
        to_space = sun.column(mpf(0), sun.crossings(world.top)[1], points)
        depth = world.depth([x + y for x, y in zip(eye, to_space)])
        density = world.densities(ray.distance(t) - world.radius)
        return [
            exp(-depth[k]) * (world.rayleigh[k] * density[0] * rayleigh_phase + world.mie[k] * density[1] * mie_phase)
            for k in range(3)
        ]

    return rule(light, cuts, points)


def towards(elevation, azimuth=0):
    e, a = mpf(elevation) * pi / 180, mpf(azimuth) * pi / 180
    return [f32(cos(e) * cos(a)), f32(cos(e) * sin(a)), f32(sin(e))]


def past(world, altitude, perigee):
    sine = (WORLDS[world].radius + perigee) / (WORLDS[world].radius + altitude)
    return [f32(sine), 0.0, f32(-sqrt(1 - sine * sine))]


VIEWS = [
    ("leenman_low_sun", "leenman", 2.0, towards(20, 120), towards(2), None),
    ("leenman_twilight", "leenman", 2.0, towards(1), towards(-3), None),
    ("cs562_sunset_horizon", "cs562", 200.0, towards(0.1), towards(0), None),
    ("cs562_aeroplane", "cs562", 10000.0, towards(-2, 30), towards(5), None),
    ("earth_sunset_zenith", "earth", 2.0, towards(90), towards(0), None),
    ("earth_limb", "earth", 1000000.0, past("earth", 1000000, 20000), towards(-20, 40), None),
    ("earth_mountain", "earth", 200.0, towards(1, 50), towards(5), 100000.0),
    ("mars_morning", "mars", 2.0, towards(20), towards(10), None),
    ("thick_twilight", "thick", 2.0, towards(20, 120), towards(-3), None),
    ("thick_disc", "thick", 1000000.0, past("thick", 1000000, -1000000), towards(60, 40), None),
]


def computed(view):
    name, world, altitude, d, s, distance = view
    coarse, fine = (
        radiance(WORLDS[world], altitude, d, s, distance, gauss_legendre(n)) for n in (COARSE, FINE)
    )
    off = max(abs(x - y) for x, y in zip(coarse, fine)) / max(fine)
    print("%-22s %s  differ by %s" % (name, nstr(fine, 18), nstr(off, 3)), flush=True)
    assert off <= mpf(10) ** -15, name
    cells = [name, world, altitude, *d, *s, "none" if distance is None else distance]
    return cells + [nstr(x, 20) for x in fine]


def main():
    wanted = sys.argv[1:]
    if "-h" in wanted or "--help" in wanted:
        print(__doc__.strip())
        return
    unknown = set(wanted) - {view[0] for view in VIEWS}
    if unknown:
        sys.exit("truth_table.py: no view named %s; there are: %s" % (unknown.pop(), ", ".join(v[0] for v in VIEWS)))
    with multiprocessing.Pool() as pool:
        rows = pool.map(computed, [v for v in VIEWS if not wanted or v[0] in wanted], chunksize=1)
    if not wanted:
        write_table(
            "truth",
            """radiance [1/sr] per solar irradiance, three channels; 15 digits at least; eye at altitude [m] on the z axis;
            directions are normalised by the reader; distance [m]""",
            ["view", "world", "altitude", "dx", "dy", "dz", "sx", "sy", "sz", "distance", "r0", "r1", "r2"],
            rows,
            folder=os.path.dirname(os.path.abspath(__file__)),
            script="study/tests/truth_table.py",
        )


if __name__ == "__main__":
    main()
