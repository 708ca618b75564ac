#!/usr/bin/env python3
"""What the diagnosis says of recorded robots with the files of their makers, as a table. Needs `cargo build --release` and the measured logs:

    benches/real_diagnoses.py ../shared/data [DENAVIT]
"""

import json
import os
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
DATA = os.path.abspath(sys.argv[1]) if len(sys.argv) > 1 else sys.exit(__doc__)
DENAVIT = os.path.abspath(sys.argv[2]) if len(sys.argv) > 2 else os.path.join(ROOT, "target", "release", "denavit")
PLACE = tempfile.mkdtemp()
IIWA = ["chirp_j2", "chirp_j6", "motion_j2toj7"]
# Name, robot file, fitted logs, validating logs (none: the last three tenths of the fitted ones), options.
RUNS = [
    ("KUKA iiwa 14, three logs; on motion of joints 3 and 4", "kuka-iiwa14", IIWA, ["motion_j3j4"], []),
    ("Staubli TX40, a file without links", "staubli-tx40", ["exciting_train"], [], []),
    ("KUKA LWR 4+", "kuka-lwr4plus", ["traj1"], [], []),
    ("Kinova Gen3, sensor behind the gear", "kinova-gen3", ["optitraj1"], [], []),
    ("Kinova Gen3, motor current", "kinova-gen3", ["optitraj1"], [], ["--torque", "taum"]),
    ("Franka Panda, 30 Hz", "franka-panda", ["exciting"], [], []),
]
FILES = {"kuka-lwr4plus": "kuka-lwr4"}


def mean(errors):
    """Root mean square over joints, N m."""
    return (sum(e * e for e in errors) / len(errors)) ** 0.5


def words(cause):
    joints = ", ".join(map(str, cause["joints"]))
    return f"{cause['law'] if cause.get('law') else cause['cause']} {f'[{joints}] ' if joints else ''}{cause['probability']:.2f}"


def main():
    print("| robot | file | refitted | extended | in the offered model | suspected beside it |")
    print("|---|---|---|---|---|---|")
    for name, arm, fit, validate, options in RUNS:
        logs = [[os.path.join(DATA, arm, f"{log}.csv") for log in part] for part in (fit, validate)]
        robot = os.path.join(ROOT, "robots", f"{FILES.get(arm, arm)}.yaml")
        out = os.path.join(PLACE, "said.json")
        command = [DENAVIT, "diagnose", robot, *logs[0], *(["--validate", *logs[1]] if logs[1] else []), "--json", out, *options]
        run = subprocess.run(command, capture_output=True, text=True)
        if run.returncode not in (0, 1) or not os.path.exists(out):
            sys.exit(run.stderr)
        with open(out) as file:
            said = json.load(file)
        rms = [f"{mean(said[model]['rms']['validate']):.2f}" for model in ("baseline", "refitted", "extended")]
        causes = [[words(c) for c in said["causes"] if c["in_extended"] == inside] for inside in (True, False)]
        print(f"| {name} | {' | '.join(rms)} | {' | '.join('; '.join(part) or '-' for part in causes)} |", flush=True)
        os.remove(out)


if __name__ == "__main__":
    main()
