//! `backlash`: a dead zone in the transmission. The link rests half the gap to the side towards
//! which its torque pushes it.
//!
//! The motor crosses the gap in hundredths of a second. The low-pass of the log leaves a hump in
//! the acceleration that the link never had. The transition is therefore filtered by the same
//! low-pass before it is subtracted from the motion. The side is the sign of the slow part of the
//! load, recomputed along the link's motion: along the motor's motion the modelled load contains
//! the hump.

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
use crate::data::signal::low_pass;
use crate::diagnose::windows::windowed_data::WindowedData;
use crate::numerics::sums::root_mean_square;

/// Link angle `q - (BL / 2) load / sqrt(load^2 + (TB rms)^2)`.
pub struct Backlash;

/// First step of the search, rad.
const FIRST: f64 = 1e-4;
/// Number of evaluations of the load: first along the motor's motion, then along that of the link
/// given by the previous load.
const ROUNDS: usize = 3;

/// Whether the joint carries load to both sides, so that it crosses a gap.
pub(super) fn both_ways(scene: &WindowedData<'_>, j: usize) -> bool {
    let torque = &scene.rigid[j];
    let rms = root_mean_square(torque);
    rms > 0.0 && torque.iter().any(|t| *t > 0.05 * rms) && torque.iter().any(|t| *t < -0.05 * rms)
}

/// Low-pass of a load at `cutoff`, Hz.
fn slow(scene: &WindowedData<'_>, load: &[f64], cutoff: f64) -> Vec<f64> {
    let mut load = load.to_vec();
    if let Ok(filter) = low_pass(2, cutoff, 1.0 / scene.step) {
        for run in &scene.runs {
            filter.forward_backward(&mut load[run.clone()], (1.0 / (cutoff * scene.step)) as usize);
        }
    }
    load
}

impl Hypothesis for Backlash {
    fn effect(&self) -> EffectKind {
        EffectKind::Backlash
    }

    fn kind(&self) -> Kind {
        Kind::Transmission
    }

    fn shape(&self) -> &'static [Shape] {
        &[
            Shape { symbol: Symbol::Own("step"), unit: "rad", range: [1e-7, 1.0], step: None },
            Shape { symbol: Symbol::Own("TB"), unit: "", range: [1e-3, 0.4], step: Some(0.4) },
            Shape { symbol: Symbol::Own("slow"), unit: "Hz", range: [0.1, 100.0], step: None },
        ]
    }

    fn grid(&self, _: &WindowedData<'_>, _: &[usize], _: &[Vec<f64>]) -> Vec<Vec<f64>> {
        [1.5, 3.0, 5.0].iter().flat_map(|below| [0.02, 0.1].map(|share| vec![FIRST, share, *below])).collect()
    }

    fn shows(&self, scene: &WindowedData<'_>, place: &[usize], _: &[f64]) -> bool {
        both_ways(scene, place[0])
    }

    fn terms(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64]) -> Vec<Term> {
        let (j, scale) = (place[0], shape[0]);
        let whole = scene.transmitted(j);
        let mut load = slow(scene, &whole, shape[2]);
        let mut round = 1;
        loop {
            let rms = root_mean_square(&load);
            let small = (shape[1] * rms).max(1e-12);
            let behind = scene.seen_through(j, &load, |t| -0.5 * t / (t * t + small * small).sqrt());
            let mut rows = scene.moved(j, &behind, scale);
            // The rotor follows the measured motion.
            rows[j].iter_mut().zip(&behind[2]).for_each(|(t, a)| *t -= scene.rotors[j] * a);
            if round == ROUNDS || scale == FIRST {
                return vec![Term::new(effects::Backlash::BL, scene.column(rows), Sign::Positive)];
            }
            let link: Vec<f64> = whole.iter().zip(&rows[j]).map(|(t, more)| t + scale * more).collect();
            load = slow(scene, &link, shape[2]);
            round += 1;
        }
    }

    fn finite_difference(&self) -> bool {
        true
    }

    fn rests_on_model(&self) -> bool {
        true
    }

    fn named(&self, found: &Estimate<'_>) -> Vec<Named> {
        vec![found.term(0)]
    }

    fn over(&self) -> Over {
        Over::Torque
    }

    fn says(&self) -> &'static str {
        "the link jumps across a gap when the torque changes its direction"
    }

    fn shown_by(&self) -> &'static str {
        "motions in which the joint's torque changes its sign often, with and without a preload"
    }
}
