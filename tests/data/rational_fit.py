"""What every fit script shares: least squares of a rational function's relative error."""

import sys

import numpy

ROUNDS = 400


def chebyshev_shares(count):
    """Chebyshev's points of [0, 1], which crowd at both ends."""
    return (1 - numpy.cos(numpy.pi * (numpy.arange(count) + 0.5) / count)) / 2


def fit(x, f, degree_p, degree_q):
    """p and q, lowest power first, with p(x) / q(x) near f, and the largest relative error.

    Weights are raised where the error is large until its ripples are level.
    """
    # Powers over (1 + x)^degree_q, so that none overflows; the factor cancels in p / q.
    powers = [x**k * (1 / (1 + x)) ** degree_q for k in range(max(degree_p, degree_q) + 1)]
    weight = numpy.ones(len(x))
    q_before = numpy.ones(len(x))
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


def main(script, about, degrees, points):
    """Fits at points(), pairs of x and f, and prints the coefficients; the degrees come from the command line."""
    arguments = sys.argv[1:]
    if "-h" in arguments or "--help" in arguments:
        print(about.strip())
        return 0
    if len(arguments) not in (0, 2) or not all(a.isdigit() for a in arguments):
        print("%s: give both degrees or none, as in: %s %d %d" % (script, script, *degrees), file=sys.stderr)
        return 1
    degree_p, degree_q = (int(a) for a in arguments) if arguments else degrees
    x, f = points()
    largest, p, q = fit(x, f, degree_p, degree_q)
    for name, coefficients in (("p", p), ("q", q)):
        for k, c in enumerate(coefficients):
            print("%s%d = %r" % (name, k, float(c)))
    print("largest relative error %.4g on %d points" % (largest, len(x)))
    return 0
