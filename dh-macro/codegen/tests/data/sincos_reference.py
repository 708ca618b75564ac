"""Sines and cosines to 40 digits as a nearest double and the rest: writes sincos_reference.csv. Needs mpmath."""
import random, struct
from mpmath import mp, mpf, sin, cos
mp.prec = 1400
random.seed(7)
xs = [0.0, 5e-324, 1e-310, 1e-20, 1e-8, 0.5, 1.0, 3.0, 1e22, 1e300, 1.7976931348623157e308, 6381956970095103.0 * 2.0**797]
xs += [k * 1.5707963267948966 for k in range(-12, 13)] + [k * 0.7853981633974483 for k in range(-9, 10)]
xs += [1.5707963267948966 * k for k in (1e3, 12345, 318309, 318310, 1e6, 1e9)] + [499999.9, 500000.0, 500000.1]
xs += [random.uniform(-7, 7) for _ in range(300)] + [random.uniform(-5e5, 5e5) for _ in range(200)]
xs += [random.choice((-1, 1)) * 2.0 ** random.uniform(19, 1023) for _ in range(200)]
with open("sincos_reference.csv", "w") as f:
    f.write("x_bits,sin,sin_rest,cos,cos_rest\n")
    for x in xs:
        row = ["%016x" % struct.unpack("<Q", struct.pack("<d", x))[0]]
        for v in (sin(mpf(x)), cos(mpf(x))):
            row += [repr(float(v)), repr(float(v - mpf(float(v))))]
        f.write(",".join(row) + "\n")
