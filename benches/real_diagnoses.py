#!/usr/bin/env python3
"""What the diagnosis says of recorded robots with the files of their makers, as a table. Needs `cargo build --release` and the measured logs:

    benches/real_diagnoses.py ../shared/data [DENAVIT] [--excerpts]

`--excerpts`: instead, of three excerpts of each log (its first, last and middle six tenths), whether the causes that one of them names with
more than 0.8 are named on the same joints by the two others.
"""

import json
import os
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
ARGUMENTS = [a for a in sys.argv[1:] if a != "--excerpts"]
DATA = os.path.abspath(ARGUMENTS[0]) if ARGUMENTS else sys.exit(__doc__)
DENAVIT = os.path.abspath(ARGUMENTS[1]) if len(ARGUMENTS) > 1 else os.path.join(ROOT, "target", "release", "denavit")
PLACE = tempfile.mkdtemp()
IIWA = ["chirp_j2", "chirp_j6", "motion_j2toj7"]
# Name, robot file, fitted logs, validating logs (none: the last three tenths of the fitted ones), options.
RUNS = [
    ("KUKA iiwa 14, three logs; on motion of joints 3 and 4", "kuka-iiwa14", IIWA, ["motion_j3j4"], []),
    ("Staubli TX40, a file without links", "staubli-tx40", ["exciting_train"], [], []),
    ("KUKA LWR 4+", "kuka-lwr4plus", ["traj1"], [], []),
    ("Kinova Gen3, sensor behind the gear", "kinova-gen3", ["optitraj1"], [], []),
    ("Kinova Gen3, motor current", "kinova-gen3", ["optitraj1"], [], ["--torque", "taum"]),
    ("Kinova Gen3, motor current less sensor", "kinova-gen3", ["optitraj1"], [], ["--transmission"]),
    ("Franka Panda, 30 Hz", "franka-panda", ["exciting"], [], []),
]
FILES = {"kuka-lwr4plus": "kuka-lwr4"}
# Logs that are long enough for excerpts of three seconds.
LONG = [("staubli-tx40", "exciting_train"), ("kuka-lwr4plus", "traj1"), ("franka-panda", "exciting")]
LONG += [("kuka-iiwa14", log) for log in [*IIWA, "motion_j3j4"]]
EXCERPTS = [(0.0, 0.6), (0.4, 1.0), (0.2, 0.8)]


def mean(errors):
    """Root mean square over joints, N m."""
    return (sum(e * e for e in errors) / len(errors)) ** 0.5


def words(cause):
    joints = ", ".join(map(str, cause["joints"]))
    return f"{cause['law'] if cause.get('law') else cause['cause']} {f'[{joints}] ' if joints else ''}{cause['probability']:.2f}"


def diagnose(arm, fit, validate, options=()):
    robot = os.path.join(ROOT, "robots", f"{FILES.get(arm, arm)}.yaml")
    out = os.path.join(PLACE, "said.json")
    command = [DENAVIT, "diagnose", robot, *fit, *(["--validate", *validate] if validate else []), "--json", out, *options]
    run = subprocess.run(command, capture_output=True, text=True)
    if run.returncode not in (0, 1) or not os.path.exists(out):
        sys.exit(run.stderr)
    with open(out) as file:
        said = json.load(file)
    os.remove(out)
    return said


def excerpt(path, low, high):
    """The rows between two parts of a log. Its clock may restart."""
    with open(path) as file:
        header, *rows = file.readlines()
    first, end = (round(part * len(rows)) for part in (low, high))
    out = os.path.join(PLACE, f"{low}-{os.path.basename(path)}")
    with open(out, "w") as part:
        part.writelines([header, *rows[first:end]])
    return out


def excerpts():
    print("| log | named above 0.8 | in the other excerpts, of |")
    print("|---|---|---|")
    found = asked = 0
    for arm, log in LONG:
        parts = []
        for low, high in EXCERPTS:
            said = diagnose(arm, [excerpt(os.path.join(DATA, arm, f"{log}.csv"), low, high)], [])
            parts.append({(c["cause"], tuple(c["joints"])): c["probability"] for c in said["causes"] if c["cause"] != "unknown"})
        sure = [(k, key) for k, part in enumerate(parts) for key, p in part.items() if p > 0.8]
        again = [key in part for k, key in sure for i, part in enumerate(parts) if i != k]
        names = sorted({f"{cause} {list(joints)}" if joints else cause for _, (cause, joints) in sure})
        print(f"| {arm} {log} | {'; '.join(names) or '-'} | {sum(again)} of {len(again)} |", flush=True)
        found, asked = found + sum(again), asked + len(again)
    print(f"| all | | {found} of {asked} |")


def models():
    print("| robot | file | refitted | extended | in the offered model | suspected beside it |")
    print("|---|---|---|---|---|---|")
    for name, arm, fit, validate, options in RUNS:
        logs = [[os.path.join(DATA, arm, f"{log}.csv") for log in part] for part in (fit, validate)]
        said = diagnose(arm, *logs, options)
        rms = [f"{mean(said[model]['rms']['validate']):.2f}" for model in ("baseline", "refitted", "extended")]
        causes = [[words(c) for c in said["causes"] if c["in_extended"] == inside] for inside in (True, False)]
        print(f"| {name} | {' | '.join(rms)} | {' | '.join('; '.join(part) or '-' for part in causes)} |", flush=True)


if __name__ == "__main__":
    excerpts() if "--excerpts" in sys.argv else models()
