//! Whether the causes of a diagnosis are found again by diagnoses of excerpts of its logs.

use super::findings::calibration;
use super::findings::result::Cause;
use super::windows::recording::{Recording, Stretch};

/// Parts of the motion's time that the excerpts take: its first and its last six tenths.
const EXCERPTS: [[f64; 2]; 2] = [[0.0, 0.6], [0.4, 1.0]];

/// Shortest part of a stretch that is used, s.
const SHORTEST: f64 = 0.5;

/// Seeks each cause again in excerpts, and lowers the probability of those that an excerpt lacks.
/// `again`: causes of an excerpt, given the rest of the recordings; `None` if it is too short to be
/// diagnosed.
pub(super) fn seek_again(
    causes: &mut [Cause],
    recordings: &[Recording],
    again: impl Fn(&[Recording], &[Recording]) -> Option<Vec<Cause>>,
) {
    // A push has its own time, and what is left without a name has no place.
    let counts = |cause: &Cause| cause.cause != "unknown" && cause.window().is_none();
    if !causes.iter().any(counts) {
        return;
    }
    for [from, to] in EXCERPTS {
        let rest = [between(recordings, [0.0, from]), between(recordings, [to, 1.0])].concat();
        let Some(found) = again(&between(recordings, [from, to]), &rest) else { continue };
        for cause in causes.iter_mut().filter(|cause| counts(cause)) {
            let [known, of] = cause.found_again;
            let here = found.iter().any(|other| other.is(cause));
            cause.found_again = [known + usize::from(here), of + 1];
        }
    }
    for cause in causes {
        cause.probability = calibration::sought_again(cause.probability, cause.found_again);
    }
}

/// The motion between two shares of the recordings' whole time.
fn between(recordings: &[Recording], [from, to]: [f64; 2]) -> Vec<Recording> {
    let whole: f64 = recordings.iter().map(Recording::seconds).sum();
    let mut before = 0.0;
    let mut cut = |stretch: &Stretch| {
        let at = |share: f64| ((share * whole - before) / stretch.period).round().max(0.0) as usize;
        let [first, end] = [at(from), at(to)].map(|at| at.min(stretch.states.len));
        before += stretch.states.len as f64 * stretch.period;
        ((end - first) as f64 * stretch.period >= SHORTEST).then(|| stretch.cut(first..end))
    };
    let parts = recordings.iter().map(|recording| Recording {
        stretches: recording.stretches.iter().filter_map(&mut cut).collect(),
        name: recording.name.clone(),
        begin: recording.begin,
    });
    parts.filter(|recording| !recording.stretches.is_empty()).collect()
}
