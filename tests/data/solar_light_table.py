#!/usr/bin/python3
"""The sun's light above the air, from its spectrum: total, as the eye sees it, and at the wavelengths of earth().

The spectrum and the colour-matching functions are taken as straight lines between the points of their tables, and the
product of two straight lines is integrated exactly.
"""

import csv
import os

from mpmath import matrix, mpf

from reference import FOLDER, write_table

# The mean of 42 years by Gueymard, A reevaluation of the solar constant (2018) [W/m^2]. The spectrum integrates to
# 1366.1, the value in use when it was made, and is scaled.
TOTAL = mpf("1361.1")
LUMENS_PER_WATT = 683  # of light at 555 nm, by the definition of the candela
# Chromaticities of the primaries and of white, ITU-R BT.709.
PRIMARIES = [("0.64", "0.33"), ("0.30", "0.60"), ("0.15", "0.06")]
WHITE = ("0.3127", "0.3290")


def inputs(name):
    with open(os.path.join(FOLDER, "inputs", name + ".csv"), encoding="ascii") as file:
        rows = list(csv.reader(line for line in file if not line.startswith("#")))
    return [[mpf(cell) for cell in row] for row in rows[1:]]


def at(points, x):
    """The straight lines through points, at x; 0 outside them."""
    for (x0, y0), (x1, y1) in zip(points, points[1:]):
        if x0 <= x <= x1:
            return y0 + (y1 - y0) * (x - x0) / (x1 - x0)
    return mpf(0)


def integral(spectrum, weight):
    """Of the product, over the weight's range: by Simpson's rule between neighbours of either, exact for parabolas."""
    low, high = weight[0][0], weight[-1][0]
    inner = {x for x, _ in spectrum + weight if low < x < high}
    knots = [low, *sorted(inner), high]
    total = mpf(0)
    for a, b in zip(knots, knots[1:]):
        middle = (a + b) / 2
        f = [at(spectrum, x) * at(weight, x) for x in (a, middle, b)]
        total += (b - a) / 6 * (f[0] + 4 * f[1] + f[2])
    return total


def rgb_from_xyz():
    """The matrix that makes white (1, 1, 1)."""
    def xyz(x, y):
        return [mpf(x) / mpf(y), mpf(1), (1 - mpf(x) - mpf(y)) / mpf(y)]
    columns = [xyz(*p) for p in PRIMARIES]
    primaries = matrix(3, 3)
    for i in range(3):
        for j in range(3):
            primaries[i, j] = columns[j][i]
    strengths = primaries**-1 * matrix(xyz(*WHITE))
    for i in range(3):
        for j in range(3):
            primaries[i, j] *= strengths[j]
    return primaries**-1


table = inputs("astm_e490")
whole = [(1000 * um, value / 1000) for um, value in table]  # nm, W / (m^2 nm)
printed_total = integral(whole, [(whole[0][0], mpf(1)), (whole[-1][0], mpf(1))])
scale = TOTAL / printed_total
visible = [(nm, scale * value) for nm, value in whole if 340 < nm < 850]

observer = inputs("cie_1931")
eye = [LUMENS_PER_WATT * integral(visible, [(row[0], row[k]) for row in observer]) for k in (1, 2, 3)]
rgb = rgb_from_xyz() * matrix(eye)

rows = [
    ["printed_total", printed_total],
    ["total", TOTAL],
    ["illuminance", eye[1]],
    ["chromaticity_x", eye[0] / sum(eye)],
    ["chromaticity_y", eye[1] / sum(eye)],
    ["red", rgb[0]],
    ["green", rgb[1]],
    ["blue", rgb[2]],
]
for nm in (680, 550, 440):
    band = [(mpf(nm - 5), mpf("0.1")), (mpf(nm + 5), mpf("0.1"))]  # the mean over 10 nm
    rows.append(["at_%d" % nm, integral(visible, band)])

write_table(
    "solar_light",
    """printed_total, of the spectrum as printed, and total [W/m^2]; illuminance, red, green, blue [lx]; at_<nm>: mean
    over 10 nm [W/(m^2 nm)]""",
    ["what", "expected"],
    rows,
)
