#!/usr/bin/env python3
"""Adds a known cause to the torques of real recordings: DIR/NN/{fit,validate}.csv, DIR/base/ARM/ and DIR/truth.json."""
import argparse
import json
import pathlib
import re
import subprocess
from dataclasses import dataclass, field
from typing import Callable

import numpy as np
import scipy.signal
import yaml

ROOT = pathlib.Path(__file__).resolve().parents[2]
WINDOW = 0.01      # s over which residuals are averaged
STANDS = 5e-5      # rad of travel back before friction turns about
END = float("inf")


# ---- recordings --------------------------------------------------------------------------------------------------

@dataclass
class Source:
    """Logs of an arm as (file, from, to), in parts of its rows."""
    folder: str
    robot: str
    fit: list
    validate: list
    band: float                                          # Hz of the motion
    top: float = END                                     # Hz up to which torques were recorded
    torque: str = "tau"
    late: float = 0.0                                    # s by which torques lag the motion
    known: dict = field(default_factory=dict)            # effects that the robot file lacks: joint -> effect


WRIST = {"joint": 5, "KC": 1, "IAM": 0.0077, "FVM": 0.616, "FCM": 1.956}   # the recording's README
ARMS = {
    "franka-panda": Source("franka-panda", "franka-panda", [("exciting", 0, 1)], [], 2.5),
    "staubli-tx40": Source("staubli-tx40", "staubli-tx40", [("exciting_train", 0, 0.75)], [("exciting_train", 0.75, 1)],
                           40, known={6: {"gear_coupling": WRIST}}),
    "kinova-gen3": Source("kinova-gen3", "kinova-gen3", [("optitraj1", 0, 1)], [], 8),
    "kinova-gen3-motor": Source("kinova-gen3", "kinova-gen3", [("optitraj1", 0, 1)],
                                [("sync7_slow_cold_currentonly", 0, 1)], 8, torque="taum"),
    # Filtered before it was published, by 2 Hz; the last half second is spoilt.
    "kuka-lwr4plus": Source("kuka-lwr4plus", "kuka-lwr4", [("traj1", 0, 0.6)], [("traj1", 0.6, 0.98)], 3, top=2),
    "kuka-iiwa14": Source("kuka-iiwa14", "kuka-iiwa14", [("motion_j2toj7", 0, 0.35)], [("motion_j2toj7", 0.5, 0.7)], 8,
                          late=0.025),
}
DECK = [*ARMS, "franka-panda", "staubli-tx40"]   # the short ones twice


def low_pass(x, hertz, step):
    if len(x) < 30 or hertz * step > 0.4:
        return x
    # What is put before the first and behind the last sample lasts two periods of the band, so that ends stay quiet.
    ends = min(len(x) - 1, round(2 / (hertz * step)))
    return scipy.signal.sosfiltfilt(scipy.signal.butter(3, 2 * hertz * step, output="sos"), x, axis=0, padlen=ends)


class Log:
    """One file: raw columns, torques, low-passed motion. Nothing is filtered across a change of `seg`."""

    def __init__(self, path, begin, end, source):
        with open(path) as file:
            names = file.readline().strip().split(",")
        rows = np.loadtxt(path, delimiter=",", skiprows=1)
        rows = rows[round(begin * len(rows)):round(end * len(rows))]
        column = {name: rows[:, i] for i, name in enumerate(names)}
        n = sum(bool(re.fullmatch(r"q\d+", name)) for name in names)

        def joints(key):
            return np.stack([column[f"{key}{j + 1}"] for j in range(n)], axis=1)
        self.source, self.t, self.tau, self.raw = source, column["t"], joints(source.torque), joints("q")
        seg = column.get("seg", np.zeros(len(rows)))
        self.seg = np.cumsum(np.diff(seg, prepend=seg[0]) != 0)
        self.parts = [np.flatnonzero(self.seg == k) for k in range(self.seg[-1] + 1)]
        self.step = np.median([(self.t[p[-1]] - self.t[p[0]]) / (len(p) - 1) for p in self.parts])
        self.q = self.each(lambda x: low_pass(x, source.band, self.step), self.raw)
        self.dq = self.each(lambda x: np.gradient(x, self.step, axis=0), self.q)
        self.ddq = self.each(lambda x: np.gradient(x, self.step, axis=0), self.dq)
        self.sign = np.stack([self.each(direction, x) for x in self.q.T], axis=1)

    def each(self, change, x):
        """The change, made to every recording of the log by itself."""
        return np.concatenate([change(x[part]) for part in self.parts])

    def shifted(self, x, seconds):
        return self.each(lambda part: np.stack([np.interp(np.arange(len(y)) - seconds / self.step, np.arange(len(y)), y)
                                                for y in part.T], axis=1), x)

    def recorded(self, torque):
        """What the arm's recorder would have made of a torque at the joints."""
        late = self.shifted(torque, self.source.late) if self.source.late else torque
        return self.each(lambda x: low_pass(x, self.source.top, self.step), late)

    def windows(self, x):
        """Means over windows."""
        size = max(1, round(WINDOW / self.step))
        return x[:len(x) // size * size].reshape(-1, size, *x.shape[1:]).mean(axis=1)

    def write(self, path, tau):
        n = tau.shape[1]
        names = ["t", "seg", *(f"q{j + 1}" for j in range(n)), *(f"tau{j + 1}" for j in range(n))]
        np.savetxt(path, np.column_stack([self.t, self.seg, self.raw, tau]), delimiter=",", header=",".join(names),
                   comments="", fmt=["%.5f", "%d"] + ["%.8g"] * 2 * n)


def direction(q):
    """Sign of the last motion, kept while the joint stands."""
    out, way, turn = np.zeros(len(q)), np.sign(q[-1] - q[0]) or 1.0, q[0]
    for i, x in enumerate(q):
        if (x - turn) * way > 0:
            turn = x
        elif (turn - x) * way > STANDS:
            way, turn = -way, x
        out[i] = way
    return out


# ---- dynamics ----------------------------------------------------------------------------------------------------

def number(value, names):
    if isinstance(value, list):
        return [number(entry, names) for entry in value]
    return float(eval(re.sub(r"deg\b", "*pi/180", str(value)), {"__builtins__": {}}, names))   # files of this project


def turn(axis, angle):
    c, s, out = np.cos(angle), np.sin(angle), np.zeros((*np.shape(angle), 3, 3))
    i, k = (axis + 1) % 3, (axis + 2) % 3
    out[..., axis, axis], out[..., i, i], out[..., k, k], out[..., i, k], out[..., k, i] = 1, c, c, -s, s
    return out


class Arm:
    """A robot file of turning joints: table, bodies, plain drives."""

    def __init__(self, path):
        data, names = yaml.safe_load(pathlib.Path(path).read_text()), {"pi": np.pi}
        for key, value in data.get("constants", {}).items():
            names[key] = number(value, names)
        rows, self.standard = data["joints"], data["convention"] == "standard"
        self.n = len(rows)
        self.table = [number([row.get(key, 0) for key in ("alpha", "d", "theta", "r")], names) for row in rows]
        self.gravity = np.array(number(data["gravity"], names))
        bodies = [(link["M"], link["MS"], link["I"]) for link in data["links"]]
        self.bodies = [(number(M, names), np.array(number(MS, names)), tensor(number(I, names))) for M, MS, I in bodies]
        drives = [{**row["drive"], **row["drive"]["friction"]} for row in rows]
        self.rotor, self.viscous, self.coulomb, self.offset = (
            np.array([number(drive.get(key, 0), names) for drive in drives])
            for key in ("rotor_inertia", "viscous_friction", "coulomb_friction", "offset"))
        self.shared = {m: drive["gear_coupling"] for m, drive in enumerate(drives) if "gear_coupling" in drive}

    def frames(self, q):
        """Per joint: rotation and origin of its frame, its axis, a point on the axis; in base axes."""
        R, p, out = np.broadcast_to(np.eye(3), (len(q), 3, 3)), np.zeros((len(q), 3)), []
        for (alpha, d, theta, r), angle in zip(self.table, q.T):
            axis, point = R[..., 2], p
            if self.standard:
                R = R @ turn(2, angle + theta)
                p = p + axis * r + R[..., 0] * d
                R = R @ turn(0, alpha)
            else:
                p = p + R[..., 0] * d
                R = R @ turn(0, alpha) @ turn(2, angle + theta)
                axis, p = R[..., 2], p + R[..., 2] * r
                point = p
            out.append((R, p, axis, point))
        return out

    def newton_euler(self, q, dq, ddq, bodies=None):
        """Torques of the bodies: velocities outward from the base, forces about the frames' origins inward."""
        frames, w, dw = self.frames(q), np.zeros((len(q), 3)), np.zeros((len(q), 3))
        a, before, loads = np.broadcast_to(-self.gravity, (len(q), 3)), np.zeros((len(q), 3)), []
        for j, ((R, p, axis, _), (M, MS, I)) in enumerate(zip(frames, bodies or self.bodies)):
            on, rate, reach = axis * dq[:, j, None], axis * ddq[:, j, None], p - before
            turned = dw + rate + np.cross(w, on), w + on
            # The origin of a modified frame lies on the joint's axis; that of a standard frame turns with the link.
            dv, v = turned if self.standard else (dw, w)
            a = a + np.cross(dv, reach) + np.cross(v, np.cross(v, reach))
            (dw, w), before, ms = turned, p, R @ MS
            tensor_w, tensor_dw = (np.einsum("nij,jk,nlk,nl->ni", R, I, R, x, optimize=True) for x in (w, dw))
            loads.append((M * a + np.cross(dw, ms) + np.cross(w, np.cross(w, ms)),
                          tensor_dw + np.cross(w, tensor_w) + np.cross(ms, a), p))
        tau, force, moment = np.zeros_like(q), np.zeros_like(a), np.zeros_like(a)   # the moment is about the base
        for j in reversed(range(self.n)):
            f, m, p = loads[j]
            force, moment = force + f, moment + m + np.cross(p, f)
            _, _, axis, point = frames[j]
            tau[:, j] = np.sum(axis * (moment - np.cross(point, force)), axis=1)
        return tau

    def torque(self, log):
        """Torques of the file along a log, as they would be recorded."""
        drive = self.rotor * log.ddq + self.viscous * log.dq + self.coulomb * log.sign + self.offset
        for m, shared in self.shared.items():
            sizes = (shared[key] for key in ("KC", "IAM", "FVM", "FCM"))
            drive = drive + coupled(log, m, shared["joint"] - 1, *map(float, sizes))
        return self.newton_euler(log.q, log.dq, log.ddq) + drive


def tensor(entries):
    xx, yy, zz, xy, xz, yz = entries
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def coupled(log, m, k, ratio, inertia, viscous, coulomb):
    """Motor m turns with dq_m + ratio dq_k: what that adds to the torques of both joints."""
    out, way = np.zeros_like(log.q), log.each(direction, log.q[:, m] + ratio * log.q[:, k])
    for own, other in ((m, k), (k, m)):
        out[:, own] = ratio * (inertia * log.ddq[:, other] + viscous * log.dq[:, other])
    out[:, m] += coulomb * way
    out[:, k] += ratio * coulomb * way
    return out


# ---- causes ------------------------------------------------------------------------------------------------------

@dataclass
class Cause:
    """`torque(log, scale)`: added to all joints. `plain`: which of offset, Coulomb, viscous level it is itself."""
    joints: list                  # from 0; empty: the robot
    form: str
    torque: Callable
    most: float = END             # scale beyond which no arm has it
    keys: dict = field(default_factory=dict)   # parameter of an answer -> value by scale (with the file's level)
    plain: tuple = ()
    at_sensor: bool = False       # acts on the recorded torque


@dataclass
class Bench:
    """An arm with its logs."""
    name: str
    arm: Arm
    fit: list
    validate: list

    def __post_init__(self):
        self.logs = self.fit + self.validate
        self.rest = [log.windows(log.tau - log.recorded(self.arm.torque(log))) for log in self.fit]
        self.rms = np.sqrt(np.mean(np.concatenate(self.rest)**2, axis=0))
        self.low, self.high = (f([f(log.q, axis=0) for log in self.fit], axis=0) for f in (np.min, np.max))
        self.span, self.speed = self.high - self.low, np.max([np.abs(log.dq).max(axis=0) for log in self.fit], axis=0)

    def moving(self):
        return np.flatnonzero((self.span > 0.15) & (self.speed > 0.1))


def one(log, j, values):
    out = np.zeros_like(log.q)
    out[:, j] = values
    return out


def at(j, form, shape, **more):
    """Cause at one joint, in proportion to its scale."""
    return Cause([j], form, lambda log, s: s * one(log, j, shape(log)), **more)


def level(rng, file, j, name, shape, plain):
    way = -1 if file[j] > 0 and rng.random() < 0.3 else 1
    return at(j, "higher level" if way > 0 else "lower level", lambda log: way * shape(log), plain=(plain,),
              most=END if way > 0 else file[j], keys={f"{name}{j + 1}": lambda s: file[j] + way * s})


def coulomb_friction(rng, b, j):
    return level(rng, b.arm.coulomb, j, "FC", lambda log: log.sign[:, j], 1)


def viscous_friction(rng, b, j):
    return level(rng, b.arm.viscous, j, "FV", lambda log: log.dq[:, j], 2)


def asymmetric_friction(rng, b, j):
    way = rng.choice([-1, 1])
    if rng.random() < 0.5:
        return at(j, f"Coulomb level higher where the sign is {way}",
                  lambda log: log.sign[:, j] * (log.sign[:, j] == way), plain=(0, 1))
    return at(j, f"viscous slope higher where the sign is {way}", lambda log: log.dq[:, j] * (log.dq[:, j] * way > 0))


def stribeck_friction(rng, b, j):
    speed = rng.uniform(0.04, 0.15) * b.speed[j]
    if rng.random() < 0.5:
        return at(j, f"sign / (1 + |v| / {speed:.3f})^2",
                  lambda log: log.sign[:, j] / (1 + np.abs(log.dq[:, j]) / speed)**2)
    return at(j, f"sign / cosh(v / {speed:.3f})", lambda log: log.sign[:, j] / np.cosh(log.dq[:, j] / speed))


def nonlinear_viscous_friction(rng, b, j):
    top, form = b.speed[j], rng.integers(3)
    if form == 0:
        return at(j, "v |v|", lambda log: log.dq[:, j] * np.abs(log.dq[:, j]) / top**2)
    if form == 1:
        return at(j, "v^3", lambda log: (log.dq[:, j] / top)**3)
    knee = rng.uniform(0.1, 0.3) * top
    return at(j, f"arctan(v / {knee:.3f})", lambda log: np.arctan(log.dq[:, j] / knee))


def load_dependent_friction(rng, b, j):
    return at(j, "in proportion to |load|", most=0.4, keys={f"FL{j + 1}": lambda s: s},
              shape=lambda log: log.sign[:, j] * np.abs(b.arm.newton_euler(log.q, log.dq, log.ddq)[:, j]))


def position_dependent_friction(rng, b, j):
    middle, width, form = rng.uniform(b.low[j], b.high[j]), 0.15 * b.span[j], rng.integers(3)
    if form == 0:
        return at(j, f"a bell about {middle:.2f} rad",
                  lambda log: log.sign[:, j] * np.exp(-((log.q[:, j] - middle) / width)**2))
    if form == 1:
        return at(j, "grows along the travel",
                  lambda log: log.sign[:, j] * np.clip((log.q[:, j] - b.low[j]) / b.span[j], 0, 1))
    waves = int(rng.integers(2, 5))
    return at(j, f"{waves} waves in the travel",
              lambda log: log.sign[:, j] * np.sin(np.pi * waves * (log.q[:, j] - middle) / b.span[j])**2)


def presliding_hysteresis(rng, b, j):
    width, lugre = rng.uniform(0.03, 0.12) * b.span[j], rng.random() < 0.5

    def bristle(q):
        """Dahl's, or LuGre's with a breakaway level half as high again; exact or explicit within each sample."""
        out, z, speed = np.zeros(len(q)), 0.0, np.abs(np.gradient(q))
        for i, move in enumerate(np.diff(q, prepend=q[0])):
            level = 1 + 0.5 * np.exp(-(speed[i] / (0.1 * speed.max()))**2) if lugre else 1.0
            end = level * np.sign(move)
            z = end + (z - end) * np.exp(-abs(move) / (level * width)) if move else z
            out[i] = z
        return out
    return at(j, f"{'LuGre' if lugre else 'Dahl'} over {width:.3f} rad", lambda log: log.each(bristle, log.q[:, j]))


def rotor_inertia(rng, b, j):
    return at(j, "reflected inertia", lambda log: log.ddq[:, j], keys={f"IA{j + 1}": lambda s: b.arm.rotor[j] + s})


def torque_ripple(rng, b, j):
    # Four periods in the travel at least; at top speed within the recorded band.
    source = b.fit[0].source
    least, most = 2 * np.pi * 4 / b.span[j], 2 * np.pi * min(0.8 * source.top, source.band) / b.speed[j]
    if most < least:
        raise ValueError("no order fits travel and band")
    order, phase = int(np.ceil(rng.uniform(least, most))), rng.uniform(0, 6.28)
    return at(j, f"order {order}", lambda log: np.sin(order * log.q[:, j] + phase))


def joint_spring(rng, b, j):
    rest, side, form = rng.uniform(b.low[j], b.high[j]), rng.choice([-1, 1]), rng.integers(3)
    if form == 0:
        return at(j, "linear", lambda log: log.q[:, j] - rest, keys={f"KS{j + 1}": lambda s: s})
    if form == 1:
        return at(j, f"cable, taut on side {side} of {rest:.2f} rad",
                  lambda log: side * np.maximum(side * (log.q[:, j] - rest), 0))
    return at(j, f"cubic about {rest:.2f} rad", lambda log: (log.q[:, j] - rest)**3)


def torque_offset(rng, b, j):
    way = rng.choice([-1, 1])
    return at(j, "constant", lambda log: np.full(len(log.t), way), plain=(0,), keys={f"TO{j + 1}": lambda s: way * s})


def torque_gain_error(rng, b, j):
    way = rng.choice([-1, 1])
    return at(j, "scaled", lambda log: way * log.tau[:, j], most=0.5, at_sensor=True,
              keys={f"GT{j + 1}": lambda s: 1 + way * s})


def time_delay(rng, b, j):
    joints, way = ([], 1) if rng.random() < 0.5 else ([j], rng.choice([-1, 1]))

    def late(log, s):
        torque = b.arm.torque(log)
        change = log.shifted(torque, way * s) - torque
        return one(log, j, change[:, j]) if joints else change
    return Cause(joints, "of the robot" if not joints else "of one joint", late, most=0.06,
                 keys={f"TD{j + 1}" if joints else "TD": lambda s: way * s})


def gear_coupling(rng, b, j):
    k = j - 1 if j == b.arm.n - 1 or (j > 0 and rng.random() < 0.5) else j + 1
    ratio, top = rng.choice([-1, 1]), np.abs(np.concatenate([log.ddq for log in b.fit])).max()
    inertia, viscous, coulomb = rng.uniform(0.3, 1, 3) / [top, b.speed[j] + b.speed[k], 1]
    return Cause([int(j), int(k)], f"a motor turns with dq{j + 1} {'+' if ratio > 0 else '-'} dq{k + 1}",
                 lambda log, s: s * coupled(log, j, k, ratio, inertia, viscous, coulomb))


def body(b, j, centre, size):
    """Torques of 1 kg at a place of link j, a ball of some size."""
    empty, c = (0.0, np.zeros(3), np.zeros((3, 3))), np.array(centre)
    ball = (1.0, c, (c @ c + 0.4 * size**2) * np.eye(3) - np.outer(c, c))
    bodies = [ball if i == j else empty for i in range(b.arm.n)]
    return lambda log, s: s * b.arm.newton_euler(log.q, log.dq, log.ddq, bodies)


def payload(rng, b, j):
    outward = -1 if b.name.startswith("kinova") else 1      # its z axes point to the base
    centre = [*rng.uniform(-0.05, 0.05, 2), outward * rng.uniform(0.05, 0.2)]
    return Cause([], f"a ball at {np.round(centre, 2).tolist()}", body(b, b.arm.n - 1, centre, 0.05), most=6,
                 keys={"M": lambda s: s})


def link_inertia_error(rng, b, j):
    M, MS, _ = b.arm.bodies[j]
    centre, way = MS / max(M, 0.1) + rng.uniform(-0.1, 0.1, 3), -1 if rng.random() < 0.3 else 1
    add = body(b, j, centre, 0.08)
    return Cause([int(j)], f"{'more' if way > 0 else 'less'} mass at {np.round(centre, 2).tolist()}",
                 lambda log, s: way * add(log, s), most=5 if way > 0 else 0.5 * M)


def external_contact(rng, b, j):
    # At a joint whose link moves joints inward of it: link 3 outward; half a sine, in one of the fitted logs.
    link, long = int(rng.integers(2, b.arm.n)), rng.uniform(0.3, 1.2)
    where, log = rng.uniform(-0.1, 0.1, 3), b.fit[int(rng.integers(len(b.fit)))]
    clock, force = np.arange(len(log.t)) * log.step, rng.normal(size=3)
    # Without a validating log the last three tenths are not fitted.
    begin = rng.uniform(0.1, clock[-1] * (1 if b.validate else 0.7) - long - 0.1)
    force /= np.linalg.norm(force)
    during = (clock >= begin) & (clock <= begin + long)
    if len(np.unique(log.seg[during])) > 1:
        raise ValueError("a push across two recordings")

    def push(on, s):
        out = np.zeros_like(on.q)
        if on is log:
            frames = b.arm.frames(on.q)
            point = frames[link][1] + frames[link][0] @ where
            course = np.sin(np.pi * np.clip((clock - begin) / long, 0, 1))
            for i in range(link + 1):
                _, _, axis, origin = frames[i]
                out[:, i] = -s * course * np.sum(axis * np.cross(point - origin, force), axis=1)
        return out
    return Cause([], f"{long:.2f} s from {log.t[during][0]:.2f} s of fit{b.fit.index(log) + 1}, link {link + 1}", push)


KINDS = [coulomb_friction, viscous_friction, asymmetric_friction, stribeck_friction, nonlinear_viscous_friction,
         load_dependent_friction, position_dependent_friction, presliding_hysteresis, rotor_inertia, torque_ripple,
         joint_spring, torque_offset, torque_gain_error, time_delay, gear_coupling, payload, link_inertia_error,
         external_contact]


# ---- a case ------------------------------------------------------------------------------------------------------

def bench(name, given):
    """The arm with its identified file, in DIR/base/ARM, and its logs."""
    source, folder = ARMS[name], given.out / "base" / name
    folder.mkdir(parents=True, exist_ok=True)
    parts = [[Log(given.data / source.folder / f"{file}.csv", begin, end, source) for file, begin, end in part]
             for part in (source.fit, source.validate)]
    files = write(folder, parts, lambda log: log.tau)
    data = yaml.safe_load((ROOT / "robots" / f"{source.robot}.yaml").read_text())
    for row in data["joints"]:
        row["drive"]["friction"].setdefault("offset", 0)
    for j, effect in source.known.items():
        data["joints"][j - 1]["drive"].update(effect)
    if source.late:
        data["effects"] = {"time_delay": {"TD": source.late}}
    (folder / "file.yaml").write_text(yaml.safe_dump(data, sort_keys=False))
    subprocess.run([given.binary, "identify", "file.yaml", *sum(files, []), "--out", "robot.yaml"], cwd=folder,
                   check=True, capture_output=True)
    return Bench(name, Arm(folder / "robot.yaml"), *parts)


def write(folder, parts, tau):
    """Writes the logs; their names."""
    names = [[f"{kind}{i + 1}.csv" for i in range(len(part))] for kind, part in zip(("fit", "validate"), parts)]
    for log, name in zip(sum(parts, []), sum(names, [])):
        log.write(folder / name, tau(log))
    return names


def without_plain(b, cause, values):
    """Values of all fitted windows, in residuals, less offset, Coulomb and viscous level of their joint."""
    out = []
    for j in range(b.arm.n):
        plain = np.concatenate([log.windows(np.stack([np.ones(len(log.t)), log.recorded(log.sign)[:, j],
                                                      log.recorded(log.dq)[:, j]], axis=1)) for log in b.fit])
        plain = np.delete(plain, cause.plain, axis=1)
        y = np.concatenate([value[:, j] for value in values]) / b.rms[j]
        out.append(y - plain @ np.linalg.lstsq(plain, y, rcond=None)[0] if plain.shape[1] else y)
    return np.stack(out, axis=1)


def sized(b, cause, size):
    """Scale, torques by log, sizes by joint, what least squares recovers (of the whole, of halves), what plain friction
    leaves. ValueError where the case is not fair."""
    def added(scale):
        return [x if cause.at_sensor else log.recorded(x) for log in b.logs for x in [cause.torque(log, scale)]]
    scale = 0.01
    for _ in range(5):
        torques = added(scale)
        fitted = [log.windows(x) for log, x in zip(b.fit, torques)]
        share = np.sqrt(np.mean(np.concatenate(fitted)**2, axis=0)) / b.rms
        if share.max() < 1e-9:
            raise ValueError("moves no torque")
        if abs(size / share.max() - 1) < 0.01:
            break
        scale *= size / share.max()
    if not scale <= cause.most or abs(size / share.max() - 1) > 0.05:
        raise ValueError("out of an arm's reach")
    alone, rest = without_plain(b, cause, fitted), without_plain(b, cause, b.rest)
    whole = np.linalg.norm(np.concatenate(fitted) / b.rms)
    parts = [slice(None), slice(len(rest) // 2), slice(len(rest) // 2, None)]
    recovered = [1 + np.sum(rest[p] * alone[p]) / max(np.sum(alone[p]**2), 1e-12) for p in parts]
    left = np.linalg.norm(alone) / whole
    if left < 0.3:
        raise ValueError("plain friction takes it")
    if abs(recovered[0] - 1) > 0.2 or max(abs(part - 1) for part in recovered[1:]) > 0.5:
        raise ValueError("least squares of the true form misses its size")
    return scale, dict(zip(map(id, b.logs), torques)), share, recovered, left


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--data", type=pathlib.Path, required=True, help="folder of the recordings")
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("--cases", type=int, required=True, help="cases of each size")
    parser.add_argument("--sizes", default="3,1,0.5", help="RMS added, in RMS of the identified model's residual")
    parser.add_argument("--kinds", default=",".join(kind.__name__ for kind in KINDS), help="causes that are added")
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--binary", type=lambda path: str(pathlib.Path(path).resolve()),
                        default=str(ROOT / "target" / "release" / "denavit"))
    given, truth, skipped = parser.parse_args(), [], {}
    if unknown := set(given.kinds.split(",")) - {kind.__name__ for kind in KINDS}:
        parser.error(f"--kinds: there is no {', '.join(sorted(unknown))}; write {', '.join(k.__name__ for k in KINDS)}")
    benches = {name: bench(name, given) for name in ARMS}
    for name, b in benches.items():
        print(f"{name}: residual {np.round(b.rms, 2).tolist()} N m", flush=True)
    order, deck, arms = np.random.default_rng(given.seed), [], []
    kinds = [kind for kind in KINDS if kind.__name__ in given.kinds.split(",")]
    for size in map(float, given.sizes.split(",")):
        for _ in range(given.cases):
            rng = np.random.default_rng([given.seed, len(truth)])
            while True:
                deck, arms = (cards or [x[i] for i in order.permutation(len(x))]
                              for cards, x in ((deck, kinds), (arms, DECK)))
                kind, b = deck.pop(), benches[arms.pop()]
                try:
                    cause = kind(rng, b, int(rng.choice(b.moving())))
                    scale, torques, share, recovered, left = sized(b, cause, size)
                    break
                except ValueError as reason:
                    skipped[str(reason)] = skipped.get(str(reason), 0) + 1
            number = len(truth) + 1
            folder = given.out / f"{number:02}"
            folder.mkdir(exist_ok=True)
            fit, validate = write(folder, [b.fit, b.validate], lambda log: log.tau + torques[id(log)])
            truth.append({"case": number, "arm": b.name, "dof": b.arm.n, "cause": kind.__name__, "size": size,
                          "joints": [int(j) + 1 for j in cause.joints], "form": cause.form,
                          "parameters": {key: float(value(scale)) for key, value in cause.keys.items()},
                          "size_by_joint": share.round(2).tolist(), "recovered": np.round(recovered, 2).tolist(),
                          "beside_plain_friction": round(float(left), 2), "fit": fit, "validate": validate})
            print(number, size, b.name, kind.__name__, truth[-1]["joints"], cause.form, truth[-1]["parameters"],
                  f"recovered {recovered[0]:.2f}, beside plain friction {left:.2f}", flush=True)
    (given.out / "truth.json").write_text(json.dumps(truth, indent=1))
    print(f"{len(truth)} cases; drawn again: {skipped}")


if __name__ == "__main__":
    main()
