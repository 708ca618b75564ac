#!/usr/bin/env python3
"""Rigid-body dynamics of serial arms from robot files, in world axes, many samples at once (numpy only).

`simulate.py --check` prints power balance and symmetry of the mass matrix; exit status 1 if one is off.
"""
import argparse
import copy
import json
import pathlib
import re
import sys

import numpy as np

ROBOTS = pathlib.Path(__file__).resolve().parents[2] / "robots"


# ---- robot files -------------------------------------------------------------------------------------------------

def parse_flow(text):
    """Value of one flow expression, { a: b }, [a, b] or a scalar; scalars stay strings."""
    quoted = re.sub(r"[^{}\[\],:\s][^{}\[\],:]*", lambda scalar: json.dumps(scalar[0].strip()), text)
    return json.loads(quoted.replace('"null"', "null"))


def logical_lines(text):
    """[indent, text] of each line without comments; a flow value over several lines is one line."""
    out, depth = [], 0
    for raw in text.splitlines():
        line = re.sub(r"(^|\s)#.*", "", raw).rstrip()
        if line.strip() and depth > 0:
            out[-1][1] += " " + line.strip()
        elif line.strip():
            out.append([len(line) - len(line.lstrip()), line.strip()])
        depth += sum(line.count(c) for c in "{[") - sum(line.count(c) for c in "}]")
    return out


def parse_block(lines):
    """Block mapping or sequence; items of sequences are flow values, as in the robot files."""
    if lines[0][1].startswith("- "):
        return [parse_flow(text[2:]) for _, text in lines]
    out, indent = {}, lines[0][0]
    heads = [i for i, (depth, text) in enumerate(lines) if depth == indent and not text.startswith("- ")] + [len(lines)]
    for head, following in zip(heads, heads[1:]):
        key, _, value = lines[head][1].partition(":")
        value = value.strip()
        out[key] = parse_block(lines[head + 1:following]) if not value else \
            parse_flow(value) if value[0] in "{[" else value
    return out


def write_yaml(data):
    """Text of a robot file: a key a line. JSON of strings without its quotes is YAML's flow style."""
    return "".join(f"{key}: {value if isinstance(value, str) else json.dumps(value)}\n"
                   for key, value in data.items()).replace('"', "").replace("}, {", "},\n  {")


def evaluate(text, names):
    names = {"nan": np.nan, **names}
    return float(eval(re.sub(r"deg\b", "*pi/180", text), {"__builtins__": {}}, names))  # files of this repository


# ---- dynamics ----------------------------------------------------------------------------------------------------

def turn_x(angle):
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[1, 0, 0], [0, c, -s], [0, s, c]])


def turn_z(angle):
    out = np.zeros((len(angle), 3, 3))
    out[:, 0, 0] = out[:, 1, 1] = np.cos(angle)
    out[:, 1, 0] = np.sin(angle)
    out[:, 0, 1] = -out[:, 1, 0]
    out[:, 2, 2] = 1
    return out


def cross(a, b):
    return np.stack([a[..., 1] * b[..., 2] - a[..., 2] * b[..., 1], a[..., 2] * b[..., 0] - a[..., 0] * b[..., 2],
                     a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]], axis=-1)


def tensor(entries):
    xx, yy, zz, xy, xz, yz = entries
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


class Arm:
    """Table, links, drives and limits of a robot file as arrays; angles in rad, SI units."""

    def __init__(self, path):
        self.data, names = parse_block(logical_lines(pathlib.Path(path).read_text())), {"pi": np.pi}

        def number(value):
            return [number(entry) for entry in value] if isinstance(value, list) else evaluate(value, names)
        for key, text in self.data.get("constants", {}).items():
            names[key] = number(text)
        rows, links, missing = self.data["joints"], self.data["links"], "nan"
        self.name, self.n, self.standard = self.data["name"], len(rows), self.data["convention"] == "standard"
        self.sliding = np.array([row["type"] == "prismatic" for row in rows])
        self.table = np.array([number([row.get(key, "0") for key in ("alpha", "d", "theta", "r")]) for row in rows])
        self.gravity = np.array(number(self.data["gravity"]))
        self.M, self.MS = (np.array([number(link[key]) for link in links]) for key in ("M", "MS"))
        self.I = np.array([tensor(number(link["I"])) for link in links])
        drives = [{**row.get("drive", {}), **row.get("drive", {}).get("friction", {})} for row in rows]
        self.rotor, self.viscous, self.coulomb = (np.array([number(drive.get(key, "0")) for drive in drives]) for key in
                                                  ("rotor_inertia", "viscous_friction", "coulomb_friction"))
        self.limits = np.array([number(row.get("position", [missing, missing])) for row in rows])
        self.speed, self.acceleration, self.torque = (np.array([number(row.get(key, missing)) for row in rows])
                                                      for key in ("velocity", "acceleration", "torque"))

    def changed(self, **fields):
        out = copy.copy(self)
        out.__dict__.update(fields)
        return out

    def frames(self, q):
        """Per joint: rotation and origin of its frame, direction of its axis and a point on the axis, in world axes."""
        samples = len(q)
        R, p, out = np.broadcast_to(np.eye(3), (samples, 3, 3)), np.zeros((samples, 3)), []
        for j, (alpha, d, theta, r) in enumerate(self.table):
            angle = np.full(samples, theta) + (0 if self.sliding[j] else q[:, j])
            reach = np.full(samples, r) + (q[:, j] if self.sliding[j] else 0)
            if self.standard:
                axis, point = R[:, :, 2], p
                R = R @ turn_z(angle)
                p = p + axis * reach[:, None] + R[:, :, 0] * d
                R = R @ turn_x(alpha)
            else:
                p = p + R[:, :, 0] * d
                R = R @ turn_x(alpha)
                axis = R[:, :, 2]
                p = p + axis * reach[:, None]
                R, point = R @ turn_z(angle), p
            out.append((R, p, axis, point))
        return out

    def inverse_dynamics(self, q, dq, ddq, rotors=True):
        """Torques of the actuators without friction, (samples, n): Newton-Euler with every vector in world axes."""
        frames, samples = self.frames(q), len(q)
        w, dw, origin = np.zeros((samples, 3)), np.zeros((samples, 3)), np.zeros((samples, 3))
        a, loads = np.broadcast_to(-self.gravity, (samples, 3)), []
        for j, (R, p, axis, point) in enumerate(frames):
            rate, gain = axis * dq[:, j, None], axis * ddq[:, j, None]
            if self.sliding[j]:
                arm = p - origin
                a = a + cross(dw, arm) + cross(w, cross(w, arm)) + gain + 2 * cross(w, rate)
            else:
                arm = point - origin
                a = a + cross(dw, arm) + cross(w, cross(w, arm))
                dw, w, arm = dw + gain + cross(w, rate), w + rate, p - point
                if self.standard:
                    a = a + cross(dw, arm) + cross(w, cross(w, arm))
            first = R @ self.MS[j]
            inertia = R @ self.I[j] @ R.transpose(0, 2, 1)
            spin = (inertia @ w[:, :, None])[:, :, 0]
            loads.append((self.M[j] * a + cross(dw, first) + cross(w, cross(w, first)),
                          (inertia @ dw[:, :, None])[:, :, 0] + cross(w, spin) + cross(first, a)))
            origin = p
        tau, force, moment, tip = np.zeros((samples, self.n)), 0.0, 0.0, origin
        for j in reversed(range(self.n)):
            _, p, axis, point = frames[j]
            if j < self.n - 1:
                moment = moment + cross(tip - p, force)
            force, moment, tip = force + loads[j][0], moment + loads[j][1], p
            across = force if self.sliding[j] else moment + cross(p - point, force)
            tau[:, j] = np.sum(axis * across, axis=1)
        return tau + (self.rotor * ddq if rotors else 0)

    def mass_matrix(self, q, rotors=True):
        """(samples, n, n), column by column: torques of a unit acceleration without gravity and speed."""
        free, still = self.changed(gravity=np.zeros(3)), np.zeros_like(q)
        columns = [free.inverse_dynamics(q, still, still + np.eye(self.n)[j], rotors) for j in range(self.n)]
        return np.stack(columns, axis=2)

    def forward_dynamics(self, q, dq, tau):
        rest = self.inverse_dynamics(q, dq, np.zeros_like(q))
        return np.linalg.solve(self.mass_matrix(q), (tau - rest)[:, :, None])[:, :, 0]

    def energy(self, q, dq):
        """Kinetic plus potential energy from the links' own speeds, not from the mass matrix."""
        w, v, origin = np.zeros((len(q), 3)), np.zeros((len(q), 3)), np.zeros((len(q), 3))
        total = 0.5 * np.sum(self.rotor * dq**2, axis=1)
        for j, (R, p, axis, point) in enumerate(self.frames(q)):
            rate = axis * dq[:, j, None]
            v = v + (cross(w, p - origin) + rate if self.sliding[j] else cross(w, p - origin) + cross(rate, p - point))
            w, origin, first = w if self.sliding[j] else w + rate, p, R @ self.MS[j]
            own = np.einsum("ski,sk->si", R, w)
            total = total + 0.5 * self.M[j] * np.sum(v * v, axis=1) + np.sum(v * cross(w, first), axis=1)
            total = total + 0.5 * np.sum(own * (own @ self.I[j]), axis=1) - (self.M[j] * p + first) @ self.gravity
        return total

    def tip_jacobian(self, q):
        """Origin of the last frame, (samples, 3), and its Jacobian, (samples, 3, n)."""
        frames = self.frames(q)
        tip = frames[-1][1]
        columns = [axis if self.sliding[j] else cross(axis, tip - point)
                   for j, (_, _, axis, point) in enumerate(frames)]
        return tip, np.stack(columns, axis=2)


# ---- check -------------------------------------------------------------------------------------------------------

def check():
    """Power balance along a motion, symmetry and least eigenvalue of M, forward against inverse dynamics."""
    wrong, rng = False, np.random.default_rng(1)
    print(f"{'arm':16} {'power':>9} {'symmetry':>9} {'min eig M':>10} {'forward':>9}")
    for path in sorted(ROBOTS.glob("*.yaml")):
        if "links" not in parse_block(logical_lines(path.read_text())):
            continue
        arm = Arm(path)
        t = np.linspace(0, 1, 50)[:, None]
        size, rate, phase = 0.4 + rng.random(arm.n), 1 + 2 * rng.random(arm.n), 6 * rng.random(arm.n)
        motion = [lambda t: size * np.sin(rate * t + phase), lambda t: size * rate * np.cos(rate * t + phase),
                  lambda t: -size * rate**2 * np.sin(rate * t + phase)]
        q, dq, ddq = (f(t) for f in motion)
        tau, h = arm.inverse_dynamics(q, dq, ddq), 1e-3
        energy = [arm.energy(motion[0](t + k * h), motion[1](t + k * h)) for k in (-2, -1, 1, 2)]
        slope = (energy[0] - 8 * energy[1] + 8 * energy[2] - energy[3]) / (12 * h)
        power = np.abs(slope - np.sum(tau * dq, axis=1)).max() / np.abs(slope).max()
        mass = arm.mass_matrix(q)
        symmetry = np.abs(mass - mass.transpose(0, 2, 1)).max() / np.abs(mass).max()
        least = np.linalg.eigvalsh(mass).min()
        forward = np.abs(arm.forward_dynamics(q, dq, tau) - ddq).max() / np.abs(ddq).max()
        good = power < 1e-8 and symmetry < 1e-12 and least > 0 and forward < 1e-6
        wrong |= not good
        print(f"{arm.name:16} {power:9.1e} {symmetry:9.1e} {least:10.2e} {forward:9.1e}{'' if good else '  OFF'}")
    return 1 if wrong else 0


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--check", action="store_true")
    if parser.parse_args().check:
        sys.exit(check())
    parser.print_help()
