"""Prints the constants of include/airlight/gauss.hpp: positions and weights of the rules of Gauss and Legendre
on [0, 1], to 33 digits.

    python3 tests/data/gauss_rules.py
"""
import mpmath

mpmath.mp.dps = 60
COUNTS = (4, 5, 6, 8, 10, 12, 16, 24)


def rule(count):
    """Positions and weights, ascending; each root lies in its own bracket (Szego)."""
    positions, weights = [], []
    for i in range(count):
        bracket = [-mpmath.cos(mpmath.pi * (i + share) / (count + mpmath.mpf(1) / 2)) for share in (0.5, 1)]
        root = mpmath.findroot(lambda x: mpmath.legendre(count, x), bracket, solver="anderson")
        slope = count * (root * mpmath.legendre(count, root) - mpmath.legendre(count - 1, root)) / (root**2 - 1)
        positions.append((1 + root) / 2)
        weights.append(1 / ((1 - root**2) * slope**2))
    return positions, weights


def constant(name, count, values, comment):
    lines = [f"/// {comment}", "template <typename T>", f"inline constexpr T gauss_{count}_{name}[{count}] = {{"]
    literals = [f"T({mpmath.nstr(v, 33, min_fixed=-10)}L)" for v in values]
    lines += ["    " + ", ".join(literals[i:i + 2]) + ("," if i + 2 < count else "};") for i in range(0, count, 2)]
    return "\n".join(lines)


for count in COUNTS:
    positions, weights = rule(count)
    print(constant("positions", count, positions, f"Where the rule of {count} points takes its samples on [0, 1] [1]."))
    print()
    print(constant("weights", count, weights, "What each of those samples counts [1]; the sum is 1."))
    print()
