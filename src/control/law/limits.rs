//! Limits of the plan and of the arm, like those of libfranka for motions and torques.

use super::error::ControllerError;
use super::machine::Fault;
use super::model::Tool;
use super::settings::{Settings, Target};
use super::watch::Tally;

/// Limits beyond torque and speed. Each may be infinite.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits<const N: usize> {
    /// Lower and upper position limit of each joint, rad or m. Targets outside are not followed;
    /// measured positions may be outside by a fiftieth of the range.
    pub position: [[f64; 2]; N],
    /// Largest planned acceleration, rad/s^2 or m/s^2.
    pub acceleration: [f64; N],
    /// Largest planned jerk, rad/s^3 or m/s^3.
    pub jerk: [f64; N],
    /// Largest planned speed (m/s), acceleration (m/s^2) and jerk (m/s^3) of the point of contact
    /// ([`Model::touch`](super::Model::touch)). Without contact the force loop's displacement also
    /// keeps the last two.
    pub tool: [f64; 3],
    /// Largest rate of the desired force, N/s; a plan that changes it faster is followed at this
    /// rate.
    pub force_rate: f64,
    /// Largest rate of the torques, N m/s.
    pub torque_rate: [f64; N],
    /// Longest time that torques may stay at a limit of size or rate, s.
    pub saturated: f64,
    /// Largest change of a joint's command while its measured position stays bit-identical, rad or
    /// m: more than its static friction deflects the spring of the joint loop.
    pub frozen: [f64; N],
    /// Largest change of the displacement (m) and of any joint's command (rad or m) while the
    /// contact force stays bit-identical.
    pub stuck: [f64; 2],
}

impl<const N: usize> Limits<N> {
    /// No limits.
    pub const NONE: Self = Self {
        position: [[f64::NEG_INFINITY, f64::INFINITY]; N],
        acceleration: [f64::INFINITY; N],
        jerk: [f64::INFINITY; N],
        tool: [f64::INFINITY; 3],
        force_rate: f64::INFINITY,
        torque_rate: [f64::INFINITY; N],
        saturated: f64::INFINITY,
        frozen: [f64::INFINITY; N],
        stuck: [f64::INFINITY; 2],
    };

    pub(super) fn problem(&self) -> Option<ControllerError> {
        let positive = |x: &f64| *x > 0.0;
        let ranges = self.position.iter().all(|[low, high]| low < high);
        let motion = self.acceleration.iter().chain(&self.jerk).chain(&self.tool).all(positive);
        let torque = self.torque_rate.iter().all(positive) && positive(&self.saturated) && positive(&self.force_rate);
        let still = self.frozen.iter().chain(&self.stuck).all(positive);
        (!(ranges && motion && torque && still)).then_some(ControllerError::Limits)
    }

    /// Whether a posture is within the range of each joint.
    pub(super) fn contain(&self, q: &[f64; N]) -> bool {
        (0..N).all(|j| (self.position[j][0]..=self.position[j][1]).contains(&q[j]))
    }

    /// Whether a measured posture is outside the range by more than the margin.
    fn is_beyond(&self, q: &[f64; N]) -> bool {
        const MARGIN: f64 = 0.02;
        (0..N).any(|j| {
            let [low, high] = self.position[j];
            let margin = MARGIN * (high - low);
            q[j] < low - margin || q[j] > high + margin
        })
    }
}

/// Tolerance for planned values at their limit: rounding.
const ROUNDING: f64 = 1.0 + 1e-6;

/// Last valid target and the motion of its tool.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Plan<const N: usize> {
    last: Option<Target<N>>,
    velocity: Option<[f64; 3]>,
    acceleration: Option<[f64; 3]>,
    /// Number of steps since it was taken.
    since: u32,
}

impl<const N: usize> Plan<N> {
    pub(super) const NONE: Self = Self { last: None, velocity: None, acceleration: None, since: 0 };

    pub(super) fn last(&self) -> Option<&Target<N>> {
        self.last.as_ref()
    }

    /// Counts a step and takes its target if it is valid and within the limits, at a displacement,
    /// m. `touch` gives the point of contact at the target; it is evaluated only if its motion is
    /// limited.
    pub(super) fn take(
        &mut self,
        target: &Target<N>,
        settings: &Settings<N>,
        displacement: f64,
        touch: impl FnOnce() -> Option<Tool<N>>,
    ) -> bool {
        let Settings { limits, velocity, period, most, .. } = settings;
        self.since = self.since.saturating_add(1);
        let dt = f64::from(self.since) * period;
        let within = |x: &[f64; N], most: &[f64; N]| (0..N).all(|j| x[j].abs() <= ROUNDING * most[j]);
        let change = |now: &[f64; N], then: &[f64; N]| core::array::from_fn(|j| (now[j] - then[j]) / dt);
        // Positions and speeds are checked by themselves, as they may not match the given speed and
        // acceleration. A normal that turns moves the displaced tool.
        let follows = |from: &Target<N>| {
            let by = |k: usize| target.normal[k] - from.normal[k];
            let turn: f64 = (0..3).map(|k| by(k) * by(k)).sum();
            let reach = ROUNDING * limits.tool[0] * dt;
            within(&change(&target.q, &from.q), velocity)
                && within(&change(&target.dq, &from.dq), &limits.acceleration)
                && within(&change(&target.ddq, &from.ddq), &limits.jerk)
                && displacement * displacement * turn <= reach * reach
                && (target.ahead - from.ahead).abs() <= reach
        };
        let sound = is_sound(target)
            && target.force.is_none_or(|force| force <= *most)
            && limits.contain(&target.q)
            && within(&target.dq, velocity)
            && within(&target.ddq, &limits.acceleration)
            && self.last.as_ref().is_none_or(follows);
        if !sound {
            return false;
        }
        let tool = if limits.tool.iter().any(|limit| limit.is_finite()) { touch() } else { None };
        let Some(motion) = self.tool(tool.as_ref(), target, dt, &limits.tool) else { return false };
        *self = Self { last: Some(*target), since: 0, ..motion };
        true
    }

    /// Motion of the tool from differences between targets; `None` beyond its limits.
    fn tool(&self, tool: Option<&Tool<N>>, target: &Target<N>, dt: f64, limits: &[f64; 3]) -> Option<Self> {
        let Some(tool) = tool else { return Some(Self { velocity: None, acceleration: None, ..*self }) };
        let size = |x: &[f64; 3]| x.iter().map(|x| x * x).sum::<f64>();
        let within = |x: &[f64; 3], most: f64| size(x) <= ROUNDING * most * most;
        let change = |now: &[f64; 3], then: Option<[f64; 3]>| {
            then.map(|then| -> [f64; 3] { core::array::from_fn(|i| (now[i] - then[i]) / dt) })
        };
        let velocity: [f64; 3] = core::array::from_fn(|i| (0..N).map(|j| tool.jacobian[i][j] * target.dq[j]).sum());
        let acceleration = change(&velocity, self.velocity);
        let jerk = acceleration.and_then(|now| change(&now, self.acceleration));
        let sound = within(&velocity, limits[0])
            && acceleration.is_none_or(|a| within(&a, limits[1]))
            && jerk.is_none_or(|j| within(&j, limits[2]));
        sound.then_some(Self { velocity: Some(velocity), acceleration, ..*self })
    }
}

fn is_sound<const N: usize>(target: &Target<N>) -> bool {
    let Target { q, dq, ddq, normal, force, ahead } = target;
    let length: f64 = normal.iter().map(|n| n * n).sum();
    // NaN is in no range.
    q.iter().chain(dq).chain(ddq).all(|x| x.is_finite())
        && (0.98..1.02).contains(&length)
        && force.is_none_or(|f| f >= 0.0)
        && ahead.abs() < 1.0
}

/// Detects values that stay bit-identical while they should change.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Freeze<const N: usize> {
    q: [f64; N],
    /// Command of each joint when its position last changed.
    sent: [f64; N],
    force: f64,
    /// Displacement and commanded posture when the force last changed.
    displaced: f64,
    posture: [f64; N],
}

impl<const N: usize> Freeze<N> {
    pub(super) const NONE: Self =
        Self { q: [f64::NAN; N], sent: [0.0; N], force: f64::NAN, displaced: 0.0, posture: [0.0; N] };

    /// Whether a measured position is frozen while the joints are commanded to `sent`.
    pub(super) fn position(&mut self, q: &[f64; N], sent: &[f64; N], limits: &Limits<N>) -> bool {
        for j in 0..N {
            if q[j] != self.q[j] {
                (self.q[j], self.sent[j]) = (q[j], sent[j]);
            }
        }
        (0..N).any(|j| (sent[j] - self.sent[j]).abs() > limits.frozen[j])
    }

    /// Whether the contact force is stuck.
    pub(super) fn force(&mut self, force: f64, displaced: f64, sent: &[f64; N], limits: &Limits<N>) -> bool {
        if force != self.force {
            (self.force, self.displaced, self.posture) = (force, displaced, *sent);
        }
        let [deeper, along] = limits.stuck;
        (displaced - self.displaced).abs() > deeper || (0..N).any(|j| (sent[j] - self.posture[j]).abs() > along)
    }
}

/// Measures how long limits are exceeded that noise may exceed for a moment, both continuously and
/// with interruptions.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Exceeded {
    fast: (u32, Tally),
    pushed: (u32, Tally),
    saturated: f64,
    unreached: f64,
}

/// Counts an event; true if it occurs too often: in a row, or a third of the time for long.
fn too_often((row, all): &mut (u32, Tally), is: bool, patience: u32) -> bool {
    *row = if is { row.saturating_add(1) } else { 0 };
    all.count(is) || *row > patience
}

/// Factor by which measured speeds may exceed the speed limit: commands move at the limit, and the
/// arm oscillates about them.
const OVERSPEED: f64 = 1.5;

impl Exceeded {
    /// Measures how long the torques have been at a limit.
    pub(super) fn saturate(&mut self, at_limit: bool, period: f64) {
        self.saturated = if at_limit { self.saturated + period } else { 0.0 };
    }

    /// Measures how long targets have been without a posture.
    pub(super) fn reach(&mut self, found: bool, period: f64) {
        self.unreached = if found { 0.0 } else { self.unreached + period };
    }

    /// Whether there was no posture for longer than `give_up`, s.
    pub(super) fn unreached(&self, give_up: f64) -> bool {
        self.unreached > give_up
    }

    /// Checks the limits of the arm's state; returns the most severe fault.
    pub(super) fn joints<const N: usize>(
        &mut self,
        [q, before]: [&[f64; N]; 2],
        dt: f64,
        limits: &Limits<N>,
        velocity: &[f64; N],
        patience: u32,
    ) -> Option<Fault> {
        let fast = (0..N).any(|j| (q[j] - before[j]).abs() > OVERSPEED * velocity[j] * dt);
        let too_fast = too_often(&mut self.fast, fast, patience);
        if limits.is_beyond(q) {
            Some(Fault::Joint)
        } else if too_fast {
            Some(Fault::Speed)
        } else {
            (self.saturated > limits.saturated).then_some(Fault::Torque)
        }
    }

    /// Whether the estimated push, in any direction, has been above `most`, N, for too long.
    pub(super) fn push(&mut self, push: &[f64; 3], most: f64, patience: u32) -> bool {
        let above = push.iter().map(|x| x * x).sum::<f64>() > most * most;
        too_often(&mut self.pushed, above, patience)
    }
}

/// Postures that the model found for the displaced targets.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Postures<const N: usize> {
    last: Option<[f64; N]>,
    /// Number of steps since it was found.
    since: u32,
}

/// Factor by which the change of posture may exceed the speed limits: near a singularity the joints
/// lag behind the plan.
const LEAP: f64 = 3.0;

impl<const N: usize> Postures<N> {
    pub(super) const NONE: Self = Self { last: None, since: 0 };

    /// Whether a posture continues the last one and is not on another branch of the inverse
    /// kinematics. The permitted change grows with the time since then, up to that of the patience.
    pub(super) fn take(&mut self, q: &[f64; N], velocity: &[f64; N], period: f64, patience: u32) -> bool {
        self.since = self.since.saturating_add(1).min(patience.saturating_add(1));
        let reach = LEAP * f64::from(self.since) * period;
        let follows = |last: &[f64; N]| (0..N).all(|j| (q[j] - last[j]).abs() <= velocity[j] * reach);
        let takes = self.last.as_ref().is_none_or(follows);
        if takes {
            *self = Self { last: Some(*q), since: 0 };
        }
        takes
    }
}
