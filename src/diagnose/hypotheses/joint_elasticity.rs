//! `joint_elasticity`: the measured angle is the motor's, and a spring lies between it and the
//! link.
//!
//! The link oscillates on that spring, excited by the motor's fast motion (it sticks and breaks
//! away at each reversal), and this oscillation distinguishes a spring from all other causes. The
//! column is therefore the link's equation of motion along the recorded motion
//! (`src/numerics/elastic_joint.rs`), and not the static deflection alone. If the motion is too
//! slow to show the oscillation of a stiff spring, that spring is damped so strongly that it
//! deflects with its load.

use dh_codegen::robot::EffectKind;
use dh_codegen::robot::effects;

use super::Estimate;
use super::Hypothesis;
use super::Kind;
use super::Named;
use super::Over;
use super::Shape;
use super::Sign;
use super::Symbol;
use super::Term;
use super::geometric;
use crate::diagnose::windows::windowed_data::{Slopes, WindowedData};
use crate::numerics::elastic_joint::{Deflection, LinkLoad, Spring};
use crate::numerics::median::median;

/// `KE d + DE d'` is the torque on the link at `q - d`.
pub struct JointElasticity;

/// Dynamics of a link behind a spring, over the windows of the data.
struct Link<'s, 'a> {
    scene: &'s WindowedData<'a>,
    joint: usize,
    slopes: std::sync::Arc<Slopes>,
    /// Torque on the link if it moves like its motor, N m.
    load: Vec<f64>,
    /// Correction of the load for the deflection, N m: the arm is not linear in it.
    bent: Vec<f64>,
    /// Inertia of the link about its axis, kg m^2.
    inertia: Vec<f64>,
    /// Median of the inertia, kg m^2.
    usual: f64,
}

impl<'s, 'a> Link<'s, 'a> {
    fn new(scene: &'s WindowedData<'a>, joint: usize) -> Option<Self> {
        if scene.rigid[joint].iter().all(|t| *t == 0.0) {
            return None;
        }
        let (slopes, rotor) = (scene.slopes(joint), scene.rotors[joint]);
        let mut inertia: Vec<f64> = slopes.acceleration[joint].iter().map(|m| m - rotor).collect();
        let usual = median(&mut inertia.clone())?;
        if usual.is_nan() || usual <= 0.0 {
            return None;
        }
        // The inertia of an estimated model may have any value.
        inertia.iter_mut().for_each(|m| *m = m.max(0.05 * usual));
        Some(Self { scene, joint, slopes, load: scene.transmitted(joint), bent: vec![0.0; scene.len], inertia, usual })
    }

    /// The highest resonance observable in the motion, Hz.
    fn highest(&self) -> f64 {
        let filters = self.scene.own[self.joint].iter().filter_map(|own| own.filters.narrow.first());
        filters.map(|filter| SEEN * filter.cutoff).fold(HIGHEST, f64::min)
    }

    /// Whether the motion shows a spring of this resonance, Hz, and damping ratio: its oscillation
    /// or, above the motion's band, its deflection under load.
    fn shows(&self, frequency: f64, ratio: f64) -> bool {
        let highest = self.highest();
        frequency <= highest || frequency <= HIGHEST && ratio >= STILL
    }

    fn asked(&self, run: std::ops::Range<usize>) -> LinkLoad<'_> {
        LinkLoad {
            load: &self.load[run.clone()],
            inertia: &self.inertia[run.clone()],
            damping: &self.slopes.velocity[self.joint][run.clone()],
            stiffness: &self.slopes.position[self.joint][run],
            step: self.scene.step,
        }
    }

    /// Torque of joint `of` due to a deflection.
    fn adds(&self, of: usize, [d, v, a]: &Deflection, run: std::ops::Range<usize>) -> Vec<f64> {
        let Slopes { position, velocity, acceleration } = &*self.slopes;
        let inertia = if of == self.joint { &self.inertia } else { &acceleration[of] };
        run.zip(d.iter().zip(v).zip(a))
            .map(|(w, ((d, v), a))| -(position[of][w] * d + velocity[of][w] * v + inertia[w] * a))
            .collect()
    }

    /// The deflection in each run, starting from quasi-static equilibrium. While a model is fitted,
    /// it starts from the state that explains most of the torque, since the link may oscillate when
    /// a log begins.
    fn wound(&self, spring: Spring) -> Vec<Deflection> {
        let begins = |run: &std::ops::Range<usize>| {
            let asked = self.asked(run.clone());
            let start = spring.quasi_static(&asked);
            let wound = spring.integrate(&asked, start);
            if self.scene.all { wound } else { self.after_a_start(spring, run.clone(), start, wound) }
        };
        self.scene.runs.iter().map(begins).collect()
    }

    fn after_a_start(
        &self,
        spring: Spring,
        run: std::ops::Range<usize>,
        start: [f64; 2],
        wound: Deflection,
    ) -> Deflection {
        let (j, scene, asked) = (self.joint, self.scene, self.asked(run.clone()));
        let nothing = vec![0.0; run.len()];
        let free = LinkLoad { load: &nothing, ..asked };
        // Unit responses: an initial angle, and an initial rate with the same amplitude.
        let rate = (spring.stiffness / self.usual).sqrt();
        let ways = Spring::damped(spring.stiffness, [spring.damping; 2], &free, [[1.0, 0.0], [0.0, rate]]);
        let ways = ways.map(|way| self.adds(j, &way, run.clone()));
        let adds = self.adds(j, &wound, run.clone());
        let (mut n, mut r) = ([[0.0; 2]; 2], [0.0; 2]);
        for (k, w) in run.clone().enumerate().filter(|(_, w)| scene.live[j][*w]) {
            let left = scene.y[j][w] - scene.whole[j][w] - self.bent[w] - adds[k];
            for (a, way) in ways.iter().enumerate() {
                r[a] += way[k] * left;
                (0..2).for_each(|b| n[a][b] += way[k] * ways[b][k]);
            }
        }
        let determinant = n[0][0] * n[1][1] - n[0][1] * n[1][0];
        if determinant <= 1e-6 * n[0][0] * n[1][1] {
            return wound;
        }
        let x = (r[0] * n[1][1] - r[1] * n[0][1]) / determinant;
        let y = (r[1] * n[0][0] - r[0] * n[1][0]) / determinant;
        spring.integrate(&asked, [start[0] + x, start[1] + y * rate])
    }

    /// Decrease of the squared residual of the joint by springs of one resonance, Hz, with these
    /// damping ratios, N^2 m^2 times windows, without the first second.
    fn takes<const N: usize>(&self, frequency: f64, ratios: [f64; N], residual: &[f64]) -> [f64; N] {
        let skip = (1.0 / self.scene.step) as usize;
        let springs = ratios.map(|ratio| self.spring(frequency, ratio));
        let stiffness = springs[0].stiffness;
        let mut gains = [0.0; N];
        for run in &self.scene.runs {
            let asked = self.asked(run.clone());
            let starts = [springs[0].quasi_static(&asked); N];
            let wound = Spring::damped(stiffness, springs.map(|s| s.damping), &asked, starts);
            for (gain, wound) in gains.iter_mut().zip(&wound) {
                let adds = self.adds(self.joint, wound, run.clone());
                for (w, c) in run.clone().zip(&adds).skip(skip.min(run.len() / 3)) {
                    if self.scene.live[self.joint][w] {
                        *gain += (2.0 * residual[w] - c) * c;
                    }
                }
            }
        }
        gains
    }

    /// The spring with this resonance, Hz, and damping ratio.
    fn spring(&self, frequency: f64, ratio: f64) -> Spring {
        let w = std::f64::consts::TAU * frequency;
        Spring { stiffness: w * w * self.usual, damping: 2.0 * ratio * w * self.usual }
    }
}

impl Hypothesis for JointElasticity {
    fn effect(&self) -> EffectKind {
        EffectKind::JointElasticity
    }

    fn kind(&self) -> Kind {
        Kind::Transmission
    }

    fn shape(&self) -> &'static [Shape] {
        &[
            Shape {
                symbol: Symbol::Key(effects::JointElasticity::KE),
                unit: "N m/rad",
                range: [1e-3, 1e9],
                step: Some(0.05),
            },
            Shape {
                symbol: Symbol::Key(effects::JointElasticity::DE),
                unit: "N m s/rad",
                range: [1e-9, 1e6],
                step: Some(0.4),
            },
        ]
    }

    fn shows(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64]) -> bool {
        Link::new(scene, place[0]).is_some_and(|link| {
            let rate = (shape[0] / link.usual).sqrt();
            link.shows(rate / std::f64::consts::TAU, 0.5 * shape[1] / (rate * link.usual))
        })
    }

    /// Spring that explains most of the joint's residual torque: resonances from 0.4 Hz to the
    /// highest observable one, then a finer search about the best of them.
    fn grid(&self, scene: &WindowedData<'_>, place: &[usize], residual: &[Vec<f64>]) -> Vec<Vec<f64>> {
        let Some(link) = Link::new(scene, place[0]) else { return Vec::new() };
        let residual = &residual[place[0]];
        let mut all: Vec<(f64, [f64; 2])> = Vec::new();
        for frequency in geometric(0.4, link.highest().max(0.5), 30) {
            const RATIOS: [f64; 3] = [0.02, 0.08, 0.3];
            let taken = link.takes(frequency, RATIOS, residual).into_iter().zip(RATIOS);
            all.extend(taken.map(|(gain, ratio)| (gain, [frequency, ratio])).max_by(|a, b| a.0.total_cmp(&b.0)));
        }
        for frequency in geometric(link.highest(), HIGHEST, 12).into_iter().skip(1) {
            let [gain] = link.takes(frequency, [WINDS], residual);
            all.push((gain, [frequency, WINDS]));
        }
        // Select the two highest peaks.
        let peak = |i: &usize| {
            let at = |k: usize| all.get(k).map_or(f64::NEG_INFINITY, |a| a.0);
            all[*i].0 > 0.0 && all[*i].0 >= at(i + 1) && (*i == 0 || all[*i].0 >= at(i - 1))
        };
        let mut peaks: Vec<usize> = (0..all.len()).filter(peak).collect();
        peaks.sort_by(|a, b| all[*b].0.total_cmp(&all[*a].0));
        let scaled = |x: f64, step: f64, up: bool| if up { x * (1.0 + step) } else { x / (1.0 + step) };
        let finer = |&i: &usize| {
            let mut best = all[i];
            let mut step = [0.07, 0.5];
            for _ in 0..5 {
                for up in [true, false] {
                    let next = [scaled(best.1[0], step[0], up), best.1[1]];
                    let [gain] = link.takes(next[0], [next[1].max(LEAST)], residual);
                    if gain > best.0 && link.shows(next[0], next[1]) {
                        best = (gain, next);
                        break;
                    }
                }
                let ratios = [true, false].map(|up| scaled(best.1[1], step[1], up));
                let gains = link.takes(best.1[0], ratios.map(|ratio| ratio.max(LEAST)), residual);
                let shown = gains.into_iter().zip(ratios).filter(|(_, ratio)| link.shows(best.1[0], *ratio));
                if let Some((gain, ratio)) = shown.max_by(|a, b| a.0.total_cmp(&b.0)).filter(|(gain, _)| *gain > best.0)
                {
                    best = (gain, [best.1[0], ratio]);
                }
                step = step.map(|s| 0.6 * s);
            }
            let Spring { stiffness, damping } = link.spring(best.1[0], best.1[1].max(LEAST));
            vec![stiffness, damping]
        };
        peaks.iter().take(2).map(finer).collect()
    }

    /// The initial state of the oscillation adds two unknowns.
    fn free(&self, _: &[f64]) -> usize {
        3
    }

    fn unit(&self) -> bool {
        true
    }

    fn terms(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64]) -> Vec<Term> {
        let j = place[0];
        let Some(mut link) = Link::new(scene, j) else { return Vec::new() };
        let least = 2.0 * LEAST * (shape[0] * link.usual).sqrt();
        let spring = Spring { stiffness: shape[0], damping: shape[1].max(least) };
        let linear = |link: &Link<'_, '_>, wound: &[Deflection]| -> Vec<Vec<f64>> {
            let row = |of: usize| {
                let runs = scene.runs.iter().zip(wound);
                runs.flat_map(|(run, wound)| link.adds(of, wound, run.clone())).collect()
            };
            (0..scene.dof()).map(row).collect()
        };
        let mut wound = link.wound(spring);
        let mut rows = linear(&link, &wound);
        if wound.iter().flat_map(|w| &w[0]).any(|d| d.abs() > SMALL) {
            // Repeat with the nonlinear part of the arm's torque.
            let behind: [Vec<f64>; 3] = std::array::from_fn(|k| wound.iter().flat_map(|w| &w[k]).map(|x| -x).collect());
            let mut lacks = scene.moved(j, &behind, 1.0);
            lacks[j].iter_mut().zip(&behind[2]).for_each(|(t, a)| *t -= scene.rotors[j] * a);
            for (lacks, row) in lacks.iter_mut().zip(&rows) {
                lacks.iter_mut().zip(row).for_each(|(a, b)| *a -= b);
            }
            link.load.iter_mut().zip(&lacks[j]).for_each(|(load, more)| *load += more);
            link.bent.clone_from(&lacks[j]);
            wound = link.wound(spring);
            rows = linear(&link, &wound);
            for (row, lacks) in rows.iter_mut().zip(&lacks) {
                row.iter_mut().zip(lacks).for_each(|(a, b)| *a += b);
            }
        }
        vec![Term::new(Symbol::Own("swing"), scene.column(rows), Sign::Positive)]
    }

    fn rests_on_model(&self) -> bool {
        true
    }

    fn rests_on_friction(&self) -> bool {
        true
    }

    /// A gear that deflects by more than a radian under the joint's largest torque is implausible.
    fn plausible(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64], _: &[f64]) -> bool {
        shape[0] * SOFTEST >= scene.rated[place[0]]
    }

    fn named(&self, found: &Estimate<'_>) -> Vec<Named> {
        let both = self.shape().iter().zip(found.shape).zip(&found.shape_std);
        both.map(|((number, value), std)| Named::new(number.symbol, *value, *std)).collect()
    }

    fn over(&self) -> Over {
        Over::Torque
    }

    fn says(&self) -> &'static str {
        "the link follows the measured angle as behind a spring"
    }

    fn shown_by(&self) -> &'static str {
        "high accelerations with a payload, or the joint's resonance in a chirp"
    }
}

/// Least damping ratio, as in the law of the file.
const LEAST: f64 = dh_codegen::drive::LEAST_DAMPING;
/// Share of the low-pass's cutoff above which no resonance is searched. An oscillation there is
/// excited by motion that the low-pass removed, and resembles that removed motion.
const SEEN: f64 = 0.7;
/// Damping ratio of a spring that deflects with its load without oscillation, and the least one of
/// a spring above the band. The inertia used with it is that of each log.
const WINDS: f64 = 0.7;
const STILL: f64 = 0.35;
/// The highest resonance in the search, Hz.
const HIGHEST: f64 = 45.0;
/// The largest deflection of a gear under the joint's largest torque, rad.
const SOFTEST: f64 = 1.0;
/// Deflection, rad, above which the arm is not treated as linear in it.
const SMALL: f64 = 3e-3;
