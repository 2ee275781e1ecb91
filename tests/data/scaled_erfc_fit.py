#!/usr/bin/python3
"""Fits the rational function of scaled_erfc: sqrt(pi) exp(x^2) erfc(x) = p(x) / q(x), for x from 0 to infinity.

usage: scaled_erfc_fit.py [degree of p] [degree of q]      default: 4 5, the coefficients in chapman.hpp

Least squares of the relative error, weights raised where the error is large until its ripples are level. Prints the
coefficients, lowest power first, and the largest relative error. Needs Debian's python3-numpy and python3-mpmath.
"""

import sys

import mpmath
import numpy

import rational_fit

mpmath.mp.dps = 30


def scaled_erfc(x):
    x = mpmath.mpf(x)
    if x < 20:
        return float(mpmath.sqrt(mpmath.pi) * mpmath.exp(x * x) * mpmath.erfc(x))
    # The asymptotic series: its eighth term is below 1e-15 from x = 20 on.
    return float(sum((-1) ** k * mpmath.fac2(2 * k - 1) / (2 * x * x) ** k for k in range(8)) / x)


def points():
    # u = x / (1 + x) carries [0, infinity) to [0, 1).
    u = rational_fit.chebyshev_shares(1500)
    x = u / (1 - u)
    return x, numpy.array([scaled_erfc(v) for v in x])


if __name__ == "__main__":
    sys.exit(rational_fit.main("scaled_erfc_fit.py", __doc__, (4, 5), points))
