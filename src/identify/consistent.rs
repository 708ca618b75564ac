//! Fits standard parameters of physically possible bodies to the data.
//!
//! Least squares gives base parameters, which need not belong to any real links. Here the unknowns
//! are the standard parameters `x` themselves, and the data enter as the same weighted factor as in
//! the plain solution. The pseudo-inertia `P_i(x)` of every link is kept inside its cone:
//!
//! ```text
//! min  1/(2 lambda) |R K x - z|^2 + w sum_i D(P_i(x), P0_i)    with  P_i(x) >= eps P0_i,  IA, FV, FC >= 0,  bounds
//! ```
//!
//! - `R, z`: triangular factor of the equations of all joints, each weighted by its noise; `beta =
//!   K x` are the base parameters.
//! - `lambda`: samples per independent sample, over all joints; the first term is then the negative
//!   logarithm of the likelihood.
//! - `D(P, P0) = tr(P P0^-1) - log det(P P0^-1) - 4`: the entropic (Bregman log-det) distance of P.
//!   Wensing and J.-J. Slotine / T. Lee, P. Wensing and F. Park, *Geometric robot dynamic
//!   identification: a convex programming approach*, IEEE Transactions on Robotics 36(2), 2020;
//!   twice the Kullback-Leibler divergence of the normal distributions with these second moments.
//!   It does not depend on units or frames. For small differences it is half the sum of squared
//!   relative differences, so `w = 1/s^2` gives the prior a relative standard deviation `s`.
//! - `eps` (`margin`): in every direction a link has at least this share of its prior's body. The
//!   distance is measured from there (of `P - eps P0`), so it is the barrier of the constraint. The
//!   problem is then smooth and strictly convex, with one solution ([`newton`]).
//!
//! Undetermined directions go to the prior; well-determined ones are hardly changed (`w = 1`
//! against thousands of samples).

mod bounds;
#[cfg(test)]
mod cuts;
mod least_squares;
mod newton;
mod path;
mod reproduce;
mod setup;
mod stacked;
#[cfg(test)]
mod tests;

pub use crate::model::likely_bodies::{PriorBody, Source, geometric_bodies, prior_bodies};
pub use crate::model::pseudo_inertia::{body_of, pseudo_inertia};
pub use bounds::Bounds;
pub use least_squares::{BoundedLeastSquares, Feasible};
pub use newton::Stalled;
pub use reproduce::{Reproduced, buildable_links, possible_bodies};

use newton::Weights;
use setup::{Data, Setup};

use statrs::distribution::{ContinuousCDF, FisherSnedecor};

use super::accuracy;
use super::result::{Identification, Underdetermined};
use crate::identify::regression::accumulator::Factors;
use crate::identify::regression::recover::base_of;
use crate::identify::regression::wls::{JointSystem, stacked};
use crate::identify::validation::accuracy::Accuracy;
use crate::identify::validation::preference::Preference;
use crate::identify::validation::preference::preference;
use crate::model::Arm;

/// Weight at which prior and barriers have no visible effect: they cost at most this per link
/// eigenvalue, in units of the log-likelihood.
const VANISHING: f64 = 1e-6;

/// Settings for fitting possible bodies.
#[derive(Debug, Clone, PartialEq)]
pub struct ConsistentSettings {
    /// `w`: 1 gives the prior's bodies a relative standard deviation of about 100 %, 100 one of 10
    /// %. Default 1.
    pub prior_weight: f64,
    /// Weight of a guessed body ([`Source::Geometric`]) relative to one from the robot file.
    /// Default 1e-3.
    pub geometric_share: f64,
    /// `eps`, above 0 and below 1. Default 1e-3.
    pub margin: f64,
    /// Prior on masses and centres.
    pub bounds: Bounds,
    /// Known bodies that are fixed to links (counted from 0), such as a tool. The standard
    /// parameters include them; the fitted bodies do not.
    pub carried: Vec<(usize, [f64; 10])>,
    /// Standard parameters of drives with a least value above zero, as for
    /// [`nonnegative_drives`](super::nonnegative_drives).
    pub floors: Vec<(usize, f64)>,
    /// Largest increase of the weighted residual of the fit due to possible bodies, percent, above
    /// which the data are reported to contradict physics. The increase must also exceed noise (an F
    /// test at 0.1 % over the independent samples: the plain fit of a short log follows the noise
    /// and has a smaller residual than the truth). Default 25.
    pub most_cost_percent: f64,
}

impl Default for ConsistentSettings {
    fn default() -> Self {
        Self {
            prior_weight: 1.0,
            geometric_share: 1e-3,
            margin: 1e-3,
            bounds: Bounds::default(),
            carried: Vec::new(),
            floors: Vec::new(),
            most_cost_percent: 25.0,
        }
    }
}

/// Reason why there are no possible bodies.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ConsistentError {
    /// A vector has the wrong length.
    #[error("{what}: {found} where the arm has {expected}")]
    Length {
        /// Name of the vector.
        what: &'static str,
        /// Length given.
        found: usize,
        /// Length required.
        expected: usize,
    },
    /// The arm's parameters do not describe complete bodies.
    #[error("link {link} has no parameter {missing}: ten are needed to decide whether it can be a body")]
    Incomplete {
        /// Link, counted from 1.
        link: usize,
        /// Name of the missing parameter.
        missing: String,
    },
    /// The weights or the margin are out of range.
    #[error("the prior's weight must be above 0, and the margin between 0 and 1")]
    Settings,
    /// A prior is not a possible body.
    #[error("the prior of link {link} is not the body of any distribution of mass")]
    PriorBody {
        /// Link, counted from 1.
        link: usize,
    },
    /// The bounds have no feasible solution.
    #[error("the bounds on the bodies contradict each other: {what}")]
    Bounds {
        /// Description of the contradiction.
        what: String,
    },
    /// The equations have infinite numbers.
    #[error("the equations contain infinite numbers")]
    NotFinite,
    /// The solver stalled. There is no substitute result.
    #[error("the search for possible bodies came to a halt: {0}")]
    Stalled(#[from] Stalled),
    /// No possible bodies explain the torques.
    #[error(
        "the data contradict physics: with possible bodies the weighted residual grows by {growth_percent:.0} % (allowed: {allowed_percent} %), \
         most on joint {joint}, from {plain:.3} to {possible:.3} N m. Look for torques with the wrong sign, a wrong table, gravity or tool, \
         a delay, or parameters that the model lacks (a rotor inertia, an offset)"
    )]
    Contradiction {
        /// Increase of the weighted residual, percent.
        growth_percent: f64,
        /// Allowed increase, percent.
        allowed_percent: f64,
        /// Joint with the largest increase, counted from 1.
        joint: usize,
        /// Its RMS error with the plain solution, N m.
        plain: f64,
        /// Its RMS error with possible bodies, N m.
        possible: f64,
    },
}

/// Cost of a fit compared with the plain one.
#[derive(Debug, Clone, PartialEq)]
pub struct Cost {
    /// Increase of the norm of the weighted residual of the fit, percent.
    pub growth_percent: f64,
    /// Errors on the fitted logs.
    pub fit: Accuracy,
    /// Errors on the validation logs.
    pub validation: Option<Accuracy>,
}

/// Possible bodies and their cost.
#[derive(Debug, Clone, PartialEq)]
pub struct Consistent {
    /// Standard parameters, in the arm's order, including the bodies fixed to links.
    pub standard: Vec<f64>,
    /// Base parameters of these standard parameters.
    pub base: Vec<f64>,
    /// Names of the base parameters.
    pub names: Vec<String>,
    /// Cost of possibility and prior together: errors of [`Consistent::standard`].
    pub cost: Cost,
    /// Cost of possibility alone (with vanishing weight of the prior).
    pub possible: Cost,
    /// Comparison of [`Consistent::standard`] with the plain solution on the validation logs, with
    /// an interval.
    pub against_plain: Option<Preference>,
    /// Whether the cost of possibility alone exceeds noise. If so, part of the residual is not
    /// noise, and the plain solution follows it to impossible bodies.
    pub significant: bool,
    /// Source of each link's prior.
    pub sources: Vec<Source>,
    /// Entropic distance of each link from its prior.
    pub distances: Vec<f64>,
    /// Smallest eigenvalue of each link's body relative to its prior; not below the margin.
    pub margins: Vec<f64>,
    /// Links (counted from 1) that the data push to the edge of possibility (with vanishing weight
    /// of the prior): eigenvalue below twice the margin.
    pub at_the_edge: Vec<usize>,
    /// Weight of the prior.
    pub prior_weight: f64,
    /// Largest allowed increase of the residual due to possibility, percent.
    pub most_cost_percent: f64,
    /// Margin that was used.
    pub margin: f64,
    /// Mass of all links, without the bodies fixed to them, kg.
    pub total_mass: f64,
    /// Number of Newton steps of both fits.
    pub steps: usize,
}

/// Fits possible bodies to the factors passed to [`solve`](super::solve), whose result is `found`.
///
/// `prior`: one body per link, without the bodies fixed to it ([`prior_bodies`]). `drives`:
/// standard parameters of the robot file, of which those of the drives are used (zero if unknown).
pub fn consistent(
    arm: &dyn Arm,
    fit: &[Factors],
    validate: &[Factors],
    found: &Identification,
    prior: &[PriorBody],
    drives: &[f64],
    settings: &ConsistentSettings,
) -> Result<Consistent, ConsistentError> {
    let (data, floor) = data(arm, fit, found)?;
    let parameters = arm.base_parameters().len() as f64;
    let freedom = found.independent - parameters;
    let setup = Setup::of(arm.description(), &data, prior, drives, settings)?;
    let shares = setup.problem.links.iter().map(|l| l.share).fold(1.0, f64::min);
    let vanishing = Weights { w: VANISHING / shares, mu: VANISHING };
    let wanted = Weights { w: settings.prior_weight, mu: VANISHING };
    let total = |logs: &[Factors], beta: &[f64]| accuracy(&logs.iter().collect::<Vec<_>>(), beta);
    let cost = |v: &[f64]| {
        let base = base_of(arm, &setup.standard(v));
        Cost {
            growth_percent: 100.0 * ((1.0 + 2.0 * setup.problem.misfit(v) / floor).sqrt() - 1.0),
            fit: total(fit, &base),
            validation: (!validate.is_empty()).then(|| total(validate, &base)),
        }
    };
    let significant = |v: &[f64]| {
        FisherSnedecor::new(parameters, freedom).is_ok_and(|distribution| {
            let f = (2.0 * setup.problem.misfit(v) / parameters) / (floor / freedom);
            f > distribution.inverse_cdf(0.999)
        })
    };
    let check = |v: &[f64], cost: &Cost| {
        if cost.growth_percent <= settings.most_cost_percent || !significant(v) {
            return Ok(());
        }
        let grown = |j: usize| (cost.fit.rms[j].powi(2) - found.fit.rms[j].powi(2)) / found.noise.sigma[j].powi(2);
        let joints = (0..found.fit.rms.len()).filter(|&j| found.fit.rms[j].is_finite());
        let joint = joints.max_by(|&a, &b| grown(a).total_cmp(&grown(b))).unwrap_or(0);
        Err(ConsistentError::Contradiction {
            growth_percent: cost.growth_percent,
            allowed_percent: settings.most_cost_percent,
            joint: joint + 1,
            plain: found.fit.rms[joint],
            possible: cost.fit.rms[joint],
        })
    };
    // If no bodies fit, a rough answer suffices: further digits would only refine the misfit.
    let rough = 1e-6 * setup.problem.misfit(&setup.start);
    if rough > vanishing.w {
        let (v, _) = setup.problem.follow(&setup.start, Weights { w: rough, mu: rough })?;
        if setup.problem.misfit(&v) > 1e4 * rough {
            check(&v, &cost(&v))?;
        }
    }
    let (v_possible, first) = setup.problem.follow(&setup.start, vanishing)?;
    let possible = cost(&v_possible);
    check(&v_possible, &possible)?;
    let significant = significant(&v_possible);
    let (v, second) = setup.problem.follow(&setup.start, wanted)?;
    let standard = setup.standard(&v);
    if standard.iter().any(|x| !x.is_finite()) {
        return Err(ConsistentError::NotFinite);
    }
    let mass = |x: &[f64]| -> f64 { setup.layout.links.iter().map(|l| x[l[0]]).sum() };
    let edge = |(link, margin): (usize, &f64)| (*margin < 2.0 * settings.margin).then_some(link + 1);
    let distance = |l: &newton::Link| setup.problem.distance(&v, l.start).unwrap_or(f64::INFINITY);
    let base = base_of(arm, &standard);
    Ok(Consistent {
        against_plain: preference(validate, &found.values(), &base),
        base,
        names: arm.base_parameters().iter().map(|b| b.name.clone()).collect(),
        cost: cost(&v),
        possible,
        significant,
        sources: prior.iter().map(|p| p.source).collect(),
        distances: setup.problem.links.iter().map(distance).collect(),
        margins: setup.margins(&v),
        at_the_edge: setup.margins(&v_possible).iter().enumerate().filter_map(edge).collect(),
        prior_weight: settings.prior_weight,
        most_cost_percent: settings.most_cost_percent,
        margin: settings.margin,
        total_mass: mass(&standard) - settings.carried.iter().map(|(_, b)| b[0]).sum::<f64>(),
        steps: first + second,
        standard,
    })
}

/// Plain problem in units of its noise, and the squared residual that no parameters remove.
fn data(arm: &dyn Arm, fit: &[Factors], found: &Identification) -> Result<(Data, f64), ConsistentError> {
    let parameters = arm.base_parameters().len();
    let joints = JointSystem::all(fit, parameters);
    let length = |what, found, expected| match found == expected {
        true => Ok(()),
        false => Err(ConsistentError::Length { what, found, expected }),
    };
    length("joints", found.noise.sigma.len(), joints.len())?;
    length("base parameters", found.parameters.len(), parameters)?;
    // An exact fit would have an unbounded weight: torques are known to at most five digits.
    let floored = |(joint, sigma): (&JointSystem, &f64)| sigma.max(1e-5 * joint.torque_rms).max(1e-12);
    // A fit with fewer equations than unknowns shows no noise; the residual of the file is an upper
    // bound.
    let follows = matches!(found.underdetermined(), Some(Underdetermined::Equations { .. }));
    let noise = found.fit_before.as_ref().filter(|_| follows).map_or(&found.noise.sigma, |before| &before.rms);
    let sigmas: Vec<f64> = joints.iter().zip(noise).map(floored).collect();
    let weights: Vec<f64> = if found.weighted {
        sigmas.iter().map(|s| s.recip()).collect()
    } else {
        let samples: usize = joints.iter().map(|j| j.samples).sum();
        let squares: f64 = joints.iter().zip(&sigmas).map(|(j, s)| s * s * j.samples as f64).sum();
        vec![(samples as f64 / squares).sqrt(); joints.len()]
    };
    let active: Vec<usize> = (0..parameters).collect();
    let triangle = stacked(&joints, &weights, &active, parameters);
    let effective: f64 = found.noise.effective_samples.iter().sum();
    let samples: usize = joints.iter().map(|j| j.samples).sum();
    let root = (effective / samples as f64).min(1.0).sqrt();
    let r = nalgebra::DMatrix::from_fn(parameters, parameters, |i, k| root * triangle.get(i, k));
    let z = nalgebra::DVector::from_fn(parameters, |i, _| root * triangle.get(i, parameters));
    let last = root * triangle.get(parameters, parameters);
    if r.iter().chain(z.iter()).chain([&last]).any(|x| !x.is_finite()) {
        return Err(ConsistentError::NotFinite);
    }
    Ok((Data { r, z }, (last * last).max(1e-12 * effective)))
}
