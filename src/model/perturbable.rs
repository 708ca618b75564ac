//! An arm whose geometry can be changed: the requirements of a diagnosis.

use dh_codegen::robot::EffectKind;

use super::arm::{Arm, States};
use super::likely_bodies::PriorBody;

/// A change of an arm that none of its parameters can express.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Change {
    /// The base is turned by `RotY(pitch) RotX(roll)`, rad, against where its file says it stands.
    Base {
        /// About x, rad.
        roll: f64,
        /// About y, rad.
        pitch: f64,
    },
    /// A row of the DH table is longer or more twisted than its file says.
    Row {
        /// Number of the row, from 0.
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

/// Bodies that an arm's links are likely to have.
#[derive(Debug, Clone, PartialEq)]
pub struct LikelyBodies {
    /// One per link, without what is fixed to it.
    pub prior: Vec<PriorBody>,
    /// Known bodies that are fixed to links (from 0), in the link's frame: a tool. The standard
    /// parameters contain them.
    pub carried: Vec<(usize, [f64; 10])>,
}

/// An arm whose geometry can be questioned: what a diagnosis needs beyond [`Arm`].
pub trait PerturbableArm: Arm {
    /// Row of each joint, from 0, base to tip.
    fn rows(&self) -> &[usize];

    /// Motor turns per joint turn, if the file has them.
    fn gear_ratios(&self) -> &[Option<f64>];

    /// Values of the standard parameters in the file (`P`); `None` where it has no links.
    fn given(&self) -> Option<&[f64]>;

    /// Value of a drive parameter (index into the standard parameters) in the file, whether or not
    /// it has links.
    fn given_drive(&self, index: usize) -> f64;

    /// Whether it has links and carries anything; else it is the drives of a robot alone, and torques
    /// are what their gears take.
    fn has_bodies(&self) -> bool {
        true
    }

    /// Largest torque of each joint, N m, if the file has it.
    fn torque_limits(&self) -> Vec<Option<f64>> {
        vec![None; self.dof()]
    }

    /// The same arm with a rotor inertia at every joint, 0 where its file has none: what a refit
    /// looks for. `None`: it has them all.
    fn with_rotors(&self) -> Option<Box<dyn PerturbableArm>> {
        None
    }

    /// Effects of the file beyond rotors, `FV`, `FC` and `FO`: name and joint (from 0; `None`: the
    /// whole robot). Those of geometry and bodies are in the arm itself, delays in
    /// [`PerturbableArm::delays`], the rest in [`PerturbableArm::known`].
    fn effects(&self) -> Vec<(EffectKind, Option<usize>)> {
        Vec::new()
    }

    /// How late the file says each joint's torque is, s.
    fn delays(&self) -> Vec<f64> {
        vec![0.0; self.dof()]
    }

    /// Contribution of the file's effects to the recorded torques beside the plain arm (which is as
    /// late), N m, joint-major like the states, along recorded motion as in
    /// [`TorqueModel::torques_since`](super::TorqueModel::torques_since). `false`: none, and `out`
    /// is unchanged.
    fn known(&self, _begun: f64, _time: &[f64], _states: &States, _temperature: &[f64], _out: &mut [f64]) -> bool {
        false
    }

    /// Adds the file's laws of the transmitted torque, where that is measured: `load`, N m, joint-major
    /// like the states, or empty. Whether there are such.
    fn add_laws_of_load(&self, _states: &States, _load: &[f64], _out: &mut [f64]) -> bool {
        false
    }

    /// By how much each joint has to travel, rad or m, until it does not matter in which state the
    /// file's friction with memory began.
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

    /// [`Arm::inverse_dynamics`] of the arm with a change. It gives torques, N m (N for a prismatic
    /// joint), of all joints, joint-major like the states, from the standard parameters (`P`, SI)
    /// of the unchanged arm's frames.
    fn changed_dynamics(&self, change: &Change, states: &States, standard: &[f64], out: &mut [f64]);

    /// `J'`: the torque on joint `j` of a unit of component `c` of a wrench on the tool at sample
    /// `s` goes to `out[(c * n + j) * len + s]`. Components are `fx fy fz mx my mz`, at the origin
    /// of the tool's frame (of the last frame without a tool), in its axes or in the base's.
    fn wrench_columns(&self, states: &States, base: bool, out: &mut [f64]);

    /// Position of that origin, axes of the base, m: component `c` at sample `s` goes to
    /// `out[c * len + s]`.
    fn tool_positions(&self, states: &States, out: &mut [f64]);
}
