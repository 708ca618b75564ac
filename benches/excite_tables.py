#!/usr/bin/env python3
"""The tables of docs/excite.md: criteria over seeds, robots, scalings of the columns. Needs numpy and `cargo build --release`.

Times are seconds of processor of the whole program, the robot's generation included: a machine's load changes them little.
"""

import json
import os
import resource
import statistics
import subprocess
import tempfile

import numpy as np

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
DENAVIT = os.path.join(ROOT, "target", "release", "denavit")


def excite(robot, *options):
    path = robot if robot.endswith(".yaml") else os.path.join(ROOT, "robots", robot + ".yaml")
    command = [DENAVIT, "excite", path, "--json", "-", *map(str, options)]
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    run = subprocess.run(command, capture_output=True, text=True)
    cpu = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    return {**json.loads(run.stdout), "cpu": cpu} if run.returncode == 0 else None


def row(*cells):
    print("| " + " | ".join(cells) + " |", flush=True)


print("kuka-lwr4, 10 s, all constraints, medians over seeds 1 to 5\n")
row("criterion", "columns", "value", "condition number", "log det", "s of processor")
row(*["---"] * 6)
for criterion in ["cond", "logdet", "hadamard"]:
    for name, options in [("43, links", ["--links-only"]), ("57, with friction", [])]:
        runs = [excite("kuka-lwr4", "--criterion", criterion, "--seed", seed, *options) for seed in range(1, 6)]
        assert all(r and r["feasible"] for r in runs)
        middle = lambda key: statistics.median(r[key] for r in runs)
        row(criterion, name, f"{middle('value'):.2f}", f"{middle('condition_number'):.1f}", f"{middle('log_det'):.1f}", f"{middle('cpu'):.1f}")

print("\nRobots, 10 s, links only, seed 1: condition number\n")
row("robot", "columns", "cond", "logdet", "s of processor (cond)")
row(*["---"] * 5)
for robot in ["franka-panda", "ur10e", "kinova-gen3", "staubli-tx40"]:
    cond, log = (excite(robot, "--criterion", c, "--links-only") for c in ("cond", "logdet"))
    row(robot, str(len(cond["columns"])), f"{cond['condition_number']:.1f}", f"{log['condition_number']:.1f}", f"{cond['cpu']:.1f}")

print("\nOne motion, many condition numbers: 10 s by cond, 8 starts, seed 1\n")
row("robot", "designed for", "leaders, links", "leaders, all", "combinations, links", "combinations, all", "unit columns, all")
row(*["---"] * 7)


def spread(matrix):
    sigma = np.linalg.svd(matrix, compute_uv=False)
    sigma = sigma[sigma > 1e-9 * sigma[0]]
    return f"{sigma[0] / sigma[-1]:.1f}"


BODY = "tool: { name: box, M: 2, MS: [0.05, 0.04, 0.2], I: [0.05, 0.05, 0.02, -0.003, -0.004, -0.003] }\n"
with tempfile.TemporaryDirectory() as folder:
    for name, body in [("franka-panda", ""), ("kuka-iiwa14", BODY), ("kuka-lwr4", "")]:
        robot, motion, states = (os.path.join(folder, f) for f in ("robot.yaml", "motion.csv", "states.csv"))
        with open(os.path.join(ROOT, "robots", name + ".yaml")) as source, open(robot, "w") as to:
            to.write(source.read() + "\n" + body)
        for what, options in [("links", ["--links-only"]), ("all", [])]:
            excite(robot, "--criterion", "cond", "--starts", 8, "--out", motion, *options)
            with open(motion) as source, open(states, "w") as to:
                lines = source.readlines()
                to.writelines(lines[:1] + lines[1::2])
            cells = []
            for quantity in ["base_regressor", "regressor"]:
                command = [DENAVIT, "eval", robot, "--quantity", quantity, "--states", states, "--json", "-"]
                found = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
                matrix = np.array(found["values"]).reshape(-1, found["cols"])
                links = [k for k, column in enumerate(found["column_names"]) if column[:2] not in ("IA", "FV", "FC", "FO")]
                cells += [spread(matrix[:, links]), spread(matrix)]
                if quantity == "base_regressor":
                    unit = spread(matrix / np.linalg.norm(matrix, axis=0))
            row(name + (", 2 kg in its hand" if body else ""), what, *cells, unit)
