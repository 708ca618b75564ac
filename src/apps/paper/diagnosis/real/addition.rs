//! Additions to measured torques: one law of the vocabulary each, evaluated on the measured motion.

use super::session::{Excerpt, Session, torques};
use crate::data::log::{Log, Quantity, Role};
use crate::model::{Contact, DriveTerm, PerturbableArm};
use crate::numerics::prng::Random;
use dh_codegen::robot::effects;

/// A kind of addition.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    Viscous,
    Coulomb,
    Asymmetric,
    Stribeck,
    Cubic,
    Root,
    LoadDependent,
    Payload,
    Link,
    Delay,
    Gain,
    Offset,
    Ripple,
    Spring,
    Contact,
}

impl Form {
    pub(super) const ALL: [Self; 15] = [
        Self::Viscous,
        Self::Coulomb,
        Self::Asymmetric,
        Self::Stribeck,
        Self::Cubic,
        Self::Root,
        Self::LoadDependent,
        Self::Payload,
        Self::Link,
        Self::Delay,
        Self::Gain,
        Self::Offset,
        Self::Ripple,
        Self::Spring,
        Self::Contact,
    ];

    /// Name of the cause in the vocabulary.
    pub(super) fn cause(self) -> &'static str {
        match self {
            Self::Viscous => effects::ViscousFriction::NAME,
            Self::Coulomb => effects::CoulombFriction::NAME,
            Self::Asymmetric => effects::AsymmetricFriction::NAME,
            Self::Stribeck => effects::StribeckFriction::NAME,
            Self::Cubic | Self::Root => effects::NonlinearViscousFriction::NAME,
            Self::LoadDependent => effects::LoadDependentFriction::NAME,
            Self::Payload => effects::Payload::NAME,
            Self::Link => effects::LinkInertiaError::NAME,
            Self::Delay => effects::TimeDelay::NAME,
            Self::Gain => effects::TorqueGainError::NAME,
            Self::Offset => effects::TorqueOffset::NAME,
            Self::Ripple => effects::TorqueRipple::NAME,
            Self::Spring => effects::JointSpring::NAME,
            Self::Contact => effects::ExternalContact::NAME,
        }
    }

    /// Whether a refit of all base parameters explains the addition as well, so that only a fit
    /// with the file's bodies can find its size.
    pub(super) fn within_bodies(self) -> bool {
        matches!(self, Self::Payload | Self::Link | Self::Gain)
    }

    /// Parameter of the arm that it changes.
    pub(super) fn plain(self) -> Option<DriveTerm> {
        match self {
            Self::Viscous => Some(DriveTerm::FV),
            Self::Coulomb => Some(DriveTerm::FC),
            Self::Offset => Some(DriveTerm::FO),
            _ => None,
        }
    }

    /// Whether it acts on the robot rather than on a joint.
    fn whole(self) -> bool {
        matches!(self, Self::Payload | Self::Delay | Self::Contact)
    }

    /// Whether its joint must move for it to act.
    fn needs_motion(self) -> bool {
        !matches!(self, Self::Gain | Self::Offset | Self::Contact)
    }
}

/// An addition with its exact label.
#[derive(Debug, Clone, PartialEq)]
pub struct Added {
    /// Name of the cause.
    pub cause: &'static str,
    /// Joints, from 1; empty for the whole robot.
    pub joints: Vec<usize>,
    /// Equivalent causes with their joints.
    pub same: Vec<(&'static str, Vec<usize>)>,
    /// Parameters: symbol and value.
    pub truth: Vec<(String, f64)>,
    /// Root mean square on each joint over the fitted logs, N m.
    pub rms: Vec<f64>,
}

/// A drawn addition with an undetermined size.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Addition {
    pub(super) form: Form,
    /// Joints, from 1; empty for the whole robot.
    pub(super) joints: Vec<usize>,
    /// Joint of the law, from 0.
    joint: usize,
    /// Largest speed of that joint, rad/s.
    fastest: f64,
    /// Shape parameters of the law: characteristic speed; order and phase; rest position;
    /// direction.
    shape: [f64; 3],
    /// Begin and end of a contact, s, in the first fitted log.
    window: [f64; 2],
}

/// Share of the largest speed below which the sign of a velocity is smoothed.
const REST: f64 = 0.01;

/// Smallest travel, rad, and root mean square speed, rad/s, of a joint that moves.
const MOVES: [f64; 2] = [0.2, 0.05];

fn root_mean_square(x: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = x.fold((0.0, 0), |(sum, count), x| (sum + x * x, count + 1));
    (sum / f64::from(count.max(1))).sqrt()
}

impl Addition {
    /// Joint of the law, from 0.
    pub(super) fn joint(&self) -> usize {
        self.joint
    }

    /// Draws joint and shape; `None` if no joint can show it.
    pub(super) fn draw(form: Form, session: &Session, random: &mut Random) -> Option<Self> {
        let dof = session.numeric.dof();
        let usable = |j: usize| {
            let alive = |e: &Excerpt| e.torque(j).iter().any(|t| *t != 0.0);
            let moves = |e: &Excerpt| {
                let (low, high) =
                    e.of(&e.states.q, j).iter().fold((f64::MAX, f64::MIN), |(l, h), q| (l.min(*q), h.max(*q)));
                high - low > MOVES[0] && root_mean_square(e.of(&e.states.dq, j).iter().copied()) > MOVES[1]
            };
            let everywhere = [&session.fit, &session.validate].iter().all(|logs| logs.iter().any(alive));
            let moving = || [&session.fit, &session.validate].iter().all(|logs| logs.iter().any(moves));
            everywhere && (!form.needs_motion() || moving())
        };
        let joints: Vec<usize> = (0..dof).filter(|&j| usable(j)).collect();
        // A body on the last link is a payload.
        let joints: Vec<usize> =
            if form == Form::Link { joints.into_iter().filter(|j| j + 1 < dof).collect() } else { joints };
        if joints.is_empty() {
            return None;
        }
        let joint = joints[random.below(joints.len())];
        let speeds = || session.fit.iter().flat_map(|e| e.of(&e.states.dq, joint).iter().map(|v| v.abs()));
        let fastest = speeds().fold(1e-6, f64::max);
        let first = session.fit.first()?;
        let [begin, end] = [first.time().first().copied()?, first.time().last().copied()?];
        let contact = random.uniform(1.0, 2.0).min(0.3 * (end - begin));
        let start = random.uniform(begin + 0.1 * (end - begin), end - 0.1 * (end - begin) - contact);
        let q = first.of(&first.states.q, joint);
        let middle = q.iter().sum::<f64>() / q.len().max(1) as f64;
        let angle = random.uniform(0.0, std::f64::consts::TAU);
        let shape = match form {
            Form::Stribeck => [random.uniform(0.05, 0.15) * fastest, 0.0, 0.0],
            // At half of the samples the ripple is slower than four periods per second.
            Form::Ripple => {
                let mut all: Vec<f64> = speeds().collect();
                all.sort_by(f64::total_cmp);
                let most = (25.0 / all[all.len() / 2].max(0.02)).min(150.0);
                [random.uniform(8.0_f64.min(0.5 * most), most).round(), angle, 0.0]
            }
            Form::Spring => [middle + random.uniform(-0.5, 0.5), 0.0, 0.0],
            _ => [0.3 * angle.cos(), 0.3 * angle.sin(), random.uniform(0.5, 1.0)],
        };
        let joints = if form.whole() { Vec::new() } else { vec![joint + 1] };
        Some(Self { form, joints, joint, fastest, shape, window: [start, start + contact] })
    }

    /// Torque that size `x` adds to each joint, N m.
    pub(super) fn signal(&self, session: &Session, e: &Excerpt, x: f64, first: bool) -> Vec<Vec<f64>> {
        let (dof, len, j) = (session.numeric.dof(), e.states.len, self.joint);
        let mut out = vec![vec![0.0; len]; dof];
        let (q, v) = (e.of(&e.states.q, j), e.of(&e.states.dq, j));
        let sign = |v: f64| (v / (REST * self.fastest)).tanh();
        let [a, b, c] = self.shape;
        let mut own = |law: &dyn Fn(usize) -> f64| out[j] = (0..len).map(|k| x * law(k)).collect();
        match self.form {
            Form::Viscous => own(&|k| v[k]),
            Form::Coulomb => own(&|k| sign(v[k])),
            Form::Asymmetric => own(&|k| sign(v[k]).abs()),
            Form::Stribeck => own(&|k| sign(v[k]) * (-(v[k] / a).powi(2)).exp()),
            Form::Cubic => own(&|k| v[k].powi(3)),
            Form::Root => own(&|k| sign(v[k]) * v[k].abs().sqrt()),
            Form::LoadDependent => own(&|k| sign(v[k]) * e.load[j][k].abs()),
            Form::Gain => own(&|k| e.torque(j)[k]),
            Form::Offset => own(&|_| 1.0),
            Form::Ripple => own(&|k| (a * q[k] - b).cos()),
            Form::Spring => own(&|k| q[k] - a),
            Form::Payload | Form::Link => {
                let row = if self.form == Form::Payload { dof - 1 } else { j };
                let center =
                    if self.form == Form::Payload { [0.1 * a, 0.1 * b, 0.1] } else { [0.3 * a, 0.3 * b, 0.1 * c] };
                let mut standard = vec![0.0; session.numeric.parameters()];
                let first = 10 * session.plant.rows()[row];
                standard[first..first + 10].copy_from_slice(&point(x, center));
                out = torques(&session.numeric, &e.states, &standard);
            }
            Form::Delay => {
                for (j, row) in out.iter_mut().enumerate() {
                    *row = delayed(e, j, x).iter().zip(e.torque(j)).map(|(late, now)| late - now).collect();
                }
            }
            Form::Contact if first => {
                let mut unit = vec![0.0; 6 * dof * len];
                session.plant.wrench_columns(&e.states, Contact { link: None, in_base: true }, &mut unit);
                let force = [a, b, c];
                let acts = |t: f64| (self.window[0]..self.window[1]).contains(&t);
                for (j, row) in out.iter_mut().enumerate() {
                    for k in (0..len).filter(|&k| acts(e.time()[k])) {
                        row[k] = (0..3).map(|c| -x * force[c] * unit[(c * dof + j) * len + k]).sum();
                    }
                }
            }
            Form::Contact => {}
        }
        // A sensor that was off stays off.
        for (j, row) in out.iter_mut().enumerate() {
            if e.torque(j).iter().all(|t| *t == 0.0) {
                row.fill(0.0);
            }
        }
        out
    }

    /// Root mean square on the fitted logs (of a contact while it acts), per joint, N m.
    fn rms(&self, session: &Session, x: f64) -> Vec<f64> {
        let all: Vec<Vec<Vec<f64>>> =
            session.fit.iter().enumerate().map(|(n, e)| self.signal(session, e, x, n == 0)).collect();
        let counts = |v: &f64| self.form != Form::Contact || *v != 0.0;
        (0..session.numeric.dof())
            .map(|j| root_mean_square(all.iter().flat_map(|rows| rows[j].iter().copied()).filter(counts)))
            .collect()
    }

    /// Value of `x` at which the root mean square on its joint, or on the most affected joint, is
    /// `size` residuals; `None` if the value would be implausible.
    pub(super) fn sized(&self, session: &Session, size: f64) -> Option<f64> {
        let mut x = if self.form == Form::Delay { 1e-3 } else { 1.0 };
        for _ in 0..6 {
            let rms = self.rms(session, x);
            let by = |j: usize| rms[j] / session.residual[j].max(1e-9);
            let now = match self.joints.first() {
                Some(_) if self.form != Form::Link => by(self.joint),
                _ => (0..rms.len()).map(by).fold(0.0, f64::max),
            };
            if !(now.is_finite() && now > 0.0) {
                return None;
            }
            x *= size / now;
            if (now / size - 1.0).abs() < 1e-3 {
                break;
            }
        }
        let most = match self.form {
            Form::Delay => 0.1,
            Form::Gain | Form::LoadDependent => 0.6,
            Form::Payload | Form::Link => 20.0,
            _ => f64::INFINITY,
        };
        (x < most).then_some(x)
    }

    /// A log with the addition.
    pub(super) fn to(&self, session: &Session, e: &Excerpt, x: f64, first: bool) -> Log {
        let mut log = e.log.clone();
        for (j, row) in self.signal(session, e, x, first).into_iter().enumerate() {
            if let Some(at) = log.layout.find(Role::Joint(Quantity::Tau, j)) {
                log.columns[at].iter_mut().zip(row).for_each(|(tau, by)| *tau += by);
            }
        }
        log
    }

    /// Label of the addition of size `x`.
    pub(super) fn added(&self, session: &Session, x: f64) -> Added {
        let dof = session.numeric.dof();
        let drive = &session.robot.joints[session.plant.rows()[self.joint]].drive;
        let (fv, fc) = (drive.viscous_friction.unwrap_or(0.0), drive.coulomb_friction.unwrap_or(0.0));
        let [a, b, c] = self.shape;
        use effects::*;
        let truth = match self.form {
            Form::Viscous => vec![(ViscousFriction::FV, fv + x)],
            Form::Coulomb => vec![(CoulombFriction::FC, fc + x)],
            Form::Asymmetric => vec![(AsymmetricFriction::FCA, x)],
            Form::Stribeck => vec![(StribeckFriction::FS, fc + x), (StribeckFriction::VS, a)],
            Form::Cubic => vec![(NonlinearViscousFriction::FN, x), (NonlinearViscousFriction::EN, 3.0)],
            Form::Root => vec![(NonlinearViscousFriction::FN, x), (NonlinearViscousFriction::EN, 0.5)],
            Form::LoadDependent => vec![(LoadDependentFriction::FL, x)],
            Form::Payload => vec![(Payload::M, x)],
            Form::Link => Vec::new(),
            Form::Delay => vec![(TimeDelay::TD, x)],
            Form::Gain => vec![(TorqueGainError::GT, 1.0 + x)],
            Form::Offset => vec![(TorqueOffset::TO, x)],
            Form::Ripple => {
                vec![(TorqueRipple::RN, a), (TorqueRipple::RC, x * b.cos()), (TorqueRipple::RS, x * b.sin())]
            }
            Form::Spring => vec![(JointSpring::KS, x), (JointSpring::QS, a)],
            Form::Contact => {
                vec![(ExternalContact::FX, x * a), (ExternalContact::FY, x * b), (ExternalContact::FZ, x * c)]
            }
        };
        let number = self.joints.first().map_or(String::new(), ToString::to_string);
        let truth = truth.into_iter().map(|(key, value)| (format!("{key}{number}"), value)).collect();
        let same = match self.form {
            Form::Payload => vec![(effects::LinkInertiaError::NAME, vec![dof])],
            // In either direction of motion the added level has the same sign.
            Form::Asymmetric => vec![(effects::TorqueOffset::NAME, self.joints.clone())],
            _ => Vec::new(),
        };
        Added { cause: self.form.cause(), joints: self.joints.clone(), same, truth, rms: self.rms(session, x) }
    }
}

/// Parameters `M MS I` of a point mass at `c`, m, the tensor about the frame's origin.
fn point(m: f64, c: [f64; 3]) -> [f64; 10] {
    let [x, y, z] = c;
    [
        m,
        m * x,
        m * y,
        m * z,
        m * (y * y + z * z),
        m * (x * x + z * z),
        m * (x * x + y * y),
        -m * x * y,
        -m * x * z,
        -m * y * z,
    ]
}

/// A joint's torque recorded `by` s later, interpolated linearly, N m.
fn delayed(e: &Excerpt, j: usize, by: f64) -> Vec<f64> {
    let (t, tau) = (e.time(), e.torque(j));
    let mut out = tau.to_vec();
    for segment in super::motion::segments(&e.log.starts, t.len()) {
        let mut at = segment.start;
        for k in segment.clone() {
            let wanted = (t[k] - by).max(t[segment.start]);
            while at + 2 < segment.end && t[at + 1] < wanted {
                at += 1;
            }
            if at + 1 < segment.end {
                let share = ((wanted - t[at]) / (t[at + 1] - t[at]).max(1e-9)).clamp(0.0, 1.0);
                out[k] = tau[at] + share * (tau[at + 1] - tau[at]);
            }
        }
    }
    out
}
