"""Density profiles [1] at altitudes >= 0."""

from mpmath import exp, mpf

from reference import Sampler, f32, figure, write_table

sampler = Sampler(3)


def exponential(h, scale):
    return exp(-h / scale), figure((1 + 2 * h / scale) * exp(-h / scale))


def tent(h, centre, half_width):
    value = max(mpf(0), 1 - abs(h - centre) / half_width)
    return value, figure(value + (abs(h) + abs(centre) + abs(h - centre)) / half_width)


def lorentzian(h, centre, half_width):
    x = (h - centre) / half_width
    value = 1 / (1 + x * x)
    slope = 2 * abs(x) * value * value
    return value, figure(value + slope * ((abs(h) + abs(centre)) / half_width + abs(x)))


rows = []
for _ in range(80):
    h, scale = sampler.log_uniform(0.01, 2e5), sampler.log_uniform(0.1, 1e6)
    if mpf(h) / mpf(scale) < 80:  # further down float has only denormals; the unit test has its own case
        rows.append(["exponential", h, scale, 0.0, *exponential(mpf(h), mpf(scale))])
for h, scale in ((0.0, 8000.0), (8000.0, 8000.0), (1200.0, 1200.0), (f32(8848.86), 8000.0), (1.0, 0.125)):
    rows.append(["exponential", h, scale, 0.0, *exponential(mpf(h), mpf(scale))])
for name, function in (("tent", tent), ("lorentzian", lorentzian)):
    for _ in range(60):
        h, c, w = sampler.uniform(0, 60000), sampler.uniform(10000, 40000), sampler.log_uniform(1000, 30000)
        rows.append([name, h, c, w, *function(mpf(h), mpf(c), mpf(w))])
    for h in (0.0, 10000.0, 25000.0, 40000.0, 32500.0):
        rows.append([name, h, 25000.0, 15000.0, *function(mpf(h), mpf(25000), mpf(15000))])

write_table(
    "density",
    """relative density [1] at altitude h; p, q = scale height, or centre and half width, one length unit;
    condition = sum |df/dx| |x| + |f|""",
    ["function", "h", "p", "q", "expected", "condition"],
    rows,
)
