#!/usr/bin/python3
"""Fits the rational function of arc_tangent: atan(t) / t = p(t^2) / q(t^2), for t from 0 to 1.

usage: arc_tangent_fit.py [degree of p] [degree of q]      default: 2 3, the coefficients in arc_tangent.hpp

Least squares of the relative error, weights raised where the error is large until its ripples are level. Prints the
coefficients, lowest power first, and the largest relative error. Needs Debian's python3-numpy.
"""

import sys

import numpy

import rational_fit


def points():
    t = rational_fit.chebyshev_shares(1500)
    return t * t, numpy.arctan(t) / t


if __name__ == "__main__":
    sys.exit(rational_fit.main("arc_tangent_fit.py", __doc__, (2, 3), points))
