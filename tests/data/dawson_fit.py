#!/usr/bin/python3
"""Fits the rational function of dawson: its integral over x is p(y) / q(y) with y = x^2, for x from 0 to infinity.

usage: dawson_fit.py [degree of p] [degree of q]      default: 7 8, the coefficients in dawson.hpp

Least squares of the relative error, weights raised where the error is large until its ripples are level. Prints the
coefficients, lowest power first, and the largest relative error. Needs Debian's python3-numpy and python3-mpmath.
"""

import sys

import mpmath
import numpy

import rational_fit

mpmath.mp.dps = 30


def dawson_over_x(y):
    y = mpmath.mpf(y)
    if y < 625:
        x = mpmath.sqrt(y)
        return float(mpmath.sqrt(mpmath.pi) / 2 * mpmath.exp(-y) * mpmath.erfi(x) / x)
    # The asymptotic series: its ninth term is below 1e-18 from y = 625 on.
    return float(sum(mpmath.fac2(2 * k - 1) / (2 * y) ** k for k in range(9)) / (2 * y))


def points():
    # u = y / (1 + y) carries [0, infinity) to [0, 1).
    u = rational_fit.chebyshev_shares(1500)
    y = u / (1 - u)
    return y, numpy.array([dawson_over_x(v) for v in y])


if __name__ == "__main__":
    sys.exit(rational_fit.main("dawson_fit.py", __doc__, (7, 8), points))
