//! Constrained fit: possible bodies, and non-negative rotor inertias, friction levels and sizes of
//! laws. The result is the model that is evaluated, offered and written.

use dh_codegen::robot::EffectKind;
use nalgebra::{DMatrix, DVector};

use super::body_limits::independent_share;
use super::model::{Chosen, Fitted, Mode, ModelUnderTest, given_friction, inertial, local, units, without_friction};
use crate::diagnose::hypotheses::Sign;
use crate::diagnose::select::model_choice::LeftOut;
use crate::identify::{BoundedLeastSquares, ConsistentError, ConsistentSettings};
use crate::model::{BaseParameter, LikelyBodies, StandardParameter};

/// Relative accuracy of torques: no residual is trusted below this share of them.
const DIGITS: f64 = 1e-5;

/// Constraints on the unknowns of a fit.
struct Limits {
    standard: Vec<StandardParameter>,
    base: Vec<BaseParameter>,
    least: Vec<Option<f64>>,
    bodies: LikelyBodies,
    drives: Vec<f64>,
    settings: ConsistentSettings,
    /// Weights of the joints, in units of the noise of independent windows.
    weights: Vec<f64>,
}

impl Limits {
    /// Solves with these unknowns fixed at 1.
    fn solve_at_one(
        &self,
        mut normal: DMatrix<f64>,
        mut rhs: DVector<f64>,
        ones: &[usize],
    ) -> Result<(DVector<f64>, Vec<f64>), ConsistentError> {
        for &k in ones {
            rhs -= normal.column(k);
        }
        for &k in ones {
            normal.row_mut(k).fill(0.0);
            normal.column_mut(k).fill(0.0);
            rhs[k] = 0.0;
        }
        let (mut x, standard) = self.solve(&normal, &rhs)?;
        ones.iter().for_each(|&k| x[k] = 1.0);
        Ok((x, standard))
    }

    fn solve(&self, normal: &DMatrix<f64>, rhs: &DVector<f64>) -> Result<(DVector<f64>, Vec<f64>), ConsistentError> {
        let problem = BoundedLeastSquares {
            standard: &self.standard,
            base: &self.base,
            least: &self.least,
            prior: &self.bodies.prior,
            drives: &self.drives,
            settings: &self.settings,
        };
        problem.solve(normal, rhs).map(|found| (found.x, found.standard))
    }
}

impl ModelUnderTest<'_> {
    /// Moves a fit to the constrained least-squares solution. Unchanged if all of it is inside the
    /// limits and no link is unknown. The scene then has the model of the result.
    ///
    /// The coefficient of a law whose size is in its shape is fixed at 1, as in a robot file. With
    /// a scaled column the fit would be another model than the written one.
    ///
    /// # Errors
    /// If the solver finds no solution.
    pub(in crate::diagnose) fn possible(
        &mut self,
        chosen: &mut [Chosen],
        fitted: &Fitted,
    ) -> Result<Fitted, ConsistentError> {
        let mut limits = self.limits(chosen, fitted);
        let ones = units(chosen, fitted);
        let inside = |(least, x): (&Option<f64>, &f64)| least.is_none_or(|l| *x >= l);
        let first = limits.base.len();
        if first == 0 && ones.is_empty() && limits.least.iter().zip(fitted.solution.x.iter()).all(inside) {
            return Ok(fitted.clone());
        }
        let (normal, rhs) = fitted.moments.normal(&limits.weights);
        ones.iter().for_each(|&k| limits.least[k - first] = None);
        let (x, standard) = limits.solve_at_one(normal, rhs, &ones)?;
        let solution = fitted.moments.at(&fitted.solution, x);
        let standard = (first > 0).then(|| without_friction(self.plant, &standard));
        let moved = Fitted { residual: fitted.moments.residual(&solution.x), solution, standard, ..fitted.clone() };
        for ((c, at), terms) in chosen.iter_mut().zip(&moved.first).zip(&moved.terms) {
            c.x = (0..terms.len()).map(|t| moved.solution.x[at + t]).collect();
        }
        self.update_model(&moved);
        Ok(moved)
    }

    /// [`ModelUnderTest::left_out`] with constraints: each stretch is predicted by the possible
    /// model that fits the others best.
    ///
    /// # Errors
    /// If the solver finds no solution.
    pub(in crate::diagnose) fn possible_left_out(
        &self,
        chosen: &[Chosen],
        fitted: &Fitted,
    ) -> Result<LeftOut, ConsistentError> {
        let mut limits = self.limits(chosen, fitted);
        let (stretches, mut fixed) = (self.stretches(fitted), local(chosen, fitted));
        fixed.extend(units(chosen, fitted));
        let first = limits.base.len();
        let weights = limits.weights.clone();
        // Fixed values are not constrained.
        fixed.iter().for_each(|&k| limits.least[k - first] = None);
        let solve = |normal: &DMatrix<f64>, rhs: &DVector<f64>| limits.solve(normal, rhs).map(|(x, _)| x);
        let sums = stretches.cross_validated_by(&fitted.solution, &weights, &[], &fixed, solve)?;
        Ok(LeftOut::new(&sums, &stretches.counts()))
    }

    fn limits(&self, chosen: &[Chosen], fitted: &Fitted) -> Limits {
        let plant = self.plant;
        let bodies = if self.mode == Mode::Refitted { plant.bodies() } else { None };
        let all = plant.base_parameters();
        let count = if self.mode == Mode::Refitted { inertial(plant).len() } else { 0 };
        let base = match bodies {
            Some(_) => inertial(plant).into_iter().map(|b| all[b].clone()).collect(),
            None => Vec::new(),
        };
        // Base parameters without a body may have any sign; rotors of drives alone may not.
        let any = if plant.has_bodies() { None } else { Some(0.0) };
        let mut least = vec![any; if bodies.is_some() { 0 } else { count }];
        for (k, file) in given_friction(plant).iter().flatten().enumerate() {
            let bounded = k % 3 < 2 && !self.frozen[k];
            least.push(bounded.then(|| -file.unwrap_or(0.0).max(0.0)));
        }
        for (c, terms) in chosen.iter().zip(&fitted.terms) {
            let rotor = c.cause.effect() == EffectKind::RotorInertia;
            let own = |sign: Sign| match sign {
                Sign::Positive => Some(0.0),
                Sign::Any if rotor => Some(-self.scene.rotors[c.place[0]].max(0.0)),
                Sign::Any => None,
            };
            least.extend(terms.iter().map(|t| own(t.sign)));
        }
        let drives = (0..plant.standard_parameters().len()).map(|i| plant.given_drive(i)).collect();
        let solution = &fitted.solution;
        let share = independent_share(&solution.counts, &fitted.memory);
        let weight = |(w, torque): (&f64, f64)| share * w.min((DIGITS * torque).max(1e-12).powi(-2));
        let weights = solution.weights.iter().zip(fitted.moments.torque()).map(weight).collect();
        let carried = bodies.as_ref().map_or(Vec::new(), |b| b.carried.clone());
        Limits {
            standard: plant.standard_parameters().to_vec(),
            base,
            least,
            bodies: bodies.unwrap_or(LikelyBodies { prior: Vec::new(), carried: Vec::new() }),
            drives,
            settings: ConsistentSettings { carried, ..ConsistentSettings::default() },
            weights,
        }
    }
}
