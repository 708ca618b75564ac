"""Advisories of RustSec on the packages of our locks, for scripts/supply: read from an excerpt, compared, written from the database.

The database is on GitHub, which CI can't reach; so the excerpt is committed, with the date of the database it was made from.
"""

import re
import subprocess
import textwrap
import tomllib
from datetime import date
from pathlib import Path

EXCERPT = Path(__file__).resolve().parent / "advisories.txt"
HEAD = """\
# What RustSec's database (https://github.com/rustsec/advisory-db, dedicated to the public domain: CC0-1.0) says of the packages in the
# three locks: an excerpt of ids and versions, without texts and without what was withdrawn. scripts/supply compares; `scripts/supply
# --advisories DIR` writes this file anew from a checkout of the database. Requirements are Cargo's: commas are and, `or` is or. A version
# that is neither patched nor unaffected is affected. What was published after `state` is not here.
"""
NONE = "\n# Looked up, and without an advisory.\n"
DAYS = 180  # old enough for a hint
LINE = re.compile(r"(RUSTSEC-\d{4}-\d{4}) (\S+): (\w+); patched ([^;]+)(?:; unaffected ([^;]+))?")
FRONT = re.compile(r"^```toml$(.*?)^```$", re.MULTILINE | re.DOTALL)
VERSION = re.compile(r"(\d+)(?:\.(\d+))?(?:\.(\d+)(?:-([0-9A-Za-z.-]+))?)?(?:\+[0-9A-Za-z.-]+)?")
RELEASE, FIRST = (1,), (0,)  # after all pre-releases of its numbers; before all of them


def parts(text):
    """The numbers of a version, as many as it has, and what orders its pre-release."""
    if not (found := VERSION.fullmatch(text)):
        raise ValueError(f"`{text}` is no version")
    *numbers, pre = found.groups()
    words = [(0, int(word), "") if word.isdigit() else (1, 0, word) for word in pre.split(".")] if pre else []
    return [int(n) for n in numbers if n is not None], (*FIRST, *words) if words else RELEASE


def place(numbers, pre=RELEASE):
    """What orders versions; numbers that are not given are 0."""
    return (*numbers, *[0] * (3 - len(numbers)), pre)


def beyond(numbers):
    """Before all that is greater than every version with these first numbers."""
    return place([*numbers[:-1], numbers[-1] + 1], FIRST)


def span(comparator):
    """The first place that a comparator takes, and the first after it that it doesn't; None where it has no such end."""
    if comparator == "*":
        return None, None
    sign, text = re.fullmatch(r"(>=|<=|[<>=^~]?)\s*(.*)", comparator).groups()
    if not sign:
        sign = "=" if text.endswith(".*") else "^"
    numbers, pre = parts(text.removesuffix(".*").removesuffix(".*"))
    here = place(numbers, pre)
    after = (*here, 0) if len(numbers) == 3 else beyond(numbers)
    # The caret keeps the first number that is not 0, and those before it.
    kept = next((k for k, n in enumerate(numbers) if n), len(numbers) - 1) + 1
    spans = {">=": (here, None), ">": (after, None), "<": (None, here), "<=": (None, after), "=": (here, after)}
    return (spans | {"~": (here, beyond(numbers[:2])), "^": (here, beyond(numbers[:kept]))})[sign]


def meets(version, requirement):
    """Whether a version meets a requirement as Cargo reads it, but for pre-releases, which stand in their order, as RustSec has them."""
    at = place(*parts(version))
    spans = [span(comparator.strip()) for comparator in requirement.split(",")]
    return all((low is None or low <= at) and (high is None or at < high) for low, high in spans)


def read(text):
    """State, advisories by crate (id, kind, patched, unaffected), and the names that were looked up."""
    state, known, names = None, {}, set()
    for k, line in enumerate(text.splitlines(), 1):
        word, _, rest = line.partition(": ")
        if word == "state":
            state = date.fromisoformat(rest)
        elif word == "none":
            names.update(rest.split())
        elif found := LINE.fullmatch(line):
            said, name, kind, patched, unaffected = found.groups()
            ranges = [[] if r in (None, "none") else r.split(" or ") for r in (patched, unaffected)]
            known.setdefault(name, []).append((said, kind, *ranges))
        elif line and not line.startswith("#"):
            raise ValueError(f"line {k} can't be read: {line}")
    if state is None:
        raise ValueError("no line says its state")
    return state, known, names | known.keys()


def affected(locked, known):
    """Locked versions (name, version) with each advisory that they are neither patched for nor unaffected by."""
    for name, version in sorted(locked):
        for said, kind, patched, unaffected in known.get(name, []):
            if not any(meets(version, r) for r in patched + unaffected):
                yield name, version, said, kind, patched


def ignored(deny):
    """The ids that `deny.toml` ignores, with their reasons."""
    entries = [{"id": e} if isinstance(e, str) else e for e in deny.get("advisories", {}).get("ignore", [])]
    return {e["id"]: e.get("reason", "") for e in entries if "id" in e}


def compare(locked, deny):
    """Prints what was compared and gives what is wrong. `locked`: folders by (name, version)."""
    where = f"scripts/{EXCERPT.name}"
    try:
        state, known, names = read(EXCERPT.read_text())
        found = list(affected(locked, known))
    except (OSError, ValueError) as error:
        return [f"{where}: {error}; write it anew: scripts/supply --advisories DIR"]
    reasons, wrong = ignored(deny), []
    for name, version, said, kind, patched in found:
        if said not in reasons:
            mend = f"`cargo update -p {name}` to {' or '.join(patched)}" if patched else "no version is patched: replace it"
            what = f"{', '.join(locked[name, version])}: {name} {version} has {said} ({kind}, https://rustsec.org/advisories/{said})"
            wrong.append(f"{what}; {mend}, or ignore it in deny.toml with a reason")
    met = {said for _, _, said, *_ in found}
    wrong += [f"deny.toml ignores {said} without a reason" for said in reasons if not reasons[said]]
    wrong += [f"deny.toml ignores {said}, which no locked version has by {where}: take it out" for said in reasons if said not in met]
    count = sum(map(len, known.values()))
    print(f"supply: {len(locked)} versions compared with {count} advisories, state {state}; {len(met & reasons.keys())} ignored")
    if missing := sorted({name for name, _ in locked} - names):
        print(f"supply: {len(missing)} not looked up: {', '.join(missing)}")
    if (days := (date.today() - state).days) > DAYS:
        print(f"supply: {where} is {days} days old; write it anew from a checkout of the database: scripts/supply --advisories DIR")
    return wrong


def joined(requirements):
    """Requirements on one line, spaced alike."""
    return " or ".join(", ".join(re.sub(r"\s", "", part) for part in r.split(",")) for r in requirements) or "none"


def line(file):
    """The crate that an advisory names, and its line in the excerpt; None where it was withdrawn."""
    try:
        front = tomllib.loads(FRONT.search(file.read_text())[1])
        said, versions = front["advisory"], front["versions"]
        name, head = said["package"], f"{said['id']} {said['package']}: {said.get('informational', 'vulnerability')}"
        unaffected = f"; unaffected {joined(u)}" if (u := versions.get("unaffected")) else ""
        return None if said.get("withdrawn") else (name, f"{head}; patched {joined(versions['patched'])}{unaffected}")
    except (KeyError, TypeError, ValueError) as error:
        raise SystemExit(f"{file} is no advisory that can be read: {error!r}") from None


def write(folder, names):
    """Writes the excerpt for these crates from a checkout of the database; its state is the date of the last commit there."""
    folder = Path(folder)
    run = subprocess.run(["git", "-C", folder, "log", "-1", "--format=%cs"], capture_output=True, text=True)
    if run.returncode or not (folder / "crates").is_dir():
        raise SystemExit(f"{folder} is no checkout of the database: `git clone https://github.com/rustsec/advisory-db`")
    lines, without = [], []
    for name in sorted(names):
        files = sorted((folder / "crates" / name).glob("RUSTSEC-[1-9]*.md"))
        own = [found[1] for file in files if (found := line(file)) and found[0] == name]
        lines += own
        without += [] if own else [name]
    rows = textwrap.wrap(" ".join(without), 134, break_on_hyphens=False)
    rest = "".join(f"none: {row}\n" for row in rows)
    EXCERPT.write_text(f"{HEAD}state: {run.stdout.strip()}\n" + "".join(f"{own}\n" for own in lines) + NONE + rest)
