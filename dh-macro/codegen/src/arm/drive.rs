//! Torques at the sensors of an arm whose drives have effects beyond rotor and plain friction: the
//! laws of [`crate::robot::effects`] as expressions.
//!
//! `tau = GT clip(load + IA ddq + warmth friction + FO + ripple + law + couplings, TM) + TO`, with
//! `load` the torque of the bodies and of the joint's spring. Links of elastic joints lag their
//! motors by `load / KE`, and by half of the backlash on the side to which the load pushes. These
//! are first-order, quasi-static corrections: load and deflection do not act back on each other,
//! and the link moves at its motor's speed.

use super::chain::{Chain, Group, Links};
use super::dynamics::{self, Values};
use super::formula;
use super::motion::Include;
use super::param::{DriveTerm, Parameter};
use crate::robot::effects::{JointSpring, StribeckFriction};
use crate::robot::{Laws, Variable};
use crate::sym::{Call, Ex, Graph};

/// Source of the bristle states and of the gears' warmth.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Memory {
    /// No state: bristles are at the end of their travel (`sign(v)`), gears are warm (a factor of
    /// 1).
    Steady,
    /// Inputs after the parameters: all bristles, then all factors.
    Given,
    /// The same inputs, followed by the time and all temperatures.
    Clocked,
}

/// Load within which a gear with backlash changes sides, as a share of the torque limit.
const CHANGES_SIDE: f64 = 2e-3;

/// Torques at the sensors.
pub(super) fn torques<'g>(
    chain: &Chain,
    graph: &'g Graph,
    standard: &[Parameter],
    laws: &[Laws],
    memory: Memory,
) -> Vec<Ex<'g>> {
    let geared: Vec<Vec<(usize, f64)>> = laws.iter().map(geared).collect();
    let links = chain.behind(graph, &[], &geared);
    let values = Values::new(&links, standard);
    let mut load = loads(&links, &values, laws, &[]);
    if laws.iter().any(Laws::is_soft) {
        graph.section("links behind soft joints");
        let deflection: Vec<Option<Ex<'g>>> =
            laws.iter().zip(&load).map(|(law, &load)| deflection(law, load)).collect();
        load = loads(&chain.behind(graph, &deflection, &geared), &values, laws, &deflection);
    }
    bear(&mut load, &geared);
    graph.section("drives");
    let after = standard.len();
    let drives: Vec<Drive<'g>> = links
        .moving()
        .map(|(row, k)| {
            let (v, sign) = (links.input(Group::Velocity, k), links.input(Group::Velocity, k).sign());
            let (bristle, warmth) = match memory {
                Memory::Steady => (sign, links.number(1.0)),
                Memory::Given | Memory::Clocked => (
                    links.input(Group::Parameter, after + k),
                    links.input(Group::Parameter, after + links.inputs.dof + k),
                ),
            };
            let encoder = laws.get(k).map_or(0.0, |l| l.encoder_offset);
            let q = links.input(Group::Position, k) + encoder;
            let term = |which| values.drive(row, which).unwrap_or(links.number(0.0));
            Drive { q, v, sign, bristle, warmth, load: load[k], coulomb: term(DriveTerm::FC) }
        })
        .collect();
    let mut tau: Vec<Ex<'g>> = load.clone();
    for (row, k) in links.moving() {
        let Some(law) = laws.get(k) else { continue };
        let (drive, ddq) = (&drives[k], links.input(Group::Acceleration, k));
        let term = |which| values.drive(row, which).unwrap_or(links.number(0.0));
        let friction = term(DriveTerm::FV) * drive.v + drive.friction(law);
        let warm = if law.drift.is_some() { drive.warmth * friction } else { friction };
        tau[k] = tau[k] + term(DriveTerm::IA) * ddq + warm + term(DriveTerm::FO) + ripple(law, drive.q);
    }
    add_formulas(&mut tau, &links, &drives, laws, (memory == Memory::Clocked).then_some(after + 2 * drives.len()));
    for (m, law) in laws.iter().enumerate() {
        for c in &law.couplings {
            let k = c.other;
            let at = |group, joint| links.input(group, joint);
            let along = |joint| at(Group::Acceleration, joint) * c.rotor + at(Group::Velocity, joint) * c.viscous;
            let sign = (drives[m].v + drives[k].v * c.ratio).sign() * c.coulomb;
            tau[k] = tau[k] + (along(m) + sign) * c.ratio;
            tau[m] = tau[m] + along(k) * c.ratio + sign;
        }
    }
    graph.section("sensors");
    tau.iter().zip(laws).map(|(&tau, law)| measured(law, tau)).collect()
}

/// Adds laws in closed form.
fn add_formulas<'g>(tau: &mut [Ex<'g>], links: &Links<'g>, drives: &[Drive<'g>], laws: &[Laws], clock: Option<usize>) {
    let of = |variable| variable_of(variable, links, drives, laws, clock);
    for (law, tau) in laws.iter().zip(tau) {
        if let Some(law) = &law.law {
            *tau = *tau + formula::value(links.graph, law.term(), &of);
        }
    }
}

/// Input of a law in closed form; `clock`: position of the time among the parameters, followed by
/// the temperatures. Without it the time is 0, and joints have their reference temperature.
fn variable_of<'g>(
    variable: Variable,
    links: &Links<'g>,
    drives: &[Drive<'g>],
    laws: &[Laws],
    clock: Option<usize>,
) -> Ex<'g> {
    match (variable, clock) {
        (Variable::Position(k), _) => drives[k].q,
        (Variable::Velocity(k), _) => drives[k].v,
        (Variable::Acceleration(k), _) => links.input(Group::Acceleration, k),
        (Variable::Time, Some(at)) => links.input(Group::Parameter, at),
        (Variable::Temperature(k), Some(at)) => links.input(Group::Parameter, at + 1 + k),
        (Variable::Time, None) => links.number(0.0),
        (Variable::Temperature(k), None) => links.number(laws[k].reference),
    }
}

/// Joints whose motors turn a link in addition to its own, with ratios.
fn geared(law: &Laws) -> Vec<(usize, f64)> {
    law.couplings.iter().filter(|c| c.carried != 0.0).map(|c| (c.other, c.carried)).collect()
}

/// Adds the share of a link's torque that the motors of other joints bear.
fn bear<'g>(load: &mut [Ex<'g>], geared: &[Vec<(usize, f64)>]) {
    let on_links = load.to_vec();
    for (&on_link, carried) in on_links.iter().zip(geared) {
        carried.iter().for_each(|&(k, ratio)| load[k] = load[k] + on_link * ratio);
    }
}

/// Torques transmitted by the gears: those of the bodies and of the joint springs.
fn loads<'g>(links: &Links<'g>, values: &Values<'g>, laws: &[Laws], deflection: &[Option<Ex<'g>>]) -> Vec<Ex<'g>> {
    let mut load = dynamics::torques(links, values, Include::ALL, false, false);
    for (k, law) in laws.iter().enumerate() {
        if let Some(spring) = law.spring {
            let mut q = links.input(Group::Position, k) + (law.encoder_offset - spring.rest());
            for (other, ratio) in geared(law) {
                q = q + links.input(Group::Position, other) * ratio;
            }
            if let Some(by) = deflection.get(k).copied().flatten() {
                q = q - by;
            }
            load[k] = load[k] + elastic(spring, law.rated, q);
        }
    }
    load
}

/// Torque of a joint's spring, `x` rad from its rest angle.
fn elastic<'g>(spring: JointSpring, rated: f64, x: Ex<'g>) -> Ex<'g> {
    let zero = x.graph().constant(0.0);
    let x = match spring.side() {
        side if side > 0.0 => x.most(zero),
        side if side < 0.0 => x.least(zero),
        _ => x,
    };
    let linear = x * spring.stiffness(rated);
    if spring.cubic() == 0.0 { linear } else { linear + x * x * x * spring.cubic() }
}

/// Lag of an elastic joint's link behind its motor.
fn deflection<'g>(law: &Laws, load: Ex<'g>) -> Option<Ex<'g>> {
    let small = CHANGES_SIDE * law.rated;
    let zero = load.graph().constant(0.0);
    let side = if law.backlash() == 0.0 { zero } else { load / (load * load + small * small).call(Call::Sqrt) };
    let spring = law.stiffness().map_or(zero, |stiffness| load * (1.0 / stiffness));
    law.is_soft().then(|| spring + side * (0.5 * law.backlash()))
}

/// Inputs of the laws of one joint.
struct Drive<'g> {
    /// True angle of the motor.
    q: Ex<'g>,
    v: Ex<'g>,
    sign: Ex<'g>,
    /// Replacement of the sign in a law with hysteresis.
    bristle: Ex<'g>,
    warmth: Ex<'g>,
    load: Ex<'g>,
    /// Coulomb level `FC`.
    coulomb: Ex<'g>,
}

impl<'g> Drive<'g> {
    fn number(&self, value: f64) -> Ex<'g> {
        self.v.graph().constant(value)
    }

    fn speed(&self) -> Ex<'g> {
        self.v.call(Call::Abs)
    }

    /// All friction except `FV v`.
    fn friction(&self, law: &Laws) -> Ex<'g> {
        let mut level = self.coulomb;
        if let Some(stribeck) = law.stribeck {
            level = level + self.stribeck(law, stribeck);
        }
        if let Some(e) = law.position {
            level = level + wave(self.q, e.periods(), e.cosine(law.rated), e.sine(law.rated));
        }
        for &[size, exponent, half] in &law.nonlinear {
            let saturates = half > 0.0;
            let grown = if saturates { self.speed() / (self.speed() + half) } else { power(self.speed(), exponent) };
            level = level + grown * size;
        }
        let [drives, driven] = law.load.map_or([0.0; 2], |e| [e.factor(), e.driven()]);
        if [drives, driven] != [0.0; 2] {
            let mean = if drives == driven { drives } else { 0.5 * (drives + driven) };
            level = level + self.load.call(Call::Abs) * mean;
        }
        let mut friction = level * self.sign;
        if drives != driven {
            // The directions of power differ in `|load| sign(v)` times the sign of the power, which
            // is the load itself while the joint moves.
            friction = friction + self.sign.call(Call::Abs) * self.load * (0.5 * (drives - driven));
        }
        let [constant, slope] = [law.asymmetric.level(law.rated), law.asymmetric.viscous(law.rated)];
        if constant != 0.0 {
            friction = friction + self.sign.call(Call::Abs) * constant;
        }
        if slope != 0.0 {
            friction = friction + self.speed() * slope;
        }
        if let Some(e) = law.hysteresis {
            friction = friction + self.bristle * e.level(law.rated);
        }
        friction
    }

    /// Stribeck term `(FS - FC) exp(-|v / VS|^DS)`.
    fn stribeck(&self, law: &Laws, e: StribeckFriction) -> Ex<'g> {
        let above = match e.breakaway {
            Some(level) => self.number(level) - self.coulomb,
            None => self.number(StribeckFriction::EXCESS * law.rated),
        };
        above * (-power(self.speed() * (1.0 / e.velocity()), e.exponent())).call(Call::Exp)
    }
}

/// Power `x^n` of a non-negative number.
fn power(x: Ex<'_>, n: f64) -> Ex<'_> {
    match n {
        1.0 => x,
        2.0 => x * x,
        0.5 => x.call(Call::Sqrt),
        _ => (x.call(Call::Ln) * n).call(Call::Exp),
    }
}

/// Wave `cosine cos(n q) + sine sin(n q)`.
fn wave<'g>(q: Ex<'g>, n: f64, cosine: f64, sine: f64) -> Ex<'g> {
    let angle = q * n;
    angle.call(Call::Cos) * cosine + angle.call(Call::Sin) * sine
}

fn ripple<'g>(law: &Laws, q: Ex<'g>) -> Ex<'g> {
    let zero = q.graph().constant(0.0);
    law.ripple.iter().fold(zero, |sum, &[n, c, s]| sum + wave(q, n, c, s))
}

/// Sensor reading of the drive's torque.
fn measured<'g>(law: &Laws, tau: Ex<'g>) -> Ex<'g> {
    let number = |value: f64| tau.graph().constant(value);
    let clipped = law.limit.map_or(tau, |limit| tau.least(number(limit)).most(number(-limit)));
    clipped * law.gain + law.offset
}
