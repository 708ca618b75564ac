#!/usr/bin/env python3
"""Compares robot files with MuJoCo, in both directions.

    pip install mujoco pyyaml
    cargo build --release
    python3 benches/mujoco/export.py target/release/denavit robots/kuka-lwr4.yaml identified.yaml
    python3 benches/mujoco/export.py target/release/denavit tests/import/arm.xml:grasp

A robot file is exported to MJCF, an MJCF file imported (up to the link behind the colon, joints beside
the arm at zero). Inverse dynamics of both sides at 50 random states, relative to the largest torque: the mass
matrix, Coriolis and gravity torques, rotors, viscous friction and springs by `mj_inverse`, to which
Coulomb friction is added (MuJoCo's is a constraint). Where a robot file has `time_delay`, the model is
played: a late torque must be read that late, an early one must act that late.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

import mujoco
import numpy as np
import yaml

STATES = 50


def run(*words):
    done = subprocess.run([str(w) for w in words], capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(done.stderr)
    return done.stdout


def states(folder, n):
    rng = np.random.default_rng(3)
    q, dq, ddq = (rng.uniform(-1, 1, (STATES, n)) * s for s in (2.0, 2.0, 5.0))
    head = ",".join(f"{w}{k + 1}" for w in ("q", "dq", "ddq") for k in range(n))
    file = folder / "states.csv"
    np.savetxt(file, np.hstack([q, dq, ddq]), delimiter=",", header=head, comments="", fmt="%.17g")
    return file, q, dq, ddq


def inverse_dynamics(model_file, names, held, q, dq, ddq):
    model = mujoco.MjModel.from_xml_path(str(model_file))
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONSTRAINT
    data = mujoco.MjData(model)
    joints = [model.joint(name) for name in names]
    torques = []
    for k in range(len(q)):
        data.qpos[:] = model.qpos0
        data.qvel[:] = 0
        data.qacc[:] = 0
        for name, value in held.items():
            data.qpos[model.joint(name).qposadr[0]] = value
        for column, joint in enumerate(joints):
            data.qpos[joint.qposadr[0]] = q[k, column]
            data.qvel[joint.dofadr[0]] = dq[k, column]
            data.qacc[joint.dofadr[0]] = ddq[k, column]
        mujoco.mj_inverse(model, data)
        coulomb = [np.sign(dq[k, c]) * model.dof_frictionloss[j.dofadr[0]] for c, j in enumerate(joints)]
        torques.append([data.qfrc_inverse[j.dofadr[0]] for j in joints] + np.array(coulomb))
    return np.array(torques)


def command(t, size):
    return size * np.sin(2 * np.pi * 0.7 * t)


def delays(model_file, steps=2000):
    """Largest difference of torques read and applied from the commands of `delay` earlier, relative."""
    model = mujoco.MjModel.from_xml_path(str(model_file))
    data = mujoco.MjData(model)
    motors = [a for a in range(model.nu) if model.actuator_delay[a] > 0]
    sensors = [s for s in range(model.nsensor) if model.sensor_delay[s] > 0]
    if not motors and not sensors:
        return None
    range_of = lambda a: model.actuator_ctrlrange[a, 1] if model.actuator_ctrllimited[a] else 1.0
    size = 1e-3 * np.array([range_of(a) for a in range(model.nu)])
    worst = 0.0
    for _ in range(steps):
        t = data.time
        data.ctrl[:] = command(t, size)
        mujoco.mj_step(model, data)
        acted = {a: model.actuator_delay[a] for a in range(model.nu)}
        for a in motors:
            if t > acted[a] + model.opt.timestep:
                worst = max(worst, abs(data.actuator_force[a] - command(t - acted[a], size[a])) / size[a])
        for s in sensors:
            a = next(a for a in range(model.nu) if model.actuator_trnid[a, 0] == model.sensor_objid[s])
            late = model.sensor_delay[s] + acted[a]
            if t > late + model.opt.timestep:
                worst = max(worst, abs(data.sensordata[model.sensor_adr[s]] - command(t - late, size[a])) / size[a])
    count = f"{len(sensors)} late torques, {len(motors)} late motors"
    return f"{count}, off by {worst:.1e} of the command (linear between steps)", worst


def compare(binary, argument, folder):
    name, _, tip = argument.partition(":")
    file = pathlib.Path(name)
    robot, model, held = file, file, {}
    if file.suffix != ".yaml":
        robot = folder / "robot.yaml"
        options = ["--at", "zero"] + (["--tip", tip] if tip else [])
        held = json.loads(run(binary, "import", file, "--out", robot, "--json", "-", *options))["held"]
    else:
        model = folder / "robot.xml"
        print(run(binary, "export", robot, "--format", "mjcf", "--out", model), end="")
    rows = yaml.safe_load(pathlib.Path(robot).read_text())["joints"]
    names = [row.get("name", f"joint{k + 1}") for k, row in enumerate(rows) if row["type"] != "fixed"]
    table, q, dq, ddq = states(folder, len(names))
    said = json.loads(run(binary, "eval", robot, "--quantity", "inverse_dynamics", "--states", table))
    ours = np.array(said["values"]).reshape(STATES, -1)
    theirs = inverse_dynamics(model, names, held, q, dq, ddq)
    worst = np.abs(ours - theirs).max() / max(1.0, np.abs(theirs).max())
    print(f"{file}: {len(names)} joints, inverse dynamics differ by {worst:.1e}")
    late = delays(model)
    if late:
        print(f"{file}: {late[0]}")
        # Between two steps of 2 ms a sine of 0.7 Hz is off a straight line by 1e-5 of its size.
        worst = max(worst, 0.0 if late[1] < 2e-5 else late[1])
    return worst


def main():
    binary = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as folder:
        worst = max(compare(binary, f, pathlib.Path(folder)) for f in sys.argv[2:])
    sys.exit(0 if worst < 1e-9 else 1)


if __name__ == "__main__":
    main()
