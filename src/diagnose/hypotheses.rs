//! The hypotheses: one cause of the vocabulary, one file.
//!
//! A cause names places (joints, or the whole robot) where it may act, and for each place a family
//! of columns. They are linear in its coefficients; a few further numbers (`shape`: a speed, an
//! order, a time) are searched on a grid and then refined.

use dh_codegen::robot::EffectKind;
use dh_codegen::robot::effects::Key;
use nalgebra::DMatrix;

use crate::diagnose::windows::windowed_data::{Column, WindowedData};

mod asymmetric_friction;
mod backlash;
mod base_tilt;
mod encoder_offset;
mod external_contact;
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
mod rotor_inertia;
mod stribeck_friction;
mod time_delay;
mod torque_gain_error;
mod torque_ripple;
mod torque_saturation;
mod wall;

pub use asymmetric_friction::AsymmetricFriction;
pub use plain::{COULOMB, OFFSET, VISCOUS};
pub use point_mass::inertia as point_inertia;

/// Kind of a cause: causes of one kind on one joint look alike.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Torque against the motion.
    Friction,
    /// Between motor and link.
    Transmission,
    /// How signals are measured.
    Measurement,
    /// Masses and geometry.
    Body,
    /// From outside.
    Outside,
}

/// On what a cause acts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scope {
    /// One joint.
    Joint,
    /// A joint and its neighbour.
    Pair,
    /// The whole robot.
    Robot,
    /// Either.
    JointOrRobot,
}

/// Range of a coefficient under which the cause deserves its name.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Sign {
    /// Anywhere.
    Any,
    /// Above zero.
    Positive,
}

/// Symbol of a number that a hypothesis estimates.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Symbol {
    /// A key of the robot file.
    Key(Key),
    /// A number of the hypothesis alone, which no file has.
    Own(&'static str),
}

impl Symbol {
    /// As reports write it, without the joint.
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
    /// Torque of one unit of it.
    pub column: Column,
    /// Its range.
    pub sign: Sign,
}

impl Term {
    /// A term.
    pub fn new(symbol: impl Into<Symbol>, column: Column, sign: Sign) -> Self {
        Self { symbol: symbol.into(), column, sign }
    }
}

/// A number of the family in which it is not linear.
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
    /// Whether it is a parameter of the robot file and not one of the search.
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
    /// Standard deviation; `None` where it was not estimated.
    pub std: Option<f64>,
}

impl Named {
    /// A number of this symbol.
    pub fn new(symbol: impl Into<Symbol>, value: f64, std: Option<f64>) -> Self {
        Self { symbol: symbol.into(), value, std }
    }

    /// The same for the report, with the number of its (first) joint, from 1, if it has one.
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
    /// Standard deviation; `None` where it was not estimated.
    pub std: Option<f64>,
}

/// Estimate of a cause in its place.
pub struct Estimate<'a> {
    /// The data.
    pub scene: &'a WindowedData<'a>,
    /// The place.
    pub place: &'a [usize],
    /// The numbers in which it is not linear.
    pub shape: &'a [f64],
    /// Their standard deviations, where they were estimated.
    pub shape_std: Vec<Option<f64>>,
    /// Its terms.
    pub terms: &'a [Term],
    /// Their coefficients.
    pub x: &'a [f64],
    /// `FV`, `FC`, `FO` of its joint, the file's and what was found.
    pub levels: [f64; 3],
    /// Covariance of the coefficients and, behind them, of the levels.
    pub covariance: DMatrix<f64>,
}

impl Estimate<'_> {
    /// Standard deviation of a coefficient.
    pub fn std(&self, k: usize) -> f64 {
        self.covariance[(k, k)].max(0.0).sqrt()
    }

    /// Of the sum of a coefficient and a level.
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

/// Over what a cause shows best.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Over {
    /// The joint's position.
    Position,
    /// Its velocity.
    Velocity,
    /// Its acceleration.
    Acceleration,
    /// The torque of the model.
    Torque,
    /// Time.
    Time,
}

/// A law of an effect, with the shapes to try.
pub type Law = (&'static dyn Hypothesis, Vec<Vec<f64>>);

/// A hypothesis of the vocabulary.
pub trait Hypothesis: Sync {
    /// The effect that it looks for.
    fn effect(&self) -> EffectKind;

    /// Its name in files and reports.
    fn name(&self) -> &'static str {
        self.effect().name()
    }

    /// Its kind.
    fn kind(&self) -> Kind;

    /// On what it acts.
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

    /// The numbers in which the family is not linear.
    fn shape(&self) -> &'static [Shape] {
        &[]
    }

    /// Values of the shape to try.
    fn grid(&self, _scene: &WindowedData<'_>, _place: &[usize], _residual: &[Vec<f64>]) -> Vec<Vec<f64>> {
        vec![Vec::new()]
    }

    /// Whether this data can show it. A model that has it says what it says on any data.
    fn shows(&self, _scene: &WindowedData<'_>, _place: &[usize], _shape: &[f64]) -> bool {
        true
    }

    /// Index of the shape number that is an integer, by its nature (periods a turn) or by
    /// preference: as such it is no unknown.
    fn integer_shape(&self) -> Option<usize> {
        None
    }

    /// Standard deviation of the prior on that number, where integers are only preferred.
    fn integer_prior_std(&self) -> Option<f64> {
        None
    }

    /// How many numbers of this shape are unknown.
    fn free(&self, shape: &[f64]) -> usize {
        let numbers = self.shape().iter().enumerate().filter(|(_, s)| s.step.is_some());
        numbers
            .filter(|(k, _)| self.integer_shape() != Some(*k) || shape.get(*k).is_none_or(|v| v.fract() != 0.0))
            .count()
    }

    /// The family's columns; none where they do not exist.
    fn terms(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64]) -> Vec<Term>;

    /// Law to which a shape belongs, if refining one never leads to another.
    fn law(&self, _shape: &[f64]) -> usize {
        0
    }

    /// Laws of the same effect with fewer unknowns, the simplest first, each with the shapes to
    /// try: this law where its further terms are nothing but noise.
    fn simpler(&self, _scene: &WindowedData<'_>, _place: &[usize], _shape: &[f64]) -> Vec<Law> {
        Vec::new()
    }

    /// Whether the columns are difference quotients about zero: the shape's first number is their
    /// step, which follows the coefficient.
    fn finite_difference(&self) -> bool {
        false
    }

    /// Shape that these coefficients of its terms ask for, where the shape follows them.
    fn follows(&self, _terms: &[Term], _x: &[f64]) -> Option<Vec<f64>> {
        None
    }

    /// Whether its columns go with accelerations, so that errors of derivatives look like it.
    fn follows_acceleration(&self) -> bool {
        matches!(self.kind(), Kind::Body | Kind::Transmission)
    }

    /// Whether it acts between the motor's torque and the joint's: where both are measured it shows in
    /// their difference.
    fn in_the_drive(&self) -> bool {
        matches!(self.kind(), Kind::Friction | Kind::Measurement)
    }

    /// Whether it can follow any error that turns with the motion or drifts, and so takes a part of
    /// what plain friction would explain.
    fn follows_reversals(&self) -> bool {
        false
    }

    /// Whether its size is in its shape, and its one coefficient is 1 where its law holds: known to
    /// [`UNIT`].
    fn unit(&self) -> bool {
        false
    }

    /// Whether it may act in one part of the data only, so that the other parts can't vouch for it.
    fn local(&self) -> bool {
        false
    }

    /// Of what acts in one part of the data: its start and end, s of used data.
    fn acts(&self, _shape: &[f64]) -> Option<[f64; 2]> {
        None
    }

    /// Of what touches the robot wherever that is in a place: in which windows it does. Empty for all
    /// others.
    fn touches(&self, _scene: &WindowedData<'_>, _shape: &[f64]) -> Vec<bool> {
        Vec::new()
    }

    /// How many instances may act in one place (ripple of several orders, pushes one after the
    /// other).
    fn most(&self) -> usize {
        1
    }

    /// Whether it is taken out by moving the torques in time: then its coefficient goes into the
    /// delays of the scene.
    fn moves_time(&self) -> bool {
        false
    }

    /// Whether it only says that link parameters are others: not to be seen where all base
    /// parameters are unknown.
    fn within_links(&self) -> bool {
        false
    }

    /// Whether a constant torque on its joint belongs to it.
    fn has_constant(&self) -> bool {
        false
    }

    /// Causes that no motion separates from it.
    fn same_on_paper(&self) -> &'static [&'static str] {
        &[]
    }

    /// Causes that are the same here, on paper or in what this data can show.
    fn indistinguishable(&self, _scene: &WindowedData<'_>, _place: &[usize]) -> &'static [&'static str] {
        self.same_on_paper()
    }

    /// Whether the columns depend on the rigid model and so must be recomputed when that changes.
    fn rests_on_model(&self) -> bool {
        false
    }

    /// Whether they also depend on the friction found so far.
    fn rests_on_friction(&self) -> bool {
        false
    }

    /// Whether estimated coefficients make sense beyond the sign of each.
    fn plausible(&self, _scene: &WindowedData<'_>, _place: &[usize], _shape: &[f64], _x: &[f64]) -> bool {
        true
    }

    /// Part of its coefficients above the resolution of the data.
    fn above_resolution(&self, _scene: &WindowedData<'_>, _place: &[usize], x: &[f64]) -> Vec<f64> {
        x.to_vec()
    }

    /// Its parameters under the names of a robot file.
    fn named(&self, found: &Estimate<'_>) -> Vec<Named> {
        let shapes = self.shape().iter().enumerate().filter(|(_, number)| number.named());
        let shapes = shapes.map(|(k, number)| Named::new(number.symbol, found.shape[k], found.shape_std[k]));
        found.all_terms().chain(shapes).collect()
    }

    /// Over what it shows best.
    fn over(&self) -> Over {
        if self.kind() == Kind::Friction { Over::Velocity } else { Over::Position }
    }

    /// The cause of the whole robot that has the same columns and explains these coefficients.
    fn equivalent_robot_cause(
        &self,
        _scene: &WindowedData<'_>,
        _place: &[usize],
        _terms: &[Term],
        _x: &[f64],
    ) -> Option<&'static dyn Hypothesis> {
        None
    }

    /// By how much the values of the file that its coefficients change may be off, one each;
    /// `None`: it changes none.
    fn prior_std(&self, _scene: &WindowedData<'_>, _place: &[usize], _terms: &[Term]) -> Option<Vec<f64>> {
        None
    }

    /// Its effect, for the sentence of the evidence.
    fn says(&self) -> &'static str;

    /// The same of one shape.
    fn says_of(&self, _shape: &[f64]) -> &'static str {
        self.says()
    }

    /// Experiment that would separate it from others, or show it better.
    fn shown_by(&self) -> &'static str;

    /// What would tell it here from those that it is [`Hypothesis::indistinguishable`] from, where no
    /// motion does.
    fn decided_by(&self, _scene: &WindowedData<'_>, _place: &[usize]) -> Option<&'static str> {
        None
    }
}

/// The hypothesis that looks for an effect.
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
        EffectKind::ExternalContact => &external_contact::ExternalContact,
        EffectKind::TimeDelay => &time_delay::TimeDelay,
    }
}

/// A further law by which an effect may act: the same keys, other columns.
fn further(effect: EffectKind) -> Option<&'static dyn Hypothesis> {
    match effect {
        EffectKind::GearCoupling => Some(&gear_coupling::CarriedAxis),
        EffectKind::JointSpring => Some(&joint_spring::CableSpring),
        EffectKind::ExternalContact => Some(&wall::Wall),
        EffectKind::Payload => Some(&point_mass::POINT_PAYLOAD),
        EffectKind::LinkInertiaError => Some(&point_mass::POINT_LINK),
        _ => None,
    }
}

/// All laws by which an effect may act.
pub(in crate::diagnose) fn laws(effect: EffectKind) -> impl Iterator<Item = &'static dyn Hypothesis> {
    core::iter::once(hypothesis(effect)).chain(further(effect))
}

/// All hypotheses that add columns, in the order of the vocabulary: those of the baseline friction
/// have theirs already.
pub fn causes() -> impl Iterator<Item = &'static dyn Hypothesis> {
    let plain = [EffectKind::ViscousFriction, EffectKind::CoulombFriction, EffectKind::TorqueOffset];
    let wanted = EffectKind::ALL.iter().filter(move |effect| !plain.contains(effect));
    wanted.flat_map(|&effect| laws(effect))
}

/// The hypothesis of this name.
pub fn by_name(name: &str) -> Option<&'static dyn Hypothesis> {
    EffectKind::of(name).map(hypothesis)
}

/// To what the coefficient of a [`Hypothesis::unit`] is known to be 1: filters and windows leave so
/// much of a law open.
pub(super) const UNIT: f64 = 0.05;

/// Whether a number of a shape has run to the end of its search range: then it is no estimate, and
/// another law is meant. 0 is a number that is not in use.
pub(super) fn at_edge(cause: &dyn Hypothesis, shape: &[f64]) -> bool {
    let preferred = |k: usize| cause.integer_prior_std().is_some() && cause.integer_shape() == Some(k);
    let numbers = cause.shape().iter().zip(shape).enumerate().filter(|(k, _)| !preferred(*k)).map(|(_, both)| both);
    numbers.filter(|(number, value)| number.step.is_some() && **value != 0.0).any(|(number, value)| {
        let [least, most] = number.range;
        let near = EDGE * (most - least).min(value.abs());
        *value <= least + near || *value >= most - near
    })
}

/// Distance from the end within which a number has run there, as a share of itself.
const EDGE: f64 = 0.02;

/// Values from `first` to `last`, `count` of them, evenly spaced in their logarithms.
fn geometric(first: f64, last: f64, count: usize) -> Vec<f64> {
    let steps = count.saturating_sub(1).max(1) as f64;
    (0..count).map(|i| first * (last / first).powf(i as f64 / steps)).collect()
}

/// Whether joint `j` moves at all: beyond what its noise looks like.
fn moves(scene: &WindowedData<'_>, j: usize) -> bool {
    let [low, high] = scene.travel[j];
    high - low > 0.02 && scene.fastest[j] > 3.0 * scene.velocity_noise_limit[j]
}
