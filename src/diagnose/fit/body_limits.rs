//! Keeps changed bodies physically possible: the file's link plus the change, or the payload by
//! itself, is a mass distribution.

use nalgebra::{DMatrix, DVector};

use super::model::{Chosen, Fitted, Mode, ModelUnderTest};
use super::moments::{Gain, Trial, pseudo_inverse, reduced_normal};
use super::white_errors::independent_windows;
use crate::diagnose::hypotheses::{Hypothesis, Symbol, Term, point_inertia};
use crate::diagnose::windows::windowed_data::WindowedData;
use crate::identify::{BoundedLeastSquares, ConsistentSettings};
use crate::model::likely_bodies::{PriorBody, Source};
use crate::model::pseudo_inertia::is_body;
use crate::model::{BaseParameter, Inertial, StandardParameter};
use dh_codegen::robot::EffectKind;
use dh_codegen::robot::effects;

/// Initial guess for a body fixed to the flange: a ball of 1 kg at 5 cm, `I` about the frame's
/// origin.
const BALL: [f64; 10] = [1.0, 0.0, 0.0, 0.05, 0.0035, 0.0035, 0.001, 0.0, 0.0, 0.0];

/// Mass changes that are tried where the motion does not determine the mass of a link, as shares of
/// its mass. The largest are tried first, since they change the rotational inertia least.
const ADDED: [f64; 6] = [1.0, 0.3, 0.1, -0.7, -0.3, -0.1];

/// A body with the `changed` values of the parameters `which`. If they are not possible with the
/// other parameters of the `given` body, a point mass at the centre that the first moments imply is
/// added to these. `None` where no such body exists.
pub fn completed(given: &[f64; 10], changed: &[f64; 10], which: &[usize]) -> Option<[f64; 10]> {
    if is_body(changed) {
        return Some(*changed);
    }
    let with = |mass: f64| {
        let first: [f64; 3] = std::array::from_fn(|axis| changed[1 + axis] - given[1 + axis]);
        let center = first.map(|h| h / mass);
        let mut body = *given;
        for (k, by) in std::iter::once(mass).chain(first).enumerate() {
            body.iter_mut().zip(column(k, &center)).for_each(|(b, c)| *b += c * by);
        }
        which.iter().for_each(|&k| body[k] = changed[k]);
        body
    };
    let known = which.contains(&0).then(|| changed[0] - given[0]);
    let masses = known.map_or_else(|| ADDED.map(|share| share * given[0]).to_vec(), |mass| vec![mass]);
    masses
        .into_iter()
        .filter(|mass| *mass != 0.0)
        .map(with)
        .find(|body| body.iter().all(|b| b.is_finite()) && is_body(body))
}

/// The body that a cause changes.
#[derive(Debug, Clone)]
pub struct Body {
    /// Parameters without the change; zero for a payload.
    given: [f64; 10],
    prior: PriorBody,
    /// Change of the ten parameters per unit of each coefficient: one of the ten, or for a point
    /// mass also the inertia that belongs to it.
    columns: Vec<[f64; 10]>,
    /// Index of each coefficient among the ten parameters.
    which: Vec<usize>,
    /// Prior standard deviation of each coefficient.
    std: Option<Vec<f64>>,
}

impl Body {
    /// The body of a chosen cause whose coefficients add to body parameters. `None` for other
    /// causes, or where the file has no such body or an impossible one.
    pub fn of(scene: &WindowedData<'_>, chosen: &Chosen, terms: &[Term]) -> Option<Self> {
        let Chosen { cause, place, shape, .. } = chosen;
        let effect = cause.effect();
        let keys = match effect {
            EffectKind::Payload => effects::Payload::BODY,
            EffectKind::LinkInertiaError => effects::LinkInertiaError::BODY,
            _ => return None,
        };
        let of = |term: &Term| keys.iter().position(|key| Symbol::Key(*key) == term.symbol);
        let which = terms.iter().map(of).collect::<Option<Vec<usize>>>()?;
        let columns = which.iter().map(|&k| column(k, shape)).collect();
        let std = cause.prior_std(scene, place, terms);
        if effect == EffectKind::Payload {
            let prior = PriorBody { body: BALL, source: Source::Geometric };
            return Some(Self { given: [0.0; 10], prior, columns, which, std });
        }
        let first = 10 * scene.plant.rows().get(*place.first()?)?;
        let given: [f64; 10] = scene.plant.given()?.get(first..first + 10)?.try_into().ok()?;
        let prior = PriorBody { body: given, source: Source::File };
        is_body(&given).then_some(Self { given, prior, columns, which, std })
    }

    /// Number of coefficients.
    pub fn len(&self) -> usize {
        self.which.len()
    }

    /// Parameters of the body with these changes.
    fn changed(&self, x: &[f64]) -> [f64; 10] {
        let mut body = self.given;
        for (column, x) in self.columns.iter().zip(x) {
            body.iter_mut().zip(column).for_each(|(b, c)| *b += c * x);
        }
        body
    }

    /// Whether a mass distribution has these parameters, with any values of the unidentifiable
    /// ones.
    pub fn holds(&self, x: &[f64]) -> bool {
        completed(&self.given, &self.changed(x), &self.which).is_some()
    }

    /// Mass of the link with these changes, kg, if it is not identifiable and the file's mass is
    /// not possible with them.
    pub fn assumed_mass(&self, x: &[f64]) -> Option<f64> {
        let changed = self.changed(x);
        let unseen = !self.which.contains(&0) && !is_body(&changed);
        unseen.then(|| completed(&self.given, &changed, &self.which)).flatten().map(|body| body[0])
    }

    /// Prior information on each coefficient: zero where there is no prior.
    fn precision(&self) -> Vec<f64> {
        let one = |k: usize| self.std.as_ref().map_or(0.0, |std| std[k].max(f64::MIN_POSITIVE).powi(-2));
        (0..self.len()).map(one).map(|p| if p.is_finite() { p } else { 0.0 }).collect()
    }
}

/// Change of all ten parameters per unit of one of them; `shape` is the centre of mass, if the body
/// is a point mass.
fn column(which: usize, shape: &[f64]) -> [f64; 10] {
    let mut column = [0.0; 10];
    column[which] = 1.0;
    if let (Some(axis @ 0..3), [_, _, _]) = (which.checked_sub(1), shape) {
        column[4..].copy_from_slice(&point_inertia(axis, shape));
    }
    column
}

/// The normal matrix of some bodies' coefficients plus their prior information, so that
/// undetermined directions do not lead to masses of tonnes.
fn with_prior(bodies: &[Body], mut normal: DMatrix<f64>) -> DMatrix<f64> {
    let precision: Vec<f64> = bodies.iter().flat_map(Body::precision).collect();
    precision.into_iter().enumerate().for_each(|(k, p)| normal[(k, k)] += p);
    normal
}

/// Constrained least squares of changes of bodies, in the coefficients of all bodies in order, with
/// everything else refitted. `normal` and `rhs` are in units of the noise of independent windows.
/// `None` where the solver fails.
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

/// Ratio of independent windows to all windows.
pub(super) fn independent_share(counts: &[f64], memory: &[f64]) -> f64 {
    (independent_windows(counts, memory).sum::<f64>() / counts.iter().sum::<f64>()).min(1.0)
}

/// Unknowns of bodies, and their values with the prior, inside the limits where a solution is
/// found, everything else refitted. `None` where the solution already has these values.
pub(super) fn possible_values(
    bodies: &[(Body, usize)],
    x: &DVector<f64>,
    inverse: &DMatrix<f64>,
    share: f64,
) -> Option<(Vec<usize>, DVector<f64>)> {
    let own: Vec<usize> = bodies.iter().flat_map(|(body, first)| *first..*first + body.len()).collect();
    let free = x.select_rows(&own);
    let all: Vec<Body> = bodies.iter().map(|b| b.0.clone()).collect();
    let normal = reduced_normal(inverse, &own) * share;
    let rhs = &normal * &free;
    let values = limited(&all, normal, &rhs, free.clone())?;
    (values != free).then_some((own, values))
}

/// Constrained least squares of changes of bodies with their priors; `free` is the solution
/// without.
fn limited(bodies: &[Body], normal: DMatrix<f64>, rhs: &DVector<f64>, free: DVector<f64>) -> Option<DVector<f64>> {
    let known = bodies.iter().any(|body| body.std.is_some());
    let normal = with_prior(bodies, normal);
    let x = if known { pseudo_inverse(&normal) * rhs } else { free };
    let mut first = 0;
    let hold = bodies.iter().all(|body| {
        first += body.len();
        body.holds(&x.as_slice()[first - body.len()..first])
    });
    if hold { Some(x) } else { possible_changes(bodies, &normal, rhs) }
}

impl ModelUnderTest<'_> {
    /// Bodies that chosen causes change, with the index of their first unknown. None where links
    /// are refitted.
    pub(super) fn changed_bodies(&self, chosen: &[Chosen], fitted: &Fitted) -> Vec<(Body, usize)> {
        if self.mode == Mode::Refitted {
            return Vec::new();
        }
        let own = chosen.iter().zip(&fitted.first).zip(&fitted.terms);
        let own = own.filter(|((c, _), terms)| c.cause.within_links() && !terms.is_empty());
        own.filter_map(|((c, first), terms)| Some((Body::of(&self.scene, c, terms)?, *first))).collect()
    }

    /// A fit with impossible bodies moved to possible ones, all else refitted; unchanged where the
    /// solver finds none.
    pub(super) fn with_possible_bodies(&self, chosen: &[Chosen], fitted: Fitted) -> Fitted {
        let bodies = self.changed_bodies(chosen, &fitted);
        if bodies.is_empty() {
            return fitted;
        }
        let Fitted { solution, moments, .. } = &fitted;
        let share = independent_share(&solution.counts, &fitted.memory);
        let Some((own, values)) = possible_values(&bodies, &solution.x, &solution.inverse, share) else {
            return fitted;
        };
        let solution = moments.limited(solution, &own, &values);
        let residual = moments.residual(&solution.x);
        Fitted { solution, memory: self.memory(&residual), residual, ..fitted }
    }

    /// Whether the body that a cause changes remains possible.
    pub(in crate::diagnose) fn is_possible(&self, chosen: &Chosen, terms: &[Term]) -> bool {
        let body = || Body::of(&self.scene, chosen, terms);
        self.mode == Mode::Refitted || !chosen.cause.within_links() || body().is_none_or(|b| b.holds(&chosen.x))
    }

    /// Gain of a cause's columns beside a fit, with the changed body inside its limits. `None`
    /// where the fit already explains the same, or no possible body was found.
    pub(in crate::diagnose) fn limited_gain(
        &self,
        fitted: &Fitted,
        cause: &'static dyn Hypothesis,
        (place, shape): (&[usize], &[f64]),
        terms: &[Term],
        trial: &Trial,
    ) -> Option<Gain> {
        let Fitted { moments, solution, memory, .. } = fitted;
        let reduced = moments.reduced(solution, trial)?;
        let free = reduced.solution();
        let limits = self.mode == Mode::Trusted && cause.within_links();
        let chosen = || Chosen { cause, place: place.to_vec(), shape: shape.to_vec(), x: Vec::new() };
        let body = limits.then(|| Body::of(&self.scene, &chosen(), terms)).flatten();
        let x = match body {
            Some(body) => {
                let share = independent_share(&solution.counts, memory);
                let (normal, rhs) = (&reduced.normal * share, &reduced.rhs * share);
                let found = limited(std::slice::from_ref(&body), normal, &rhs, free)?;
                body.holds(found.as_slice()).then_some(found)?
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
        let columns = (0..10).map(|k| column(k, &[])).collect();
        Body { given: LINK, prior, columns, which: (0..10).collect(), std: None }
    }

    /// A well-conditioned normal matrix of ten columns, with a small noise.
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

    /// No possible body fits better than the one found, beyond the cost of the prior and the
    /// margin.
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
        // The first has lost more mass than it had, the second is possible.
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

    /// A direction without data keeps its prior size; determined directions keep their values.
    #[test]
    fn a_prior_keeps_what_the_data_leave_open_at_a_robots_size() {
        let columns: Vec<[f64; 10]> = (0..4).map(|k| column(k, &[0.0, 0.0, 0.0])).collect();
        let prior = PriorBody { body: LINK, source: Source::File };
        let std = Some(vec![2.0, 0.3, 0.3, 0.3]);
        let body = Body { given: LINK, prior, columns, which: (0..4).collect(), std };
        // Determined to a thousandth: MSX and 0.01 M - MSZ. Undetermined: their sum, and MSY.
        let mut normal = DMatrix::zeros(4, 4);
        normal[(1, 1)] = 1e6;
        for (i, a) in [(0, 0.01), (3, -1.0)] {
            for (k, b) in [(0, 0.01), (3, -1.0)] {
                normal[(i, k)] = 1e6 * a * b;
            }
        }
        // A possible least-squares solution: 300 kg, balanced by 3 kg m.
        let free = DVector::from_vec(vec![300.0, 0.05, 0.0, 3.0 - 0.02]);
        let found = limited(&[body], normal.clone(), &(&normal * &free), free).unwrap();
        assert!(found[0].abs() < 0.5 && found[2].abs() < 0.01, "{found}");
        assert!((found[1] - 0.05).abs() < 1e-3 && (0.01 * found[0] - found[3] - 0.02).abs() < 1e-3, "{found}");
    }

    /// First moments are possible with some mass where the mass is unidentifiable, but not with
    /// any.
    #[test]
    fn a_mass_that_does_not_show_makes_a_body_possible() {
        let prior = PriorBody { body: LINK, source: Source::File };
        let columns = [1, 2].map(|k| column(k, &[])).to_vec();
        let body = Body { given: LINK, prior, columns, which: vec![1, 2], std: None };
        let added = body.changed(&[0.05, 0.6]);
        assert!(!is_body(&added) && body.holds(&[0.05, 0.6]));
        let whole = completed(&LINK, &added, &[1, 2]).unwrap();
        assert_eq!(body.assumed_mass(&[0.05, 0.6]), Some(whole[0]));
        assert_eq!(body.assumed_mass(&[0.0, 0.01]), None);
        assert!(is_body(&whole) && whole[1..4] == added[1..4] && whole[0] > LINK[0]);
        // If all ten are identified, an impossible body stays impossible.
        assert!(completed(&LINK, &added, &(0..10).collect::<Vec<usize>>()).is_none());
    }

    /// The inertia of a point mass belongs to its first moments. A heavy mass far away never makes
    /// a light link's inertia negative, but a negative mass does.
    #[test]
    fn a_mass_at_a_point_is_possible_where_the_whole_link_is() {
        let centre = [0.0, 0.0, 0.2];
        let prior = PriorBody { body: LINK, source: Source::File };
        let columns = (0..4).map(|k| column(k, &centre)).collect();
        let body = Body { given: LINK, prior, columns, which: (0..4).collect(), std: None };
        let mass = |m: f64| [m, 0.0, 0.0, m * centre[2]];
        assert!(body.holds(&mass(3.0)) && !body.holds(&mass(-3000.0)) && !body.holds(&mass(-1.9)));
        let inertia = body.changed(&mass(3.0));
        assert!((inertia[4] - LINK[4] - 3.0 * 0.04).abs() < 1e-12 && (inertia[6] - LINK[6]).abs() < 1e-12);
    }
}
