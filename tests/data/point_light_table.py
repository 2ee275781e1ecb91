"""Light of a point that even fog turns into a view ray, once scattered, to 30 digits: by quadrature along the ray.

The light stands in the origin with intensity 1; the fog's phase function is Rayleigh's, or that of Cornette and Shanks.
"""

from mpmath import exp, mp, mpf, pi, quad, sqrt

from reference import Sampler, f32, write_table

mp.dps = 30
sampler = Sampler(63)


def dot(a, b):
    return sum(u * v for u, v in zip(a, b))


def light(rayleigh, mie, g, eye, direction, distance):
    size = sqrt(dot(direction, direction))
    d = [mpf(v) / size for v in direction]
    e = [mpf(v) for v in eye]
    extinction = mpf(rayleigh) + mpf(mie)
    g = mpf(g)

    def source(t):
        q = [p + t * u for p, u in zip(e, d)]
        r = sqrt(dot(q, q))
        mu = -dot(q, d) / r
        scattered = mpf(rayleigh) * 3 / (16 * pi) * (1 + mu * mu)
        norm = 3 / (8 * pi) * (1 - g * g) / (2 + g * g)
        scattered += mpf(mie) * norm * (1 + mu * mu) / (1 + g * g - 2 * g * mu) ** mpf("1.5")
        return scattered * exp(-extinction * (t + r)) / (r * r)

    foot = min(max(-dot(e, d), mpf(0)), mpf(distance))
    gap = sqrt(dot([p + foot * u for p, u in zip(e, d)], [p + foot * u for p, u in zip(e, d)]))
    cuts = {mpf(0), foot, mpf(distance)}
    for k in range(-3, 12):
        for side in (1, -1):
            t = foot + side * gap * mpf(2) ** k
            if 0 < t < distance:
                cuts.add(t)
    return quad(source, sorted(cuts))


rows = []
for thick in (0.0, 0.01, 0.3, 1.0, 3.0):
    for kind in range(24):
        eye = [sampler.uniform(-1, 1) for _ in range(3)]
        if kind % 3 == 0:
            # Past the light, closely.
            miss = [sampler.uniform(-0.1, 0.1) for _ in range(3)]
            direction = [f32(m - p) for m, p in zip(miss, eye)]
        else:
            direction = [sampler.uniform(-1, 1) for _ in range(3)]
        distance = sampler.log_uniform(0.3, 10)
        rayleigh = f32(thick * 0.3 + 1e-6)
        mie = f32(thick * 0.7) if kind % 2 else 0.0
        g = f32(0.6)
        rows.append([f32(thick), rayleigh, mie, g, *eye, *direction, distance, light(rayleigh, mie, g, eye, direction, distance)])

write_table(
    "point_light",
    """radiance at (ex, ey, ez) from the direction (dx, dy, dz), not yet normalised, of fog with these coefficients [1/L] before a
    surface at `distance` [L]; thick is about the depth of a unit of length. 30 digits, printed with 50.""",
    ["thick", "rayleigh", "mie", "g", "ex", "ey", "ez", "dx", "dy", "dz", "distance", "value"],
    rows,
)
