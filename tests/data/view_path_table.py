"""Where view rays are inside the air: textbook quadratics at 65 digits, the eye at height h on the z axis.

The direction's float32 components are normalised here. The condition is sum |df/dx| |x| + |f| over ground radius,
top, altitude, both components of the direction and distance.
"""

from mpmath import inf, mp, mpf, sqrt

from reference import Sampler, f32, figure, write_table

sampler = Sampler(10)


def path(R, top, h, dx, dz, distance):
    """(in_air, begin, end, ground) of the ray."""
    length = sqrt(dx * dx + dz * dz)
    sine = abs(dx) / length
    mu = dz / length
    r = R + h
    p = r * sine
    along = r * mu

    def crossings(radius):
        discriminant = radius * radius - p * p
        if discriminant <= 0:
            return None
        half = sqrt(discriminant)
        # For along < 0 the nearer root by the product of both: 0, not 1e-65, for an eye on the sphere.
        far = -along + half
        return ((r * r - radius * radius) / far if along < 0 else -along - half), far

    air = crossings(R + top)
    if air is None or air[1] <= 0:
        return False, mpf(0), mpf(0), False
    begin = max(air[0], mpf(0))
    end = air[1]
    ground = crossings(R)
    hits = ground is not None and along < 0 and ground[0] >= 0
    if hits:
        end = ground[0]
    reaches = hits and end <= distance
    end = min(end, distance)
    if end <= begin:
        return False, mpf(0), mpf(0), reaches
    return True, begin, end, reaches


def condition(which, arguments):
    value = path(*arguments)[which]
    total = abs(value)
    for i, x in enumerate(arguments):
        if x == inf or x == 0:
            continue
        step = abs(x) * mpf(10) ** -20
        up = list(arguments)
        down = list(arguments)
        up[i] = x + step
        down[i] = x - step
        total += abs((path(*up)[which] - path(*down)[which]) / (2 * step) * x)
    return figure(total)


rows = []


def add(label, R, top, h, dx, dz, distance=None):
    # Rounded to float32, so that both the table and the tests see the same direction.
    length = sqrt(mpf(dx) ** 2 + mpf(dz) ** 2)
    dx, dz = f32(mpf(dx) / length), f32(mpf(dz) / length)
    arguments = [mpf(R), mpf(top), mpf(h), mpf(dx), mpf(dz), inf if distance is None else mpf(distance)]
    in_air, begin, end, ground = path(*arguments)
    rows.append(
        [label, R, top, h, dx, dz, "none" if distance is None else distance, in_air, ground, begin, end]
        + [condition(1, arguments), condition(2, arguments)]
    )


for R, top in ((6360000.0, 100000.0), (f32(3389500.0), 80000.0), (1000.0, 500.0)):
    inside = f32(top * 0.25)
    outside = f32(top * 4)
    far = f32(R * 10)
    add("inside_up", R, top, inside, 0.0, 1.0)
    add("inside_down", R, top, inside, 0.0, -1.0)
    add("inside_level", R, top, inside, 1.0, 0.0)
    add("inside_surface_inside", R, top, inside, 0.6, 0.8, f32(top / 8))
    add("inside_surface_outside", R, top, inside, 0.6, 0.8, f32(top * 8))
    add("inside_down_surface_in_front", R, top, inside, 0.6, -0.8, f32(top / 16))
    add("ground_up", R, top, 0.0, 0.8, 0.6)
    add("ground_down", R, top, 0.0, 0.8, -0.6)
    add("outside_down", R, top, outside, 0.0, -1.0)
    add("outside_away", R, top, outside, 0.6, 0.8)
    add("outside_surface_inside", R, top, outside, 0.0, -1.0, f32(top * 3.5))
    add("outside_surface_in_front", R, top, outside, 0.0, -1.0, top)
    add("far_down", R, top, far, 0.0, -1.0)
    add("far_limb", R, top, far, f32((mpf(R) + mpf(top) / 2) / (mpf(R) + mpf(far))), f32(-sqrt(1 - ((mpf(R) + mpf(top) / 2) / (mpf(R) + mpf(far))) ** 2)))
    add("far_miss", R, top, far, 0.3, -0.4)
    for _ in range(8):
        h = f32(top * sampler.uniform(0, 1))
        add("inside_any", R, top, h, sampler.uniform(-1, 1), sampler.uniform(-1, 1))
        h = f32(mpf(top) * (1 + mpf(sampler.log_uniform(0.1, 100))))
        sine = (mpf(R) + mpf(top) * mpf(sampler.uniform(-3, 0.8))) / (mpf(R) + mpf(h))
        add("outside_any", R, top, h, f32(sine), f32(-sqrt(1 - sine * sine)))

write_table(
    "view_path",
    """eye at altitude h, up +z, direction (dx, 0, dz); distance of the surface or none; lengths in one unit""",
    ["case", "radius", "top", "h", "dx", "dz", "distance", "in_air", "reaches_ground", "begin", "end"]
    + ["condition_begin", "condition_end"],
    rows,
)
