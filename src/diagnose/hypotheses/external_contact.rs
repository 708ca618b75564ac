//! `external_contact`: an external wrench during a part of the log, constant in the axes of what it
//! acts on or of the base.

use dh_codegen::robot::EffectKind;
use dh_codegen::robot::effects::{self, Key};

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
use super::pushed_stretches::{Stretch, ends, pushed_stretches, swelling};
use crate::diagnose::windows::windowed_data::{Column, WindowedData};
use crate::model::Contact;

/// A wrench between `start` and `end` (seconds of used data, over all logs), constant in the axes of
/// what it acts on or, with `base` 1, in those of the base. With `swell` it rises until the middle
/// and falls from there on, as a push of a hand does.
pub struct Push {
    on: On,
}

/// What a push acts on.
#[derive(Clone, Copy, PartialEq)]
enum On {
    /// The tool. Without `moment` it is a force at the origin of the tool's frame.
    Tool,
    /// The far end of `link`, a row of the table from 1. It is a force.
    Link,
}

/// A push on the tool.
pub(in crate::diagnose) const ON_TOOL: Push = Push { on: On::Tool };

/// A push on a link that at least two joints carry: an error of one joint is no evidence of a force.
/// One on the last link is a push on the tool.
pub(in crate::diagnose) const ON_LINK: Push = Push { on: On::Link };

/// Indices of the shape's numbers.
const BASE: usize = 2;
const MOMENT_OR_LINK: usize = 3;
const SWELL: usize = 4;

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
pub(super) const CONSTANT: f64 = 2.0 / 3.0;

/// Longest push that rises and falls, s: anything longer is a slow error.
pub(in crate::diagnose) const LONGEST_SWELL: f64 = 2.0;

/// Number of stretches of the log that are tried.
const TRIED: usize = 6;

impl Hypothesis for Push {
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
        match self.on {
            On::Tool => const { &shapes("moment", 1.0) },
            On::Link => const { &shapes("link", 1e3) },
        }
    }

    /// Stretches in which a constant force would take more of the residual than elsewhere.
    fn grid(&self, scene: &WindowedData<'_>, _: &[usize], residual: &[Vec<f64>]) -> Vec<Vec<f64>> {
        let touched = match self.on {
            On::Tool => vec![None],
            On::Link => touchable(scene.plant.rows()).iter().copied().map(Some).collect(),
        };
        let contacts = touched.iter().flat_map(|&link| [false, true].map(|in_base| Contact { link, in_base }));
        let possible = |ends: [f64; 2]| is_push(scene, ends, false, BRIEFEST);
        let mut found: Vec<Stretch> =
            contacts.flat_map(|contact| pushed_stretches(scene, residual, contact, &possible)).collect();
        found.sort_by(|a, b| b.worth.total_cmp(&a.worth));
        found.truncate(TRIED);
        found.iter().flat_map(|stretch| self.laws(scene, stretch)).collect()
    }

    /// Very short contacts are impacts. Short ones at an end of a recording are presliding
    /// deflection or a settling low-pass. A push does not continue in the next recording.
    fn shows(&self, scene: &WindowedData<'_>, _: &[usize], shape: &[f64]) -> bool {
        let least = if self.moment(shape) { WITH_MOMENT } else { BRIEFEST };
        is_push(scene, [shape[0], shape[1]], swells(shape), least)
    }

    fn terms(&self, scene: &WindowedData<'_>, _: &[usize], shape: &[f64]) -> Vec<Term> {
        let window = |t: f64| ((t / scene.step).round() as usize).min(scene.len);
        let (start, end) = (window(shape[0]), window(shape[1]));
        if start + 4 > end {
            return Vec::new();
        }
        let unit = scene.wrenches(start..end, self.contact(shape));
        let len = end - start;
        let dof = scene.dof();
        let middle = |w: usize| ((w as f64 + 0.5) * scene.step - shape[0]) / (shape[1] - shape[0]);
        let swelling = |w: usize| (std::f64::consts::PI * middle(w).clamp(0.0, 1.0)).sin().powi(2);
        let share: Vec<f64> = (start..end).map(|w| if swells(shape) { swelling(w) } else { 1.0 }).collect();
        effects::ExternalContact::WRENCH
            .into_iter()
            .enumerate()
            .filter(|(c, _)| self.moment(shape) || *c < 3)
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
        usize::from(self.moment(shape)) + 2 * usize::from(swells(shape))
    }

    /// The touched link is found, too.
    fn free(&self, _: &[f64]) -> usize {
        2 + usize::from(self.on == On::Link)
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
        let base = (found.shape[BASE] == 1.0).then(|| Named::new(effects::ExternalContact::BASE, 1.0, None));
        let link = self.contact(found.shape).link.map(|row| (row + 1) as f64);
        let link = link.map(|number| Named::new(effects::ExternalContact::LINK, number, None));
        ends.into_iter().chain(rise).chain(found.all_terms()).chain(base).chain(link).collect()
    }

    fn over(&self) -> Over {
        Over::Time
    }

    fn says(&self) -> &'static str {
        match self.on {
            On::Tool => "a force acts on the arm during part of the recording",
            On::Link => "a force acts on a link during part of the recording",
        }
    }

    fn says_of(&self, shape: &[f64]) -> &'static str {
        match (self.on, shape[BASE] == 1.0, swells(shape)) {
            (On::Tool, true, false) => {
                "a force acts on the arm during part of the recording, constant in the base's axes"
            }
            (On::Tool, false, false) => {
                "a force acts on the arm during part of the recording, constant in the tool's axes"
            }
            (On::Tool, true, true) => {
                "a force acts on the arm during part of the recording, rising and falling along one direction of the base's axes"
            }
            (On::Tool, false, true) => {
                "a force acts on the arm during part of the recording, rising and falling along one direction of the tool's axes"
            }
            (On::Link, true, false) => {
                "a force acts on a link during part of the recording, constant in the base's axes"
            }
            (On::Link, false, false) => {
                "a force acts on a link during part of the recording, constant in the link's axes"
            }
            (On::Link, true, true) => {
                "a force acts on a link during part of the recording, rising and falling along one direction of the base's axes"
            }
            (On::Link, false, true) => {
                "a force acts on a link during part of the recording, rising and falling along one direction of the link's axes"
            }
        }
    }

    fn shown_by(&self) -> &'static str {
        "the same motion in free space"
    }
}

impl Push {
    /// Whether it has a moment.
    fn moment(&self, shape: &[f64]) -> bool {
        self.on == On::Tool && shape[MOMENT_OR_LINK] == 1.0
    }

    fn contact(&self, shape: &[f64]) -> Contact {
        let link = (self.on == On::Link).then(|| (shape[MOMENT_OR_LINK] as usize).saturating_sub(1));
        Contact { link, in_base: shape[BASE] == 1.0 }
    }

    /// Shapes of all laws that resemble a constant force in a stretch.
    fn laws(&self, scene: &WindowedData<'_>, stretch: &Stretch) -> Vec<Vec<f64>> {
        let further = match stretch.contact.link {
            None => vec![0.0, 1.0],
            Some(row) => vec![(row + 1) as f64],
        };
        let base = f64::from(u8::from(stretch.contact.in_base));
        let of = |swell: f64| {
            let span = if swell == 1.0 { swelling } else { ends };
            let [start, end] = span(scene, &stretch.windows);
            further.iter().map(move |further| vec![start, end, base, *further, swell])
        };
        [0.0, 1.0].into_iter().flat_map(of).collect()
    }
}

/// The shape's numbers; the fourth is a moment or a link.
const fn shapes(fourth: &'static str, most: f64) -> [Shape; 5] {
    const fn time(key: Key) -> Shape {
        Shape { symbol: Symbol::Key(key), unit: "s", range: [0.0, 1e9], step: Some(-0.12) }
    }
    const fn which(name: &'static str, most: f64) -> Shape {
        Shape { symbol: Symbol::Own(name), unit: "", range: [0.0, most], step: None }
    }
    let [start, end] = [time(effects::ExternalContact::START), time(effects::ExternalContact::END)];
    [start, end, which("base", 1.0), which(fourth, most), which("swell", 1.0)]
}

/// Rows of the links that a push on a link may touch.
pub(in crate::diagnose) fn touchable(rows: &[usize]) -> &[usize] {
    rows.get(1..rows.len().saturating_sub(1)).unwrap_or(&[])
}

/// Whether a push between these times (s of used data) is within one recording and not too short.
/// `least`: least length, s.
fn is_push(scene: &WindowedData<'_>, [start, end]: [f64; 2], swells: bool, least: f64) -> bool {
    let inside = |[first, last]: [f64; 2]| start > first - 0.5 * scene.step && end < last + 0.5 * scene.step;
    let Some([first, last]) = scene.runs.iter().map(|run| ends(scene, run)).find(|run| inside(*run)) else {
        return false;
    };
    if swells && end - start > LONGEST_SWELL {
        return false;
    }
    let lead = if swells { 0.5 * (1.0 - CONSTANT) * (end - start) } else { 0.0 };
    let [start, end] = [start + lead, end - lead];
    let at_an_end = start < first + NEAR_END || end > last - NEAR_END;
    end - start >= least && (end - start > SHORT || !at_an_end)
}

/// Whether a push rises to its middle and falls from there on.
pub(in crate::diagnose) fn swells(shape: &[f64]) -> bool {
    shape.get(SWELL) == Some(&1.0)
}
