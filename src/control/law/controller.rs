//! The two loops of the paper's Fig. 8, under the state machine of [`Machine`].
//!
//! Reactions to faults:
//!
//! - A sample is missing, late, stale, not a number or discontinuous, or the model returns no
//!   numbers: torques and displacement are held ([`Status::Holding`]), for at most `patience`
//!   steps.
//! - Positions are missing for longer, or are frozen: gravity torques and brakes; damping once
//!   samples return.
//! - Time stamps and steps disagree, the model fails, a joint is too far or too fast, or torques
//!   are at their limits: damping and gravity until rest, then brakes.
//! - Targets beyond the limits, no posture, no force, no contact, too high or stuck force: the tool
//!   leaves the wall while the path is followed to a stop; then brakes.
//! - Contact is lost: the displacement may follow by `regain`.
//! - The inverse kinematics has no solution: desired positions are held, for at most `give_up`
//!   seconds.
//!
//! Torques are finite, within their limits and rate limits, for any input. A fault lasts until
//! [`Controller::reset`].

use super::contact::Contact;
use super::drag::Drag;
use super::error::ControllerError;
use super::force::ForceLoop;
use super::limits::{Exceeded, Freeze, Plan, Postures};
use super::machine::{Arrival, Bounds, Fault, Machine, Reaction, Seen, Status, Touch, Wanted};
use super::model::Model;
use super::settings::{Settings, Target};
use super::stop::{PathStop, Still};
use super::watch::{Sample, Tally, Watch};

/// Output of the controller.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Command<const N: usize> {
    /// Torques of the actuators, N m.
    pub torque: [f64; N],
    /// Desired joint positions, rad.
    pub desired: [f64; N],
    /// Displacement along the normal, m.
    pub displacement: f64,
    /// State of the controller; [`Status::brakes`] requests the brakes.
    pub status: Status,
}

/// The controller. Each call of [`Controller::step`] is a period of its clock.
#[derive(Debug, Clone)]
pub struct Controller<M, const N: usize> {
    model: M,
    settings: Settings<N>,
    bounds: Bounds,
    watch: Watch<N>,
    force: ForceLoop,
    state: State<N>,
    drag: Drag,
}

/// Recent failures of model, targets and force.
#[derive(Debug, Clone, Copy, Default)]
struct Failing {
    model: Tally,
    plan: Tally,
    force: Tally,
}

/// State that a reset clears.
#[derive(Debug, Clone, Copy)]
struct State<const N: usize> {
    machine: Machine,
    plan: Plan<N>,
    stop: Option<PathStop<N>>,
    contact: Contact,
    freeze: Freeze<N>,
    exceeded: Exceeded,
    failing: Failing,
    postures: Postures<N>,
    still: Still<N>,
    desired: Option<[f64; N]>,
    /// Torques of the previous step, N m.
    torque: Option<[f64; N]>,
    /// Last valid gravity torques, N m.
    gravity: [f64; N],
    /// Whether the last evaluation of the model gave valid numbers.
    answers: bool,
    /// Desired force after its rate limit, on its way to the plan's, N.
    asked: f64,
    carried: f64,
    aside: [f64; 3],
}

impl<const N: usize> State<N> {
    fn new() -> Self {
        Self {
            machine: Machine::default(),
            plan: Plan::NONE,
            stop: None,
            contact: Contact::default(),
            freeze: Freeze::NONE,
            exceeded: Exceeded::default(),
            failing: Failing::default(),
            postures: Postures::NONE,
            still: Still::NONE,
            desired: None,
            torque: None,
            gravity: [0.0; N],
            answers: true,
            asked: 0.0,
            carried: 0.0,
            aside: [0.0; 3],
        }
    }
}

/// A usable sample.
struct Measured<'a, const N: usize> {
    sample: &'a Sample<N>,
    /// Previous position; equal to the present one where the motion in between is unknown.
    before: [f64; N],
    dt: f64,
}

impl<M: Model<N>, const N: usize> Controller<M, N> {
    /// Creates a controller with a model of the arm.
    ///
    /// # Errors
    /// Returns the first invalid setting.
    pub fn new(model: M, settings: Settings<N>) -> Result<Self, ControllerError> {
        if let Some(problem) = settings.problem() {
            return Err(problem);
        }
        let fastest = settings.velocity.map(|v| 3.0 * v);
        Ok(Self {
            model,
            bounds: settings.bounds(),
            watch: Watch::new(settings.period, settings.patience, fastest),
            force: settings.force_loop(),
            state: State::new(),
            drag: Drag::default(),
            settings,
        })
    }

    /// The model, for inspection or changes.
    pub fn model(&mut self) -> &mut M {
        &mut self.model
    }

    /// Learned friction at the contact.
    pub fn drag(&self) -> &Drag {
        &self.drag
    }

    /// Longest durations of the states that end by themselves.
    pub fn bounds(&self) -> &Bounds {
        &self.bounds
    }

    /// Clears faults and restarts from the present posture.
    pub fn reset(&mut self) {
        self.watch.reset();
        self.force.reset();
        self.drag.reset();
        self.state = State::new();
    }

    /// Runs one period: takes target and measurements, returns torques.
    pub fn step(&mut self, target: &Target<N>, sample: &Sample<N>) -> Command<N> {
        let Self { model, settings, state, .. } = self;
        let plan = state.plan.take(target, settings, self.force.displacement(), || model.touch(&target.q));
        let relies = !matches!(self.reaction(), Some(Reaction::Damped | Reaction::Blind));
        let before = self.watch.position();
        let (arrival, dt) = self.watch.judge(sample, relies);
        let arrived = matches!(arrival, Arrival::Good | Arrival::Jumped);
        let measured = arrived.then(|| Measured { sample, before: self.before(before, &sample.q, dt), dt });
        let seen = self.look(arrival, plan, measured.as_ref());
        self.advance(&seen);
        match measured {
            Some(measured) => self.control(&measured, seen.force),
            None => self.wait(before),
        }
    }

    /// Reaction to the present fault.
    fn reaction(&self) -> Option<Reaction> {
        self.state.machine.status().fault().map(Fault::reaction)
    }

    /// Previous position, limited so that no joint moved faster than three times its velocity
    /// limit. A discontinuity then gives bounded damping, and an arm that really is that fast is
    /// still damped.
    fn before(&self, before: Option<[f64; N]>, q: &[f64; N], dt: f64) -> [f64; N] {
        let Some(before) = before else { return *q };
        let reach = 3.0 * dt.max(self.settings.period);
        core::array::from_fn(|j| {
            let (most, way) = (self.settings.velocity[j] * reach, q[j] - before[j]);
            if way.abs() <= most { before[j] } else { q[j] - way.clamp(-most, most) }
        })
    }

    /// Evaluates the guards of this step.
    fn look(&mut self, arrival: Arrival, plan: bool, measured: Option<&Measured<'_, N>>) -> Seen {
        let displacement = self.force.displacement();
        let Settings { limits, velocity, patience, period, most, give_up, .. } = self.settings;
        let search = self.settings.search();
        let state = &mut self.state;
        let force = state.plan.last().map(|target| target.force);
        let wanted = match force {
            None => Wanted::Nothing,
            Some(None) => Wanted::Free,
            Some(Some(_)) => Wanted::Press,
        };
        let planless = state.failing.plan.count(!plan && wanted != Wanted::Nothing);
        let over = state.stop.as_ref().is_none_or(PathStop::is_over);
        let mut seen = Seen {
            arrival,
            model: state.answers,
            plan,
            wanted,
            force: true,
            touch: Touch::NotYet,
            limit: None,
            clear: over && displacement <= self.settings.force.range[0],
            rest: false,
        };
        let Some(Measured { sample, before, dt }) = measured else { return seen };
        seen.rest = state.still.step(&sample.q, &velocity, period) && over;
        seen.force = sample.force.is_finite();
        let sent = state.desired.unwrap_or(sample.q);
        let frozen = state.freeze.position(&sample.q, &sent, &limits);
        let joint = state.exceeded.joints([&sample.q, before], *dt, &limits, &velocity, patience);
        let pushed = state.exceeded.push(&sample.push, most, patience);
        let excess = pushed || (wanted == Wanted::Press && seen.force && sample.force > most);
        let mut stuck = false;
        match force.flatten() {
            Some(wanted) if seen.force && !excess && state.machine.status().fault().is_none() => {
                seen.touch = state.contact.step(sample.force, wanted, displacement, *dt, &search);
                stuck = state.freeze.force(sample.force, displacement, &sent, &limits) && state.contact.touches();
            }
            Some(_) => {}
            None => state.contact = Contact::default(),
        }
        let lost = state.exceeded.unreached(give_up);
        let dumb = state.failing.model.count(!state.answers);
        let forceless = wanted == Wanted::Press && state.failing.force.count(!seen.force);
        let first = |limits: &[(bool, Fault)]| limits.iter().find(|(is, _)| *is).map(|(_, fault)| *fault);
        let grave = first(&[(frozen, Fault::Frozen), (dumb, Fault::Model)]);
        let milder = || {
            first(&[
                (planless, Fault::Plan),
                (lost, Fault::Reach),
                (excess, Fault::Excess),
                (stuck, Fault::Stuck),
                (forceless, Fault::Force),
            ])
        };
        seen.limit = grave.or(joint).or_else(milder);
        seen
    }

    /// Advances the state machine and initialises what starts with a fault.
    fn advance(&mut self, seen: &Seen) {
        let state = &mut self.state;
        let healthy = state.machine.status().fault().is_none();
        state.machine = state.machine.next(seen, &self.bounds);
        if healthy && state.machine.status().fault().is_some() {
            state.stop = state.plan.last().map(|from| PathStop::new(*from, self.settings.stop));
            state.still = Still::NONE;
        }
    }

    /// Command for a period without a sample.
    fn wait(&mut self, last: Option<[f64; N]>) -> Command<N> {
        let desired = self.state.desired.or(last).unwrap_or([0.0; N]);
        match (self.reaction(), last) {
            (None | Some(Reaction::Path), _) => self.answer(self.state.torque.unwrap_or([0.0; N]), desired, false),
            (Some(_), Some(q)) => {
                self.weigh(&q);
                self.answer(self.state.gravity, desired, true)
            }
            (Some(_), None) => self.answer([0.0; N], desired, true),
        }
    }

    /// Updates gravity from the model; keeps the last value if the model gives no numbers or
    /// torques above the limits.
    fn weigh(&mut self, q: &[f64; N]) {
        let gravity = self.model.gravity(q);
        // A comparison with NaN is false.
        self.state.answers = (0..N).all(|j| gravity[j].abs() <= self.settings.torque[j]);
        if self.state.answers {
            self.state.gravity = gravity;
        }
    }

    /// Command for a period with a sample.
    fn control(&mut self, measured: &Measured<'_, N>, has_force: bool) -> Command<N> {
        let Measured { sample, before, dt } = measured;
        let (q, dt) = (&sample.q, *dt);
        self.weigh(q);
        let status = self.state.machine.status();
        let target = match self.reaction() {
            Some(Reaction::Damped | Reaction::Blind) => None,
            Some(Reaction::Path) => self.state.stop.as_mut().map(|stop| stop.step(dt)),
            None => self.state.plan.last().copied(),
        };
        // No target, or one that cannot be followed reliably.
        let Some(mut target) = target else {
            self.state.desired = Some(*q);
            self.force.reset();
            (self.state.asked, self.state.carried, self.state.aside) = (0.0, 0.0, [0.0; 3]);
            let torque = self.settings.joints.rest([q, before], dt, &self.state.gravity);
            return self.answer(torque, *q, true);
        };
        if !self.state.answers {
            let desired = self.state.desired.unwrap_or(*q);
            return self.answer(self.state.torque.unwrap_or(self.state.gravity), desired, false);
        }
        target.force = self.asks(target.force, dt);
        self.press(&target, sample.force, has_force, dt);
        let last = self.state.desired.unwrap_or(*q);
        let desired = self.send(&target, &last, dt);
        let gravity = self.state.gravity;
        let mut torque = self.settings.joints.torques([&desired, &last], [q, before], dt, &gravity);
        self.carry(&target, status, dt);
        let drag = self.slide(q, &target, &sample.push, status, dt);
        self.yield_aside(&target, &sample.push, &drag[1], status, dt);
        let Settings { carry, aside, drag: share, feed, .. } = self.settings;
        if carry > 0.0 || aside > 0.0 || share > 0.0 {
            let State { carried, aside, .. } = self.state;
            let push = core::array::from_fn(|k| carried * target.normal[k] + aside[k] + drag[0][k]);
            let pressing = self.model.pressing(q, &push);
            (0..N).for_each(|j| torque[j] += pressing[j]);
        }
        if feed > 0.0 {
            let moving = self.model.moving(q, &target.dq, &target.ddq);
            (0..N).for_each(|j| torque[j] += feed * moving[j]);
        }
        self.state.desired = Some(desired);
        self.answer(torque, desired, false)
    }

    /// Desired force from the plan, limited in rate, N.
    fn asks(&mut self, wanted: Option<f64>, dt: f64) -> Option<f64> {
        let (step, last) = (self.settings.limits.force_rate * dt, self.state.asked);
        self.state.asked = wanted.map_or(0.0, |wanted| wanted.clamp(last - step, last + step));
        wanted.map(|_| self.state.asked)
    }

    /// Moves the displacement along the normal.
    fn press(&mut self, target: &Target<N>, force: f64, has_force: bool, dt: f64) {
        match (self.state.machine.status(), target.force) {
            (Status::Leaving(_), _) => {
                self.force.go(self.settings.force.range[0], dt);
            }
            (Status::Free, _) => {
                self.force.go(0.0, dt);
            }
            (status @ (Status::Approaching | Status::Pressing | Status::Lost), Some(wanted)) if has_force => {
                let ceiling = self.state.contact.ceiling(&self.settings.search());
                if status == Status::Pressing {
                    self.force.press(wanted - force, dt, ceiling, target.ahead);
                } else {
                    self.force.approach(wanted - force, dt, ceiling, target.ahead);
                }
            }
            _ => self.force.hold(),
        }
    }

    /// Ramps the feed-forward force up within half a second of contact and down within 20 ms of its
    /// end.
    fn carry(&mut self, target: &Target<N>, status: Status, dt: f64) {
        let wanted = target.force.unwrap_or(0.0);
        let to = if self.presses(status) { self.settings.carry * wanted } else { 0.0 };
        let carried = self.state.carried;
        let full = wanted.max(carried);
        let (up, down) = (full * dt / 0.5, full * dt / 0.02);
        self.state.carried = to.clamp(carried - down, carried + up);
    }

    fn presses(&self, status: Status) -> bool {
        status == Status::Pressing && self.state.contact.touches()
    }

    /// Predicted drag, N, world axes: for the planned sliding now, and with the delay of the
    /// estimate. Learns the friction from the estimate.
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

    /// Feeds forward the estimated tangential force, low-passed and at most as large as the desired
    /// normal force. Friction is proportional to the normal force. So the ratio of tangential to
    /// normal force is used, times the desired force; otherwise oscillations of one would feed back
    /// into the other. The part already fed forward (`known`, with the estimate's delay) is
    /// subtracted.
    fn yield_aside(&mut self, target: &Target<N>, push: &[f64; 3], known: &[f64; 3], status: Status, dt: f64) {
        let (n, most) = (target.normal, target.force.unwrap_or(0.0));
        let presses = self.presses(status);
        let keep = 1.0 / (1.0 + self.settings.aside_pole * dt);
        let out: f64 = (0..3).map(|k| push[k] * n[k]).sum();
        let share = most / out.max(self.settings.contact).max(1e-9);
        for k in 0..3 {
            let left = share * (push[k] - out * n[k]) - known[k];
            let to = if presses { self.settings.aside * left } else { 0.0 };
            // Holds the value while there is no estimate.
            if to.is_finite() {
                self.state.aside[k] = (to + keep * (self.state.aside[k] - to)).clamp(-most, most);
            }
        }
    }

    /// Desired positions: the plan's, displaced along the normal, within the velocity limits.
    fn send(&mut self, target: &Target<N>, last: &[f64; N], dt: f64) -> [f64; N] {
        let by = target.normal.map(|n| n * self.force.displacement());
        let wanted = self.model.displaced(&target.q, &by, last);
        let Settings { limits, velocity, period, patience, .. } = &self.settings;
        let wanted = wanted.filter(|q| {
            q.iter().all(|x| x.is_finite())
                && limits.contain(q)
                && self.state.postures.take(q, velocity, *period, *patience)
        });
        self.state.exceeded.reach(wanted.is_some(), self.settings.period);
        let Some(wanted) = wanted else { return *last };
        core::array::from_fn(|j| {
            let reach = self.settings.velocity[j] * dt;
            wanted[j].clamp(last[j] - reach, last[j] + reach)
        })
    }

    /// Builds a command within the limits of size and rate. Torques that are not finite are held,
    /// or, in a stop that must not hold any (`stops`), replaced by gravity.
    fn answer(&mut self, torque: [f64; N], desired: [f64; N], stops: bool) -> Command<N> {
        let Settings { torque: most, limits, period, .. } = &self.settings;
        let state = &mut self.state;
        let numbers = torque.iter().all(|t| t.is_finite());
        state.answers &= numbers;
        let held = state.torque.unwrap_or([0.0; N]);
        let wanted: [f64; N] = match (numbers, stops) {
            (true, _) => torque,
            (false, true) => core::array::from_fn(|j| if torque[j].is_finite() { torque[j] } else { state.gravity[j] }),
            (false, false) => held,
        };
        // The first torques take over the arm from its brakes.
        let last = state.torque.unwrap_or(wanted);
        let next = core::array::from_fn(|j| {
            let step = limits.torque_rate[j] * period;
            wanted[j].clamp(last[j] - step, last[j] + step).clamp(-most[j], most[j])
        });
        state.exceeded.saturate(next != wanted, *period);
        state.torque = Some(next);
        Command { torque: next, desired, displacement: self.force.displacement(), status: state.machine.status() }
    }
}
