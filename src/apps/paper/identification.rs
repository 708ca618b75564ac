//! Sections II.D, II.E, III.E and VI.A of the paper, end to end: Fig. 6, Table II, Table III, Fig.
//! 10, and the validity of the standard deviations.

use super::ReproduceError;
use super::Watch;
use super::chain::{factors, fit, play};
use super::fig6::{self, Bars, mean};
use super::fig10::{Fig10, fig10};
use super::honesty::{Honesty, honesty};
use super::lwr::{Lwr, Unmodelled};
use super::motions::{PaperMotion, motions};
use super::table2;
use super::table3;
use crate::apps::paper::tool::{Column, PAPER_TORQUE_NOISE};
use crate::data::signal::Filter;
use crate::identify::{Factors, Identification};
use crate::simulate::Recording;

/// Settings of the experiment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IdentificationSettings {
    /// Number of runs with other noise, for the standard deviations. Default 200.
    pub runs: usize,
    /// Seed of motions and noise. Default 1.
    pub seed: u64,
}

impl Default for IdentificationSettings {
    fn default() -> Self {
        Self { runs: 200, seed: 1 }
    }
}

/// Residual due to a single effect.
#[derive(Debug, Clone, PartialEq)]
pub struct Missing {
    /// The effect.
    pub effect: Unmodelled,
    /// Held-out RMS with this effect alone, mean over the joints, N m.
    pub rms: f64,
}

/// Results of the experiment.
#[derive(Debug, Clone)]
pub struct Experiment {
    /// Settings used.
    pub settings: IdentificationSettings,
    /// The motions; the last one validates.
    pub motions: Vec<PaperMotion>,
    /// White noise of the torque sensors, N m, per joint.
    pub noise: Vec<f64>,
    /// The same after the low-pass: the noise floor.
    pub floor: Vec<f64>,
    /// Fig. 6.
    pub fig6: Vec<fig6::Fig6Row>,
    /// Residuals of the unmodelled case, effect by effect.
    pub missing: Vec<Missing>,
    /// Table II, from the motion by log det.
    pub table2: Vec<table2::Table2Row>,
    /// Number of inertial base parameters within three standard deviations of the truth where the
    /// model lacks effects, and their total number. Friction parameters absorb part of the effects.
    pub within_unmodelled: [usize; 2],
    /// Table III.
    pub table3: Vec<Column>,
    /// The large roller over repeated runs, from one log of each kind and from more.
    pub rollers: Vec<table3::Repeated>,
    /// Fig. 10.
    pub fig10: Fig10,
    /// Validity of the standard deviations in the noise-only case.
    pub honesty: Option<Honesty>,
}

/// Range of an experiment's progress.
struct Stage<'a> {
    watch: Watch<'a>,
    from: f64,
    to: f64,
}

impl Stage<'_> {
    fn tell(&self, what: &str, share: f64) {
        (self.watch)(what, self.from + (self.to - self.from) * share);
    }
}

/// A recording of each motion, their identifications, and the factors of the last one.
struct Case {
    recordings: Vec<Recording>,
    found: Vec<Identification>,
    validate: Factors,
}

fn case(
    lwr: &Lwr,
    motions: &[PaperMotion],
    which: &[Unmodelled],
    seed: u64,
    stage: &Stage<'_>,
) -> Result<Case, ReproduceError> {
    let mut recordings = Vec::new();
    for (k, motion) in motions.iter().enumerate() {
        stage.tell(&format!("playing {}", motion.name), k as f64 / motions.len() as f64);
        recordings.push(play(lwr, motion, which, seed.wrapping_add(1000 * k as u64))?);
    }
    let mut all = Vec::new();
    for (motion, recording) in motions.iter().zip(&recordings) {
        all.push(factors(motion.name, &lwr.arm, &recording.log, 1)?);
    }
    let validate = all.pop().ok_or(ReproduceError::Missing("motion"))?;
    let found = all.iter().map(|f| fit(lwr, f, &validate)).collect::<Result<_, _>>()?;
    Ok(Case { recordings, found, validate })
}

/// Runs the experiment in at most a minute; `watch` receives the progress.
pub fn identification(settings: &IdentificationSettings, watch: Watch<'_>) -> Result<Experiment, ReproduceError> {
    let lwr = Lwr::new()?;
    let IdentificationSettings { runs, seed } = *settings;
    let stage = |from: f64, to: f64| Stage { watch, from, to };
    let designing = stage(0.0, 0.45);
    let motions = motions(&lwr, seed, &|what, share| designing.tell(what, share))?;
    let noise = PAPER_TORQUE_NOISE.to_vec();
    let gain = Filter::default().noise_gain(Lwr::sensors().rate);
    let floor: Vec<f64> = noise.iter().map(|s| gain * s).collect();

    let robots: Vec<PaperMotion> = motions.iter().filter(|m| m.name != "tool").cloned().collect();
    let plain = case(&lwr, &robots, &[], seed, &stage(0.45, 0.52))?;
    let real = case(&lwr, &robots, &Unmodelled::ALL, seed.wrapping_add(7), &stage(0.52, 0.59))?;
    let best = robots.iter().position(|m| m.name == "logdet").unwrap_or(0);

    let noisier = stage(0.59, 0.62);
    let again =
        fig6::again(&lwr, &plain.recordings, seed.wrapping_mul(5_000_011), &|what, share| noisier.tell(what, share))?;
    let fig6 = fig6::PAPER
        .iter()
        .filter_map(|&(criterion, paper)| {
            let k = robots.iter().position(|m| m.name == criterion)?;
            Some(fig6::Fig6Row {
                criterion,
                paper,
                noise_only: Bars {
                    rms: again.motions[k][0].clone(),
                    nrms: again.motions[k][1].clone(),
                    ..Bars::new(&plain.found[k], &plain.validate)
                },
                unmodelled: Bars::new(&real.found[k], &real.validate),
                floor: floor.clone(),
                true_parameters: again.truth.clone(),
            })
        })
        .collect();

    let mut missing = Vec::new();
    let pair = [robots[best].clone(), robots[robots.len() - 1].clone()];
    for (k, effect) in Unmodelled::ALL.into_iter().enumerate() {
        let part = stage(0.62 + 0.02 * k as f64, 0.64 + 0.02 * k as f64);
        let alone = case(&lwr, &pair, &[effect], seed.wrapping_add(7), &part)?;
        let rms = alone.found[0].validation.as_ref().map_or(f64::NAN, |v| mean(&v.rms));
        missing.push(Missing { effect, rms });
    }

    let table2 = table2::rows(&lwr, &plain.found[best], &real.found[best]);
    let inertial = || real.found[best].parameters.iter().zip(&lwr.truth).filter(|(e, _)| !e.leader.is_friction());
    let within = inertial().filter(|(e, truth)| (e.value - *truth).abs() <= 3.0 * e.std).count();
    let (tool, bench, rolling, many) = (stage(0.68, 0.7), stage(0.7, 0.74), stage(0.74, 0.86), stage(0.86, 1.0));
    let fig10 =
        fig10(&lwr, &robots[best], &real.recordings[best], &Unmodelled::ALL, seed.wrapping_add(11), &|what, share| {
            tool.tell(what, share)
        })?;
    let moving = motions.iter().find(|m| m.name == "tool").unwrap_or(&robots[best]);
    // An empty hand in the same motion: the robot's own parameters then contribute equally to both
    // logs.
    bench.tell("the hand empty", 0.0);
    let empty = play(&lwr, moving, &[], seed.wrapping_add(17))?;
    let table3 = table3::columns(&lwr, moving, &empty, seed.wrapping_add(13), &|what, share| {
        bench.tell(what, share);
    })?;
    let rollers = table3::repeated(
        &lwr,
        &[&empty, &plain.recordings[best]],
        &[moving, &robots[best]],
        seed.wrapping_mul(7_000_003),
        &|what, share| rolling.tell(what, share),
    )?;
    let honesty = match runs {
        0 => None,
        _ => Some(honesty(
            &lwr,
            &plain.recordings[best],
            &plain.recordings[robots.len() - 1],
            &floor,
            runs,
            seed.wrapping_mul(1_000_003),
            &|what, share| many.tell(what, share),
        )?),
    };
    Ok(Experiment {
        settings: *settings,
        within_unmodelled: [within, inertial().count()],
        motions,
        noise,
        floor,
        fig6,
        missing,
        table2,
        table3,
        rollers,
        fig10,
        honesty,
    })
}
