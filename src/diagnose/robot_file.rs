//! Writes the findings of a diagnosis into a robot file.

use super::fit::body_limits::completed;
use super::{Cause, Diagnosis, Symbol};
use crate::model::robot_edit::{with_rotors, with_values, without};
use dh_codegen::arm::param::{self, DriveTerm, Inertial, Parameter};
use dh_codegen::robot::effects::{self, Key};
use dh_codegen::robot::{Effect, EffectKind, Inertia, Robot, Term, TorqueLaw};

/// Index of a key among the ten parameters of a body.
fn body_place(key: Key) -> Option<usize> {
    effects::Payload::BODY.iter().position(|which| *which == key)
}

/// The robot with all findings of a diagnosis.
///
/// A diagnosis models its findings as torques at the sensor, as functions of the measured angle.
/// The file's laws act on the true torque and the true angle. If the gain or the encoder offset of
/// a joint was found wrong too, its laws are therefore converted to values before the sensor.
pub fn extended(robot: Robot, found: &Diagnosis) -> Robot {
    let robot = without(robot, &found.forgotten);
    let mut robot = match &found.standard {
        Some(standard) if found.transmission => with_rotors_of(robot, standard),
        Some(standard) if found.links_refitted => {
            // A refit has rotors that the file does not have.
            let robot = with_rotors(robot);
            // Friction is reported separately; the file's own stays unless a cause changes it.
            let names = param::standard(&robot);
            let values: Vec<f64> = names
                .iter()
                .zip(standard)
                .map(|(p, v)| match *p {
                    Parameter::Drive(row, term) if term != DriveTerm::IA => {
                        param::drive_value(&robot, row, term).unwrap_or(0.0)
                    }
                    _ => *v,
                })
                .collect();
            // The values include the present bodies, so these effects are removed.
            let mut robot = with_values(robot, &values);
            let body = |e: &Effect| matches!(e, Effect::Payload(_) | Effect::LinkInertiaError(_));
            robot.effects.retain(|e| !body(e));
            robot.joints.iter_mut().for_each(|joint| joint.drive.effects.retain(|e| !body(e)));
            robot
        }
        _ => robot,
    };
    let moving = robot.moving();
    let of = |effect: EffectKind, row: usize| {
        let here =
            |c: &&Cause| c.cause == effect.name() && c.joints.first().and_then(|j| moving.get(j - 1)) == Some(&row);
        found.causes.iter().filter(|c| c.in_extended).find(here).and_then(|c| c.keys.first()).map(|named| named.value)
    };
    for cause in found.friction.iter().chain(found.causes.iter().filter(|c| c.in_extended)) {
        let row = cause.joints.first().and_then(|j| moving.get(j - 1)).copied();
        let sensor = Sensor {
            gain: row.and_then(|row| of(EffectKind::TorqueGainError, row)).filter(|g| *g != 0.0).unwrap_or(1.0),
            zero: row.and_then(|row| of(EffectKind::EncoderOffset, row)).unwrap_or(0.0),
        };
        if let (Some(row), Some(law)) = (row, &cause.law) {
            write_law(&mut robot, row, law, sensor);
        }
        write_cause(&mut robot, row, &moving, cause, sensor);
    }
    robot
}

/// The robot with the rotor inertias of these standard parameters.
fn with_rotors_of(robot: Robot, standard: &[f64]) -> Robot {
    let mut robot = with_rotors(robot);
    for (parameter, value) in param::standard(&robot).into_iter().zip(standard) {
        if let Parameter::Drive(row, DriveTerm::IA) = parameter {
            robot.joints[row].drive.rotor_inertia = Some(*value);
        }
    }
    robot
}

/// Adds a torque in closed form to a joint's law. Skipped if the file's rules reject it.
fn write_law(robot: &mut Robot, row: usize, law: &str, sensor: Sensor) {
    let kinds = robot.moving_kinds();
    let Ok(found) = TorqueLaw::parse(law, &kinds) else { return };
    let own = match sensor.gain {
        1.0 => found.term().clone(),
        gain => Term::Product(vec![found.term().clone(), Term::Inverse(Box::new(Term::Number(gain)))]),
    };
    let drive = &mut robot.joints[row].drive;
    let sum = match &drive.law {
        Some(known) => Term::Sum(vec![known.term().clone(), own]),
        None => own,
    };
    if let Ok(law) = TorqueLaw::new(&sum, &kinds) {
        drive.law = Some(law);
    }
}

/// Sensor errors of a joint: relation between its laws and the recording.
#[derive(Clone, Copy)]
struct Sensor {
    /// Gain of the torque sensor, `GT`.
    gain: f64,
    /// Offset of the encoder, `QO`, rad.
    zero: f64,
}

/// Keys with a unit of torque per something, which scale with the gain of the sensor.
const SIZES: [Key; 17] = [
    effects::AsymmetricFriction::FCA,
    effects::AsymmetricFriction::FVA,
    effects::NonlinearViscousFriction::FN,
    effects::LoadDependentFriction::FL,
    effects::LoadDependentFriction::FLB,
    effects::PreslidingHysteresis::HC,
    effects::PositionDependentFriction::PC,
    effects::PositionDependentFriction::PS,
    effects::TorqueRipple::RC,
    effects::TorqueRipple::RS,
    effects::JointSpring::KS,
    effects::JointSpring::KQ,
    effects::GearCoupling::IAM,
    effects::GearCoupling::FVM,
    effects::GearCoupling::FCM,
    effects::TorqueOffset::TO,
    effects::StribeckFriction::FS,
];

impl Sensor {
    /// Converts a law's keys to values before the sensor. `coulomb`: the joint's level, N m, which
    /// `FS` includes.
    fn before(self, effect: EffectKind, keys: &mut [(Key, f64)], coulomb: f64) {
        let Self { gain, zero } = self;
        for (key, value) in keys.iter_mut().filter(|(key, _)| SIZES.contains(key)) {
            *value = match (effect, *key) {
                (EffectKind::TorqueOffset, _) => *value, // added after the gain
                (_, effects::StribeckFriction::FS) => coulomb + (*value - coulomb) / gain,
                _ => *value / gain,
            };
        }
        if zero == 0.0 {
            return;
        }
        match effect {
            EffectKind::TorqueRipple => {
                use effects::TorqueRipple as Keys;
                turn(keys, [Keys::RN, Keys::RC, Keys::RS], zero)
            }
            EffectKind::PositionDependentFriction => {
                use effects::PositionDependentFriction as Keys;
                turn(keys, [Keys::PN, Keys::PC, Keys::PS], zero)
            }
            EffectKind::JointSpring => change(keys, effects::JointSpring::QS, |rest| *rest += zero),
            _ => {}
        }
    }
}

/// Value of a key; `None` if it is absent.
fn value_of(keys: &[(Key, f64)], wanted: Key) -> Option<f64> {
    keys.iter().find(|(key, _)| *key == wanted).map(|(_, value)| *value)
}

/// Changes the value of a key, if it is present.
fn change(keys: &mut [(Key, f64)], wanted: Key, by: impl Fn(&mut f64)) {
    keys.iter_mut().filter(|(key, _)| *key == wanted).for_each(|(_, value)| by(value));
}

/// Rotates the coefficients of `c cos(n q) + s sin(n q)` to an angle that is larger by `zero`.
fn turn(keys: &mut [(Key, f64)], [order, cosine, sine]: [Key; 3], zero: f64) {
    let of = |key: Key, default: f64| value_of(keys, key).unwrap_or(default);
    let (n, c, s) = (of(order, 1.0), of(cosine, 0.0), of(sine, 0.0));
    let (sin, cos) = (n * zero).sin_cos();
    change(keys, cosine, |value| *value = c * cos - s * sin);
    change(keys, sine, |value| *value = c * sin + s * cos);
}

/// Converts the values found for an effect to the conventions of the file.
fn in_terms_of_the_file(
    robot: &Robot,
    row: Option<usize>,
    moving: &[usize],
    cause: &Cause,
    kind: EffectKind,
    keys: &mut Vec<(Key, f64)>,
) {
    use effects::JointSpring as Spring;
    let drive = row.map(|row| &robot.joints[row].drive);
    match kind {
        EffectKind::GearCoupling => {
            if let Some(other) = cause.joints.get(1).and_then(|j| moving.get(j - 1)) {
                keys.insert(0, (effects::GearCoupling::JOINT, (other + 1) as f64));
            }
        }
        // While the joint moves, half a difference of the Coulomb levels is an offset.
        EffectKind::AsymmetricFriction => {
            let offset = keys.iter_mut().filter(|(key, _)| *key == effects::TorqueOffset::TO);
            offset.for_each(|(key, _)| *key = effects::AsymmetricFriction::FCA);
        }
        // The spring's rest position replaces the whole offset; the file's own part of the offset
        // stays in the file.
        EffectKind::JointSpring if !keys.iter().any(|(key, _)| [Spring::SIDE, Spring::KQ].contains(key)) => {
            let own = drive.and_then(|d| d.offset).unwrap_or(0.0);
            let stiffness = value_of(keys, Spring::KS).unwrap_or(0.0);
            if stiffness != 0.0 {
                change(keys, Spring::QS, |rest| *rest += own / stiffness);
            }
        }
        // Without an inertia tensor, the file would treat the mass as a point mass.
        EffectKind::Payload if !keys.iter().any(|(key, _)| body_place(*key) >= Some(Inertial::XX as usize)) => {
            keys.push((effects::Payload::XX, 0.0))
        }
        // A joint's delay is counted from zero, and the file adds it to the common one; the common
        // delay is counted on the first joint.
        EffectKind::TimeDelay => {
            let delay = |e: &Effect| if let Effect::TimeDelay(e) = e { e.delay } else { None };
            let first = moving.first().map(|row| robot.joints[*row].drive.effects.iter());
            let other = match row {
                Some(_) => robot.effects.iter().find_map(delay),
                None => first.and_then(|mut effects| effects.find_map(delay)),
            };
            change(keys, effects::TimeDelay::TD, |late| *late -= other.unwrap_or(0.0));
        }
        _ => {}
    }
}

/// Adds the found value to a drive's non-zero offset: an effect with the same constant would be a
/// second, redundant parameter. Returns whether this was done.
fn corrects_offset(robot: &mut Robot, row: Option<usize>, keys: &[(Key, f64)], gain: f64) -> bool {
    let Some(drive) = row.map(|row| &mut robot.joints[row].drive) else { return false };
    let given = drive.effects.iter().any(|e| e.kind() == EffectKind::TorqueOffset);
    match (drive.offset.filter(|own| *own != 0.0 && !given), value_of(keys, effects::TorqueOffset::TO)) {
        (Some(own), Some(found)) => {
            drive.offset = Some(own + found / gain);
            true
        }
        _ => false,
    }
}

/// Adds to a link's parameters. Unidentifiable ones are completed to a possible body.
fn write_link(robot: &mut Robot, row: usize, more: &[(Key, f64)]) {
    let given = robot.links.get(row).copied().flatten().map_or([0.0; 10], Inertia::to_array);
    let added: Vec<(usize, f64)> = more.iter().filter_map(|(key, by)| Some((body_place(*key)?, *by))).collect();
    let mut values = given;
    added.iter().for_each(|(at, by)| values[*at] += by);
    if !more.is_empty() && row < robot.links.len() {
        let which: Vec<usize> = added.iter().map(|(at, _)| *at).collect();
        robot.links[row] = Some(Inertia::from_array(completed(&given, &values, &which).unwrap_or(values)));
    }
}

fn write_cause(robot: &mut Robot, row: Option<usize>, moving: &[usize], cause: &Cause, sensor: Sensor) {
    // A structure that no effect explains cannot be written.
    let Some(kind) = EffectKind::of(cause.cause) else { return };
    let mut left: Vec<(Key, f64)> = Vec::new();
    for named in &cause.keys {
        // Other values are written to the comments and the JSON.
        let Symbol::Key(key) = named.symbol else { continue };
        match (key, row.map(|row| &mut robot.joints[row].drive)) {
            (effects::ViscousFriction::FV, Some(drive)) => drive.viscous_friction = Some(named.value),
            (effects::CoulombFriction::FC, Some(drive)) => drive.coulomb_friction = Some(named.value),
            (effects::RotorInertia::IA, Some(drive)) if kind == EffectKind::RotorInertia => {
                drive.rotor_inertia = Some(named.value)
            }
            _ => left.push((key, named.value)),
        }
    }
    if kind == EffectKind::LinkInertiaError {
        if let Some(row) = row {
            write_link(robot, row, &left);
        }
        return;
    }
    if left.is_empty() {
        return;
    }
    in_terms_of_the_file(robot, row, moving, cause, kind, &mut left);
    let drive = row.map(|row| &robot.joints[row].drive);
    sensor.before(kind, &mut left, drive.and_then(|d| d.coulomb_friction).unwrap_or(0.0));
    if kind == EffectKind::TorqueOffset && corrects_offset(robot, row, &left, sensor.gain) {
        return;
    }
    // A cause may list levels beside its own keys.
    left.retain(|(key, _)| kind.description().key(key.name()).is_some());
    if left.is_empty() {
        return;
    }
    // A coupling without its other joint cannot be written.
    let Ok(effect) = Effect::of_kind(kind, &left) else { return };
    let effects = match row {
        Some(row) => &mut robot.joints[row].drive.effects,
        None => &mut robot.effects,
    };
    match (effects.iter_mut().find(|e| e.kind() == kind), effect) {
        // A second law of the same joint: its keys are numbered.
        (Some(Effect::TorqueRipple(known)), Effect::TorqueRipple(more)) => known.extend(more),
        (Some(Effect::NonlinearViscousFriction(known)), Effect::NonlinearViscousFriction(more)) => known.extend(more),
        (Some(Effect::ExternalContact(known)), Effect::ExternalContact(more))
            if (known.stiffness() > 0.0) != (more.stiffness() > 0.0) =>
        {
            *known = known.beside(more)
        }
        (Some(known), effect) => *known = effect,
        (None, effect) => effects.push(effect),
    }
}
