"""What every table script shares: 50 digits, numbers that float32 holds, and the CSV format.

Inputs are rounded to float32 before anything is computed, so that float, double and long double all see
exactly the numbers the table was made for. Results are printed with 50 digits.
"""

import os
import random
import struct
import tempfile

import mpmath
from mpmath import mp, mpf

DIGITS = 50
mp.dps = DIGITS + 15

FOLDER = os.path.dirname(os.path.abspath(__file__))


def f32(x):
    """The float32 nearest to x, as a Python float."""
    return struct.unpack("f", struct.pack("f", float(x)))[0]


class Sampler:
    """Seeded samples that float32 holds."""

    def __init__(self, seed):
        self.random = random.Random(seed)

    def uniform(self, low, high):
        return min(max(f32(self.random.uniform(low, high)), f32(low)), f32(high))

    def log_uniform(self, low, high):
        return f32(mpmath.exp(self.random.uniform(float(mpmath.log(low)), float(mpmath.log(high)))))


def text(cell):
    if isinstance(cell, bool):
        return "1" if cell else "0"
    if isinstance(cell, mpf):
        return mpmath.nstr(cell, DIGITS)
    if isinstance(cell, float):
        assert f32(cell) == cell, "an input that float32 does not hold: %r" % cell
        return repr(cell)
    return str(cell)


def figure(x):
    """A number of which six digits matter, such as a condition."""
    return mpmath.nstr(x, 6)


def write_table(name, about, columns, rows, folder=None, script=None):
    """Writes name.csv; a half-written file never stands under the final name. `script` is the caller's path."""
    folder = folder or os.environ.get("AIRLIGHT_TABLES", FOLDER)
    rows = [[text(cell) for cell in row] for row in rows]
    assert rows and all(len(row) == len(columns) for row in rows)
    descriptor, temporary = tempfile.mkstemp(dir=folder, prefix=name, suffix=".part")
    with os.fdopen(descriptor, "w", encoding="ascii", newline="\n") as file:
        file.write("# Written by %s; edit that file, not this one.\n" % (script or "tests/data/%s_table.py" % name))
        for line in about.strip().splitlines():
            file.write("# " + line.strip() + "\n")
        file.write(",".join(columns) + "\n")
        for row in rows:
            file.write(",".join(row) + "\n")
    os.chmod(temporary, 0o644)
    os.replace(temporary, os.path.join(folder, name + ".csv"))
    print("%-20s %5d rows" % (name + ".csv", len(rows)))
