"""Chapman's function upwards and the scaled complementary error function, to 50 digits."""

from mpmath import erfc, exp, mpf, pi, quad, sqrt

from reference import f32, write_table


def chapman(x, mu):
    """The exponential air on a ray to space over scale height times density, lengths in scale heights."""

    def density(s):
        rise = s * (2 * x * mu + s)
        return exp(-rise / (x + sqrt(x * x + rise)))

    # Cut where the ray has risen by so many scale heights; exp(-180) is below the last of 65 digits.
    def way(h):
        rise = h * (2 * x + h)
        return rise / (x * mu + sqrt((x * mu) ** 2 + rise)) if h else mpf(0)

    # A small planet bends the way within a few of its own radii: further cuts there.
    small = [x / 8, x, 8 * x] if x < 8 else []
    return quad(density, [way(h) for h in sorted([mpf(0), 1, 3, 8, 20, 60, 180] + small)])


rows = []
for x in (0, 1e-6, 1e-3, 0.01, 0.1, 0.25, 0.5, 0.75, 1, 1.5, 2, 3, 5, 8, 12, 20, 50, 100, 1e3, 1e4):
    v = mpf(f32(x))
    rows.append(["scaled_erfc", f32(x), 0.0, sqrt(pi) * exp(v * v) * erfc(v)])
for x in (0.01, 0.1, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 800, 5300, 1e5):
    for mu in (0, 1e-4, 1e-3, 0.01, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 0.9, 0.98, 1):
        rows.append(["chapman", f32(x), f32(mu), chapman(mpf(x), mpf(f32(mu)))])

write_table(
    "chapman",
    "sqrt(pi) exp(x^2) erfc(x) [1]; Chapman's function [1] of x = radius / scale height, upwards from the cosine mu",
    ["function", "x", "mu", "value"],
    rows,
)
