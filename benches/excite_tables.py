#!/usr/bin/env python3
"""The tables of docs/excite.md: criteria over seeds, robots, durations. Needs `cargo build --release`.

Times are seconds of processor of the whole program, the robot's generation included: a machine's load changes them little.
"""

import json
import os
import resource
import statistics
import subprocess

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
DENAVIT = os.path.join(ROOT, "target", "release", "denavit")


def excite(robot, *options):
    command = [DENAVIT, "excite", os.path.join(ROOT, "robots", robot + ".yaml"), "--json", "-", *map(str, options)]
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    run = subprocess.run(command, capture_output=True, text=True)
    cpu = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    return {**json.loads(run.stdout), "cpu": cpu} if run.returncode == 0 else None


def row(*cells):
    print("| " + " | ".join(cells) + " |", flush=True)


print("kuka-lwr4, 10 s, all constraints, medians over seeds 1 to 3\n")
row("criterion", "columns", "value", "condition number", "log det", "s of processor")
row(*["---"] * 6)
for criterion in ["cond", "logdet", "hadamard"]:
    for name, options in [("43, links", ["--links-only"]), ("57, with friction", [])]:
        runs = [excite("kuka-lwr4", "--criterion", criterion, "--seed", seed, *options) for seed in (1, 2, 3)]
        assert all(r and r["feasible"] for r in runs)
        middle = lambda key: statistics.median(r[key] for r in runs)
        row(criterion, name, f"{middle('value'):.2f}", f"{middle('condition_number'):.1f}", f"{middle('log_det'):.1f}", f"{middle('cpu'):.1f}")

print("\nRobots, 10 s, links only, seed 1: condition number\n")
row("robot", "columns", "cond", "logdet", "s of processor (cond)")
row(*["---"] * 5)
for robot in ["franka-panda", "ur10e", "kinova-gen3", "staubli-tx40"]:
    cond, log = (excite(robot, "--criterion", c, "--links-only") for c in ("cond", "logdet"))
    row(robot, str(len(cond["columns"])), f"{cond['condition_number']:.1f}", f"{log['condition_number']:.1f}", f"{cond['cpu']:.1f}")

print("\nkuka-lwr4, links only, by duration, 8 starts\n")
row("s", "cond", "change", "-log det", "change", "-log Hadamard", "change")
row(*["---"] * 7)
before = {}
for seconds in range(1, 16):
    cells = [str(seconds)]
    for criterion in ["cond", "logdet", "hadamard"]:
        found = excite("kuka-lwr4", "--criterion", criterion, "--duration", seconds, "--links-only", "--starts", 8)
        value = found["value"] if found else None
        change = value - before[criterion] if value is not None and before.get(criterion) is not None else None
        before[criterion] = value
        cells += [f"{value:.1f}" if value is not None else "-", f"{change:+.1f}" if change is not None else "-"]
    row(*cells)
