#!/usr/bin/env python3
"""A free swing of 10 s without friction, by `denavit simulate`, MuJoCo and Pinocchio, each with its own model built from the same robot
file: largest differences of the joint positions, and what each does to the energy. An optional check; needs `cargo build --release` and
`pip install mujoco pin pyyaml numpy`.

    benches/peers/free_swing.py [robots/kuka-lwr4.yaml] [seconds] [start, rad: 0.3,0.5,..]
"""

import os
import re
import subprocess
import sys
import tempfile

import mujoco
import numpy as np
import pinocchio as pin
import yaml

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
DENAVIT = os.path.join(ROOT, "target", "release", "denavit")
ROBOT = sys.argv[1] if len(sys.argv) > 1 else os.path.join(ROOT, "robots", "kuka-lwr4.yaml")
SECONDS = float(sys.argv[2]) if len(sys.argv) > 2 else 10.0
STEP = 1e-4


def number(value, constants):
    """An expression of the robot file: pi, constants, degrees."""
    text = re.sub(r"([0-9.]+)\s*deg", r"(\1*pi/180)", str(value))
    return float(eval(text, {"__builtins__": {}}, {"pi": np.pi, **constants}))


def read(path):
    file = yaml.safe_load(open(path))
    constants = {}
    for name, value in file.get("constants", {}).items():
        constants[name] = number(value, constants)
    assert file["convention"] == "modified" and "tool" not in file, "modified convention, no tool"
    joints = []
    for joint in file["joints"]:
        assert joint["type"] == "revolute"
        joints.append([number(joint.get(key, 0), constants) for key in ("alpha", "d", "theta", "r")])
    links = []
    for link in file["links"]:
        m, s = number(link["M"], constants), np.array([number(x, constants) for x in link["MS"]])
        xx, yy, zz, xy, xz, yz = (number(x, constants) for x in link["I"])
        c = s / m
        about_centre = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]) - m * (c @ c * np.eye(3) - np.outer(c, c))
        links.append((m, c, about_centre))
    return joints, links, np.array([number(g, constants) for g in file["gravity"]]), file


def turn_x(a):
    return np.array([[1, 0, 0], [0, np.cos(a), -np.sin(a)], [0, np.sin(a), np.cos(a)]])


def turn_z(a):
    return np.array([[np.cos(a), -np.sin(a), 0], [np.sin(a), np.cos(a), 0], [0, 0, 1]])


def placement(alpha, d, theta, r):
    """Of a row at q = 0: RotX(alpha) TransX(d) RotZ(theta) TransZ(r)."""
    return turn_x(alpha) @ turn_z(theta), turn_x(alpha) @ np.array([d, 0, r])


def pinocchio_model(joints, links, gravity):
    model = pin.Model()
    model.gravity.linear = gravity
    parent = 0
    for k, (row, (m, c, tensor)) in enumerate(zip(joints, links)):
        parent = model.addJoint(parent, pin.JointModelRZ(), pin.SE3(*placement(*row)), f"joint{k + 1}")
        model.appendBodyToJoint(parent, pin.Inertia(m, c, tensor), pin.SE3.Identity())
    return model


def mujoco_model(joints, links, gravity):
    words = lambda values: " ".join(repr(float(v)) for v in values)
    body, close = "", ""
    for row, (m, c, tensor) in zip(joints, links):
        rotation, origin = placement(*row)
        quaternion = np.zeros(4)
        mujoco.mju_mat2Quat(quaternion, rotation.flatten())
        i = tensor
        body += f'<body pos="{words(origin)}" quat="{words(quaternion)}"><joint type="hinge" axis="0 0 1"/>'
        full = words([i[0, 0], i[1, 1], i[2, 2], i[0, 1], i[0, 2], i[1, 2]])
        body += f'<inertial pos="{words(c)}" mass="{m!r}" fullinertia="{full}"/>'
        close += "</body>"
    option = f'<option timestep="{STEP}" integrator="RK4" gravity="{words(gravity)}"><flag contact="disable"/></option>'
    compiler = '<compiler autolimits="true" balanceinertia="false" boundmass="0" boundinertia="0"/>'
    return mujoco.MjModel.from_xml_string(f"<mujoco>{compiler}{option}<worldbody>{body}{close}</worldbody></mujoco>")


def swing_mujoco(model, q, steps, every):
    data = mujoco.MjData(model)
    data.qpos[:] = q
    rows = [data.qpos.copy()]
    for k in range(steps):
        mujoco.mj_step(model, data)
        if (k + 1) % every == 0:
            rows.append(data.qpos.copy())
    return np.array(rows)


def swing_pinocchio(model, q, steps, every):
    data, n = model.createData(), model.nq
    tau = np.zeros(n)
    rate = lambda y: np.concatenate([y[n:], pin.aba(model, data, y[:n], y[n:], tau)])
    y = np.concatenate([q, np.zeros(n)])
    rows = [y[:n].copy()]
    for k in range(steps):
        k1 = rate(y)
        k2 = rate(y + STEP / 2 * k1)
        k3 = rate(y + STEP / 2 * k2)
        k4 = rate(y + STEP * k3)
        y = y + STEP / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        if (k + 1) % every == 0:
            rows.append(y[:n].copy())
    return np.array(rows)


def swing_denavit(file, q):
    with tempfile.TemporaryDirectory() as place:
        for joint in file["joints"]:
            joint.pop("drive", None)
        robot, effects, log = (os.path.join(place, name) for name in ("robot.yaml", "effects.yaml", "log.csv"))
        yaml.safe_dump(file, open(robot, "w"), default_flow_style=None, sort_keys=False)
        with open(effects, "w") as out:
            out.write("sensors: { rate: 100, encoder: 0, torque_noise: 0 }\nsolver: { tolerance: 1e-12 }\n")
        start = ",".join(map(str, q))
        command = [DENAVIT, "simulate", robot, "--free", str(SECONDS), f"--start={start}", "--effects", effects, "--out", log]
        print(subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()[1])
        table = np.genfromtxt(log, delimiter=",", names=True)
        return np.column_stack([table[f"q{j + 1}"] for j in range(len(q))])


joints, links, gravity, file = read(ROBOT)
start = np.array([float(x) for x in sys.argv[3].split(",")]) if len(sys.argv) > 3 else np.array([0.3, 0.5, -0.2, 0.8, 0.1, -0.5, 0.2])[: len(joints)]
every, steps = round(0.01 / STEP), round(SECONDS / STEP)
pinocchio = pinocchio_model(joints, links, gravity)
swings = {
    "denavit": swing_denavit(file, start),
    "MuJoCo": swing_mujoco(mujoco_model(joints, links, gravity), start, steps, every),
    "Pinocchio": swing_pinocchio(pinocchio, start, steps, every),
}
print(f"{file['name']}, {SECONDS} s; MuJoCo {mujoco.__version__} and Pinocchio {pin.__version__} by Runge-Kutta 4, steps of {STEP} s")
names = list(swings)
for a, b in [(0, 1), (0, 2), (1, 2)]:
    off = np.abs(swings[names[a]] - swings[names[b]]).max(axis=1)
    parts = ", ".join(f"{off[: round(t * 100) + 1].max():.1e} rad in {t:g} s" for t in (1, 2, 5, 10) if t <= SECONDS)
    print(f"{names[a]:9} - {names[b]:9} {parts}; largest angle {np.abs(swings[names[a]]).max():.1f} rad")
