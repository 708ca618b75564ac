#!/usr/bin/env python3
"""Runs `denavit diagnose` on drawn cases and counts what it names. Answers stay in DIR/NN/answer.json."""
import argparse
import concurrent.futures
import json
import pathlib
import subprocess
import time

# The same thing on such a log under two names: what is hidden, what is said, on which joints, why it is right.
OWN, LAST, FIRST = "the same joint", "the last link", "joint 1"
SAME = [
    ("torque_offset", "asymmetric_friction", OWN, "while it moves, levels that differ by direction are a constant"),
    ("payload", "link_inertia_error", LAST, "a body on the flange adds to the last link's ten parameters"),
    ("link_inertia_error", "payload", LAST, "the same ten columns"),
    ("rotor_inertia", "link_inertia_error", FIRST, "IA1 and ZZ1 are one base parameter"),
    ("link_inertia_error", "rotor_inertia", FIRST, "IA1 and ZZ1 are one base parameter"),
    ("encoder_offset", "geometric_error", OWN, "a zero is the constant theta of its row (DTHETA)"),
]
PLAIN = {"coulomb_friction", "viscous_friction", "torque_offset"}   # no mistake where the effect moves them as well
ALIKE = 0.1   # noise RMS that another single cause may leave, in truth.json, to count as the same on this log


def run(folder, binary, again):
    """Answer of one case, from the file or from the command."""
    answer = folder / "answer.json"
    if answer.exists() and not again:
        return
    command = [binary, "diagnose", "robot.yaml", "fit.csv", "--validate", "validate.csv", "--json", "-"]
    begin = time.monotonic()
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    said = json.loads(done.stdout) if done.returncode == 0 else {"verdict": "failed", "causes": []}
    said |= {"seconds": round(time.monotonic() - begin, 1), "status": done.returncode, "messages": done.stderr}
    answer.write_text(json.dumps(said, indent=1))
    print(f"{folder}: {said['seconds']} s, {said['verdict']}", flush=True)


def same(effect, cause, dof):
    """Does this cause of the answer name this effect of the truth?"""
    true, name, joints = effect["joints"], cause["cause"], cause["joints"]
    if name == effect["cause"]:
        if not true:
            return not joints or len(joints) == dof or name != "time_delay"
        return bool(set(true) & set(joints))
    for hidden, said, where, _ in SAME:
        if (hidden, said) == (effect["cause"], name):
            fits = {OWN: set(true) & set(joints), FIRST: 1 in true + joints and set(true) & set(joints),
                    LAST: set(true + joints) == {dof}}
            if fits[where]:
                return True
    for other, left in effect["alternatives"].items():
        said, *joint = other.split()
        if left <= ALIKE and said == name and (not joint or int(joint[0]) in joints):
            return True
    return False


def part(effect, cause):
    """Is this plain friction that the effect has in it: larger by a fifth before a refit of plain friction?"""
    return cause["cause"] in PLAIN and set(effect["joints"]) & set(cause["joints"]) \
        and effect["without_refit"] > 1.2 * effect["size"]


def grade(truth, answer):
    causes, effects, dof = answer["causes"], truth["effects"], truth["dof"]
    named = [any(same(effect, cause, dof) for cause in causes) for effect in effects]
    extra = [cause for cause in causes
             if not any(same(effect, cause, dof) or part(effect, cause) for effect in effects)]
    first = bool(causes) and any(same(effect, causes[0], dof) for effect in effects)
    return {"first": first, "named": sum(named), "effects": len(effects),
            "extra": sum(cause["cause"] != "unknown" for cause in extra),
            "vague": any(cause["cause"] == "unknown" for cause in extra),
            "alarm": not effects and (bool(causes) or answer["verdict"] != "nothing_wrong"),
            "outside": any(effect["cause"] == "unknown" for effect in effects),
            "right": first and all(named) and not extra if effects else
            not causes and answer["verdict"] == "nothing_wrong"}


def summary(label, grades):
    dirty = [g for g in grades if g["effects"]]
    known, clean = [g for g in dirty if not g["outside"]], [g for g in grades if not g["effects"]]
    outside, pairs = [g for g in dirty if g["outside"]], [g for g in known if g["effects"] == 2]
    total = sum(g["effects"] for g in known)
    wrong, vague = (sum(g[key] for g in dirty) for key in ("extra", "vague"))
    print(f"{label:>13}   {sum(g['first'] for g in known):4} of {len(known):3}   {sum(g['named'] for g in known):6} of "
          f"{total:3}   {sum(g['named'] == 2 for g in pairs):4} of {len(pairs):2}   "
          f"{sum(g['first'] for g in outside):3} of {len(outside):2}   {wrong:4} and {vague:3} in {len(dirty):3} cases"
          f"   {sum(g['alarm'] for g in clean):4} of {len(clean):2}")


def describe(folder, truth, answer):
    hidden = ", ".join(f"{e['cause']} {e['joints']} ({e['law']}; {e['size']:.1f}, validate {e['size_validate']:.1f})"
                       for e in truth["effects"]) or "clean"
    alike = {name: left for e in truth["effects"] for name, left in e["alternatives"].items()}
    said = ", ".join(f"{c['cause']} {c['joints']} {c['probability']:.2f}" for c in answer["causes"]) or "none"
    note = " | fails: " + " ".join(answer["messages"].split())[:300] if answer["status"] else ""
    log = f"{truth['arm']}, {truth['rate']} Hz, {'coloured' if truth['colour'] else 'white'} noise"
    print(f"{folder} {log}: {hidden} | said: {said} | {answer['verdict']}"
          f"{' | nearly the same: ' + str(alike) if alike else ''}{note}")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folders", metavar="DIR", type=pathlib.Path, nargs="+")
    parser.add_argument("--binary", type=lambda path: str(pathlib.Path(path).resolve()), required=True)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--again", action="store_true", help="run the command where an answer exists")
    given = parser.parse_args()
    cases = [(folder / f"{truth['case']:02}", truth) for folder in given.folders
             for truth in json.loads((folder / "truth.json").read_text())]
    with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        list(pool.map(lambda case: run(case[0], given.binary, given.again), cases))
    answers = [json.loads((folder / "answer.json").read_text()) for folder, _ in cases]
    grades = [grade(truth, answer) for (_, truth), answer in zip(cases, answers)]
    print("\n  size, noise   right first   effects named   both of 2   outside   wrong, unknown beside   alarms clean")
    for size in sorted({truth["asked"] for _, truth in cases}):
        for kind in ("white", "coloured"):
            summary(f"{size:g} {kind}", [g for (_, truth), g in zip(cases, grades)
                                         if truth["asked"] == size and (truth["colour"] > 0) == (kind == "coloured")])
    summary("all", grades)
    print("\nNot right (or with a further cause):")
    for (folder, truth), answer, mark in zip(cases, answers, grades):
        if not mark["right"]:
            describe(folder, truth, answer)


if __name__ == "__main__":
    main()
