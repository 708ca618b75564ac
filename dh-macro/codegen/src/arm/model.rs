//! Model of a robot: base parameters, the plan with the fewest operations, and any kernel on
//! demand.

use super::base::BaseParameters;
use super::chain::{Chain, Links};
use super::dynamics::{self, Values};
use super::kernel::{Function, Kernel};
use super::motion::{Include, can_shift};
use super::param::{DriveTerm, Parameter, standard};
use super::plan::{self, Plan};
use super::regressor::Columns;
use super::{adjoint, drive, energy, kinematics};
use crate::robot::{Laws, Robot};
use crate::sym::{Ex, Graph, Tape};

/// Everything from which kernels are built.
pub struct Model {
    chain: Chain,
    standard: Vec<Parameter>,
    base: BaseParameters,
    plan: Plan,
    laws: Vec<Laws>,
}

impl Model {
    /// Model of the arm by the rows, links and plain drives of its file, without effects. Groups
    /// the parameters and searches the plan.
    pub fn new(robot: &Robot) -> Self {
        Self::of(robot, Vec::new())
    }

    /// Model of the arm with all effects of its file: zeros, rows and base are the effective ones,
    /// and [`Function::InverseDynamics`] includes the laws of the drives. Without effects identical
    /// to [`Model::new`].
    pub fn with_effects(robot: &Robot) -> Self {
        if robot.has_effects() { Self::of(&robot.effective(), robot.laws()) } else { Self::new(robot) }
    }

    fn of(robot: &Robot, laws: Vec<Laws>) -> Self {
        let chain = Chain::new(robot);
        let standard = standard(robot);
        let base = BaseParameters::new(robot);
        let leaders: Vec<Parameter> = base.0.iter().map(|b| b.leader).collect();
        let cost = |plan: &Plan| {
            let graph = Graph::new();
            Tape::estimate(&graph, &regressor(&chain.over(&graph), &leaders, plan, Include::ALL))
        };
        let plan = plan::search(plan::plain(chain.rows.len()), plan::ROUNDS, |row| can_shift(&chain.rows[row]), cost);
        Self { chain, standard, base, plan, laws }
    }

    /// Number of degrees of freedom.
    pub fn dof(&self) -> usize {
        self.chain.dof()
    }

    /// Chain of joint frames.
    pub fn chain(&self) -> &Chain {
        &self.chain
    }

    /// Standard parameters, in the order of the regressor's columns.
    pub fn standard(&self) -> &[Parameter] {
        &self.standard
    }

    /// Base parameters, in the order of the base regressor's columns.
    pub fn base(&self) -> &BaseParameters {
        &self.base
    }

    /// Effects of each drive; empty if the file has none, or they were left out.
    pub fn laws(&self) -> &[Laws] {
        &self.laws
    }

    /// Whether a drive's law depends on time or temperature, so that
    /// [`Function::ClockedDriveTorques`] exists.
    pub fn reads_clock(&self) -> bool {
        self.laws.iter().any(Laws::reads_clock)
    }

    /// Offsets included in the gravity torque from base parameters: degree of freedom, and torque,
    /// N m. A prismatic joint's weight, rotor and offset can't be separated, so `FO` is grouped
    /// there (see [`BaseParameters`]).
    pub fn offsets_in_gravity(&self, standard: &[f64]) -> Vec<(usize, f64)> {
        let grouped = |p: &Parameter| self.base.0.iter().all(|b| b.leader != *p);
        let offset = |(p, &value): (&Parameter, &f64)| match *p {
            Parameter::Drive(row, DriveTerm::FO) if grouped(p) => self.chain.rows[row].dof.map(|k| (k, value)),
            _ => None,
        };
        self.standard.iter().zip(standard).filter_map(offset).collect()
    }

    /// Torques from these parameters, with the last link taken about the origin that needs fewer
    /// operations.
    fn torques<'g>(&self, links: &Links<'g>, from: &[Parameter], include: Include, drives: bool) -> Vec<Ex<'g>> {
        let cost = |slide: bool| {
            let graph = Graph::new();
            let links = self.chain.over(&graph);
            Tape::estimate(&graph, &dynamics::torques(&links, &Values::new(&links, from), include, false, slide))
        };
        let slide = self.chain.rows.last().is_some_and(can_shift) && cost(true) < cost(false);
        dynamics::torques(links, &Values::new(links, from), include, drives, slide)
    }

    /// Torques at the sensors for given states of the drives.
    fn driven<'g>(&self, graph: &'g Graph, memory: drive::Memory) -> Vec<Ex<'g>> {
        let mut laws = self.laws.clone();
        laws.resize_with(self.dof(), || Laws::none(crate::robot::RATED));
        drive::torques(&self.chain, graph, &self.standard, &laws, memory)
    }

    /// Plan for the columns of parameters other than the base ones.
    fn plan_for(&self, parameters: &[Parameter], include: Include) -> Plan {
        let cost = |plan: &Plan| {
            let graph = Graph::new();
            Tape::estimate(&graph, &regressor(&self.chain.over(&graph), parameters, plan, include))
        };
        let own = plan::search(plan::plain(self.chain.rows.len()), 1, |row| can_shift(&self.chain.rows[row]), cost);
        if cost(&own) < cost(&self.plan) { own } else { self.plan.clone() }
    }

    /// Builds the tape of a function.
    pub fn kernel(&self, function: Function) -> Kernel {
        let n = self.dof();
        let graph = Graph::new();
        let links = self.chain.over(&graph);
        let leaders: Vec<Parameter> = self.base.0.iter().map(|b| b.leader).collect();
        let make = |shape: Vec<usize>, roots: Vec<Ex<'_>>| Kernel::new(function, links.inputs, shape, &roots);
        let base_values = || Values::new(&links, &leaders);
        match function {
            Function::Frames => {
                let poses = kinematics::frames(&links);
                make(vec![poses.len(), 3, 4], poses.iter().flat_map(|p| p.entries()).collect())
            }
            Function::ForwardKinematics => {
                make(vec![3, 4], kinematics::frames(&links).last().map(|p| p.entries()).unwrap_or_default())
            }
            Function::ToolPose => make(vec![3, 4], kinematics::tool(&links).map(|p| p.entries()).unwrap_or_default()),
            Function::Jacobian => make(vec![6, n], kinematics::jacobian(&links)),
            Function::ToolJacobian => make(vec![6, n], kinematics::tool_jacobian(&links)),
            Function::JacobianDotVelocity => make(vec![6], kinematics::jacobian_dot_velocity(&links)),
            Function::InverseDynamics if !self.laws.is_empty() => {
                make(vec![n], drive::torques(&self.chain, &graph, &self.standard, &self.laws, drive::Memory::Steady))
            }
            Function::DriveTorques => make(vec![n], self.driven(&graph, drive::Memory::Given)),
            Function::ClockedDriveTorques => make(vec![n], self.driven(&graph, drive::Memory::Clocked)),
            Function::InverseDynamics | Function::RigidDynamics => {
                make(vec![n], self.torques(&links, &self.standard, Include::ALL, true))
            }
            Function::InverseDynamicsBase => make(vec![n], self.torques(&links, &leaders, Include::ALL, true)),
            Function::Coriolis => make(vec![n], self.torques(&links, &leaders, Include::VELOCITY, false)),
            Function::Gravity => make(vec![n], self.torques(&links, &leaders, Include::GRAVITY, false)),
            Function::MassMatrix => {
                let upper = dynamics::mass_matrix(&links, &base_values());
                let full = (0..n).flat_map(|i| (0..n).map(move |j| (i.min(j), i.max(j))));
                make(vec![n, n], full.map(|(i, j)| upper[i][j]).collect())
            }
            Function::ForwardDynamics => {
                let mass = dynamics::mass_matrix(&links, &base_values());
                let bias = self.torques(&links, &leaders, Include::BIAS, true);
                let right: Vec<Ex<'_>> =
                    bias.iter().enumerate().map(|(k, &b)| links.input(super::chain::Group::Torque, k) - b).collect();
                make(vec![n], dynamics::solve(&links, &mass, &right))
            }
            Function::Regressor => {
                let all = &self.standard;
                make(vec![n, all.len()], regressor(&links, all, &self.plan_for(all, Include::ALL), Include::ALL))
            }
            Function::BaseRegressor => {
                make(vec![n, leaders.len()], regressor(&links, &leaders, &self.plan, Include::ALL))
            }
            Function::GravityRegressor => {
                let links_only: Vec<Parameter> =
                    self.standard.iter().copied().filter(|p| matches!(p, Parameter::Link(..))).collect();
                make(vec![n, links_only.len()], regressor(&links, &links_only, &self.plan, Include::GRAVITY))
            }
            Function::KineticEnergyRegressor => {
                make(vec![self.standard.len()], energy::kinetic(&links, &self.standard))
            }
            Function::PotentialEnergyRegressor => {
                make(vec![self.standard.len()], energy::potential(&links, &self.standard))
            }
            Function::PayloadRegressor => {
                let columns = Columns::new(&links, &self.plan, Include::ALL);
                make(vec![n, 10], by_rows(n, &columns.payload()))
            }
            Function::BaseRegressorAdjoint => adjoint::kernel(&self.kernel(Function::BaseRegressor), function, 0),
            Function::PayloadRegressorAdjoint => adjoint::kernel(&self.kernel(Function::PayloadRegressor), function, 0),
            Function::InverseDynamicsAdjoint => {
                adjoint::kernel(&self.kernel(Function::InverseDynamics), function, self.standard.len())
            }
            Function::FramesAdjoint => adjoint::kernel(&self.kernel(Function::Frames), function, 0),
            Function::ToolPoseAdjoint => adjoint::kernel(&self.kernel(Function::ToolPose), function, 0),
        }
    }
}

/// Regressor of these parameters for a plan, row-major.
fn regressor<'g>(links: &Links<'g>, parameters: &[Parameter], plan: &Plan, include: Include) -> Vec<Ex<'g>> {
    let columns = Columns::new(links, plan, include);
    let all: Vec<Vec<Ex<'g>>> = parameters.iter().map(|p| columns.column(*p)).collect();
    by_rows(links.inputs.dof, &all)
}

/// Converts columns to row-major entries.
fn by_rows<'g>(n: usize, columns: &[Vec<Ex<'g>>]) -> Vec<Ex<'g>> {
    (0..n).flat_map(|i| columns.iter().map(move |c| c[i])).collect()
}
