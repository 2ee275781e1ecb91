"""The air of an exponential layer along rays above the ground, to 50 digits.

Lengths in metres, scale height 8000 m, air up to 60 scale heights, ground radius x scale heights. The condition is
sum |df/dv| |v| + |f| over ground radius, altitude, mu and distance.
"""

from mpmath import exp, inf, mp, mpf, quad, sqrt

from reference import f32, figure, write_table

HEIGHT = 8000
TOP = 60


def air(radius, altitude, mu, distance):
    """The integral of exp(-h / H) over the distance; positions from the planet's centre."""
    start = radius + altitude
    along = start * mu
    perigee_squared = start * start - along * along

    def reach(h):
        """Half the chord of the shell at altitude h."""
        return sqrt(max((radius + h) ** 2 - perigee_squared, mpf(0)))

    def density(t):
        return exp((radius - sqrt(perigee_squared + (along + t) ** 2)) / HEIGHT)

    end = min(distance, reach(mpf(TOP * HEIGHT)) - along)
    cuts = {mpf(0), end, -along}
    for k in (0.1, 0.5, 1, 2, 4, 8, 16, 32):
        for low in (perigee_squared**0.5 - radius, min(altitude, (perigee_squared + (along + end) ** 2) ** 0.5 - radius)):
            cuts |= {reach(low + k * HEIGHT) - along, -reach(low + k * HEIGHT) - along}
    return quad(density, sorted(t for t in cuts if 0 <= t <= end))


def condition(arguments):
    with mp.workdps(30):
        total = air(*arguments)
        for i, v in enumerate(arguments):
            if v == inf or v == 0:
                continue
            step = v * mpf(10) ** -10
            # Forwards where a step back would leave the domain, as from a cosine of 1.
            moved = list(arguments)
            moved[i] = v - step
            total += abs((air(*arguments) - air(*moved)) / step * v)
        return figure(total)


rows = []
for x in (50, 100, 800, 5300, 100000):
    radius = x * HEIGHT
    horizon = (2 / x) ** 0.5  # cosine of the ray that rises by one scale height above its perigee
    bow = x * horizon  # and that ray's length, in scale heights

    def add(altitude, mu, distance=None):
        values = [f32(radius), f32(altitude * HEIGHT), f32(mu), inf if distance is None else f32(distance * HEIGHT)]
        arguments = [mpf(v) for v in values]
        rows.append([x, *values[:3], "none" if distance is None else values[3], air(*arguments), condition(arguments)])

    # Vertical, up and down.
    add(0, 1)
    add(0, 1, 1)
    add(10, 1)
    add(1, -1, 1)
    add(10, -1, 10)
    add(10, -1, 0.5)
    # A thousandth of a scale height long.
    for altitude, mu in ((0, 1), (0, 0.5), (1, 0), (1, -0.5), (10, -1)):
        add(altitude, mu, 1e-3)
    # Slanted.
    for mu in (0.5, 0.1, 0.02):
        add(0, mu)
        add(1, mu, 3)
    add(4, -0.3, 8)
    add(10, 0.3)
    # Grazing: level or nearly so.
    add(0, 0)
    add(0, 1e-4)
    add(0, 0, 0.1 * bow)
    add(0, 0, bow)
    add(10, 0, 3 * bow)
    # Down to the perigee, which lies above the ground, and through it.
    for altitude in (2, 10):
        mu = -horizon * (altitude / 2) ** 0.5
        add(altitude, mu)
        add(altitude, mu, 0.5 * bow)
        add(altitude, mu, 2 * bow)
    add(0.5, -0.1 * horizon, 0.2 * bow)
    # Rising by a good quarter of a scale height, where the difference of two Chapman functions is shortest.
    for mu in (0.9, 0.5, 0.2):
        add(0, mu, 0.26 / mu)
    add(1.26, -horizon * 0.26**0.5, 2 * bow * 0.26**0.5)

write_table(
    "exponential_column",
    """air of an exponential layer along a ray [m]; scale height 8000 m, air up to 480 km, ground radius of x scale
    heights""",
    ["x", "ground_radius", "altitude", "mu", "distance", "column", "condition"],
    rows,
)
