//! A model under test: the rigid arm, its friction and the accepted causes, fitted to
//! [`WindowedData`].

use std::collections::HashMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use nalgebra::{DMatrix, DVector};

use crate::identify::recover_standard;
use crate::model::{DriveTerm, PerturbableArm, StandardParameter};
use crate::numerics::parallel::{parallel, threads_for};
use crate::numerics::sums::root_mean_square;

use super::body_limits::{independent_share, possible_values};
use super::moments::{Moments, Solution};
use super::regulariser::{Regulariser, STRENGTHS, prior};
use super::shapes::misfit;
use super::uncertainty::derivative;
use crate::diagnose::hypotheses::{Hypothesis, PLAIN, Term, UNIT};
use crate::diagnose::select::model_choice::LeftOut;
use crate::diagnose::windows::recording::Recording;
use crate::diagnose::windows::torque_noise::autocorrelation_time;
use crate::diagnose::windows::windowed_data::{BLOCKS, Column, WindowedData};

/// Delay, s, below which it is treated as linear in its column and the data are not shifted.
const LINEAR: f64 = 2e-4;

/// Unknown parameters of the rigid arm.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mode {
    /// None: link parameters are fixed at the file's values, apart from the causes.
    Trusted,
    /// All base parameters.
    Refitted,
}

/// An accepted cause.
#[derive(Clone)]
pub struct Chosen {
    /// Cause of the vocabulary.
    pub cause: &'static dyn Hypothesis,
    /// Joints on which it acts, from 0.
    pub place: Vec<usize>,
    /// Its nonlinear parameters.
    pub shape: Vec<f64>,
    /// Its linear coefficients.
    pub x: Vec<f64>,
}

impl Chosen {
    /// Range of samples, `step` s apart, in which a local cause acts; `None` for other causes.
    pub(in crate::diagnose) fn span(&self, step: f64) -> Option<std::ops::Range<usize>> {
        let [start, end] = self.cause.acts(&self.shape)?;
        let at = |t: f64| (t / step).round() as usize;
        Some(at(start)..at(end))
    }

    /// Whether a number of the shape is an integer that must remain one.
    pub(super) fn integer(&self, number: usize) -> bool {
        self.cause.integer_shape() == Some(number) && self.shape[number].fract() == 0.0
    }
}

/// Index among `[FV, FC, FO]`, and row, of friction parameters, which are separate from the base
/// parameters.
fn friction_of(parameter: StandardParameter) -> Option<(usize, usize)> {
    let StandardParameter::Drive(row, term) = parameter else { return None };
    let which = [DriveTerm::FV, DriveTerm::FC, DriveTerm::FO].iter().position(|t| *t == term)?;
    Some((which, row))
}

/// Friction of the file, per joint: `[FV, FC, FO]`; `None` where its model lacks the term.
pub fn given_friction(plant: &dyn PerturbableArm) -> Vec<[Option<f64>; 3]> {
    let mut out = vec![[None; 3]; plant.dof()];
    for (i, parameter) in plant.standard_parameters().iter().enumerate() {
        if let Some((which, row)) = friction_of(*parameter)
            && let Some(j) = plant.rows().iter().position(|r| *r == row)
        {
            out[j][which] = Some(plant.given_drive(i));
        }
    }
    out
}

/// Indices of the base parameters of the rigid arm: all but friction.
pub(in crate::diagnose) fn inertial(plant: &dyn PerturbableArm) -> Vec<usize> {
    let base = plant.base_parameters();
    (0..base.len()).filter(|&b| friction_of(base[b].leader).is_none()).collect()
}

/// Values of the base parameters in the file, with zero friction.
fn given_base(plant: &dyn PerturbableArm) -> Vec<f64> {
    let Some(standard) = plant.given() else { return vec![0.0; plant.base_parameters().len()] };
    plant
        .base_parameters()
        .iter()
        .map(|b| match friction_of(b.leader) {
            Some(_) => 0.0,
            None => b.coefficients.iter().map(|(i, k)| k * standard[*i]).sum(),
        })
        .collect()
}

/// A fitted model.
#[derive(Clone)]
pub struct Fitted {
    /// The least-squares problem.
    pub moments: Moments,
    /// Its solution.
    pub solution: Solution,
    /// Residuals, per joint and window, N m.
    pub residual: Vec<Vec<f64>>,
    /// Autocorrelation time of each joint's residual, windows.
    pub memory: Vec<f64>,
    /// Index of the first friction unknown; three per joint.
    pub friction: usize,
    /// Index of the first unknown of each chosen cause.
    pub first: Vec<usize>,
    /// Terms of each chosen cause.
    pub terms: Vec<Arc<Vec<Term>>>,
    /// Standard parameters of possible bodies with these base parameters, without friction; `None`
    /// if not computed.
    pub standard: Option<Vec<f64>>,
}

impl Fitted {
    /// Covariance of the unknowns.
    pub fn covariance(&self) -> DMatrix<f64> {
        self.moments.covariance(&self.solution, &self.memory)
    }

    /// Viscous, N m s/rad, and Coulomb friction, N m, of a joint: those of the file (`given`) and
    /// the changes.
    pub(in crate::diagnose) fn friction_levels(&self, given: &[Option<f64>; 3], joint: usize) -> [f64; 2] {
        [0, 1].map(|which| given[which].unwrap_or(0.0) + self.solution.x[self.friction + 3 * joint + which])
    }
}

/// Unknowns of local causes: parts of the log where they do not act do not determine them.
pub fn local(chosen: &[Chosen], fitted: &Fitted) -> Vec<usize> {
    let of = chosen.iter().zip(&fitted.first).zip(&fitted.terms).filter(|((c, _), _)| c.cause.local());
    of.flat_map(|((_, first), terms)| *first..first + terms.len()).collect()
}

/// Unknowns of causes whose size is in their shape ([`Hypothesis::unit`]).
pub(in crate::diagnose) fn units(chosen: &[Chosen], fitted: &Fitted) -> Vec<usize> {
    let of = chosen.iter().zip(&fitted.first).zip(&fitted.terms).filter(|((c, _), _)| c.cause.unit());
    of.flat_map(|((_, first), terms)| *first..first + terms.len()).collect()
}

/// Whether a shape that depends on coefficients has converged: to a hundredth of its largest
/// number.
pub(in crate::diagnose) fn near(next: &[f64], shape: &[f64]) -> bool {
    let size = shape.iter().fold(1e-9_f64, |most, s| most.max(s.abs()));
    next.len() == shape.len() && next.iter().zip(shape).all(|(a, b)| (a - b).abs() <= 0.01 * size)
}

/// Key of a set of terms: cause, place, bits of the shape.
type Key = (&'static str, Vec<usize>, Vec<u64>);

/// Cache of terms by cause, place and shape, of limited size.
#[derive(Default)]
struct Known {
    terms: HashMap<Key, Arc<Vec<Term>>>,
    /// Numbers stored in their series.
    held: usize,
}

impl Known {
    /// Drops terms that act on the `moved` joints.
    fn forget(&mut self, moved: &[bool]) {
        self.terms.retain(|_, terms| terms.iter().flat_map(|t| &t.column.rows).all(|(joint, _)| !moved[*joint]));
        self.held = self.terms.values().map(|terms| size(terms)).sum();
    }

    /// Maximum number of stored values: 16 MB. The first entries stay, because a search evaluates
    /// all candidates in each round.
    const MOST: usize = 2 << 20;

    fn keep(&mut self, key: Key, terms: &Arc<Vec<Term>>) {
        let size = size(terms);
        if self.held + size <= Self::MOST && self.terms.insert(key, terms.clone()).is_none() {
            self.held += size;
        }
    }
}

/// Numbers in the series of some terms.
fn size(terms: &[Term]) -> usize {
    terms.iter().flat_map(|t| &t.column.rows).map(|(_, series)| series.len()).sum()
}

/// A model under test: the data, the unknowns, and what is fixed or known about them.
pub struct ModelUnderTest<'a> {
    /// The arm.
    pub plant: &'a dyn PerturbableArm,
    /// The logs.
    pub recordings: &'a [Recording],
    /// Windows per second.
    pub rate: f64,
    /// Unknowns of the rigid arm.
    pub mode: Mode,
    /// Windowed data on which causes are evaluated.
    pub scene: WindowedData<'a>,
    /// Friction parameters (three per joint) that are fixed at the file's values.
    pub frozen: Vec<bool>,
    /// Friction parameters that are fitted but not reported: too small or too uncertain to be
    /// named.
    pub quiet: Vec<bool>,
    /// Friction parameters that changed independently of any friction law found on their joint.
    pub separate: Vec<bool>,
    /// Prior at the file's values for directions that the motion does not determine; built at the
    /// first fit.
    pub regulariser: Option<Regulariser>,
    /// Torque errors of each joint due to errors of the recorded motion, N m; empty if unknown.
    pub motion_error: Vec<f64>,
    /// Whether every window counts.
    all: bool,
    /// Cached terms of families that depend on the motion alone.
    known: Mutex<Known>,
    /// Equations in the unknowns of the rigid arm and friction alone: in interleaved pieces, and in
    /// contiguous stretches.
    ground: [OnceLock<Moments>; 2],
    /// Columns of the rigid arm's unknowns, where it is fitted.
    base: Vec<Column>,
    /// Columns of friction, three per joint; empty where every sample counts.
    friction: Vec<Column>,
    y: Vec<Vec<f64>>,
}

impl<'a> ModelUnderTest<'a> {
    /// A model on these recordings. `all`: every window counts, as in the final evaluation.
    pub fn new(
        plant: &'a dyn PerturbableArm,
        recordings: &'a [Recording],
        rate: f64,
        mode: Mode,
        delays: &[f64],
        all: bool,
    ) -> Self {
        let scene = WindowedData::new(plant, recordings, rate, delays, all);
        let (frozen, quiet) = (vec![false; 3 * plant.dof()], vec![false; 3 * plant.dof()]);
        let (base, friction, y) = Default::default();
        let mut tested = Self {
            plant,
            recordings,
            rate,
            mode,
            scene,
            frozen,
            quiet,
            separate: vec![false; 3 * plant.dof()],
            regulariser: None,
            motion_error: Vec::new(),
            all,
            known: Mutex::default(),
            ground: Default::default(),
            base,
            friction,
            y,
        };
        tested.scene.set_model(given_base(plant), plant.given().map(|s| without_friction(plant, s)));
        let (all, count) = (vec![true; plant.dof()], inertial(plant).len());
        tested.base = if tested.refits_here() { vec![Column::default(); count] } else { Vec::new() };
        tested.y = vec![Vec::new(); plant.dof()];
        tested.prepare(&all);
        tested
    }

    /// Whether the columns of the rigid arm's unknowns are stored. A model that only predicts
    /// accumulates them on the fly.
    fn refits_here(&self) -> bool {
        self.mode == Mode::Refitted && !self.all
    }

    /// Computes the columns of the `moved` joints that do not depend on the found causes.
    fn prepare(&mut self, moved: &[bool]) {
        self.ground = Default::default();
        let mut friction = std::mem::take(&mut self.friction);
        let (scene, plant) = (&self.scene, self.plant);
        if !self.all {
            friction.resize(3 * scene.dof(), Column::default());
            for j in (0..scene.dof()).filter(|&j| moved[j]) {
                friction[3 * j..3 * j + 3].clone_from_slice(&friction_columns(scene, j));
            }
        }
        let mut base = std::mem::take(&mut self.base);
        if self.refits_here() {
            let wanted = inertial(plant);
            base.iter_mut().for_each(|column| column.rows.retain(|(j, _)| !moved[*j]));
            for (j, entries) in scene.base_rows(moved).into_iter().enumerate() {
                for (b, mut series) in entries {
                    scene.masked(j, &mut series);
                    if let Some(at) = wanted.iter().position(|w| *w == b)
                        && series.iter().any(|x| *x != 0.0)
                    {
                        base[at].rows.push((j, Arc::new(series)));
                    }
                }
            }
            base.iter_mut().for_each(|column| column.rows.sort_by_key(|row| row.0));
        }
        (self.base, self.friction) = (base, friction);
        let fresh = self.unexplained_by_file(moved);
        for (j, y) in fresh.into_iter().enumerate().filter(|(j, _)| moved[*j]) {
            self.y[j] = y;
        }
    }

    /// Torque of the `moved` joints, N m, without the file's friction, and in mode `Trusted`
    /// without its rigid torque.
    fn unexplained_by_file(&self, moved: &[bool]) -> Vec<Vec<f64>> {
        let (scene, plant) = (&self.scene, self.plant);
        let (given, base) = (given_friction(plant), given_base(plant));
        let rigid = match self.mode {
            Mode::Trusted if base.iter().any(|b| *b != 0.0) => scene.base_torques(&base, moved),
            _ => vec![vec![0.0; scene.len]; scene.dof()],
        };
        let of = |j: usize| {
            let mut y = scene.y[j].to_vec();
            let friction = self.plain(j);
            let series = y.iter_mut().zip(&rigid[j]).zip(&scene.live[j]);
            series.for_each(|((y, r), live)| *y -= if *live { *r } else { 0.0 });
            for which in 0..3 {
                let value = given[j][which].unwrap_or(0.0);
                if value != 0.0
                    && let Some((_, series)) = friction[which].rows.first()
                {
                    y.iter_mut().zip(&**series).for_each(|(y, s)| *y -= value * s);
                }
            }
            y
        };
        (0..scene.dof()).map(|j| if moved[j] { of(j) } else { Vec::new() }).collect()
    }

    /// Friction columns of a joint.
    fn plain(&self, j: usize) -> [Column; 3] {
        match self.friction.get(3 * j..3 * j + 3) {
            Some(held) => std::array::from_fn(|which| held[which].clone()),
            None => friction_columns(&self.scene, j),
        }
    }

    /// Torque to be explained, N m: the measured one without the parts taken from the file.
    pub fn target(&self) -> &[Vec<f64>] {
        &self.y
    }

    /// Shifts the torques of these joints, or of all if the list is empty, by a further delay, s.
    fn delay(&mut self, joints: &[usize], by: f64) {
        let mut delays = self.scene.delays.clone();
        let own = |j: usize| joints.is_empty() || joints.contains(&j);
        delays.iter_mut().enumerate().filter(|(j, _)| own(*j)).for_each(|(_, delay)| *delay += by);
        self.set_delays(&delays);
    }

    /// Sets the delay of each joint's torque relative to the motion, s, and recomputes dependent
    /// data.
    pub fn set_delays(&mut self, delays: &[f64]) {
        let moved: Vec<bool> = self.scene.delays.iter().zip(delays).map(|(a, b)| a != b).collect();
        if !moved.contains(&true) {
            return;
        }
        self.scene.delayed_by(self.recordings, self.rate, delays);
        self.known.get_mut().unwrap_or_else(PoisonError::into_inner).forget(&moved);
        self.prepare(&moved);
    }

    /// Terms of a chosen cause for the present state of the scene.
    pub fn terms(&self, chosen: &Chosen) -> Arc<Vec<Term>> {
        self.family(chosen.cause, &chosen.place, &chosen.shape)
    }

    /// Terms of a cause; cached where they depend on the motion alone.
    pub fn family(&self, cause: &'static dyn Hypothesis, place: &[usize], shape: &[f64]) -> Arc<Vec<Term>> {
        let rests = cause.rests_on_model()
            && (self.mode == Mode::Refitted || cause.rests_on_friction() || cause.finite_difference());
        // Intervals of local causes differ from trial to trial: not cached.
        if rests || self.all || cause.local() {
            return Arc::new(cause.terms(&self.scene, place, shape));
        }
        let key = (cause.name(), place.to_vec(), shape.iter().map(|s| s.to_bits()).collect());
        let lock = || self.known.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(found) = lock().terms.get(&key) {
            return found.clone();
        }
        let made = Arc::new(cause.terms(&self.scene, place, shape));
        lock().keep(key, &made);
        made
    }

    /// Frees caches after a search.
    pub fn forget(&mut self) {
        self.known = Mutex::default();
        self.scene.forget();
    }

    /// Fits rigid arm (where unknown), friction and the chosen causes together. Families of finite
    /// differences are recomputed about the estimate until it converges. So are all terms that
    /// depend on the rigid model.
    pub fn fit(&mut self, chosen: &mut [Chosen]) -> Fitted {
        if self.regulariser.is_none() {
            self.regulariser = Some(self.held(&[]));
        }
        let mut weights: Option<Vec<f64>> = None;
        for round in 0.. {
            let fitted = self.fit_once(chosen, weights.as_deref());
            weights = Some(fitted.solution.weights.clone());
            let mut converged = true;
            for (i, c) in chosen.iter_mut().enumerate() {
                let before = c.x.clone();
                c.x = (0..fitted.terms[i].len()).map(|t| fitted.solution.x[fitted.first[i] + t]).collect();
                if c.cause.finite_difference() && !c.x.is_empty() {
                    let x = c.x[0];
                    if c.cause.moves_time() {
                        // Smaller delays are treated as linear.
                        if x.abs() > LINEAR && x.is_finite() {
                            converged = false;
                            self.delay(&c.place, x.clamp(-0.05, 0.05));
                            c.shape[0] = 1e-3;
                        }
                    } else if x != 0.0 && (x / c.shape[0] - 1.0).abs() > 1e-3 {
                        c.shape[0] = x;
                        converged = false;
                    }
                }
                if let Some(next) = c.cause.follows(&fitted.terms[i], &c.x)
                    && !near(&next, &c.shape)
                {
                    c.shape = next;
                    converged = false;
                }
                if c.cause.rests_on_model() && !c.cause.moves_time() && before != c.x {
                    let size = c.x.iter().map(|x| x.abs()).fold(1e-12, f64::max);
                    let change = before.iter().zip(&c.x).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                    converged &= before.len() == c.x.len() && change < 1e-3 * size;
                }
            }
            self.update_model(&fitted);
            let rests = self.mode == Mode::Refitted && chosen.iter().any(|c| c.cause.rests_on_model());
            if (converged && !(rests && round < 2)) || round >= 6 {
                return fitted;
            }
        }
        unreachable!("the loop returns")
    }

    /// Refines sizes that are part of a law's shape ([`Hypothesis::unit`]) by Gauss-Newton steps
    /// with everything else refitted; then the numbers of all other shapes.
    pub fn polish(&mut self, chosen: &mut [Chosen]) -> Fitted {
        let mut fitted = self.fit(chosen);
        for index in (0..chosen.len()).filter(|&i| chosen[i].cause.unit()).collect::<Vec<usize>>() {
            let off = |c: &Chosen| ((c.x.first().copied().unwrap_or(0.0) - 1.0) / UNIT).powi(2);
            let misfit = |fitted: &Fitted, c: &Chosen| misfit(fitted) + off(c);
            for _ in 0..4 {
                let Some(step) = self.newton(&fitted, chosen, index) else { break };
                let known = misfit(&fitted, &chosen[index]);
                let better = [1.0, 0.4, 0.15].into_iter().find_map(|share| {
                    let mut trial = chosen.to_vec();
                    let numbers = trial[index].cause.shape();
                    for ((value, by), number) in trial[index].shape.iter_mut().zip(&step).zip(numbers) {
                        let next = (*value + share * by).clamp(0.6 * *value, 1.6 * *value);
                        *value = next.clamp(number.range[0], number.range[1]);
                    }
                    let next = self.fit(&mut trial);
                    (misfit(&next, &trial[index]) < known).then_some((trial, next))
                });
                let Some((trial, next)) = better else { break };
                let gained = known - misfit(&next, &trial[index]);
                chosen.clone_from_slice(&trial);
                fitted = next;
                if gained < 0.1 {
                    break;
                }
            }
        }
        let fitted = self.polish_shapes(chosen, fitted);
        // Restore the scene's model, which is that of the last trial.
        self.update_model(&fitted);
        fitted
    }

    /// Gauss-Newton step of the numbers of one law's shape, with the prior that its coefficient is
    /// 1 within [`UNIT`].
    fn newton(&self, fitted: &Fitted, chosen: &[Chosen], index: usize) -> Option<Vec<f64>> {
        let (c, own) = (&chosen[index], fitted.first[index]);
        let columns: Option<Vec<Column>> = (0..c.shape.len())
            .map(|k| {
                let first = c.cause.shape()[k].step?;
                derivative(self, fitted, index, c, k, first)
            })
            .collect();
        let columns = columns.filter(|columns| !columns.is_empty() && !c.x.is_empty())?;
        let columns: Vec<&Column> = columns.iter().collect();
        let solution = fitted.moments.with(&columns).solve(Some(&fitted.solution.weights));
        let known = (1.0 - solution.x[own]) / (solution.inverse[(own, own)].max(0.0) + UNIT * UNIT);
        let behind = fitted.solution.x.len();
        let step: Vec<f64> =
            (0..columns.len()).map(|k| solution.x[behind + k] + solution.inverse[(behind + k, own)] * known).collect();
        step.iter().all(|s| s.is_finite()).then_some(step)
    }

    fn fit_once(&self, chosen: &[Chosen], weights: Option<&[f64]>) -> Fitted {
        let threads = threads_for(self.scene.len * self.scene.dof());
        let terms = parallel(threads, chosen.len(), |i| self.terms(&chosen[i]));
        let (moments, first) = self.equations(&terms, false);
        let friction = self.base.len();
        let solution = moments.solve(weights);
        let residual = moments.residual(&solution.x);
        let memory = self.memory(&residual);
        let fitted = Fitted { moments, solution, residual, memory, friction, first, terms, standard: None };
        self.with_possible_bodies(chosen, fitted)
    }

    /// Autocorrelation time of each joint's residual, windows.
    pub(super) fn memory(&self, residual: &[Vec<f64>]) -> Vec<f64> {
        let threads = threads_for(self.scene.len * residual.len());
        parallel(threads, residual.len(), |j| autocorrelation_time(&residual[j], &self.scene.live[j]))
    }

    /// Equations in the unknowns of the rigid arm, friction and the causes with these terms, in pieces
    /// or in stretches. Also returns the index of each cause's first unknown.
    fn equations(&self, terms: &[Arc<Vec<Term>>], stretches: bool) -> (Moments, Vec<usize>) {
        let ground = self.ground[usize::from(stretches)].get_or_init(|| {
            let columns: Vec<&Column> = self.base.iter().chain(&self.friction).collect();
            let len = self.scene.len.max(1);
            let spans: Vec<usize> = (0..self.scene.len).map(|w| w * BLOCKS / len).collect();
            Moments::new(&self.scene, if stretches { &spans } else { &self.scene.block }, &self.y, &columns)
        });
        let (mut columns, mut first) = (Vec::new(), Vec::new());
        for term in terms {
            first.push(ground.unknowns + columns.len());
            columns.extend(term.iter().map(|t| &t.column));
        }
        let free = |k: usize| k.checked_sub(self.base.len()).is_some_and(|k| self.frozen.get(k) == Some(&true));
        let mut moments = ground.without(free).with(&columns);
        moments.regularised_by(self.holding());
        (moments, first)
    }

    /// The regulariser without fixed friction parameters.
    fn holding(&self) -> Regulariser {
        let frozen = |k: usize| k.checked_sub(self.base.len()).is_some_and(|k| self.frozen.get(k) == Some(&true));
        self.regulariser.as_ref().map_or_else(Regulariser::none, |regulariser| regulariser.without(frozen))
    }

    /// Removes the regulariser from these joints' friction. Beside a slow error the data seem to
    /// determine little of it; beside the cause of that error they may determine it.
    pub fn release_joints(&mut self, joints: &[usize]) {
        let base = self.base.len();
        let own = |k: usize| k.checked_sub(base).is_some_and(|k| joints.contains(&(k / 3)));
        self.regulariser = self.regulariser.take().map(|regulariser| regulariser.without(own));
    }

    /// Fits with a regulariser for the directions that the data do not determine beside these
    /// causes. The error of a missing cause is slow, and beside it a joint's parameters seem poorly
    /// determined.
    pub fn fit_regularised_beside(&mut self, chosen: &mut [Chosen]) -> Fitted {
        self.regulariser = Some(Regulariser::none());
        self.regulariser = Some(self.held(chosen));
        self.fit(chosen)
    }

    /// The regulariser of base parameters and friction, chosen while these causes are fitted too.
    fn held(&self, chosen: &[Chosen]) -> Regulariser {
        let wanted = if self.mode == Mode::Refitted { inertial(self.plant) } else { Vec::new() };
        let torque: Vec<f64> = self.scene.y.iter().map(|y| root_mean_square(y)).collect();
        let Some(prior) = prior(self.plant, &wanted, &torque) else { return Regulariser::none() };
        let free = self.fit_once(chosen, None);
        let weights = &free.solution.weights;
        let thinned: Vec<f64> = weights.iter().zip(&free.memory).map(|(w, m)| w / m).collect();
        let (full, thinned) = (free.moments.information(weights), free.moments.information(&thinned));
        let mut stretches = self.stretches(&free);
        let counts = stretches.counts();
        let ground: Vec<f64> = torque.iter().map(|t| 0.004 * t).collect();
        let mut best: Option<(Regulariser, LeftOut)> = None;
        for regulariser in STRENGTHS.iter().filter_map(|strength| Regulariser::new(&prior, &full, &thinned, *strength))
        {
            stretches.regularised_by(regulariser.clone());
            let sums = stretches.cross_validated_without(&free.solution, &[], &local(chosen, &free));
            let left = LeftOut::new(&sums, &counts);
            if best.as_ref().is_none_or(|(_, known)| left.less(known, &ground).gain > 0.0) {
                best = Some((regulariser, left));
            }
        }
        best.map_or_else(Regulariser::none, |b| b.0)
    }

    /// The equations of a fit in stretches that can be left out: eighths of the data, each in one
    /// piece. Their terms are those that were fitted: with the model that came of it a law that rests
    /// on the model may have fewer.
    pub fn stretches(&self, fitted: &Fitted) -> Moments {
        self.equations(&fitted.terms, true).0
    }

    /// Errors of the fitted model on stretches that were left out in turn.
    pub fn left_out(&self, chosen: &[Chosen], fitted: &Fitted) -> LeftOut {
        let stretches = self.stretches(fitted);
        let fixed = local(chosen, fitted);
        let bodies = self.changed_bodies(chosen, fitted);
        let sums = if bodies.is_empty() {
            stretches.cross_validated_without(&fitted.solution, &[], &fixed)
        } else {
            let share = independent_share(&fitted.solution.counts, &fitted.memory);
            let limit = |x: &DVector<f64>, inverse: &DMatrix<f64>| possible_values(&bodies, x, inverse, share);
            stretches.cross_validated_within(&fitted.solution, &fixed, limit)
        };
        LeftOut::new(&sums, &stretches.counts())
    }

    /// Errors of the unchanged file on the same stretches.
    pub fn file_left_out(&self) -> LeftOut {
        let (mut sums, mut counts) =
            (vec![vec![0.0; self.scene.dof()]; BLOCKS], vec![vec![0.0; self.scene.dof()]; BLOCKS]);
        for j in 0..self.scene.dof() {
            for w in (0..self.scene.len).filter(|&w| self.scene.live[j][w]) {
                let span = w * BLOCKS / self.scene.len;
                sums[span][j] += self.y[j][w].powi(2);
                counts[span][j] += 1.0;
            }
        }
        LeftOut::new(&sums, &counts)
    }

    /// Restores the delays and the scene's model, which are those of the last fit, to those of an
    /// earlier one.
    pub(in crate::diagnose) fn restore(&mut self, delays: &[f64], fitted: &Fitted) {
        self.set_delays(delays);
        self.update_model(fitted);
    }

    /// Updates the scene's rigid model, and the torque with friction, from a fit.
    pub(in crate::diagnose) fn update_model(&mut self, fitted: &Fitted) {
        if self.mode == Mode::Refitted {
            let mut beta = vec![0.0; self.plant.base_parameters().len()];
            for (at, b) in inertial(self.plant).into_iter().enumerate() {
                beta[b] = fitted.solution.x[at];
            }
            let file = || self.plant.given().map(|s| without_friction(self.plant, s));
            let nearest = || recover_standard(self.plant, &beta, file().as_deref()).ok();
            let standard = fitted.standard.clone().or_else(nearest);
            self.scene.set_model(beta, standard);
        }
        let given = given_friction(self.plant);
        for j in 0..self.scene.dof() {
            let [fv, fc] = fitted.friction_levels(&given[j], j);
            // A fitted offset belongs to the sensor: neither the gear nor the gain includes it.
            let fo = given[j][2].unwrap_or(0.0);
            let with_rigid = |fc: f64| -> Vec<f64> {
                let own = self.scene.own[j].iter();
                let friction = own.map(|own| self.scene.average_of(own, |k| fv * own.v[k] + fc * own.sign[k] + fo));
                let mut torque = self.scene.joined(friction);
                torque.iter_mut().zip(&*self.scene.rigid[j]).for_each(|(f, r)| *f += r);
                torque
            };
            let (whole, smooth) = (with_rigid(fc), with_rigid(0.0));
            (self.scene.whole[j], self.scene.smooth[j]) = (Arc::new(whole), Arc::new(smooth));
        }
    }

    /// Takes the rigid model and the friction of another fitted model.
    pub fn adopt(&mut self, other: &ModelUnderTest<'_>, fitted: &Fitted) {
        self.scene.set_model(other.scene.beta.clone(), other.scene.standard.clone());
        let keep = self.mode;
        self.mode = Mode::Trusted;
        self.update_model(fitted);
        self.mode = keep;
    }

    /// Torques predicted with unknowns `x` (in the order of the fit), beyond the file's part, per
    /// joint, N m: the target less this is the error.
    pub fn predict(&self, x: &DVector<f64>, chosen: &[Chosen]) -> Vec<Vec<f64>> {
        let mut rows = vec![vec![0.0; self.scene.len]; self.scene.dof()];
        let threads = threads_for(self.scene.len * self.scene.dof());
        let terms = parallel(threads, chosen.len(), |i| self.terms(&chosen[i]));
        let held = if self.all && self.mode == Mode::Refitted { inertial(self.plant) } else { Vec::new() };
        let mut at = held.len();
        if at > 0 {
            let mut base = vec![0.0; self.plant.base_parameters().len()];
            held.iter().zip(x.iter()).for_each(|(b, x)| base[*b] = *x);
            rows = self.scene.base_torques(&base, &vec![true; self.scene.dof()]);
            rows.iter_mut().enumerate().for_each(|(j, row)| self.scene.masked(j, row));
        }
        let mut add = |column: &Column| {
            for (j, series) in &column.rows {
                rows[*j].iter_mut().zip(&**series).for_each(|(r, s)| *r += x[at] * s);
            }
            at += 1;
        };
        self.base.iter().for_each(&mut add);
        (0..self.scene.dof()).for_each(|j| self.plain(j).iter().for_each(&mut add));
        for (chosen, terms) in chosen.iter().zip(&terms) {
            // A family that is not observable in these data keeps its place among the unknowns.
            for k in 0..chosen.x.len() {
                match terms.get(k) {
                    Some(term) => add(&term.column),
                    None => add(&Column::default()),
                }
            }
        }
        rows
    }
}

/// Columns of a joint's plain friction: viscous, Coulomb, offset.
fn friction_columns(scene: &WindowedData<'_>, j: usize) -> [Column; 3] {
    PLAIN.map(|p| p.terms(scene, &[j], &[]).remove(0).column)
}

pub(in crate::diagnose) fn without_friction(plant: &dyn PerturbableArm, standard: &[f64]) -> Vec<f64> {
    plant
        .standard_parameters()
        .iter()
        .zip(standard)
        .map(|(p, value)| if friction_of(*p).is_some() { 0.0 } else { *value })
        .collect()
}
