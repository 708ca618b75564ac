//! The force without a sensor, equation (14): `F = (J')^+ (Gamma - Gamma_dyn)`, sample by sample.
//!
//! Positions and torques pass the same low-pass before anything else, so that model and measurement
//! stay in step; velocity and acceleration are backward differences of what comes out.
//!
//! A joint at rest is held by friction of any value within its breakaway level
//! ([`Body::static_friction`]). While such friction explains all that the torques of the arm leave,
//! there is no force: the estimate decays to zero. Torques that it does not explain are a force,
//! with friction as the model has it.

use super::least::{factor, substitute};
use super::model::{Body, Tool};
use super::rest::Rest;

/// How the force is estimated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EstimatorSettings<const N: usize> {
    /// Time between samples, s.
    pub period: f64,
    /// Corner of the low-pass (three equal poles), Hz.
    pub corner: f64,
    /// Weight of each joint's torque: one over the variance of its error.
    pub weights: [f64; N],
    /// Part of the mean eigenvalue of `J W J'` that is added to all: bounds the estimate near
    /// singular postures.
    pub damping: f64,
    /// How large a moment the contact may carry, N m, as a standard deviation. Infinite: any at
    /// all, equation (14) of the paper; 0: none, and three components are found in place of six. A
    /// prior on the moment improves the force: seven torques determine six components hardly better
    /// than they are measured.
    pub moment: f64,
    /// Largest error of the friction of each joint just after a reversal ([`Body::turning`] gives
    /// place and size), N m. There the wrench is only known to lie in an interval. The value next
    /// to the last one is taken, so that possible friction does not count as force. Where no joint
    /// has just turned round nearly nothing is changed, and nothing comes later. The held value
    /// decays to the estimate within half a second. 0: equation (14) of the paper.
    pub turning: [f64; N],
    /// Travel within which a joint stands, rad or m: more than the noise of its position behind the
    /// low-pass. 0: it never does.
    pub rest: [f64; N],
}

/// Time constant with which a held value decays to the estimate, s. It is some times as long as
/// friction takes to turn round in a motion (0.1 s), so that a joint that stops does not hold a
/// lost contact, or a glitch.
const HELD: f64 = 0.5;

/// Squared standard deviations of a joint's torque ([`EstimatorSettings::weights`]) within which
/// friction explains it: to begin with, and as long as it did.
const EXPLAINED: [f64; 2] = [9.0, 25.0];

/// Farthest that a joint goes from one sample to the next, rad or m. Beyond it an encoder has wrapped
/// round, samples are missing, or the position is wrong.
const JUMP: f64 = 1.0;

/// Longest time over which lost samples are replaced by the motion before them, s. Then the low-pass
/// begins again.
const LOST: f64 = 0.1;

/// No joint has a position (rad or m) or a torque (N m or N) beyond these.
const LARGEST: [f64; 2] = [1e5, 1e9];

/// How far a joint may go while no torque changes by a bit, rad or m. Beyond it the torques are
/// those of another time.
const FROZEN: f64 = 0.05;

/// State that runs along with the arm.
#[derive(Debug, Clone)]
pub struct Estimator<B, const N: usize> {
    body: B,
    settings: EstimatorSettings<N>,
    /// Each pole of the low-pass moves by this share of the way in a period.
    share: f64,
    q: [[f64; N]; 3],
    tau: [[f64; N]; 3],
    /// Positions of the last sample; positions and torques that went into the low-pass last.
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
    /// The last torques that differed from those before, and where that was.
    changed: Option<[[f64; N]; 2]>,
}

impl<B: Body<N>, const N: usize> Estimator<B, N> {
    /// With a model of the arm.
    pub fn new(body: B, settings: EstimatorSettings<N>) -> Self {
        // A pole at -w, by the backward rule: w T / (1 + w T).
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

    /// Whether joints stand and static friction explains what the torques of the last sample left:
    /// the wrench is then taken as zero, and goes there within half a second.
    pub fn friction_alone(&self) -> bool {
        self.friction_alone
    }

    /// The model, to look at or to change.
    pub fn body(&mut self) -> &mut B {
        &mut self.body
    }

    /// Torques of the environment at the joints, `Gamma - Gamma_dyn`, of a sample. `None` until the
    /// differences are there, for a sample that is no number or no joint's, for positions that jump,
    /// and for torques that are frozen while the arm moves. The low-pass then goes on as fast as
    /// before, up to 0.1 s; so it does when positions have jumped for good (an encoder that wraps
    /// round).
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

    /// Puts positions and torques through the low-pass; speed and acceleration behind it.
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

    /// Replaces a lost sample by the motion and the torques before it.
    fn bridge(&mut self) {
        self.wrench = None;
        let period = self.settings.period;
        self.lost += period;
        if self.seen > 0 {
            let [q, tau] = self.taken;
            self.pass(&core::array::from_fn(|j| q[j] + self.speed[j] * period), &tau);
        }
    }

    /// Whether a joint is far from where it was a sample ago.
    fn jumps(&mut self, q: &[f64; N]) -> bool {
        let last = self.last.replace(*q).unwrap_or(*q);
        (0..N).any(|j| (q[j] - last[j]).abs() > JUMP)
    }

    /// Moves the low-pass along with joints that have jumped since the last sample that it took.
    fn follow(&mut self, q: &[f64; N]) {
        for j in (0..N).filter(|&j| (q[j] - self.taken[0][j]).abs() > JUMP) {
            let by = q[j] - self.speed[j] * self.settings.period - self.taken[0][j];
            let unchanged = self.changed.iter_mut().map(|[_, place]| place);
            self.q.iter_mut().chain([&mut self.before]).chain(unchanged).for_each(|place| place[j] += by);
        }
    }

    /// Whether all torques have been the same to the bit while the arm has moved.
    fn is_frozen(&mut self, q: &[f64; N], tau: &[f64; N]) -> bool {
        let [_, place] = *self.changed.insert(match self.changed {
            Some([last, place]) if last == *tau => [last, place],
            _ => [*tau, *q],
        });
        (0..N).any(|j| (q[j] - place[j]).abs() > FROZEN)
    }

    /// Wrench of the tool on its surroundings, world axes, about the point of contact: force (N)
    /// and moment (N m).
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
        // Within the bounds of all wrenches that it may be, the one that changes least.
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

    /// Whether friction explains all torques: of joints that stand within the breakaway level, of
    /// others as far as they have just turned round. Not where every joint moves.
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

    /// The first `M` components as estimated from the torques, and by how much they may be less
    /// (not above 0) and more, where friction is in doubt.
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
            // Friction that is more in the model is less at the contact.
            let by = substitute(&a, &core::array::from_fn(|i| -tool.jacobian[i][j] * weights[j] * turning[j]));
            for i in 0..M {
                less[i] += by[i].min(0.0);
                more[i] += by[i].max(0.0);
            }
        }
        // A minimum drops NaN, so the doubt itself is examined.
        let sound = wrench.iter().chain(&less).chain(&more).chain(turning).all(|x| x.is_finite());
        sound.then_some([wrench, less, more])
    }
}
