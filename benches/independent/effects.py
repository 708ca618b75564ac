"""Effects that a case may hide. Each is drawn for one joint, grows with one scale, and acts through one or two hooks:
`arm` (another arm), `angle` (the link does not follow the motor), `torque` (added), `record` (on the torque's way
into the log). Joints count from 0 here, from 1 in truth.json; `joints` is empty for the robot as a whole."""
import math
from dataclasses import dataclass, field
from typing import Callable, Optional

import numpy as np

STEP, SUBSTEPS = 1e-3, 4   # s, of the simulation; substeps where motor and link have their own states


@dataclass
class Effect:
    cause: str
    joints: list
    law: str
    low: float
    high: float
    parameters: Callable = lambda s: {}
    arm: Optional[Callable] = None
    angle: Optional[Callable] = None
    torque: Optional[Callable] = None
    record: Optional[Callable] = None
    own: tuple = field(default_factory=tuple)   # columns among offset, Coulomb, viscous that are the effect itself


def yield_state(travel, width):
    """Ideal springs that slip at `width`: from -1 to 1 along the travel (Prandtl's element)."""
    out, state = np.zeros_like(travel), np.zeros(travel.shape[1])
    for i, move in enumerate(np.diff(travel, axis=0, prepend=travel[:1])):
        state = np.minimum(np.maximum(state + move / width, -1), 1)
        out[i] = state
    return out


def bristle_state(travel, width):
    """LuGre's deflection over its final value, exact for the constant speed of one step."""
    out, state = np.zeros(len(travel)), 0.0
    for i, move in enumerate(np.diff(travel, prepend=travel[0])):
        end = math.copysign(1, move)
        state = end + (state - end) * math.exp(-abs(move) / width)
        out[i] = state
    return out


def only(b, j, values):
    out = np.zeros_like(b.q)
    out[:, j] = values
    return out


def added(cause, j, law, shape, own=(), **parameters):
    """Effect whose torque on joint j is the scale times `shape(bench, load)`."""
    return Effect(cause, [j], law, 0, math.inf, lambda s: {"scale": s, **parameters}, own=own,
                  torque=lambda b, load, s: s * only(b, j, shape(b, load)))


# ---- friction ----------------------------------------------------------------------------------------------------

def viscous(rng, b, j):
    return added("viscous_friction", j, "higher level", lambda b, load: b.dq[:, j], own=(2,))


def coulomb(rng, b, j):
    return added("coulomb_friction", j, "higher level", lambda b, load: b.sign[:, j], own=(1,))


def asymmetric(rng, b, j):
    slope, way, top = rng.uniform(1, 3), rng.choice([-1, 1]), np.abs(b.dq[:, j]).max()
    return added("asymmetric_friction", j, "further level and slope in one direction", slope=slope, way=way,
                 shape=lambda b, load: (b.sign[:, j] * way > 0) * (b.sign[:, j] + slope * b.dq[:, j] / top))


def stribeck(rng, b, j):
    speed = rng.uniform(0.03, 0.1) * np.abs(b.dq[:, j]).max()
    return added("stribeck_friction", j, "rational: 1 / (1 + (v/vs)^2)", vs=speed,
                 shape=lambda b, load: b.sign[:, j] / (1 + (b.dq[:, j] / speed)**2))


def nonlinear_viscous(rng, b, j):
    top = np.abs(b.dq[:, j]).max()
    if rng.random() < 0.6:
        knee = rng.uniform(0.08, 0.25) * top
        return added("nonlinear_viscous_friction", j, "levels off: v / sqrt(1 + (v/v0)^2)", v0=knee,
                     shape=lambda b, load: b.dq[:, j] / np.hypot(knee, b.dq[:, j]))
    power = rng.uniform(1.6, 2.4)
    return added("nonlinear_viscous_friction", j, "power", exponent=power,
                 shape=lambda b, load: np.sign(b.dq[:, j]) * np.abs(b.dq[:, j] / top)**power)


def load_dependent(rng, b, j):
    more = rng.uniform(-0.6, 0.6)
    effect = added("load_dependent_friction", j, "|load| (1 + r where it drives)", r=more,
                   shape=lambda b, load: b.sign[:, j] * np.abs(load[:, j])
                   * (1 + more * (load[:, j] * b.dq[:, j] < 0)))
    effect.high = 0.4   # gears lose no more of their load than that
    return effect


def presliding(rng, b, j):
    width = rng.uniform(0.002, 0.012) * (0.3 if b.arm.sliding[j] else 1)   # rad or m
    if rng.random() < 0.5:
        return added("presliding_hysteresis", j, "LuGre", width=width,
                     shape=lambda b, load: bristle_state(b.q[:, j], width))
    parts = width * np.array([0.3, 0.7, 1.2, 2.0])
    return added("presliding_hysteresis", j, "four Maxwell-slip elements", width=width,
                 shape=lambda b, load: yield_state(np.repeat(b.q[:, j, None], 4, 1), parts).mean(axis=1))


def drift(rng, b, j):
    time = rng.uniform(4, 9)
    return added("friction_drift", j, "Coulomb and viscous level fade exponentially", T=time,
                 shape=lambda b, load: np.exp(-np.maximum(b.t, 0) / time)
                 * (b.sign[:, j] + b.dq[:, j] / np.abs(b.dq[:, j]).max()))


def along_travel(rng, b, j):
    span, centre = np.ptp(b.q[:, j]), rng.uniform(*np.quantile(b.q[:, j], [0.2, 0.8]))
    if rng.random() < 0.5:
        return added("position_dependent_friction", j, "worn place (a bell)", centre=centre, width=0.15 * span,
                     shape=lambda b, load: b.sign[:, j] * np.exp(-0.5 * ((b.q[:, j] - centre) / (0.15 * span))**2))
    periods = rng.uniform(1.5, 3)
    return added("position_dependent_friction", j, "wave along the travel", periods=periods,   # and never below zero
                 shape=lambda b, load: b.sign[:, j] * (1 + np.sin(2 * np.pi * periods * (b.q[:, j] - centre) / span)))


# ---- drive and sensors -------------------------------------------------------------------------------------------

def rotor(rng, b, j):
    return added("rotor_inertia", j, "reflected inertia", lambda b, load: b.ddq[:, j])


def ripple(rng, b, j):
    # At top speed the second harmonic stays below a third of the sampling rate and 40 Hz; four periods in the travel.
    most = int(min(b.rate / 3, 40) * 2 * np.pi / (2 * np.abs(b.dq[:, j]).max()))
    least = max(4, math.ceil(4 * 2 * np.pi / np.ptp(b.q[:, j])))
    order = int(rng.integers(least, max(most, least) + 1))
    phase, second = rng.uniform(0, 6.28, 2), rng.uniform(0.2, 0.5)
    return added("torque_ripple", j, "two harmonics", order=order, second=second,
                 shape=lambda b, load: np.sin(order * b.q[:, j] + phase[0])
                 + second * np.sin(2 * order * b.q[:, j] + phase[1]))


def gain(rng, b, j):
    way = rng.choice([-1, 1])
    return Effect("torque_gain_error", [j], "scaled", 0, 0.5, lambda s: {"gain": 1 + way * s},
                  record=lambda b, tau, s: tau + only(b, j, way * s * tau[:, j]))


def offset(rng, b, j):
    return added("torque_offset", j, "constant", lambda b, load: np.ones(len(b.t)), own=(0,))


def saturation(rng, b, j):
    top = np.abs(b.plain[:, j]).max()
    return Effect("torque_saturation", [j], "clipped before the noise", 0.02, 0.7, lambda s: {"limit": (1 - s) * top},
                  record=lambda b, tau, s: tau + only(b, j, np.clip(tau[:, j], -(1 - s) * top, (1 - s) * top)
                                                      - tau[:, j]))


def delay(rng, b, j):
    joints, way = ([] if rng.random() < 0.6 else [j]), rng.choice([-1, 1], p=[0.2, 0.8])

    def record(b, tau, s):
        out = tau.copy()
        for k in joints or range(tau.shape[1]):
            out[:, k] = np.interp(b.t - way * s, b.t, tau[:, k])
        return out
    # From six tenths of a sample to six samples or 40 ms.
    return Effect("time_delay", joints, "torque late" if way > 0 else "motion late", 0.6 / b.rate,
                  max(6 / b.rate, 0.04), lambda s: {"TD": way * s}, record=record)


def coupling(rng, b, j):
    k = int(j - 1 if j == b.arm.n - 1 or (j > 0 and rng.random() < 0.5) else j + 1)
    if rng.random() < 0.5:
        def angle(b, arm, link, s):
            out = [x.copy() for x in link]
            for x, own in zip(out, (b.q, b.dq, b.ddq)):
                x[:, j] += s * own[:, k]
            return out
        return Effect("gear_coupling", [j, k], "link j stands at q_j + s q_k, motor k bears s times its load", 0, 0.5,
                      lambda s: {"ratio": s}, angle=angle, torque=lambda b, load, s: only(b, k, s * load[:, j]))
    way, mass = rng.choice([-1, 1]), 0.3 * b.arm.mass_matrix(b.q[:1])[0, j, j]
    fv, fc = b.arm.viscous[j], b.arm.coulomb[j]

    def torque(b, load, s):
        # Rotor and friction of each joint by itself are the file's; what is hidden is what couples the two.
        turns = yield_state((b.q[:, j] + way * b.q[:, k])[:, None], 3e-5)[:, 0]
        return s * (only(b, j, way * (mass * b.ddq[:, k] + fv * b.dq[:, k]) + fc * turns)
                    + only(b, k, way * (mass * b.ddq[:, j] + fv * b.dq[:, j] + fc * turns)))
    return Effect("gear_coupling", [j, k], "a motor turns with q_j +- q_k", 0, 3,
                  lambda s: {"way": way, "inertia": s * mass, "fv": s * fv, "fc": s * fc}, torque=torque)


# ---- transmission ------------------------------------------------------------------------------------------------

def follow(b, arm, link, j, law, start):
    """Link j behind its motor: motor along the recorded motion, link by its own equation, law(angle, rate) between.

    Its inertia and the rest of its load come from inverse dynamics along the link's motion, which is found by
    repetition over the whole log (waveform relaxation): both change little with the few milliradians of deflection."""
    q, dq, ddq = (x.copy() for x in link)
    motor, h = ddq[:, j].copy(), STEP / SUBSTEPS
    inertia = arm.changed(gravity=np.zeros(3)).inverse_dynamics(q, 0 * q, 0 * q + np.eye(arm.n)[j], False)[:, j]
    weights = [k / SUBSTEPS for k in range(SUBSTEPS)]
    for _ in range(8):
        rest = arm.inverse_dynamics(q, dq, ddq, False)[:, j] - inertia * ddq[:, j]
        drive, forces = (motor + rest / inertia).tolist(), (1 / inertia).tolist()
        shift, angle, rate = np.zeros((3, len(q))), start(drive[0] * inertia[0]), 0.0
        for i in range(len(q)):
            shift[:, i] = angle, rate, drive[i] - law(angle, rate) * forces[i]
            step = drive[min(i + 1, len(q) - 1)] - drive[i]
            for weight in weights:
                rate += h * (drive[i] + weight * step - law(angle, rate) * forces[i])
                angle += h * rate
        change = np.abs(link[0][:, j] - shift[0] - q[:, j]).max()
        q[:, j], dq[:, j], ddq[:, j] = (x[:, j] - y for x, y in zip(link, shift))
        if change < 2e-6:
            return q, dq, ddq
    raise ValueError("the link's motion did not settle")


def typical_inertia(b, j):
    return b.arm.changed(rotor=0 * b.arm.rotor).mass_matrix(b.q[::2000])[:, j, j].mean()


def elasticity(rng, b, j):
    mass, ratio, harder = typical_inertia(b, j), rng.uniform(0.03, 0.15), rng.uniform(0, 0.6)
    load = np.abs(b.load[:, j]).max()

    def angle(b, arm, link, s):
        stiffness = mass * (2 * np.pi * 10)**2 / s
        damping, wind = 2 * ratio * math.sqrt(stiffness * mass), (load / stiffness)**2
        return follow(b, arm, link, j, lambda x, v: stiffness * x * (1 + harder * x * x / wind) + damping * v,
                      lambda torque: torque / stiffness)
    # A link that resonates between 3.5 and 28 Hz.
    return Effect("joint_elasticity", [j], "hardening spring with a damper", (10 / 28)**2, (10 / 3.5)**2,
                  lambda s: {"KE": mass * (2 * np.pi * 10)**2 / s, "frequency": 10 / s**0.5, "ratio": ratio},
                  angle=angle)


def backlash(rng, b, j):
    mass = typical_inertia(b, j)
    stiffness, damping = mass * (2 * np.pi * 55)**2, 2 * 0.2 * mass * 2 * np.pi * 55
    if np.sum(np.diff(np.sign(b.load[b.t >= 0, j])) != 0) < 6:
        raise ValueError("the load hardly changes sides")
    if b.rate < 3 * 55:
        raise ValueError("the impacts would be sampled too rarely")

    def angle(b, arm, link, s):
        def law(x, v):
            if abs(x) < s / 2:
                return 0.0
            force = stiffness * (x - math.copysign(s / 2, x)) + damping * v
            return force if force * x > 0 else 0.0   # a flank pushes and does not pull
        return follow(b, arm, link, j, law, lambda torque: math.copysign(s / 2, torque) + torque / stiffness)
    return Effect("backlash", [j], "gap between stiff, damped flanks: impacts", 0.001, 0.05, lambda s: {"BL": s},
                  angle=angle)


# ---- geometry and bodies -----------------------------------------------------------------------------------------

def zero(rng, b, j):
    way = rng.choice([-1, 1])

    def angle(b, arm, link, s):
        return [link[0] + only(b, j, way * s), *link[1:]]
    return Effect("encoder_offset", [j], "true angle = measured + QO", 0.001, 0.25, lambda s: {"QO": way * s},
                  angle=angle)


def geometry(rng, b, j):
    if j == 0:
        raise ValueError("row 1 is the base's pose")
    column, way = int(rng.choice([0, 1, 3])), rng.choice([-1, 1])
    if column == 3 and b.arm.sliding[j]:
        raise ValueError("that is the zero of a sliding joint")

    def arm(given, s):
        table = given.table.copy()
        table[j, column] += way * s
        return given.changed(table=table)
    return Effect("geometric_error", [j], ["DALPHA", "DD", "", "DR"][column], 0.002, 0.15, lambda s: {"by": way * s},
                  arm=arm)


def tilt(rng, b, j):
    turn = rng.uniform(0, 2 * np.pi)

    def arm(given, s):
        roll, pitch = s * np.cos(turn), s * np.sin(turn)
        base = np.array([[np.cos(pitch), 0, np.sin(pitch)], [0, 1, 0], [-np.sin(pitch), 0, np.cos(pitch)]]) \
            @ np.array([[1, 0, 0], [0, np.cos(roll), -np.sin(roll)], [0, np.sin(roll), np.cos(roll)]])
        return given.changed(gravity=base.T @ given.gravity)
    return Effect("base_tilt", [], "roll and pitch", 0.002, 0.2,
                  lambda s: {"roll": s * np.cos(turn), "pitch": s * np.sin(turn)}, arm=arm)


def about_origin(mass, centre, tensor):
    return tensor + mass * (centre @ centre * np.eye(3) - np.outer(centre, centre))


def with_link(given, j, mass, first, inertia):
    M, MS, I = given.M.copy(), given.MS.copy(), given.I.copy()
    M[j], MS[j], I[j] = mass, first, inertia
    return given.changed(M=M, MS=MS, I=I)


def link(rng, b, j):
    share, shift = rng.choice([-1, 1]) * rng.uniform(0.1, 0.3), rng.normal(0, 0.02, 3)

    def arm(given, s):
        mass, centre = given.M[j], given.MS[j] / given.M[j]
        own, more = given.I[j] - about_origin(mass, centre, np.zeros((3, 3))), 1 + s * share
        return with_link(given, j, more * mass, more * mass * (centre + s * shift),
                         about_origin(more * mass, centre + s * shift, more * own))
    return Effect("link_inertia_error", [j], "mass, centre and tensor", 0.2, 2.5,
                  lambda s: {"mass": s * share * b.arm.M[j], "share": s * share}, arm=arm)


def payload(rng, b, j):
    sides, centre = rng.uniform(0.04, 0.15, 3), np.array([*rng.normal(0, 0.03, 2), rng.uniform(0.04, 0.15)])

    def arm(given, s):
        own = s / 12 * np.diag(np.sum(sides**2) - sides**2)
        return with_link(given, -1, given.M[-1] + s, given.MS[-1] + s * centre,
                         given.I[-1] + about_origin(s, centre, own))
    return Effect("payload", [], "a box", 0.02, 0.5 * b.arm.M.sum(), lambda s: {"M": s, "centre": centre.tolist()},
                  arm=arm)


# ---- surroundings ------------------------------------------------------------------------------------------------

def spring(rng, b, j):
    rest, way = rng.uniform(*np.quantile(b.q[:, j], [0.35, 0.65])), rng.choice([-1, 1])
    if rng.random() < 0.5:
        return added("joint_spring", j, "taut on one side", rest=rest, side=way,
                     shape=lambda b, load: way * np.maximum(way * (b.q[:, j] - rest), 0))
    return added("joint_spring", j, "cubic", rest=rest, shape=lambda b, load: (b.q[:, j] - rest)**3)


def push(rng, b, j):
    way, length, ramp = rng.normal(size=3), rng.uniform(0.8, 2.5), rng.uniform(0.1, 0.3)
    way, start = way / np.linalg.norm(way), rng.uniform(2, b.t[-1] - 4)
    later = rng.random() < 0.5   # the validating log has one too, at another time

    def torque(b, load, s):
        if b.index == 1 and not later:
            return 0 * b.q
        begin = start if b.index == 0 else 0.6 * start
        rise = np.clip(np.minimum(b.t - begin, begin + length - b.t) / ramp, 0, 1)
        return -s * rise[:, None] * np.einsum("ski,k->si", b.arm.tip_jacobian(b.q)[1], way)
    return Effect("external_contact", [], "push with ramps", 0, math.inf, torque=torque,
                  parameters=lambda s: {"force": (s * way).tolist(), "start": start, "end": start + length})


def wall(rng, b, j):
    way = rng.normal(size=3)
    way, share, time = way / np.linalg.norm(way), rng.uniform(0.6, 0.85), rng.uniform(0.01, 0.05)
    place = np.quantile(b.arm.tip_jacobian(b.q)[0] @ way, share)

    def torque(b, load, s):
        tip, jacobian = b.arm.tip_jacobian(b.q)
        depth, rate = tip @ way - place, np.einsum("ski,k,si->s", jacobian, way, b.dq)
        force = np.where(depth > 0, np.maximum(s * (depth + time * rate), 0), 0)
        return force[:, None] * np.einsum("ski,k->si", jacobian, way)
    return Effect("external_contact", [], "wall with damping", 0, math.inf, torque=torque,
                  parameters=lambda s: {"k": s, "normal": way.tolist(), "at": place, "damping": s * time})


def outside(rng, b, j):
    other = int(rng.choice([k for k in range(b.arm.n) if k != j]))
    times, kind = int(rng.integers(1, 4)), rng.integers(3)
    if kind == 0:
        return added("unknown", j, "sin(m q_other) sign(dq)", other=other + 1, times=times,
                     shape=lambda b, load: b.sign[:, j] * np.sin(times * b.q[:, other]))
    if kind == 1:
        return added("unknown", j, "sin(m q_other) dq", other=other + 1, times=times,
                     shape=lambda b, load: b.dq[:, j] * np.sin(times * b.q[:, other]))
    pitch = rng.uniform(1.5, 6)
    return added("unknown", j, "vibration of the floor", frequency=pitch,
                 shape=lambda b, load: np.sin(2 * np.pi * pitch * b.t + 1))


DRAWS = [viscous, coulomb, asymmetric, stribeck, nonlinear_viscous, load_dependent, presliding, drift, along_travel,
         rotor, ripple, gain, offset, saturation, delay, coupling, elasticity, backlash, zero, geometry, tilt, link,
         payload, spring, push, wall]
