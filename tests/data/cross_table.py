"""Cross products of two nearly parallel, nearly opposite and any unit vectors, exact for the rounded inputs."""

from mpmath import mpf, sqrt

from reference import Sampler, f32, write_table

sampler = Sampler(8)
rows = []


def unit(v):
    length = sqrt(sum(mpf(x) ** 2 for x in v))
    return [f32(mpf(x) / length) for x in v]


def add(a, b):
    exact_a = [mpf(x) for x in a]
    exact_b = [mpf(x) for x in b]
    cross = [exact_a[i - 2] * exact_b[i - 1] - exact_a[i - 1] * exact_b[i - 2] for i in range(3)]
    rows.append([*a, *b, *cross])


for _ in range(20):
    a = unit([sampler.uniform(-1, 1) for _ in range(3)])
    add(a, unit([sampler.uniform(-1, 1) for _ in range(3)]))
    for sign in (1, -1):
        tilt = sampler.log_uniform(1e-6, 0.1)
        add(a, unit([sign * x + tilt * sampler.uniform(-1, 1) for x in a]))

write_table("cross", "a x b for the vectors as printed", ["ax", "ay", "az", "bx", "by", "bz", "x", "y", "z"], rows)
