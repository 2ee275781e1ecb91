"""The air of the column and single-scattering tables, at mpmath's working precision.

Geometry is the textbook's: positions as distance from the centre, everything that cancels there is made up for by
digits. Coefficients are float32 numbers, so that float, double and long double hold the very same air.
"""

from mpmath import exp, inf, mpf, quad, sqrt

from reference import f32

RADIUS = mpf(6360000)
TOP = mpf(100000)
RAYLEIGH_HEIGHT = mpf(8000)
MIE_HEIGHT = mpf(1200)
TENT = (mpf(25000), mpf(15000))
LORENTZIAN = (mpf(30000), mpf(4000))
RAYLEIGH = [mpf(f32(x)) for x in (5.802e-6, 13.558e-6, 33.1e-6)]
MIE_SCATTERING = mpf(f32(3.996e-6))
MIE_ABSORPTION = mpf(f32(0.444e-6))
OZONE = [mpf(f32(x)) for x in (0.65e-6, 1.881e-6, 0.085e-6)]
G = mpf(f32(0.8))


def densities(h):
    """Rayleigh, Mie, ozone as a tent, ozone as a Lorentz curve times Rayleigh."""
    h = max(h, mpf(0))
    rayleigh = exp(-h / RAYLEIGH_HEIGHT)
    tent = max(mpf(0), 1 - abs(h - TENT[0]) / TENT[1])
    x = (h - LORENTZIAN[0]) / LORENTZIAN[1]
    return rayleigh, exp(-h / MIE_HEIGHT), tent, rayleigh / (1 + x * x)


class Ray:
    """A ray from radius r with cosine mu; t runs along it."""

    def __init__(self, r, mu):
        self.r = r
        self.along = r * mu

    def altitude(self, t):
        return sqrt(self.r**2 + t * (2 * self.along + t)) - RADIUS

    def crossings(self, altitude):
        discriminant = self.along**2 - self.r**2 + (RADIUS + altitude) ** 2
        if discriminant <= 0:
            return []
        half = sqrt(discriminant)
        return [-self.along - half, -self.along + half]

    def air(self, distance):
        """(begin, end) of the air along the ray, the ground not there; None where there is none."""
        crossings = self.crossings(TOP)
        if not crossings:
            return None
        begin, end = max(crossings[0], mpf(0)), min(crossings[1], distance)
        return (begin, end) if end > begin else None

    def meets_ground(self):
        return self.along < 0 and len(self.crossings(mpf(0))) == 2

    def cuts(self, begin, end):
        """begin, end and what lies between: the edges of the profiles, heights where they change fast, perigee, ground."""
        cuts = {begin, end}
        heights = [0, 1200, 3000, 6000, 10000, 17500, 25000, 30000, 40000, 60000]
        inside = [t for h in heights for t in self.crossings(mpf(h))] + [-self.along]
        return sorted(cuts | {t for t in inside if begin < t < end})


def columns(ray, begin, end):
    """The four densities integrated from begin to end."""
    cuts = ray.cuts(begin, end)
    return [quad(lambda t: densities(ray.altitude(t))[i], cuts) for i in range(4)]
