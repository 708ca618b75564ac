//! Monte Carlo tests: the truth lies within two stated standard deviations in about 95 % of the
//! runs, for white and coloured noise.

use super::*;
use crate::identify::planar::motion;

/// Share of (run, parameter) pairs within two standard deviations, and the root mean square of
/// error / standard deviation.
fn coverage(runs: u64, rate: f64, seconds: f64, filtered: bool) -> (f64, f64) {
    let arm = Planar::new();
    let truth = arm.beta();
    let clean = motion(&arm, seconds, rate, 0.0);
    let (mut within, mut squares, mut all) = (0, 0.0, 0);
    for seed in 0..runs {
        let mut m = clean.clone();
        add_noise(&mut m, [2.0, 0.6], filtered, 100 + seed);
        for (p, truth) in identify(&arm, &[m]).parameters.iter().zip(&truth) {
            let score = (p.value - truth) / p.std;
            within += usize::from(score.abs() < 2.0);
            squares += score * score;
            all += 1;
        }
    }
    (within as f64 / all as f64, (squares / all as f64).sqrt())
}

#[test]
fn filtered_noise() {
    let (within, spread) = coverage(150, 200.0, 10.0, true);
    assert!((0.93..0.985).contains(&within) && (0.85..1.1).contains(&spread), "{within} {spread}");
}

#[test]
fn white_noise() {
    let (within, spread) = coverage(100, 100.0, 10.0, false);
    assert!((0.93..0.985).contains(&within) && (0.85..1.1).contains(&spread), "{within} {spread}");
}

#[test]
fn short_record() {
    let (within, spread) = coverage(100, 200.0, 5.0, true);
    assert!((0.92..0.985).contains(&within) && (0.85..1.15).contains(&spread), "{within} {spread}");
}

/// The white-noise formula on the same data gives standard deviations too small by the root of the
/// inflation.
#[test]
fn filtered_noise_is_told_from_white() {
    let arm = Planar::new();
    let mut m = motion(&arm, 10.0, 1000.0, 0.0);
    add_noise(&mut m, [2.0, 0.6], true, 7);
    let found = identify(&arm, &[m]);
    // A zero-phase low-pass at 10 Hz leaves about 2 * 9.5 Hz * 10 s independent samples of 10,000.
    for joint in 0..2 {
        let n = found.noise.effective_samples[joint];
        assert!((110.0..350.0).contains(&n), "{n}");
    }
}

/// Shannon: `2 f T + 1` numbers fully represent a torque below `f`.
#[test]
fn a_band_holds_twice_its_width_of_samples() {
    let arm = Planar::new();
    let m = Motion { bandwidth: Some(10.0), ..motion(&arm, 10.0, 1000.0, 0.0) };
    let found = factors(&arm, &[m]);
    for joint in &found.joints {
        assert!((joint.independent / (joint.samples as f64 / 10_000.0) - 201.0).abs() < 1.0, "{}", joint.independent);
    }
}

/// Number of runs of a test: `few` by default, `DENAVIT_HONESTY=200` for published figures.
fn runs(few: u64) -> u64 {
    std::env::var("DENAVIT_HONESTY").ok().and_then(|n| n.parse().ok()).unwrap_or(few)
}

/// Share of the scores (error / standard deviation) within three, and their root mean square.
fn within_three(scores: &[f64]) -> (f64, f64) {
    let within = scores.iter().filter(|z| z.abs() < 3.0).count() as f64 / scores.len() as f64;
    (within, (scores.iter().map(|z| z * z).sum::<f64>() / scores.len() as f64).sqrt())
}

/// A log of joints that dry friction holds at every reversal. Speeds below 0.1 rad/s are set to
/// zero, and meanwhile friction passes from one level to the other. Encoders have steps of 1e-5
/// rad. Positions and torques are means over each sample's time: a hold lasts some samples, and
/// accelerations merely picked at the samples do not add up to the velocities.
fn sticking(arm: &Planar, rate: f64, noise: f64, seed: u64) -> crate::data::log::Log {
    const FINER: usize = 10;
    let mut m = motion(arm, 12.0, rate * FINER as f64, 0.37 * seed as f64);
    let (len, dead) = (m.states.len, 0.1);
    let mut friction = vec![0.0; 2 * len];
    for joint in 0..2 {
        let own = joint * len..(joint + 1) * len;
        let asked = m.states.dq[own.clone()].to_vec();
        for (k, v) in asked.iter().enumerate() {
            friction[own.start + k] = (v / dead).clamp(-1.0, 1.0);
            m.states.dq[own.start + k] = v - v.clamp(-dead, dead);
            if v.abs() < dead {
                m.states.ddq[own.start + k] = 0.0;
            }
        }
        for k in 1..len {
            let mean = 0.5 * (m.states.dq[own.start + k] + m.states.dq[own.start + k - 1]);
            m.states.q[own.start + k] = m.states.q[own.start + k - 1] + mean * m.period;
        }
    }
    let beta = arm.beta();
    crate::identify::planar::torque(arm, &m.states.clone(), &beta, &mut m.tau);
    for (joint, level) in [(0, beta[9]), (1, beta[10])] {
        for k in joint * len..(joint + 1) * len {
            let sign = if m.states.dq[k] == 0.0 { 0.0 } else { m.states.dq[k].signum() };
            m.tau[k] += level * (friction[k] - sign);
        }
    }
    let means = |x: &[f64]| x.chunks_exact(FINER).map(|c| c.iter().sum::<f64>() / FINER as f64).collect();
    (m.states.q, m.tau) = (means(&m.states.q), means(&m.tau));
    (m.states.len, m.period) = (len / FINER, m.period * FINER as f64);
    add_noise(&mut m, [noise; 2], false, 500 + seed);
    m.states.q.iter_mut().for_each(|q| *q = (*q / 1e-5).round() * 1e-5);
    crate::identify::planar::log(&m)
}

/// Rows of a joint that sticks are left out of its equation: dry friction dominates the residual
/// there, and its sign is unknown.
#[test]
fn rows_of_joints_that_stick_are_left_out() {
    use crate::data::log::Replay;
    use crate::data::signal::{Prepare, each_motion};
    let arm = Planar::new();
    let truth = arm.beta();
    let (mut scores, mut squares) = (Vec::new(), [0.0; 2]);
    for seed in 0..runs(6) {
        let log = sticking(&arm, 500.0, 0.05, seed);
        for (square, blind) in squares.iter_mut().zip([false, true]) {
            let mut stack = QrAccumulator::new("log", &arm, AccumulatorSettings::default());
            let sink = |motion: &Motion| match blind {
                false => stack.absorb(motion),
                true => stack.absorb(&Motion { stuck: Vec::new(), resting: Vec::new(), ..motion.clone() }),
            };
            each_motion(&mut Replay::new(&log), 2, &Prepare::default(), sink).unwrap();
            let found = solve(&arm, &[stack.finish()], &[], &IdentifySettings::default()).unwrap();
            let errors = found.parameters.iter().zip(&truth).map(|(p, truth)| p.value - truth);
            *square += errors.clone().map(|e| e * e).sum::<f64>();
            if !blind {
                scores.extend(found.parameters.iter().zip(errors).map(|(p, e)| e / p.std));
            }
        }
    }
    let (within, spread) = within_three(&scores);
    println!("{} runs: {within} within three deviations, spread {spread}; squares {squares:?}", runs(6));
    // 200 runs: 99.4 % within three deviations, spread 1.11, since low-passed rows are kept.
    assert!(within >= 0.985 && spread < 1.25, "{within} {spread}");
    assert!(squares[0] < squares[1], "{squares:?}");
}

/// Ten seconds of two sines per joint.
fn waves(n: usize, rate: f64) -> crate::model::States {
    let len = (10.0 * rate) as usize;
    let wave = |joint: usize, s: usize, derivative: i32| -> f64 {
        let [size, lead] =
            [0.1 + 0.4 * f64::from(u8::from(joint != 2)), f64::from(derivative) * std::f64::consts::FRAC_PI_2];
        let of = |w: f64| size * w.powi(derivative) * (w * s as f64 / rate + joint as f64 + lead).sin();
        of(1.3 + 0.4 * joint as f64) + 0.5 * of(3.1 - 0.3 * joint as f64)
    };
    let all = |d: i32| (0..n).flat_map(|j| (0..len).map(move |s| (j, s))).map(|(j, s)| wave(j, s, d)).collect();
    crate::model::States { len, q: all(0), dq: all(1), ddq: all(2) }
}

/// A hand with a tool: a robot of the repository, and the parameters of both.
struct Hand {
    arm: crate::model::interpreted::Interpreted,
    standard: Vec<f64>,
    tool: [f64; 10],
}

const TOOL_RATE: f64 = 100.0;

impl Hand {
    fn new() -> Self {
        use dh_codegen::arm::{Function, param};
        let text = include_str!("../../../robots/scara.yaml");
        let robot = dh_codegen::robot::Robot::from_yaml(text, &dh_codegen::robot::no_files).unwrap().robot;
        let arm = crate::model::interpreted::Interpreted::new(&robot, &[Function::PayloadRegressor]);
        let standard = param::standard_values(&robot).unwrap();
        Self { arm, standard, tool: [1.5, 0.03, -0.02, 0.12, 0.02, 0.03, 0.01, 0.001, -0.002, 0.003] }
    }

    /// Factors of ten seconds of motion, with white noise of 0.02 N m.
    fn recorded(&self, loaded: bool, normal: &mut Normal) -> Factors {
        use crate::identify::tool::Carrying;
        use crate::model::Arm;
        let carrying = Carrying::new(&self.arm, loaded);
        let n = self.arm.dof();
        let states = waves(n, TOOL_RATE);
        let len = states.len;
        let mut tau = vec![0.0; n * len];
        let whole = if loaded { [&self.standard[..], &self.tool].concat() } else { self.standard.clone() };
        carrying.inverse_dynamics(&states, &whole, &mut tau);
        tau.iter_mut().for_each(|t| *t += 0.02 * normal.next());
        let (period, velocity_noise) = (1.0 / TOOL_RATE, vec![0.0; n]);
        let motion = Motion { period, states, tau, core: 0..len, stride: 1, velocity_noise, ..Motion::default() };
        let mut stack = QrAccumulator::new("log", &carrying, AccumulatorSettings::default());
        stack.absorb(&motion);
        stack.finish()
    }

    /// Errors of the estimated tool in units of their standard deviations.
    fn scores(
        &self,
        unloaded: &[Factors],
        loaded: &[Factors],
        settings: &crate::identify::tool::ToolSettings,
    ) -> Vec<f64> {
        let found = crate::identify::tool::identify_tool(&self.arm, unloaded, loaded, settings).unwrap();
        let determined = found.determined();
        (0..10).filter(|&k| determined[k]).map(|k| (found.values[k] - self.tool[k]) / found.std[k]).collect()
    }
}

/// Without an unloaded log: the robot's parameters have errors according to their covariance.
#[test]
fn a_tool_on_a_robot_that_is_known_to_so_much() {
    use crate::identify::recover_standard;
    use crate::identify::tool::ToolSettings;
    let hand = Hand::new();
    let base = crate::identify::regression::recover::base_of(&hand.arm, &hand.standard);
    let std: Vec<f64> = base.iter().map(|b| 0.01 * b.abs() + 1e-3).collect();
    let covariance: Vec<f64> = (0..std.len().pow(2))
        .map(|e| if e / std.len() == e % std.len() { std[e % std.len()].powi(2) } else { 0.0 })
        .collect();
    let (mut counted, mut exact) = (Vec::new(), Vec::new());
    for seed in 0..runs(15) {
        let mut normal = Normal::new(900 + seed);
        let loaded = [hand.recorded(true, &mut normal)];
        let wrong: Vec<f64> = base.iter().zip(&std).map(|(b, s)| b + s * normal.next()).collect();
        let robot = recover_standard(&hand.arm, &wrong, Some(&hand.standard)).ok();
        for (covariance, scores) in [(Some(covariance.clone()), &mut counted), (None, &mut exact)] {
            let settings =
                ToolSettings { robot: robot.clone(), robot_covariance: covariance, ..ToolSettings::default() };
            scores.extend(hand.scores(&[], &loaded, &settings));
        }
    }
    let ((within, spread), (_, without)) = (within_three(&counted), within_three(&exact));
    println!("{} runs: {within} within three deviations, spread {spread}; robot taken as exact: {without}", runs(15));
    assert!(within >= 0.985 && (0.6..1.3).contains(&spread), "{within} {spread}");
    assert!(without > 2.0, "{without}");
}

/// With an unloaded log the robot need not be known.
#[test]
fn a_tool_beside_the_empty_hand() {
    let (hand, settings) = (Hand::new(), crate::identify::tool::ToolSettings::default());
    let mut scores = Vec::new();
    for seed in 0..runs(15) {
        let mut normal = Normal::new(1900 + seed);
        let logs = [false, true].map(|loaded| [hand.recorded(loaded, &mut normal)]);
        scores.extend(hand.scores(&logs[0], &logs[1], &settings));
    }
    let (within, spread) = within_three(&scores);
    println!("{} runs: {within} within three deviations, spread {spread}", runs(15));
    assert!(within >= 0.985 && (0.7..1.2).contains(&spread), "{within} {spread}");
}

/// A scale with a standard deviation is one more measurement of the mass: precisions add, and
/// parameters correlated with the mass are updated accordingly.
#[test]
fn a_scale_is_a_measurement() {
    use crate::identify::tool::{ToolSettings, identify_tool};
    let hand = Hand::new();
    let mut normal = Normal::new(77);
    let logs = [false, true].map(|loaded| [hand.recorded(loaded, &mut normal)]);
    let identified = |settings: &ToolSettings| identify_tool(&hand.arm, &logs[0], &logs[1], settings).unwrap();
    let free = identified(&ToolSettings::default());
    let (mass, std) = (free.values[0] + 3.0 * free.std[0], 0.5 * free.std[0]);
    let both = identified(&ToolSettings { known_mass: Some(mass), mass_std: std, ..ToolSettings::default() });
    let precision = free.std[0].powi(-2) + std.powi(-2);
    assert!((both.std[0] / precision.powf(-0.5) - 1.0).abs() < 1e-6);
    let shift = (mass - free.values[0]) * std.powi(-2) / precision;
    assert!((both.values[0] - free.values[0] - shift).abs() < 1e-6 * free.std[0]);
    let mut along = 0;
    for k in (1..10).filter(|&k| free.determined()[k]) {
        let by = free.covariance[10 * k] / free.covariance[0] * shift;
        assert!((both.values[k] - free.values[k] - by).abs() < 1e-6 * free.std[k], "{k}");
        along += usize::from(by.abs() > 1e-3 * free.std[k]);
    }
    assert!(along > 0, "nothing is correlated with the mass");
}

/// Tools with a tolerance: probabilities are those of normal densities, of which the widest is the
/// lowest.
#[test]
fn tools_are_as_likely_as_their_densities() {
    use crate::identify::tool::{Entry, RecogniseSettings, ToolSettings, identify_tool, recognise};
    use nalgebra::{DMatrix, DVector, SMatrix};
    let hand = Hand::new();
    let mut normal = Normal::new(78);
    let logs = [false, true].map(|loaded| [hand.recorded(loaded, &mut normal)]);
    let found = identify_tool(&hand.arm, &logs[0], &logs[1], &ToolSettings::default()).unwrap();
    let which: Vec<usize> = (0..10).filter(|&k| found.determined()[k]).collect();
    let entry = |name: &str, off: f64, wide: f64| Entry {
        name: name.into(),
        values: std::array::from_fn(|k| found.values[k] + off * found.std[k]),
        covariance: SMatrix::from_fn(|i, k| if i == k { (wide * found.std[i]).powi(2) } else { 0.0 }),
        geometry: None,
        pose: ([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], [0.0; 3]),
    };
    let table = [entry("narrow", 0.4, 0.5), entry("wide", 0.2, 1.0)];
    let answer = recognise(&found, &table, &RecogniseSettings::default()).unwrap();
    // In units of the standard deviations.
    let density = |entry: &Entry| {
        let unit = |i: usize, k: usize| found.std[which[i]] * found.std[which[k]];
        let n = which.len();
        let covariance = DMatrix::from_fn(n, n, |i, k| {
            (found.covariance[10 * which[i] + which[k]] + entry.covariance[(which[i], which[k])]) / unit(i, k)
        });
        let d = DVector::from_fn(n, |i, _| (found.values[which[i]] - entry.values[which[i]]) / found.std[which[i]]);
        let exponent = -0.5
            * d.dot(
                &covariance
                    .clone()
                    .try_inverse()
                    .unwrap()
                    .column_iter()
                    .zip(d.iter())
                    .fold(DVector::zeros(n), |sum, (column, x)| sum + column * *x),
            );
        exponent.exp() / covariance.determinant().sqrt()
    };
    let [narrow, wide] = [density(&table[0]), density(&table[1])];
    let expected = narrow / (narrow + wide);
    let said = answer.candidates.iter().find(|c| c.name == "narrow").unwrap().probability;
    assert!((said - expected).abs() < 1e-6, "{said} {expected}");
    assert!((0.02..0.98).contains(&expected), "{expected}");
}
