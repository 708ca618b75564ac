//! The hypotheses: one file per cause of the vocabulary.
//!
//! A hypothesis defines the places (joints, or the whole robot) where its cause may act, and for
//! each place a family of torque columns. The columns are linear in its coefficients. A few further
//! numbers (`shape`: a speed, an order, a time) are searched on a grid and then refined.

use dh_codegen::robot::EffectKind;
use dh_codegen::robot::effects::Key;
use nalgebra::DMatrix;

use crate::diagnose::windows::windowed_data::{Column, WindowedData};

mod asymmetric_friction;
mod backlash;
mod base_tilt;
mod encoder_offset;
pub(super) mod external_contact;
mod friction_drift;
mod gear_coupling;
mod geometric_error;
mod joint_elasticity;
mod joint_spring;
mod link_inertia_error;
mod load_dependent_friction;
mod nonlinear_viscous_friction;
mod payload;
mod plain;
mod point_mass;
mod position_dependent_friction;
mod presliding_hysteresis;
mod pushed_stretches;
mod rotor_inertia;
mod stribeck_friction;
mod time_delay;
mod torque_gain_error;
mod torque_ripple;
mod torque_saturation;
mod wall;

pub use asymmetric_friction::AsymmetricFriction;
use plain::{COULOMB, VISCOUS};
pub use plain::{OFFSET, PLAIN};
pub use point_mass::inertia as point_inertia;

/// Kind of a cause. Causes of one kind on one joint resemble each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Torque against the motion.
    Friction,
    /// Between motor and link.
    Transmission,
    /// Errors of sensors and signals.
    Measurement,
    /// Masses and geometry.
    Body,
    /// External forces.
    Outside,
}

/// Scope of a cause.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scope {
    /// One joint.
    Joint,
    /// A joint and its neighbour.
    Pair,
    /// The whole robot.
    Robot,
    /// One joint or the whole robot.
    JointOrRobot,
}

/// Range of a coefficient within which the cause is meaningful.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Sign {
    /// Any sign.
    Any,
    /// Above zero.
    Positive,
}

/// Symbol of a number that a hypothesis estimates.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Symbol {
    /// A key of the robot file.
    Key(Key),
    /// A number used by the hypothesis alone, which no file has.
    Own(&'static str),
}

impl Symbol {
    /// Name in reports, without the joint.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Key(key) => key.name(),
            Self::Own(name) => name,
        }
    }
}

impl From<Key> for Symbol {
    fn from(key: Key) -> Self {
        Self::Key(key)
    }
}

/// A linear coefficient with its column.
#[derive(Debug, Clone)]
pub struct Term {
    /// Symbol, as in a robot file: `FL`.
    pub symbol: Symbol,
    /// Torque per unit of the coefficient.
    pub column: Column,
    /// Admissible range.
    pub sign: Sign,
}

impl Term {
    /// A term.
    pub fn new(symbol: impl Into<Symbol>, column: Column, sign: Sign) -> Self {
        Self { symbol: symbol.into(), column, sign }
    }
}

/// A nonlinear number of the family.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shape {
    /// Symbol: `VS`.
    pub symbol: Symbol,
    /// Unit.
    pub unit: &'static str,
    /// Smallest and largest sensible value.
    pub range: [f64; 2],
    /// First step of the refinement: `None` for no refinement, a share of the value if positive, an
    /// absolute step if negative.
    pub step: Option<f64>,
}

impl Shape {
    /// Whether it is a parameter of the robot file and not only of the search.
    pub fn named(&self) -> bool {
        matches!(self.symbol, Symbol::Key(_))
    }
}

/// A number with its symbol, for the robot file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Named {
    /// Symbol, without the joint.
    pub symbol: Symbol,
    /// Value.
    pub value: f64,
    /// Standard deviation; `None` if not estimated.
    pub std: Option<f64>,
}

impl Named {
    /// A number with this symbol.
    pub fn new(symbol: impl Into<Symbol>, value: f64, std: Option<f64>) -> Self {
        Self { symbol: symbol.into(), value, std }
    }

    /// Converts it for the report, with the number of its (first) joint, from 1, if it has one.
    pub fn of_joint(self, joint: Option<usize>) -> Quantity {
        let Self { symbol, value, std } = self;
        let joint = joint.map(|joint| joint.to_string()).unwrap_or_default();
        Quantity { symbol: format!("{}{joint}", symbol.name()), value, std }
    }
}

/// A number with its name for the report and the JSON.
#[derive(Debug, Clone, PartialEq)]
pub struct Quantity {
    /// Symbol with the joint's number: `FS3`.
    pub symbol: String,
    /// Value.
    pub value: f64,
    /// Standard deviation; `None` if not estimated.
    pub std: Option<f64>,
}

/// Estimate of a cause in its place.
pub struct Estimate<'a> {
    /// The windowed data.
    pub scene: &'a WindowedData<'a>,
    /// Joints on which it acts, from 0; empty for the whole robot.
    pub place: &'a [usize],
    /// Nonlinear numbers of the cause.
    pub shape: &'a [f64],
    /// Their standard deviations, where estimated.
    pub shape_std: Vec<Option<f64>>,
    /// Terms of the cause.
    pub terms: &'a [Term],
    /// Coefficients of the terms.
    pub x: &'a [f64],
    /// `FV`, `FC`, `FO` of its joint: the file's values plus the fitted changes.
    pub levels: [f64; 3],
    /// Covariance of the coefficients, followed by the levels.
    pub covariance: DMatrix<f64>,
}

impl Estimate<'_> {
    /// Standard deviation of a coefficient.
    pub fn std(&self, k: usize) -> f64 {
        self.covariance[(k, k)].max(0.0).sqrt()
    }

    /// Standard deviation of the sum of a coefficient and a level.
    pub fn std_with(&self, k: usize, level: usize) -> f64 {
        let at = self.x.len() + level;
        let c = &self.covariance;
        (c[(k, k)] + c[(at, at)] + 2.0 * c[(k, at)]).max(0.0).sqrt()
    }

    /// A coefficient under its own symbol.
    pub fn term(&self, k: usize) -> Named {
        Named::new(self.terms[k].symbol, self.x[k], Some(self.std(k)))
    }

    /// All coefficients.
    pub fn all_terms(&self) -> impl Iterator<Item = Named> + '_ {
        (0..self.terms.len().min(self.x.len())).map(|k| self.term(k))
    }
}

/// Quantity over which the effect of a cause is displayed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Over {
    /// The joint's position.
    Position,
    /// The joint's velocity.
    Velocity,
    /// The joint's acceleration.
    Acceleration,
    /// The torque of the model.
    Torque,
    /// Time.
    Time,
}

/// A law of an effect, with the shapes to try.
pub type Law = (&'static dyn Hypothesis, Vec<Vec<f64>>);

/// A hypothesis of the vocabulary: a cause with its places, columns and conditions.
pub trait Hypothesis: Sync {
    /// The effect that it models.
    fn effect(&self) -> EffectKind;

    /// Name in files and reports.
    fn name(&self) -> &'static str {
        self.effect().name()
    }

    /// Kind of the cause.
    fn kind(&self) -> Kind;

    /// Scope of the cause.
    fn scope(&self) -> Scope {
        Scope::Joint
    }

    /// Joints (from 0) of each place where it may act; empty for the whole robot.
    fn places(&self, scene: &WindowedData<'_>) -> Vec<Vec<usize>> {
        let dof = scene.dof();
        let joints = (0..dof).map(|j| vec![j]);
        match self.scope() {
            Scope::Joint => joints.collect(),
            Scope::Pair => (1..dof).flat_map(|m| [vec![m, m - 1], vec![m - 1, m]]).collect(),
            Scope::Robot => vec![Vec::new()],
            Scope::JointOrRobot => std::iter::once(Vec::new()).chain(joints).collect(),
        }
    }

    /// Nonlinear numbers of the family.
    fn shape(&self) -> &'static [Shape] {
        &[]
    }

    /// Shapes on which the search starts.
    fn grid(&self, _scene: &WindowedData<'_>, _place: &[usize], _residual: &[Vec<f64>]) -> Vec<Vec<f64>> {
        vec![Vec::new()]
    }

    /// Whether it is observable in these data. A model that has it evaluates it on any data.
    fn shows(&self, _scene: &WindowedData<'_>, _place: &[usize], _shape: &[f64]) -> bool {
        true
    }

    /// Whether the data do not resolve two such laws in one place: their sizes then cancel.
    fn unresolved(&self, _scene: &WindowedData<'_>, _place: &[usize], _a: &[f64], _b: &[f64]) -> bool {
        false
    }

    /// Whether two shapes are of the same cause. Of causes of which one place may have several
    /// ([`most`](Self::most)) the shape tells which one it is; an empty shape tells nothing.
    fn same_law(&self, _a: &[f64], _b: &[f64]) -> bool {
        true
    }

    /// Index of the shape number that is an integer, by nature (periods per turn) or by preference.
    /// An integer value does not count as an unknown.
    fn integer_shape(&self) -> Option<usize> {
        None
    }

    /// Standard deviation of the prior on that number, where integers are only preferred.
    fn integer_prior_std(&self) -> Option<f64> {
        None
    }

    /// Number of unknowns in this shape.
    fn free(&self, shape: &[f64]) -> usize {
        let numbers = self.shape().iter().enumerate().filter(|(_, s)| s.step.is_some());
        numbers
            .filter(|(k, _)| self.integer_shape() != Some(*k) || shape.get(*k).is_none_or(|v| v.fract() != 0.0))
            .count()
    }

    /// Columns of the family; empty if they do not exist.
    fn terms(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64]) -> Vec<Term>;

    /// Index of the law to which a shape belongs; refinement never changes it.
    fn law(&self, _shape: &[f64]) -> usize {
        0
    }

    /// Laws of the same effect with fewer unknowns, the simplest first, each with the shapes to
    /// try. They apply if the further terms of this law only fit noise.
    fn simpler(&self, _scene: &WindowedData<'_>, _place: &[usize], _shape: &[f64]) -> Vec<Law> {
        Vec::new()
    }

    /// Whether the columns are difference quotients about zero. Their step is then the first number
    /// of the shape, which is set to the coefficient.
    fn finite_difference(&self) -> bool {
        false
    }

    /// Shape implied by these coefficients, for a shape that depends on them.
    fn follows(&self, _terms: &[Term], _x: &[f64]) -> Option<Vec<f64>> {
        None
    }

    /// Whether its columns correlate with accelerations, so that errors of derivatives resemble it.
    fn follows_acceleration(&self) -> bool {
        matches!(self.kind(), Kind::Body | Kind::Transmission)
    }

    /// Whether it acts between the motor's and the joint's torque, so that it is visible in their
    /// difference where both are measured.
    fn in_the_drive(&self) -> bool {
        matches!(self.kind(), Kind::Friction | Kind::Measurement)
    }

    /// Whether it can fit any error that reverses with the motion or drifts, and so absorbs a part
    /// of plain friction.
    fn follows_reversals(&self) -> bool {
        false
    }

    /// Whether its size is in its shape, so that its single coefficient is 1 within [`UNIT`] where
    /// its law holds.
    fn unit(&self) -> bool {
        false
    }

    /// Whether it may act in one part of the data only, so that other parts cannot confirm it.
    fn local(&self) -> bool {
        false
    }

    /// Start and end of a local cause, s of used data; `None` for others.
    fn acts(&self, _shape: &[f64]) -> Option<[f64; 2]> {
        None
    }

    /// Windows with contact, for a contact that depends on the position of the robot; empty for all
    /// other causes.
    fn touches(&self, _scene: &WindowedData<'_>, _shape: &[f64]) -> Vec<bool> {
        Vec::new()
    }

    /// Maximum number of instances in one place (ripple of several orders, successive pushes).
    fn most(&self) -> usize {
        1
    }

    /// Whether it is compensated by shifting the torques in time. Its coefficient is then added to
    /// the delays of the scene.
    fn moves_time(&self) -> bool {
        false
    }

    /// Whether it only changes link parameters, so that it is not identifiable where all base
    /// parameters are unknown.
    fn within_links(&self) -> bool {
        false
    }

    /// Whether a constant torque on its joint is part of it.
    fn has_constant(&self) -> bool {
        false
    }

    /// Causes that no motion separates from it.
    fn same_on_paper(&self) -> &'static [&'static str] {
        &[]
    }

    /// Causes that are equivalent here, in theory or for these data.
    fn indistinguishable(&self, _scene: &WindowedData<'_>, _place: &[usize]) -> &'static [&'static str] {
        self.same_on_paper()
    }

    /// Whether the columns depend on the rigid model and must be recomputed when it changes.
    fn rests_on_model(&self) -> bool {
        false
    }

    /// Whether the columns also depend on the friction found so far.
    fn rests_on_friction(&self) -> bool {
        false
    }

    /// Whether estimated coefficients are plausible, beyond their signs.
    fn plausible(&self, _scene: &WindowedData<'_>, _place: &[usize], _shape: &[f64], _x: &[f64]) -> bool {
        true
    }

    /// Part of its coefficients above the resolution of the data.
    fn above_resolution(&self, _scene: &WindowedData<'_>, _place: &[usize], x: &[f64]) -> Vec<f64> {
        x.to_vec()
    }

    /// Parameters under the names of a robot file.
    fn named(&self, found: &Estimate<'_>) -> Vec<Named> {
        let shapes = self.shape().iter().enumerate().filter(|(_, number)| number.named());
        let shapes = shapes.map(|(k, number)| Named::new(number.symbol, found.shape[k], found.shape_std[k]));
        found.all_terms().chain(shapes).collect()
    }

    /// Quantity over which its effect is displayed.
    fn over(&self) -> Over {
        if self.kind() == Kind::Friction { Over::Velocity } else { Over::Position }
    }

    /// The cause of the whole robot with the same columns that explains these coefficients.
    fn equivalent_robot_cause(
        &self,
        _scene: &WindowedData<'_>,
        _place: &[usize],
        _terms: &[Term],
        _x: &[f64],
    ) -> Option<&'static dyn Hypothesis> {
        None
    }

    /// Prior standard deviations of the file's values that its coefficients change, one each;
    /// `None` if it changes none.
    fn prior_std(&self, _scene: &WindowedData<'_>, _place: &[usize], _terms: &[Term]) -> Option<Vec<f64>> {
        None
    }

    /// Description of the effect, for the sentence of the evidence.
    fn says(&self) -> &'static str;

    /// Description of the effect with one shape.
    fn says_of(&self, _shape: &[f64]) -> &'static str {
        self.says()
    }

    /// Experiment that would separate it from others, or show it better.
    fn shown_by(&self) -> &'static str;

    /// Information that would separate it here from the causes in
    /// [`Hypothesis::indistinguishable`], where no motion does.
    fn decided_by(&self, _scene: &WindowedData<'_>, _place: &[usize]) -> Option<&'static str> {
        None
    }
}

/// The hypothesis that models an effect.
pub fn hypothesis(effect: EffectKind) -> &'static dyn Hypothesis {
    match effect {
        EffectKind::ViscousFriction => &VISCOUS,
        EffectKind::CoulombFriction => &COULOMB,
        EffectKind::AsymmetricFriction => &asymmetric_friction::AsymmetricFriction,
        EffectKind::StribeckFriction => &stribeck_friction::StribeckFriction,
        EffectKind::NonlinearViscousFriction => &nonlinear_viscous_friction::NonlinearViscousFriction,
        EffectKind::LoadDependentFriction => &load_dependent_friction::LoadDependentFriction,
        EffectKind::PreslidingHysteresis => &presliding_hysteresis::PreslidingHysteresis,
        EffectKind::FrictionDrift => &friction_drift::FrictionDrift,
        EffectKind::PositionDependentFriction => &position_dependent_friction::PositionDependentFriction,
        EffectKind::RotorInertia => &rotor_inertia::RotorInertia,
        EffectKind::TorqueRipple => &torque_ripple::TorqueRipple,
        EffectKind::JointElasticity => &joint_elasticity::JointElasticity,
        EffectKind::Backlash => &backlash::Backlash,
        EffectKind::GearCoupling => &gear_coupling::GearCoupling,
        EffectKind::TorqueGainError => &torque_gain_error::TorqueGainError,
        EffectKind::TorqueOffset => &OFFSET,
        EffectKind::TorqueSaturation => &torque_saturation::TorqueSaturation,
        EffectKind::EncoderOffset => &encoder_offset::EncoderOffset,
        EffectKind::GeometricError => &geometric_error::GeometricError,
        EffectKind::LinkInertiaError => &link_inertia_error::LinkInertiaError,
        EffectKind::Payload => &payload::Payload,
        EffectKind::BaseTilt => &base_tilt::BaseTilt,
        EffectKind::JointSpring => &joint_spring::JointSpring,
        EffectKind::ExternalContact => &external_contact::ON_TOOL,
        EffectKind::TimeDelay => &time_delay::TimeDelay,
    }
}

/// Further laws of an effect: the same keys, other columns.
fn further(effect: EffectKind) -> &'static [&'static dyn Hypothesis] {
    match effect {
        EffectKind::GearCoupling => &[&gear_coupling::CarriedAxis],
        EffectKind::JointSpring => &[&joint_spring::CableSpring],
        EffectKind::ExternalContact => &[&external_contact::ON_LINK, &wall::Wall],
        EffectKind::Payload => &[&point_mass::POINT_PAYLOAD],
        EffectKind::LinkInertiaError => &[&point_mass::POINT_LINK],
        _ => &[],
    }
}

/// All laws of an effect.
pub(in crate::diagnose) fn laws(effect: EffectKind) -> impl Iterator<Item = &'static dyn Hypothesis> {
    core::iter::once(hypothesis(effect)).chain(further(effect).iter().copied())
}

/// All hypotheses that add columns, in the order of the vocabulary. Baseline friction is excluded,
/// since its columns are always present.
pub fn causes() -> impl Iterator<Item = &'static dyn Hypothesis> {
    let wanted = EffectKind::ALL.iter().filter(|effect| PLAIN.iter().all(|plain| plain.effect() != **effect));
    wanted.flat_map(|&effect| laws(effect))
}

/// The hypothesis with this name.
pub fn by_name(name: &str) -> Option<&'static dyn Hypothesis> {
    EffectKind::of(name).map(hypothesis)
}

/// Tolerance of the coefficient of a [`Hypothesis::unit`] about 1: filters and windows leave so
/// much of a law undetermined.
pub(super) const UNIT: f64 = 0.05;

/// Whether a number of a shape has reached the end of its search range. It is then no estimate, and
/// another law applies. 0 marks a number that is not in use.
pub(super) fn at_edge(cause: &dyn Hypothesis, shape: &[f64]) -> bool {
    let preferred = |k: usize| cause.integer_prior_std().is_some() && cause.integer_shape() == Some(k);
    let numbers = cause.shape().iter().zip(shape).enumerate().filter(|(k, _)| !preferred(*k)).map(|(_, both)| both);
    numbers.filter(|(number, value)| number.step.is_some() && **value != 0.0).any(|(number, value)| {
        let [least, most] = number.range;
        let near = EDGE * (most - least).min(value.abs());
        *value <= least + near || *value >= most - near
    })
}

/// Distance from the end of the range that counts as reached, as a share of the number.
const EDGE: f64 = 0.02;

/// Values from `first` to `last`, `count` of them, in geometric progression.
fn geometric(first: f64, last: f64, count: usize) -> Vec<f64> {
    let steps = count.saturating_sub(1).max(1) as f64;
    (0..count).map(|i| first * (last / first).powf(i as f64 / steps)).collect()
}

/// Whether two orders differ by less than a factor; true if one of them is not given.
fn nearly_one_order(a: &[f64], b: &[f64], factor: f64) -> bool {
    match (a, b) {
        (&[a], &[b]) => a < factor * b && b < factor * a,
        _ => true,
    }
}

/// Whether joint `j` moves significantly: beyond its velocity noise and by more than 0.02 rad.
fn moves(scene: &WindowedData<'_>, j: usize) -> bool {
    let [low, high] = scene.travel[j];
    high - low > 0.02 && scene.fastest[j] > 3.0 * scene.velocity_noise_limit[j]
}
