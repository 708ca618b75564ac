//! Changed bodies that can exist: the file's link with what a cause adds to it, or what is fixed to
//! the flange by itself, is a distribution of mass.

use nalgebra::{DMatrix, DVector};

use super::model::{Chosen, Fitted, Mode, ModelUnderTest};
use super::moments::{Gain, Trial, reduced_normal};
use crate::diagnose::hypotheses::{Hypothesis, Symbol, Term};
use crate::identify::{BoundedLeastSquares, ConsistentSettings};
use crate::model::likely_bodies::{PriorBody, Source};
use crate::model::pseudo_inertia::is_body;
use crate::model::{BaseParameter, Inertial, PerturbableArm, StandardParameter};
use dh_codegen::robot::EffectKind;
use dh_codegen::robot::effects;

/// A guess of what is fixed to the flange: a ball of 1 kg, 5 cm away, `I` about the frame's origin.
const BALL: [f64; 10] = [1.0, 0.0, 0.0, 0.05, 0.0035, 0.0035, 0.001, 0.0, 0.0, 0.0];

/// The body that a cause changes.
#[derive(Debug, Clone)]
pub struct Body {
    /// Without the change; what is fixed to the flange is nothing.
    given: [f64; 10],
    prior: PriorBody,
    /// Which of the ten parameters each coefficient adds to.
    which: Vec<usize>,
}

impl Body {
    /// Of a cause whose coefficients add to parameters of a body; `None` where that is none of the
    /// file's, or where the file's is not possible itself.
    pub fn of(plant: &dyn PerturbableArm, effect: EffectKind, place: &[usize], terms: &[Term]) -> Option<Self> {
        let keys = match effect {
            EffectKind::Payload => effects::Payload::BODY,
            EffectKind::LinkInertiaError => effects::LinkInertiaError::BODY,
            _ => return None,
        };
        let of = |term: &Term| keys.iter().position(|key| Symbol::Key(*key) == term.symbol);
        let which = terms.iter().map(of).collect::<Option<Vec<usize>>>()?;
        if effect == EffectKind::Payload {
            let prior = PriorBody { body: BALL, source: Source::Geometric };
            return Some(Self { given: [0.0; 10], prior, which });
        }
        let first = 10 * plant.rows().get(*place.first()?)?;
        let given: [f64; 10] = plant.given()?.get(first..first + 10)?.try_into().ok()?;
        let prior = PriorBody { body: given, source: Source::File };
        is_body(&given).then_some(Self { given, prior, which })
    }

    /// Number of coefficients.
    pub fn len(&self) -> usize {
        self.which.len()
    }

    /// The changed body.
    fn changed(&self, x: &[f64]) -> [f64; 10] {
        let mut body = self.given;
        self.which.iter().zip(x).for_each(|(&k, x)| body[k] += x);
        body
    }

    /// Whether some distribution of mass has these parameters.
    pub fn holds(&self, x: &[f64]) -> bool {
        is_body(&self.changed(x))
    }
}

/// Least squares of changes of bodies, `normal` and `rhs` in units of the noise of independent
/// windows, everything else refitted: the bodies' coefficients one after the other. `None` where the
/// solver comes to a halt.
pub fn possible_changes(bodies: &[Body], normal: &DMatrix<f64>, rhs: &DVector<f64>) -> Option<DVector<f64>> {
    let (mut standard, mut base, mut given) = (Vec::new(), Vec::new(), Vec::new());
    for (row, body) in bodies.iter().enumerate() {
        let first = standard.len();
        standard.extend(Inertial::ALL.map(|which| StandardParameter::Link(row, which)));
        for &which in &body.which {
            base.push(BaseParameter {
                leader: standard[first + which],
                name: String::new(),
                grouping: String::new(),
                coefficients: vec![(first + which, 1.0)],
                unit: String::new(),
            });
            given.push(body.given[which]);
        }
    }
    let given = DVector::from_vec(given);
    let prior: Vec<PriorBody> = bodies.iter().map(|b| b.prior).collect();
    let drives = vec![0.0; standard.len()];
    let settings = ConsistentSettings::default();
    let problem = BoundedLeastSquares {
        standard: &standard,
        base: &base,
        least: &[],
        prior: &prior,
        drives: &drives,
        settings: &settings,
    };
    problem.solve(normal, &(rhs + normal * &given)).ok().map(|found| found.x - given)
}

/// Whether all that a cause changes of a body is among its coefficients. The inertia of a mass at a
/// point follows from its other numbers.
fn changes_a_body(cause: &dyn Hypothesis) -> bool {
    cause.within_links() && cause.shape().is_empty()
}

/// Independent windows by all windows.
pub(super) fn independent_share(counts: &[f64], memory: &[f64]) -> f64 {
    let independent: f64 = counts.iter().zip(memory).map(|(n, m)| n / m).sum();
    (independent / counts.iter().sum::<f64>()).min(1.0)
}

/// Unknowns of bodies that are not possible in a least-squares solution, and the values that are,
/// everything else refitted; `None` where all bodies are possible, or the solver finds none.
pub(super) fn possible_values(
    bodies: &[(Body, usize)],
    x: &DVector<f64>,
    inverse: &DMatrix<f64>,
    share: f64,
) -> Option<(Vec<usize>, DVector<f64>)> {
    let unknowns = |(body, first): &(Body, usize)| *first..*first + body.len();
    let value = |x: &DVector<f64>, of: &(Body, usize)| unknowns(of).map(|k| x[k]).collect::<Vec<f64>>();
    if bodies.iter().all(|of| of.0.holds(&value(x, of))) {
        return None;
    }
    let own: Vec<usize> = bodies.iter().flat_map(unknowns).collect();
    let normal = reduced_normal(inverse, &own) * share;
    let rhs = &normal * x.select_rows(&own);
    let all: Vec<Body> = bodies.iter().map(|b| b.0.clone()).collect();
    Some((own, possible_changes(&all, &normal, &rhs)?))
}

impl ModelUnderTest<'_> {
    /// Bodies that chosen causes change, with their unknowns. Where links are refitted, they are
    /// none of the causes.
    pub(super) fn changed_bodies(&self, chosen: &[Chosen], fitted: &Fitted) -> Vec<(Body, usize)> {
        if self.mode == Mode::Refitted {
            return Vec::new();
        }
        let own = chosen.iter().zip(&fitted.first).zip(&fitted.terms);
        let own = own.filter(|((c, _), terms)| changes_a_body(c.cause) && !terms.is_empty());
        own.filter_map(|((c, first), terms)| Some((Body::of(self.plant, c.cause.effect(), &c.place, terms)?, *first)))
            .collect()
    }

    /// A fit with the bodies that are not possible moved to where they are, all else refitted;
    /// unchanged where the solver finds none.
    pub(super) fn with_possible_bodies(&self, chosen: &[Chosen], fitted: Fitted) -> Fitted {
        let bodies = self.changed_bodies(chosen, &fitted);
        let Fitted { solution, moments, .. } = &fitted;
        let share = independent_share(&solution.counts, &fitted.memory);
        let Some((own, values)) = possible_values(&bodies, &solution.x, &solution.inverse, share) else {
            return fitted;
        };
        let solution = moments.limited(solution, &own, &values);
        let residual = moments.residual(&solution.x);
        Fitted { solution, memory: self.memory(&residual), residual, ..fitted }
    }

    /// What a cause's columns gain beside a fit; a body that a cause changes stays possible. `None`
    /// where the fit explains the same, or no possible body was found.
    pub(in crate::diagnose) fn limited_gain(
        &self,
        fitted: &Fitted,
        cause: &dyn Hypothesis,
        place: &[usize],
        terms: &[Term],
        trial: &Trial,
    ) -> Option<Gain> {
        let Fitted { moments, solution, memory, .. } = fitted;
        let reduced = moments.reduced(solution, trial)?;
        let free = reduced.solution();
        let limited = self.mode == Mode::Trusted && changes_a_body(cause);
        let body = limited.then(|| Body::of(self.plant, cause.effect(), place, terms)).flatten();
        let x = match body.filter(|body| !body.holds(free.as_slice())) {
            Some(body) => {
                let share = independent_share(&solution.counts, memory);
                possible_changes(&[body], &(&reduced.normal * share), &(&reduced.rhs * share))?
            }
            None => free,
        };
        Some(moments.gain_at(solution, trial, &reduced, x))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::pseudo_inertia::pseudo_inertia;
    use crate::numerics::prng::Random;

    const LINK: [f64; 10] = [2.0, 0.1, 0.0, 0.2, 0.05, 0.06, 0.02, 0.001, -0.002, 0.0];

    fn link() -> Body {
        let prior = PriorBody { body: LINK, source: Source::File };
        Body { given: LINK, prior, which: (0..10).collect() }
    }

    /// A well-conditioned normal matrix of ten columns, in units of a noise that says much.
    fn normal(random: &mut Random) -> DMatrix<f64> {
        let rows = DMatrix::from_fn(40, 10, |_, _| random.even(1.7));
        rows.tr_mul(&rows) * 1e6
    }

    #[test]
    fn a_change_that_is_possible_is_found_as_it_is() {
        let normal = normal(&mut Random::new(1));
        let change = DVector::from_iterator(10, LINK.iter().map(|x| 0.3 * x));
        assert!(link().holds(change.as_slice()));
        let found = possible_changes(&[link()], &normal, &(&normal * &change)).unwrap();
        assert!((&found - &change).amax() < 1e-4, "{found}");
    }

    /// Of all possible bodies none fits better than the one that is found, beyond what the prior
    /// and the margin cost.
    #[test]
    fn an_impossible_change_becomes_the_nearest_possible_one() {
        let mut random = Random::new(2);
        for _ in 0..20 {
            let normal = normal(&mut random);
            let wanted = DVector::from_fn(10, |k, _| LINK[k].abs().max(0.05) * 2.0 * random.even(1.7));
            if link().holds(wanted.as_slice()) {
                continue;
            }
            let misfit = |x: &DVector<f64>| {
                let off = x - &wanted;
                off.dot(&(&normal * &off))
            };
            let found = possible_changes(&[link()], &normal, &(&normal * &wanted)).unwrap();
            assert!(link().holds(found.as_slice()), "{found}");
            let best = misfit(&found);
            for step in [1e-3, 1e-2, 0.1] {
                for _ in 0..200 {
                    let other = &found + DVector::from_fn(10, |_, _| step * random.even(1.7));
                    assert!(!link().holds(other.as_slice()) || misfit(&other) > 0.99 * best - 100.0);
                }
            }
        }
    }

    #[test]
    fn two_bodies_are_limited_at_once_each_by_its_own() {
        let mut random = Random::new(3);
        let rows = DMatrix::from_fn(60, 20, |_, _| random.even(1.7));
        let normal = rows.tr_mul(&rows) * 1e6;
        // The first has lost more than it had, the second is possible.
        let mut wanted = DVector::zeros(20);
        wanted[0] = -3.0;
        wanted[10] = 1.0;
        (14..17).for_each(|k| wanted[k] = 0.05);
        let found = possible_changes(&[link(), link()], &normal, &(&normal * &wanted)).unwrap();
        let [first, second] = [&found.as_slice()[..10], &found.as_slice()[10..]];
        assert!(first[0] > -2.0 && link().holds(first) && link().holds(second));
        let body = link().changed(first);
        assert!(pseudo_inertia(&body).symmetric_eigenvalues().min() >= 0.0);
    }
}
