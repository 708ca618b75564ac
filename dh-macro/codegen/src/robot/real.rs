//! The arm as its effects of geometry and bodies say that it is.

use super::laws::shift_zero;
use super::{Angle, Given, Inertia, Joint, JointKind, Length, Robot};
use crate::runtime::Scalar;

/// True zeros, rows, base and links.
pub(super) fn as_it_is(robot: &Robot) -> Robot {
    let mut real = robot.clone();
    for (row, effect) in robot.effects_by_row() {
        let given = Given::new(effect, None);
        match effect.name.as_str() {
            "geometric_error" => change_row(&mut real.joints[row], &given),
            "encoder_offset" if robot.joints[row].kind != JointKind::Fixed && given.get("QO") != 0.0 => {
                shift_zero(&mut real.joints[row], given.get("QO"));
            }
            "link_inertia_error" => change_link(&mut real, Robot::link_of(&given, Some(row)), &given),
            _ => {}
        }
    }
    for effect in &robot.effects {
        let given = Given::new(effect, None);
        match effect.name.as_str() {
            "base_tilt" => real.gravity = tilted(real.gravity, given.get("roll"), given.get("pitch")),
            "link_inertia_error" => change_link(&mut real, Robot::link_of(&given, None), &given),
            "payload" => {
                if let Some(last) = real.links.last_mut().and_then(Option::as_mut) {
                    *last = last.plus(&payload(&given));
                }
            }
            _ => {}
        }
    }
    real
}

/// What is not in error stays exact.
fn change_row(joint: &mut Joint, given: &Given<'_>) {
    let angle = |slot: &mut Angle, error: f64| {
        if error != 0.0 {
            *slot = Angle::radians(slot.value + error);
        }
    };
    let length = |slot: &mut Length, error: f64| {
        if error != 0.0 {
            *slot = Length::meters(slot.value + error);
        }
    };
    angle(&mut joint.alpha, given.get("DALPHA"));
    angle(&mut joint.theta, given.get("DTHETA"));
    length(&mut joint.d, given.get("DD"));
    length(&mut joint.r, given.get("DR"));
}

/// The given parameters and these; where no size is written, a fifth of the given.
fn change_link(robot: &mut Robot, row: Option<usize>, given: &Given<'_>) {
    let Some(link) = row.and_then(|row| robot.links.get_mut(row)).and_then(Option::as_mut) else { return };
    let stated = !given.is_bare() && given.body().iter().any(|p| *p != 0.0);
    let error = if stated { given.body() } else { link.to_array().map(|p| 0.2 * p) };
    *link = link.plus(&Inertia::from_array(error));
}

/// A point mass where nothing is said of its tensor.
fn payload(given: &Given<'_>) -> Inertia {
    let mut body = Inertia::from_array(given.body());
    let said = ["XX", "YY", "ZZ", "XY", "XZ", "YZ"].iter().any(|key| given.stated(key).is_some());
    if !given.is_bare() && !said && body.m > 0.0 {
        let [x, y, z] = body.ms;
        body.i = [y * y + z * z, x * x + z * z, x * x + y * y, -x * y, -x * z, -y * z].map(|p| p / body.m);
    }
    body
}

/// Gravity in the axes of a base that is turned by `RotY(pitch) RotX(roll)`: `RotX(-roll) RotY(-pitch) g`.
fn tilted([x, y, z]: [f64; 3], roll: f64, pitch: f64) -> [f64; 3] {
    let ([sr, sp], [cr, cp]) = f64::sin_cos_all(&[roll, pitch]);
    let (x, z) = (cp * x - sp * z, sp * x + cp * z);
    [x, cr * y + sr * z, cr * z - sr * y]
}
