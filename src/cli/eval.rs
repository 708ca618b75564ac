//! `denavit eval`: a quantity at each state of a CSV file.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use dh_codegen::arm::{Argument, Function, param};

use super::{Failure, files};
use crate::arm::{Arm, States};
use crate::interpreted::Interpreted;
use crate::report::eval_json;

/// Evaluate a quantity of the robot at each row of a CSV file.
///
/// The states have columns `q1.., dq1.., ddq1..` (and `tau1..` for forward_dynamics); those that the quantity does not need may be
/// left out. Joints count from 1 and leave out fixed rows. Torques include the friction and the tool of the robot file.
#[derive(Args)]
#[command(
    after_help = "Example:\n  denavit eval robots/kuka-lwr4.yaml --quantity jacobian --states states.csv --json -"
)]
pub(super) struct Eval {
    /// Robot file.
    robot: PathBuf,
    /// What to evaluate.
    #[arg(long, value_enum)]
    quantity: Quantity,
    /// States, CSV with a header.
    #[arg(long, value_name = "CSV")]
    states: PathBuf,
    /// Where the result goes as JSON; `-` for standard output.
    #[arg(long, value_name = "FILE", default_value = "-")]
    json: PathBuf,
}

#[derive(Clone, Copy, ValueEnum)]
#[value(rename_all = "snake_case")]
enum Quantity {
    /// 4x4 homogeneous matrix of the last DH frame.
    ForwardKinematics,
    /// 6xn, linear part first, of the last frame's origin in base axes.
    Jacobian,
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
    pub(super) fn run(self) -> Result<(), Failure> {
        let file = files::robot(&self.robot)?;
        let function = self.quantity.function();
        let arm = Interpreted::new(&file.robot, &[function]);
        let table = Table::read(&self.states)?;
        let arguments = function.arguments();
        let n = arm.dof();
        let column = |prefix: &str, argument: Argument| -> Result<Vec<f64>, Failure> {
            if arguments.contains(&argument) {
                table.joints(prefix, n)
            } else {
                Ok(table.joints(prefix, n).unwrap_or_else(|_| vec![0.0; n * table.len]))
            }
        };
        let states = States {
            len: table.len,
            q: column("q", Argument::Configuration)?,
            dq: column("dq", Argument::Velocities)?,
            ddq: column("ddq", Argument::Accelerations)?,
        };
        let tau = if arguments.contains(&Argument::Torques) { table.joints("tau", n)? } else { Vec::new() };
        let wants = |a| arguments.contains(&a);
        let parameters = if wants(Argument::StandardParameters) || wants(Argument::BaseParameters) {
            let standard = param::standard_values(&file.robot).ok_or_else(|| {
                Failure::input(format!(
                    "{}: {} needs the inertial parameters of every link; add a `links:` list with one entry per joint, or identify them (`denavit identify`)",
                    self.robot.display(),
                    function.name()
                ))
            })?;
            if wants(Argument::BaseParameters) { arm.model().base().values(&standard) } else { standard }
        } else {
            Vec::new()
        };
        let values = arm.evaluate(function, &states, &tau, &parameters);
        let shape = arm.shape(function);
        let value = eval_json::value(function.name(), &arm, &shape, values);
        files::json(&self.json, &value)
    }
}

/// Numbers with a header.
struct Table {
    file: String,
    header: Vec<String>,
    columns: Vec<Vec<f64>>,
    len: usize,
}

impl Table {
    fn read(path: &std::path::Path) -> Result<Self, Failure> {
        let file = path.display().to_string();
        let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(files::open(path)?);
        let bad = |e: csv::Error| Failure::input(format!("{file}: {e}"));
        let header: Vec<String> = reader.headers().map_err(bad)?.iter().map(str::to_string).collect();
        let mut columns = vec![Vec::new(); header.len()];
        let mut len = 0;
        for row in reader.records() {
            let row = row.map_err(bad)?;
            let line = row.position().map_or(0, csv::Position::line);
            for ((cell, name), column) in row.iter().zip(&header).zip(&mut columns) {
                let value: f64 = cell.parse().ok().filter(|v: &f64| v.is_finite()).ok_or_else(|| {
                    Failure::input(format!("{file}: line {line}, column {name}: `{cell}` is not a finite number"))
                })?;
                column.push(value);
            }
            len += 1;
        }
        Ok(Self { file, header, columns, len })
    }

    /// Columns `prefix1..prefixn`, joint-major.
    fn joints(&self, prefix: &str, n: usize) -> Result<Vec<f64>, Failure> {
        let mut all = Vec::with_capacity(n * self.len);
        for j in 1..=n {
            let name = format!("{prefix}{j}");
            let at = self.header.iter().position(|h| *h == name).ok_or_else(|| {
                Failure::input(format!(
                    "{}: there is no column {name}; the robot has {n} joints, so {prefix}1 to {prefix}{n} are needed",
                    self.file
                ))
            })?;
            all.extend_from_slice(&self.columns[at]);
        }
        Ok(all)
    }
}
