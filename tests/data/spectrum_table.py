"""Coefficients from optics: King factor, Rayleigh coefficient, visibility, Angstrom, absorption."""

from mpmath import log, mpf, pi, power

from reference import Sampler, f32, write_table

sampler = Sampler(5)
rows = []


def king(d):
    return (6 + 3 * d) / (6 - 7 * d)


def rayleigh(refractivity, density, wavelength):
    n = 1 + refractivity
    return 8 * pi**3 * (n * n - 1) ** 2 / (3 * density * wavelength**4)


def visibility(distance, contrast):
    return -log(contrast) / distance


def angstrom(wavelength, reference, exponent):
    return power(wavelength / reference, -exponent)


def absorption(scattering, albedo):
    return scattering / albedo - scattering


def add(name, function, *arguments):
    cells = [float(a) for a in arguments] + [0.0] * (3 - len(arguments))
    rows.append([name, *cells, function(*[mpf(a) for a in arguments])])


for d in (0.0, f32(0.0279), f32(0.035), f32(0.09), f32(0.1), f32(0.5)):
    add("king", king, d)
for _ in range(20):
    add("king", king, sampler.uniform(0, f32(0.1)))
for _ in range(30):
    # Number density in 1/um^3, wavelength in um: within float's range.
    add("rayleigh", rayleigh, sampler.log_uniform(1e-6, 1e-2), sampler.log_uniform(1e4, 1e8), sampler.uniform(0.25, 2))
add("rayleigh", rayleigh, f32(0.00027783191), f32(2.546899e7), f32(0.55))
for _ in range(20):
    add("visibility", visibility, sampler.log_uniform(10, 3e5), sampler.uniform(0.01, 0.9))
for contrast in (f32(0.02), f32(0.05), 1.0):
    add("visibility", visibility, 23000.0, contrast)
for _ in range(30):
    add("angstrom", angstrom, sampler.uniform(0.3, 2), sampler.uniform(0.3, 2), sampler.uniform(-1, 4))
for albedo in (f32(0.9), f32(0.61), f32(0.97), 0.5, 1.0, f32(1e-3)):
    for scattering in (f32(4e-6), 1.0, f32(0.02)):
        add("absorption", absorption, scattering, albedo)

write_table(
    "spectrum",
    """a, b, c = the function's arguments in order (absorption: one channel's scattering, albedo); rayleigh:
    refractivity n - 1 [1], number density [1/um^3], wavelength [um], result [1/um]""",
    ["function", "a", "b", "c", "expected"],
    rows,
)
