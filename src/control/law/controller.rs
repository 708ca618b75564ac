//! The two loops of the paper's Fig. 8 and the reactions to what goes wrong.
//!
//! | what happens | what is done |
//! |---|---|
//! | a sample is missing, late, stale, not a number, or a leap | torques and displacement are held
//! ([`Status::Holding`]) |
//! | more than `patience` in a row | [`Fault::Position`]: gravity at the last known place; with samples again, damping to rest; until [`Controller::reset`] |
//! | the force is missing | the displacement stands still; longer than `patience`: [`Fault::Force`], the tool leaves the wall |
//! | contact is lost | the displacement may follow by `regain`; after `give_up` seconds [`Fault::Contact`], the tool leaves the wall |
//! | the force exceeds `most` | [`Fault::Excess`], the tool leaves the wall |
//! | the inverse kinematics finds nothing | desired positions stay |
//! | the model gives no numbers | torques stay |
//!
//! Torques are finite and within their limits whatever arrives.

use super::drag::Drag;
use super::error::ControllerError;
use super::force::{ForceLoop, ForceSettings};
use super::joint::JointLoop;
use super::model::Model;
use super::watch::{Judged, Sample, Watch};

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
    /// times as fast are rejected.
    pub velocity: [f64; N],
    /// Samples in a row that may fail.
    pub patience: u32,
    /// Force that means contact, N.
    pub contact: f64,
    /// Contact that is gone for this long is lost, s.
    pub lost_after: f64,
    /// How far the displacement may follow a contact that was lost, m.
    pub regain: f64,
    /// How long it is looked for, s.
    pub give_up: f64,
    /// Force above which the tool leaves the wall, N.
    pub most: f64,
    /// Share of the desired force that is fed forward as torques while the tool presses. At 0
    /// (equation 13) the springs of the joint loop carry the force and give way aside too; at 1
    /// they carry none of it.
    pub carry: f64,
    /// Share of the planned motion's torques ([`Model::moving`]) that is fed forward; 0 is equation
    /// (13).
    pub feed: f64,
    /// Share of the estimated force aside of the normal (a roller that is dragged) that is fed
    /// forward while the tool presses, so that the springs of the joint loop need not give way to
    /// it. 0 is equation (13). It must stay below 1, or friction is overcome for good and the tool
    /// creeps.
    pub aside: f64,
    /// Pole of the low-pass of that force, rad/s.
    pub aside_pole: f64,
    /// Share of the drag that is fed forward before the estimate shows it: friction along the
    /// tool's axes as learned so far ([`Drag`]), where and when the plan slides. With 0 all
    /// information about it comes late, from the estimate.
    pub drag: f64,
    /// Corner of the low-pass of the estimate (three equal poles), Hz: how late it is.
    pub corner: f64,
}

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
        ];
        rules.into_iter().find(|(holds, _)| !holds).map(|(_, error)| error)
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

/// Why it does not press any more.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fault {
    /// No positions for too long.
    Position,
    /// No force for too long.
    Force,
    /// No contact for too long.
    Contact,
    /// Too much force.
    Excess,
}

/// State of the controller.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// Follows the plan; no force was asked for.
    Free,
    /// On the way to the wall.
    Approaching,
    /// Presses.
    Pressing,
    /// Looks for a contact that is lost.
    Lost,
    /// Waits for a sample.
    Holding,
    /// Leaves the wall and follows the plan beside it.
    Leaving(Fault),
    /// Comes to rest, or hangs on gravity where positions are missing: apply the brakes.
    Stopped(Fault),
}

/// Output of the controller.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Command<const N: usize> {
    /// Torques of the actuators, N m.
    pub torque: [f64; N],
    /// Positions that the joints are sent to.
    pub desired: [f64; N],
    /// Along the normal, m.
    pub displacement: f64,
    /// State of the controller.
    pub status: Status,
}

/// The controller.
#[derive(Debug, Clone)]
pub struct Controller<M, const N: usize> {
    model: M,
    settings: Settings<N>,
    watch: Watch<N>,
    force: ForceLoop,
    target: Option<Target<N>>,
    desired: Option<[f64; N]>,
    torque: [f64; N],
    fault: Option<Fault>,
    blind: u32,
    touched: bool,
    away: f64,
    anchor: f64,
    carried: f64,
    aside: [f64; 3],
    drag: Drag,
}

impl<M: Model<N>, const N: usize> Controller<M, N> {
    /// With a model of the arm.
    ///
    /// # Errors
    /// The first setting that makes no sense.
    pub fn new(model: M, settings: Settings<N>) -> Result<Self, ControllerError> {
        if let Some(problem) = settings.problem() {
            return Err(problem);
        }
        let fastest = settings.velocity.map(|v| 3.0 * v);
        Ok(Self {
            model,
            watch: Watch::new(settings.period, settings.patience, fastest),
            force: ForceLoop::new(settings.force),
            settings,
            target: None,
            desired: None,
            torque: [0.0; N],
            fault: None,
            blind: 0,
            touched: false,
            away: 0.0,
            anchor: 0.0,
            carried: 0.0,
            aside: [0.0; 3],
            drag: Drag::default(),
        })
    }

    /// The model, to look at or to change.
    pub fn model(&mut self) -> &mut M {
        &mut self.model
    }

    /// Learned friction at the contact.
    pub fn drag(&self) -> &Drag {
        &self.drag
    }

    /// Clears faults and restarts from the present posture.
    pub fn reset(&mut self) {
        self.watch.reset();
        self.force.reset();
        (self.target, self.desired, self.fault) = (None, None, None);
        (self.blind, self.touched, self.away, self.carried) = (0, false, 0.0, 0.0);
        self.aside = [0.0; 3];
        self.drag.reset();
    }

    /// One period: what is wanted and what was measured in, torques out.
    pub fn step(&mut self, target: &Target<N>, sample: &Sample<N>) -> Command<N> {
        if is_sound(target) {
            self.target = Some(*target);
        }
        let before = self.watch.position();
        let dt = match self.watch.judge(sample) {
            Judged::Good(dt) => dt,
            Judged::Late => {
                self.fault = Some(Fault::Position);
                self.settings.period
            }
            Judged::Bad(missed) => return self.wait(missed, before),
        };
        let q = sample.q;
        // After a pause there is no velocity to speak of.
        let before = match (before, self.fault) {
            (Some(before), None) => before,
            (Some(before), Some(_)) if self.is_close(&q, &before) => before,
            _ => q,
        };
        let gravity = self.model.gravity(&q);
        let target = match (self.target, self.fault) {
            (Some(target), fault) if fault != Some(Fault::Position) => target,
            // Nothing to follow, or nothing that it could be trusted to follow.
            (_, fault) => {
                self.desired = Some(q);
                self.force.reset();
                (self.carried, self.aside) = (0.0, [0.0; 3]);
                let torque = self.settings.joints.rest([&q, &before], dt, &gravity);
                let status = fault.map_or(Status::Holding, Status::Stopped);
                return self.answer(torque, q, status);
            }
        };
        let status = self.press(&target, sample.force, dt);
        let last = self.desired.unwrap_or(q);
        let desired = self.send(&target, &last, dt);
        let mut torque = self.settings.joints.torques([&desired, &last], [&q, &before], dt, &gravity);
        self.carry(&target, status, dt);
        let drag = self.slide(&q, &target, &sample.push, status, dt);
        self.yield_aside(&target, &sample.push, &drag[1], status, dt);
        if self.settings.carry > 0.0 || self.settings.aside > 0.0 || self.settings.drag > 0.0 {
            let push = core::array::from_fn(|k| self.carried * target.normal[k] + self.aside[k] + drag[0][k]);
            let pressing = self.model.pressing(&q, &push);
            (0..N).for_each(|j| torque[j] += pressing[j]);
        }
        if self.settings.feed > 0.0 && self.fault.is_none() {
            let moving = self.model.moving(&q, &target.dq, &target.ddq);
            (0..N).for_each(|j| torque[j] += self.settings.feed * moving[j]);
        }
        self.desired = Some(desired);
        self.answer(torque, desired, status)
    }

    fn is_close(&self, q: &[f64; N], before: &[f64; N]) -> bool {
        let reach = 3.0 * self.settings.period;
        (0..N).all(|j| (q[j] - before[j]).abs() <= self.settings.velocity[j] * reach)
    }

    /// Without a sample.
    fn wait(&mut self, missed: u32, last: Option<[f64; N]>) -> Command<N> {
        if missed > self.settings.patience {
            self.fault = Some(Fault::Position);
        }
        let desired = self.desired.or(last).unwrap_or([0.0; N]);
        match (self.fault, last) {
            (Some(Fault::Position), Some(q)) => {
                let torque = self.model.gravity(&q);
                self.answer(torque, desired, Status::Stopped(Fault::Position))
            }
            (Some(Fault::Position), None) => self.answer([0.0; N], desired, Status::Stopped(Fault::Position)),
            _ => self.answer(self.torque, desired, Status::Holding),
        }
    }

    /// Moves the displacement.
    fn press(&mut self, target: &Target<N>, force: f64, dt: f64) -> Status {
        let Settings { patience, contact, lost_after, regain, give_up, most, .. } = self.settings;
        if let Some(fault) = self.fault {
            let away = self.settings.force.range[0];
            self.force.go(away, dt);
            return Status::Leaving(fault);
        }
        let Some(wanted) = target.force else {
            self.force.go(0.0, dt);
            (self.touched, self.away, self.blind) = (false, 0.0, 0);
            return Status::Free;
        };
        if !force.is_finite() {
            self.blind = self.blind.saturating_add(1);
            if self.blind > patience {
                self.fault = Some(Fault::Force);
            }
            return Status::Holding;
        }
        self.blind = 0;
        if force > most {
            self.fault = Some(Fault::Excess);
            return Status::Leaving(Fault::Excess);
        }
        let mut ceiling = f64::MAX;
        let mut status = Status::Pressing;
        if force >= contact {
            (self.touched, self.away) = (true, 0.0);
        } else if self.touched {
            if self.away == 0.0 {
                self.anchor = self.force.displacement();
            }
            self.away += dt;
            ceiling = self.anchor + regain;
            if self.away > lost_after {
                status = Status::Lost;
            }
        } else {
            status = Status::Approaching;
            // At the end of its range there is no wall to be found.
            let end = self.force.displacement() >= self.settings.force.range[1];
            self.away = if end { self.away + dt } else { 0.0 };
        }
        if self.away > give_up {
            self.fault = Some(Fault::Contact);
            return Status::Leaving(Fault::Contact);
        }
        self.force.press(wanted - force, dt, ceiling, target.ahead);
        status
    }

    /// Comes within half a second of contact, and goes within 20 ms of its end.
    fn carry(&mut self, target: &Target<N>, status: Status, dt: f64) {
        let wanted = target.force.unwrap_or(0.0);
        let presses = self.presses(status);
        let to = if presses { self.settings.carry * wanted } else { 0.0 };
        let full = wanted.max(self.carried);
        let (up, down) = (full * dt / 0.5, full * dt / 0.02);
        self.carried = to.clamp(self.carried - down, self.carried + up);
    }

    fn presses(&self, status: Status) -> bool {
        status == Status::Pressing && self.touched && self.away == 0.0
    }

    /// The push that drag will take (N, world axes): where the plan slides now, with the delay of
    /// the estimate. Learns from the estimate.
    fn slide(&mut self, q: &[f64; N], target: &Target<N>, push: &[f64; 3], status: Status, dt: f64) -> [[f64; 3]; 2] {
        let Settings { drag, corner, contact, period, .. } = self.settings;
        let (true, Some(most), true) = (drag > 0.0, target.force, self.presses(status)) else { return [[0.0; 3]; 2] };
        let Some(tool) = self.model.touch(q) else { return [[0.0; 3]; 2] };
        let turn = core::f64::consts::TAU * corner * period;
        self.drag.slide(&tool, &target.dq, &target.normal, turn / (1.0 + turn));
        let n = target.normal;
        let out: f64 = (0..3).map(|k| push[k] * n[k]).sum();
        if out > contact {
            self.drag.learn(&core::array::from_fn(|k| (push[k] - out * n[k]) / out), dt);
        }
        self.drag.predicted().map(|by| by.map(|x| drag * most * x))
    }

    /// Estimated force aside of the normal, low-passed, at most as large as the desired force along
    /// it. Friction goes with the normal force. Its ratio to the force along the normal is taken,
    /// times the desired force; otherwise each swing of the one would come back by the other. What
    /// of it was fed forward already (`known`, as late as the estimate) is taken off.
    fn yield_aside(&mut self, target: &Target<N>, push: &[f64; 3], known: &[f64; 3], status: Status, dt: f64) {
        let (n, most) = (target.normal, target.force.unwrap_or(0.0));
        let presses = self.presses(status);
        let keep = 1.0 / (1.0 + self.settings.aside_pole * dt);
        let out: f64 = (0..3).map(|k| push[k] * n[k]).sum();
        let share = most / out.max(self.settings.contact).max(1e-9);
        for k in 0..3 {
            let left = share * (push[k] - out * n[k]) - known[k];
            let to = if presses { self.settings.aside * left } else { 0.0 };
            // Without an estimate it is held.
            if to.is_finite() {
                self.aside[k] = (to + keep * (self.aside[k] - to)).clamp(-most, most);
            }
        }
    }

    /// Desired positions: the plan's, displaced, no faster than the joints may be.
    fn send(&mut self, target: &Target<N>, last: &[f64; N], dt: f64) -> [f64; N] {
        let by = target.normal.map(|n| n * self.force.displacement());
        let wanted = self.model.displaced(&target.q, &by, last);
        let Some(wanted) = wanted.filter(|q| q.iter().all(|x| x.is_finite())) else { return *last };
        core::array::from_fn(|j| {
            let reach = self.settings.velocity[j] * dt;
            wanted[j].clamp(last[j] - reach, last[j] + reach)
        })
    }

    /// Within the limits, and finite.
    fn answer(&mut self, torque: [f64; N], desired: [f64; N], status: Status) -> Command<N> {
        if torque.iter().all(|t| t.is_finite()) {
            self.torque = core::array::from_fn(|j| {
                let limit = self.settings.torque[j];
                torque[j].clamp(-limit, limit)
            });
        }
        Command { torque: self.torque, desired, displacement: self.force.displacement(), status }
    }
}

fn is_sound<const N: usize>(target: &Target<N>) -> bool {
    let Target { q, dq, ddq, normal, force, ahead } = target;
    let length: f64 = normal.iter().map(|n| n * n).sum();
    // A NaN is in no range.
    q.iter().chain(dq).chain(ddq).all(|x| x.is_finite())
        && (0.98..1.02).contains(&length)
        && force.is_none_or(|f| (0.0..1e6).contains(&f))
        && ahead.abs() < 1.0
}
