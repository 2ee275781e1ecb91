"""Air along rays, to 50 digits; and the midpoint sums with 16 steps that column_marched should form."""

from mpmath import inf, mpf

from air import RADIUS, Ray, columns, densities
from reference import Sampler, f32, figure, write_table

sampler = Sampler(11)
rows = []


def add(altitude, mu, distance=None):
    ray = Ray(RADIUS + mpf(altitude), mpf(mu))
    air = ray.air(inf if distance is None else mpf(distance))
    if air is None:
        exact = sums = [mpf(0)] * 4
        scale = mpf(0)
    else:
        begin, end = air
        exact = columns(ray, begin, end)
        step = (end - begin) / 16
        samples = [densities(ray.altitude(begin + (i + mpf(0.5)) * step)) for i in range(16)]
        sums = [step * sum(s[k] for s in samples) for k in range(4)]
        # The altitude of a sample is good to 3 roundoffs of this much (docstring of altitude_along_ray), which the
        # shortest scale height, 1200 m, turns into a relative error of the density.
        scale = max(
            (t * abs(2 * ray.along + t) + ray.r**2 - RADIUS**2) / (2 * RADIUS)
            for t in [begin + (i + mpf(0.5)) * step for i in range(16)]
        )
    rows.append([altitude, mu, "none" if distance is None else distance, *exact, *sums, figure(1 + scale / 1200)])


for mu in (1.0, 0.5, f32(0.1), 0.0, f32(-0.01)):
    for altitude in (0.0, 2.0, 2000.0, 12000.0):
        add(altitude, mu)
for altitude, mu, distance in (
    (0.0, 1.0, 10.0),
    (0.0, 1.0, 20000.0),
    (2.0, 0.0, 100000.0),
    (10000.0, -1.0, 10000.0),
    (10000.0, f32(-0.1), 50000.0),
    (30000.0, f32(-0.05), 500000.0),
    (2.0, 0.25, f32(1e-6)),
    (100000.0, -1.0, 100000.0),
    (400000.0, -1.0, 400000.0),
    (400000.0, -1.0, 200000.0),
    (400000.0, 0.5, 1000.0),
):
    add(altitude, mu, distance)
add(400000.0, f32(-0.33))
add(99000.0, f32(-0.05))

write_table(
    "column",
    """air along a ray [m]: exact integrals, and midpoint sums of 16 steps; Earth of 6360 km, air up to 100 km, scale
    heights 8000 and 1200 m, tent 25 and 15 km, Lorentz curve 30 and 4 km times Rayleigh""",
    ["altitude", "mu", "distance", "rayleigh", "mie", "tent", "lorentzian"]
    + ["rayleigh_16", "mie_16", "tent_16", "lorentzian_16", "condition"],
    rows,
)
