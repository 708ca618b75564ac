//! An arm with changeable geometry, as a diagnosis needs it.

use dh_codegen::robot::EffectKind;

use super::arm::{Arm, States};
use super::likely_bodies::PriorBody;

/// A change of an arm that none of its parameters can express.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Change {
    /// Rotation of the base by `RotY(pitch) RotX(roll)`, rad, relative to the file.
    Base {
        /// About x, rad.
        roll: f64,
        /// About y, rad.
        pitch: f64,
    },
    /// Change of a row of the DH table relative to the file.
    Row {
        /// Index of the row, from 0.
        row: usize,
        /// Added to `alpha`, rad.
        alpha: f64,
        /// Added to `d`, m.
        d: f64,
        /// Added to `theta`, rad.
        theta: f64,
        /// Added to `r`, m.
        r: f64,
    },
}

/// Where a wrench acts, and the axes of its components.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Contact {
    /// Row, from 0, whose link is touched, at its far end, on the next joint's axis. `None`:
    /// the tool, or the last frame without one, is touched at the origin of its frame.
    pub link: Option<usize>,
    /// Whether the components are along the base's axes, else along those of the touched frame.
    pub in_base: bool,
}

/// Prior bodies of an arm's links.
#[derive(Debug, Clone, PartialEq)]
pub struct LikelyBodies {
    /// One per link, without bodies that are fixed to it.
    pub prior: Vec<PriorBody>,
    /// Known bodies that are fixed to links (index from 0), in the link's frame: a tool. The
    /// standard parameters include them.
    pub carried: Vec<(usize, [f64; 10])>,
}

/// An arm with changeable geometry: what a diagnosis needs beyond [`Arm`].
pub trait PerturbableArm: Arm {
    /// Row of each joint, from 0, base to tip.
    fn rows(&self) -> &[usize];

    /// Motor turns per joint turn, if the file has them.
    fn gear_ratios(&self) -> &[Option<f64>];

    /// Values of the standard parameters in the file (`P`); `None` if it has no links.
    fn given(&self) -> Option<&[f64]>;

    /// Value of a drive parameter (index into the standard parameters) in the file, whether or not
    /// the file has links.
    fn given_drive(&self, index: usize) -> f64;

    /// Whether it has links and carries a load. Otherwise it consists of the drives of a robot
    /// alone, and torques are the losses of their gears.
    fn has_bodies(&self) -> bool {
        true
    }

    /// Largest torque of each joint, N m, if the file has it.
    fn torque_limits(&self) -> Vec<Option<f64>> {
        vec![None; self.dof()]
    }

    /// The same arm with a rotor inertia at every joint, 0 where its file has none, so that a refit
    /// can estimate it. `None` if it has all of them.
    fn with_rotors(&self) -> Option<Box<dyn PerturbableArm>> {
        None
    }

    /// Effects of the file beyond rotors, `FV`, `FC` and `FO`: kind and joint (from 0; `None` for
    /// the whole robot). Those of geometry and bodies are part of the arm itself, delays are in
    /// [`PerturbableArm::delays`], the rest in [`PerturbableArm::known`].
    fn effects(&self) -> Vec<(EffectKind, Option<usize>)> {
        Vec::new()
    }

    /// Delay of each joint's torque according to the file, s.
    fn delays(&self) -> Vec<f64> {
        vec![0.0; self.dof()]
    }

    /// Contribution of the file's effects to the recorded torques in addition to the plain arm
    /// (with the same delays), N m. Joint-major like the states, along recorded motion as in
    /// [`TorqueModel::torques_since`](super::TorqueModel::torques_since). Returns `false` if there
    /// is none, with `out` unchanged.
    fn known(&self, _begun: f64, _time: &[f64], _states: &States, _temperature: &[f64], _out: &mut [f64]) -> bool {
        false
    }

    /// Adds the file's laws of the transmitted torque where that is measured. `load`: N m,
    /// joint-major like the states, or empty. Returns whether there are such laws.
    fn add_laws_of_load(&self, _states: &States, _load: &[f64], _out: &mut [f64]) -> bool {
        false
    }

    /// Travel of each joint, rad or m, after which the initial state of the file's friction with
    /// memory has no effect.
    fn settling(&self) -> Vec<f64> {
        vec![0.0; self.dof()]
    }

    /// Prior bodies of the links; `None` without any knowledge of their size.
    fn bodies(&self) -> Option<LikelyBodies> {
        None
    }

    /// The same arm without some of its file's [`PerturbableArm::effects`].
    fn without(&self, _effects: &[(EffectKind, Option<usize>)]) -> Option<Box<dyn PerturbableArm>> {
        None
    }

    /// [`Arm::inverse_dynamics`] of the arm with a change: torques, N m (N for a prismatic joint),
    /// of all joints, joint-major like the states. The standard parameters (`P`, SI) are given in
    /// the frames of the unchanged arm.
    fn changed_dynamics(&self, change: &Change, states: &States, standard: &[f64], out: &mut [f64]);

    /// `J'`: the torque on joint `j` per unit of component `c` of a wrench at sample `s` goes to
    /// `out[(c * n + j) * len + s]`. Components are `fx fy fz mx my mz`, at the point of contact.
    fn wrench_columns(&self, states: &States, contact: Contact, out: &mut [f64]);

    /// Position of that origin, axes of the base, m: component `c` at sample `s` goes to
    /// `out[c * len + s]`.
    fn tool_positions(&self, states: &States, out: &mut [f64]);
}
