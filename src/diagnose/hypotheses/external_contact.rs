//! `external_contact`: an external wrench acts during part of the log, constant in the axes of the
//! last frame or of the base.

use dh_codegen::robot::EffectKind;
use dh_codegen::robot::effects;

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
use crate::diagnose::windows::windowed_data::{Column, WindowedData};

/// A constant wrench on the last frame between `start` and `end` (seconds of used data, over all
/// logs). It is given in the last frame's axes or, with `base` 1, in those of the base.
pub struct ExternalContact;

/// Distance from an end of a recording, s, within which a push must be longer than [`SHORT`], s.
const NEAR_END: f64 = 0.3;
const SHORT: f64 = 1.0;

/// Least duration, s: what is shorter is an impact, not a force that stays.
const BRIEFEST: f64 = 0.1;

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
        ]
    }

    /// The windows in which the residual, scaled by its own noise, is largest against the rest.
    fn grid(&self, scene: &WindowedData<'_>, _: &[usize], residual: &[Vec<f64>]) -> Vec<Vec<f64>> {
        let n = scene.len;
        let mut power = vec![0.0; n + 1];
        for row in residual {
            let mut sizes: Vec<f64> = row.iter().map(|e| e * e).filter(|e| *e > 0.0).collect();
            sizes.sort_by(f64::total_cmp);
            // A quiet joint's noise: the median of the squares, which a short contact does not
            // move.
            let Some(&median) = sizes.get(sizes.len() / 2) else { continue };
            for (p, e) in power[1..].iter_mut().zip(row) {
                *p += e * e / median;
            }
        }
        for w in 0..n {
            power[w + 1] += power[w];
        }
        let mean = power[n] / n.max(1) as f64;
        let mut found: Vec<(f64, usize, usize)> = Vec::new();
        let mut length = (0.15 / scene.step).ceil().max(4.0) as usize;
        while length <= n / 2 {
            let mut best = (0.0, 0, 0);
            for start in (0..n.saturating_sub(length)).step_by((length / 8).max(1)) {
                let excess = power[start + length] - power[start] - mean * length as f64;
                if excess / (length as f64).sqrt() > best.0 {
                    best = (excess / (length as f64).sqrt(), start, start + length);
                }
            }
            found.push(best);
            length = (length * 4 / 3).max(length + 1);
        }
        found.sort_by(|a, b| b.0.total_cmp(&a.0));
        found.truncate(4);
        let windows = found.iter().filter(|f| f.2 > f.1);
        windows
            .flat_map(|f| [0.0, 1.0].map(|base| vec![f.1 as f64 * scene.step, f.2 as f64 * scene.step, base]))
            .collect()
    }

    /// What is very short is an impact; what is short and at an end of a recording is a bristle
    /// that bends or a low-pass that settles.
    fn shows(&self, scene: &WindowedData<'_>, _: &[usize], shape: &[f64]) -> bool {
        let [start, end] = [shape[0], shape[1]];
        let at_an_end = |run: &std::ops::Range<usize>| {
            let [first, last] = [run.start, run.end].map(|w| w as f64 * scene.step);
            start < last && end > first && (start < first + NEAR_END || end > last - NEAR_END)
        };
        end - start >= BRIEFEST && (end - start > SHORT || !scene.runs.iter().any(at_an_end))
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
        effects::ExternalContact::WRENCH
            .into_iter()
            .enumerate()
            .filter_map(|(c, key)| {
                let rows = (0..dof)
                    .map(|j| {
                        let mut row = vec![0.0; scene.len];
                        for w in start..end {
                            row[w] = -unit[(c * dof + j) * len + w - start];
                        }
                        row
                    })
                    .collect();
                let column: Column = scene.column(rows);
                (!column.rows.is_empty()).then(|| Term::new(key, column, Sign::Any))
            })
            .collect()
    }

    fn local(&self) -> bool {
        true
    }

    fn acts(&self, shape: &[f64]) -> Option<[f64; 2]> {
        Some([shape[0], shape[1]])
    }

    /// Pushes one after the other, in any of the logs.
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
        ends.into_iter().chain(found.all_terms()).collect()
    }

    fn over(&self) -> Over {
        Over::Time
    }

    fn says(&self) -> &'static str {
        "a force acts on the arm during part of the recording"
    }

    fn shown_by(&self) -> &'static str {
        "the same motion in free space"
    }
}
