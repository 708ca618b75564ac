//! Errors on logs of a robot file that contains the offered model, by the file's ordinary inverse
//! dynamics. This path shares neither columns nor windows with the diagnosis.

use super::findings::result::Diagnosis;
use super::run::KEPT;
use super::windows::low_passed::in_band;
use super::windows::recording::{Recording, Stretch};
use super::windows::windowed_data::{dead_zones, edge};
use crate::model::{States, TorqueModel};
use crate::numerics::sums::root_mean_square;

/// Root mean square error of each joint's torque, N m, over the samples on which a diagnosis
/// evaluates, behind its low-pass. Both ends of each stretch are left out. Without a validating log
/// all but the last three tenths of each stretch are left out, too.
///
/// The sign of a velocity inside its noise is 0 for a joint at rest most of the time, as in the
/// diagnosis. A joint whose sensor was off has no error.
pub fn written_errors(model: &dyn TorqueModel, recordings: &[Recording], found: &Diagnosis) -> Vec<f64> {
    let dof = model.dof();
    let share = if found.own_validation { 0.0 } else { KEPT };
    let recordings = &in_band(recordings, found.band.as_ref())[..];
    let parts: Vec<Recording> = recordings.iter().map(|r| r.split(share)[1].clone()).collect();
    let zones = dead_zones(&parts, dof);
    let mut errors = vec![Vec::new(); dof];
    for recording in recordings {
        let torques = along(model, recording, &zones);
        let mut first = 0;
        let len: usize = recording.stretches.iter().map(|s| s.states.len).sum();
        for stretch in &recording.stretches {
            let n = stretch.states.len;
            for k in counted(stretch, share) {
                for (j, errors) in errors.iter_mut().enumerate() {
                    errors.push(stretch.tau[j * n + k] - torques[j * len + first + k]);
                }
            }
            first += n;
        }
    }
    let off = |j: usize| parts.iter().flat_map(|r| &r.stretches).all(|s| s.of(&s.tau, j).iter().all(|t| *t == 0.0));
    (0..dof).map(|j| if off(j) { 0.0 } else { root_mean_square(&errors[j]) }).collect()
}

/// Samples of a stretch on which a diagnosis evaluates.
fn counted(stretch: &Stretch, share: f64) -> std::ops::Range<usize> {
    let n = stretch.states.len;
    let first = stretch.at(share);
    let edge = edge(stretch, n - first);
    first + edge..(n.saturating_sub(edge)).max(first + edge)
}

/// Torques along all stretches of a recording, joint-major, N m, so that the drives continue to
/// warm up.
fn along(model: &dyn TorqueModel, recording: &Recording, zones: &[(f64, bool)]) -> Vec<f64> {
    let (dof, stretches) = (model.dof(), &recording.stretches);
    let time: Vec<f64> =
        stretches.iter().flat_map(|s| (0..s.states.len).map(move |k| s.start + k as f64 * s.period)).collect();
    let joined = |of: fn(&Stretch) -> &[f64]| -> Vec<f64> {
        if stretches.iter().any(|s| of(s).len() != dof * s.states.len) {
            return Vec::new();
        }
        (0..dof).flat_map(|j| stretches.iter().flat_map(move |s| s.of(of(s), j).iter().copied())).collect()
    };
    let len = time.len();
    let mut dq = joined(|s| &s.states.dq);
    for (dq, (zone, _)) in dq.chunks_exact_mut(len.max(1)).zip(zones).filter(|(_, (_, rests))| *rests) {
        dq.iter_mut().filter(|v| v.abs() <= *zone).for_each(|v| *v = 0.0);
    }
    let states = States { len, q: joined(|s| &s.states.q), dq, ddq: joined(|s| &s.states.ddq) };
    let mut out = vec![0.0; dof * len];
    model.torques_since(recording.begin, &time, &states, &joined(|s| &s.temperature), &mut out);
    out
}
