"""Phase functions [1/sr] written from their textbook definitions.

Henyey-Greenstein and Draine by their closed forms; Cornette-Shanks as Henyey-Greenstein times
(1 + c^2), its norm found by numerical integration here rather than taken from the paper; the fog phase
from the fit of Jendersie and d'Eon 2023 (5 to 50 um).
"""

from mpmath import exp, mp, mpf, pi, quad, sqrt

from reference import Sampler, f32, figure, write_table

sampler = Sampler(2)


def rayleigh(c):
    return 3 * (1 + c * c) / (16 * pi)


def henyey_greenstein(c, g):
    base = 1 + g * g - 2 * g * c
    return (1 - g * g) / (4 * pi * base * sqrt(base))


norms = {}


def cornette_shanks(c, g):
    if g not in norms:
        lobe = lambda u: (1 + u * u) * henyey_greenstein(u, g)
        edges = [-1, 0] + [1 - mpf(2) ** -k for k in range(1, 12)] + [1]
        edges = edges if g >= 0 else [-e for e in reversed(edges)]
        norms[g] = 2 * pi * quad(lobe, edges)
    return (1 + c * c) * henyey_greenstein(c, g) / norms[g]


def schlick(c, k):
    return (1 - k * k) / (4 * pi * (1 - k * c) ** 2)


def draine(c, g, alpha):
    return henyey_greenstein(c, g) * (1 + alpha * c * c) / (1 + alpha * (1 + 2 * g * g) / 3)


def fog(c, d):
    g_hg = exp(-mpf("0.0990567") / (d - mpf("1.67154")))
    g_d = exp(-mpf("2.20679") / (d + mpf("3.91029")) - mpf("0.428934"))
    alpha = exp(mpf("3.62489") - mpf("8.29288") / (d + mpf("5.52825")))
    share = exp(-mpf("0.599085") / (d - mpf("0.641583")) - mpf("0.665888"))
    return (1 - share) * henyey_greenstein(c, g_hg) + share * draine(c, g_d, alpha)


def condition(function, arguments):
    """sum |df/dx| |x| + |f|, by central differences far below the table's last digit. For the lobes
    (1 + g^2 - 2 g c)^-1.5 the powers are written out where c = 1 leaves no room for a difference."""
    total = abs(function(*arguments))
    for i, x in enumerate(arguments):
        step = mpf(10) ** -25
        up = list(arguments)
        down = list(arguments)
        up[i] = x + step
        down[i] = x - step
        total += abs((function(*up) - function(*down)) / (2 * step) * x)
    return total


functions = {
    "rayleigh": rayleigh,
    "henyey_greenstein": henyey_greenstein,
    "cornette_shanks": cornette_shanks,
    "schlick": schlick,
    "draine": draine,
    "fog": fog,
}


def cosines(count):
    yield from (-1.0, -0.5, 0.0, 0.5, f32(0.999), f32(0.99999), 1.0)
    for _ in range(count):
        yield sampler.uniform(-1, 1)


def plain_cornette_shanks(c, g):
    # The closed norm, only for the condition number (differences of a memoised quadrature are slow).
    return henyey_greenstein(c, g) * (1 + c * c) * 3 / (2 * (2 + g * g))


rows = []


def add(name, c, *parameters):
    exact = [mpf(c)] + [mpf(p) for p in parameters]
    with_closed_norm = plain_cornette_shanks if name == "cornette_shanks" else functions[name]
    p = [float(x) for x in parameters] + [0.0] * (2 - len(parameters))
    rows.append([name, c, p[0], p[1], functions[name](*exact), figure(condition(with_closed_norm, exact))])


for c in cosines(40):
    add("rayleigh", c)
gs = [0.0, f32(0.1), f32(0.5), f32(0.76), f32(0.8), f32(0.99), f32(-0.5), f32(-0.9)]
for g in gs:
    for c in cosines(8):
        add("henyey_greenstein", c, g)
        add("cornette_shanks", c, g)
        add("schlick", c, g)
        add("draine", c, g, sampler.uniform(0, 60))
for d in (5.0, 7.5, 10.0, 20.0, 35.0, 50.0):
    for c in cosines(8):
        add("fog", c, d)

write_table(
    "phase",
    """phase functions [1/sr]; c = cosine of the scattering angle, 1 forward; p, q = their parameters in the
    order of the function's arguments; condition = sum |df/dx| |x| + |f|""",
    ["function", "c", "p", "q", "expected", "condition"],
    rows,
)
