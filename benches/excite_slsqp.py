#!/usr/bin/env python3
"""What one reaches today: SLSQP, finite differences, Pinocchio's regressor. And `denavit excite` on the same problem.

The problem: kuka-lwr4, 10 s, clamped quintic spline with a way point every second (77 variables: 11 per joint), 1,001 samples, the 43
inertial base columns unscaled, limits of position, velocity and acceleration only (full speed in half a second where the file has no
acceleration limit). SLSQP holds them at 51 times, two-sided: 2,142 constraints; `denavit` between the samples too.

    pip install numpy scipy pin
    cargo build --release
    python benches/excite_slsqp.py [cond|logdet] [iterations, 0: only ours] [seed]
"""

import json
import math
import os
import re
import resource
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
SEED = int(sys.argv[3]) if len(sys.argv) > 3 else 1

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


def slsqp():
    a = bounds()
    x = np.random.default_rng(SEED).uniform(-1, 1, 77)
    x *= 0.8 / np.abs(a @ x).max()
    calls = [0]

    def f(x):
        calls[0] += 1
        return value(x)

    print(f"SLSQP: {len(x)} variables, {len(a)} constraints, {len(COLUMNS)} columns, starts at {value(x):.2f}", flush=True)
    begun, cpu = time.time(), time.process_time()
    done = minimize(f, x, method="SLSQP", constraints={"type": "ineq", "fun": lambda x: 1 - a @ x, "jac": lambda x: -a}, options={"maxiter": ITERATIONS})
    print(f"SLSQP: {CRITERION} {done.fun:.3f} after {done.nit} iterations, {calls[0]} values, {time.time() - begun:.1f} s, {time.process_time() - cpu:.1f} s of processor; {done.message}", flush=True)
    worst = max(np.abs(b @ done.x.reshape(7, 11).T / limit).max() for b, limit in zip(SAMPLES, [POSITION, VELOCITY, ACCELERATION]))
    print(f"SLSQP: at 1,001 samples, {100 * worst:.1f} % of a limit is used", flush=True)
    return done.fun


def denavit(target):
    """The same limits, without ground, spheres and torques; ever more starts and steps. Time: the search, on all cores, as `denavit` says
    it; processor time: of the whole program, with the robot's generation."""
    text = open(ROBOT).read()
    text = re.sub(r"\ncollision:.*", "\n", text, flags=re.S)
    text = re.sub(r"\nlinks:\n(  .*\n)*", "\n", text)
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "bare.yaml")
        open(path, "w").write(text)
        for starts, steps in [(1, 15), (1, 30), (1, 60), (2, 30), (4, 30), (6, 30), (16, 90)]:
            before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
            out = subprocess.run([DENAVIT, "excite", path, "--links-only", "--criterion", CRITERION, "--starts", str(starts), "--seed", str(SEED), "--iterations", str(steps), "--json", "-"], capture_output=True, text=True, check=True).stdout
            cpu = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
            found = json.loads(out)
            print(f"denavit: {CRITERION} {found['value']:.3f} with --starts {starts} --iterations {steps}, {found['seconds']:.2f} s, {cpu:.2f} s of processor, limits kept between samples: {found['feasible']}", flush=True)
            if target is not None and found["value"] < target:
                print(f"denavit reaches SLSQP's value in {found['seconds']:.2f} s")
                target = None


if __name__ == "__main__":
    denavit(None if ITERATIONS == 0 else slsqp())
