//! Rejects friction that would do positive work on its joint. Another error then has the same form
//! along the recorded motion, as an offset has along a motion in one direction.

use crate::diagnose::fit::model::{Chosen, Fitted, ModelUnderTest, given_friction};
use crate::diagnose::hypotheses::Kind;

/// Tolerance for friction that appears to drive a joint. For a level: this share of the file's
/// level, or of the noise in N m (for a viscous one: in N m at 1 rad/s). For a law: this share of
/// the work that it dissipates and of the work that the noise can do.
const BELOW: f64 = 0.25;

/// Whether a plain friction level (number `k` among the unknowns) is far below zero in a fit.
pub(super) fn level_drives(tested: &ModelUnderTest<'_>, k: usize, fitted: &Fitted, noise: f64) -> bool {
    let file = given_friction(tested.plant)[k / 3][k % 3].unwrap_or(0.0).max(0.0);
    let level = file + fitted.solution.x[fitted.friction + k];
    k % 3 < 2 && level < -BELOW * file.max(noise)
}

/// Whether the friction of a joint, including its laws among `chosen`, does positive work on it.
/// The limit is a share of the work that it dissipates elsewhere in the motion, plus what noise can
/// do.
pub(in crate::diagnose) fn friction_drives(
    tested: &ModelUnderTest<'_>,
    joint: usize,
    chosen: &[Chosen],
    fitted: &Fitted,
    noise: f64,
) -> bool {
    let scene = &tested.scene;
    let speed = scene.pointwise(joint, |o, k| o.v[k]);
    let signs = scene.pointwise(joint, |o, k| o.sign[k]);
    let [Some((_, speed)), Some((_, signs))] = [speed.rows.first(), signs.rows.first()] else { return false };
    let [viscous, coulomb] = fitted.friction_levels(&given_friction(tested.plant)[joint], joint);
    let mut torque: Vec<f64> = speed.iter().zip(signs.iter()).map(|(v, s)| viscous * v + coulomb * s).collect();
    for (c, terms) in chosen.iter().zip(&fitted.terms) {
        if c.cause.kind() != Kind::Friction || c.place != [joint] {
            continue;
        }
        for (term, x) in terms.iter().zip(&c.x) {
            for (_, series) in term.column.rows.iter().filter(|row| row.0 == joint) {
                torque.iter_mut().zip(series.iter()).for_each(|(t, s)| *t += x * s);
            }
        }
    }
    let power = || torque.iter().zip(speed.iter()).map(|(t, v)| t * v);
    let [lost, driven] = power().fold([0.0, 0.0], |[lost, driven], p| [lost + p.max(0.0), driven - p.min(0.0)]);
    driven > BELOW * (lost + noise * speed.iter().map(|v| v.abs()).sum::<f64>())
}
