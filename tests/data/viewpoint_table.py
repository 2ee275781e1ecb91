"""Altitude and up of positions, from the planet's centre and from a point on the ground (vertical +z)."""

from mpmath import mpf, sqrt

from reference import Sampler, f32, figure, write_table

sampler = Sampler(9)
rows = []


def add(function, radius, position):
    R = mpf(radius)
    p = [mpf(x) for x in position]
    length = sqrt(sum(x * x for x in p))
    if function == "from_surface":
        condition = length + length**2 / (2 * R)
        p[2] += R
    else:
        condition = length
    distance = sqrt(sum(x * x for x in p))
    rows.append([function, radius, *position, distance - R, *[x / distance for x in p], figure(condition)])


for radius in (100.0, f32(3389500.0), 6360000.0, 7e7):
    for _ in range(12):
        sign = 1 if sampler.random.random() < 0.7 else -1
        direction = [sampler.uniform(-1, 1) for _ in range(3)]
        size = mpf(radius) * mpf(sampler.log_uniform(0.5, 1e4))
        add("from_centre", radius, [f32(size * d) for d in direction])
        size = mpf(radius) * mpf(sampler.log_uniform(1e-7, 1e4))
        add("from_surface", radius, [f32(size * d) for d in (direction[0], direction[1], sign * abs(direction[2]))])
    add("from_surface", radius, [0.0, 0.0, 2.0])
    add("from_surface", radius, [0.0, 0.0, -2.0])
    add("from_surface", radius, [f32(radius / 64), 0.0, 0.0])

write_table(
    "viewpoint",
    """altitude [L] and up of a position [L]; condition: distance from the centre, or |p| + |p|^2 / 2R""",
    ["function", "radius", "px", "py", "pz", "altitude", "up_x", "up_y", "up_z", "condition"],
    rows,
)
