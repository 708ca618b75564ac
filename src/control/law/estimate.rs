//! Force estimate without a sensor, equation (14): `F = (J')^+ (Gamma - Gamma_dyn)`, sample by
//! sample.
//!
//! Positions and torques first pass the same low-pass, so that model and measurement have the same
//! delay; velocity and acceleration are backward differences of its output.
//!
//! A joint at rest is held by friction of any value within its breakaway level
//! ([`Body::static_friction`]). While such friction explains all residual torques of the arm, there
//! is no force: the estimate decays to zero. Residual torques that it does not explain are a force,
//! with friction as in the model.

use super::least::{factor, substitute};
use super::model::{Body, Tool};
use super::rest::Rest;

/// Settings of the force estimate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EstimatorSettings<const N: usize> {
    /// Time between samples, s.
    pub period: f64,
    /// Corner frequency of the low-pass (three equal poles), Hz.
    pub corner: f64,
    /// Weight of each joint's torque: reciprocal of its error variance.
    pub weights: [f64; N],
    /// Share of the mean eigenvalue of `J W J'` that is added to all eigenvalues: bounds the
    /// estimate near singular postures.
    pub damping: f64,
    /// Standard deviation of the moment that the contact may transmit, N m. Infinite: unrestricted,
    /// equation (14) of the paper; 0: no moment, and three components are estimated instead of six.
    /// A prior on the moment improves the force, as seven torques determine six components with
    /// hardly any redundancy.
    pub moment: f64,
    /// Largest friction error of each joint just after a reversal ([`Body::turning`] gives joint
    /// and size), N m. After a reversal the wrench is only known to lie in an interval. The value
    /// closest to the previous one is taken, so that possible friction does not count as force.
    /// Where no joint has just reversed, almost nothing changes and no delay is added. The held
    /// value decays to the estimate with a time constant of 0.5 s. 0: equation (14) of the paper.
    pub turning: [f64; N],
    /// Travel within which a joint stands, rad or m: more than the noise of its low-passed
    /// position. 0: it never stands.
    pub rest: [f64; N],
}

/// Time constant with which a held value decays to the estimate, s. It is several times the
/// duration of a friction reversal in a motion (0.1 s), so that a joint that stops does not hold a
/// lost contact or a glitch for long.
const HELD: f64 = 0.5;

/// Squared standard deviations of a joint's torque ([`EstimatorSettings::weights`]) within which
/// friction explains it: to enter the state, and to stay in it.
const EXPLAINED: [f64; 2] = [9.0, 25.0];

/// Largest change of a joint position between samples, rad or m. Beyond it an encoder has wrapped
/// around, samples are missing, or the position is wrong.
const JUMP: f64 = 1.0;

/// Longest time over which lost samples are extrapolated from the preceding motion, s. After it the
/// low-pass restarts.
const LOST: f64 = 0.1;

/// Largest plausible position (rad or m) and torque (N m or N).
const LARGEST: [f64; 2] = [1e5, 1e9];

/// Largest travel of a joint while all torques stay bit-identical, rad or m. Beyond it the torques
/// are outdated.
const FROZEN: f64 = 0.05;

/// Force estimator with its state.
#[derive(Debug, Clone)]
pub struct Estimator<B, const N: usize> {
    body: B,
    settings: EstimatorSettings<N>,
    /// Share of the remaining distance that each pole of the low-pass covers in a period.
    share: f64,
    q: [[f64; N]; 3],
    tau: [[f64; N]; 3],
    /// Positions of the previous sample; `taken` are the last positions and torques fed to the
    /// low-pass.
    last: Option<[f64; N]>,
    taken: [[f64; N]; 2],
    /// Time since a sample was taken, s.
    lost: f64,
    before: [f64; N],
    speed: [f64; N],
    wrench: Option<[f64; 6]>,
    seen: u32,
    rest: Rest<N>,
    friction_alone: bool,
    /// Last torques that differed from those before, and the positions at that time.
    changed: Option<[[f64; N]; 2]>,
}

impl<B: Body<N>, const N: usize> Estimator<B, N> {
    /// Creates an estimator with a model of the arm.
    pub fn new(body: B, settings: EstimatorSettings<N>) -> Self {
        // A pole at -w, discretised by the backward rule: w T / (1 + w T).
        let turn = core::f64::consts::TAU * settings.corner * settings.period;
        Self {
            body,
            settings,
            share: turn / (1.0 + turn),
            q: [[0.0; N]; 3],
            tau: [[0.0; N]; 3],
            last: None,
            taken: [[0.0; N]; 2],
            lost: 0.0,
            before: [0.0; N],
            speed: [0.0; N],
            wrench: None,
            seen: 0,
            rest: Rest::new(settings.rest),
            friction_alone: false,
            changed: None,
        }
    }

    /// Whether joints stand and static friction explains the residual torques of the last sample.
    /// The wrench is then taken as zero, and decays to it with a time constant of 0.5 s.
    pub fn friction_alone(&self) -> bool {
        self.friction_alone
    }

    /// The model, for inspection or changes.
    pub fn body(&mut self) -> &mut B {
        &mut self.body
    }

    /// Torques of the environment at the joints, `Gamma - Gamma_dyn`, of a sample. `None` until the
    /// differences are available, for invalid values, for discontinuous positions, and for torques
    /// that are frozen while the arm moves. The low-pass is then extrapolated at constant speed,
    /// for up to 0.1 s. The same happens when positions have jumped for good (an encoder that wraps
    /// around).
    pub fn external(&mut self, q: &[f64; N], tau: &[f64; N]) -> Option<[f64; N]> {
        let sound = [q, tau].into_iter().zip(LARGEST).all(|(x, most)| x.iter().all(|x| x.abs() <= most));
        if !sound || self.jumps(q) {
            self.bridge();
            return None;
        }
        if self.lost > LOST {
            self.seen = 0;
        }
        self.lost = 0.0;
        if self.seen == 0 {
            (self.q, self.tau, self.before, self.speed) = ([*q; 3], [*tau; 3], *q, [0.0; N]);
            self.taken = [*q, *tau];
        }
        self.follow(q);
        let (speed, change) = self.pass(q, tau);
        if self.is_frozen(q, tau) {
            self.wrench = None;
            return None;
        }
        let model = self.body.torques(&self.before, &speed, &change, self.settings.period);
        (self.seen > 3).then(|| core::array::from_fn(|j| self.tau[2][j] - model[j]))
    }

    /// Low-passes positions and torques; returns velocity and acceleration of the filtered
    /// positions.
    fn pass(&mut self, q: &[f64; N], tau: &[f64; N]) -> ([f64; N], [f64; N]) {
        for j in 0..N {
            for (stages, new) in [(&mut self.q, q[j]), (&mut self.tau, tau[j])] {
                let mut from = new;
                for stage in stages {
                    stage[j] += self.share * (from - stage[j]);
                    from = stage[j];
                }
            }
        }
        let (period, place) = (self.settings.period, self.q[2]);
        let speed: [f64; N] = core::array::from_fn(|j| (place[j] - self.before[j]) / period);
        let change = core::array::from_fn(|j| (speed[j] - self.speed[j]) / period);
        (self.taken, self.before, self.speed) = ([*q, *tau], place, speed);
        self.seen = self.seen.saturating_add(1);
        (speed, change)
    }

    /// Replaces a lost sample by extrapolating the motion and holding the torques.
    fn bridge(&mut self) {
        self.wrench = None;
        let period = self.settings.period;
        self.lost += period;
        if self.seen > 0 {
            let [q, tau] = self.taken;
            self.pass(&core::array::from_fn(|j| q[j] + self.speed[j] * period), &tau);
        }
    }

    /// Whether a joint is far from its position in the previous sample.
    fn jumps(&mut self, q: &[f64; N]) -> bool {
        let last = self.last.replace(*q).unwrap_or(*q);
        (0..N).any(|j| (q[j] - last[j]).abs() > JUMP)
    }

    /// Shifts the low-pass with joints that have jumped since the last sample fed to it.
    fn follow(&mut self, q: &[f64; N]) {
        for j in (0..N).filter(|&j| (q[j] - self.taken[0][j]).abs() > JUMP) {
            let by = q[j] - self.speed[j] * self.settings.period - self.taken[0][j];
            let unchanged = self.changed.iter_mut().map(|[_, place]| place);
            self.q.iter_mut().chain([&mut self.before]).chain(unchanged).for_each(|place| place[j] += by);
        }
    }

    /// Whether all torques have stayed bit-identical while the arm has moved.
    fn is_frozen(&mut self, q: &[f64; N], tau: &[f64; N]) -> bool {
        let [_, place] = *self.changed.insert(match self.changed {
            Some([last, place]) if last == *tau => [last, place],
            _ => [*tau, *q],
        });
        (0..N).any(|j| (q[j] - place[j]).abs() > FROZEN)
    }

    /// Wrench of the tool on its surroundings, world axes, about the point of contact: force, N,
    /// and moment, N m.
    pub fn step(&mut self, q: &[f64; N], tau: &[f64; N]) -> Option<[f64; 6]> {
        let external = self.external(q, tau)?;
        let stands = self.rest.step(&self.before, self.settings.period);
        let tool = self.body.tool(&self.before);
        let turning = self.body.turning();
        let turning = core::array::from_fn(|j| {
            let most = self.settings.turning[j];
            if most > 0.0 { turning[j].clamp(-most, most) } else { 0.0 }
        });
        self.friction_alone = self.explained(&external, &stands, &turning);
        if self.friction_alone {
            let left = 1.0 - (self.settings.period / HELD).min(1.0);
            let wrench = self.wrench.unwrap_or([0.0; 6]).map(|x| left * x);
            self.wrench = Some(wrench);
            return self.wrench;
        }
        let found = if self.settings.moment > 0.0 {
            self.estimated::<6>(&tool, &external, &turning)?
        } else {
            let [force, less, more] = self.estimated::<3>(&tool, &external, &turning)?;
            [force, less, more].map(|w| [w[0], w[1], w[2], 0.0, 0.0, 0.0])
        };
        // Of all wrenches within the bounds, the one that changes least.
        let [wrench, less, more] = found;
        let last = self.wrench.unwrap_or(wrench);
        let share = (self.settings.period / HELD).min(1.0);
        let wrench = core::array::from_fn(|i| {
            let held = last[i] + share * (wrench[i] - last[i]);
            held.clamp(wrench[i] + less[i], wrench[i] + more[i])
        });
        if !wrench.iter().all(|x: &f64| x.is_finite()) {
            return None;
        }
        self.wrench = Some(wrench);
        Some(wrench)
    }

    /// Whether friction explains all torques: for joints at rest within the breakaway level, for
    /// others within the deviation after a reversal. False if every joint moves.
    fn explained(&self, external: &[f64; N], stands: &[bool; N], turning: &[f64; N]) -> bool {
        let at_rest = self.body.static_friction();
        let limit = EXPLAINED[usize::from(self.friction_alone)];
        let within = |j: usize| {
            let [less, more] = if stands[j] { at_rest[j] } else { [turning[j].min(0.0), turning[j].max(0.0)] };
            let beyond = external[j] - external[j].min(more).max(less);
            self.settings.weights[j] * beyond * beyond <= limit
        };
        stands.contains(&true) && (0..N).all(within)
    }

    /// Estimates the first `M` components from the torques, with the amounts by which uncertain
    /// friction may lower (not above 0) and raise them.
    fn estimated<const M: usize>(
        &self,
        tool: &Tool<N>,
        external: &[f64; N],
        turning: &[f64; N],
    ) -> Option<[[f64; M]; 3]> {
        let EstimatorSettings { weights, damping, moment, .. } = &self.settings;
        let mut a = [[0.0; M]; M];
        for i in 0..M {
            for k in 0..=i {
                a[i][k] = (0..N).map(|j| tool.jacobian[i][j] * weights[j] * tool.jacobian[k][j]).sum();
            }
        }
        let trace: f64 = (0..M).map(|i| a[i][i]).sum();
        let moment = moment.max(1e-6);
        for (i, row) in a.iter_mut().enumerate() {
            row[i] += damping * trace / M as f64 + if i < 3 { 0.0 } else { 1.0 / (moment * moment) };
        }
        factor(&mut a, trace)?;
        let right = core::array::from_fn(|i| (0..N).map(|j| tool.jacobian[i][j] * weights[j] * external[j]).sum());
        let wrench = substitute(&a, &right);
        let [mut less, mut more] = [[0.0; M]; 2];
        for j in (0..N).filter(|&j| turning[j] != 0.0) {
            // Friction that is higher in the model is lower at the contact.
            let by = substitute(&a, &core::array::from_fn(|i| -tool.jacobian[i][j] * weights[j] * turning[j]));
            for i in 0..M {
                less[i] += by[i].min(0.0);
                more[i] += by[i].max(0.0);
            }
        }
        // A minimum drops NaN, so the friction range itself is checked.
        let sound = wrench.iter().chain(&less).chain(&more).chain(turning).all(|x| x.is_finite());
        sound.then_some([wrench, less, more])
    }
}
