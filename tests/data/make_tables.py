#!/usr/bin/python3
"""Writes every table of this folder; with --check, compares instead and writes nothing here.

usage: make_tables.py [--check] [name ...]      for example: make_tables.py phase density

Needs Debian's python3-mpmath.
"""

import filecmp
import glob
import os
import subprocess
import sys
import tempfile

folder = os.path.dirname(os.path.abspath(__file__))


def scripts():
    return sorted(glob.glob(os.path.join(folder, "*_table.py")))


def main():
    arguments = sys.argv[1:]
    if "-h" in arguments or "--help" in arguments:
        print(__doc__.strip())
        return 0
    check = "--check" in arguments
    names = [a for a in arguments if a != "--check"]
    known = [os.path.basename(s)[: -len("_table.py")] for s in scripts()]
    for name in names:
        if name not in known:
            print("make_tables.py: no table named '%s'; there are: %s" % (name, ", ".join(known)), file=sys.stderr)
            return 1
    status = 0
    with tempfile.TemporaryDirectory() as scratch:
        environment = dict(os.environ, PYTHONDONTWRITEBYTECODE="1", AIRLIGHT_TABLES=scratch if check else folder)
        for name in names or known:
            run = subprocess.run([sys.executable, os.path.join(folder, name + "_table.py")], env=environment)
            if run.returncode != 0:
                print("make_tables.py: %s_table.py failed" % name, file=sys.stderr)
                status = 1
                continue
            table = name + ".csv"
            if check and not (
                os.path.exists(os.path.join(folder, table))
                and filecmp.cmp(os.path.join(scratch, table), os.path.join(folder, table), shallow=False)
            ):
                print("make_tables.py: %s differs from what its script writes; rerun the script" % table, file=sys.stderr)
                status = 1
    return status


if __name__ == "__main__":
    sys.exit(main())
