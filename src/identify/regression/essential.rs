//! Essential parameters: those without which the prediction degrades (Khalil and Dombre, section
//! 12.5.4).
//!
//! The parameter of the largest relative standard deviation is dropped and the rest is fitted
//! again. This ends when all are well determined, or when the dropped ones together differ from
//! zero significantly under their own covariance (Wald's F test on the full model).

use nalgebra::DVector;
use statrs::distribution::{ContinuousCDF, FisherSnedecor};

use crate::identify::regression::statistics::covariance;
use crate::identify::regression::wls::{Problem, Solution, positions};

/// Stopping criteria for dropping parameters.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Essential {
    /// Relative standard deviation below which parameters are kept, percent. Default 10.
    pub percent: f64,
    /// Level of the F test: probability of stopping although all dropped parameters are zero.
    /// Default 0.05.
    pub level: f64,
}

impl Default for Essential {
    fn default() -> Self {
        Self { percent: 10.0, level: 0.05 }
    }
}

/// A parameter that was left out.
#[derive(Debug, Clone, PartialEq)]
pub struct Dropped {
    /// Name of the parameter.
    pub name: String,
    /// Value in the full model.
    pub value: f64,
    /// Relative standard deviation when it was dropped, percent.
    pub relative_std_percent: f64,
    /// F value of all parameters dropped so far.
    pub f: f64,
    /// F value at which the reduction would have stopped.
    pub limit: f64,
    /// Increase of the weighted residual so far, percent.
    pub residual_growth_percent: f64,
}

/// Solution with the kept parameters, and the list of those that were dropped.
pub(in crate::identify) fn reduce(
    problem: &Problem<'_>,
    full: &Solution,
    names: &[String],
    settings: Essential,
) -> (Vec<usize>, Vec<Dropped>) {
    let (noise, full_covariance) = covariance(problem.joints, full, problem.parameters);
    let place = positions(&full.active, problem.parameters);
    let freedom = (noise.effective_samples.iter().sum::<f64>() - full.active.len() as f64).max(1.0);
    let weighted_residual = |s: &Solution| -> f64 {
        let square =
            |(j, w): (&crate::identify::regression::wls::JointSystem, &f64)| (w * j.residual_norm(&s.beta)).powi(2);
        problem.joints.iter().zip(&full.weights).map(square).sum::<f64>().sqrt()
    };
    let floor = weighted_residual(full);
    let fixed = Problem { most_iterations: 1, ..problem.clone() };
    let (mut active, mut dropped, mut gone) = (full.active.clone(), Vec::<Dropped>::new(), Vec::new());
    let mut solution = full.clone();
    while active.len() > 1 {
        let (_, covariance) = covariance(problem.joints, &solution, problem.parameters);
        let relative = |i: usize| 100.0 * covariance[(i, i)].sqrt() / solution.beta[active[i]].abs();
        let Some(worst) = (0..active.len()).max_by(|&a, &b| relative(a).total_cmp(&relative(b))) else { break };
        let percent = relative(worst);
        if percent < settings.percent {
            break;
        }
        let candidate = active[worst];
        gone.push(candidate);
        let f = wald(&gone, full, &place, &full_covariance);
        let limit = FisherSnedecor::new(gone.len() as f64, freedom)
            .map_or(f64::INFINITY, |law| law.inverse_cdf(1.0 - settings.level));
        // NaN (an undetermined parameter) counts as no evidence against dropping.
        if f > limit {
            break;
        }
        active.remove(worst);
        solution = fixed.solve(&active, Some(&full.weights));
        dropped.push(Dropped {
            name: names[candidate].clone(),
            value: full.beta[candidate],
            relative_std_percent: percent,
            f,
            limit,
            residual_growth_percent: 100.0 * (weighted_residual(&solution) / floor - 1.0),
        });
    }
    (active, dropped)
}

/// F statistic `b' C^-1 b / m` of `m` parameters `b` with covariance `C`, for the hypothesis that
/// all are zero.
fn wald(gone: &[usize], full: &Solution, place: &[Option<usize>], covariance: &nalgebra::DMatrix<f64>) -> f64 {
    let at: Vec<usize> = gone.iter().filter_map(|&c| place[c]).collect();
    let b = DVector::from_fn(at.len(), |i, _| full.beta[gone[i]]);
    let c = nalgebra::DMatrix::from_fn(at.len(), at.len(), |i, k| covariance[(at[i], at[k])]);
    c.cholesky().map_or(f64::NAN, |root| b.dot(&root.solve(&b)) / at.len() as f64)
}
