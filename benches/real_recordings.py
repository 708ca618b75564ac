#!/usr/bin/env python3
"""The README's table of real recordings: every robot identified on one part of its recordings and validated on another. Needs `cargo build --release` and
the measured logs:

    benches/real_recordings.py ../shared/data
"""

import json
import os
import re
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
DENAVIT = os.environ.get("DENAVIT", os.path.join(ROOT, "target", "release", "denavit"))
DATA = os.path.abspath(sys.argv[1]) if len(sys.argv) > 1 else sys.exit(__doc__)
PLACE = tempfile.mkdtemp()


def robot(name, change):
    """The robot file with unknowns that it leaves out: `offset: 0` and `rotor_inertia: 0` ask for them."""
    path = os.path.join(PLACE, name + ".yaml")
    with open(os.path.join(ROOT, "robots", name + ".yaml")) as file, open(path, "w") as out:
        out.write(change(file.read()))
    return path


def rotors(text):
    return re.sub(r"drive: \{ (?!rotor)", "drive: { rotor_inertia: 0, ", text)


def cut(path, low, high):
    """The rows from `low` to `high` seconds."""
    out = os.path.join(PLACE, f"{low}-{os.path.basename(path)}")
    with open(path) as file, open(out, "w") as part:
        part.write(file.readline())
        part.writelines(line for line in file if low <= float(line.split(",", 1)[0]) <= high)
    return out


def row(what, robot, fit, validate, options=()):
    command = [DENAVIT, "identify", robot, *fit, "--validate", *validate, "--json", "-", *options]
    run = subprocess.run(command, capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    said = json.loads(run.stdout)
    cells = ["-" if v is None else f"{v:.2f}" if v < 10 else f"{v:.0f}" for v in said["rms"]["validate"]]
    cells += [""] * (7 - len(cells))
    against = (said["consistent"].get("against_plain") or {}).get("validate")
    bodies = "" if not against else "{:+.0f} % ({:+.0f} to {:+.0f})".format(against["percent"], *against["interval"])
    error = said["relative_error_percent"]["validate"]
    print(f"| {what} | {' | '.join(cells)} | {error:.{1 if error < 9.95 else 0}f} % | {bodies} |", flush=True)


def log(*path):
    return os.path.join(DATA, *path)


print("| robot | joint 1 | 2 | 3 | 4 | 5 | 6 | 7 | all joints | bodies against the plain fit, mean over joints |")
print("|" + "---|" * 10)
offsets = lambda text: re.sub(r"(coulomb_friction: [0-9.]+) \}", r"\1, offset: 0 }", text)
run = log("kuka-lwr4plus", "traj1.csv")
row("KUKA LWR 4+, 15 s, then 9.6 s (the same motion again)", robot("kuka-lwr4", lambda t: rotors(offsets(t))), [cut(run, 0, 15)], [cut(run, 15, 24.63)])
iiwa = [os.path.join(ROOT, "data", "kuka-iiwa14", name + ".csv.gz") for name in ("chirp_j2", "chirp_j6", "motion_j2toj7", "motion_j3j4")]
row("KUKA iiwa 14, chirps and moves, then other moves", os.path.join(ROOT, "robots", "kuka-iiwa14.yaml"), iiwa[:3], iiwa[3:], ["--delay", "0.04"])
run = log("staubli-tx40", "exciting_train.csv")
parts = [cut(run, 0, 4.2999)], [cut(run, 4.3, 99)]
row("Staubli TX40, 4.3 s, then 1.45 s, 40 Hz", os.path.join(ROOT, "robots", "staubli-tx40.yaml"), *parts, ["--cutoff", "40"])
gear = "drive: { gear_coupling: { joint: 5, KC: 1, IAM: 0.0077, FVM: 0.616, FCM: 1.956 }, "
coupled = lambda text: rotors(text[: (at := text.index("drive: {", text.index("name: J6")))] + gear + text[at + 8 :])
row("the same with its wrist's gear and all rotors", robot("staubli-tx40", coupled), *parts, ["--cutoff", "40"])
logs = [[log("kinova-gen3", name + ".csv")] for name in ("optitraj1", "sync7_run")]
row("Kinova Gen3, 4.7 s, then another motion", robot("kinova-gen3", rotors), *logs, ["--keep", "dead-torque"])
