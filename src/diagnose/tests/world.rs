//! A robot whose torques come from the numeric recursion. Its effects are written from the
//! literature, independently of the laws of the diagnosis. Examples are a stiff spring-like bristle
//! with a Stribeck curve of its own, and springs solved for the link's angle.

use std::cell::RefCell;

use dh_codegen::arm::param;
use dh_codegen::robot::Robot;

use crate::data::log::open;
use crate::data::signal::each_motion;
use crate::diagnose::{HIGHEST, Recording, Stretch, preparation};
use crate::model::States;
use crate::model::rigid_body::Numeric;
use crate::numerics::prng::Random;
use crate::numerics::sums::root_mean_square;

/// A hidden effect.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Hidden {
    Nothing,
    Stribeck {
        speed: f64,
    },
    SquareViscous,
    RootViscous,
    Load,
    Bristle {
        distance: f64,
    },
    Warming {
        time: f64,
    },
    Bump {
        at: f64,
        width: f64,
    },
    Ripple {
        order: f64,
    },
    Spring {
        stiffness: f64,
    },
    Elastic,
    Gain,
    Offset,
    Viscous,
    Coulomb,
    Saturation,
    Zero,
    Payload,
    Tilt,
    Delay {
        all: bool,
    },
    Contact,
    Rotor,
    Asymmetric,
    /// Outside of the vocabulary: an oscillation in time.
    Beat,
    /// Outside of the vocabulary: depends on another joint's motion.
    Cross,
}

impl Hidden {
    pub(super) fn name(&self) -> &'static str {
        match self {
            Self::Nothing => "nothing_wrong",
            Self::Stribeck { .. } => "stribeck_friction",
            Self::SquareViscous | Self::RootViscous => "nonlinear_viscous_friction",
            Self::Load => "load_dependent_friction",
            Self::Bristle { .. } => "presliding_hysteresis",
            Self::Warming { .. } => "friction_drift",
            Self::Bump { .. } => "position_dependent_friction",
            Self::Ripple { .. } => "torque_ripple",
            Self::Spring { .. } => "joint_spring",
            Self::Elastic => "joint_elasticity",
            Self::Gain => "torque_gain_error",
            Self::Offset => "torque_offset",
            Self::Viscous => "viscous_friction",
            Self::Coulomb => "coulomb_friction",
            Self::Saturation => "torque_saturation",
            Self::Zero => "encoder_offset",
            Self::Payload => "payload",
            Self::Tilt => "base_tilt",
            Self::Delay { .. } => "time_delay",
            Self::Contact => "external_contact",
            Self::Rotor => "rotor_inertia",
            Self::Asymmetric => "asymmetric_friction",
            Self::Beat | Self::Cross => "unknown",
        }
    }
}

/// Multi-sine motions within the joints' limits, `[position, velocity, acceleration]` per joint and
/// sample.
pub(super) fn motion(robot: &Robot, seconds: f64, rate: f64, random: &mut Random) -> Vec<Vec<[f64; 3]>> {
    let n = (seconds * rate) as usize;
    robot
        .moving()
        .into_iter()
        .map(|row| {
            let limits = &robot.joints[row].limits;
            let [low, high] = limits.position.unwrap_or([-2.0, 2.0]);
            let (low, high) = (low.max(-2.6), high.min(2.6));
            let fastest = limits.velocity.unwrap_or(2.0).min(2.5);
            let waves: Vec<[f64; 3]> = (1..=5)
                .map(|k| {
                    let w = std::f64::consts::TAU * (0.1 * f64::from(k) + random.uniform(0.0, 0.05));
                    [random.uniform(0.3, 1.0) / f64::from(k), w, random.uniform(0.0, std::f64::consts::TAU)]
                })
                .collect();
            let (mut size, mut speed) = (0.0_f64, 0.0_f64);
            for i in 0..n {
                let t = i as f64 / rate;
                let (mut q, mut v) = (0.0, 0.0);
                for [a, w, p] in &waves {
                    q += a * (w * t + p).sin();
                    v += a * w * (w * t + p).cos();
                }
                (size, speed) = (size.max(f64::abs(q)), speed.max(f64::abs(v)));
            }
            let scale = (0.45 * (high - low) / size).min(0.7 * fastest / speed);
            (0..n)
                .map(|i| {
                    let t = i as f64 / rate;
                    let mut s = [0.5 * (low + high), 0.0, 0.0];
                    for [a, w, p] in &waves {
                        s[0] += scale * a * (w * t + p).sin();
                        s[1] += scale * a * w * (w * t + p).cos();
                        s[2] -= scale * a * w * w * (w * t + p).sin();
                    }
                    s
                })
                .collect()
        })
        .collect()
}

/// A simulated robot with hidden effects (effect, joint, size in units of the noise).
pub(super) struct World<'a> {
    pub robot: &'a Robot,
    pub hidden: Vec<(Hidden, usize, f64)>,
    /// Noise of each joint's torque, N m.
    pub noise: &'a [f64],
    pub rate: f64,
    /// Sizes computed for the first log and reused for the others, which have the same physics.
    pub sizes: RefCell<Vec<f64>>,
}

impl World<'_> {
    /// Noise-free torques along a motion: per joint and sample, N m.
    fn torques(
        &self,
        q: &[Vec<[f64; 3]>],
        change: &dyn Fn(usize, usize, [f64; 3]) -> [f64; 3],
        robot: &Robot,
    ) -> Vec<Vec<f64>> {
        let numeric = Numeric::new(robot);
        let phi = param::standard_values(robot).unwrap();
        let (dof, n) = (q.len(), q[0].len());
        let mut work = numeric.workspace();
        let mut tau = vec![0.0; dof];
        let mut out = vec![vec![0.0; n]; dof];
        for k in 0..n {
            let state: Vec<[f64; 3]> = (0..dof).map(|j| change(j, k, q[j][k])).collect();
            let pick = |i: usize| state.iter().map(|s| s[i]).collect::<Vec<_>>();
            numeric.inverse_dynamics_into(&mut work, &pick(0), &pick(1), &pick(2), &phi, &mut tau);
            (0..dof).for_each(|j| out[j][k] = tau[j]);
        }
        out
    }

    /// Size of an effect, computed for the first log.
    fn sized(&self, number: usize, make: impl FnOnce() -> f64) -> f64 {
        if let Some(size) = self.sizes.borrow().get(number) {
            return *size;
        }
        let size = make();
        self.sizes.borrow_mut().push(size);
        size
    }

    /// Torque of an effect, at unit size or at a physical one, scaled to the desired root mean
    /// square.
    fn effect(
        &self,
        number: usize,
        hidden: &Hidden,
        j: usize,
        q: &[Vec<[f64; 3]>],
        clean: &[Vec<f64>],
        size: f64,
    ) -> Vec<Vec<f64>> {
        let (dof, n) = (q.len(), q[0].len());
        let mut out = vec![vec![0.0; n]; dof];
        let sign = |v: f64| (v / 2e-3).tanh();
        let own = |f: &dyn Fn(usize, [f64; 3]) -> f64| (0..n).map(|k| f(k, q[j][k])).collect::<Vec<f64>>();
        let same = |_: usize, _: usize, s: [f64; 3]| s;
        // Scales a torque on joint j to the wanted size.
        let scaled = |mut x: Vec<f64>| {
            let by = self.sized(number, || size / root_mean_square(&x).max(1e-12));
            x.iter_mut().for_each(|x| *x *= by);
            x
        };
        // Finds the size of a change of the arm that gives the wanted torque on joint j.
        let searched = |at: f64, make: &dyn Fn(f64) -> Vec<Vec<f64>>| {
            let x = self.sized(number, || {
                let mut x = at;
                for _ in 0..4 {
                    let found = make(x);
                    let now = (0..dof).map(|k| root_mean_square(&found[k]) / self.noise[k]).fold(0.0, f64::max)
                        * self.noise[j];
                    x *= size / now.max(1e-15);
                }
                x
            });
            make(x)
        };
        let minus = |mut a: Vec<Vec<f64>>| {
            for (a, b) in a.iter_mut().zip(clean) {
                a.iter_mut().zip(b).for_each(|(a, b)| *a -= b);
            }
            a
        };
        match hidden {
            Hidden::Nothing => {}
            // Bo and Pavelescu's exponent 1.4, not the Gaussian one that the search starts from.
            Hidden::Stribeck { speed } => {
                out[j] = scaled(own(&|_, s| sign(s[1]) * (-(s[1].abs() / speed).powf(1.4)).exp()))
            }
            Hidden::SquareViscous => out[j] = scaled(own(&|_, s| s[1] * s[1].abs())),
            Hidden::RootViscous => out[j] = scaled(own(&|_, s| sign(s[1]) * s[1].abs().powf(0.6))),
            Hidden::Load => {
                let mut smooth = self.robot.clone();
                for joint in &mut smooth.joints {
                    (joint.drive.viscous_friction, joint.drive.coulomb_friction) = (None, None);
                }
                let rigid = self.torques(q, &same, &smooth);
                out[j] = scaled(own(&|k, s| sign(s[1]) * rigid[j][k].abs()));
            }
            Hidden::Bristle { distance } => {
                // LuGre model with a Stribeck level, ten steps per sample.
                let mut z = 0.0;
                let mut x = Vec::with_capacity(n);
                for k in 0..n {
                    let v = q[j][k][1];
                    let level = 1.0 + 0.15 * (-(v / 0.05).powi(2)).exp();
                    for _ in 0..10 {
                        z += (v - v.abs() * z / (level * distance)) / self.rate / 10.0;
                    }
                    x.push(z / distance);
                }
                out[j] = scaled(x);
            }
            Hidden::Warming { time } => {
                out[j] = scaled(own(&|k, s| (sign(s[1]) + 0.6 * s[1]) * (-(k as f64) / self.rate / time).exp()));
            }
            Hidden::Bump { at, width } => {
                out[j] = scaled(own(&|_, s| sign(s[1]) * (-((s[0] - at) / width).powi(2)).exp()))
            }
            Hidden::Ripple { order } => {
                out[j] = scaled(own(&|_, s| (order * s[0] + 0.4).sin() + 0.15 * (2.0 * order * s[0]).sin()));
            }
            Hidden::Spring { stiffness } => out[j] = scaled(own(&|_, s| (stiffness * (s[0] - 0.3)).sinh())),
            Hidden::Offset => out[j] = scaled(own(&|_, _| 1.0)),
            Hidden::Viscous => out[j] = scaled(own(&|_, s| s[1])),
            Hidden::Coulomb => out[j] = scaled(own(&|_, s| sign(s[1]))),
            Hidden::Asymmetric => out[j] = scaled(own(&|_, s| if s[1] > 0.0 { s[1] } else { 0.2 * s[1] })),
            Hidden::Rotor => out[j] = scaled(own(&|_, s| s[2])),
            Hidden::Gain => out[j] = scaled(clean[j].clone()),
            Hidden::Beat => out[j] = scaled(own(&|k, _| (std::f64::consts::TAU * 1.37 * k as f64 / self.rate).sin())),
            Hidden::Cross => {
                let other = (j + 2) % dof;
                out[j] = scaled((0..n).map(|k| sign(q[other][k][1]) * q[other][k][0].cos()).collect());
            }
            Hidden::Saturation => {
                let mut sizes: Vec<f64> = clean[j].iter().map(|t| t.abs()).collect();
                sizes.sort_by(f64::total_cmp);
                let clip = |bound: f64| clean[j].iter().map(|t| t.clamp(-bound, bound) - t).collect::<Vec<f64>>();
                let bound = self.sized(number, || {
                    let index = (0..100)
                        .find(|i| root_mean_square(&clip(sizes[(n - 1) * (99 - i) / 100])) >= size)
                        .unwrap_or(60);
                    sizes[(n - 1) * (99 - index) / 100]
                });
                out[j] = clip(bound);
            }
            Hidden::Elastic => {
                let mut smooth = self.robot.clone();
                for joint in &mut smooth.joints {
                    (joint.drive.viscous_friction, joint.drive.coulomb_friction) = (None, None);
                }
                let rigid = self.torques(q, &same, &smooth);
                let make = |c: f64| {
                    let wind: Vec<f64> = rigid[j].iter().map(|t| -c * t).collect();
                    let h = 1.0 / self.rate;
                    let d = |x: &[f64], k: usize| (x[(k + 1).min(n - 1)] - x[k.max(1) - 1]) / (2.0 * h);
                    let rate: Vec<f64> = (0..n).map(|k| d(&wind, k)).collect();
                    let second: Vec<f64> = (0..n).map(|k| d(&rate, k)).collect();
                    let change = |i: usize, k: usize, s: [f64; 3]| {
                        if i == j { [s[0] + wind[k], s[1] + rate[k], s[2] + second[k]] } else { s }
                    };
                    let mut torques = self.torques(q, &change, &smooth);
                    for (a, b) in torques.iter_mut().zip(&rigid) {
                        a.iter_mut().zip(b).for_each(|(a, b)| *a -= b);
                    }
                    torques
                };
                out = searched(1e-5, &make);
            }
            Hidden::Zero => {
                let make = |o: f64| {
                    let change = |i: usize, _: usize, s: [f64; 3]| if i == j { [s[0] + o, s[1], s[2]] } else { s };
                    minus(self.torques(q, &change, self.robot))
                };
                out = searched(1e-3, &make);
            }
            Hidden::Payload => {
                let make = |m: f64| {
                    let mut robot = self.robot.clone();
                    let mut links = robot.inertias().unwrap();
                    let last = links.len() - 1;
                    let c = [0.03, 0.02, 0.12];
                    let i = [m * 0.0154, m * 0.0163, m * 0.0023, -m * 0.0006, -m * 0.0036, -m * 0.0024];
                    let mut body = [m, m * c[0], m * c[1], m * c[2], 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
                    body[4..].copy_from_slice(&i);
                    links[last] = links[last].plus(&dh_codegen::robot::Inertia::from_array(body));
                    robot.links = links.into_iter().map(Some).collect();
                    robot.tool = None;
                    minus(self.torques(q, &same, &robot))
                };
                out = searched(0.1, &make);
            }
            Hidden::Tilt => {
                let make = |a: f64| {
                    let mut robot = self.robot.clone();
                    let g = 9.81;
                    robot.gravity = [g * a.sin() * 0.8, -g * a.sin() * 0.6, -g * a.cos()];
                    minus(self.torques(q, &same, &robot))
                };
                out = searched(1e-2, &make);
            }
            Hidden::Contact => {
                let numeric = Numeric::new(self.robot);
                let make = |f: f64| {
                    let mut out = vec![vec![0.0; n]; dof];
                    for k in n * 2 / 5..n / 2 {
                        let state: Vec<f64> = (0..dof).map(|i| q[i][k][0]).collect();
                        let jacobian = numeric.jacobian(&state);
                        let force = nalgebra::Vector6::new(0.3, -0.2, 1.0, 0.0, 0.0, 0.0) * f;
                        let tau = jacobian.transpose() * force;
                        (0..dof).for_each(|i| out[i][k] = -tau[i]);
                    }
                    out
                };
                out = searched(5.0, &make);
            }
            Hidden::Delay { all } => {
                let make = |d: f64| {
                    let mut out = vec![vec![0.0; n]; dof];
                    for (i, row) in out.iter_mut().enumerate() {
                        if *all || i == j {
                            for (k, x) in row.iter_mut().enumerate() {
                                let at = (k as f64 - d * self.rate).clamp(0.0, n as f64 - 1.001);
                                let (f, w) = (at as usize, at.fract());
                                *x = clean[i][f] * (1.0 - w) + clean[i][f + 1] * w - clean[i][k];
                            }
                        }
                    }
                    out
                };
                out = searched(5e-3, &make);
            }
        }
        out
    }

    /// The log as bytes of a CSV file.
    pub(super) fn log(&self, seconds: f64, random: &mut Random) -> Vec<u8> {
        let q = motion(self.robot, seconds, self.rate, random);
        let same = |_: usize, _: usize, s: [f64; 3]| s;
        let clean = self.torques(&q, &same, self.robot);
        let (dof, n) = (q.len(), q[0].len());
        let mut tau = clean.clone();
        for (number, (hidden, j, size)) in self.hidden.iter().enumerate() {
            let effect = self.effect(number, hidden, *j, &q, &clean, size * self.noise[*j]);
            for (t, e) in tau.iter_mut().zip(&effect) {
                t.iter_mut().zip(e).for_each(|(t, e)| *t += e);
            }
        }
        let gauss = |random: &mut Random| (0..12).map(|_| random.uniform(0.0, 1.0)).sum::<f64>() - 6.0;
        let mut text = String::from("t");
        (1..=dof).for_each(|j| text.push_str(&format!(",q{j}")));
        (1..=dof).for_each(|j| text.push_str(&format!(",tau{j}")));
        text.push('\n');
        for k in 0..n {
            text.push_str(&format!("{:.4}", k as f64 / self.rate));
            for row in &q {
                text.push_str(&format!(",{:.6}", (row[k][0] / 2e-5).round() * 2e-5));
            }
            for (j, row) in tau.iter().enumerate() {
                text.push_str(&format!(",{:.6}", row[k] + self.noise[j] * gauss(random)));
            }
            text.push('\n');
        }
        text.into_bytes()
    }
}

/// Reads a log as the command does.
pub(super) fn record(name: &str, bytes: &[u8], dof: usize) -> Recording {
    let prepare = preparation(HIGHEST);
    let mut recording = Recording::new(name);
    let mut source = open(name, bytes).unwrap();
    each_motion(source.as_mut(), dof, &prepare, |motion| recording.absorb(motion)).unwrap();
    recording
}

#[test]
fn recordings_hold_what_was_written() {
    let states = States { len: 2, q: vec![0.0, 1.0], ..States::default() };
    let stretch = Stretch {
        start: 0.0,
        period: 0.5,
        states,
        tau: vec![1.0, 2.0],
        temperature: Vec::new(),
        motor: Vec::new(),
        load: Vec::new(),
        velocity_noise: vec![0.0],
        error: Vec::new(),
        torque_noise: Vec::new(),
        clock_error: 0.0,
        stuck: Vec::new(),
        band: Default::default(),
        beside: [const { Vec::new() }; 2],
    };
    assert_eq!(stretch.of(&stretch.tau, 0), [1.0, 2.0]);
}
