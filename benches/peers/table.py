#!/usr/bin/env python3
"""The two ends of run.sh: `describe` writes model.txt; `table` checks every peer's values against ours and prints the table."""

import csv
import glob
import json
import math
import os
import random
import re
import subprocess
import sys

import yaml

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
ROBOT = os.path.join(ROOT, "robots", "kuka-lwr4.yaml")
DENAVIT = os.path.join(os.environ.get("CARGO_TARGET_DIR", os.path.join(ROOT, "target")), "release", "denavit")
FUNCTIONS = [
    ("regressor", "full regressor"),
    ("base_regressor", "base regressor"),
    ("inverse_dynamics", "inverse dynamics"),
    ("mass_matrix", "mass matrix"),
    ("gravity", "gravity"),
    ("jacobian", "Jacobian"),
    ("forward_kinematics", "forward kinematics"),
]


def robot():
    """The robot file without its drives: the peers' models have none."""
    with open(ROBOT) as file:
        said = yaml.safe_load(file)
    for joint in said["joints"]:
        joint.pop("drive", None)
    said.pop("collision", None)
    return said


def describe(work):
    said = robot()
    names = {"pi": math.pi, **said.get("constants", {})}
    number = lambda x: float(eval(str(x), {"__builtins__": {}}, names))
    with open(os.path.join(work, "bare.yaml"), "w") as file:
        yaml.safe_dump(said, file)
    checked = json.loads(subprocess.run([DENAVIT, "check", os.path.join(work, "bare.yaml"), "--json", "-"], check=True, capture_output=True).stdout)
    standard = checked["standard_parameters"]
    leaders = [standard.index(re.sub("R$", "", b["name"])) for b in checked["base_parameters"]]
    n = len(said["joints"])
    chance = random.Random(7)
    states = [[[chance.uniform(-2, 2) for _ in range(n)] for _ in range(3)] for _ in range(5)]
    with open(os.path.join(work, "model.txt"), "w") as file:
        put = lambda row: file.write(" ".join(repr(x) for x in row) + "\n")
        put([n])
        for joint in said["joints"]:
            put([number(joint.get(key, 0)) for key in ("alpha", "d", "theta", "r")])
        for link in said["links"]:
            put([link["M"], *link["MS"], *link["I"]])
        put([len(leaders), *leaders])
        put([len(states)])
        for state in states:
            for part in state:
                put(part)
    with open(os.path.join(work, "states.csv"), "w", newline="") as file:
        out = csv.writer(file)
        out.writerow([f"{what}{j + 1}" for what in ("q", "dq", "ddq") for j in range(n)])
        out.writerows([[repr(x) for part in state for x in part] for state in states])


def flat(x):
    return [y for part in x for y in flat(part)] if isinstance(x, list) else [x]


def ours(work):
    """What `denavit eval` says at the states: function -> one flat list per state."""
    values = {}
    for name, _ in FUNCTIONS:
        command = [DENAVIT, "eval", os.path.join(work, "bare.yaml"), "--quantity", name, "--states", os.path.join(work, "states.csv"), "--json", "-"]
        said = json.loads(subprocess.run(command, check=True, capture_output=True).stdout)
        values[name] = [flat(v) for v in said["values"]]
    return values


def medians(text):
    """Median ns by function from divan's table, for kuka_lwr4; a pack's by state."""
    times, arm, function = {}, None, None
    units = {"ns": 1.0, "µs": 1e3, "us": 1e3, "ms": 1e6}
    for line in text.splitlines():
        name = re.match(r"^[│ ]*[├╰]─ (\w+)", line)
        if not name:
            continue
        depth = line.index("─")
        cells = re.findall(r"([\d.]+) (ns|µs|us|ms)\b", line)
        if depth < 3:
            arm = name[1]
        elif not cells:
            function = name[1]
        elif arm == "kuka_lwr4":
            value, unit = cells[2]
            times[function, name[1]] = float(value) * units[unit]
    return times


def table(work):
    mine = ours(work)
    peers = {}
    for path in sorted(glob.glob(os.path.join(work, "*.json"))):
        with open(path) as file:
            peers[os.path.basename(path)[:-5]] = json.load(file)
    worst = 0.0
    for label, said in peers.items():
        for index, state in enumerate(said["states"]):
            for name, values in state.items():
                expected = mine[name][index]
                assert len(values) == len(expected), (label, name, len(values), len(expected))
                size = max(1.0, max(map(abs, expected)))
                error = max(abs(a - b) for a, b in zip(values, expected)) / size
                assert error < 1e-9, f"{label}: {name} differs from ours by {error:.1e}"
                worst = max(worst, error)
    print(f"Every peer's values agree with ours at five states: worst relative difference {worst:.1e}.\n")
    with open(os.path.join(work, "kernels.txt")) as file:
        times = medians(file.read())

    def best(kind, name):
        found = [(said["ns"][name], label) for label, said in peers.items() if label.startswith(kind) and name in said["ns"]]
        return min(found) if found else None

    print("| kuka-lwr4, ns per call | ours | eight states at once, per state | CasADi, best build | ratio | Pinocchio, best build | ratio |")
    print("|---|---|---|---|---|---|---|")
    for name, title in FUNCTIONS:
        own, pack = times[name, "generated"], times[name, "pack"] / 8
        row = [title, f"{own:.0f}", f"{pack:.1f}"]
        for kind in ("casadi", "pinocchio"):
            found = best(kind, name)
            row += [f"{found[0]:.0f} ({found[1].removeprefix(kind + '-')})", f"{found[0] / own:.1f}"] if found else ["-", "-"]
        print("| " + " | ".join(row) + " |")
    with open(os.path.join(work, "bare.txt")) as file:
        rounds = [tuple(map(float, line.split())) for line in file if line.strip()]
    ratios = sorted(peer / own for own, peer in rounds)
    middle = lambda x: sorted(x)[len(x) // 2]
    print(
        f"\nFull regressor of the same 70 columns as Pinocchio's (no drives), one after the other {len(rounds)} times: {middle([r[0] for r in rounds]):.0f} ns, Pinocchio "
        f"{middle([r[1] for r in rounds]):.0f} ns, {middle(ratios):.1f} times ({ratios[0]:.1f} to {ratios[-1]:.1f})."
    )
    base = times["inverse_dynamics_base", "generated"], times["inverse_dynamics_base", "pack"] / 8
    print(f"\nInverse dynamics from base parameters: {base[0]:.0f} ns, {base[1]:.1f} ns per state of eight.")
    print("\nAll builds, ns:")
    for label, said in peers.items():
        print(f"  {label}: " + ", ".join(f"{k} {v:.0f}" for k, v in said["ns"].items()))


if __name__ == "__main__":
    {"describe": describe, "table": table}[sys.argv[1]](sys.argv[2])
