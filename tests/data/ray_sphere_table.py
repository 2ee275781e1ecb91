"""Crossings of a line with a sphere by the textbook quadratic; 65 digits make up for its cancellation."""

from mpmath import mpf, sqrt

from reference import Sampler, f32, figure, write_table

sampler = Sampler(4)
rows = []


def add(radius, altitude, mu):
    R, h, m = mpf(radius), mpf(altitude), mpf(mu)
    r = R + h
    discriminant = r * r * m * m - h * (2 * R + h)
    if discriminant < 0:
        rows.append([radius, altitude, mu, False, mpf(0), mpf(0), mpf(0), mpf(0)])
        return
    root = sqrt(discriminant)
    results = []
    conditions = []
    for sign in (-1, 1):
        t = -r * m + sign * root
        # d/dR, d/dh, d/dmu of t, each times its input.
        d_radius = -m + sign * (r * m * m - h) / root
        d_altitude = -m + sign * (r * m * m - r) / root
        d_mu = -r + sign * r * r * m / root
        results.append(t)
        conditions.append(figure(abs(d_radius * R) + abs(d_altitude * h) + abs(d_mu * m) + abs(t)))
    rows.append([radius, altitude, mu, True, *results, *conditions])


radii = [100.0, f32(3389500.0), 6360000.0, 6371000.0, 7e7]
for radius in radii:
    for _ in range(10):  # outside, aimed at the sphere
        altitude = sampler.log_uniform(0.1, 1e9)
        sine = mpf(radius) / (mpf(radius) + mpf(altitude)) * mpf(sampler.uniform(0, f32(0.999)))
        add(radius, altitude, f32(-sqrt(1 - sine * sine)))
    for _ in range(6):  # any direction
        add(radius, sampler.log_uniform(1, 1e6), sampler.uniform(-1, 1))
    for _ in range(6):  # inside
        add(radius, f32(-radius * sampler.uniform(0, 1)), sampler.uniform(-1, 1))
    add(radius, 2.0, -1.0)
    add(radius, 2.0, 1.0)
    add(radius, 0.0, 0.5)
    add(radius, 0.0, -0.5)
    add(radius, -radius, f32(0.3))

write_table(
    "ray_sphere",
    """crossings of the ray from `altitude` above a sphere with cosine mu to the vertical, one length unit;
    conditions = sum |dt/dx| |x| + |t| of each""",
    ["radius", "altitude", "mu", "hit", "t_near", "t_far", "condition_near", "condition_far"],
    rows,
)
