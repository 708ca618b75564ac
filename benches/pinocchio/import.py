#!/usr/bin/env python3
"""Compares imported robot files with Pinocchio on the URDF files that they were made of.

    pip install pin pyyaml
    cargo build --release && python3 benches/pinocchio/import.py ../shared/data/urdf target/release/denavit

For each file: forward kinematics and Jacobian of the tip, inverse dynamics where the file knows the
inertia of every link, at 50 random states, relative to the largest entry. The reference is the URDF as
Pinocchio reads it, all other joints locked where the import holds them. Reports each file when it is done, those worse
than 1e-9, and the largest difference of all.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
import pinocchio as pin
import yaml

STATES = 50
REQUIRED = 1e-9
LONGEST = 300  # s, of one command


def run(*words):
    words = [str(w) for w in words]
    try:
        return subprocess.run(words, capture_output=True, text=True, timeout=LONGEST)
    except subprocess.TimeoutExpired:
        return subprocess.CompletedProcess(words, 1, "", f"no end within {LONGEST} s")


def imported(binary, file, folder):
    """The JSON of an import and the robot file; the first of several tips."""
    out = folder / "robot.yaml"
    options = ["--at", "zero"]
    for _ in range(2):
        made = run(binary, "import", file, "--out", out, "--json", "-", *options)
        if made.returncode == 0:
            return json.loads(made.stdout), out
        if " moving joints: " not in made.stderr:
            return made.stderr.strip().splitlines()[0], None
        # Each with its number of joints: `wrist (6), thumb (8); choose ...`.
        tip = made.stderr.split(" moving joints: ")[1].split(";")[0].split(",")[0].rsplit(" (", 1)[0].strip()
        options += ["--tip", tip]
    return made.stderr.strip().splitlines()[0], None


def evaluated(binary, robot, quantity, states):
    made = run(binary, "eval", robot, "--quantity", quantity, "--states", states)
    if made.returncode != 0:
        raise RuntimeError(made.stderr)
    said = json.loads(made.stdout)
    return np.array(said["values"]).reshape(STATES, said["rows"], said["cols"])


def tool_of(robot_file):
    """Pose of the tool frame in the last DH frame."""
    tool = yaml.safe_load(robot_file.read_text()).get("tool")
    pose = pin.SE3.Identity()
    if tool:
        number = lambda x: float(eval(str(x), {"pi": np.pi}))
        xyz, rpy = ([number(x) for x in tool["pose"][key]] for key in ("xyz", "rpy"))
        pose = pin.SE3(pin.rpy.rpyToMatrix(*rpy), np.array(xyz))
    return pose


def compare(binary, file, folder):
    made, robot = imported(binary, file, folder)
    if robot is None:
        return made
    model = pin.buildModelFromUrdf(str(file))
    names = [j["name"] for j in made["joints"] if j["type"] != "fixed"]
    if made["base"] != model.frames[1].name and model.getFrameId(made["base"]) > 1:
        return "another base than the root"
    ids = [model.getJointId(name) for name in names]
    rng = np.random.default_rng(1)
    n = len(names)
    q, dq, ddq = (rng.uniform(-1, 1, (STATES, n)) * s for s in (np.pi, 2.0, 5.0))
    states = folder / "states.csv"
    head = ",".join(f"{w}{k + 1}" for w in ("q", "dq", "ddq") for k in range(n))
    np.savetxt(states, np.hstack([q, dq, ddq]), delimiter=",", header=head, comments="", fmt="%.17g")

    # Friction is no part of Pinocchio's inverse dynamics: it is added here.
    data = model.createData()
    held = pin.neutral(model)
    for name, value in made["held"].items():
        joint = model.joints[model.getJointId(name)]
        if joint.nq == 1:
            held[joint.idx_q] = value
        else:
            held[joint.idx_q:joint.idx_q + 2] = np.cos(value), np.sin(value)
    tip = model.getFrameId(made["tip"])
    poses, jacobians, torques = [], [], []
    known = not any("inertia" in sentence for sentence in made["unknown"])
    for k in range(STATES):
        full, v, a = held.copy(), np.zeros(model.nv), np.zeros(model.nv)
        for column, index in enumerate(ids):
            joint = model.joints[index]
            if joint.nq == 1:
                full[joint.idx_q] = q[k, column]
            else:
                full[joint.idx_q:joint.idx_q + 2] = np.cos(q[k, column]), np.sin(q[k, column])
            v[joint.idx_v], a[joint.idx_v] = dq[k, column], ddq[k, column]
        columns = [model.joints[index].idx_v for index in ids]
        pin.framesForwardKinematics(model, data, full)
        pin.computeJointJacobians(model, data, full)
        poses.append(data.oMf[tip].copy())
        jacobians.append(pin.getFrameJacobian(model, data, tip, pin.LOCAL_WORLD_ALIGNED)[:, columns])
        torques.append(pin.rnea(model, data, full, v, a)[columns])
    tool = tool_of(robot)
    worst = {}
    found = evaluated(binary, robot, "forward_kinematics", states)
    ends = [pin.SE3(t) * tool for t in found]
    worst["fk"] = max(np.abs(e.homogeneous - p.homogeneous).max() for e, p in zip(ends, poses))
    jacobian = evaluated(binary, robot, "jacobian", states)
    for k in range(STATES):
        arm = found[k][:3, :3] @ tool.translation
        jacobian[k][:3] += np.cross(jacobian[k][3:].T, arm).T
    worst["jacobian"] = max(np.abs(a - b).max() for a, b in zip(jacobian, jacobians))
    if known:
        moving = [j for j in made["joints"] if j["type"] != "fixed"]
        plain = [[j["viscous_friction"] or 0.0, j["coulomb_friction"] or 0.0] for j in moving]
        viscous, coulomb = np.array(plain).T
        friction = viscous * dq + coulomb * np.sign(dq)
        found = evaluated(binary, robot, "inverse_dynamics", states)[:, :, 0] - friction
        size = max(1.0, np.abs(torques).max())
        worst["inverse dynamics"] = np.abs(found - np.array(torques)).max() / size
    return worst


def main():
    source, binary = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
    files = sorted(source.rglob("*.urdf"))
    largest, compared, without, seen = {}, {}, [], {}
    with tempfile.TemporaryDirectory() as folder:
        for file in files:
            name, content = file.relative_to(source), file.read_bytes()
            if content in seen:
                without.append((name, f"the same bytes as {seen[content]}"))
                continue
            seen[content] = name
            try:
                worst = compare(binary, file, pathlib.Path(folder))
            except (ValueError, RuntimeError, IndexError, KeyError) as error:
                worst = f"Pinocchio: {str(error).splitlines()[0][:100]}"
            if isinstance(worst, str):
                without.append((name, worst))
                continue
            print(f"{name}: " + ", ".join(f"{key} {value:.1e}" for key, value in worst.items()), flush=True)
            for key, value in worst.items():
                compared[key] = compared.get(key, 0) + 1
                largest[key] = max(largest.get(key, 0.0), value)
                if not value <= REQUIRED:
                    print(f"{name}: {key} differs by {value:.1e}")
    for name, why in without:
        print(f"{name}: not compared: {why[:160]}")
    for key, value in largest.items():
        print(f"{key}: {compared[key]} of {len(files)} files, largest difference {value:.1e}")


if __name__ == "__main__":
    main()
