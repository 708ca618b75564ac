//! Measures the time for 10,000 samples of seven joints: `cargo test --release
//! identify::tests::speed -- --ignored --nocapture`.

use std::time::Instant;

use super::*;
use crate::model::{Arm, BaseParameter, Description, DriveTerm, Inertial, StandardParameter, States};

/// Seven joints, 57 columns with the structure of a serial arm: joint `j` depends on the inertial
/// parameters of the links from `j` on.
struct Wide(Description);

impl Wide {
    fn new() -> Self {
        use Inertial::{MSX, MSY, XX, XY, XZ, YZ, ZZ};
        let link = |row| [XX, XY, XZ, YZ, ZZ, MSX, MSY].map(|which| StandardParameter::Link(row, which));
        let drives = [DriveTerm::FV, DriveTerm::FC].into_iter();
        let drives = drives.flat_map(|term| (0..7).map(move |row| StandardParameter::Drive(row, term)));
        let leaders = std::iter::once(StandardParameter::Link(0, ZZ)).chain((1..7).flat_map(link)).chain(drives);
        let leaders: Vec<StandardParameter> = leaders.collect();
        let acts = |joint: usize, leader: &StandardParameter| match *leader {
            StandardParameter::Link(row, _) => row >= joint,
            StandardParameter::Drive(row, _) => row == joint,
            _ => false,
        };
        let columns =
            |joint| leaders.iter().enumerate().filter(move |(_, p)| acts(joint, p)).map(move |(c, _)| (joint, c));
        let pattern = (0..7).flat_map(columns).collect();
        let base = leaders.iter().map(|leader| BaseParameter {
            leader: *leader,
            name: leader.to_string(),
            grouping: leader.to_string(),
            coefficients: vec![],
            unit: String::new(),
        });
        let base = base.collect();
        Self(Description { name: "wide".into(), dof: 7, standard: Vec::new(), base, pattern })
    }
}

impl Arm for Wide {
    fn description(&self) -> &Description {
        &self.0
    }
    /// Returns cheap numbers of the right shape: the model's own time is not measured here.
    fn base_regressor(&self, states: &States, out: &mut [f64]) {
        let n = states.len;
        for (k, &(row, column)) in self.0.pattern.iter().enumerate() {
            for s in 0..n {
                let (q, v) = (states.q[row * n + s], states.dq[(column % 7) * n + s]);
                out[k * n + s] =
                    q * (1.0 + 0.1 * k as f64) + v * (0.3 * (k * k) as f64).sin() + ((s * (k + 3)) % 17) as f64 * 0.1;
            }
        }
    }
    fn inverse_dynamics(&self, _: &States, _: &[f64], _: &mut [f64]) {}
}

#[test]
#[ignore = "measures time"]
fn ten_thousand_samples() {
    let arm = Wide::new();
    let len = 10_000;
    let mut normal = Normal::new(1);
    let mut random = || (0..7 * len).map(|_| normal.next()).collect::<Vec<f64>>();
    let states = States { len, q: random(), dq: random(), ddq: random() };
    let mut regressor = vec![0.0; arm.base_pattern().len() * len];
    arm.base_regressor(&states, &mut regressor);
    let mut tau = random();
    for (k, &(row, column)) in arm.base_pattern().iter().enumerate() {
        (0..len).for_each(|s| tau[row * len + s] += regressor[k * len + s] * (1.0 + column as f64));
    }
    let m = Motion {
        period: 1e-3,
        states,
        tau,
        core: 0..len,
        stride: 1,
        velocity_noise: vec![0.0; 7],
        position_noise: Vec::new(),
        temperature: Vec::new(),
        motor: Vec::new(),
        ..Default::default()
    };
    eprintln!("{} columns, {} entries", arm.base_parameters().len(), arm.base_pattern().len());
    for _ in 0..5 {
        let start = Instant::now();
        let mut out = vec![0.0; arm.base_pattern().len() * 256];
        let mut block = crate::data::signal::MotionBlock::default();
        let mut from = 0;
        loop {
            let count = m.gather(from, 256, &mut block);
            if count == 0 {
                break;
            }
            arm.base_regressor(&block.states, &mut out[..arm.base_pattern().len() * count]);
            from += count;
        }
        let model = start.elapsed();
        let start = Instant::now();
        let mut stack = QrAccumulator::new("speed", &arm, AccumulatorSettings::default());
        stack.absorb(&m);
        let f = [stack.finish()];
        let factor = start.elapsed() - model;
        let start = Instant::now();
        let found = solve(&arm, &f, &[], &IdentifySettings::default()).unwrap();
        let solved = start.elapsed();
        let start = Instant::now();
        let essential =
            IdentifySettings { essential: Some(crate::identify::Essential::default()), ..Default::default() };
        solve(&arm, &f, &[], &essential).unwrap();
        eprintln!(
            "factor {:.1} ms, solve {:.1} ms ({} rounds), with essential {:.1} ms; model {:.1} ms",
            1e3 * factor.as_secs_f64(),
            1e3 * solved.as_secs_f64(),
            found.iterations,
            1e3 * start.elapsed().as_secs_f64(),
            1e3 * model.as_secs_f64()
        );
    }
}

/// An hour of seven joints at 1 kHz, generated while it is read: a piece of 16 s, repeated.
struct Hour {
    piece: Vec<String>,
    row: usize,
    rest: Vec<u8>,
}

impl std::io::Read for Hour {
    fn read(&mut self, out: &mut [u8]) -> std::io::Result<usize> {
        while self.rest.is_empty() && self.row < 3_600_000 {
            for _ in 0..64 {
                let cells = &self.piece[self.row % self.piece.len()];
                self.rest.extend_from_slice(format!("{:.3}{cells}\n", self.row as f64 * 1e-3).as_bytes());
                self.row += 1;
            }
        }
        let n = self.rest.len().min(out.len());
        out[..n].copy_from_slice(&self.rest[..n]);
        self.rest.drain(..n);
        Ok(n)
    }
}

#[test]
#[ignore = "measures time and memory"]
fn an_hour_in_bounded_memory() {
    let arm = Wide::new();
    let mut normal = Normal::new(2);
    let piece = (0..16_000).map(|k| {
        let x = std::f64::consts::TAU * k as f64 / 16_000.0;
        let q = (0..7).map(|j| format!(",{:.6}", (x * (j + 1) as f64).sin() + 0.3 * (x * (3 * j + 2) as f64).cos()));
        q.chain((0..7).map(|j| format!(",{:.4}", 10.0 * (x * (j + 1) as f64).cos() + normal.next()))).collect()
    });
    let header = "t,q1,q2,q3,q4,q5,q6,q7,tau1,tau2,tau3,tau4,tau5,tau6,tau7\n";
    let hour = Hour { piece: piece.collect(), row: 0, rest: header.into() };
    let start = Instant::now();
    let mut stack = QrAccumulator::new("hour", &arm, AccumulatorSettings::default());
    let mut source = crate::data::log::open("hour.csv", hour).unwrap();
    let prepared =
        crate::data::signal::each_motion(source.as_mut(), 7, &Default::default(), |m| stack.absorb(m)).unwrap();
    let read = start.elapsed();
    let found = solve(&arm, &[stack.finish()], &[], &IdentifySettings::default()).unwrap();
    let memory = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let peak = memory.lines().find(|l| l.starts_with("VmHWM")).unwrap_or("peak unknown");
    eprintln!(
        "{} samples in {:.1} s, solve {:.1} ms; {peak}",
        prepared.samples,
        read.as_secs_f64(),
        1e3 * (start.elapsed() - read).as_secs_f64()
    );
    assert!(found.samples > 20_000_000);
}
