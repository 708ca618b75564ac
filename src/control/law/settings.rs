//! Gains, limits and reference values.

use super::contact::Search;
use super::error::ControllerError;
use super::force::{ForceLoop, ForceSettings};
use super::joint::JointLoop;
use super::limits::Limits;
use super::machine::Bounds;

/// All gains and limits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings<const N: usize> {
    /// Time between samples, s.
    pub period: f64,
    /// Inner loop.
    pub joints: JointLoop<N>,
    /// Outer loop.
    pub force: ForceSettings,
    /// Torque limits, N m, both ways.
    pub torque: [f64; N],
    /// Speed limits, rad/s: desired positions move no faster, and measured ones that move three
    /// times as fast are rejected; one and a half times as fast for longer than the patience is a
    /// fault.
    pub velocity: [f64; N],
    /// Samples in a row that may fail; forces, targets and answers of the model too.
    pub patience: u32,
    /// Force that means contact, N.
    pub contact: f64,
    /// Contact that is gone for this long is lost, s.
    pub lost_after: f64,
    /// How far the displacement may follow a contact that was lost, m.
    pub regain: f64,
    /// How long it is looked for, s.
    pub give_up: f64,
    /// Force above which the tool leaves the wall, N: along the normal at once, and in any
    /// direction as estimated ([`Sample::push`](super::Sample::push)) after the patience. No larger
    /// one is pressed with.
    pub most: f64,
    /// Share of the desired force that is fed forward as torques while the tool presses. At 0
    /// (equation 13) the springs of the joint loop carry the force and give way aside too; at 1
    /// they carry none of it.
    pub carry: f64,
    /// Share of the planned motion's torques ([`Model::moving`](super::Model::moving)) that is fed
    /// forward; 0 is equation (13).
    pub feed: f64,
    /// Share of the estimated force aside of the normal (a roller that is dragged) that is fed
    /// forward while the tool presses, so that the springs of the joint loop need not give way to
    /// it. 0 is equation (13). It must stay below 1, or friction is overcome for good and the tool
    /// creeps.
    pub aside: f64,
    /// Pole of the low-pass of that force, rad/s.
    pub aside_pole: f64,
    /// Share of the drag that is fed forward before the estimate shows it: friction along the
    /// tool's axes as learned so far ([`Drag`](super::Drag)), where and when the plan slides. With
    /// 0 all information about it comes late, from the estimate.
    pub drag: f64,
    /// Corner of the low-pass of the estimate (three equal poles), Hz: how late it is.
    pub corner: f64,
    /// Limits beyond torque and speed.
    pub limits: Limits<N>,
    /// Time of a stop along the plan's path, s.
    pub stop: f64,
}

/// Time in which an arm comes to rest after its stop along the path, or by damping alone; the
/// brakes are requested then anyway, s.
const REST: f64 = 1.0;

impl<const N: usize> Settings<N> {
    /// Their first mistake, if there is one.
    pub fn problem(&self) -> Option<ControllerError> {
        let positive = |x: f64| x > 0.0 && x.is_finite();
        let not_negative = |x: f64| x >= 0.0 && x.is_finite();
        let all = |x: &[f64]| x.iter().all(|x| not_negative(*x));
        let ForceSettings { kp, ki, range, rate } = self.force;
        let shares = [self.carry, self.feed, self.aside, self.drag];
        let rules = [
            (positive(self.period), ControllerError::Period),
            (all(&self.joints.kp) && all(&self.joints.kd), ControllerError::JointGains),
            (all(&[kp, ki]), ControllerError::ForceGains),
            (all(&[-range[0], range[1]]), ControllerError::Range),
            (positive(rate), ControllerError::Rate),
            (self.torque.iter().chain(&self.velocity).all(|x| positive(*x)), ControllerError::Limits),
            (all(&[self.contact, self.lost_after, self.regain, self.give_up, self.most]), ControllerError::Contact),
            (shares.iter().all(|share| (0.0..=1.0).contains(share)), ControllerError::Share),
            (not_negative(self.aside_pole), ControllerError::AsidePole),
            (positive(self.corner), ControllerError::Corner),
            (self.limits.problem().is_none(), ControllerError::Limits),
            (positive(self.stop), ControllerError::Stop),
        ];
        rules.into_iter().find(|(holds, _)| !holds).map(|(_, error)| error)
    }

    /// Longest stays of the state machine.
    pub(super) fn bounds(&self) -> Bounds {
        let ForceSettings { range, rate, .. } = self.force;
        // A conversion saturates, and a NaN is 0.
        let steps = |seconds: f64| (seconds / self.period) as u32;
        let way = (range[1] - range[0]) / rate + self.force_loop().delay(self.period);
        let leave = steps(way + self.stop).saturating_add(self.patience).saturating_add(2);
        Bounds { patience: self.patience, leave, stop: steps(self.stop + REST).saturating_add(2) }
    }

    /// Without contact the displacement keeps to the tool's limits of acceleration and jerk.
    pub(super) fn force_loop(&self) -> ForceLoop {
        let [_, acceleration, jerk] = self.limits.tool;
        ForceLoop::new(self.force).within([acceleration, jerk], self.period)
    }

    /// Limits of the search for a contact.
    pub(super) fn search(&self) -> Search {
        let Self { contact, lost_after, give_up, regain, .. } = *self;
        Search { contact, lost_after, give_up, regain, end: self.force.range[1] }
    }
}

/// Reference values at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Target<const N: usize> {
    /// The planned posture, whose tool touches the wall.
    pub q: [f64; N],
    /// Its planned velocity, rad/s or m/s; read where [`Settings::feed`] is not 0.
    pub dq: [f64; N],
    /// Its planned acceleration, rad/s^2 or m/s^2; read there too.
    pub ddq: [f64; N],
    /// Unit vector in world axes along which the tool presses, into the wall.
    pub normal: [f64; 3],
    /// Force to press with, N, not negative; `None` away from the wall.
    pub force: Option<f64>,
    /// Displacement along the normal that is known to be needed here, m, added to what the force
    /// loop asks for: learned on the coat before, or 0. The limits of the displacement hold for the
    /// sum, and away from the wall it is not used.
    pub ahead: f64,
}

impl<const N: usize> Target<N> {
    /// At a posture, without velocity and acceleration.
    pub fn at(q: [f64; N], normal: [f64; 3], force: Option<f64>) -> Self {
        Self { q, dq: [0.0; N], ddq: [0.0; N], normal, force, ahead: 0.0 }
    }
}
