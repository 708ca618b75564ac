#!/usr/bin/env python3
"""The tables of docs/consistency.md: plain least squares against possible bodies on motion that was not fitted, over several splits of each
log. Needs `cargo build --release` and the measured logs (the folder that holds kuka-lwr4plus, staubli-tx40, ...):

    benches/possible_bodies.py ../shared/data
"""

import json
import math
import os
import re
import statistics
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
DENAVIT = os.environ.get("DENAVIT", os.path.join(ROOT, "target", "release", "denavit"))
DATA = os.path.abspath(sys.argv[1]) if len(sys.argv) > 1 else sys.exit(__doc__)
PLACE = tempfile.mkdtemp()


def robot(name, change=lambda text: text):
    path = os.path.join(PLACE, name + ".yaml")
    with open(os.path.join(ROOT, "robots", name + ".yaml")) as file, open(path, "w") as out:
        out.write(change(file.read()))
    return path


def parts(path, left_out, stem):
    """Two logs: the rows at whose times `left_out` is false, and those at which it is true (None: neither). Each stretch has its own `seg`."""
    with open(path) as file:
        head, *lines = file.read().strip().split("\n")
    names = []
    for wanted in (False, True):
        names.append(os.path.join(PLACE, f"{stem}-{wanted}.csv"))
        with open(names[-1], "w") as out:
            out.write(head + ",seg\n")
            segment, last = 0, None
            for line in lines:
                now = left_out(float(line.split(",", 1)[0]))
                segment += now == wanted and last != wanted
                last = now
                if now == wanted:
                    out.write(f"{line},{segment}\n")
    return [[name] for name in names]


def identify(robot, fit, validate, options):
    command = [DENAVIT, "identify", robot, *fit, "--validate", *validate, "--json", "-", "--most-cost", "1000", *options]
    run = subprocess.run(command, capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    said = json.loads(run.stdout)
    assert said["consistent"]["status"] == "possible", said["consistent"]
    return said


def mean(values):
    return statistics.fmean(v for v in values if v is not None)


def row(*cells):
    print("| " + " | ".join(cells) + " |", flush=True)


CALIBRATION = []


def table(what, robot, splits, options=()):
    held_out, better = [], []
    for fit, validate in splits:
        said = identify(robot, fit, validate, options)
        bodies = said["consistent"]["rms"]
        held_out.append([mean(v) for v in (said["rms"]["validate"], bodies["validate_possible"], bodies["validate"])])
        against = said["consistent"]["against_plain"]
        better.append((against["validate"] or {}).get("better", "open"))
        if len(splits) == 1:
            for where in ("validate", "left_out"):
                if against[where]:
                    low, high = against[where]["interval"]
                    print(f"<!-- {what}: {where} {against[where]['percent']:+.1f} % ({low:+.1f} to {high:+.1f}) -->")
        for announced, here, there in zip(said["carry_over"]["ratio"], said["rms"]["fit"], said["rms"]["validate"]):
            if here and there:
                CALIBRATION.append((math.inf if announced is None else announced, there / here))
    columns = [statistics.fmean(c) for c in zip(*held_out)]
    share = lambda k: f"{100 * (columns[k] / columns[0] - 1):+.1f} %"
    worst = lambda k: f"{100 * (max(h[k] / h[0] for h in held_out) - 1):+.0f} %"
    row(what, str(len(held_out)), *(f"{c:.3f}" for c in columns), share(1), share(2), worst(1), worst(2), "/".join(str(better.count(b)) for b in ("bodies", "open", "plain")))


def log(*path):
    return os.path.join(DATA, *path)


row("log, splits", "fits", "plain", "possible", "with prior", "possible", "with prior", "worst split", "with prior", "told: bodies/open/plain")
row(*["---"] * 10)

lwr = robot("kuka-lwr4", lambda text: re.sub(r"(coulomb_friction: [0-9.]+) \}", r"\1, offset: 0 }", text))
run, period, end = log("kuka-lwr4plus", "traj1.csv"), 4 * math.pi, 24.63
table("LWR 4+, the same motion again (15 s, 9.6 s)", lwr, [parts(run, lambda t: None if t > end else t >= 15, "lwr")])
for k in (4, 5, 6, 8):
    block = lambda b: (lambda t: None if t > end else int(k * (t / period % 1)) == b)
    table(f"LWR 4+, {k} blocks of the period", lwr, [parts(run, block(b), f"lwr-{b}") for b in range(k)])

tx40, run = robot("staubli-tx40"), log("staubli-tx40", "exciting_train.csv")
table("TX40, 3.5 s and 2.2 s", tx40, [parts(run, lambda t: t >= 3.5, "tx")])
for k in (4, 5, 8):
    block = lambda b: (lambda t: int(k * t / 5.75) == b)
    table(f"TX40, {k} blocks", tx40, [parts(run, block(b), f"tx-{b}") for b in range(k)])

GEAR = "gear_coupling: { joint: 5, KC: 1, IAM: 0.0077, FVM: 0.616, FCM: 1.956 }, "


def with_gear(text):
    """The wrist's gear, which the file lacks."""
    at = text.index("drive: {", text.index("name: J6")) + len("drive: {")
    return text[:at] + " " + GEAR + text[at:].lstrip()


def with_rotors(text):
    """And the rotors that it lacks: those of joints 1, 2 (where base parameters hold them too) and 6."""
    return re.sub(r"drive: \{ (?!rotor)", "drive: { rotor_inertia: 0, ", text)


for what, change in [("gear", with_gear), ("gear, rotors", lambda text: with_rotors(with_gear(text)))]:
    other = robot("staubli-tx40", change)
    table(f"TX40 with {what}, 3.5 s and 2.2 s", other, [parts(run, lambda t: t >= 3.5, "tx")])
    for k in (4, 5, 8):
        block = lambda b: (lambda t: int(k * t / 5.75) == b)
        table(f"TX40 with {what}, {k} blocks", other, [parts(run, block(b), f"tx-{b}") for b in range(k)])

names = ["chirp_j2", "chirp_j5j6j7", "chirp_j6", "motion_j2toj7", "motion_j3j4"]
logs = {name: log("kuka-iiwa14", name + ".csv") for name in names}
late = ["--delay", "0.04"]
some = ["chirp_j2", "chirp_j5j6j7", "motion_j2toj7"]
iiwa = robot("kuka-iiwa14")
table("iiwa 14, three logs and two", iiwa, [([logs[n] for n in some], [logs[n] for n in names if n not in some])], late)
table("iiwa 14, one log left out", iiwa, [([logs[m] for m in names if m != n], [logs[n]]) for n in names], late)

gen3 = robot("kinova-gen3")
two = [[log("kinova-gen3", name + ".csv")] for name in ("optitraj1", "sync7_run")]
table("Gen3, `optitraj1` and `sync7_run`", gen3, [two], ["--keep", "dead-torque"])
table("Gen3, either log", gen3, [two, two[::-1]], ["--keep", "dead-torque"])

print("\nWhat is announced before validation, joint by joint over all of these fits\n")
row("announced uncertainty by residual", "joints", "median of held-out by fitted RMS", "above 2")
row(*["---"] * 4)
for low, high in [(0, 1), (1, 3), (3, 10), (10, 30), (30, math.inf)]:
    there = [ratio for announced, ratio in CALIBRATION if low < announced <= high]
    if there:
        row(f"{low} to {high}", str(len(there)), f"{statistics.median(there):.2f}", f"{100 * sum(r > 2 for r in there) / len(there):.0f} %")
