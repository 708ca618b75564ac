#!/usr/bin/env python3
"""Runs `denavit diagnose` on the logs of cases.py, altered and untouched, and counts what it names."""
import argparse
import json
import pathlib
import subprocess
import time

PLAIN = {"coulomb_friction", "viscous_friction", "torque_offset"}
FRICTION = {"asymmetric_friction", "stribeck_friction", "nonlinear_viscous_friction", "load_dependent_friction",
            "position_dependent_friction", "presliding_hysteresis", "gear_coupling"}
# What docs/diagnose.md, "Causes that can't be separated", says of a cause at a joint: true cause -> what may be said.
OWN = {
    "torque_offset": {"asymmetric_friction", "joint_spring"},
    "coulomb_friction": {"asymmetric_friction"},
    "viscous_friction": {"asymmetric_friction", "time_delay"},
    "asymmetric_friction": PLAIN,
    "time_delay": {"viscous_friction"},
    "joint_spring": {"torque_offset"},
}
BODIES = {"payload", "link_inertia_error"}     # of the last link: the same ten columns
FIRST = {"rotor_inertia", "link_inertia_error"}   # of joint 1: one base parameter


def run(folder, robot, fit, validate, given):
    """The answer of a folder, from its answer.json or from the command."""
    answer = folder / "answer.json"
    if given.again or not answer.exists():
        held_out = ["--validate", *validate] if validate else []
        command = [given.binary, "diagnose", robot, *fit, *held_out, "--json", "-"]
        begin = time.monotonic()
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
        said = json.loads(done.stdout) if done.stdout.startswith("{") else {"verdict": "failed", "causes": []}
        said |= {"seconds": round(time.monotonic() - begin, 1), "status": done.returncode, "messages": done.stderr,
                 "command": " ".join(["denavit", *command[1:-2]])}
        answer.write_text(json.dumps(said, indent=1))
        print(f"{folder}: {said['seconds']} s, {said['verdict']}", flush=True)
    return json.loads(answer.read_text())


def same(a, b):
    """One cause in two lists: its joints overlap."""
    return a["cause"] == b["cause"] and (a["joints"] == b["joints"] or bool(set(a["joints"]) & set(b["joints"])))


def right(truth, cause):
    """The cause itself, on its joint."""
    joints = set(truth["joints"]) or set(range(1, truth["dof"] + 1))
    return cause["cause"] == truth["cause"] and (not cause["joints"] or bool(joints & set(cause["joints"]))) \
        and (bool(cause["joints"]) or not truth["joints"])


def equivalent(truth, cause):
    """What the documentation says can't be told from the cause."""
    own, last = set(truth["joints"]) & set(cause["joints"]), truth["dof"]
    names = {truth["cause"], cause["cause"]}
    if names <= BODIES:
        return set(truth["joints"] + cause["joints"]) <= {last}
    if names <= FIRST:
        return own == {1}
    return bool(own) and cause["cause"] in OWN.get(truth["cause"], ())


def beside(truth, cause):
    """Plain friction on the joint of a law of friction: a part of the law."""
    return truth["cause"] in FRICTION and cause["cause"] in PLAIN and bool(set(truth["joints"]) & set(cause["joints"]))


def sizes(truth, cause):
    """Deviations from the truth, in standard deviations, of the parameters that both have."""
    return {key: round((cause["parameters"][key] - value) / max(cause["parameters_std"][key], 1e-12), 1)
            for key, value in truth["parameters"].items()
            if key in cause["parameters"] and cause["parameters_std"].get(key) is not None}


def grade(truth, answer, untouched):
    new = [c for c in answer["causes"] if not any(same(c, old) for old in untouched["causes"])]
    known, wrong = [c for c in new if c["cause"] != "unknown"], []
    true = [c for c in known if right(truth, c) or equivalent(truth, c)]
    own = next((c for c in true if right(truth, c)), None)
    for c in known:
        if c not in true and not beside(truth, c):
            wrong.append(c)
    first = known[0] if known else None
    return {"counts": not any(right(truth, old) for old in untouched["causes"]),
            "first": first in true if first else False, "itself": own is not None,
            "joint": bool(first) and (not truth["joints"] and first in true
                                      or bool(set(truth["joints"]) & set(first["joints"]))),
            "named": any(c["probability"] > 0.5 for c in true), "off": sizes(truth, own) if own else {},
            "false": [brief(c) for c in wrong], "said": [brief(c) for c in new], "unknown": len(new) > len(known)}


def brief(cause):
    joints = f" {cause['joints']}" if cause["joints"] else ""
    return f"{cause['cause']}{joints} {cause['probability']:.2f}"


def table(title, rows, key):
    print(f"\n{title:28} cases   first   joint   named   itself   size in 3 std   false a case")
    for value in [*sorted({key(truth) for truth, _ in rows}), "all"]:
        grades = [g for truth, g in rows if value in (key(truth), "all")]
        n, sized = len(grades), [max(map(abs, g["off"].values())) <= 3 for g in grades if g["off"]]
        first, joint, named, itself = (sum(g[k] for g in grades) for k in ("first", "joint", "named", "itself"))
        print(f"{value!s:28} {n:5} {first:7} {joint:7} {named:7} {itself:8}   {sum(sized):6} of {len(sized):2}   "
              f"{sum(len(g['false']) for g in grades) / n:12.2f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", metavar="DIR", type=pathlib.Path)
    parser.add_argument("--binary", type=lambda path: str(pathlib.Path(path).resolve()), required=True)
    parser.add_argument("--again", action="store_true", help="run the command where an answer exists")
    given, rows = parser.parse_args(), []
    truths = json.loads((given.folder / "truth.json").read_text())
    base = {}
    for truth in truths:
        if truth["arm"] not in base:
            folder = given.folder / "base" / truth["arm"]
            base[truth["arm"]] = run(folder, "robot.yaml", truth["fit"], truth["validate"], given)
        folder = given.folder / f"{truth['case']:02}"
        answer = run(folder, f"../base/{truth['arm']}/robot.yaml", truth["fit"], truth["validate"], given)
        rows.append((truth, grade(truth, answer, base[truth["arm"]]) | {k: answer[k] for k in ("command", "seconds")}))
    with open(given.folder / "results.jsonl", "w") as file:
        file.writelines(json.dumps(truth | g) + "\n" for truth, g in rows)
    fair = [row for row in rows if row[1]["counts"]]
    table("size, residuals", fair, lambda truth: truth["size"])
    table("cause", fair, lambda truth: truth["cause"])
    table("arm", fair, lambda truth: truth["arm"])
    print(f"\nNot counted, since the untouched log has the cause: {[t['case'] for t, g in rows if not g['counts']]}")
    print("\nMissed, or with another cause:")
    for truth, g in fair:
        if not g["first"] or g["false"]:
            print(f"{truth['case']:02} {truth['arm']}: {truth['cause']} {truth['joints']} ({truth['form']}), "
                  f"{truth['size']:g} residuals, least squares finds {truth['recovered']} of it"
                  f" | said: {', '.join(g['said']) or 'nothing new'}"
                  f"\n   cd {given.folder.resolve()}/{truth['case']:02} && {g['command']}")


if __name__ == "__main__":
    main()
