#!/usr/bin/env python3
"""Scaling over cores: each command that works with several, on one core and on all, and whether the results are the same.

    benches/cores.py [DENAVIT]     default: target/release/denavit

A simulated KUKA LWR with two hidden effects, 180 s (and 20 minutes) at 500 Hz; 20,000 states and poses. The shared part of the work follows from
the two times (Amdahl), and from it what sixteen cores would give; docs/results/speed.md says where that does not hold.
"""

import hashlib
import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PROGRAM = Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "target/release/denavit").resolve()
ROBOT = ROOT / "robots/kuka-lwr4.yaml"
REPEATS = 3
EFFECTS = """\
joints:
  2: { stribeck_friction: { FS: 6.0, VS: 0.08 } }
  4: { joint_spring: {} }
sensors: { rate: 500, torque_noise: 0.1 }
"""


def run(arguments, here, cores):
    """Seconds by the clock, seconds of processor time."""
    before, begin = os.times(), time.perf_counter()
    limited = ["taskset", "-c", ",".join(map(str, cores)), PROGRAM, *map(str, arguments)]
    done = subprocess.run(limited, cwd=here, capture_output=True, text=True)
    if done.returncode not in (0, 1):
        sys.exit(f"{' '.join(map(str, arguments))}: {done.stderr}")
    after = os.times()
    return time.perf_counter() - begin, sum(after[2:4]) - sum(before[2:4])


def logs(here):
    """Two fitted logs and a validating one, states and poses."""
    for k, (name, periods) in enumerate([("fit", 9), ("validate", 2), ("long", 60)]):
        motion = ["excite", ROBOT, "--fourier", "5", "--duration", "20", "--periods", periods, "--iterations", "5",
                  "--starts", "1", "--seed", str(k + 1), "--rate", "500", "--out", f"{name}_motion.csv"]
        run(motion, here, CORES)
        run(["simulate", ROBOT, "--trajectory", f"{name}_motion.csv", "--effects", "effects.yaml", "--control", "exact", "--out", f"{name}.csv",
             "--seed", str(k + 1)], here, CORES)
    rows = (here / "fit_motion.csv").read_text().splitlines()
    (here / "states.csv").write_text("\n".join(rows[:20_001]) + "\n")
    run(["eval", ROBOT, "--quantity", "forward_kinematics", "--states", "states.csv", "--json", "poses.json"], here, CORES)
    poses = json.loads((here / "poses.json").read_text())["values"]
    header = "r11,r12,r13,px,r21,r22,r23,py,r31,r32,r33,pz"
    (here / "poses.csv").write_text("\n".join([header, *(",".join(map(str, pose[:12])) for pose in poses)]) + "\n")


def commands():
    return {
        "identify, 3 minutes": ["identify", ROBOT, "fit.csv", "--json", "out.json"],
        "identify, 20 minutes": ["identify", ROBOT, "long.csv", "--json", "out.json"],
        "diagnose": ["diagnose", ROBOT, "fit.csv", "--validate", "validate.csv", "--json", "out.json"],
        "excite": ["excite", ROBOT, "--seed", "3", "--starts", "8", "--iterations", "20", "--out", "out.json"],
        "eval": ["eval", ROBOT, "--quantity", "base_regressor", "--states", "states.csv", "--json", "out.json"],
        "ik": ["ik", ROBOT, "--poses", "poses.csv", "--json", "out.json"],
    }


CORES = sorted(os.sched_getaffinity(0))


def main():
    with tempfile.TemporaryDirectory() as folder:
        here = Path(folder)
        (here / "effects.yaml").write_text(EFFECTS)
        logs(here)
        print(f"| | one core, s | {len(CORES)} cores, s | ratio | shared part | 16 cores, reckoned | same result |")
        print("|---|---|---|---|---|---|---|")
        for name, arguments in commands().items():
            times, results = [], set()
            for cores in (CORES[:1], CORES):
                times.append(min(run(arguments, here, cores)[0] for _ in range(REPEATS)))
                results.add(hashlib.sha256((here / "out.json").read_bytes()).hexdigest())
            ratio, n = times[0] / times[1], len(CORES)
            # 1 / ratio = 1 - p + p / n.
            shared = min(max((1 - 1 / ratio) / (1 - 1 / n), 0.0), 1.0) if n > 1 else 0.0
            print(f"| {name} | {times[0]:.2f} | {times[1]:.2f} | {ratio:.2f} | {100 * shared:.0f} % "
                  f"| {1 / (1 - shared + shared / 16):.1f} | {'yes' if len(results) == 1 else 'NO'} |", flush=True)


if __name__ == "__main__":
    main()
