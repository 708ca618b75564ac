#!/usr/bin/env python3
"""The diagnosis on logs of a simulator that this project did not write: MuJoCo plays arms of robots/ or others (--arms), with and without an effect that the
robot file does not know. Prints the figures; --out keeps robot files, logs, labels and results.

    python3 -m pip install mujoco pyyaml
    cargo build --release --bin denavit
    benches/mujoco/battery.py --cases 200 --seed 1 --out /tmp/battery

DENAVIT names another binary. A third of a minute a case; every fifth case hides nothing. The same seed gives the same cases.

Effects, as MuJoCo knows them: joint damping, frictionloss, armature, stiffness; a welded payload; a heavier link; a fixed tendon with armature, damping and
frictionloss (one motor on two axes); a joint limit of some milliradians between motor and link (backlash), a spring in its place (elasticity); commands that act
late or are clipped while the log has the command; a gain, an offset, a wrong zero; a push (xfrc_applied). Encoders step by 1e-6 to 1e-3 rad, rates go from
30 Hz to 1 kHz.

--laws hides laws that neither MuJoCo nor the diagnosis has in that form, each with the cause that it is a case of: friction of LuGre and of Maxwell's elements
in series, a Stribeck curve that is rational, a viscous curve that levels off, load friction that differs by quadrant, a tight spot, a level that fades, a cable
taut on one side and one that hardens, a gear that hardens, a wall that pushes while the tool is behind it.
"""

import argparse
import csv
import json
import math
import os
import subprocess
import sys
import tempfile

import mujoco
import numpy as np
import yaml

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
DENAVIT = os.environ.get("DENAVIT", os.path.join(ROOT, "target", "release", "denavit"))
ARMS = ["franka-panda", "ur10e", "kuka-iiwa14", "kinova-gen3", "kuka-lwr4"]
EFFECTS = [
    "viscous_friction", "coulomb_friction", "rotor_inertia", "joint_spring", "payload", "link_inertia_error", "gear_coupling", "backlash",
    "joint_elasticity", "time_delay", "torque_saturation", "torque_gain_error", "torque_offset", "encoder_offset", "external_contact",
]
# Cause and form.
LAWS = [
    ("presliding_hysteresis", "lugre"), ("presliding_hysteresis", "maxwell"), ("stribeck_friction", "rational"), ("nonlinear_viscous_friction", "levels off"),
    ("load_dependent_friction", "quadrant"), ("position_dependent_friction", "tight spot"), ("friction_drift", "fades"), ("asymmetric_friction", "viscous"),
    ("joint_spring", "taut"), ("joint_spring", "hardens"), ("joint_elasticity", "hardens"), ("external_contact", "wall"),
]
RATES = [30, 60, 100, 200, 500, 1000]
STEP = 1e-3
# Standard deviation of the torque's noise by the joint's torque limit.
NOISE = 1e-3
# MuJoCo's dry friction is a steep viscous law up to some speed: 0.08 rad/s with its defaults, which a diagnosis rightly
# finds where it should find nothing. This is as hard as the step allows.
HARD = "solreffriction='0.002 1' solimpfriction='0.999 0.9999 0.001'"


def number(value, constants):
    """A number of a robot file, which may be an expression."""
    if isinstance(value, (int, float)):
        return float(value)
    text = "".join(c for c in value)
    for unit, factor in (("deg", "*(pi/180)"), ("rad", "")):
        text = text.replace(unit, factor)
    return float(eval(text, {"__builtins__": {}}, {"pi": math.pi, **constants}))


def limits(value, constants, default):
    return [number(v, constants) for v in value] if value else default


class Arm:
    """DH table, limits and bodies of a robot file (a name in robots/, or a path); bodies that MuJoCo takes for impossible become ellipsoids."""

    def __init__(self, name):
        if not name.endswith(".yaml"):
            name = os.path.join(ROOT, "robots", name + ".yaml")
        with open(name) as file:
            raw = yaml.safe_load(file)
        constants = {}
        for key, value in (raw.get("constants") or {}).items():
            constants[key] = number(value, constants)
        table = (raw.get("convention", "modified"), {j.get("type", "revolute") for j in raw["joints"]})
        if table != ("modified", {"revolute"}):
            sys.exit(f"{name}: only modified tables of revolute joints are played, and this is {table}")
        self.name, self.joints, self.links = os.path.splitext(os.path.basename(name))[0], [], []
        self.gravity = [number(g, constants) for g in raw.get("gravity", [0, 0, -9.81])]
        for row, joint in enumerate(raw["joints"]):
            of = lambda key: number(joint.get(key, 0), constants)
            torque = of("torque") or 50.0
            self.joints.append({
                "alpha": of("alpha"), "d": of("d"), "theta": of("theta"), "r": of("r"), "torque": torque,
                "position": limits(joint.get("position"), constants, [-2.5, 2.5]), "velocity": of("velocity") or 1.5,
                "IA": 2e-4 * torque, "FV": 0.02 * torque, "FC": 0.015 * torque,
            })
            link = (raw.get("links") or [None] * 99)[row]
            self.links.append(self.body(link, constants, row))

    @staticmethod
    def body(link, constants, row):
        mass, first, tensor = 0.0, np.zeros(3), np.zeros(6)
        if link:
            mass = number(link.get("M", 0), constants)
            first = np.array([number(x, constants) for x in link.get("MS", [0, 0, 0])])
            tensor = np.array([number(x, constants) for x in link.get("I", [0] * 6)])
        if mass > 0.05:
            center = first / mass
            moments = np.linalg.eigvalsh(matrix(tensor) - mass * (center @ center * np.eye(3) - np.outer(center, center)))
            if moments[0] > 1e-5 and moments[0] + moments[1] > 1.001 * moments[2]:
                return mass, first, tensor
        mass, center, radius = 4.0 / (row + 1), np.array([0.0, 0.02, 0.05]), np.array([0.05, 0.05, 0.1])
        own = mass / 5 * (radius @ radius * np.eye(3) - np.diag(radius**2))
        tensor = own + mass * (center @ center * np.eye(3) - np.outer(center, center))
        return mass, mass * center, np.array([tensor[0, 0], tensor[1, 1], tensor[2, 2], tensor[0, 1], tensor[0, 2], tensor[1, 2]])

    def dof(self):
        return len(self.joints)

    def file(self):
        """The robot file that the diagnosis gets."""
        joints = [
            {"name": f"J{i + 1}", "type": "revolute", "alpha": repr(j["alpha"]) + " + 0", "d": j["d"], "theta": repr(j["theta"]) + " + 0", "r": j["r"],
             "position": j["position"], "velocity": j["velocity"], "torque": j["torque"],
             "drive": {"rotor_inertia": j["IA"], "friction": {"viscous_friction": j["FV"], "coulomb_friction": j["FC"]}}}
            for i, j in enumerate(self.joints)
        ]
        links = [{"M": float(m), "MS": [float(x) for x in ms], "I": [float(x) for x in t]} for m, ms, t in self.links]
        return {"name": self.name, "convention": "modified", "gravity": self.gravity, "joints": joints, "links": links}


def matrix(t):
    return np.array([[t[0], t[3], t[4]], [t[3], t[1], t[5]], [t[4], t[5], t[2]]])


def model(arm, effect=None, j=0, x=0.0):
    """The MuJoCo model of an arm with an effect of size x on joint j."""
    extra, lines, closing = {}, [], []
    soft = effect in ("backlash", "joint_elasticity")
    for i, (row, (mass, first, tensor)) in enumerate(zip(arm.joints, arm.links)):
        mass, first, tensor = mass, np.array(first), np.array(tensor)
        add = np.zeros(3)
        if effect == "payload" and i == arm.dof() - 1:
            add, by = np.array([0.02, 0.03, 0.1]), x
        if effect == "link_inertia_error" and i == j:
            add, by = np.array([0.05, 0.1, 0.05]), x
        if add.any():
            point = by * (add @ add * np.eye(3) - np.outer(add, add))
            tensor = tensor + np.array([point[0, 0], point[1, 1], point[2, 2], point[0, 1], point[0, 2], point[1, 2]])
            mass, first = mass + by, first + by * add
        center = first / mass
        about = matrix(tensor) - mass * (center @ center * np.eye(3) - np.outer(center, center))
        full = " ".join(f"{v:.12g}" for v in (about[0, 0], about[1, 1], about[2, 2], about[0, 1], about[0, 2], about[1, 2]))
        ca, sa = math.cos(row["alpha"] / 2), math.sin(row["alpha"] / 2)
        ct, st = math.cos(row["theta"] / 2), math.sin(row["theta"] / 2)
        quat = f"{ca * ct:.15g} {sa * ct:.15g} {-sa * st:.15g} {ca * st:.15g}"
        position = f"{row['d']:.15g} {-math.sin(row['alpha']) * row['r']:.15g} {math.cos(row['alpha']) * row['r']:.15g}"
        damping, loss, armature, spring = row["FV"], row["FC"], row["IA"], ""
        if i == j:
            damping += x if effect == "viscous_friction" else 0
            loss += x if effect == "coulomb_friction" else 0
            armature += x if effect == "rotor_inertia" else 0
            if effect == "joint_spring":
                spring = f" stiffness='{x}' springref='{math.degrees(0.3)}'"
        lines.append(f"<body name='b{i}' pos='{position}' quat='{quat}'>")
        lines.append(f"<joint name='j{i}' type='hinge' axis='0 0 1' damping='{damping}' frictionloss='{loss}' armature='{armature}' {HARD}{spring}/>")
        if soft and i == j:
            if effect == "backlash":
                lines.append(f"<joint name='gap' type='hinge' axis='0 0 1' damping='{0.1 * row['FV']}' limited='true' range='{-math.degrees(x / 2)} {math.degrees(x / 2)}' solreflimit='0.004 1'/>")
            else:
                lines.append(f"<joint name='gap' type='hinge' axis='0 0 1' damping='{0.2 * row['FV']}' stiffness='{1 / x}'/>")
        lines.append(f"<inertial pos='{center[0]:.12g} {center[1]:.12g} {center[2]:.12g}' mass='{mass:.12g}' fullinertia='{full}'/>")
        closing.append("</body>")
    motors = "".join(f"<motor joint='j{i}'/>" for i in range(arm.dof()))
    tendon = ""
    if effect == "gear_coupling":
        other = j - 1 if j > 0 else j + 1
        row = arm.joints[j]
        # The motor of joint j has its rotor and its friction on the sum of both axes.
        tendon = f"<tendon><fixed armature='{3 * row['IA'] * x}' damping='{row['FV'] * x}' frictionloss='{row['FC'] * x}'><joint joint='j{j}' coef='1'/><joint joint='j{other}' coef='1'/></fixed></tendon>"
        extra["other"] = other
    gravity = " ".join(map(str, arm.gravity))
    xml = (f"<mujoco><compiler angle='degree' balanceinertia='false'/><option timestep='{STEP}' integrator='implicitfast' gravity='{gravity}' cone='elliptic' impratio='10' solver='Newton' tolerance='1e-12'>"
           f"<flag contact='disable'/></option><worldbody>{''.join(lines)}{''.join(closing)}</worldbody>{tendon}<actuator>{motors}</actuator></mujoco>")
    return mujoco.MjModel.from_xml_string(xml), extra


def motion(arm, seconds, slow, random):
    """Sums of four sines inside the limits: positions, velocities, accelerations over the steps."""
    t = np.arange(0, seconds, STEP)
    q, v, a = (np.zeros((len(t), arm.dof())) for _ in range(3))
    for j, row in enumerate(arm.joints):
        low, high = max(row["position"][0], -2.3), min(row["position"][1], 2.3)
        waves = [(random.uniform(0.3, 1) / (k + 1), 2 * math.pi * ((0.1 * (k + 1) + random.uniform(0, 0.05)) * (0.5 if slow else 1)), random.uniform(0, 6.28)) for k in range(4)]
        s = sum(b * np.sin(w * t + p) for b, w, p in waves)
        ds = sum(b * w * np.cos(w * t + p) for b, w, p in waves)
        dds = sum(-b * w * w * np.sin(w * t + p) for b, w, p in waves)
        scale = min(0.4 * (high - low) / abs(s).max(), 0.7 * min(row["velocity"], 2.0) / abs(ds).max())
        q[:, j], v[:, j], a[:, j] = 0.5 * (low + high) + scale * s, scale * ds, scale * dds
    return t, q, v, a


class Law:
    """A law of joint j of size x: dry friction beside that of the file, and a torque."""

    def __init__(self, arm, form, j, x, scale):
        t, q, v, _ = scale
        self.form, self.x, self.row = form, x, arm.joints[j]
        self.fast, self.far = np.abs(v[:, j]).max(), 0.5 * np.ptp(q[:, j])
        self.middle, self.seconds = 0.5 * (q[:, j].max() + q[:, j].min()), t[-1]
        self.bristles = np.zeros(4)

    def dry(self, t, q, v, load):
        x = self.x
        if self.form == "rational":
            return x / (1 + (v / (0.08 * self.fast)) ** 2)
        if self.form == "quadrant":
            return x * abs(load) * (1.4 if load * v > 0 else 0.6)
        if self.form == "tight spot":
            return x * math.exp(-(((q - self.middle) / (0.25 * self.far)) ** 2))
        if self.form == "fades":
            return x * math.exp(-t / (0.4 * self.seconds))
        return 0.0

    def torque(self, q, v):
        x = self.x
        if self.form == "levels off":
            return -x * math.tanh(v / (0.3 * self.fast))
        if self.form == "viscous":
            return -x * max(v, 0.0)
        if self.form == "taut":
            return -x * max(q - self.middle - 0.2 * self.far, 0.0)
        if self.form == "hardens":
            return -x * math.sinh(2.5 * (q - self.middle) / self.far)
        if self.form == "lugre":
            # Bristles of 5 mrad to the whole torque; a step that is implicit in them.
            level = 1 + 0.3 * math.exp(-((v / (0.1 * self.fast)) ** 2))
            self.bristles[0] = (self.bristles[0] + STEP * v) / (1 + STEP * abs(v) / 5e-3 / level)
            return -x / 5e-3 * self.bristles[0]
        if self.form == "maxwell":
            widths = np.array([1e-3, 3e-3, 8e-3, 2e-2])
            self.bristles = np.clip(self.bristles + STEP * v, -widths, widths)
            return -0.25 * x * (self.bristles / widths).sum()
        return 0.0


def play(arm, moves, effect, j, x, first, random_window, form=None, scale=None):
    """Follows a motion by computed torques; true motion and command at every step. The constants of a law come from the motion `scale`."""
    # A spring of another form takes the place of MuJoCo's.
    mj, extra = model(arm, None if form and effect == "joint_spring" else effect, j, x)
    plain, _ = model(arm)
    data, feed = mujoco.MjData(mj), mujoco.MjData(plain)
    t, q, v, a = moves
    n = arm.dof()
    at = [mj.joint(f"j{i}").qposadr[0] for i in range(n)]
    data.qpos[at], data.qvel[at] = q[0], v[0]
    wide = 40.0 if effect in ("backlash", "joint_elasticity") else 60.0
    lag = int(round(x / STEP)) if effect == "time_delay" else 0
    queue = []
    out_q, out_v, out_a, out_tau = (np.zeros((len(t), n)) for _ in range(4))
    last = mj.body(f"b{n - 1}").id
    law, own = Law(arm, form, j, x, scale or moves), mj.joint(f"j{j}").dofadr[0]
    gap = mj.joint("gap") if form and effect == "joint_elasticity" else None
    wall = None
    for k in range(len(t)):
        now, speed = data.qpos[at], data.qvel[at]
        feed.qpos[:], feed.qvel[:], feed.qacc[:] = now, v[k], a[k] + wide**2 * (q[k] - now) + 1.4 * wide * (v[k] - speed)
        mujoco.mj_inverse(plain, feed)
        command = feed.qfrc_inverse.copy()
        queue.append(command)
        acts = queue[max(0, len(queue) - 1 - lag)].copy()
        if effect == "torque_saturation":
            acts[j] = np.clip(acts[j], -x, x)
        if effect == "torque_gain_error":
            acts[j] /= 1 + x
        data.ctrl[:] = acts
        data.xfrc_applied[:] = 0
        if form:
            data.qfrc_applied[:] = 0
            # Torque on the link: friction of the file is on the motor's side.
            row = arm.joints[j]
            load = command[j] - row["FV"] * speed[j] - row["FC"] * np.sign(speed[j])
            mj.dof_frictionloss[own] = row["FC"] + law.dry(t[k], now[j], speed[j], load)
            if gap:
                # Twice as stiff where the joint's torque winds it most.
                wound = data.qpos[gap.qposadr[0]]
                data.qfrc_applied[gap.dofadr[0]] = -(wound**3) * (1 / x) / (arm.joints[j]["torque"] * x) ** 2
            elif effect != "external_contact":
                data.qfrc_applied[own] = law.torque(now[j], speed[j])
            elif wall is None:
                # Behind it is the tool one third of the way.
                mujoco.mj_kinematics(mj, data)
                heights = []
                for posture in (scale or moves)[1][::50]:
                    feed.qpos[:] = posture
                    mujoco.mj_kinematics(plain, feed)
                    heights.append(feed.xpos[last, 2])
                wall = np.quantile(heights, 0.33), max(np.ptp(heights), 1e-3)
            if wall:
                data.xfrc_applied[last, 2] = x * max(wall[0] - data.xpos[last, 2], 0.0) / wall[1]
        elif effect == "external_contact" and first and random_window[0] <= t[k] < random_window[1]:
            data.xfrc_applied[last, :3] = x * np.array([0.6, -0.5, 0.62])
        out_q[k], out_v[k], out_tau[k] = now, speed, command
        mujoco.mj_step(mj, data)
        out_a[k] = (data.qvel[at] - speed) / STEP
    return t, out_q, out_v, out_a, out_tau, extra


def size_of(arm, run):
    """What the plain arm misses of a run, per joint, in noises."""
    plain, _ = model(arm)
    feed = mujoco.MjData(plain)
    t, q, v, a, tau, _ = run
    missed = []
    for k in range(200, len(t) - 200, 10):
        feed.qpos[:], feed.qvel[:], feed.qacc[:] = q[k], v[k], a[k]
        mujoco.mj_inverse(plain, feed)
        missed.append(tau[k] - feed.qfrc_inverse)
    return np.sqrt(np.mean(np.square(missed), axis=0)) / [NOISE * j["torque"] for j in arm.joints]


START = {
    "viscous_friction": lambda r: 0.02 * r["torque"], "coulomb_friction": lambda r: 0.01 * r["torque"], "rotor_inertia": lambda r: 4e-3 * r["torque"],
    "joint_spring": lambda r: 0.01 * r["torque"], "payload": lambda r: 0.5, "link_inertia_error": lambda r: 0.5, "gear_coupling": lambda r: 1.0,
    "backlash": lambda r: 4e-3, "joint_elasticity": lambda r: 1 / (60 * r["torque"]), "time_delay": lambda r: 0.01, "torque_saturation": lambda r: 0.3 * r["torque"],
    "torque_gain_error": lambda r: 0.05, "torque_offset": lambda r: 0.01 * r["torque"], "encoder_offset": lambda r: 0.02, "external_contact": lambda r: 8.0,
}
TRUTH = {
    "viscous_friction": ("FV", lambda r, x: r["FV"] + x), "coulomb_friction": ("FC", lambda r, x: r["FC"] + x), "rotor_inertia": ("IA", lambda r, x: r["IA"] + x),
    "joint_spring": ("KS", lambda r, x: x), "payload": ("M", lambda r, x: x), "joint_elasticity": ("KE", lambda r, x: 1 / x), "backlash": ("BL", lambda r, x: x),
    "torque_saturation": ("TM", lambda r, x: x), "torque_gain_error": ("GT", lambda r, x: 1 + x), "torque_offset": ("TO", lambda r, x: x),
    "encoder_offset": ("QO", lambda r, x: -x), "time_delay": ("TD", lambda r, x: -x),
}


def record(path, arm, run, effect, j, x, rate, encoder, random):
    """The log as sensors of that rate see it."""
    t, q, v, a, tau, _ = run
    every = max(1, int(round(1 / (rate * STEP))))
    take = np.arange(0, len(t), every)
    q, tau = q[take].copy(), tau[take].copy()
    if effect == "encoder_offset":
        q[:, j] += x
    if effect == "torque_offset":
        tau[:, j] += x
    q = np.round(q / encoder) * encoder
    tau += random.normal(size=tau.shape) * [NOISE * r["torque"] for r in arm.joints]
    n = arm.dof()
    with open(path, "w", newline="") as file:
        out = csv.writer(file)
        out.writerow(["t"] + [f"q{i + 1}" for i in range(n)] + [f"tau{i + 1}" for i in range(n)])
        for k, row in enumerate(take):
            out.writerow([f"{t[row]:.6f}"] + [f"{x:.9g}" for x in q[k]] + [f"{x:.8g}" for x in tau[k]])


def draw(seed, wanted, laws=False, arms=ARMS):
    """A case: what is hidden, its size, its logs' motions."""
    random = np.random.default_rng(seed)
    clean = seed % 5 == 0
    # Every arm has clean logs, and others.
    arm = Arm(arms[(seed + seed // 5) % len(arms)] if len(arms) % 5 == 0 else arms[seed % len(arms)])
    effect = None if clean else EFFECTS[(seed - seed // 5) % len(EFFECTS)]
    form = None
    if laws and effect:
        effect, form = LAWS[(seed - seed // 5) % len(LAWS)]
    rate = RATES[int(random.integers(len(RATES)))]
    encoder = 10.0 ** random.uniform(-6, -4) if effect else 10.0 ** random.uniform(-6, -3)
    j = int(random.integers(arm.dof() - (1 if effect == "link_inertia_error" else 0)))
    moves = [motion(arm, seconds, rate < 100, random) for seconds in (16.0, 10.0)]
    window = (lambda s: (s, s + 1.5))(random.uniform(1.5, 4))
    row = arm.joints[j]
    x = START.get(effect, lambda r: 0.01 * r["torque"])(row) if effect else 0.0
    if form in ("lugre", "maxwell"):
        rate = max(rate, 200)
    grows = {"torque_saturation": -0.5, "backlash": 0.7}.get(effect, 1.0)
    # The first seconds tell the size.
    short = tuple(part[: int(6 / STEP)] for part in moves[0])
    for attempt in range(4 if effect else 0):
        seen = play(arm, short, effect, j, x, True, window, form, moves[0])
        if effect in ("torque_offset", "encoder_offset"):
            t, q, v, a, tau, extra = seen
            q, tau = q.copy(), tau.copy()
            q[:, j] += x if effect == "encoder_offset" else 0
            tau[:, j] += x if effect == "torque_offset" else 0
            seen = (t, q, v, a, tau, extra)
        sizes = size_of(arm, seen)
        one = effect in ("viscous_friction", "coulomb_friction", "rotor_inertia", "joint_spring", "torque_gain_error", "torque_offset", "torque_saturation")
        reached = sizes[j] if one or form not in (None, "wall") else sizes.max()
        if not np.isfinite(reached) or reached == 0:
            return None
        if abs(math.log(reached / wanted)) < 0.3:
            break
        x *= float(np.clip((wanted / reached) ** grows, 0.1, 10))
    else:
        if effect:
            return None
    runs = [play(arm, move, effect, j, x, first, window, form, moves[0]) for move, first in zip(moves, (True, False))]
    whole = effect in ("payload", "time_delay", "external_contact")
    joints = [] if whole else [j + 1]
    if effect == "gear_coupling":
        joints = [j + 1, runs[0][5]["other"] + 1]
    symbol, value = (None, None) if form else TRUTH.get(effect, (None, None))
    truth = {} if not symbol else {symbol + ("" if whole else str(j + 1)): value(row, x)}
    label = {"seed": seed, "robot": arm.name, "effect": effect, "form": form, "dof": arm.dof(), "joints": joints, "size": x, "parameters": truth, "rate": rate, "encoder": encoder}
    return arm, runs, label, (effect, j, x, rate, encoder, random)


def diagnose(arm, runs, sensors, place):
    robot, logs = os.path.join(place, "robot.yaml"), [os.path.join(place, f"{name}.csv") for name in ("fit", "validate")]
    with open(robot, "w") as file:
        yaml.safe_dump(arm.file(), file, sort_keys=False)
    for path, run in zip(logs, runs):
        record(path, arm, run, *sensors)
    command = [DENAVIT, "diagnose", robot, logs[0], "--validate", logs[1], "--json", "-"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        return {"error": done.stderr.strip()}
    return json.loads(done.stdout)


def same(cause, label):
    joints = sorted(cause["joints"])
    if label["effect"] == "payload" and cause["cause"] == "link_inertia_error":
        return joints == [label["dof"]]
    if label["effect"] == "link_inertia_error" and label["joints"] == [1] and cause["cause"] == "rotor_inertia":
        # Only its inertia about the axis moves: the torque of a rotor.
        return joints == [1]
    return cause["cause"] == label["effect"] and joints == sorted(label["joints"])


def share(good, all_):
    return f"{100 * good / all_:.0f} % ({good} of {all_})" if all_ else "-"


def report(results):
    hidden = [r for r in results if r["label"]["effect"]]
    clean = [r for r in results if not r["label"]["effect"]]
    causes = lambda r: r["found"].get("causes", [])
    failed = [r for r in results if "error" in r["found"]]
    first = [r for r in hidden if causes(r) and same(causes(r)[0], r["label"])]
    named = [r for r in hidden if any(same(c, r["label"]) for c in causes(r))]
    right = [r for r in hidden if any(c["cause"] == r["label"]["effect"] for c in causes(r))]
    wrong = sum(1 for r in hidden for c in causes(r) if not same(c, r["label"]) and c["cause"] != "unknown")
    alarms = [r for r in clean if causes(r)]
    loud = [r for r in clean if any(c["probability"] > 0.5 for c in causes(r))]
    inside, known = 0, 0
    for r in named:
        for c in (c for c in causes(r) if same(c, r["label"])):
            for symbol, value in r["label"]["parameters"].items():
                std = (c.get("parameters_std") or {}).get(symbol)
                if symbol in c["parameters"] and std:
                    known, inside = known + 1, inside + (abs(c["parameters"][symbol] - value) <= 3 * std)
    print(f"cases                        {len(results)}, {len(clean)} of them clean, {len(failed)} refused")
    print(f"right cause first, in place  {share(len(first), len(hidden))}")
    print(f"right cause named, in place  {share(len(named), len(hidden))}")
    print(f"right joint, cause right     {share(len(named), len(right))}")
    print(f"sizes within three std       {share(inside, known)}")
    print(f"wrong causes per case        {wrong / max(1, len(hidden)):.2f}")
    print(f"clean logs with any cause    {share(len(alarms), len(clean))}, above 0.5 {share(len(loud), len(clean))}")
    claims = [(c["probability"], bool(r["label"]["effect"]) and same(c, r["label"])) for r in results for c in causes(r) if c["cause"] != "unknown"]
    error = 0.0
    for low, high in zip([0, 0.2, 0.4, 0.6, 0.8, 0.9], [0.2, 0.4, 0.6, 0.8, 0.9, 1.01]):
        here = [c for c in claims if low <= c[0] < high]
        if here:
            mean, true = np.mean([c[0] for c in here]), np.mean([c[1] for c in here])
            error += len(here) * abs(mean - true) / len(claims)
            print(f"  stated {low:.1f} to {min(high, 1):.1f}: mean {mean:.2f}, true {share(sum(c[1] for c in here), len(here))}")
    print(f"expected calibration error   {error:.3f}")
    for r in failed + alarms + [r for r in hidden if r not in first]:
        said = r["found"].get("error") or "; ".join(f"{c['cause']} {c['joints']} {c['probability']:.2f}" for c in causes(r))
        label = r["label"]
        print(f"  seed {label['seed']} {label['robot']} {label['rate']} Hz, encoder {label['encoder']:.0e}: {label['effect']}{' ' + label['form'] if label.get('form') else ''} {label['joints']} -> {r['found'].get('verdict', 'refused')}: {said}")


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--cases", type=int, default=200, help="how many; every fifth is clean")
    options.add_argument("--seed", type=int, default=1, help="of the first case; each has the next")
    options.add_argument("--size", type=float, default=10.0, help="error of the file that an effect makes on its joint, in noises of the torque")
    options.add_argument("--laws", action="store_true", help="hide laws of other forms")
    options.add_argument("--arms", nargs="+", default=ARMS, help="names in robots/, or robot files, as `denavit import` writes them; their friction is drawn from their torque limits")
    options.add_argument("--out", help="folder for robot files, logs, labels and results")
    options = options.parse_args()
    if not os.access(DENAVIT, os.X_OK):
        sys.exit(f"{DENAVIT} is missing: cargo build --release --bin denavit, or DENAVIT=path")
    results = []
    for seed in range(options.seed, options.seed + options.cases):
        case = draw(seed, options.size, options.laws, options.arms)
        if case is None:
            print(f"seed {seed}: the effect can't be made so large here, left out", file=sys.stderr)
            continue
        arm, runs, label, sensors = case
        with tempfile.TemporaryDirectory() as temporary:
            place = temporary
            if options.out:
                place = os.path.join(options.out, f"{seed:05d}")
                os.makedirs(place, exist_ok=True)
            found = diagnose(arm, runs, sensors, place)
            results.append({"label": label, "found": found})
            if options.out:
                with open(os.path.join(place, "result.json"), "w") as file:
                    json.dump(results[-1], file, indent=1)
        print(f"{len(results)} of {options.cases}", end="\r", file=sys.stderr, flush=True)
    report(results)


if __name__ == "__main__":
    main()
