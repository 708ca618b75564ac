//! The arm as its effects of geometry and bodies say that it is.

use super::laws::shift_zero;
use super::{Angle, Effect, Given, Inertia, Joint, JointKind, Length, NoLink, Robot};
use crate::runtime::Scalar;

/// True zeros, rows, base and links. A change of a link that the file does not know changes
/// nothing.
pub(super) fn as_it_is(robot: &Robot) -> Robot {
    let mut real = robot.clone();
    for (row, effect) in robot.effects_by_row() {
        let given = Given::new(effect, None);
        if effect.name == "encoder_offset" && robot.joints[row].kind != JointKind::Fixed && given.get("QO") != 0.0 {
            shift_zero(&mut real.joints[row], given.get("QO"));
        }
        let _unknown = change(&mut real, Some(row), effect);
    }
    for effect in &robot.effects {
        let _unknown = change(&mut real, None, effect);
    }
    real
}

/// One effect of geometry or bodies, at a joint's row or of the whole robot; any other changes
/// nothing.
pub(super) fn change(real: &mut Robot, row: Option<usize>, effect: &Effect) -> Result<(), NoLink> {
    let given = Given::new(effect, None);
    match (effect.name.as_str(), row) {
        ("geometric_error", Some(row)) => change_row(&mut real.joints[row], &given),
        ("link_inertia_error", _) => {
            let number = given.stated("link");
            let row = number.map_or(row, |number| (number as usize).checked_sub(1));
            let link = row.and_then(|row| real.links.get_mut(row)).and_then(Option::as_mut);
            let link = link.ok_or(NoLink { number, last: real.joints.len() })?;
            *link = link.plus(&link_error(link, &given));
        }
        ("base_tilt", None) => real.gravity = tilted(real.gravity, given.get("roll"), given.get("pitch")),
        ("payload", None) => {
            let last = real.joints.len();
            let link = real.links.last_mut().and_then(Option::as_mut);
            let link = link.ok_or(NoLink { number: Some(last as f64), last })?;
            *link = link.plus(&payload(&given));
        }
        _ => {}
    }
    Ok(())
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

/// What the true link has more than the given one; where no size is written, a fifth of it.
fn link_error(link: &Inertia, given: &Given<'_>) -> Inertia {
    let stated = !given.is_bare() && given.body().iter().any(|p| *p != 0.0);
    Inertia::from_array(if stated { given.body() } else { link.to_array().map(|p| 0.2 * p) })
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

/// Gravity in the axes of a base that is turned by `RotY(pitch) RotX(roll)`: `RotX(-roll)
/// RotY(-pitch) g`.
fn tilted([x, y, z]: [f64; 3], roll: f64, pitch: f64) -> [f64; 3] {
    let ([sr, sp], [cr, cp]) = f64::sin_cos_all(&[roll, pitch]);
    let (x, z) = (cp * x - sp * z, sp * x + cp * z);
    [x, cr * y + sr * z, cr * z - sr * y]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gravity_leans_away_from_the_tilt() {
        let g = tilted([0.0, 0.0, -9.81], 0.1, 0.0);
        assert!(g[0].abs() < 1e-15 && (g[1] + 9.81 * 0.1f64.sin()).abs() < 1e-12, "{g:?}");
        let g = tilted([0.0, 0.0, -9.81], 0.0, 0.1);
        assert!((g[0] - 9.81 * 0.1f64.sin()).abs() < 1e-12 && g[1].abs() < 1e-15, "{g:?}");
    }
}
