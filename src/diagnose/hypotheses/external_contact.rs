//! `external_contact`: an external wrench during a part of the log, constant in the axes of the
//! tool or of the base.

use std::ops::Range;

use dh_codegen::robot::EffectKind;
use dh_codegen::robot::effects;
use nalgebra::{Matrix3, Vector3};

use super::Estimate;
use super::Hypothesis;
use super::Kind;
use super::Named;
use super::Over;
use super::Scope;
use super::Shape;
use super::Sign;
use super::Symbol;
use super::Term;
use crate::diagnose::windows::windowed_data::{Column, WindowedData, parts};
use crate::numerics::median::median;

/// A wrench on the tool between `start` and `end` (seconds of used data, over all logs), constant in
/// the tool's axes or, with `base` 1, in those of the base. Without `moment` it is a force at the
/// origin of the tool's frame. With `swell` it rises until the middle and falls from there on, as a
/// push of a hand does.
pub struct ExternalContact;

/// Distance from an end of a recording, s, within which a push must be longer than [`SHORT`], s.
const NEAR_END: f64 = 0.3;
const SHORT: f64 = 1.0;

/// Least duration, s: anything shorter is an impact, not a sustained force.
pub(in crate::diagnose) const BRIEFEST: f64 = 0.25;

/// Least duration of a push with a moment, s. At a single posture a wrench fits any error of six
/// joints.
const WITH_MOMENT: f64 = 0.5;

/// Largest moment of a push about the joints, as a multiple of the largest motor torque.
const LARGEST: f64 = 2.0;

/// Length of the constant push that a swelling one resembles, as a share of its own.
const CONSTANT: f64 = 2.0 / 3.0;

/// Longest push that rises and falls, s: anything longer is a slow error.
const LONGEST_SWELL: f64 = 2.0;

/// Number of stretches of the log that are tried.
const TRIED: usize = 6;

impl Hypothesis for ExternalContact {
    fn effect(&self) -> EffectKind {
        EffectKind::ExternalContact
    }

    fn kind(&self) -> Kind {
        Kind::Outside
    }

    fn scope(&self) -> Scope {
        Scope::Robot
    }

    fn shape(&self) -> &'static [Shape] {
        &[
            Shape {
                symbol: Symbol::Key(effects::ExternalContact::START),
                unit: "s",
                range: [0.0, 1e9],
                step: Some(-0.12),
            },
            Shape {
                symbol: Symbol::Key(effects::ExternalContact::END),
                unit: "s",
                range: [0.0, 1e9],
                step: Some(-0.12),
            },
            Shape { symbol: Symbol::Own("base"), unit: "", range: [0.0, 1.0], step: None },
            Shape { symbol: Symbol::Own("moment"), unit: "", range: [0.0, 1.0], step: None },
            Shape { symbol: Symbol::Own("swell"), unit: "", range: [0.0, 1.0], step: None },
        ]
    }

    /// Stretches in which a constant force would take more of the residual than elsewhere.
    fn grid(&self, scene: &WindowedData<'_>, _: &[usize], residual: &[Vec<f64>]) -> Vec<Vec<f64>> {
        let mut found: Vec<Push> = [0.0, 1.0].into_iter().flat_map(|base| pushes(scene, residual, base)).collect();
        found.sort_by(|a, b| b.worth.total_cmp(&a.worth));
        found.truncate(TRIED);
        let shape = |p: &Push, [moment, swell]: [f64; 2]| {
            let [start, end] = if swell == 1.0 { swelling(scene, &p.windows) } else { ends(scene, &p.windows) };
            vec![start, end, p.base, moment, swell]
        };
        let laws = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
        found.iter().flat_map(|p| laws.map(|law| shape(p, law))).collect()
    }

    /// Very short contacts are impacts. Short ones at an end of a recording are presliding
    /// deflection or a settling low-pass. A push does not continue in the next recording.
    fn shows(&self, scene: &WindowedData<'_>, _: &[usize], shape: &[f64]) -> bool {
        let [start, end] = [shape[0], shape[1]];
        let inside = |[first, last]: [f64; 2]| start > first - 0.5 * scene.step && end < last + 0.5 * scene.step;
        let Some([first, last]) = scene.runs.iter().map(|run| ends(scene, run)).find(|run| inside(*run)) else {
            return false;
        };
        let swells = swells(shape);
        if swells && end - start > LONGEST_SWELL {
            return false;
        }
        let lead = if swells { 0.5 * (1.0 - CONSTANT) * (end - start) } else { 0.0 };
        let [start, end] = [start + lead, end - lead];
        let at_an_end = start < first + NEAR_END || end > last - NEAR_END;
        let least = if shape[3] == 1.0 { WITH_MOMENT } else { BRIEFEST };
        end - start >= least && (end - start > SHORT || !at_an_end)
    }

    fn terms(&self, scene: &WindowedData<'_>, _: &[usize], shape: &[f64]) -> Vec<Term> {
        let window = |t: f64| ((t / scene.step).round() as usize).min(scene.len);
        let (start, end) = (window(shape[0]), window(shape[1]));
        if start + 4 > end {
            return Vec::new();
        }
        let unit = scene.wrenches(start..end, shape[2] == 1.0);
        let len = end - start;
        let dof = scene.dof();
        let middle = |w: usize| ((w as f64 + 0.5) * scene.step - shape[0]) / (shape[1] - shape[0]);
        let swelling = |w: usize| (std::f64::consts::PI * middle(w).clamp(0.0, 1.0)).sin().powi(2);
        let share: Vec<f64> = (start..end).map(|w| if swells(shape) { swelling(w) } else { 1.0 }).collect();
        effects::ExternalContact::WRENCH
            .into_iter()
            .enumerate()
            .filter(|(c, _)| shape[3] == 1.0 || *c < 3)
            .filter_map(|(c, key)| {
                let rows = (0..dof)
                    .map(|j| {
                        let mut row = vec![0.0; scene.len];
                        for w in start..end {
                            row[w] = -share[w - start] * unit[(c * dof + j) * len + w - start];
                        }
                        row
                    })
                    .collect();
                let column: Column = scene.column(rows);
                (!column.rows.is_empty()).then(|| Term::new(key, column, Sign::Any))
            })
            .collect()
    }

    fn plausible(&self, scene: &WindowedData<'_>, _: &[usize], _: &[f64], x: &[f64]) -> bool {
        let most = LARGEST * scene.rated.iter().copied().fold(0.0, f64::max);
        x.iter().all(|x| x.abs() * scene.reach().min(1.0) <= most)
    }

    fn law(&self, shape: &[f64]) -> usize {
        (shape[3] + 2.0 * shape[4]) as usize
    }

    fn local(&self) -> bool {
        true
    }

    fn acts(&self, shape: &[f64]) -> Option<[f64; 2]> {
        Some([shape[0], shape[1]])
    }

    /// Successive pushes, in any of the logs.
    fn most(&self) -> usize {
        4
    }

    fn named(&self, found: &Estimate<'_>) -> Vec<Named> {
        let time = &found.scene.time;
        let at = |t: f64| time.get((t / found.scene.step).round() as usize).or(time.last()).copied().unwrap_or(0.0);
        let ends = [
            Named::new(effects::ExternalContact::START, at(found.shape[0]), None),
            Named::new(effects::ExternalContact::END, at(found.shape[1]), None),
        ];
        let half = 0.5 * (ends[1].value - ends[0].value);
        let rise = swells(found.shape).then(|| Named::new(effects::ExternalContact::RISE, half, None));
        let base = (found.shape[2] == 1.0).then(|| Named::new(effects::ExternalContact::BASE, 1.0, None));
        ends.into_iter().chain(rise).chain(found.all_terms()).chain(base).collect()
    }

    fn over(&self) -> Over {
        Over::Time
    }

    fn says(&self) -> &'static str {
        "a force acts on the arm during part of the recording"
    }

    fn says_of(&self, shape: &[f64]) -> &'static str {
        match (shape[2] == 1.0, swells(shape)) {
            (true, false) => "a force acts on the arm during part of the recording, constant in the base's axes",
            (false, false) => "a force acts on the arm during part of the recording, constant in the tool's axes",
            (true, true) => {
                "a force acts on the arm during part of the recording, rising and falling along one direction of the base's axes"
            }
            (false, true) => {
                "a force acts on the arm during part of the recording, rising and falling along one direction of the tool's axes"
            }
        }
    }

    fn shown_by(&self) -> &'static str {
        "the same motion in free space"
    }
}

/// A stretch of a log in which a constant force may act.
struct Push {
    windows: Range<usize>,
    /// 1 if it is constant in the axes of the base, else 0.
    base: f64,
    /// Its gain there relative to that of a force in most other stretches of the same length.
    worth: f64,
}

/// Whether a push rises to its middle and falls from there on.
pub(in crate::diagnose) fn swells(shape: &[f64]) -> bool {
    shape.get(4) == Some(&1.0)
}

/// Begin and end of a range of windows, s.
fn ends(scene: &WindowedData<'_>, windows: &Range<usize>) -> [f64; 2] {
    [windows.start, windows.end].map(|w| w as f64 * scene.step)
}

/// Begin and end of a swelling push that resembles a constant one in these windows, within their
/// recording, s.
fn swelling(scene: &WindowedData<'_>, windows: &Range<usize>) -> [f64; 2] {
    let [start, end] = ends(scene, windows);
    let lead = 0.5 * (1.0 / CONSTANT - 1.0) * (end - start);
    let run = scene.runs.iter().find(|run| run.start <= windows.start && windows.end <= run.end);
    let [first, last] = run.map_or([start, end], |run| ends(scene, run));
    [(start - lead).max(first), (end + lead).min(last)]
}

/// The best stretch of each length. Its gain is compared with the upper quartile of all stretches
/// of the same length, and penalised by their number.
fn pushes(scene: &WindowedData<'_>, residual: &[Vec<f64>], base: f64) -> Vec<Push> {
    let (n, dof) = (scene.len, scene.dof());
    let weight: Vec<f64> = residual.iter().map(|row| quiet(row)).collect();
    let mut sums: Vec<(Matrix3<f64>, Vector3<f64>)> = Vec::with_capacity(n + 1);
    let mut sum = (Matrix3::zeros(), Vector3::zeros());
    sums.push(sum);
    for part in parts(n) {
        let unit = scene.wrenches(part.clone(), base == 1.0);
        for w in part.clone() {
            for j in (0..dof).filter(|&j| scene.live[j][w]) {
                let row = Vector3::from_fn(|c, _| -unit[(c * dof + j) * part.len() + w - part.start]);
                sum.0 += weight[j] * row * row.transpose();
                sum.1 += weight[j] * residual[j][w] * row;
            }
            sums.push(sum);
        }
    }
    let least = sum.0.trace() * 1e-6 / n.max(1) as f64;
    let gain = |start: usize, length: usize| {
        let (normal, right) = (sums[start + length].0 - sums[start].0, sums[start + length].1 - sums[start].1);
        let normal = normal + Matrix3::identity() * (least * length as f64 + f64::MIN_POSITIVE);
        normal.cholesky().map_or(0.0, |l| right.dot(&l.solve(&right)))
    };
    let mut found = Vec::new();
    let mut length = (BRIEFEST / scene.step).ceil().max(4.0) as usize;
    while length <= n / 2 {
        let starts =
            |run: &Range<usize>| (run.start..(run.end + 1).saturating_sub(length)).step_by((length / 8).max(1));
        let mut all: Vec<(f64, usize)> =
            scene.runs.iter().flat_map(starts).map(|start| (gain(start, length), start)).collect();
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        let possible = |start: usize| {
            let [from, to] = [start, start + length].map(|w| w as f64 * scene.step);
            ExternalContact.shows(scene, &[], &[from, to, base, 0.0, 0.0])
        };
        if let Some(&(gain, start)) = all.iter().rev().find(|(_, start)| possible(*start)) {
            let usual = all[all.len() * 3 / 4].0 * (1.0 + n as f64 / length as f64).ln();
            let worth = gain / usual.max(f64::MIN_POSITIVE);
            found.push(Push { windows: start..start + length, base, worth });
        }
        length = (length * 4 / 3).max(length + 1);
    }
    found
}

/// Inverse of the median of a joint's squared residual, which a short push does not affect.
pub(super) fn quiet(row: &[f64]) -> f64 {
    let mut sizes: Vec<f64> = row.iter().map(|e| e * e).filter(|e| *e > 0.0).collect();
    median(&mut sizes).map_or(0.0, |median| 1.0 / median)
}
