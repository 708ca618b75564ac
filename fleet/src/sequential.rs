//! A sequential test of change with a stated rate of false alarms.
//!
//! Each channel of a robot gives a number a day. Without a change it has an unknown mean (which may
//! follow the temperature) and an unknown day-to-day scatter. For each day `j` after the reference
//! the evidence that the mean changed after `j` is the Bayes factor of the two-sample t-test with
//! right-Haar prior on mean and scatter and a normal prior on the change, in units of the scatter
//! (Gonen et al., The American Statistician 59, 2005; Perez-Ortiz et al., Annals of Statistics 52,
//! 2024: E-statistics, group invariance and anytime-valid testing). Whatever mean and scatter are,
//! its expectation without a change stays 1 as days pass. The sum over `j` is a Shiryaev-Roberts
//! detector (Shin, Ramdas and Rinaldo, New England Journal of Statistics in Data Science 2, 2024:
//! E-detectors): it grows by 1 a day on average, so the mean time until it passes `A` is at least
//! `A` days. The mean over channels has the same property, so channels need no correction for their
//! number.

use std::collections::VecDeque;

/// How to watch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sequential {
    /// Days before the first change can be found. Default 10.
    pub reference_days: usize,
    /// Mean number of days of one robot between false alarms, at least. Default 365.
    pub days_between: f64,
    /// Oldest change that is looked for, days ago. Default 30; bounds memory and time.
    pub window: usize,
    /// Variance of a change before it is seen, in scatters squared. Default 10.
    pub change: f64,
}

impl Default for Sequential {
    fn default() -> Self {
        Self { reference_days: 10, days_between: 365.0, window: 30, change: 10.0 }
    }
}

/// One day of one channel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Observed {
    /// Estimate.
    pub value: f64,
    /// Variance by noise; infinite where the day does not show the channel.
    pub variance: f64,
}

/// A change that was found.
#[derive(Debug, Clone, PartialEq)]
pub struct Detection {
    /// Index of the channel that shows it best.
    pub channel: usize,
    /// Last day without the change.
    pub before: i32,
    /// Size in the channel's unit, and standard deviation with the scatter in it.
    pub size: [f64; 2],
    /// Value of the detector, days; [`Sequential::days_between`] is where it stops.
    pub evidence: f64,
    /// Per channel: variance of the difference between the two means.
    pub scatter: Vec<f64>,
}

/// Sums over days: weights and values, each with the powers of the temperature.
#[derive(Debug, Clone, Copy, Default)]
struct Sums {
    days: usize,
    w: f64,
    wt: f64,
    wtt: f64,
    wy: f64,
    wty: f64,
    wyy: f64,
}

impl Sums {
    fn add(&mut self, weight: f64, temperature: f64, y: f64) {
        self.days += usize::from(weight > 0.0);
        self.w += weight;
        self.wt += weight * temperature;
        self.wtt += weight * temperature * temperature;
        self.wy += weight * y;
        self.wty += weight * temperature * y;
        self.wyy += weight * y * y;
    }
}

/// Place and scale of a channel, fixed by the reference days.
#[derive(Debug, Clone, Copy)]
struct Scale {
    centre: f64,
    /// Typical standard deviation of a day.
    unit: f64,
    /// Variance between days without that of noise.
    between: f64,
}

/// One day, as weights and scaled values.
#[derive(Debug, Clone)]
struct Day {
    day: i32,
    temperature: f64,
    /// Per channel.
    values: Vec<[f64; 2]>,
}

/// A step, regressed on the days of a channel.
#[derive(Debug, Clone, Copy)]
struct Step {
    log_factor: f64,
    size: f64,
    variance: f64,
}

/// The test of one robot.
#[derive(Debug, Clone)]
pub struct Detector {
    settings: Sequential,
    /// Until there are enough.
    reference: Vec<(i32, Option<f64>, Vec<Observed>)>,
    scales: Vec<Scale>,
    /// Temperature of the first day, if it is used.
    warm: Option<f64>,
    totals: Vec<Sums>,
    days: VecDeque<Day>,
    /// Days since the start, and the last on which a change can't be told yet.
    count: usize,
    evidence: f64,
}

/// Temperatures of the reference that scatter by less than this are no help, deg C.
const LEAST_WARMTH: f64 = 1.0;

impl Detector {
    /// Before the first day.
    pub fn new(settings: Sequential) -> Self {
        Self {
            settings,
            reference: Vec::new(),
            scales: Vec::new(),
            warm: None,
            totals: Vec::new(),
            days: VecDeque::new(),
            count: 0,
            evidence: 0.0,
        }
    }

    /// Value of the detector: it stops at [`Sequential::days_between`].
    pub fn evidence(&self) -> f64 {
        self.evidence
    }

    /// Takes in a day, in order. After a detection the test starts again with the days after the
    /// change.
    pub fn day(&mut self, day: i32, temperature: Option<f64>, observed: &[Observed]) -> Option<Detection> {
        if self.scales.is_empty() {
            self.reference.push((day, temperature, observed.to_vec()));
            if self.reference.len() >= self.settings.reference_days.max(4) {
                self.begin();
            }
            return None;
        }
        let row = self.row(day, temperature, observed)?;
        self.take(row);
        self.test()
    }

    /// Ends the reference: place and scale of each channel.
    fn begin(&mut self) {
        let rows = std::mem::take(&mut self.reference);
        let warmth: Vec<f64> = rows.iter().filter_map(|(_, t, _)| *t).collect();
        let used = warmth.len() == rows.len() && variance(&warmth).sqrt() >= LEAST_WARMTH;
        self.warm = warmth.first().copied().filter(|_| used);
        let channels = rows.iter().map(|(_, _, o)| o.len()).max().unwrap_or(0);
        self.scales = (0..channels).map(|k| scale(rows.iter().filter_map(|(_, _, o)| o.get(k)))).collect();
        self.totals = vec![Sums::default(); channels];
        for (day, temperature, observed) in rows {
            if let Some(row) = self.row(day, temperature, &observed) {
                self.take(row);
            }
        }
    }

    /// Weights and scaled values of a day; `None` where the temperature that is needed is missing.
    fn row(&self, day: i32, temperature: Option<f64>, observed: &[Observed]) -> Option<Day> {
        let temperature = match self.warm {
            Some(first) => temperature? - first,
            None => 0.0,
        };
        let scaled = |(scale, seen): (&Scale, &Observed)| {
            if !(seen.variance.is_finite() && seen.value.is_finite() && scale.unit > 0.0) {
                return [0.0, 0.0];
            }
            let weight = scale.unit * scale.unit / (scale.between + seen.variance);
            [weight, (seen.value - scale.centre) / scale.unit]
        };
        let values = self.scales.iter().zip(observed).map(scaled).collect();
        Some(Day { day, temperature, values })
    }

    fn take(&mut self, row: Day) {
        for (total, [weight, y]) in self.totals.iter_mut().zip(&row.values) {
            total.add(*weight, row.temperature, *y);
        }
        self.count += 1;
        self.days.push_back(row);
        if self.days.len() > self.settings.window.max(1) {
            self.days.pop_front();
        }
    }

    /// Evidence for a change after each day of the window but the reference's.
    fn test(&mut self) -> Option<Detection> {
        let channels = self.totals.len();
        let mut after = vec![Sums::default(); channels];
        let possible = self.count.saturating_sub(self.settings.reference_days.max(4)).min(self.days.len() - 1);
        let (mut evidence, mut best) = (0.0, None::<(f64, usize, usize)>);
        for back in 1..=possible {
            let at = self.days.len() - back;
            let row = &self.days[at];
            for (sums, [weight, y]) in after.iter_mut().zip(&row.values) {
                sums.add(*weight, row.temperature, *y);
            }
            for k in 0..channels {
                let log = self.step(&self.totals[k], &after[k]).map_or(0.0, |step| step.log_factor);
                evidence += log.min(700.0).exp() / channels as f64;
                if best.is_none_or(|(most, _, _)| log > most) {
                    best = Some((log, k, at));
                }
            }
        }
        self.evidence = evidence;
        let (_, channel, at) = best.filter(|_| evidence >= self.settings.days_between)?;
        Some(self.detection(channel, at))
    }

    /// The change between two days of the window, after which the test starts again.
    fn detection(&mut self, channel: usize, at: usize) -> Detection {
        let mut after = vec![Sums::default(); self.totals.len()];
        for row in self.days.range(at..) {
            for (sums, [weight, y]) in after.iter_mut().zip(&row.values) {
                sums.add(*weight, row.temperature, *y);
            }
        }
        let steps: Vec<Option<Step>> = self.totals.iter().zip(&after).map(|(all, own)| self.step(all, own)).collect();
        let square = |k: usize| self.scales[k].unit.powi(2);
        let scatter = |(k, step): (usize, &Option<Step>)| step.map_or(0.0, |step| step.variance * square(k));
        let found = Detection {
            channel,
            before: self.days[at - 1].day,
            size: steps[channel].map_or([0.0, f64::INFINITY], |step| {
                [step.size * self.scales[channel].unit, step.variance.sqrt() * self.scales[channel].unit]
            }),
            evidence: self.evidence,
            scatter: steps.iter().enumerate().map(scatter).collect(),
        };
        self.totals = after;
        self.days.drain(..at);
        self.count = self.days.len();
        self.evidence = 0.0;
        found
    }

    /// The regression of a channel's days on a mean, the temperature, and a step.
    fn step(&self, all: &Sums, after: &Sums) -> Option<Step> {
        let unknowns = 1 + usize::from(self.warm.is_some());
        if after.days == 0 || all.days < unknowns + 3 || after.days >= all.days {
            return None;
        }
        // (a, b)' (Z'Z)^-1 (c, d)
        let product = |[a, b]: [f64; 2], [c, d]: [f64; 2]| match self.warm {
            None => a * c / all.w,
            Some(_) => {
                let determinant = all.w * all.wtt - all.wt * all.wt;
                (all.wtt * a * c - all.wt * (a * d + b * c) + all.w * b * d) / determinant
            }
        };
        let (zx, zy) = ([after.w, after.wt], [all.wy, all.wty]);
        let square = after.w - product(zx, zx);
        let slope = after.wy - product(zx, zy);
        let plain = all.wyy - product(zy, zy);
        if !(square > 1e-9 * after.w && plain > 0.0) {
            return None;
        }
        let rest = (plain - slope * slope / square).max(1e-12 * plain);
        let freedom = (all.days - unknowns - 1) as f64;
        let ratio = (plain - rest) / rest;
        let wide = 1.0 + square * self.settings.change;
        let log_factor = 0.5 * (freedom + 1.0) * ((1.0 + ratio).ln() - (1.0 + ratio / wide).ln()) - 0.5 * wide.ln();
        Some(Step { log_factor, size: slope / square, variance: rest / freedom / square })
    }
}

/// Place and scale of a channel over its reference days. The variance between days is that of the
/// values less that of their noise (DerSimonian and Laird's moments).
fn scale<'a>(seen: impl Iterator<Item = &'a Observed>) -> Scale {
    let seen: Vec<&Observed> = seen.filter(|o| o.variance.is_finite() && o.value.is_finite()).collect();
    let values: Vec<f64> = seen.iter().map(|o| o.value).collect();
    let noise = seen.iter().map(|o| o.variance).sum::<f64>() / seen.len().max(1) as f64;
    let between = (variance(&values) - noise).max(0.0);
    let unit = if values.len() < 3 { 0.0 } else { (between + noise).sqrt() };
    Scale { centre: values.iter().sum::<f64>() / values.len().max(1) as f64, unit, between }
}

fn variance(values: &[f64]) -> f64 {
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n.max(1.0);
    values.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / (n - 1.0).max(1.0)
}

#[cfg(test)]
mod tests;
