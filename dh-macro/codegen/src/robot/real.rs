//! Applies a robot's effects of geometry and bodies to its description.

use super::effects::{Effect, GeometricError, LinkInertiaError, Payload};
use super::laws::shift_zero;
use super::{Angle, Inertia, Joint, JointKind, Length, NoLink, Robot};
use crate::runtime::Scalar;

/// Robot with effective zeros, rows, base and links. An effect on a link that the file does not
/// define is ignored.
pub(super) fn effective(robot: &Robot) -> Robot {
    let mut real = robot.clone();
    for (row, effect) in robot.effects_by_row() {
        if let Effect::EncoderOffset(e) = effect
            && robot.joints[row].kind != JointKind::Fixed
            && e.offset() != 0.0
        {
            shift_zero(&mut real.joints[row], e.offset());
        }
        let _unknown = change(&mut real, Some(row), effect);
    }
    for effect in &robot.effects {
        let _unknown = change(&mut real, None, effect);
    }
    real
}

/// Applies one effect of geometry or bodies, at a joint's row or of the whole robot; a law of
/// drives or sensors changes nothing.
pub(super) fn change(real: &mut Robot, row: Option<usize>, effect: &Effect) -> Result<(), NoLink> {
    match (effect, row) {
        (Effect::GeometricError(e), Some(row)) => change_row(&mut real.joints[row], e),
        (Effect::LinkInertiaError(e), _) => {
            let row = e.link.map_or(row, |number| number.checked_sub(1));
            let link = row.and_then(|row| real.links.get_mut(row)).and_then(Option::as_mut);
            let link = link.ok_or(NoLink { number: e.link, last: real.joints.len() })?;
            *link = link.plus(&link_error(link, e));
        }
        (Effect::BaseTilt(e), None) => real.gravity = tilted(real.gravity, e.roll(), e.pitch()),
        (Effect::Payload(e), None) => {
            let last = real.joints.len();
            let link = real.links.last_mut().and_then(Option::as_mut);
            let link = link.ok_or(NoLink { number: Some(last), last })?;
            *link = link.plus(&payload(e));
        }
        // At the top it applies to every row, and is applied with each of them.
        (Effect::GeometricError(_), None) => {}
        // These apply to the whole robot, not to a joint.
        (Effect::BaseTilt(_) | Effect::Payload(_), Some(_)) => {}
        (
            Effect::ViscousFriction(_)
            | Effect::CoulombFriction(_)
            | Effect::AsymmetricFriction(_)
            | Effect::StribeckFriction(_)
            | Effect::NonlinearViscousFriction(_)
            | Effect::LoadDependentFriction(_)
            | Effect::PreslidingHysteresis(_)
            | Effect::FrictionDrift(_)
            | Effect::PositionDependentFriction(_)
            | Effect::RotorInertia(_)
            | Effect::TorqueRipple(_)
            | Effect::JointElasticity(_)
            | Effect::Backlash(_)
            | Effect::GearCoupling(_)
            | Effect::TorqueGainError(_)
            | Effect::TorqueOffset(_)
            | Effect::TorqueSaturation(_)
            | Effect::EncoderOffset(_)
            | Effect::JointSpring(_)
            | Effect::ExternalContact(_)
            | Effect::TimeDelay(_),
            _,
        ) => {}
    }
    Ok(())
}

/// Adds the errors to a row; entries without an error stay exact.
fn change_row(joint: &mut Joint, error: &GeometricError) {
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
    angle(&mut joint.alpha, error.alpha());
    angle(&mut joint.theta, error.theta());
    length(&mut joint.d, error.d());
    length(&mut joint.r, error.r());
}

/// Difference between the true link and the given one; if no size is stated, a fifth of the given
/// one.
fn link_error(link: &Inertia, error: &LinkInertiaError) -> Inertia {
    let stated = error.body().iter().any(|p| *p != 0.0);
    Inertia::from_array(if stated { error.body() } else { link.to_array().map(|p| 0.2 * p) })
}

/// Inertia of a payload; a point mass if no tensor is stated.
fn payload(payload: &Payload) -> Inertia {
    let mut body = Inertia::from_array(payload.body());
    if payload.is_point() && body.m > 0.0 {
        let [x, y, z] = body.ms;
        body.i = [y * y + z * z, x * x + z * z, x * x + y * y, -x * y, -x * z, -y * z].map(|p| p / body.m);
    }
    body
}

/// Gravity in the axes of a base rotated by `RotY(pitch) RotX(roll)`: `RotX(-roll) RotY(-pitch) g`.
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
