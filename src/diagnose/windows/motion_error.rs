//! Torque errors of a model due to errors of the recorded motion.

use super::recording::Stretch;
use super::windowed_data::WindowedData;
use crate::data::signal::repeatability;
use crate::identify::{ErrorBudget, thinned, torque_of_errors};
use crate::numerics::sums::root_mean_square;

/// Number of windows at which the model's sensitivities are evaluated.
const SAMPLES: usize = 128;

/// Error budget of each joint, N m, before the residual is known. Sensors (`noise`), motion and
/// clock by the rigid model of the data, and repeatability of what was `recorded`.
pub(in crate::diagnose) fn budget<'r>(
    scene: &WindowedData<'_>,
    recorded: impl Iterator<Item = &'r Stretch> + Clone,
    noise: &[f64],
) -> ErrorBudget {
    let dof = scene.dof();
    let stretches = || recorded.clone();
    let seconds: f64 = stretches().map(seconds_of).sum::<f64>().max(f64::MIN_POSITIVE);
    let mean = |of: &dyn Fn(&Stretch) -> f64| stretches().map(|s| seconds_of(s) * of(s)).sum::<f64>() / seconds;
    let error = |j: usize, k: usize| mean(&|s| s.error.get(j).map_or(0.0, |e| e[k] * e[k])).sqrt();
    let errors: Vec<[f64; 3]> = (0..dof).map(|j| std::array::from_fn(|k| error(j, k))).collect();
    let motion = match scene.states.first() {
        Some(states) => torque_of_errors(scene.plant, &scene.beta, &thinned(states, SAMPLES), &errors),
        None => vec![0.0; dof],
    };
    let time = mean(&|s| s.clock_error * s.clock_error).sqrt();
    let rate = |j: usize| root_mean_square(&scene.rate_of(&scene.by_motion(j)));
    ErrorBudget {
        sensor: noise.to_vec(),
        motion,
        clock: (0..dof).map(|j| if time > 0.0 { time * rate(j) } else { 0.0 }).collect(),
        repeatability: repetitions(recorded.clone(), dof),
        left: vec![0.0; dof],
    }
}

fn seconds_of(stretch: &Stretch) -> f64 {
    stretch.states.len as f64 * stretch.period
}

/// Difference between the torques of repeated motions, N m, per joint; `None` without repetitions.
fn repetitions<'r>(recorded: impl Iterator<Item = &'r Stretch>, dof: usize) -> Option<Vec<f64>> {
    let (mut squares, mut all) = (vec![0.0; dof], 0.0);
    for stretch in recorded {
        let Some((rms, seconds)) = repeatability(&stretch.states.q, &stretch.tau, stretch.states.len, stretch.period)
        else {
            continue;
        };
        squares.iter_mut().zip(rms).for_each(|(sum, rms)| *sum += seconds * rms * rms);
        all += seconds;
    }
    (all > 0.0).then(|| squares.iter().map(|s| (s / all).sqrt()).collect())
}
