"""Air of a spinning cylinder between two points, Dawson's integral and the arc tangent, to 50 digits.

The column is the integral of the density along the way by quadrature, without a closed form.
"""

from mpmath import atan2, erfi, exp, mpf, pi, quad, sqrt

from reference import Sampler, f32, write_table

sampler = Sampler(60)


def column(rise, radius, a, b):
    a = [mpf(v) for v in a]
    b = [mpf(v) for v in b]
    length = sqrt(sum((q - p) ** 2 for p, q in zip(a, b)))

    def density(s):
        y = a[1] + s * (b[1] - a[1])
        z = a[2] + s * (b[2] - a[2])
        return exp(rise * (y * y + z * z - mpf(radius) ** 2))

    # Cut finely enough that the logarithm of the density changes by about a unit from cut to cut.
    ends = abs(rise) * ((b[1] - a[1]) ** 2 + (b[2] - a[2]) ** 2 + mpf(radius) ** 2)
    cuts = int(min(40, 2 + ends))
    return length * quad(density, [mpf(i) / cuts for i in range(cuts + 1)])


def in_cylinder(radius, half_length):
    while True:
        y = sampler.uniform(-radius, radius)
        z = sampler.uniform(-radius, radius)
        if y * y + z * z <= radius * radius:
            return [sampler.uniform(-half_length, half_length), y, z]


def along(start, direction, length):
    return [f32(s + length * d) for s, d in zip(start, direction)]


rows = []


def add(rise, radius, a, b):
    rows.append(["column", f32(rise), f32(radius), *a, *b, column(mpf(f32(rise)), f32(radius), a, b)])


# The document's habitat, in metres, with a wall as heavy as Earth's ground: rise radius^2 is 0.47.
R, L = 8e3, 24e3
RISE = f32(7.36e-9)
for i in range(400):
    add(RISE, R, in_cylinder(R, L), in_cylinder(R, L))
for i in range(120):  # nearly axial
    a = in_cylinder(R, L)
    b = [sampler.uniform(-L, L), f32(a[1] + sampler.uniform(-1, 1)), f32(a[2] + sampler.uniform(-1, 1))]
    add(RISE, R, a, b)
for i in range(120):  # nearly radial, through the axis too
    a = in_cylinder(R, L)
    k = sampler.uniform(-1, 1)
    add(RISE, R, a, [f32(a[0] + sampler.uniform(-1, 1)), f32(k * a[1]), f32(k * a[2])])
for i in range(120):  # tiny
    a = in_cylinder(R, L)
    s = sampler.log_uniform(1e-3, 10)
    add(RISE, R, a, [f32(v + s * sampler.uniform(-1, 1)) for v in a])
for i in range(200):  # spins up to a hundred times as strong in the density, and none
    rise = f32(RISE * sampler.log_uniform(1, 100)) if i % 10 else 0.0
    add(rise, R, in_cylinder(R, L), in_cylinder(R, L))
for i in range(40):  # behind the wall
    add(RISE, R, in_cylinder(R, L), in_cylinder(3 * R, L))

zero = [0.0] * 5
for x in (0, 1e-6, 1e-3, 0.03, 0.1, 0.3, 0.5, 0.7, 0.9, 0.925, 1, 1.3, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10, 13, 20, 50, 150, 299, 1e3, 1e6):
    for sign in (1, -1):
        v = mpf(f32(x))
        if v < 20:
            value = sqrt(pi) / 2 * exp(-v * v) * erfi(v)
        else:
            value = quad(lambda s: exp(-s * (2 * v - s)), [mpf(0), 1 / v, 8 / v, min(v, 80 / v), min(v, 200 / v)])
        rows.append(["dawson", f32(sign * x), *zero, 0.0, 0.0, sign * value])
for y in (0, 1e-6, 1e-3, 0.1, 0.5, 1, 2, 10, 1e3):
    for x in (0, 1e-6, 1e-3, 0.1, 0.5, 1, 2, 10, 1e3):
        for sign in (1, -1):
            if x or (y and sign > 0):
                rows.append(["arc_tangent", f32(y), f32(sign * x), *zero, 0.0, atan2(mpf(f32(y)), mpf(f32(sign * x)))])

write_table(
    "habitat",
    """column [L] between (ax, ay, az) and (bx, by, bz) of a density exp(rise (y^2 + z^2 - radius^2));
    dawson [1] of rise; arc_tangent [rad] of rise over radius""",
    ["function", "rise", "radius", "ax", "ay", "az", "bx", "by", "bz", "value"],
    rows,
)
