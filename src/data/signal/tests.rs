//! Tests of the whole preparation, from the rows of a log to motion.

use std::f64::consts::TAU;

use super::*;
use crate::data::log::{Acceptance, Clock, Kind, Quantity, open};
use crate::numerics::prng::Random;

/// Two joints on motions of some frequencies up to 1.2 Hz.
struct Joints {
    waves: Vec<Vec<[f64; 3]>>,
}

impl Joints {
    fn new(random: &mut Random) -> Self {
        let wave = |k: u32, random: &mut Random| {
            let f = 0.23 * (f64::from(k) + random.uniform(-0.3, 0.3));
            [TAU * f, random.uniform(0.1, 0.4), random.uniform(0.0, TAU)]
        };
        Self { waves: (0..2).map(|_| (1..=5).map(|k| wave(k, random)).collect()).collect() }
    }

    /// Position of a joint, or its derivative of order `derivative`.
    fn at(&self, joint: usize, t: f64, derivative: i32) -> f64 {
        let lead = 0.25 * TAU * f64::from(derivative);
        self.waves[joint].iter().map(|[w, a, p]| a * w.powi(derivative) * (w * t + p + lead).sin()).sum()
    }

    /// A log sampled at `times` and stamped at `stamps`, with encoders of these steps. Torques are
    /// accelerations times 1 kg m^2.
    fn log(&self, times: &[f64], stamps: &[f64], steps: [f64; 2]) -> Vec<u8> {
        let mut text = String::from("t,q1,q2,tau1,tau2\n");
        for (t, stamp) in times.iter().zip(stamps) {
            let read = |j: usize| (self.at(j, *t, 0) / steps[j]).round() * steps[j];
            let tau = [self.at(0, *t, 2), self.at(1, *t, 2)];
            text.push_str(&format!("{stamp:.6},{:.9},{:.9},{:.6},{:.6}\n", read(0), read(1), tau[0], tau[1]));
        }
        text.into_bytes()
    }
}

fn motions(log: &[u8], prepare: &Prepare) -> (Vec<Motion>, Prepared) {
    let mut motions = Vec::new();
    let prepared = each_motion(open("log.csv", log).unwrap().as_mut(), 2, prepare, |m| motions.push(m.clone()));
    (motions, prepared.unwrap())
}

/// Root mean square error of a joint's filtered series, compared with the derivative of its
/// position.
fn error(motion: &Motion, joints: &Joints, joint: usize, derivative: i32) -> f64 {
    let len = motion.states.len;
    let series = [&motion.states.q, &motion.states.dq, &motion.states.ddq][derivative as usize];
    let square = |k: usize| (series[joint * len + k] - joints.at(joint, motion.time(k), derivative)).powi(2);
    // Leaves out a second at both ends, where the low-pass is one-sided.
    let edge = (1.0 / motion.period) as usize;
    let inner = motion.core.start + edge..motion.core.end - edge;
    (inner.clone().map(square).sum::<f64>() / inner.len() as f64).sqrt()
}

fn even(rate: f64, seconds: f64) -> Vec<f64> {
    (0..(rate * seconds) as usize).map(|k| k as f64 / rate).collect()
}

fn adaptive(cutoff: f64) -> Prepare {
    Prepare { filter: Some(Filter { order: 4, cutoff }), adaptive: true, ..Prepare::default() }
}

/// Each joint gets a band according to its encoder: the coarse one's acceleration improves, the
/// fine one keeps a wider band, and errors are as estimated.
#[test]
fn each_joint_gets_the_band_that_its_encoder_deserves() {
    for seed in 1..6 {
        let joints = Joints::new(&mut Random::new(seed));
        let times = even(100.0, 40.0);
        let log = joints.log(&times, &times, [1e-3, 1e-6]);
        let (found, _) = motions(&log, &adaptive(15.0));
        let (fixed, _) = motions(&log, &Prepare { adaptive: false, ..adaptive(15.0) });
        let band = &found[0].band;
        assert!(band.narrow[0].cutoff < 5.0 && band.narrow[1].cutoff > band.narrow[0].cutoff, "{band:?}");
        assert!(error(&found[0], &joints, 0, 2) < 0.3 * error(&fixed[0], &joints, 0, 2));
        // Rounding of slow motion is not white: the position error has low frequencies that no
        // derivative shows.
        for derivative in [1, 2] {
            let ratio = found[0].error[0][derivative as usize] / error(&found[0], &joints, 0, derivative);
            assert!((0.5..2.0).contains(&ratio), "seed {seed}, derivative {derivative}: {ratio}");
        }
        // Torques keep the widest band, so nothing that the fine joint shows is lost.
        assert_eq!(found[0].bandwidth, Some(band.narrow[1].cutoff));
    }
}

/// A given cutoff is the only one, whatever the noise.
#[test]
fn a_given_cutoff_is_obeyed() {
    let joints = Joints::new(&mut Random::new(3));
    let times = even(100.0, 20.0);
    let log = joints.log(&times, &times, [1e-3, 1e-6]);
    for cutoff in [4.0, 12.0, 30.0] {
        let prepare = Prepare { adaptive: false, ..adaptive(cutoff) };
        let (found, _) = motions(&log, &prepare);
        let motion = &found[0];
        assert!(motion.band.narrow.iter().all(|filter| *filter == prepare.filter.unwrap()), "{:?}", motion.band);
        assert!(motion.band.wide.is_empty() && motion.bandwidth == Some(cutoff));
        let read: Vec<f64> = times.iter().map(|t| (joints.at(0, *t, 0) / 1e-3).round() * 1e-3).collect();
        let mut q = read.clone();
        let sos = low_pass(4, cutoff, 100.0).unwrap();
        sos.forward_backward(&mut q, ((100.0 / cutoff).ceil() as usize).max(sos.scipy_padding()));
        let ddq = central_second(&q, 0.01);
        let first = ((motion.start - times[0]) / 0.01).round() as usize;
        // Away from the ends, where the reflection matters.
        let inner = motion.core.start + 200..motion.core.end - 200;
        let off = inner.map(|k| (motion.states.ddq[k] - ddq[first + k]).abs()).fold(0.0, f64::max);
        assert!(off < 1e-6, "{cutoff} Hz: {off}");
    }
}

/// Rows sampled up to half a period off their stamps are moved back to their times, with a note;
/// torques are moved with them.
#[test]
fn rows_are_moved_to_the_times_at_which_they_were_sampled() {
    for seed in 1..4 {
        let mut random = Random::new(seed);
        let joints = Joints::new(&mut random);
        let stamps = even(50.0, 60.0);
        let times: Vec<f64> = stamps.iter().map(|t| t + random.uniform(-0.008, 0.008)).collect();
        let uneven = Prepare { keep: Acceptance::all(), ..adaptive(10.0) };
        let (right, _) = motions(&joints.log(&times, &times, [1e-5; 2]), &uneven);
        let (found, prepared) = motions(&joints.log(&times, &stamps, [1e-5; 2]), &adaptive(10.0));
        let is_found =
            |kind: &Kind| matches!(kind, Kind::Evened { clock: Clock::Found { rms } } if (0.002..0.008).contains(rms));
        assert!(prepared.findings.iter().any(|f| is_found(&f.kind)), "{:?}", prepared.findings);
        // Error of the acceleration due to a wrong clock, behind the same low-pass.
        let wrong = {
            let mut q: Vec<f64> = times.iter().map(|t| joints.at(0, *t, 0)).collect();
            low_pass(4, 10.0, 50.0).unwrap().forward_backward(&mut q, 20);
            let ddq = central_second(&q, 0.02);
            let square = |k: usize| (ddq[k] - joints.at(0, stamps[k], 2)).powi(2);
            (100..2900).map(square).sum::<f64>() / 2800.0
        }
        .sqrt();
        let own = error(&found[0], &joints, 0, 2);
        assert!(own < 0.5 * wrong, "{own} of {wrong}");
        assert!(error(&right[0], &joints, 0, 2) <= own);
        assert!(found[0].clock_error > 0.0 && found[0].clock_error < 0.004, "{}", found[0].clock_error);
    }
}

/// Moving rows to their times smooths the noise of the torques; the stated noise is what is left,
/// also behind a low-pass of the torques.
#[test]
fn torque_noise_of_moved_rows_is_what_is_left_of_it() {
    let mut random = Random::new(8);
    let joints = Joints::new(&mut random);
    let stamps = even(50.0, 60.0);
    let times: Vec<f64> = stamps.iter().map(|t| t + random.uniform(-0.008, 0.008)).collect();
    let mut text = String::from("t,q1,q2,tau1,tau2\n");
    for (t, stamp) in times.iter().zip(&stamps) {
        let tau = [0, 1].map(|j| joints.at(j, *t, 2) + random.even(3.0_f64.sqrt()));
        let q = [0, 1].map(|j| joints.at(j, *t, 0));
        text.push_str(&format!("{stamp:.6},{:.6},{:.6},{:.6},{:.6}\n", q[0], q[1], tau[0], tau[1]));
    }
    for (raw_torque, range) in [(true, 0.6..0.95), (false, 0.3..0.8)] {
        let (found, _) = motions(text.as_bytes(), &Prepare { raw_torque, ..adaptive(10.0) });
        let motion = &found[0];
        let inner = motion.core.start + 50..motion.core.end - 50;
        let square = |k: usize| (motion.tau[k] - joints.at(0, motion.time(k), 2)).powi(2);
        let seen = (inner.clone().map(square).sum::<f64>() / inner.len() as f64).sqrt();
        let stated = motion.torque_noise[0];
        assert!(range.contains(&seen) && (0.85..1.2).contains(&(stated / seen)), "{stated} {seen}");
    }
}

/// The stated velocity noise is that of white noise behind low-pass and difference.
#[test]
fn velocity_noise_is_that_of_the_filter() {
    let mut random = Random::new(31);
    for (cutoff, rate) in [(10.0, 200.0), (10.0, 1000.0), (25.0, 1000.0)] {
        let filter = Filter { order: 5, cutoff };
        let mut q: Vec<f64> = (0..100_000).map(|_| 1e-4 * random.even(3.0_f64.sqrt())).collect();
        low_pass(5, cutoff, rate).unwrap().forward_backward(&mut q, 1000);
        let v = central(&q, 1.0 / rate);
        let inner = &v[2000..98_000];
        let std = (inner.iter().map(|v| v * v).sum::<f64>() / inner.len() as f64).sqrt();
        let ratio = filter.velocity_noise(1e-4, rate) / std;
        // The low-pass has no sharp edge.
        assert!((0.85..1.2).contains(&ratio), "{cutoff} Hz of {rate} Hz: {ratio}");
    }
}

/// The torque of the gears is that of the motors (torque or current) minus that of the joints,
/// which is the load.
#[test]
fn torques_on_both_sides_of_the_gears() {
    let joints = Joints::new(&mut Random::new(12));
    let times = even(200.0, 5.0);
    let log = |motors: &str, gain: [f64; 2]| {
        let mut text = format!("t,q1,q2,tau1,tau2,{motors}1,{motors}2\n");
        for t in &times {
            let [q, tau, gear] = [0, 2, 1].map(|d| [0, 1].map(|j| joints.at(j, *t, d)));
            let motor = [0, 1].map(|j| (tau[j] + 0.3 * gear[j]) / gain[j]);
            text.push_str(&format!(
                "{t},{:.9},{:.9},{:.9},{:.9},{:.9},{:.9}\n",
                q[0], q[1], tau[0], tau[1], motor[0], motor[1]
            ));
        }
        text.into_bytes()
    };
    let gears = Prepare { transmission: true, raw_torque: true, ..Prepare::default() };
    let constants = vec![Some(4.0), Some(-0.5)];
    let cases = [
        ("taum", [1.0, 1.0], Prepare { torque: Quantity::Taum, ..gears.clone() }),
        ("i", [4.0, -0.5], Prepare { torque: Quantity::Current, torque_constants: constants, ..gears }),
    ];
    for (motors, gain, prepare) in cases {
        let (found, prepared) = motions(&log(motors, gain), &prepare);
        assert_eq!(prepared.both_torques, motors == "taum");
        for motion in &found {
            let len = motion.states.len;
            for (j, k) in (0..2).flat_map(|j| motion.core.clone().map(move |k| (j, k))) {
                let t = motion.time(k);
                let at = j * len + k;
                assert!((motion.tau[at] - 0.3 * joints.at(j, t, 1)).abs() < 1e-6, "{motors} {j} {t}");
                assert!((motion.load[at] - joints.at(j, t, 2)).abs() < 1e-6, "{motors} {j} {t}");
            }
        }
        assert!(!found.is_empty());
    }
    // A disconnected sensor behind the gear is detected like any other.
    let off: Vec<u8> =
        String::from_utf8(log("taum", [1.0; 2])).unwrap().lines().enumerate().fold(Vec::new(), |mut all, (k, line)| {
            let mut cells: Vec<&str> = line.split(',').collect();
            if k > 0 {
                cells[4] = "0";
            }
            all.extend_from_slice(cells.join(",").as_bytes());
            all.push(b'\n');
            all
        });
    let prepare = Prepare { torque: Quantity::Taum, transmission: true, ..Prepare::default() };
    let refused =
        each_motion(open("off.csv", &off[..]).unwrap().as_mut(), 2, &prepare, |_| {}).unwrap_err().to_string();
    assert!(refused.contains("`tau2`"), "{refused}");
}
