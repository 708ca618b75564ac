//! Delay between torque and motion in MuJoCo: history buffers, since MuJoCo 3.5.
//!
//! `time_delay` means that the torque sample at t belongs to the motion at t - TD. A late torque
//! (TD above zero) is therefore a sensor of the joint's torque with a delay of TD, and an early one
//! (below zero) a commanded torque that acts -TD later.

use core::fmt::Write;

use dh_codegen::robot::effects::TimeDelay;
use dh_codegen::robot::{Joint, Robot};

/// Shortest time step for which a buffer is long enough, s: a quarter of MuJoCo's default.
const FINEST_STEP: f64 = 5e-4;

/// Attributes of a sensor or actuator with this delay, s.
pub(super) fn attributes(seconds: f64) -> [(&'static str, String); 3] {
    // A buffer shorter than the delay would return too recent a torque.
    let samples = (seconds / FINEST_STEP).ceil().max(1.0);
    [("delay", format!("{seconds:?}")), ("nsample", format!("{samples}")), ("interp", "linear".into())]
}

fn written(seconds: f64) -> String {
    attributes(seconds).iter().map(|(name, value)| format!(" {name}=\"{value}\"")).collect()
}

/// Moving rows with a non-zero `TD`, s.
fn delays(robot: &Robot) -> Vec<(usize, f64)> {
    let laws = robot.laws();
    let all = robot.moving().into_iter().zip(laws.iter().map(|law| law.delay));
    all.filter(|(_, delay)| *delay != 0.0).collect()
}

/// Rows whose torque is read with a delay, and the delay, s.
pub(super) fn late(robot: &Robot) -> Vec<(usize, f64)> {
    delays(robot).into_iter().filter(|&(row, delay)| delay > 0.0 && robot.joints[row].actuated).collect()
}

/// Rows whose torque acts after its command, and the delay, s.
pub(super) fn early(robot: &Robot) -> Vec<(usize, f64)> {
    let all = delays(robot).into_iter().filter(|&(row, delay)| delay < 0.0 && robot.joints[row].actuated);
    all.map(|(row, delay)| (row, -delay)).collect()
}

/// Attributes of the motor of a joint, each preceded by a blank; empty without an actuation delay.
pub(super) fn of_motor(robot: &Robot, joint: &Joint) -> String {
    let own = early(robot).into_iter().find(|(row, _)| core::ptr::eq(&robot.joints[*row], joint));
    own.map_or(String::new(), |(_, delay)| written(delay))
}

/// A torque sensor for each of these joints, given by name in the model and delay, s; empty if
/// there are none.
pub(super) fn sensors(late: &[(String, f64)]) -> String {
    let mut t = String::new();
    for (name, delay) in late {
        let _ = writeln!(t, "    <jointactuatorfrc name=\"{name}_torque\" joint=\"{name}\"{}/>", written(*delay));
    }
    if t.is_empty() { t } else { format!("  <sensor>\n{t}  </sensor>\n") }
}

/// Joints with a delay but without a motor, a sentence each.
pub(super) fn without_motor(robot: &Robot) -> Vec<String> {
    let free = delays(robot).into_iter().map(|(row, _)| &robot.joints[row]).filter(|joint| !joint.actuated);
    free.map(|joint| format!("{} of `{}`, which has no motor", TimeDelay::NAME, joint.name)).collect()
}

/// Requirements on a simulator; `None` if no joint has a delay.
pub(super) fn note(robot: &Robot) -> Option<String> {
    let any = !late(robot).is_empty() || !early(robot).is_empty();
    any.then(|| {
        format!(
            "delays need MuJoCo 3.5 or later, and a time step of {FINEST_STEP} s or more (a finer one more `nsample`); \
             they last one step at least, and torques are linear between steps"
        )
    })
}
