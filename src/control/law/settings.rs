//! Settings of the controller (gains and limits) and its targets.

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
    /// Torque limits, N m, in both directions.
    pub torque: [f64; N],
    /// Speed limits, rad/s: commands move no faster. Measured positions that move three times as
    /// fast are rejected; one and a half times as fast for longer than the patience is a fault.
    pub velocity: [f64; N],
    /// Number of consecutive samples that may fail; also of forces, targets and model evaluations.
    pub patience: u32,
    /// Force above which there is contact, N.
    pub contact: f64,
    /// Time without contact after which it counts as lost, s.
    pub lost_after: f64,
    /// Farthest displacement beyond the point where contact was lost, m.
    pub regain: f64,
    /// Duration of the search for a lost contact, s.
    pub give_up: f64,
    /// Force above which the tool leaves the wall, N: along the normal at once, and in any
    /// direction, as estimated ([`Sample::push`](super::Sample::push)), after the patience. Also
    /// the largest desired force.
    pub most: f64,
    /// Share of the desired force that is fed forward as torques while the tool presses. At 0
    /// (equation 13) the springs of the joint loop carry the force and also yield tangentially; at
    /// 1 they carry none of it.
    pub carry: f64,
    /// Share of the planned motion's torques ([`Model::moving`](super::Model::moving)) that is fed
    /// forward; 0 is equation (13).
    pub feed: f64,
    /// Share of the estimated tangential force (a dragged roller) that is fed forward while the
    /// tool presses, so that the springs of the joint loop need not yield to it. 0 is equation
    /// (13). It must stay below 1; otherwise friction is fully compensated and the tool creeps.
    pub aside: f64,
    /// Pole of the low-pass of the tangential force, rad/s.
    pub aside_pole: f64,
    /// Share of the drag that is fed forward before the estimate shows it: friction along the
    /// tool's axes as learned so far ([`Drag`](super::Drag)), where and when the plan slides. With
    /// 0 drag is known only with the delay of the estimate.
    pub drag: f64,
    /// Corner frequency of the estimate's low-pass (three equal poles), Hz: determines its delay.
    pub corner: f64,
    /// Limits beyond torque and speed.
    pub limits: Limits<N>,
    /// Time of a stop along the plan's path, s.
    pub stop: f64,
}

/// Time allowed for an arm to come to rest after its stop along the path, or by damping alone, s.
/// The brakes are requested after it in any case.
const REST: f64 = 1.0;

impl<const N: usize> Settings<N> {
    /// Returns the first invalid setting, if there is one.
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

    /// Longest durations of the state machine's states.
    pub(super) fn bounds(&self) -> Bounds {
        let ForceSettings { range, rate, .. } = self.force;
        // A conversion saturates, and NaN becomes 0.
        let steps = |seconds: f64| (seconds / self.period) as u32;
        let way = (range[1] - range[0]) / rate + self.force_loop().delay(self.period);
        let leave = steps(way + self.stop).saturating_add(self.patience).saturating_add(2);
        Bounds { patience: self.patience, leave, stop: steps(self.stop + REST).saturating_add(2) }
    }

    /// Builds the force loop; without contact its displacement keeps the tool's limits of
    /// acceleration and jerk.
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
    /// Planned posture, rad or m; its tool touches the wall.
    pub q: [f64; N],
    /// Planned velocity, rad/s or m/s; used where [`Settings::feed`] is not 0.
    pub dq: [f64; N],
    /// Planned acceleration, rad/s^2 or m/s^2; used where [`Settings::feed`] is not 0.
    pub ddq: [f64; N],
    /// Unit vector in world axes along which the tool presses, into the wall.
    pub normal: [f64; 3],
    /// Desired normal force, N, not negative; `None` away from the wall.
    pub force: Option<f64>,
    /// Feed-forward displacement along the normal, m, added to that of the force loop: learned on
    /// the previous coat, or 0. The limits of the displacement hold for the sum; it is not used
    /// away from the wall.
    pub ahead: f64,
}

impl<const N: usize> Target<N> {
    /// Creates a target at a posture, with zero velocity and acceleration.
    pub fn at(q: [f64; N], normal: [f64; 3], force: Option<f64>) -> Self {
        Self { q, dq: [0.0; N], ddq: [0.0; N], normal, force, ahead: 0.0 }
    }
}
