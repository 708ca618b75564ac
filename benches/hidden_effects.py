#!/usr/bin/env python3
"""The diagnosis on the 26 cases of an independent simulator: LuGre and Maxwell-slip friction, free play with impacts, hardening springs, one-sided cables,
coupled transmissions, walls. Its code is not here, and its data's README says what each case is. Needs `cargo build --release`:

    benches/hidden_effects.py ../shared/data/hidden-effects [CASE..] [--json RESULTS.json]

DENAVIT names another binary. A case takes some 15 s of one core; two run at a time. What a case has beside its effects (plain friction, rotors and links of a
file that has the geometry alone) counts neither as right nor as false.
"""

import argparse
import concurrent.futures
import json
import os
import subprocess

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
DENAVIT = os.environ.get("DENAVIT", os.path.join(ROOT, "target", "release", "denavit"))


def means(found, effect):
    """Whether a cause that was found is this effect, or one that says the same on these logs."""
    if found["cause"] == effect["cause"]:
        return sorted(found.get("joints") or []) == sorted(effect["joints"]) or found["cause"] == "external_contact"
    same = [e for e in effect["equivalent"] if found["cause"] in e["causes"]]
    return any(sorted(found.get("joints") or []) == sorted(e["joints"]) for e in same)


def diagnosed(folder):
    with open(os.path.join(folder, "truth.json")) as file:
        truth = json.load(file)
    logs = [os.path.join(folder, name) for name in ("fit1.csv.gz", "fit2.csv.gz")]
    command = [DENAVIT, "diagnose", os.path.join(folder, "robot.yaml"), *logs, "--validate", os.path.join(folder, "validate1.csv.gz"), "--json", "-"]
    run = subprocess.run(command, capture_output=True, text=True, env={**os.environ, "RAYON_NUM_THREADS": "1"})
    if run.returncode not in (0, 1):
        raise SystemExit(f"{folder}: {run.stderr}")
    return truth, json.loads(run.stdout)


def judged(truth, said):
    """What was found, and whether it is right."""
    beside = truth["companions"]
    found = [c for c in said["causes"] if c["cause"] not in beside]
    named = [c for c in found if c["cause"] != "unknown"]
    effects = [e for e in truth["effects"] if e["cause"] != "unknown"]
    right = [any(means(c, e) for e in effects) for c in named]
    return {
        "effects": [[e["cause"], e["variant"], e["joints"], round(e["reached"], 1)] for e in truth["effects"]],
        "named": [[c["cause"], c.get("joints"), round(c["probability"], 2), r] for c, r in zip(named, right)],
        "unknown": any(c["cause"] == "unknown" for c in found),
        "first": bool(right) and right[0],
        "all": all(any(means(c, e) for c in named) for e in effects),
        "false": right.count(False),
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("data")
    parser.add_argument("cases", nargs="*")
    parser.add_argument("--json", help="write what was found")
    options = parser.parse_args()
    cases = options.cases or sorted(name for name in os.listdir(options.data) if name.isdigit())
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        answers = pool.map(lambda name: diagnosed(os.path.join(options.data, name)), cases)
        results = {name: judged(truth, said) for name, (truth, said) in zip(cases, answers)}
    for name, result in results.items():
        effects = ", ".join(f"{c}{f' ({v})' if v else ''}{f' on {j}' if j else ''}, {size} times the noise" for c, v, j, size in result["effects"])
        named = ", ".join(f"{'' if right else 'FALSE: '}{c}{f' on {j}' if j else ''} {p}" for c, j, p, right in result["named"])
        print(f"{name}: {effects or 'nothing'} -> {named or ('unknown' if result['unknown'] else 'nothing')}")
    known = [r for r in results.values() if any(e[0] != "unknown" for e in r["effects"])]
    strange = [r for r in results.values() if any(e[0] == "unknown" for e in r["effects"])]
    clean = [r for r in results.values() if not r["effects"]]
    print(f"right cause first {sum(r['first'] for r in known)} of {len(known)}; all causes named {sum(r['all'] for r in known)} of {len(known)}")
    print(f"not in the vocabulary: unknown and nothing else {sum(r['unknown'] and not r['named'] for r in strange)} of {len(strange)}")
    print(f"clean: nothing named {sum(not r['named'] for r in clean)} of {len(clean)}; causes that are false, of all cases: {sum(r['false'] for r in results.values())}")
    if options.json:
        with open(options.json, "w") as file:
            json.dump(results, file, indent=1)


if __name__ == "__main__":
    main()
