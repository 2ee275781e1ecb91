#!/usr/bin/python3
"""Fits the twelve shells of lorentzian_ramps: where they lie, and what share of the density each gets.

A Lorentz curve times the Rayleigh density is replaced by straight lines between twelve shells. The fit
makes the columns outwards along straight lines right, level and steep ones, for Leenman's layer and, with
less weight, for four like it. Prints the two lists for include/airlight/ozone_ramps.hpp and the errors of each layer.
"""
import argparse
import sys

try:
    import numpy
    from scipy.optimize import least_squares
except ImportError as missing:
    sys.exit(f"fit_ozone.py: {missing.name} is missing: apt-get install python3-numpy python3-scipy")

RADIUS = 6371e3
# Centre, half width, Rayleigh scale height [m]: Leenman's first.
LAYERS = [(30e3, 4e3, 8e3), (22e3, 5e3, 8e3), (25e3, 3e3, 8e3), (30e3, 6e3, 8e3), (20e3, 3e3, 7e3)]
# Leenman's is the one layer of this kind that is printed: it weighs the most.
WEIGHTS = [8, 1, 1, 1, 1]
# Not fitted, only judged: wide, high over the molecules, narrow.
OTHERS = [(30e3, 12e3, 8e3), (30e3, 20e3, 8e3), (0, 20e3, 8e3), (30e3, 4e3, 4e3), (30e3, 4e3, 2e3), (30e3, 4e3, 500),
          (30e3, 1e3, 8e3), (30e3, 300, 8e3)]
# Where the fit starts: what the header has.
SHELLS = [-7.99, -6.01, -4.35, -2.55, -1.47, -0.39, -0.01, 0.56, 0.98, 1.6, 2.63, 5.29]
SHARES = [0.959, 0.983, 0.969, 0.96, 0.977, 1.015, 1.024, 1.001, 0.945, 0.903, 0.727, 0]
POINTS = 3000  # along a line
STEEP = [1, 0.7, 0.4, 0.2]  # cosines to the vertical at the ground


class Layer:
    def __init__(self, centre, width, height):
        self.centre, self.width, self.height = centre, width, height
        self.lines = []
        top = max(centre + 15 * width, 10 * height)
        tails = numpy.linspace(0, centre + 5 * width, 31)
        peak = numpy.linspace(centre - 2 * width, centre + 2 * width, 41)  # a line at the peak feels every kink
        for perigee in numpy.concatenate([tails, peak]):
            end = numpy.sqrt((RADIUS + top) ** 2 - (RADIUS + perigee) ** 2)
            s = end * numpy.linspace(0, 1, POINTS) ** 2
            self.lines.append((s, s * s / (numpy.hypot(RADIUS + perigee, s) + RADIUS + perigee) + perigee))
        for mu in STEEP:
            perigee_radius = RADIUS * numpy.sqrt(1 - mu * mu)
            start = RADIUS * mu
            end = numpy.sqrt((RADIUS + top) ** 2 - perigee_radius**2)
            s = numpy.linspace(start, end, POINTS)
            self.lines.append((s, numpy.hypot(perigee_radius, s) - RADIUS))
        self.columns = self.outwards(self.density)
        self.largest = self.columns.max()

    def density(self, altitude):
        return numpy.exp(-altitude / self.height) / (1 + ((altitude - self.centre) / self.width) ** 2)

    def outwards(self, density):
        """Columns from points of every line to its end: the trapezoid rule."""
        rows = []
        for s, altitude in self.lines:
            n = density(altitude)
            air = 0.5 * (n[1:] + n[:-1]) * numpy.diff(s)
            rows.append(numpy.append(numpy.cumsum(air[::-1])[::-1], 0)[::20])
        return numpy.array(rows)

    def errors(self, shells, shares):
        """Of all columns, over the largest; of the steep columns from the ground, relative."""
        # As lorentzian_ramps places them.
        centre = min(self.centre, 6 * self.height)
        at = centre + min(self.width, max(-centre / shells[0], 0.7 * self.height)) * shells
        at[0] = min(at[0], 0)
        density = self.density(at) * shares
        off = self.outwards(lambda altitude: numpy.interp(altitude, at, density)) - self.columns
        return off / self.largest, off[-len(STEEP):, 0] / self.columns[-len(STEEP):, 0]


def unpacked(numbers):
    count = len(SHELLS)
    return numpy.cumsum(numpy.append(numbers[0], numpy.abs(numbers[1:count]))), numpy.append(numbers[count:], 0)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=40, help="rounds of the fit; 0 judges the header's numbers")
    rounds = parser.parse_args().rounds
    layers = [Layer(*layer) for layer in LAYERS]

    def residuals(numbers):
        # The power 1.5 leans towards the largest errors; light falls steeply through little ozone.
        parts = []
        for layer, weight in zip(layers, WEIGHTS):
            level, steep = layer.errors(*unpacked(numbers))
            parts += [20 * weight * numpy.sign(level.ravel()) * numpy.abs(level.ravel()) ** 1.5, 0.3 * weight * steep]
        return numpy.concatenate(parts)

    shells, shares = numpy.array(SHELLS), numpy.array(SHARES, dtype=float)
    if rounds > 0:
        start = numpy.concatenate([[shells[0]], numpy.diff(shells), shares[:-1]])
        shells, shares = unpacked(least_squares(residuals, start, max_nfev=rounds).x)
    print("shells [half widths]:", ", ".join(f"{x:.2f}" for x in shells))
    print("shares:", ", ".join(f"{x:.3f}" for x in shares))
    for layer in layers + [Layer(*other) for other in OTHERS]:
        level, steep = layer.errors(shells, shares)
        print(f"centre {layer.centre / 1e3:.0f} km, half width {layer.width / 1e3:g} km, scale height "
              f"{layer.height / 1e3:g} km: {numpy.abs(level).max():.1e} of the largest column, "
              f"{numpy.abs(steep).max():.1e} of the steep ones")


if __name__ == "__main__":
    main()
