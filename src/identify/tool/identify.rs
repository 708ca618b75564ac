//! Identifies the ten parameters of the carried body: the paper's equation (7), solved from the
//! factors of the logs.
//!
//! Solves `[tau_u; tau_l] = [W_b 0; W_b W_L] [Phi_b; Phi_L]`, each joint weighted by its own noise,
//! as in [`crate::identify`]. If the robot was identified before, `Phi_b` is known and `tau_l - W_b
//! Phi_b = W_L Phi_L` is solved from the loaded logs alone.

use super::body::{Body, moving};
use super::carrying::Carrying;
use super::robot_errors;
use crate::identify::{
    Accuracy, Factors, Identification, IdentifyError, IdentifySettings, Known, Noise, Standing, accuracy, solve,
};
use crate::model::Payload;

/// Settings of the tool identification.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ToolSettings {
    /// Standard parameters of the robot without the tool (`P`). Without an unloaded log they are
    /// taken as known, otherwise they only supply values that the logs do not determine.
    pub robot: Option<Vec<f64>>,
    /// Mass from a scale, kg.
    pub known_mass: Option<f64>,
    /// Standard deviation of the scale reading, kg; zero: exact.
    pub mass_std: f64,
    /// Whether, without an unloaded log, friction and offsets (`FV FC FO`), which change from day
    /// to day, are estimated from the loaded log. Then only links and rotors are taken as known.
    pub refresh_friction: bool,
    /// Covariance of the robot's base parameters, row-major `B * B`, as identified; zero for exact
    /// ones. Without an unloaded log it is propagated to the ten parameters. `None`: all are taken
    /// as exact.
    pub robot_covariance: Option<Vec<f64>>,
}

impl ToolSettings {
    fn check(&self, arm: &dyn Payload) -> Result<(), ToolError> {
        if let Some(mass) = self.known_mass.filter(|m| !(m.is_finite() && *m > 0.0)) {
            return Err(ToolError::Mass(mass));
        }
        let std = self.mass_std;
        if !(std.is_finite() && std >= 0.0) || (std > 0.0 && self.known_mass.is_none()) {
            return Err(ToolError::MassStd(std));
        }
        let base = arm.base_parameters().len();
        let robot =
            self.robot.as_ref().map(|v| ("standard parameters given", v.len(), arm.standard_parameters().len()));
        let covariance = self.robot_covariance.as_ref();
        let covariance = covariance.map(|v| ("entries of the robot's covariance", v.len(), base * base));
        match robot.into_iter().chain(covariance).find(|(_, found, expected)| found != expected) {
            Some((what, found, expected)) => Err(IdentifyError::Mismatch { what: what.into(), found, expected }.into()),
            None => Ok(()),
        }
    }
}

/// Contribution of the robot's own errors to the standard deviations.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RobotErrors {
    /// All errors, since the robot was identified from the same logs.
    Identified,
    /// Errors of a previous identification, whose covariance was propagated.
    Counted,
    /// No errors: the robot's parameters were taken as exact.
    NotCounted,
}

/// Reason why no tool could be identified.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ToolError {
    /// The logs can't be used.
    #[error(transparent)]
    Identify(#[from] IdentifyError),
    /// There is neither an unloaded log nor a robot with parameters.
    #[error(
        "without an unloaded log the robot's own parameters are required, and its file does not have them; record the same motion with an empty hand and give it as --unloaded, or identify the robot first"
    )]
    UnknownRobot,
    /// There is no loaded log.
    #[error("there is no loaded log")]
    NoLoad,
    /// The known mass is not positive.
    #[error("the known mass is {0} kg; give a positive number")]
    Mass(f64),
    /// The standard deviation of the known mass is invalid.
    #[error("the standard deviation of the known mass is {0} kg; give zero or more, and --known-mass with it")]
    MassStd(f64),
    /// The scale is not exact, and can only be combined with a mass that the logs determine.
    #[error(
        "the logs don't determine the mass, so that of the scale can't be combined with theirs; leave --mass-std out to use it as exact"
    )]
    MassUnidentified,
    /// The data have no information on the tool.
    #[error(
        "the loaded log has no information on the body that the arm carries: none of its ten parameters is determined; record a motion that moves the wrist"
    )]
    NothingTold,
}

/// Torque errors of one log.
#[derive(Debug, Clone, PartialEq)]
pub struct LogError {
    /// Name of the log.
    pub name: String,
    /// Whether the tool was carried.
    pub loaded: bool,
    /// Seconds of motion.
    pub seconds: f64,
    /// Errors of robot and tool.
    pub with_tool: Accuracy,
    /// Errors of the robot alone (equal to `with_tool` for an unloaded log).
    pub robot_alone: Accuracy,
}

/// Carried body, in the arm's last DH frame about its origin (in the tool frame if `arm` has a
/// tool).
#[derive(Debug, Clone, PartialEq)]
pub struct Carried {
    /// Name of the robot.
    pub robot: String,
    /// Parameters `M MSX MSY MSZ XX YY ZZ XY XZ YZ`, kg, kg m, kg m^2.
    pub values: [f64; 10],
    /// Standard deviations; infinite if undetermined; zero for a known mass.
    pub std: [f64; 10],
    /// Covariance, row-major `10 * 10`; zero in rows and columns of undetermined parameters.
    pub covariance: Vec<f64>,
    /// Status of each parameter.
    pub standing: [Standing; 10],
    /// Given mass, kg.
    pub known_mass: Option<f64>,
    /// Standard deviation of the given mass, kg; zero: taken as exact.
    pub mass_std: f64,
    /// Mass from the logs alone if one was given, and its standard deviation, kg; `None` if the
    /// logs do not determine it.
    pub mass_of_logs: Option<[f64; 2]>,
    /// Contribution of the robot's own errors to the standard deviations.
    pub robot_errors: RobotErrors,
    /// Mass, centre, principal axes; `None` if the data do not determine the mass or the first
    /// moments.
    pub body: Option<Body>,
    /// Degrees of freedom of the noise: independent samples over all joints minus the number of
    /// unknowns.
    pub freedom: f64,
    /// Errors on each log.
    pub logs: Vec<LogError>,
    /// Noise of the joints.
    pub noise: Noise,
    /// All base parameters of [`Carrying`]: those of the robot and the ten.
    pub beta: Vec<f64>,
    /// Identification of all unknowns.
    pub solved: Identification,
}

impl Carried {
    /// Relative standard deviation `100 std / |value|` of each parameter.
    pub fn relative_std_percent(&self) -> [f64; 10] {
        std::array::from_fn(|k| match (self.std[k], self.values[k]) {
            (0.0, _) => 0.0,
            (std, value) => 100.0 * std / value.abs(),
        })
    }

    /// Whether each of the ten parameters is determined (a known mass is).
    pub fn determined(&self) -> [bool; 10] {
        self.standing.map(|s| s == Standing::Identified)
    }

    /// Values and standard deviations of the body in another frame; `rotation` (row-major) and
    /// `origin` (m) are those of the last frame in it. `None` if a parameter is undetermined.
    pub fn moved(&self, rotation: &[[f64; 3]; 3], origin: &[f64; 3]) -> Option<([f64; 10], [f64; 10])> {
        if !self.determined().iter().all(|t| *t) {
            return None;
        }
        let turn = moving(rotation, origin);
        let values = turn * nalgebra::SVector::from(self.values);
        let covariance = turn * nalgebra::SMatrix::<f64, 10, 10>::from_row_slice(&self.covariance) * turn.transpose();
        Some((values.into(), std::array::from_fn(|k| covariance[(k, k)].max(0.0).sqrt())))
    }
}

/// Identifies the carried body. `unloaded` and `loaded` are factors of [`Carrying`] arms (unloaded
/// or loaded) over `arm`.
pub fn identify_tool(
    arm: &dyn Payload,
    unloaded: &[Factors],
    loaded: &[Factors],
    settings: &ToolSettings,
) -> Result<Carried, ToolError> {
    if loaded.is_empty() {
        return Err(ToolError::NoLoad);
    }
    settings.check(arm)?;
    // An exact mass is no unknown; a scale reading with a standard deviation is combined with the
    // logs' mass below.
    let exact = settings.known_mass.filter(|_| settings.mass_std == 0.0);
    let whole = Carrying::new(arm, true);
    let first = whole.first();
    let standard = settings.robot.as_ref();
    let covariance = settings.robot_covariance.as_ref().filter(|_| unloaded.is_empty());
    let robot_errors = match (unloaded.is_empty(), covariance) {
        (false, _) => RobotErrors::Identified,
        (true, Some(_)) => RobotErrors::Counted,
        (true, None) => RobotErrors::NotCounted,
    };
    let mut known: Vec<Option<f64>> = vec![None; first + 10];
    known[first] = exact;
    if unloaded.is_empty() {
        let robot = standard.ok_or(ToolError::UnknownRobot)?;
        for (slot, base) in known.iter_mut().zip(arm.base_parameters()) {
            if !(settings.refresh_friction && base.leader.is_friction()) {
                *slot = Some(base.coefficients.iter().map(|&(i, k)| k * robot[i]).sum());
            }
        }
    }
    let unknown = Known::new(&whole, &known);
    let factors: Vec<Factors> = unloaded.iter().chain(loaded).map(|log| unknown.factors(log)).collect();
    let solving = IdentifySettings {
        prior: standard.map(|robot| robot.iter().copied().chain([0.0; 10]).collect()),
        ..IdentifySettings::default()
    };
    let widened = |solved: &mut Identification, known: &[Option<f64>]| {
        let unknown: Vec<bool> = known.iter().map(Option::is_none).collect();
        covariance.iter().for_each(|c| robot_errors::add(solved, loaded, &unknown, c));
    };
    let mut solved = solve(&unknown, &factors, &[], &solving)?;
    widened(&mut solved, &known);
    let mass_of_logs = match (settings.known_mass, exact) {
        (None, _) => None,
        (Some(_), None) => mass_of(&solved),
        // Without the scale reading.
        (Some(_), Some(_)) => {
            known[first] = None;
            let free = Known::new(&whole, &known);
            let factors: Vec<Factors> = unloaded.iter().chain(loaded).map(|log| free.factors(log)).collect();
            solve(&free, &factors, &[], &solving).ok().and_then(|mut solved| {
                widened(&mut solved, &known);
                mass_of(&solved)
            })
        }
    };
    if let (Some(mass), None) = (settings.known_mass, exact) {
        add_scale_reading(&mut solved, mass, settings.mass_std)?;
    }
    let beta = unknown.whole(&solved.values());

    // Positions of the ten among the unknowns, in order; a known mass is not among them.
    let count = solved.parameters.len();
    let ten: Vec<Option<usize>> = match exact {
        Some(_) => std::iter::once(None).chain((count - 9..count).map(Some)).collect(),
        None => (count - 10..count).map(Some).collect(),
    };
    let values: [f64; 10] = std::array::from_fn(|k| beta[first + k]);
    let standing: [Standing; 10] =
        std::array::from_fn(|k| ten[k].map_or(Standing::Identified, |i| solved.parameters[i].standing));
    let std: [f64; 10] = std::array::from_fn(|k| ten[k].map_or(0.0, |i| solved.parameters[i].std));
    let determined = standing.map(|s| s == Standing::Identified);
    if !determined.iter().zip(&ten).any(|(determined, place)| *determined && place.is_some()) {
        return Err(ToolError::NothingTold);
    }
    let mut covariance = vec![0.0; 100];
    for i in 0..10 {
        for k in 0..10 {
            if let (Some(a), Some(b), true, true) = (ten[i], ten[k], determined[i], determined[k]) {
                covariance[10 * i + k] = solved.correlation[a * count + b] * std[i] * std[k];
            }
        }
    }
    let body = if determined[..4].iter().all(|t| *t) { Body::new(&values, &covariance) } else { None };
    let alone = [&beta[..first], &[0.0; 10]].concat();
    let error = |log: &Factors, loaded: bool| LogError {
        name: log.name.clone(),
        loaded,
        seconds: log.seconds,
        with_tool: accuracy(&[log], &beta),
        robot_alone: accuracy(&[log], &alone),
    };
    let logs = unloaded.iter().map(|l| error(l, false)).chain(loaded.iter().map(|l| error(l, true))).collect();
    Ok(Carried {
        robot: arm.name().into(),
        values,
        std,
        covariance,
        standing,
        known_mass: settings.known_mass,
        mass_std: settings.mass_std,
        mass_of_logs,
        robot_errors,
        body: body.filter(|_| determined.iter().all(|t| *t)),
        freedom: (solved.noise.effective_samples.iter().sum::<f64>() - count as f64).max(1.0),
        logs,
        noise: solved.noise.clone(),
        beta,
        solved,
    })
}

/// Mass among all unknowns and its standard deviation, kg; `None` if it is undetermined.
fn mass_of(solved: &Identification) -> Option<[f64; 2]> {
    let mass = solved.parameters.len().checked_sub(10).map(|at| &solved.parameters[at])?;
    (mass.standing == Standing::Identified).then_some([mass.value, mass.std])
}

/// Includes a scale reading of the mass, the first of the last ten parameters: conditional mean and
/// covariance of a normal distribution.
fn add_scale_reading(solved: &mut Identification, mass: f64, std: f64) -> Result<(), ToolError> {
    let count = solved.parameters.len();
    let at = count - 10;
    if solved.parameters[at].standing != Standing::Identified {
        return Err(ToolError::MassUnidentified);
    }
    let determined: Vec<bool> = solved.parameters.iter().map(|p| p.standing == Standing::Identified).collect();
    let stds: Vec<f64> = solved.parameters.iter().map(|p| p.std).collect();
    let covariance = |i: usize, k: usize| match determined[i] && determined[k] {
        true => solved.correlation[i * count + k] * stds[i] * stds[k],
        false => 0.0,
    };
    let variance = covariance(at, at) + std * std;
    let column: Vec<f64> = (0..count).map(|i| covariance(i, at)).collect();
    let after: Vec<f64> = (0..count * count)
        .map(|e| covariance(e / count, e % count) - column[e / count] * column[e % count] / variance)
        .collect();
    let off = mass - solved.parameters[at].value;
    for i in (0..count).filter(|&i| determined[i]) {
        solved.parameters[i].value += column[i] / variance * off;
        solved.parameters[i].std = after[i * count + i].max(0.0).sqrt();
    }
    for i in (0..count).filter(|&i| determined[i]) {
        for k in (0..count).filter(|&k| determined[k] && k != i) {
            let scale = solved.parameters[i].std * solved.parameters[k].std;
            solved.correlation[i * count + k] = if scale > 0.0 { after[i * count + k] / scale } else { 0.0 };
        }
    }
    Ok(())
}
