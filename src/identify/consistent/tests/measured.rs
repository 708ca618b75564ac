//! Tests with real logs, if present: errors of a fit on motion that was not fitted.

use std::ops::Range;

use super::*;
use crate::data::log::{self, Acceptance, Log, Quantity, Replay};
use crate::data::signal::{Prepare, each_motion};

const DATA: &str = "../shared/data";

fn read(path: &str) -> Option<Log> {
    let file = std::fs::File::open(format!("{DATA}/{path}")).ok()?;
    let mut source = log::open(path, std::io::BufReader::new(file)).unwrap();
    Some(Log::read(&mut *source, Quantity::Tau, Acceptance::all()).unwrap())
}

/// Factors of the rows within these times, each stretch separately.
fn part(arm: &Interpreted, log: &Log, stretches: &[Range<f64>]) -> Factors {
    let prepare = Prepare { keep: Acceptance::all(), ..Prepare::default() };
    let mut stack = QrAccumulator::new("part", arm, AccumulatorSettings::default());
    for stretch in stretches {
        let rows: Vec<usize> = (0..log.len()).filter(|&k| stretch.contains(&log.columns[0][k])).collect();
        if rows.len() < 200 {
            continue;
        }
        let mut piece = log.clone();
        piece.starts = vec![0];
        piece.columns = log.columns.iter().map(|c| rows.iter().map(|&k| c[k]).collect()).collect();
        each_motion(&mut Replay::new(&piece), arm.dof(), &prepare, |m| stack.absorb(m)).unwrap();
    }
    stack.finish()
}

struct Fits {
    doubtful: usize,
    /// Held-out RMS per joint, N m: plain, possible bodies, possible bodies with the prior.
    rms: [Vec<f64>; 3],
}

fn fits((robot, arm): &(Robot, Interpreted), fit: Factors, validate: Factors) -> Fits {
    let (fit, validate) = ([fit], [validate]);
    let found = solve(arm, &fit, &validate, &IdentifySettings::default()).unwrap();
    let known: Vec<Option<[f64; 10]>> = robot.links.iter().map(|l| l.as_ref().map(|l| l.to_array())).collect();
    let prior = prior_bodies(&known, &geometric_bodies(&arm.ends()));
    // Held-out errors decide here, not the cost of the fit.
    let settings = ConsistentSettings { most_cost_percent: 1e3, ..ConsistentSettings::default() };
    let drives = vec![0.0; arm.standard_names().len()];
    let bodies = consistent(arm, &fit, &validate, &found, &prior, &drives, &settings).unwrap();
    Fits {
        doubtful: crate::identify::extrapolation(arm, arm, &found).doubtful().len(),
        rms: [found.validation, bodies.possible.validation, bodies.cost.validation].map(|v| v.unwrap().rms),
    }
}

/// A short, poorly exciting log: the plain fit does not extrapolate and is reported as such;
/// possible bodies with the manufacturer's prior do.
#[test]
fn a_poor_log_carries_over_with_a_prior() {
    let (Some(fit), Some(other)) = (read("kinova-gen3/optitraj1.csv"), read("kinova-gen3/sync7_run.csv")) else {
        return;
    };
    let gen3 = file("kinova-gen3");
    let whole = [0.0..f64::INFINITY];
    let found = fits(&gen3, part(&gen3.1, &fit, &whole), part(&gen3.1, &other, &whole));
    assert!(found.doubtful >= 6, "{}", found.doubtful);
    // The sensor of joint 1 was off in the other log.
    let mean = |k: usize| found.rms[k][1..].iter().sum::<f64>() / 6.0;
    let [plain, possible, prior] = [0, 1, 2].map(mean);
    println!("plain {plain:.3} N m, possible {possible:.3}, with prior {prior:.3}");
    assert!(plain > 8.0 && possible < 0.3 * plain && prior < 2.0, "{plain} {possible} {prior}");
    for joint in 1..7 {
        assert!(found.rms[2][joint] < 0.7 * found.rms[0][joint], "joint {}", joint + 1);
    }
}

/// The LWR's log is one motion of 4 pi seconds, played twice. Each fifth of the period is left out
/// of both repetitions in turn. Possible bodies predict the left-out motion better than the plain
/// fit, on average and each time.
#[test]
fn possible_bodies_predict_motion_that_was_not_seen() {
    let Some(log) = read("kuka-lwr4plus/traj1.csv") else { return };
    let (mut robot, _) = file("kuka-lwr4");
    robot.joints.iter_mut().for_each(|j| j.drive.offset = Some(0.0));
    let arm = Interpreted::new(&robot, &[]);
    let lwr = (robot, arm);
    let (period, blocks) = (4.0 * std::f64::consts::PI, 5);
    let mut sums = [0.0; 3];
    for block in 0..blocks {
        let mut stretches = [Vec::new(), Vec::new()];
        for k in 0..2 * blocks {
            let at = |k: usize| (period * k as f64 / blocks as f64).min(24.63);
            stretches[usize::from(k % blocks == block)].push(at(k)..at(k + 1));
        }
        let [fit, validate] = stretches.map(|s| part(&lwr.1, &log, &s));
        let found = fits(&lwr, fit, validate);
        let [plain, possible, prior] = [0, 1, 2].map(|k| found.rms[k].iter().sum::<f64>() / 7.0);
        println!("fifth {}: plain {plain:.3} N m, possible {possible:.3}, with prior {prior:.3}", block + 1);
        assert!(possible < 1.01 * plain && prior < 1.01 * plain, "fifth {}: {plain} {possible} {prior}", block + 1);
        sums.iter_mut().zip([plain, possible, prior]).for_each(|(s, x)| *s += x);
    }
    assert!(sums[1] < 0.8 * sums[0] && sums[2] < 0.7 * sums[0], "{sums:?}");
}
