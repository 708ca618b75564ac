"""Reference values for sos.rs, by SciPy 1.17: python3 sos_reference.py > sos_reference.in"""
import numpy as np
from scipy.signal import butter, sosfiltfilt

k = np.arange(60)
x = np.sin(0.3 * k) + 0.2 * np.cos(1.7 * k) + 0.01 * k + 0.5
print("[")
for order, cutoff in [(1, 10.0), (2, 5.0), (4, 10.0), (5, 10.0), (5, 2.0), (8, 20.0)]:
    y = sosfiltfilt(butter(order, cutoff, fs=100.0, output="sos"), x)
    values = ", ".join(f"({i}, {y[i]!r})".replace("np.float64(", "").replace("))", ")") for i in (0, 1, 7, 30, 58, 59))
    print(f"    ({order}, {cutoff!r}, [{values}]),")
print("]")
