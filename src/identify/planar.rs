//! A hand-written planar arm of two links for the tests of identification, with motions and noise.

use crate::data::log::{Layout, Log};
use crate::data::signal::Motion;
use crate::model::{Arm, BaseParameter, Description, DriveTerm, Inertial, StandardParameter, States};

const L: f64 = 0.4;
const G: f64 = 9.81;

/// Two links in a vertical plane, modified DH, `d2 = 0.4 m`, gravity along `-y`, with rotors and
/// friction.
pub(crate) struct Planar(Description);

/// Standard parameters of a plausible arm, in the order of [`Planar::new`].
pub(crate) const STANDARD: [f64; 16] = [
    4.0, 0.9, 0.05, 0.35, // M1 MSX1 MSY1 ZZ1
    2.5, 0.5, -0.03, 0.15, // M2 MSX2 MSY2 ZZ2
    0.2, 0.06, // IA1 IA2
    1.1, 0.6, // FV1 FV2
    0.9, 0.5, // FC1 FC2
    0.15, -0.1, // FO1 FO2
];

impl Planar {
    pub(crate) fn new() -> Self {
        let of_link = |row| {
            [Inertial::M, Inertial::MSX, Inertial::MSY, Inertial::ZZ].map(|which| StandardParameter::Link(row, which))
        };
        let drives = DriveTerm::ALL.into_iter().flat_map(|term| [0, 1].map(|row| StandardParameter::Drive(row, term)));
        let standard: Vec<StandardParameter> = [0, 1].into_iter().flat_map(of_link).chain(drives).collect();
        let base = |name: &str, unit: &str, coefficients: &[(usize, f64)]| {
            let leader = standard[coefficients[0].0];
            let sum = coefficients.iter().map(|(i, k)| match *k {
                1.0 => standard[*i].to_string(),
                k => format!("{k}*{}", standard[*i]),
            });
            let grouping = format!("{name} = {}", sum.collect::<Vec<_>>().join(" + "));
            BaseParameter {
                leader,
                name: name.into(),
                grouping,
                coefficients: coefficients.to_vec(),
                unit: unit.into(),
            }
        };
        let base = vec![
            base("ZZ1R", "kg m^2", &[(3, 1.0), (4, L * L), (8, 1.0)]),
            base("MSX1R", "kg m", &[(1, 1.0), (4, L)]),
            base("MSY1", "kg m", &[(2, 1.0)]),
            base("ZZ2", "kg m^2", &[(7, 1.0)]),
            base("MSX2", "kg m", &[(5, 1.0)]),
            base("MSY2", "kg m", &[(6, 1.0)]),
            base("IA2", "kg m^2", &[(9, 1.0)]),
            base("FV1", "N m s/rad", &[(10, 1.0)]),
            base("FV2", "N m s/rad", &[(11, 1.0)]),
            base("FC1", "N m", &[(12, 1.0)]),
            base("FC2", "N m", &[(13, 1.0)]),
            base("FO1", "N m", &[(14, 1.0)]),
            base("FO2", "N m", &[(15, 1.0)]),
        ];
        let rows: [&[usize]; 2] = [&[0, 1, 2, 3, 4, 5, 7, 9, 11], &[3, 4, 5, 6, 8, 10, 12]];
        let pattern = rows.iter().enumerate().flat_map(|(r, cs)| cs.iter().map(move |c| (r, *c))).collect();
        Self(Description { name: "planar".into(), dof: 2, standard, base, pattern })
    }

    pub(crate) fn beta(&self) -> Vec<f64> {
        crate::identify::regression::recover::base_of(self, &STANDARD)
    }
}

impl Arm for Planar {
    fn description(&self) -> &Description {
        &self.0
    }
    fn base_regressor(&self, states: &States, out: &mut [f64]) {
        let n = states.len;
        let sign = |v: f64| {
            if v > 0.0 {
                1.0
            } else if v < 0.0 {
                -1.0
            } else {
                0.0
            }
        };
        for s in 0..n {
            let at = |x: &[f64], j: usize| x[j * n + s];
            let (q1, q2) = (at(&states.q, 0), at(&states.q, 1));
            let (v1, v2) = (at(&states.dq, 0), at(&states.dq, 1));
            let (a1, a2) = (at(&states.ddq, 0), at(&states.ddq, 1));
            let ((s1, c1), (s2, c2), (s12, c12)) = (q1.sin_cos(), q2.sin_cos(), (q1 + q2).sin_cos());
            let (inertia, turn) = (2.0 * a1 + a2, 2.0 * v1 * v2 + v2 * v2);
            let entries = [
                a1,
                G * c1,
                -G * s1,
                a1 + a2,
                L * (inertia * c2 - turn * s2) + G * c12,
                -L * (inertia * s2 + turn * c2) - G * s12,
                v1,
                sign(v1),
                1.0,
                a1 + a2,
                L * (a1 * c2 + v1 * v1 * s2) + G * c12,
                L * (-a1 * s2 + v1 * v1 * c2) - G * s12,
                a2,
                v2,
                sign(v2),
                1.0,
            ];
            for (k, entry) in entries.into_iter().enumerate() {
                out[k * n + s] = entry;
            }
        }
    }
    fn inverse_dynamics(&self, states: &States, standard: &[f64], out: &mut [f64]) {
        torque(self, states, &crate::identify::regression::recover::base_of(self, standard), out);
    }
}

/// Torque `W beta`, joint-major, N m.
pub(crate) fn torque(arm: &Planar, states: &States, beta: &[f64], out: &mut [f64]) {
    let n = states.len;
    let mut w = vec![0.0; arm.base_pattern().len() * n];
    arm.base_regressor(states, &mut w);
    out.fill(0.0);
    for (k, &(row, column)) in arm.base_pattern().iter().enumerate() {
        for s in 0..n {
            out[row * n + s] += w[k * n + s] * beta[column];
        }
    }
}

/// A motion of some sines, `seconds` long at `rate` Hz, with exact derivatives and torque.
/// Different values of `phase` give different motions.
pub(crate) fn motion(arm: &Planar, seconds: f64, rate: f64, phase: f64) -> Motion {
    let len = (seconds * rate).round() as usize;
    let mut states = States { len, ..States::default() };
    for joint in 0..2 {
        let terms = [[0.5, 0.3, 0.0], [0.4, 0.7, 1.0], [0.25, 1.3, 2.0]].map(|[a, f, p]| {
            (a, std::f64::consts::TAU * f * (1.0 + 0.17 * joint as f64), p + phase + 0.9 * joint as f64)
        });
        let sum = |s: usize, g: &dyn Fn(f64, f64, f64) -> f64| -> f64 {
            terms.iter().map(|&(a, w, p)| g(a, w, w * s as f64 / rate + p)).sum()
        };
        states.q.extend((0..len).map(|s| sum(s, &|a, _, x| a * x.sin())));
        states.dq.extend((0..len).map(|s| sum(s, &|a, w, x| a * w * x.cos())));
        states.ddq.extend((0..len).map(|s| sum(s, &|a, w, x| -a * w * w * x.sin())));
    }
    let mut tau = vec![0.0; 2 * len];
    torque(arm, &states, &arm.beta(), &mut tau);
    Motion {
        period: rate.recip(),
        states,
        tau,
        core: 0..len,
        stride: 1,
        velocity_noise: vec![0.0; 2],
        position_noise: Vec::new(),
        temperature: Vec::new(),
        motor: Vec::new(),
        ..Motion::default()
    }
}

/// The motion as a log of `t, q, tau`.
pub(crate) fn log(motion: &Motion) -> Log {
    let len = motion.states.len;
    let layout = Layout::new("planar.csv", &["t", "q1", "q2", "tau1", "tau2"]).unwrap();
    let mut columns = vec![(0..len).map(|s| motion.time(s)).collect::<Vec<f64>>()];
    for x in [&motion.states.q, &motion.tau] {
        columns.extend(x.chunks(len).map(<[f64]>::to_vec));
    }
    Log { layout, columns, starts: vec![0], findings: Vec::new() }
}

/// Normally distributed numbers by the Box-Muller method from a linear congruential generator,
/// identical on every machine.
pub(crate) struct Normal(u64);

impl Normal {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x1234_5678_9abc_def1)
    }

    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        ((self.0 >> 11) as f64 + 0.5) / (1u64 << 53) as f64
    }

    pub(crate) fn next(&mut self) -> f64 {
        (-2.0 * self.uniform().ln()).sqrt() * (std::f64::consts::TAU * self.uniform()).cos()
    }
}
