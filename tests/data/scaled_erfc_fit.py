#!/usr/bin/python3
"""Fits the rational function of scaled_erfc: sqrt(pi) exp(x^2) erfc(x) = p(x) / q(x), for x from 0 to infinity.

usage: scaled_erfc_fit.py [degree of p] [degree of q]      default: 4 5, the coefficients in chapman.hpp

Least squares of the relative error, weights raised where the error is large until its ripples are level. Prints the
coefficients, lowest power first, and the largest relative error. Needs Debian's python3-numpy and python3-mpmath.
"""

import sys

import mpmath
import numpy

mpmath.mp.dps = 30
SAMPLES = 1500
ROUNDS = 400


def scaled_erfc(x):
    x = mpmath.mpf(x)
    if x < 20:
        return float(mpmath.sqrt(mpmath.pi) * mpmath.exp(x * x) * mpmath.erfc(x))
    # The asymptotic series: its eighth term is below 1e-15 from x = 20 on.
    return float(sum((-1) ** k * mpmath.fac2(2 * k - 1) / (2 * x * x) ** k for k in range(8)) / x)


def fit(degree_p, degree_q):
    # u = x / (1 + x) carries [0, infinity) to [0, 1), Chebyshev's points on it crowd at both ends.
    u = (1 - numpy.cos(numpy.pi * (numpy.arange(SAMPLES) + 0.5) / SAMPLES)) / 2
    x = u / (1 - u)
    f = numpy.array([scaled_erfc(v) for v in x])
    # Powers over (1 + x)^degree_q, so that none overflows; the factor cancels in p / q.
    powers = [x**k * (1 / (1 + x)) ** degree_q for k in range(max(degree_p, degree_q) + 1)]
    weight = numpy.ones(SAMPLES)
    q_before = numpy.ones(SAMPLES)
    best = None
    for _ in range(ROUNDS):
        # p - f q = 0 with the constant of q at 1, over f times the q of the round before.
        unknowns = [v / (f * q_before) for v in powers[: degree_p + 1]]
        unknowns += [-v / q_before for v in powers[1 : degree_q + 1]]
        matrix = numpy.array(unknowns).T * weight[:, None]
        solution = numpy.linalg.lstsq(matrix, powers[0] / q_before * weight, rcond=None)[0]
        p = solution[: degree_p + 1]
        q = numpy.append(1.0, solution[degree_p + 1 :])
        q_before = sum(c * v for c, v in zip(q, powers))
        error = sum(c * v for c, v in zip(p, powers)) / q_before / f - 1
        largest = numpy.abs(error).max()
        if best is None or largest < best[0]:
            best = (largest, p, q)
        weight = weight * (0.3 + numpy.abs(error) / largest) ** 0.7
        weight = weight / weight.max()
    return best


def main():
    arguments = sys.argv[1:]
    if "-h" in arguments or "--help" in arguments:
        print(__doc__.strip())
        return 0
    if len(arguments) not in (0, 2) or not all(a.isdigit() for a in arguments):
        print("scaled_erfc_fit.py: give both degrees or none, as in: scaled_erfc_fit.py 4 5", file=sys.stderr)
        return 1
    degree_p, degree_q = (int(a) for a in arguments) if arguments else (4, 5)
    largest, p, q = fit(degree_p, degree_q)
    for name, coefficients in (("p", p), ("q", q)):
        for k, c in enumerate(coefficients):
            print("%s%d = %r" % (name, k, float(c)))
    print("largest relative error %.4g on %d points" % (largest, SAMPLES))
    return 0


if __name__ == "__main__":
    sys.exit(main())
