//! Accumulates motions into one triangular factor per joint, over that joint's columns only.

use crate::data::signal::{Motion, MotionBlock, low_pass};
use crate::identify::regression::batches::Batches;
use crate::identify::regression::r_factor::RFactor;
use crate::identify::regression::rows::Rows;
use crate::model::Arm;

/// Settings of the accumulation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AccumulatorSettings {
    /// Least length of a batch, s, for the standard deviations: several times the correlation time
    /// of filtered noise. Default 0.5, five periods of the default cutoff.
    pub batch: f64,
    /// Low-pass (order, Hz) applied alike to the columns of the regressor and to the torque before
    /// every `stride`th sample is used: Gautier's parallel filter (Khalil and Dombre, section
    /// 12.5.3). Requires motions with margins. Default none.
    pub parallel: Option<(usize, f64)>,
}

impl Default for AccumulatorSettings {
    fn default() -> Self {
        Self { batch: 0.5, parallel: None }
    }
}

/// Factor of one joint's equations: `R_j' R_j = [W_j tau_j]' [W_j tau_j]`.
#[derive(Debug, Clone, PartialEq)]
pub struct JointFactor {
    /// Base parameters on which the joint's torque can depend: the factor's columns before that of
    /// the torque.
    pub columns: Vec<usize>,
    /// Triangular factor with `columns.len() + 1` columns.
    pub triangle: RFactor,
    /// Number of samples used.
    pub samples: usize,
    /// Upper bound of the independent samples among them: a signal without content above `f` has `2
    /// f` values per second (Shannon).
    pub independent: f64,
    /// Smallest and largest torque, N m.
    pub range: [f64; 2],
    /// Smallest and largest position, rad or m.
    pub reach: [f64; 2],
    pub(in crate::identify) batches: Batches,
}

impl JointFactor {
    /// Whether the torque is not zero throughout.
    pub fn is_live(&self) -> bool {
        let n = self.columns.len();
        self.samples > 0 && self.triangle.column(n).iter().any(|v| *v != 0.0)
    }

    /// Root mean square of the torque, N m.
    pub fn torque_rms(&self) -> f64 {
        let n = self.columns.len();
        let mut last = vec![0.0; n + 1];
        last[n] = 1.0;
        self.triangle.norm_of(&last) / (self.samples.max(1) as f64).sqrt()
    }

    /// Root of the sum of squares of `tau - W beta`, N m; `beta`: all base parameters.
    pub fn residual_norm(&self, beta: &[f64]) -> f64 {
        let mut x: Vec<f64> = self.columns.iter().map(|&c| -beta[c]).collect();
        x.push(1.0);
        self.triangle.norm_of(&x)
    }
}

/// Factors of a log; their size does not depend on its length.
#[derive(Debug, Clone, PartialEq)]
pub struct Factors {
    /// Name of the log.
    pub name: String,
    /// One factor per joint.
    pub joints: Vec<JointFactor>,
    /// Seconds of motion.
    pub seconds: f64,
    /// Number of base parameters.
    pub parameters: usize,
}

impl Factors {
    /// Merges batches until each joint has at most `batches`; the fit does not change.
    pub fn shrink(&mut self, batches: usize) {
        self.joints.iter_mut().for_each(|joint| joint.batches.shrink(batches));
    }
}

/// Builds [`Factors`] from motions.
///
/// If a joint is at rest ([`Motion::resting`]), or sticks at a reversal ([`Motion::stuck`]), its
/// Coulomb column and its true friction differ by up to twice the friction. The joint's own row is
/// therefore left out. The part that the low-pass carries to later rows is kept: on short
/// recordings of real arms those rows have more information than error. A joint that rests for more
/// than half of a stretch is assumed to stand on purpose: its rows are kept, with zero in the
/// Coulomb column.
pub struct QrAccumulator<'a> {
    arm: &'a dyn Arm,
    settings: AccumulatorSettings,
    factors: Factors,
    rows: Rows,
    in_batch: usize,
    block: MotionBlock,
    regressor: Vec<f64>,
    work: Vec<f64>,
}

/// Samples at which velocities have no sign.
#[derive(Clone, Copy)]
struct Still<'a> {
    /// Marks of each joint, followed by those of the sums, at each selected sample of a motion.
    marks: &'a [bool],
    /// Number of selected samples.
    picks: usize,
    /// First selected sample of the current block.
    from: usize,
    /// Whether each joint, then each sum, stands for most of the stretch.
    stands: &'a [bool],
}

impl Still<'_> {
    fn at(self, from: usize) -> Self {
        Self { from, ..self }
    }

    fn marked(&self, row: usize, sample: usize) -> bool {
        self.marks.get(row * self.picks + self.from + sample).copied().unwrap_or(false)
    }
}

/// Samples that are evaluated and annihilated at once, such that a joint's block stays in the
/// second-level cache.
const BLOCK: usize = 256;

impl<'a> QrAccumulator<'a> {
    /// Creates an accumulator for a log named `name` of `arm`.
    pub fn new(name: &str, arm: &'a dyn Arm, settings: AccumulatorSettings) -> Self {
        let parameters = arm.base_parameters().len();
        let rows = Rows::new(arm);
        let joints: Vec<JointFactor> = rows
            .columns
            .iter()
            .cloned()
            .map(|columns| JointFactor {
                triangle: RFactor::new(columns.len() + 1),
                columns,
                samples: 0,
                independent: 0.0,
                range: [f64::INFINITY, f64::NEG_INFINITY],
                reach: [f64::INFINITY, f64::NEG_INFINITY],
                batches: Batches::new(),
            })
            .collect();
        Self {
            factors: Factors { name: name.into(), joints, seconds: 0.0, parameters },
            arm,
            settings,
            rows,
            in_batch: 0,
            block: MotionBlock::default(),
            regressor: Vec::new(),
            work: Vec::new(),
        }
    }

    /// Adds a stretch of motion.
    pub fn absorb(&mut self, motion: &Motion) {
        let stands = self.stands(motion);
        let (marks, picks) = (self.still(motion), motion.picks().len());
        let still = Still { marks: &marks, picks, from: 0, stands: &stands };
        let step = motion.period * motion.stride.max(1) as f64;
        let full = ((self.settings.batch / step).ceil() as usize).max(8);
        self.factors.seconds += motion.picks().len() as f64 * step;
        let before: Vec<usize> = self.factors.joints.iter().map(|factor| factor.samples).collect();
        self.absorb_rows(motion, still, full);
        let share = independent_share(motion, step);
        for (factor, before) in self.factors.joints.iter_mut().zip(before) {
            factor.independent += share * (factor.samples - before) as f64;
        }
    }

    fn absorb_rows(&mut self, motion: &Motion, still: Still<'_>, full: usize) {
        for (factor, q) in self.factors.joints.iter_mut().zip(motion.states.q.chunks_exact(motion.states.len.max(1))) {
            for s in motion.picks() {
                factor.reach = [factor.reach[0].min(q[s]), factor.reach[1].max(q[s])];
            }
        }
        if let Some((order, cutoff)) = self.settings.parallel
            && let Ok(sos) = low_pass(order, cutoff, motion.period.recip())
        {
            self.absorb_filtered(motion, &sos, still, full);
            return;
        }
        let (mut block, mut regressor) = (std::mem::take(&mut self.block), std::mem::take(&mut self.regressor));
        let mut from = 0;
        loop {
            let rows = BLOCK.min(full - self.in_batch);
            let count = motion.gather(from, rows, &mut block);
            if count == 0 {
                break;
            }
            from += count;
            self.rows.evaluate(self.arm, &block.states, &block.sign, &mut regressor);
            self.take_block(still.at(from - count), &regressor, &block.tau, count);
            self.end_batch(full);
        }
        (self.block, self.regressor) = (block, regressor);
    }

    /// Filters each column and the torque by the same low-pass, then uses the selected samples.
    fn absorb_filtered(&mut self, motion: &Motion, sos: &crate::data::signal::Sos, still: Still<'_>, full: usize) {
        let len = motion.states.len;
        let mut regressor = Vec::new();
        self.rows.evaluate(self.arm, &motion.states, &motion.sign, &mut regressor);
        let mut tau = motion.tau.clone();
        let pad = sos.settling();
        let picks: Vec<usize> = motion.picks().collect();
        let thin = |x: &mut Vec<f64>| {
            let mut out = Vec::with_capacity(x.len() / len.max(1) * picks.len());
            for column in x.chunks_exact_mut(len.max(1)) {
                sos.forward_backward(column, pad);
                out.extend(picks.iter().map(|&s| column[s]));
            }
            *x = out;
        };
        thin(&mut regressor);
        thin(&mut tau);
        let count = picks.len();
        let part = |x: &[f64], rows: std::ops::Range<usize>| -> Vec<f64> {
            x.chunks_exact(count.max(1)).flat_map(|c| c[rows.clone()].to_vec()).collect()
        };
        let mut from = 0;
        while from < count {
            let rows = from..(from + BLOCK.min(full - self.in_batch)).min(count);
            from = rows.end;
            let (w, t) = (part(&regressor, rows.clone()), part(&tau, rows.clone()));
            self.take_block(still.at(rows.start), &w, &t, rows.len());
            self.end_batch(full);
        }
    }

    /// Whether each joint, then each summed velocity, rests for more than half of the stretch.
    fn stands(&self, motion: &Motion) -> Vec<bool> {
        let len = motion.states.len;
        let rows = self.arm.dof() + self.rows.sums.len();
        let row = |k: usize| motion.resting.get(k * len..(k + 1) * len).unwrap_or(&[]);
        (0..rows).map(|k| 2 * row(k).iter().filter(|r| **r).count() > len).collect()
    }

    /// Marks of selected samples at which the velocity of each joint, then of each sum, has no
    /// sign.
    fn still(&self, motion: &Motion) -> Vec<bool> {
        let (len, dof) = (motion.states.len, self.arm.dof());
        let mut out = Vec::new();
        for k in 0..dof + self.rows.sums.len() {
            let mut marks = vec![false; len];
            for source in [&motion.resting, &motion.stuck].into_iter().take(if k < dof { 2 } else { 1 }) {
                let row = source.get(k * len..(k + 1) * len).unwrap_or(&[]);
                marks.iter_mut().zip(row).for_each(|(mark, still)| *mark |= still);
            }
            out.extend(motion.picks().map(|s| marks[s]));
        }
        out
    }

    /// Adds rows to the factors. `regressor`: by entry of the pattern, `count` rows each; `tau`:
    /// joint-major.
    fn take_block(&mut self, still: Still<'_>, regressor: &[f64], tau: &[f64], count: usize) {
        let (dof, stands) = (self.arm.dof(), still.stands);
        let rests = |k: usize, s: usize| still.marked(k, s);
        for (joint, factor) in self.factors.joints.iter_mut().enumerate() {
            let n = factor.columns.len();
            let entries = self.rows.offsets[joint]..self.rows.offsets[joint + 1];
            let w = &regressor[entries.start * count..entries.end * count];
            let tau = &tau[joint * count..(joint + 1) * count];
            // Each velocity whose sign occurs in these rows, with the columns of the sign.
            let own = self.rows.coulomb[joint].map(|k| (joint, vec![k]));
            let mut signs: Vec<(usize, Vec<usize>)> = own.into_iter().collect();
            for (k, summed) in self.rows.sums.iter().enumerate() {
                let here = summed.entries.iter().filter(|(entry, _)| entries.contains(entry));
                let columns: Vec<usize> = here.map(|(entry, _)| entry - entries.start).collect();
                if !columns.is_empty() {
                    signs.push((dof + k, columns));
                }
            }
            let moves = |s: &usize| signs.iter().all(|&(k, _)| stands[k] || !rests(k, *s));
            let kept: Vec<usize> = (0..count).filter(moves).collect();
            let used = kept.len();
            // Rows of zeros, which change nothing, fill the last registers.
            let rows = used.next_multiple_of(8);
            self.work.clear();
            for (column, end) in w.chunks_exact(count.max(1)).chain([tau]).zip(1..) {
                match used == count {
                    true => self.work.extend_from_slice(column),
                    false => self.work.extend(kept.iter().map(|&s| column[s])),
                }
                self.work.resize(end * rows, 0.0);
            }
            for (k, columns) in signs.iter().filter(|(k, _)| stands[*k]) {
                for &c in columns {
                    let column = self.work[c * rows..][..used].iter_mut();
                    column.zip(&kept).filter(|(_, s)| rests(*k, **s)).for_each(|(w, _)| *w = 0.0);
                }
            }
            for &value in &self.work[n * rows..][..used] {
                factor.range = [factor.range[0].min(value), factor.range[1].max(value)];
            }
            factor.samples += used;
            factor.batches.add(&self.work, n + 1);
            factor.triangle.absorb(&mut self.work, rows);
        }
        self.in_batch += count;
    }

    fn end_batch(&mut self, full: usize) {
        if self.in_batch >= full {
            self.in_batch = 0;
            self.factors.joints.iter_mut().for_each(|factor| factor.batches.end_one(factor.columns.len() + 1));
        }
    }

    /// Factors of all motions that were added.
    pub fn finish(mut self) -> Factors {
        if self.in_batch > 0 {
            self.end_batch(self.in_batch);
        }
        self.factors.joints.iter_mut().for_each(|j| j.batches.close());
        self.factors
    }
}

/// Independent samples of a stretch of low-passed torque, `2 f T + 1` (Shannon), per used sample;
/// at most 1.
fn independent_share(motion: &Motion, step: f64) -> f64 {
    let samples = motion.picks().len() as f64;
    motion.bandwidth.map_or(1.0, |f| ((2.0 * f * samples * step + 1.0) / samples).min(1.0))
}
