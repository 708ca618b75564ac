//! Solves the factors of logs for the base parameters, with statistics and checks.

use nalgebra::DMatrix;

use super::accuracy;
use super::result::{Condition, Confused, Estimate, Identification, LogSummary, Standing};
use crate::identify::regression::accumulator::Factors;
use crate::identify::regression::essential;
use crate::identify::regression::essential::Essential;
use crate::identify::regression::recover::base_of;
use crate::identify::regression::spectrum::{Small, coupled};
use crate::identify::regression::statistics::covariance;
use crate::identify::regression::wls::{JointSystem, Problem, stacked};
use crate::identify::validation::log_consistency::log_consistency;
use crate::identify::validation::torque_sign;
use crate::identify::validation::unexplained::unexplained;
use crate::model::Arm;

/// Settings of the solution.
#[derive(Debug, Clone, PartialEq)]
pub struct IdentifySettings {
    /// Whether each joint is weighted by its own noise. Default true.
    pub weighted: bool,
    /// Whether to leave out parameters that are not essential. Default: none are left out.
    pub essential: Option<Essential>,
    /// Standard parameters of the robot file: for comparison, and as values of parameters that the
    /// data do not determine.
    pub prior: Option<Vec<f64>>,
    /// Combinations whose singular value (columns of unit norm) is below this times the largest
    /// count as undetermined. Default 1e-10: above rounding, below any noise.
    pub tolerance: f64,
    /// Largest number of weighting rounds. Default 20.
    pub most_iterations: usize,
}

impl Default for IdentifySettings {
    fn default() -> Self {
        Self { weighted: true, essential: None, prior: None, tolerance: 1e-10, most_iterations: 20 }
    }
}

/// Reason why nothing could be identified.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum IdentifyError {
    /// There is no log.
    #[error("there is no log to fit")]
    NoLog,
    /// Every torque is zero.
    #[error(
        "the torques of all joints are zero throughout; take logs, or the torque column (tau, taum), that were measured"
    )]
    NoTorque,
    /// There are fewer equations than unknowns.
    #[error("{samples} samples of {joints} joints are too few for {parameters} parameters; record a longer motion")]
    TooFew {
        /// Samples over all joints.
        samples: usize,
        /// Number of joints.
        joints: usize,
        /// Number of unknowns.
        parameters: usize,
    },
    /// The factors belong to another arm, or the prior has the wrong length.
    #[error("{what}: {found} where the arm has {expected}")]
    Mismatch {
        /// Name of the mismatched quantity.
        what: String,
        /// Number given.
        found: usize,
        /// Number required.
        expected: usize,
    },
    /// The equations overflowed because of absurd positions or torques.
    #[error("the equations contain infinite numbers; look for absurd values in the log")]
    NotFinite,
}

/// Correlation of all parameters; NaN for those that are not `active` or are `open`.
fn correlations(covariance: &DMatrix<f64>, active: &[usize], std: &[f64], open: &[bool]) -> Vec<f64> {
    let parameters = std.len();
    let mut correlation = vec![f64::NAN; parameters * parameters];
    for (i, &row) in active.iter().enumerate() {
        for (k, &column) in active.iter().enumerate() {
            if !open[row] && !open[column] {
                let value = covariance[(i, k)] / (std[row] * std[column]);
                correlation[row * parameters + column] = if i == k { 1.0 } else { value };
            }
        }
    }
    correlation
}

/// Identifies the base parameters from `fit`, and validates them on `validate`.
pub fn solve(
    arm: &dyn Arm,
    fit: &[Factors],
    validate: &[Factors],
    settings: &IdentifySettings,
) -> Result<Identification, IdentifyError> {
    let parameters = arm.base_parameters();
    check(arm, fit, validate, settings)?;
    let joints = JointSystem::all(fit, parameters.len());
    let samples: usize = joints.iter().map(|j| j.samples).sum();
    if samples == 0 {
        return Err(IdentifyError::NoTorque);
    }
    if samples < parameters.len() {
        return Err(IdentifyError::TooFew { samples, joints: joints.len(), parameters: parameters.len() });
    }
    if joints.iter().chain(&JointSystem::all(validate, parameters.len())).any(|j| j.gram.iter().any(|v| !v.is_finite()))
    {
        return Err(IdentifyError::NotFinite);
    }
    let before = settings.prior.as_ref().map(|standard| base_of(arm, standard));
    let prior = before.clone().unwrap_or_else(|| vec![0.0; parameters.len()]);
    let problem = Problem {
        joints: &joints,
        parameters: parameters.len(),
        prior: &prior,
        tolerance: settings.tolerance,
        weighted: settings.weighted,
        most_iterations: settings.most_iterations.max(1),
    };
    let everything: Vec<usize> = (0..parameters.len()).collect();
    let mut solution = problem.solve(&everything, None);
    let names: Vec<String> = parameters.iter().map(|p| p.name.clone()).collect();
    let groups = coupled(&solution.null);
    let confused: Vec<Confused> = groups
        .iter()
        .map(|group| Confused {
            parameters: group.iter().map(|&i| names[solution.active[i]].clone()).collect(),
            open: group.iter().map(|&i| solution.null.row(i).norm_squared()).sum::<f64>().round() as usize,
        })
        .collect();
    let mut open = vec![false; parameters.len()];
    groups.iter().flatten().for_each(|&i| open[solution.active[i]] = true);
    let mut dropped = Vec::new();
    if let Some(essential) = settings.essential {
        let identified: Vec<usize> = everything.iter().copied().filter(|&c| !open[c]).collect();
        let start = if identified.len() < everything.len() {
            problem.solve(&identified, Some(&solution.weights))
        } else {
            solution.clone()
        };
        let (active, gone) = essential::reduce(&problem, &start, &names, essential);
        if identified.len() == everything.len() || !gone.is_empty() {
            dropped = gone;
            solution = problem.solve(&active, Some(&solution.weights));
        }
    }
    let (noise, covariance) = covariance(&joints, &solution, parameters.len());
    let mut std = vec![0.0; parameters.len()];
    for (i, &c) in solution.active.iter().enumerate() {
        std[c] = if open[c] { f64::INFINITY } else { covariance[(i, i)].max(0.0).sqrt() };
    }
    let mut white_std = std.clone();
    for (i, &c) in solution.active.iter().enumerate().filter(|(_, c)| !open[**c]) {
        white_std[c] = solution.inverse_information[(i, i)].max(0.0).sqrt();
    }
    let correlation = correlations(&covariance, &solution.active, &std, &open);
    let mut findings = match &before {
        Some(beta) if beta.iter().any(|v| *v != 0.0) => torque_sign::Model { beta, covariance: None }.opposed(&joints),
        _ => Vec::new(),
    };
    if findings.is_empty() {
        findings = torque_sign::against_fit(arm, &problem, &solution, &std);
    }
    let known = Some((&covariance, solution.active.as_slice()));
    let model = torque_sign::Model { beta: &solution.beta, covariance: known };
    for log in validate {
        for suspicion in model.opposed_by(log) {
            if findings.iter().all(|f| f.column != suspicion.column) {
                findings.push(suspicion);
            }
        }
    }
    let total = |logs: &[Factors], beta: &[f64]| accuracy(&logs.iter().collect::<Vec<_>>(), beta);
    let fitted = total(fit, &solution.beta);
    // A wrong sign is the more specific explanation.
    if findings.is_empty() {
        findings = unexplained(&fitted, parameters, &joints);
    }
    findings.extend(log_consistency(fit, &solution.weights, parameters.len()));
    let pairs = joints.iter().zip(&noise.effective_samples);
    let independent = pairs.map(|(joint, effective)| joint.independent.min(*effective)).sum();
    let unknowns = solution.active.len() - solution.null.ncols();
    let [weighted, scaled] = solution.small.conditions();
    let plain =
        Small::new(&stacked(&joints, &vec![1.0; joints.len()], &solution.active, parameters.len())).conditions()[0];
    let some = !validate.is_empty();
    Ok(Identification {
        budget: None,
        robot: arm.name().into(),
        parameters: parameters
            .iter()
            .enumerate()
            .map(|(c, p)| {
                let standing = match (open[c], solution.active.contains(&c)) {
                    (true, _) => Standing::NotIdentifiable,
                    (false, true) => Standing::Identified,
                    (false, false) => Standing::Dropped,
                };
                let values = [solution.beta[c], std[c], white_std[c]];
                Estimate::of(p, values, standing, before.as_ref().map(|b| b[c]))
            })
            .collect(),
        correlation,
        noise,
        fit: fitted,
        validation: some.then(|| total(validate, &solution.beta)),
        fit_before: before.as_ref().map(|beta| total(fit, beta)),
        validation_before: before.as_ref().filter(|_| some).map(|beta| total(validate, beta)),
        logs: fit
            .iter()
            .map(|log| (log, false))
            .chain(validate.iter().map(|log| (log, true)))
            .map(|(log, validates)| LogSummary {
                name: log.name.clone(),
                samples: log.joints.iter().map(|j| j.samples).collect(),
                seconds: log.seconds,
                validates,
                accuracy: accuracy(&[log], &solution.beta),
            })
            .collect(),
        condition: Condition { weighted, scaled, plain },
        confused,
        dropped,
        iterations: solution.iterations,
        weighted: settings.weighted,
        findings,
        samples,
        independent,
        unknowns,
    })
}

fn check(
    arm: &dyn Arm,
    fit: &[Factors],
    validate: &[Factors],
    settings: &IdentifySettings,
) -> Result<(), IdentifyError> {
    if fit.is_empty() {
        return Err(IdentifyError::NoLog);
    }
    let same = |what: String, found: usize, expected: usize| match found == expected {
        true => Ok(()),
        false => Err(IdentifyError::Mismatch { what, found, expected }),
    };
    for log in fit.iter().chain(validate) {
        same(format!("{}: joints", log.name), log.joints.len(), arm.dof())?;
        same(format!("{}: parameters", log.name), log.parameters, arm.base_parameters().len())?;
    }
    match &settings.prior {
        Some(prior) => same("standard parameters given".into(), prior.len(), arm.standard_parameters().len()),
        None => Ok(()),
    }
}
