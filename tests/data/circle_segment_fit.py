#!/usr/bin/python3
"""Fits the rational function of segment_over_chord: area of a segment of the unit circle over the cube of its half
chord, (acos(t) - t sqrt(1 - t^2)) / (1 - t^2)^(3/2) = p(t) / q(t), for chords at a distance t from 0 to 1.

usage: circle_segment_fit.py [degree of p] [degree of q]      default: 3 3, the coefficients in occultation.hpp

Interpolates at Chebyshev's points with both ends among them, so that half a circle, pi / 2, and the limit of thin
segments, 2 / 3, come out right. Prints the coefficients, lowest power first, and the largest relative error. Needs
Debian's python3-mpmath.
"""

import sys

import mpmath
from mpmath import mp, mpf

mp.dps = 60
CHECKED = 4000


def segment_over_chord(t):
    if t == 1:
        return mpf(2) / 3
    half_chord = mpmath.sqrt((1 - t) * (1 + t))
    return (mpmath.acos(t) - t * half_chord) / half_chord**3


def fit(degree_p, degree_q):
    count = degree_p + degree_q + 1
    matrix = mpmath.matrix(count, count)
    values = mpmath.matrix(count, 1)
    for i in range(count):
        t = (1 - mpmath.cos(mpmath.pi * i / (count - 1))) / 2
        f = segment_over_chord(t)
        for k in range(degree_p + 1):
            matrix[i, k] = t**k
        for k in range(1, degree_q + 1):
            matrix[i, degree_p + k] = -f * t**k
        values[i] = f
    solution = list(mpmath.lu_solve(matrix, values))
    return solution[: degree_p + 1], [mpf(1), *solution[degree_p + 1 :]]


def largest_error(p, q):
    worst = mpf(0)
    for i in range(CHECKED + 1):
        t = mpf(i) / CHECKED
        value = mpmath.polyval(p[::-1], t) / mpmath.polyval(q[::-1], t)
        worst = max(worst, abs(value / segment_over_chord(t) - 1))
    return worst


def main():
    arguments = sys.argv[1:]
    if "-h" in arguments or "--help" in arguments:
        print(__doc__.strip())
        return 0
    if len(arguments) not in (0, 2) or not all(a.isdigit() for a in arguments):
        print("circle_segment_fit.py: give both degrees or none, as in: circle_segment_fit.py 3 3", file=sys.stderr)
        return 1
    degree_p, degree_q = (int(a) for a in arguments) if arguments else (3, 3)
    if degree_p + degree_q < 1:
        print("circle_segment_fit.py: one of the degrees must be above 0", file=sys.stderr)
        return 1
    p, q = fit(degree_p, degree_q)
    for name, coefficients in (("p", p), ("q", q)):
        for k, c in enumerate(coefficients):
            print("%s%d = %s" % (name, k, mpmath.nstr(c, 21)))
    print("largest relative error %s on %d points" % (mpmath.nstr(largest_error(p, q), 4), CHECKED + 1))
    return 0


if __name__ == "__main__":
    sys.exit(main())
