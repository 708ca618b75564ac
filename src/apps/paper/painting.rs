//! Sections V and VI.B of the paper, end to end. Identifies the arm and its load, plans, presses a
//! roller on the wall with 30 N without a force sensor, and compares with the sensor in the wall:
//! Table IV, Figs. 12 and 13. Repeats this after the diagnosis has extended the model.

mod plans;
mod rig;

use super::ReproduceError;
use super::Watch;
use super::force::wandering;
use super::lwr::{Lwr, Unmodelled};
use super::many::many;
use super::motions::{PaperMotion, designed};
use super::verdict::Verdict;
use crate::apps::painting::Plan;
use crate::apps::painting::run::{Feedback, Law, Run};
use crate::data::signal::Filter;
use crate::diagnose::Diagnosis;
use crate::excite::{Criterion, Effort};
use crate::model::differentiated::Differentiated;
use crate::numerics::prng::Random;
use plans::Extent;
use rig::{Rig, Stand};

/// Settings of the experiment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PaintingSettings {
    /// Seed of motions and noise. Default 1.
    pub seed: u64,
    /// Quick check: random motions instead of designed ones, the large roller alone, a hand's
    /// breadth of wall in two seconds, no diagnosis.
    pub quick: bool,
}

impl Default for PaintingSettings {
    fn default() -> Self {
        Self { seed: 1, quick: false }
    }
}

/// Combination of robot and model.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PaintingCase {
    /// The model is correct; only noise.
    NoiseOnly,
    /// The robot has effects that no rigid-body model has.
    Unmodelled,
    /// The same robot, with the model extended by the diagnosis.
    Extended,
}

impl PaintingCase {
    /// All cases in the order of the table.
    pub const ALL: [Self; 3] = [Self::NoiseOnly, Self::Unmodelled, Self::Extended];

    /// Title for reports.
    pub fn title(self) -> &'static str {
        match self {
            Self::NoiseOnly => "right model",
            Self::Unmodelled => "unmodelled effects",
            Self::Extended => "after the diagnosis",
        }
    }
}

/// Table IV: root mean squares, N, of estimated minus measured, estimated minus desired, and
/// measured minus desired force.
pub const PAPER: [(&str, [f64; 3]); 2] = [("large-roller", [2.9, 0.2, 2.9]), ("small-roller", [2.0, 0.2, 2.0])];
/// Laws and feedbacks of the table: the paper's law, then with known terms fed forward; the latter
/// also with the measured force in the feedback.
pub const KINDS: [(Law, Feedback); 3] =
    [(Law::PAPER, Feedback::Estimated), (Law::FED, Feedback::Estimated), (Law::FED, Feedback::Measured)];
/// Number of coats with the estimate in the feedback and known terms fed forward; each but the
/// first uses what was learned from the coats before it.
pub const COATS: usize = 3;
/// The paper's durations, s.
pub const PAPER_SECONDS: [f64; 2] = [50.0, 46.0];
/// Bound on the difference of estimated and measured force after the model is extended, N.
pub const ASKED: f64 = 1.0;

/// Result of one run.
#[derive(Debug, Clone)]
pub struct PaintingRow {
    /// Name of the tool.
    pub roller: &'static str,
    /// Combination of robot and model.
    pub case: PaintingCase,
    /// Feed-forward terms of the inner loop in addition to equation (13).
    pub law: Law,
    /// Source of the force that is fed back.
    pub feedback: Feedback,
    /// Number of the coat; beyond the first, the displacement learned from the coats before is fed
    /// forward too.
    pub coat: usize,
    /// Recording and result of the run.
    pub run: Run,
    /// The paper's figures of Table IV, N.
    pub paper: [f64; 3],
}

impl PaintingRow {
    /// Our figures of Table IV, N.
    pub fn ours(&self) -> [f64; 3] {
        let a = &self.run.accuracy;
        [a.estimated_measured, a.estimated_desired, a.measured_desired]
    }

    /// Comparison of one of the three figures with the paper's.
    pub fn verdict(&self, which: usize) -> Verdict {
        Verdict::less(self.ours()[which], self.paper[which])
    }
}

/// Results of the experiment.
#[derive(Debug, Clone)]
pub struct Painting {
    /// Settings used.
    pub settings: PaintingSettings,
    /// Desired force, N.
    pub force: f64,
    /// Duration of each roller's plan, s.
    pub seconds: Vec<f64>,
    /// Held-out root mean square torque error of each case's model, mean over the joints, N m.
    pub torque: Vec<f64>,
    /// White noise of the torque sensors, before and after the low-pass, mean over the joints, N m.
    pub noise: [f64; 2],
    /// Runs: rollers, cases, laws and feedback, the first and the last coat.
    pub rows: Vec<PaintingRow>,
    /// Diagnosis of the logs of the second robot; `None` in a quick run.
    pub diagnosis: Option<Diagnosis>,
}

impl Painting {
    /// The first coat of a roller and a case under a law.
    pub fn row(&self, roller: &str, case: PaintingCase, law: Law, feedback: Feedback) -> Option<&PaintingRow> {
        let this = |r: &&PaintingRow| r.roller == roller && r.case == case && r.law == law && r.feedback == feedback;
        self.rows.iter().find(|r| this(r) && r.coat == 1)
    }

    /// The last coat of a roller and a case, with the estimate in the feedback.
    pub fn last_coat(&self, roller: &str, case: PaintingCase) -> Option<&PaintingRow> {
        self.rows.iter().find(|r| r.roller == roller && r.case == case && r.coat == COATS)
    }
}

/// A random motion.
fn wandered(lwr: &Lwr, seed: u64) -> Result<PaperMotion, ReproduceError> {
    let played = wandering(lwr, &mut Random::new(seed), 14, [0.7, 0.0])?;
    let seconds = played.span().end - played.span().start;
    let unknown = f64::NAN;
    Ok(PaperMotion { name: "random", seconds, condition: unknown, log_det: unknown, speed: Vec::new(), played })
}

/// Runs the experiment in some minutes; `watch` receives the progress.
pub fn painting(settings: &PaintingSettings, watch: Watch<'_>) -> Result<Painting, ReproduceError> {
    let lwr = Lwr::new()?;
    let seed = settings.seed;
    let arm = Differentiated::new(&lwr.robot);
    let design = |name, criterion, seconds, starts, seed, from: f64| {
        let tell = |share: f64| watch(&format!("designing {name}"), from + 0.05 * share);
        designed(&lwr, &arm, name, criterion, seconds, Effort { starts, seed, ..Effort::default() }, &tell)
    };
    let [exciting, carrying, validating] = if settings.quick {
        [wandered(&lwr, seed)?, wandered(&lwr, seed ^ 0x7001)?, wandered(&lwr, seed ^ 0x5eed)?]
    } else {
        [
            design("logdet", Criterion::LogDet, 10.0, 4, seed, 0.0)?,
            design("tool", Criterion::LogDet, 10.0, 4, seed, 0.05)?,
            design("validate", Criterion::Hadamard, 20.0, 1, seed ^ 0x5eed, 0.1)?,
        ]
    };
    drop(arm);
    let extent = if settings.quick { Extent::QUICK } else { Extent::PAPER };
    let rigid = Lwr::with_rotors()?;
    let stand = |lwr: &Lwr, which: &[Unmodelled], seed: u64, plans: Option<&[Plan]>, name: &str, from: f64| {
        let tell = |what: &str, share: f64| watch(&format!("{what}, {name}"), from + 0.1 * share);
        Stand::new(lwr, [&exciting, &carrying, &validating], which, &extent, seed, plans, &tell)
    };
    let plain = stand(&rigid, &[], seed, None, "noise only", 0.15)?;
    let plans: Vec<Plan> = plain.rollers.iter().map(|r| r.plan.clone()).collect();
    let real = stand(&lwr, &Unmodelled::ALL, seed.wrapping_add(7), Some(&plans), "unmodelled effects", 0.25)?;
    let mut stands = vec![plain, real];
    let mut diagnosis = None;
    if !settings.quick {
        watch("diagnosing", 0.36);
        let (extended, found) = stands[1].extended(&lwr, &|what| watch(&format!("diagnosing: {what}"), 0.4))?;
        stands.push(extended);
        diagnosis = Some(found);
    }
    let kinds = if settings.quick { &KINDS[1..2] } else { &KINDS[..] };
    let mut jobs: Vec<(usize, PaintingCase, Law, Feedback, &Rig)> = Vec::new();
    for k in 0..plans.len() {
        for (case, stand) in PaintingCase::ALL.into_iter().zip(&stands) {
            jobs.extend(kinds.iter().map(|&(law, feedback)| (k, case, law, feedback, &stand.rollers[k])));
        }
    }
    let one = |k: usize| {
        let (of, case, law, feedback, stage) = jobs[k];
        let coats = if law == Law::FED && feedback == Feedback::Estimated && !settings.quick { COATS } else { 1 };
        let mut rows: Vec<PaintingRow> = Vec::new();
        let mut learned = None;
        for coat in 1..=coats {
            let seed = seed.wrapping_add(100 + k as u64 + 1000 * (coat as u64 - 1));
            let run = stage.paint(law, feedback, learned.as_ref(), seed, &mut |_| {})?;
            learned.clone_from(&run.learned);
            // Of the coats with learning only the last is kept.
            rows.truncate(1);
            rows.push(PaintingRow { roller: PAPER[of].0, case, law, feedback, coat, run, paper: PAPER[of].1 });
        }
        Ok(rows)
    };
    let rows = many(jobs.len(), &one, &|what, share| watch(&format!("painting: {what}"), 0.45 + 0.55 * share))?;
    let rows = rows.into_iter().flatten().collect();
    let noise = crate::apps::paper::tool::PAPER_TORQUE_NOISE;
    let mean = noise.iter().sum::<f64>() / noise.len() as f64;
    let gain = Filter::default().noise_gain(Lwr::sensors().rate);
    Ok(Painting {
        settings: *settings,
        force: rig::FORCE,
        seconds: stands[0].rollers.iter().map(Rig::seconds).collect(),
        torque: stands.iter().map(|s| s.torque).collect(),
        noise: [mean, gain * mean],
        rows,
        diagnosis,
    })
}
