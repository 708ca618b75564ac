#!/usr/bin/env python3
"""Draws robots with a hidden effect: DIR/NN/{robot.yaml,fit.csv,validate.csv} and DIR/truth.json."""
import argparse
import copy
import json
import pathlib

import numpy as np

import effects
from simulate import ROBOTS, Arm, write_yaml

ARMS = ["kuka-lwr4", "kuka-iiwa14", "franka-panda", "ur10e", "kinova-gen3", "puma560", "stanford", "scara"]
LEAD = 1.0             # s before the log begins, in which transients of springs and friction die out
FILE_LIMIT = 0.85      # share of the torque limit that a motion may ask for


# ---- motions -----------------------------------------------------------------------------------------------------

def travel(arm, rng):
    """Middle and half width of the joints' ranges that a motion uses, its top speeds and accelerations."""
    free = np.where(arm.sliding[:, None], [0.2, 0.7], [-1.9, 1.9])
    low, high = np.where(np.isnan(arm.limits), free, np.clip(arm.limits, -3, 4)).T
    half = np.minimum((high - low) / 2 * 0.9, 1.6) * rng.uniform(0.7, 1)
    centre = (low + high) / 2
    middle = rng.uniform(np.maximum(low + half, centre - 0.4), np.minimum(high - half, centre + 0.4))
    speed = np.minimum(np.where(np.isnan(arm.speed), np.where(arm.sliding, 0.4, 1.6), arm.speed), 3)
    return middle, half, 0.75 * speed, np.where(np.isnan(arm.acceleration), 10 * speed / 2, 0.6 * arm.acceleration)


def sines(rng, box, pace, length):
    """Sum of five harmonics of a fundamental near 0.1 Hz."""
    middle, half, speed, acceleration = box
    rate = 2 * np.pi * rng.uniform(0.08, 0.12) * np.arange(1, 6)
    sizes = rng.normal(size=(2, len(middle), 5)) / np.sqrt(np.arange(1, 6))

    def value(t, order):
        turn = rate * t[:, None] + order * np.pi / 2
        return (np.sin(turn) * rate**order) @ sizes[0].T + (np.cos(turn) * rate**order) @ sizes[1].T
    t = np.arange(-LEAD, length, 0.02)
    fit = np.max([np.abs(value(t, 0)).max(0) / half, np.abs(value(t, 1)).max(0) / (pace * speed),
                  np.abs(value(t, 2)).max(0) / (pace * acceleration)], axis=0)
    sizes /= fit[:, None]
    return lambda t: [value(t, 0) + middle, value(t, 1), value(t, 2)]


def moves(rng, box, pace, length):
    """Point-to-point moves of minimal jerk with rests between them."""
    middle, half, speed, acceleration = box
    points, begins, ends, now = [middle], [], [], -LEAD
    while now < length:
        points.append(middle + half * rng.uniform(-1, 1, len(middle)))
        way = np.abs(points[-1] - points[-2])
        time = max(np.max(1.875 * way / (pace * speed)), np.sqrt(np.max(5.78 * way / (pace * acceleration))), 0.4)
        begins.append(now + rng.uniform(0.15, 0.7))
        ends.append(begins[-1] + time)
        now = ends[-1]
    points, begins, ends = np.array(points), np.array(begins), np.array(ends)

    def motion(t):
        i = np.maximum(np.searchsorted(begins, t) - 1, 0)
        time, way = (ends - begins)[i][:, None], points[i + 1] - points[i]
        u = np.clip((t - begins[i])[:, None] / time, 0, 1)
        return [points[i] + way * (10 * u**3 - 15 * u**4 + 6 * u**5), way / time * 30 * (u * (1 - u))**2,
                way / time**2 * 60 * u * (1 - u) * (1 - 2 * u)]
    return motion


class Bench:
    """One recording on the simulation's grid: motion, torques of the unchanged robot, what measures an effect."""
    SERIES = ("t", "q", "dq", "ddq", "load", "sign", "plain", "counts")

    def __init__(self, arm, motion, length, rate, index):
        self.arm, self.rate, self.index = arm, rate, index
        self.t = np.arange(round(-LEAD / effects.STEP), round(length / effects.STEP)) * effects.STEP
        self.q, self.dq, self.ddq = motion(self.t)
        self.load = arm.inverse_dynamics(self.q, self.dq, self.ddq, rotors=False)
        self.sign = effects.yield_state(self.q, np.where(arm.sliding, 1e-5, 3e-5))
        self.drive = arm.rotor * self.ddq + arm.viscous * self.dq + arm.coulomb * self.sign
        self.plain = self.load + self.drive
        self.kept = self.t >= 0
        # Where a joint turns about, friction is no function of the motion: 20 ms on both sides are no part of a size.
        wide = np.ones(round(0.04 / effects.STEP))
        turning = np.abs(self.sign) < 1
        self.counts = np.stack([np.convolve(x, wide, "same") < 0.5 for x in turning.T], axis=1)
        self.recorded = np.flatnonzero(self.kept)[::round(1 / rate / effects.STEP)]

    def torque(self, hidden):
        """Torque before the sensor's noise, given pairs of effect and scale."""
        arm, link, load = self.arm, [self.q, self.dq, self.ddq], self.load
        for effect, scale in hidden:
            arm = effect.arm(arm, scale) if effect.arm else arm
        for effect, scale in hidden:
            link = effect.angle(self, arm, link, scale) if effect.angle else link
        if any(effect.arm or effect.angle for effect, _ in hidden):
            load = arm.inverse_dynamics(*link, rotors=False)
        tau = load + self.drive
        for effect, scale in hidden:
            tau = tau + effect.torque(self, load, scale) if effect.torque else tau
        for effect, scale in hidden:
            tau = effect.record(self, tau, scale) if effect.record else tau
        return tau

    def left(self, error, noise, own=(), columns=()):
        """RMS of the error by joint, in its noise, after a refit of plain friction (and of the columns given)."""
        kept, out = self.recorded[::max(1, self.rate // 100)], []
        for j in range(self.arm.n):
            plain = np.stack([np.ones(len(self.t)), self.sign[:, j], self.dq[:, j]], axis=1)
            weight = self.counts[kept, j] / noise[j]
            A = np.delete(plain, own, axis=1)[kept] * weight[:, None]
            values = np.stack([x[kept, j] for x in [error, *columns]], axis=1) * weight[:, None]
            out.append(values - A @ np.linalg.lstsq(A, values, rcond=None)[0] if A.shape[1] else values)
        if not columns:
            return np.array([rms(x) for x in out])
        whole = np.concatenate(out)
        wide = whole[:, 1:] / np.maximum(np.linalg.norm(whole[:, 1:], axis=0), 1e-9)
        rest = whole[:, 0] - wide @ np.linalg.lstsq(wide, whole[:, 0], rcond=1e-8)[0]
        return np.array([rms(part) for part in np.split(rest, self.arm.n)])


def rms(x):
    return float(np.sqrt(np.mean(np.square(x))))


# ---- what else would say the same --------------------------------------------------------------------------------

def families(b):
    """Columns of other causes, each by itself: what they add to the torques, to first order."""
    arm, motion, only, late = b.arm, (b.q, b.dq, b.ddq), effects.only, np.gradient(b.plain, b.t, axis=0)
    plain, empty = arm.inverse_dynamics(*motion), arm.changed(M=0 * arm.M, MS=0 * arm.MS, I=0 * arm.I)
    turned = [arm.changed(gravity=np.cross(arm.gravity, axis)) for axis in np.eye(3)[:2]]
    names = {"time_delay": [late], "base_tilt": [x.inverse_dynamics(b.q, 0 * b.q, 0 * b.q) for x in turned]}
    for j in range(arm.n):
        body = []
        for field, entry in [("M", ())] + [("MS", (i,)) for i in range(3)] \
                + [("I", (i, k)) for i in range(3) for k in range(i, 3)]:
            unit = np.zeros_like(getattr(arm, field))
            unit[(j, *entry)] = unit[(j, *entry[::-1])] = 1
            body.append(empty.changed(**{field: unit}).inverse_dynamics(*motion, rotors=False))
        zero = (arm.inverse_dynamics(b.q + only(b, j, 1e-4), b.dq, b.ddq) - plain) / 1e-4
        v, own = b.dq[:, j], lambda *columns: [only(b, j, x) for x in columns]
        names |= {f"{name} {j + 1}": columns for name, columns in {
            "link_inertia_error": body, "encoder_offset": [zero], "time_delay": own(late[:, j]),
            "rotor_inertia": own(b.ddq[:, j]), "joint_spring": own(b.q[:, j]), "torque_gain_error": own(b.plain[:, j]),
            "load_dependent_friction": own(b.sign[:, j] * np.abs(b.load[:, j])),
            "asymmetric_friction": own(np.abs(v), 1.0),
            "nonlinear_viscous_friction": own(np.sign(v) * np.sqrt(np.abs(v)), v * np.abs(v))}.items()}
    return names | {"payload": names[f"link_inertia_error {arm.n}"]}


def alternatives(b, error, noise, effect):
    """Other causes that leave less than 0.4 noise RMS of the effect on every joint, and how much."""
    few, thin, out = b.recorded[::max(1, len(b.recorded) // 500)], copy.copy(b), {}
    thin.__dict__.update({key: value[few] for key, value in b.__dict__.items() if key in b.SERIES},
                         rate=1, recorded=np.arange(len(few)))
    for name, columns in families(thin).items():
        left, (said, *joint) = thin.left(error[few], noise, effect.own, columns).max(), name.split()
        own = said == effect.cause and (not joint or not effect.joints or int(joint[0]) - 1 in effect.joints)
        if left < 0.4 and not own:
            out[name] = round(float(left), 3)
    return out


# ---- a case ------------------------------------------------------------------------------------------------------

def robot_with_friction(rng, name):
    """The arm of the file, with drawn friction where the file states none."""
    arm = Arm(ROBOTS / f"{name}.yaml")
    box = travel(arm, rng)
    q, dq, ddq = sines(rng, box, 0.7, 15)(np.arange(0, 15, 0.1))
    scale = np.maximum(np.ptp(arm.inverse_dynamics(q, dq, ddq), axis=0) / 2, 0.02 * np.nan_to_num(arm.torque))
    arm.coulomb = np.where(arm.coulomb > 0, arm.coulomb, scale * rng.uniform(0.02, 0.08, arm.n))
    arm.viscous = np.where(arm.viscous > 0, arm.viscous, scale / box[2] * rng.uniform(0.02, 0.08, arm.n))
    for j, row in enumerate(arm.data["joints"]):
        drive = row.setdefault("drive", {})
        drive["friction"] = {"viscous_friction": f"{arm.viscous[j]:.6g}", "coulomb_friction": f"{arm.coulomb[j]:.6g}"}
    return arm


def record(rng):
    """Arm, two recordings, sensor: a motion whose torques stay within the limits."""
    arm = robot_with_friction(rng, str(rng.choice(ARMS)))
    rate, lengths = int(rng.choice([100, 125, 200, 250, 500, 1000])), rng.uniform(12, 20, 2)
    kinds = list(rng.permutation([sines, moves])) if rng.random() < 0.6 else [sines, sines]
    for pace in [1, 0.8, 0.65, 0.5, 0.4] * 4:
        box = travel(arm, rng)
        benches = [Bench(arm, kind(rng, box, pace, length), length, rate, index)
                   for index, (kind, length) in enumerate(zip(kinds, lengths))]
        if not any(np.any(np.abs(b.plain) > FILE_LIMIT * arm.torque) for b in benches):
            break
    b = benches[0]
    share, colour = rng.uniform(0.003, 0.02), rng.choice([0, rng.uniform(0.2, 0.7)])
    noise = np.maximum(share * np.ptp(b.plain[b.kept], axis=0) / 2, 2e-4 * np.nan_to_num(arm.torque))
    # An encoder whose steps, differentiated within 10 Hz, cost more than the torque sensor's noise would not be fair.
    resolution, mass = 10**rng.uniform(-5, -3.5), np.abs(np.diagonal(arm.mass_matrix(b.q[::3000]), 0, 1, 2)).max(0)
    while resolution > 1e-5 and np.any(mass * resolution / 3.5 * 3950 * np.sqrt(20 / rate / 5) > noise):
        resolution *= 0.7
    sensor = {"rate": rate, "noise_share": share, "noise": noise, "colour": colour, "resolution": resolution,
              "motions": [kind.__name__ for kind in kinds]}
    return arm, benches, sensor


def check_fair(effect, scale, benches, noise, size):
    """ValueError where plain friction takes most of the effect, or where the validating log hardly shows it."""
    errors = [b.torque([(effect, scale)]) - b.plain for b in benches]
    raw = benches[0].left(errors[0], noise, (0, 1, 2)).max()
    shown = benches[1].left(errors[1], noise, effect.own).max()
    if raw > 6 * size or (shown < 0.3 * size and effect.cause != "external_contact"):
        raise ValueError("plain friction takes most of it, or it is in one log alone")


def tune(effect, b, noise, size):
    """Scale at which the effect has the size asked for; ValueError where none within its bounds has."""
    bounded = effect.low > 0 or effect.high <= 1
    scale = np.sqrt(max(effect.low, effect.high / 20) * effect.high) if bounded else 1.0
    for _ in range(14):
        reached = b.left(b.torque([(effect, scale)]) - b.plain, noise, effect.own).max()
        if abs(reached / size - 1) < 0.03:
            return scale
        if reached < 1e-6:
            break
        wanted = scale * np.clip(size / reached, 0.1, 10 if np.isfinite(effect.high) else 1e6)
        if scale in (effect.low, effect.high) and (wanted - scale) * (scale - effect.low - 1e-12) > 0:
            break
        scale = float(np.clip(wanted, effect.low, effect.high))
    raise ValueError("the size is out of reach")


def draw(rng, causes, size):
    """Arm, recordings, sensor and effects with their scales, all drawn again until the sizes are reached."""
    for _ in range(200):
        arm, benches, sensor = record(rng)
        hidden = []
        try:
            for cause in causes:
                effect = cause(rng, benches[0], int(rng.integers(arm.n)))
                if hidden and set(effect.joints) & set(hidden[0][0].joints):
                    raise ValueError("two on one joint would not keep their sizes")
                hidden.append((effect, tune(effect, benches[0], sensor["noise"], size)))
                check_fair(*hidden[-1], benches, sensor["noise"], size)
            return arm, benches, sensor, hidden, [b.torque(hidden) for b in benches]
        except ValueError:
            continue
    raise RuntimeError(f"no fair draw of {[cause.__name__ for cause in causes]}")


def coloured(rng, samples, noise, memory):
    """First-order autoregressive noise of the given deviation."""
    out = rng.normal(size=(samples, len(noise)))
    for i in range(1, samples):
        out[i] = memory * out[i - 1] + np.sqrt(1 - memory**2) * out[i]
    return out * noise


def write_log(path, rng, b, tau, sensor):
    kept, n = b.recorded, b.arm.n
    steps = sensor["resolution"] * np.where(b.arm.sliding, 0.3, 1)
    q = np.round(b.q[kept] / steps + 0.3 * rng.normal(size=(len(kept), n))) * steps
    noisy = tau[kept] + coloured(rng, len(kept), sensor["noise"], sensor["colour"]**(100 / b.rate)
                                 if sensor["colour"] else 0)
    names = ["t"] + [f"q{j + 1}" for j in range(n)] + [f"tau{j + 1}" for j in range(n)]
    np.savetxt(path, np.column_stack([b.t[kept], q, noisy]), delimiter=",", header=",".join(names), comments="",
               fmt=["%.3f"] + ["%.7f"] * n + ["%.7g"] * n)


def truth_of(arm, benches, sensor, hidden, torques):
    sizes = [b.left(tau - b.plain, sensor["noise"]) for b, tau in zip(benches, torques)]
    out = []
    for effect, scale in hidden:
        single = [b.torque([(effect, scale)]) - b.plain for b in benches]
        left = [b.left(error, sensor["noise"], effect.own) for b, error in zip(benches, single)]
        out.append({"cause": effect.cause, "joints": [j + 1 for j in effect.joints], "law": effect.law,
                    "parameters": effect.parameters(scale), "size": float(left[0].max()),
                    "without_refit": float(benches[0].left(single[0], sensor["noise"], (0, 1, 2)).max()),
                    "size_validate": float(left[1].max()), "size_by_joint": left[0].round(2).tolist(),
                    "alternatives": alternatives(benches[0], single[0], sensor["noise"], effect)})
    return {"arm": arm.name, "dof": arm.n, "effects": out,
            "error_over_noise": [x.round(2).tolist() for x in sizes], **sensor}


def plan(rng, cases):
    """Causes of each case: every fifth clean; of the others one in six a pair, one in twelve outside the vocabulary."""
    deck, out, count = [], [], 0

    def card():
        if not deck:
            deck.extend(effects.DRAWS[i] for i in rng.permutation(len(effects.DRAWS)))
        return deck.pop()
    for case in range(cases):
        if case % 5 == 4:
            out.append([])
            continue
        count += 1
        out.append([effects.outside] if count % 12 == 7 else [card()] + ([card()] if count % 6 == 2 else []))
    return out


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("--cases", type=int, required=True)
    parser.add_argument("--size", type=float, required=True, help="RMS of the effect, in RMS of the torque noise")
    parser.add_argument("--out", type=pathlib.Path, required=True)
    given, truth = parser.parse_args(), []
    for number, causes in enumerate(plan(np.random.default_rng(given.seed), given.cases), 1):
        rng = np.random.default_rng([given.seed, number])
        arm, benches, sensor, hidden, torques = draw(rng, causes, given.size)
        folder = given.out / f"{number:02}"
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "robot.yaml").write_text(write_yaml(arm.data))
        for b, tau, name in zip(benches, torques, ("fit.csv", "validate.csv")):
            write_log(folder / name, rng, b, tau, sensor)
        truth.append({"case": number, "asked": given.size, **truth_of(arm, benches, sensor, hidden, torques)})
        print(number, arm.name, *[(e["cause"], e["joints"], round(e["size"], 2), e["alternatives"])
                                  for e in truth[-1]["effects"]], flush=True)
        # numpy's own types do not go into JSON by themselves
        (given.out / "truth.json").write_text(json.dumps(truth, indent=1, default=lambda x: x.tolist()))


if __name__ == "__main__":
    main()
