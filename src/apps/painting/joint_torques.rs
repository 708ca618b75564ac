//! Joint torques of a plan's motion and of the wall's contact force.

use super::Moment;
use super::task::Task;
use crate::model::States;

/// Joint torques at these moments, joint-major, N m: of the motion, and of the force on the wall
/// while the roller is in contact. Zero if the robot file lacks link parameters.
pub fn joint_torques(task: &Task<'_>, moments: &[Moment]) -> Vec<f64> {
    let (n, len) = (task.dof(), moments.len());
    let mut out = vec![0.0; n * len];
    let Some(standard) = &task.standard else { return out };
    let states = Moment::states(n, moments);
    task.arm.inverse_dynamics(&states, standard, &mut out);
    let mut frames = vec![0.0; task.arm.frame_count() * 12 * len];
    task.arm.frames(&states, &mut frames);
    let push = push(task, &states, &frames, |s| moments[s].phase.contact());
    out.iter_mut().zip(push).for_each(|(torque, push)| *torque += push);
    out
}

/// Joint torques due to the wall's contact force, `n x len`, N m: minus `J'` times the wrench on
/// the last frame, at the samples in contact.
pub(super) fn push(task: &Task<'_>, states: &States, frames: &[f64], in_contact: impl Fn(usize) -> bool) -> Vec<f64> {
    let (n, len) = (task.dof(), states.len);
    let mut out = vec![0.0; n * len];
    if task.force == 0.0 || task.standard.is_none() || !(0..len).any(&in_contact) {
        return out;
    }
    let mut jacobian = vec![0.0; 6 * n * len];
    task.arm.jacobian(states, &mut jacobian);
    let force = task.surface.normal.map(|x| x * task.force);
    let count = task.arm.frame_count();
    let has_tool = count > 0 && task.mount != dh_codegen::ik::Displacement::NONE;
    for s in (0..len).filter(|&s| in_contact(s)) {
        let at = |f: usize, i: usize, k: usize| frames[((f * 3 + i) * 4 + k) * len + s];
        let last = if has_tool { count - 2 } else { count - 1 };
        // Middle of the roller's face: `length` along z of the tool, which points into the
        // wall.
        let lever: [f64; 3] =
            std::array::from_fn(|i| at(count - 1, i, 3) - at(last, i, 3) - task.roller.length * task.surface.normal[i]);
        let moment = super::vector::cross(lever, force);
        for j in 0..n {
            let row = |r: usize| jacobian[(r * n + j) * len + s];
            let work: f64 = (0..3).map(|i| row(i) * force[i] + row(3 + i) * moment[i]).sum();
            out[j * len + s] = -work;
        }
    }
    out
}
