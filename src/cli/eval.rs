//! `denavit eval`: evaluates a quantity at each state of a CSV file.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use dh_codegen::arm::{Argument, Function, param};
use dh_codegen::robot::Robot;

use super::Failure;
use super::delivery::deliver;
use super::files;
use super::motors;
use super::provenance::Provenance;
use super::table::Table;
use crate::model::file_torque_model::FileTorqueModel;
use crate::model::interpreted::Interpreted;
use crate::model::{Arm, States, TorqueModel};
use crate::report;

/// Evaluate a quantity of the robot at each row of a CSV file.
///
/// The states have columns `q1.., dq1.., ddq1..` (and `tau1..` for forward_dynamics); those that
/// the quantity does not need may be left out. Joints count from 1 and leave out fixed rows.
/// Torques include the friction and the tool of the robot file.
///
/// Effects of the file (`drive`, `effects`) are in everything. The arm's geometry and bodies are
/// the true ones, and inverse_dynamics gives the readings of the torque sensors, bit for bit like
/// the generated code. Without a column `t` each row stands for itself: friction with memory has
/// slipped, gears are warm, nothing is late. With a column `t` (s) the rows are a recording:
/// bristles bend, gears warm (`temp1..` is read where it is there), and torques are late by
/// time_delay.
///
/// States are spread over all cores; the result does not depend on their number.
#[derive(Args)]
#[command(
    after_help = "Example:\n  denavit eval robots/kuka-lwr4.yaml --quantity jacobian --states states.csv --json -"
)]
pub(super) struct Eval {
    /// Robot file.
    robot: PathBuf,
    /// Quantity to evaluate.
    #[arg(long, value_enum)]
    quantity: Quantity,
    /// States, CSV with a header.
    #[arg(long, value_name = "CSV")]
    states: PathBuf,
    /// Write the result as JSON; `-` for standard output.
    #[arg(long, value_name = "FILE", default_value = "-")]
    json: PathBuf,
}

#[derive(Clone, Copy, ValueEnum)]
#[value(rename_all = "snake_case")]
enum Quantity {
    /// 4x4 homogeneous matrix of the last DH frame.
    ForwardKinematics,
    /// 6xn, linear part first, of the last frame's origin in world axes.
    Jacobian,
    /// 4x4 homogeneous matrix of the tool frame.
    ToolPose,
    /// 6xn, linear part first, of the tool frame's origin in world axes.
    ToolJacobian,
    /// Of the standard parameters, n x P.
    Regressor,
    /// Of the base parameters, n x B.
    BaseRegressor,
    /// Torques.
    InverseDynamics,
    /// n x n.
    MassMatrix,
    /// Coriolis and centrifugal torques.
    Coriolis,
    /// Gravity torques.
    Gravity,
    /// Accelerations that `tau` causes.
    ForwardDynamics,
}

impl Quantity {
    fn function(self) -> Function {
        match self {
            Self::ForwardKinematics => Function::ForwardKinematics,
            Self::Jacobian => Function::Jacobian,
            Self::ToolPose => Function::ToolPose,
            Self::ToolJacobian => Function::ToolJacobian,
            Self::Regressor => Function::Regressor,
            Self::BaseRegressor => Function::BaseRegressor,
            Self::InverseDynamics => Function::InverseDynamics,
            Self::MassMatrix => Function::MassMatrix,
            Self::Coriolis => Function::Coriolis,
            Self::Gravity => Function::Gravity,
            Self::ForwardDynamics => Function::ForwardDynamics,
        }
    }
}

impl Eval {
    pub(super) fn run(self, provenance: Provenance) -> Result<(), Failure> {
        let file = files::robot(&self.robot)?;
        files::check_outputs(&[("--json", &Some(self.json.clone()))], file.read.iter().chain([&self.states]))?;
        let function = self.quantity.function();
        let arm = Interpreted::with_effects(&file.robot, &[function]);
        let table = Table::read(&self.states)?;
        if table.len == 0 {
            let file = &table.file;
            return Err(Failure::input(format!("{file} has a header and no rows; write one row of numbers per state")));
        }
        let arguments = function.arguments();
        let n = arm.dof();
        let wants = |a| arguments.contains(&a);
        let column = |prefix: &str, argument: Argument| -> Result<Vec<f64>, Failure> {
            if wants(argument) { table.joints(prefix, n) } else { Ok(vec![0.0; n * table.len]) }
        };
        let states = States {
            len: table.len,
            q: column("q", Argument::Configuration)?,
            dq: column("dq", Argument::Velocities)?,
            ddq: column("ddq", Argument::Accelerations)?,
        };
        let tau = if wants(Argument::Torques) { table.joints("tau", n)? } else { Vec::new() };
        motors::no_torque_without_motor(&self.states, &file.robot, &tau, table.len)?;
        if matches!(function, Function::InverseDynamics | Function::Gravity | Function::Coriolis) {
            motors::note(&self.robot, &file.robot);
        }
        let standard = if wants(Argument::StandardParameters) || wants(Argument::BaseParameters) {
            param::standard_values(&file.robot.effective()).ok_or_else(|| {
                Failure::input(format!(
                    "{}: {} needs the inertial parameters of every link; add a `links:` list with one entry per joint, or identify them (`denavit identify`)",
                    self.robot.display(),
                    function.name()
                ))
            })?
        } else {
            Vec::new()
        };
        let values = if function == Function::InverseDynamics && file.robot.has_effects() && table.has("t") {
            along(&file.robot, &table, &states)?
        } else {
            arm.evaluate(function, &states, &tau, &standard)
        };
        let shape = arm.shape(function);
        deliver(&provenance.robot(&self.robot, &file))
            .json(Some(&self.json), || report::eval_json(function.name(), &arm, &shape, values))?
            .only_text(String::new)
    }
}

/// Sensor torques along the motion of a log, with drives with memory and delayed torques.
fn along(robot: &Robot, table: &Table, states: &States) -> Result<Vec<Vec<f64>>, Failure> {
    let predictor = FileTorqueModel::new(robot).map_err(Failure::input)?;
    let (n, len) = (predictor.dof(), states.len);
    let temperature = if table.count("temp") >= n { table.joints("temp", n)? } else { Vec::new() };
    let mut out = vec![0.0; n * len];
    predictor.torques_along(table.column("t")?, states, &temperature, &mut out);
    Ok((0..len).map(|s| (0..n).map(|k| out[k * len + s]).collect()).collect())
}
