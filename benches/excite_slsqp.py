#!/usr/bin/env python3
"""What one reaches today: SLSQP, finite differences, Pinocchio's regressor. And `denavit excite` on the same problem.

The problem: kuka-lwr4, 10 s, clamped quintic spline with a way point every second (77 variables: 11 per joint), 1,001 samples, the 43
inertial base columns unscaled, limits of position, velocity and acceleration only (full speed in half a second where the file has no
acceleration limit). SLSQP holds them at 51 times, two-sided: 2,142 constraints; `denavit` between the samples too.

    pip install numpy scipy pin
    cargo build --release
    OMP_NUM_THREADS=1 python benches/excite_slsqp.py [cond|logdet] [iterations, 0: only ours] [seeds, 5]
"""

import json
import math
import os
import re
import resource
import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np
import pinocchio as pin
from scipy.interpolate import BSpline
from scipy.optimize import minimize

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
DENAVIT = os.path.join(ROOT, "target", "release", "denavit")
ROBOT = os.path.join(ROOT, "robots", "kuka-lwr4.yaml")
CRITERION = sys.argv[1] if len(sys.argv) > 1 else "cond"
ITERATIONS = int(sys.argv[2]) if len(sys.argv) > 2 else 60
SEEDS = range(1, 1 + (int(sys.argv[3]) if len(sys.argv) > 3 else 5))

L1, L2, L3 = 0.3105, 0.40, 0.39
ROWS = [(0, L1), (1, 0), (-1, L2), (-1, 0), (1, L3), (1, 0), (-1, 0)]  # alpha in quarter turns, r
POSITION = np.radians([170, 120, 170, 120, 170, 120, 170])
VELOCITY = np.radians([110, 110, 128, 128, 204, 184, 184])
ACCELERATION = VELOCITY / 0.5


def arm():
    model, parent = pin.Model(), 0
    for k, (quarter, r) in enumerate(ROWS):
        turn = pin.utils.rotate("x", quarter * math.pi / 2)
        place = pin.SE3(turn, turn @ np.array([0, 0, r]))
        parent = model.addJoint(parent, pin.JointModelRZ(), place, f"A{k + 1}")
    return model


def leaders():
    """The base parameters' own columns, in Pinocchio's order of a body's ten."""
    text = subprocess.run([DENAVIT, "check", ROBOT, "--json", "-"], capture_output=True, text=True, check=True).stdout
    order = ["M", "MSX", "MSY", "MSZ", "XX", "XY", "YY", "XZ", "YZ", "ZZ"]
    columns = []
    for parameter in json.loads(text)["base_parameters"]:
        kind, link = re.fullmatch(r"([A-Z]+)(\d)R?", parameter["name"]).groups()
        if kind in order:
            columns.append(10 * (int(link) - 1) + order.index(kind))
    return columns


MODEL = arm()
DATA = MODEL.createData()
COLUMNS = leaders()
KNOTS = np.r_[[0.0] * 5, np.arange(11.0), [10.0] * 5]


def basis(times, order):
    full = np.stack([BSpline(KNOTS, np.eye(15)[k], 5).derivative(order)(times) if order else BSpline(KNOTS, np.eye(15)[k], 5)(times) for k in range(15)], 1)
    return np.c_[full[:, :3].sum(1), full[:, 3:12], full[:, 12:].sum(1)]


SAMPLES = [basis(np.linspace(0, 10, 1001), order) for order in range(3)]
GUARD = [basis(np.linspace(0, 10, 51), order) for order in range(3)]


def value(x):
    q, dq, ddq = (b @ x.reshape(7, 11).T for b in SAMPLES)
    w = np.concatenate([pin.computeJointTorqueRegressor(MODEL, DATA, q[k], dq[k], ddq[k])[:, COLUMNS] for k in range(1001)])
    if CRITERION == "cond":
        return np.linalg.cond(w)
    return -np.linalg.slogdet(w.T @ w)[1]


def bounds():
    rows = []
    for b, limit in zip(GUARD, [POSITION, VELOCITY, ACCELERATION]):
        rows += [sign * np.kron(np.eye(7)[j], row) / limit[j] for j in range(7) for row in b for sign in (1, -1)]
    return np.array(rows)


def slsqp(seed):
    """From one random start: value, seconds, seconds of processor."""
    a = bounds()
    x = np.random.default_rng(seed).uniform(-1, 1, 77)
    x *= 0.8 / np.abs(a @ x).max()
    begun, cpu = time.time(), time.process_time()
    done = minimize(value, x, method="SLSQP", constraints={"type": "ineq", "fun": lambda x: 1 - a @ x, "jac": lambda x: -a}, options={"maxiter": ITERATIONS})
    wall, cpu = time.time() - begun, time.process_time() - cpu
    worst = max(np.abs(b @ done.x.reshape(7, 11).T / limit).max() for b, limit in zip(SAMPLES, [POSITION, VELOCITY, ACCELERATION]))
    print(f"SLSQP, seed {seed}: {CRITERION} {value(x):.1f} to {done.fun:.3f}, {done.nit} iterations, {done.nfev} values, {wall:.1f} s, {cpu:.1f} s of processor; {100 * worst:.1f} % of a limit at 1,001 samples; {done.message}", flush=True)
    return done.fun, wall, cpu


def excite(path, seed, *options):
    """Value, seconds of the search on one core or more as the command says them, seconds of processor of the whole program."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    command = [DENAVIT, "excite", path, "--links-only", "--criterion", CRITERION, "--seed", str(seed), "--json", "-", *map(str, options)]
    found = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
    assert found["feasible"]
    return found["value"], found["seconds"], resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def denavit(seeds, target):
    """The same limits, without ground, spheres and torques; ever more starts and steps. Processor time of the search: of the program, less what it
    takes to read the robot, build its tapes and make one step."""
    text = open(ROBOT).read()
    text = re.sub(r"\ncollision:.*", "\n", text, flags=re.S)
    text = re.sub(r"\nlinks:\n(  .*\n)*", "\n", text)
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "bare.yaml")
        open(path, "w").write(text)
        idle = statistics.median(excite(path, s, "--starts", 1, "--iterations", 1)[2] for s in seeds)
        for starts, steps in [(1, 20), (1, 30), (1, 40), (1, 60), (1, 90), (4, 30), (6, 30), (16, 90)]:
            runs = [excite(path, s, "--starts", starts, "--iterations", steps) for s in seeds]
            value, wall, cpu = (statistics.median(r[k] for r in runs) for k in range(3))
            less = "" if target is None or value >= target else ", less than SLSQP's median"
            each = " ".join(f"{r[0]:.2f}" for r in runs)
            print(f"denavit --starts {starts} --iterations {steps}: {CRITERION} {each}, median {value:.3f}{less}; {wall:.2f} s, {cpu - idle:.2f} s of processor", flush=True)


if __name__ == "__main__":
    target = None
    if ITERATIONS > 0:
        print(f"SLSQP: 77 variables, {len(bounds())} constraints, {len(COLUMNS)} columns")
        target, wall, cpu = (statistics.median(r) for r in zip(*(slsqp(seed) for seed in SEEDS)))
        print(f"SLSQP: median {target:.3f}, {wall:.1f} s, {cpu:.1f} s of processor")
    denavit(SEEDS, target)
