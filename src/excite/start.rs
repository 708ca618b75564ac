//! Starting point of a run: a collision-free posture, and a random motion about it within the
//! bounds.

use crate::model::States;

use super::constraints::Worst;
use super::program::Program;
use super::task::Task;
use crate::numerics::prng::Random;

/// The posture with the largest clearance of some thousand.
pub(super) fn home(task: &Task<'_>) -> Result<Vec<f64>, Worst> {
    let (n, len) = (task.dof(), 4096);
    let mut random = Random::stream(7, 0);
    let mut states = States::zeros(n, len);
    for j in 0..n {
        let [low, high] = task.limits[j].position;
        let middle = if low < 0.0 && high > 0.0 { 0.0 } else { 0.5 * (low + high) };
        for s in 0..len {
            // The first is the middle; later ones spread more widely.
            let share = 0.9 * s as f64 / len as f64;
            states.q[j * len + s] = random.uniform(middle + share * (low - middle), middle + share * (high - middle));
        }
    }
    let constraints = task.constraints();
    let list = constraints.list();
    let values = constraints.values(&list, &states);
    let mut best = (f64::INFINITY, 0, 0);
    for s in 0..len {
        let (mut worst, mut at) = (f64::NEG_INFINITY, 0);
        for k in 0..list.len() {
            if values[k * len + s] > worst {
                (worst, at) = (values[k * len + s], k);
            }
        }
        // Beyond some clearance all are equal, and the earliest is taken.
        let worst = worst.max(-0.3);
        if worst < best.0 {
            best = (worst, s, at);
        }
    }
    if best.0 > 0.0 {
        let what = constraints.describe(list[best.2], best.0);
        return Err(Worst { what, time: 0.0, excess: best.0 });
    }
    Ok((0..n).map(|j| states.q[j * len + best.1]).collect())
}

/// Random states inside the limits, without regard to rest at the ends: a column that they do not
/// determine is not determined by any motion.
pub(super) fn anywhere(task: &Task<'_>) -> States {
    let (n, len) = (task.dof(), 500);
    let mut random = Random::stream(11, 0);
    let mut draw = |order: usize| -> Vec<f64> {
        let range = |j: usize| task.limits[j].range(order).unwrap_or([-1.0, 1.0]);
        (0..n * len).map(|k| random.uniform(range(k / len)[0], range(k / len)[1])).collect()
    };
    States { len, q: draw(0), dq: draw(1), ddq: draw(2) }
}

/// Variables of a random motion about a posture.
pub(super) fn random_motion(task: &Task<'_>, program: &Program<'_>, home: &[f64], seed: u64, stream: u64) -> Vec<f64> {
    let mut random = Random::stream(seed, stream.wrapping_add(100));
    let rest: Vec<f64> = home.iter().flat_map(|&q| task.curve.rest(q)).collect();
    let mut step = vec![0.0; rest.len()];
    let count = task.curve.count();
    for j in 0..task.dof() {
        // Each joint uses the range that its own bounds allow.
        let mut alone = vec![0.0; rest.len()];
        let [low, high] = task.limits[j].position;
        let wide = (high - low).min(4.0);
        for k in 0..count {
            alone[j * count + k] = random.uniform(-0.5, 0.5) * wide;
        }
        let room = program.room(&rest, &alone);
        (0..count).for_each(|k| step[j * count + k] = 0.8 * room * alone[j * count + k]);
    }
    rest.iter().zip(&step).map(|(r, d)| r + d).collect()
}
