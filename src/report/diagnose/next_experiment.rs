//! The motion proposed by a diagnosis, as JSON and as a line of text.

use serde_json::{Value, json};

use crate::diagnose::Separation;

/// `next_experiment` of `diagnose --json`, if a motion was designed.
pub fn next_experiment_json(next: &Separation, file: &str) -> Value {
    json!({
        "between": next.between,
        "joints": next.joints[0],
        "rival_joints": next.joints[1],
        "file": file,
        "seconds": next.motion.duration(),
        "motion": format!("play {file} and diagnose its log together with these"),
        "separation": { "rms": next.left, "share": next.share, "in_noise": next.in_noise },
    })
}

/// The proposed motion in a sentence.
pub fn next_experiment_text(next: &Separation, file: &str) -> String {
    format!(
        "next experiment: {file} ({:.0} s) separates {} from {}: {:.0} % of the first one's effect would be left, {:.1} times the noise\n",
        next.motion.duration(),
        next.between[0],
        next.between[1],
        100.0 * next.share,
        next.in_noise
    )
}
