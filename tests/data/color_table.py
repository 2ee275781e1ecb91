"""sRGB both ways and luminance, from the numbers of IEC 61966-2-1 and BT.709."""

from mpmath import mpf, power

from reference import Sampler, f32, write_table

sampler = Sampler(6)
rows = []


def encode(x):
    return mpf("12.92") * x if x <= mpf("0.0031308") else mpf("1.055") * power(x, 1 / mpf("2.4")) - mpf("0.055")


def decode(x):
    return x / mpf("12.92") if x <= mpf("0.04045") else power((x + mpf("0.055")) / mpf("1.055"), mpf("2.4"))


def luminance(r, g, b):
    return mpf("0.2126") * r + mpf("0.7152") * g + mpf("0.0722") * b


for x in [0.0, f32(0.003), f32(0.0031), f32(0.0032), f32(0.18), 0.5, 1.0] + [sampler.uniform(0, 1) for _ in range(40)]:
    rows.append(["srgb_from_linear", x, 0.0, 0.0, encode(mpf(x))])
for x in [0.0, f32(0.04), f32(0.041), 0.5, 1.0] + [sampler.uniform(0, 1) for _ in range(40)]:
    rows.append(["linear_from_srgb", x, 0.0, 0.0, decode(mpf(x))])
for _ in range(30):
    c = [sampler.log_uniform(1e-4, 1e4) for _ in range(3)]
    rows.append(["luminance", *c, luminance(*[mpf(x) for x in c])])

write_table("color", "a, b, c = one channel, or red, green, blue [1]", ["function", "a", "b", "c", "expected"], rows)
