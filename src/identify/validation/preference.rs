//! Compares the predictions of two sets of parameters on logs, and decides whether the logs are
//! long enough for a verdict.
//!
//! The criterion is the mean over the joints of the RMS, `E = mean_j sqrt(sum_t S_jt / N_j)`.
//! `S_jt` are the squared errors of joint `j` in stretch `t` (the batches of the factors, half a
//! second or more). `L = log E_b - log E_a` is a smooth function of these sums, so each stretch has
//! an influence on it, `I_t = sum_j S^b_jt / (2 r^b_j N_j sum r^b) - (the same of a)`. Its variance
//! is `var L = sum_t I_t^2 + 2 sum_(t < s) I_t I_s` (the infinitesimal jackknife; Efron and
//! Tibshirani 1993, section 21). Errors of a model are autocorrelated over stretches, so the second
//! sum extends as far as Geyer's initial positive sequence (Statistical Science 7, 1992). The
//! interval is that of Student's t, with the number of independent stretches minus one as degrees
//! of freedom. Both errors refer to the same torques, so common errors cancel.
//!
//! The parameters are taken as given: the interval covers other motion *of this kind* with these
//! two sets, not another fit.

use statrs::distribution::{ContinuousCDF, StudentsT};

use crate::identify::regression::accumulator::Factors;

/// Comparison of the predictions of the second parameters with those of the first.
#[derive(Debug, Clone, PartialEq)]
pub struct Preference {
    /// Relative increase of the mean over the joints of the RMS with the second parameters, percent
    /// (negative: decrease).
    pub percent: f64,
    /// Confidence interval of `percent`, 95 %.
    pub interval: [f64; 2],
    /// Number of stretches that were compared.
    pub stretches: usize,
    /// Equivalent number of independent stretches.
    pub independent: f64,
}

/// Verdict of the comparison.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Better {
    /// The first parameters predict better.
    First,
    /// The second parameters predict better.
    Second,
    /// The logs can't decide.
    Open,
}

impl Preference {
    /// The significantly better set of parameters.
    pub fn better(&self) -> Better {
        match self.interval {
            [low, _] if low > 0.0 => Better::First,
            [_, high] if high < 0.0 => Better::Second,
            _ => Better::Open,
        }
    }
}

/// Squared errors of two sets of parameters over the stretches of one log:
/// `[parameters][joint][stretch]`.
pub(in crate::identify) struct Errors {
    pub(in crate::identify) squares: [Vec<Vec<f64>>; 2],
    /// Number of samples of each joint; zero if its torque was not recorded.
    pub(in crate::identify) samples: Vec<usize>,
}

impl Errors {
    /// Errors over the stretches of a log with these numbers.
    pub(in crate::identify) fn new(log: &Factors, stretches: std::ops::Range<usize>, beta: [&[f64]; 2]) -> Self {
        let square = |gram: &[f64], x: &[f64]| {
            let row = |column: &[f64]| column.iter().zip(x).map(|(g, v)| g * v).sum::<f64>();
            gram.chunks_exact(x.len()).zip(x).map(|(column, v)| v * row(column)).sum::<f64>().max(0.0)
        };
        let joints = |beta: &[f64]| {
            let of = |joint: &crate::identify::regression::accumulator::JointFactor| -> Vec<f64> {
                let x: Vec<f64> = joint.columns.iter().map(|&c| -beta[c]).chain([1.0]).collect();
                let grams = joint.batches.grams.iter().enumerate().filter(|(t, _)| stretches.contains(t));
                grams.map(|(_, gram)| square(gram, &x)).collect()
            };
            log.joints.iter().map(of).collect()
        };
        let share = |joint: &crate::identify::regression::accumulator::JointFactor| {
            let all = joint.batches.grams.len().max(1) as f64;
            if joint.is_live() { (joint.samples as f64 * stretches.len() as f64 / all).round() as usize } else { 0 }
        };
        Self { squares: beta.map(joints), samples: log.joints.iter().map(share).collect() }
    }
}

/// Compares base parameters `b` with `a` on these logs. `None` if there are fewer than four
/// stretches, or if the errors are zero.
pub fn preference(logs: &[Factors], a: &[f64], b: &[f64]) -> Option<Preference> {
    let all = |log: &Factors| log.joints.iter().map(|j| j.batches.grams.len()).max().unwrap_or(0);
    compare(&logs.iter().map(|log| Errors::new(log, 0..all(log), [a, b])).collect::<Vec<_>>())
}

/// Compares errors, see [`preference`].
pub(in crate::identify) fn compare(logs: &[Errors]) -> Option<Preference> {
    let dof = logs.first()?.samples.len();
    let live: Vec<f64> = (0..dof).map(|j| logs.iter().map(|l| l.samples[j]).sum::<usize>() as f64).collect();
    let joints: Vec<usize> = (0..dof).filter(|&j| live[j] > 0.0).collect();
    // Errors r_j of both, and the derivative of log E with respect to a squared error.
    let weights = [0, 1].map(|which| {
        let total = |j: usize| logs.iter().filter(|l| l.samples[j] > 0).flat_map(|l| &l.squares[which][j]).sum::<f64>();
        let rms: Vec<f64> = joints.iter().map(|&j| (total(j) / live[j]).sqrt()).collect();
        let sum: f64 = rms.iter().sum();
        let slope = |(r, &j): (&f64, &usize)| if *r > 0.0 { 1.0 / (2.0 * r * live[j] * sum) } else { 0.0 };
        (sum, rms.iter().zip(&joints).map(slope).collect::<Vec<f64>>())
    });
    let log_ratio = (weights[1].0 / weights[0].0).ln();
    if !log_ratio.is_finite() {
        return None;
    }
    let influences: Vec<Vec<f64>> = logs
        .iter()
        .map(|log| {
            let stretches = joints.iter().map(|&j| log.squares[0][j].len()).max().unwrap_or(0);
            let at = |t: usize| {
                let of = |which: usize| -> f64 {
                    let live = joints.iter().zip(&weights[which].1).filter(|(j, _)| log.samples[**j] > 0);
                    live.map(|(&j, w)| w * log.squares[which][j].get(t).copied().unwrap_or(0.0)).sum()
                };
                of(1) - of(0)
            };
            (0..stretches).map(at).collect()
        })
        .collect();
    let stretches = influences.iter().map(Vec::len).sum::<usize>();
    if stretches < 4 {
        return None;
    }
    let lagged = |lag: usize| -> f64 {
        influences.iter().flat_map(|log| log.iter().zip(log.iter().skip(lag))).map(|(x, y)| x * y).sum()
    };
    let alone = lagged(0);
    let mut variance = alone;
    let mut pair = 1;
    // Pairs of lags (1, 2), (3, 4), ... as long as their sum is positive, up to a third of the
    // stretches.
    while pair < stretches.div_ceil(3) {
        let more = lagged(pair) + lagged(pair + 1);
        if more <= 0.0 {
            break;
        }
        variance += 2.0 * more;
        pair += 2;
    }
    let count = stretches as f64;
    let independent = if variance > 0.0 { (count * alone / variance).min(count) } else { count };
    let freedom = (independent - 1.0).max(1.0);
    // Influences sum to zero, which takes one of the independent stretches.
    let std = (variance * independent / freedom).max(0.0).sqrt();
    let reach = StudentsT::new(0.0, 1.0, freedom).map_or(f64::INFINITY, |t| t.inverse_cdf(0.975)) * std;
    // Caps the ratio at a million, so that it stays finite.
    let percent = |l: f64| 100.0 * l.clamp(-14.0, 14.0).exp_m1();
    let interval = [percent(log_ratio - reach), percent(log_ratio + reach)];
    Some(Preference { percent: percent(log_ratio), interval, stretches, independent })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::prng::Random;

    /// Autocorrelated normal noise: AR(1).
    fn noise(random: &mut Random, memory: f64, count: usize) -> Vec<f64> {
        let mut x = 0.0;
        let mut next = || {
            let normal: f64 = (0..12).map(|_| random.even(0.5)).sum();
            x = memory * x + (1.0 - memory * memory).sqrt() * normal;
            x
        };
        (0..200).for_each(|_| {
            next();
        });
        (0..count).map(|_| next()).collect()
    }

    /// Errors of the second that are three stretches above and three below those of the first, 24
    /// in all. Products at lag 1 sum to 9, at lag 2 to -6; those of lags 3 and 4 are negative. The
    /// variance is that of 24 independent stretches plus twice 3, so each counts as `24 / 30`.
    #[test]
    fn stretches_that_go_with_their_neighbours_count_for_less() {
        let second = (0..24).map(|t| if t / 3 % 2 == 0 { 2.5 } else { 1.5 }).collect();
        let errors = Errors { squares: [vec![vec![2.0; 24]], vec![second]], samples: vec![240] };
        let found = compare(&[errors]).unwrap();
        assert!((found.independent - 24.0 * 24.0 / 30.0).abs() < 1e-9 && found.percent.abs() < 1e-9, "{found:?}");
    }

    /// Two models over the same torques, the second's error larger by a known factor, with errors
    /// that are autocorrelated over several stretches. The interval has its nominal coverage, and
    /// two equally good models are distinguished at the nominal rate.
    #[test]
    fn intervals_hold_what_they_say() {
        for (memory, least) in [(0.5, 0.91), (0.97, 0.88)] {
            let (mut held, mut shorter, runs) = (0, 0, 400);
            let mut random = Random::new(77);
            for run in 0..runs {
                let truth: f64 = if run % 2 == 0 { 0.0 } else { 0.1 };
                let (stretches, length, dof) = (32, 25, 3);
                let count = stretches * length;
                let mut squares = [Vec::new(), Vec::new()];
                for _ in 0..dof {
                    let common = noise(&mut random, memory, count);
                    let own = [noise(&mut random, memory, count), noise(&mut random, memory, count)];
                    for (which, own) in own.iter().enumerate() {
                        let size = if which == 1 { 1.0 + truth } else { 1.0 };
                        let error = common.iter().zip(own).map(|(c, o)| size * (0.8 * c + 0.6 * o));
                        let error: Vec<f64> = error.collect();
                        squares[which]
                            .push(error.chunks(length).map(|b| b.iter().map(|e| e * e).sum()).collect::<Vec<f64>>());
                    }
                }
                let found = compare(&[Errors { squares, samples: vec![count; dof] }]).unwrap();
                held += u32::from(found.interval[0] <= 100.0 * truth && 100.0 * truth <= found.interval[1]);
                shorter += u32::from(found.interval[1] - found.interval[0] < 60.0);
            }
            let share = f64::from(held) / f64::from(runs);
            assert!((least..0.995).contains(&share), "memory {memory}: {share}");
            assert!(shorter > runs * 9 / 10, "{shorter}");
        }
    }

    #[test]
    fn equal_errors_and_none() {
        let errors = |b: f64| Errors {
            squares: [vec![vec![1.0, 2.0, 1.5, 1.2]], vec![vec![b, 2.0 * b, 1.5 * b, 1.2 * b]]],
            samples: vec![400],
        };
        let same = compare(&[errors(1.0)]).unwrap();
        assert_eq!((same.percent, same.better()), (0.0, Better::Open));
        let twice = compare(&[errors(4.0)]).unwrap();
        assert!((twice.percent - 100.0).abs() < 1e-9 && twice.better() == Better::First);
        assert!(compare(&[errors(0.0)]).is_none() && compare(&[]).is_none());
    }
}
