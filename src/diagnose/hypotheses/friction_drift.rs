//! `friction_drift`: friction that changes over time as grease warms up, or with the temperature
//! where that was recorded.

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
use super::moves;
use crate::diagnose::windows::windowed_data::{JointSeries, WindowedData};

/// `(DC sign(v) + DV v) exp(-t / DT)`. With a recorded temperature, `temp - 25` replaces the
/// exponential.
pub struct FrictionDrift;

/// Reference temperature of the plain friction terms, deg C: the default of the file's `T0`.
const REFERENCE: f64 = 25.0;

/// Largest ratio of the fading time to the length of the logs; slower fading is a constant level.
const SLOWEST: f64 = 1.5;

/// Least length of a log that shows a drift, s.
const SHORTEST: f64 = 10.0;

impl FrictionDrift {
    /// Whether a temperature was recorded throughout.
    fn recorded(scene: &WindowedData<'_>, j: usize) -> bool {
        scene.own[j].iter().all(|o| o.temperature.len() == o.v.len()) && !scene.own[j].is_empty()
    }

    /// Whether the recorded temperature changed by more than 1 deg C.
    fn warms(scene: &WindowedData<'_>, j: usize) -> bool {
        let all = || scene.own[j].iter().flat_map(|o| o.temperature.iter().copied());
        let (low, high) = (all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max));
        Self::recorded(scene, j) && high - low > 1.0
    }
}

/// Length of the longest log, s.
fn length(scene: &WindowedData<'_>) -> f64 {
    scene.time.iter().fold(0.0, |most: f64, t| most.max(*t))
}

impl Hypothesis for FrictionDrift {
    fn effect(&self) -> EffectKind {
        EffectKind::FrictionDrift
    }

    fn kind(&self) -> Kind {
        Kind::Friction
    }

    fn shape(&self) -> &'static [Shape] {
        &[Shape { symbol: Symbol::Key(effects::FrictionDrift::DT), unit: "s", range: [0.05, 1e5], step: Some(0.3) }]
    }

    fn grid(&self, scene: &WindowedData<'_>, place: &[usize], _: &[Vec<f64>]) -> Vec<Vec<f64>> {
        let long = length(scene).max(1.0);
        let mut grid: Vec<Vec<f64>> = geometric(0.08 * long, SLOWEST * long, 6).into_iter().map(|t| vec![t]).collect();
        if Self::warms(scene, place[0]) {
            grid.push(vec![0.0]);
        }
        grid
    }

    /// Grease takes minutes to warm up: in short logs only a recorded temperature shows it.
    fn shows(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64]) -> bool {
        moves(scene, place[0]) && (length(scene) > SHORTEST || shape[0] == 0.0)
    }

    fn plausible(&self, scene: &WindowedData<'_>, _: &[usize], shape: &[f64], _: &[f64]) -> bool {
        shape[0] <= SLOWEST * length(scene)
    }

    fn terms(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64]) -> Vec<Term> {
        let j = place[0];
        if shape[0] == 0.0 {
            if !Self::recorded(scene, j) {
                return Vec::new();
            }
            let warm = |k: usize, o: &JointSeries<'_>| o.temperature[k] - REFERENCE;
            return vec![
                Term::new(Symbol::Own("DCK"), scene.pointwise(j, |o, k| o.sign[k] * warm(k, o)), Sign::Any),
                Term::new(Symbol::Own("DVK"), scene.pointwise(j, |o, k| o.v[k] * warm(k, o)), Sign::Any),
            ];
        }
        let fade = |t: f64| (-t / shape[0]).exp();
        vec![
            Term::new(Symbol::Own("DC"), scene.pointwise(j, |o, k| o.sign[k] * fade(o.t(k))), Sign::Any),
            Term::new(Symbol::Own("DV"), scene.pointwise(j, |o, k| o.v[k] * fade(o.t(k))), Sign::Any),
        ]
    }

    fn named(&self, found: &Estimate<'_>) -> Vec<Named> {
        // The file's law scales all friction; its factor follows from the larger of the two parts.
        let [slope, level, _] = found.levels;
        let share = if level.abs() > 0.2 * slope.abs() { found.x[0] / level } else { found.x[1] / slope };
        let mut all = match found.shape[0] {
            0.0 => vec![Named::new(effects::FrictionDrift::DK, share, None)],
            time => vec![
                Named::new(effects::FrictionDrift::DA, share, None),
                Named::new(effects::FrictionDrift::DT, time, found.shape_std[0]),
            ],
        };
        all.extend(found.all_terms());
        all.retain(|n| n.value.is_finite());
        all
    }

    fn over(&self) -> Over {
        Over::Time
    }

    fn follows_reversals(&self) -> bool {
        true
    }

    fn says(&self) -> &'static str {
        "friction changes over the recording, as it does while grease warms up"
    }

    fn shown_by(&self) -> &'static str {
        "the same motion repeated from cold until it no longer changes, with the temperature recorded"
    }
}
