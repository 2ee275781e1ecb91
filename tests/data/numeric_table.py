"""1 - exp(-x) by mpmath, from tiny to large x and across the switch of methods at 0.5."""

from mpmath import exp, mpf

from reference import Sampler, f32, write_table

sampler = Sampler(1)
xs = [0.0, f32(1e-38), f32(1e-30), f32(1e-20), f32(1e-10), f32(1e-5), 0.5, 0.4375, 0.5625, 1.0, 2.0, 20.0, 88.0, 200.0]
xs += [f32(0.5 * (1 - 2.0**-24)), f32(0.5 * (1 + 2.0**-23))]
xs += [sampler.log_uniform(1e-8, 0.5) for _ in range(150)]
xs += [sampler.uniform(0.25, 0.75) for _ in range(100)]
xs += [sampler.uniform(0.5, 40) for _ in range(80)]
# Outside the domain: the function still follows the formula there.
xs += [-x for x in (f32(1e-10), f32(0.1), 0.4375, 0.5, 1.0, 10.0)]


def expected(x):
    # expm1 by a working precision wide enough for the cancellation.
    from mpmath import workdps

    with workdps(120):
        return 1 - exp(-mpf(x))


write_table("numeric", "x [1], 1 - exp(-x) [1]", ["x", "one_minus_exp"], [[x, +expected(x)] for x in xs])
