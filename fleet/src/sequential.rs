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
//!
//! Days have outliers, and the t-test of one or two days after `j` takes an outlier for a change. So
//! of each Bayes factor the least of three counts: that of all days, that without the first day
//! after `j`, and that without the day that speaks most for the change. It is at most the second,
//! which is the Bayes factor of a series that lacks one day: the bound holds as before. No single
//! day can flag a robot, and a change is found about a day later.
//!
//! Days follow each other, too: a warm week is seven warm days. Rows of a day and of the one before
//! are whitened as those of an autoregressive process of first order, `y(i) - rho y(i-1)`, with one
//! `rho` for all channels of a robot: that which seven tenths of its channels do not exceed, by the
//! days before `j`. A day that shows a channel far less than the next is none before it, for its
//! noise is not what carries over. Where `rho` is known the bound holds as before; it is estimated.

use std::collections::VecDeque;

use serde::{Deserialize, Serialize};

/// How to watch.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
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
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Detection {
    /// Index of the channel that shows it best.
    pub channel: usize,
    /// Last day without the change.
    pub before: i32,
    /// Size in the channel's unit, and standard deviation with the scatter in it.
    pub size: [f64; 2],
    /// Value of the detector, days; [`Sequential::days_between`] is where it stops.
    pub evidence: f64,
    /// Correlation of neighbouring days before the change.
    pub correlation: f64,
}

/// Weighted sums of products over days: of the mean's column, the temperature, and the value.
#[derive(Debug, Clone, Copy, Default)]
struct Products {
    oo: f64,
    ot: f64,
    tt: f64,
    oy: f64,
    ty: f64,
    yy: f64,
}

impl Products {
    /// Adds `weight (a b' + b a') / 2`; entries are one, temperature, value.
    fn add(&mut self, weight: f64, a: [f64; 3], b: [f64; 3]) {
        let pair = |i: usize, k: usize| 0.5 * weight * (a[i] * b[k] + a[k] * b[i]);
        self.oo += pair(0, 0);
        self.ot += pair(0, 1);
        self.tt += pair(1, 1);
        self.oy += pair(0, 2);
        self.ty += pair(1, 2);
        self.yy += pair(2, 2);
    }

    /// `self + factor other`.
    fn plus(self, factor: f64, other: Self) -> Self {
        Self {
            oo: self.oo + factor * other.oo,
            ot: self.ot + factor * other.ot,
            tt: self.tt + factor * other.tt,
            oy: self.oy + factor * other.oy,
            ty: self.ty + factor * other.ty,
            yy: self.yy + factor * other.yy,
        }
    }

    /// Mean, and slope by the temperature if it is used.
    fn fit(&self, warm: bool) -> [f64; 2] {
        self.solve(warm, [self.oy, self.ty])
    }

    /// `(Z'Z)^-1 z`; without temperature the second entry is zero.
    fn solve(&self, warm: bool, [a, b]: [f64; 2]) -> [f64; 2] {
        let determinant = self.oo * self.tt - self.ot * self.ot;
        match warm && determinant > 1e-12 * self.oo * self.tt {
            true => [(self.tt * a - self.ot * b) / determinant, (self.oo * b - self.ot * a) / determinant],
            false => [a / self.oo, 0.0],
        }
    }

    /// `c' P c` for the residual `y - m - s t`.
    fn residual(&self, [m, s]: [f64; 2]) -> f64 {
        let level = m * m * self.oo + 2.0 * m * s * self.ot + s * s * self.tt;
        self.yy - 2.0 * (m * self.oy + s * self.ty) + level
    }
}

/// All days of a channel, for whitening with any `rho`.
#[derive(Debug, Clone, Copy, Default)]
struct Totals {
    days: usize,
    now: Products,
    /// Of a day and the one before.
    lagged: Products,
    before: Products,
}

impl Totals {
    fn add(&mut self, weight: f64, now: [f64; 3], before: Option<[f64; 3]>) {
        self.days += usize::from(weight > 0.0);
        self.now.add(weight, now, now);
        match before {
            Some(before) => {
                self.lagged.add(weight, now, before);
                self.before.add(weight, before, before);
            }
            // The first has the variance of the process: its weight becomes `1 - rho^2` times it.
            None => self.before.add(-weight, now, now),
        }
    }

    fn whitened(&self, rho: f64) -> Products {
        self.now.plus(-2.0 * rho, self.lagged).plus(rho * rho, self.before)
    }

    /// Correlation of neighbouring days, without the bias of a short series.
    fn correlation(&self, warm: bool) -> Option<f64> {
        let fit = self.now.fit(warm);
        let (own, lagged) = (self.now.residual(fit), self.lagged.residual(fit));
        let n = self.days as f64;
        (self.days > 3 && own > 0.0).then(|| (lagged / own + 1.0 / n) / (1.0 - 3.0 / n).max(0.5))
    }
}

/// One whitened day of one channel, with the column of a step.
#[derive(Debug, Clone, Copy, Default)]
struct Row {
    weight: f64,
    columns: [f64; 3],
    step: f64,
}

/// The days after a possible change of one channel.
#[derive(Debug, Clone, Copy, Default)]
struct After {
    days: usize,
    xx: f64,
    ox: f64,
    tx: f64,
    xy: f64,
}

impl After {
    /// Adds a day, or with -1 takes it away.
    fn add(&mut self, sign: f64, Row { weight, columns: [one, warm, y], step }: Row) {
        let days = usize::from(weight > 0.0);
        self.days = if sign > 0.0 { self.days + days } else { self.days - days };
        let x = sign * weight * step;
        self.xx += x * step;
        self.ox += x * one;
        self.tx += x * warm;
        self.xy += x * y;
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
    /// Correlation with the day before, by the days before this one.
    rho: f64,
    /// Per channel.
    values: Vec<[f64; 2]>,
}

impl Day {
    fn weight(&self, channel: usize) -> f64 {
        self.values.get(channel).map_or(0.0, |[weight, _]| *weight)
    }

    fn columns(&self, channel: usize) -> [f64; 3] {
        [1.0, self.temperature, self.values.get(channel).map_or(0.0, |[_, y]| *y)]
    }

    /// The columns of this day as the one before another that shows the channel as well.
    fn before(&self, channel: usize, next: &Day) -> Option<[f64; 3]> {
        let [a, b] = [self, next].map(|day| day.weight(channel));
        (a.min(b) > ALIKE * a.max(b) && next.day - self.day <= LONGEST_PAUSE).then(|| self.columns(channel))
    }
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
    totals: Vec<Totals>,
    days: VecDeque<Day>,
    /// Days since the start, and the last on which a change can't be told yet.
    count: usize,
    evidence: f64,
}

/// Days apart up to which two days are neighbours: a long weekend.
const LONGEST_PAUSE: i32 = 4;

/// Of two days' weights the least, by the larger: a day whose motion hardly shows a channel says
/// nothing of the scatter of the next.
const ALIKE: f64 = 0.5;

/// Share of the channels that have a smaller correlation than the one that is used.
const SHARE: f64 = 0.7;

/// Correlations between these count: less is none, and more leaves nothing of a step.
const CORRELATION: [f64; 2] = [0.1, 0.9];

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
        self.totals = vec![Totals::default(); channels];
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
        Some(Day { day, temperature, rho: self.correlation(), values })
    }

    fn take(&mut self, row: Day) {
        let last = self.days.back();
        for (k, total) in self.totals.iter_mut().enumerate() {
            total.add(row.weight(k), row.columns(k), last.and_then(|last| last.before(k, &row)));
        }
        self.count += 1;
        self.days.push_back(row);
        if self.days.len() > self.settings.window.max(1) {
            self.days.pop_front();
        }
    }

    /// Correlation of neighbouring days so far, for all channels.
    fn correlation(&self) -> f64 {
        let mut all: Vec<f64> = self.totals.iter().filter_map(|total| total.correlation(self.warm.is_some())).collect();
        if all.is_empty() {
            return 0.0;
        }
        let at = ((all.len() - 1) as f64 * SHARE) as usize;
        let (_, rho, _) = all.select_nth_unstable_by(at, f64::total_cmp);
        if *rho < CORRELATION[0] { 0.0 } else { rho.min(CORRELATION[1]) }
    }

    /// Evidence for a change after each day of the window but the reference's.
    fn test(&mut self) -> Option<Detection> {
        let channels = self.totals.len();
        let possible = self.count.saturating_sub(self.settings.reference_days.max(4)).min(self.days.len() - 1);
        let (mut evidence, mut best) = (0.0, None::<(f64, usize, usize)>);
        for at in (self.days.len() - possible..self.days.len()).rev() {
            for k in 0..channels {
                let log = self.log_factor(k, at);
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
        let rho = self.days[at].rho;
        let mut after = After::default();
        (at..self.days.len()).for_each(|i| after.add(1.0, self.whitened(channel, i, at, rho)));
        let step = self.step(self.totals[channel].days, &self.totals[channel].whitened(rho), &after);
        let unit = self.scales[channel].unit;
        let found = Detection {
            channel,
            before: self.days[at - 1].day,
            size: step.map_or([0.0, f64::INFINITY], |step| [step.size * unit, step.variance.sqrt() * unit]),
            evidence: self.evidence,
            correlation: rho,
        };
        let kept: Vec<Day> = self.days.drain(..).skip(at).collect();
        self.totals.fill(Totals::default());
        (self.count, self.evidence) = (0, 0.0);
        kept.into_iter().for_each(|day| self.take(day));
        found
    }

    /// Day `i` of the window without its share of the day before, for a step at day `at`.
    fn whitened(&self, channel: usize, i: usize, at: usize, rho: f64) -> Row {
        let (day, step) = (&self.days[i], f64::from(u8::from(i >= at)));
        let (weight, columns) = (day.weight(channel), day.columns(channel));
        match i.checked_sub(1).and_then(|last| self.days[last].before(channel, day)) {
            Some(before) => {
                let columns = std::array::from_fn(|c| columns[c] - rho * before[c]);
                Row { weight, columns, step: step - rho * f64::from(u8::from(i > at)) }
            }
            None => Row { weight: weight * (1.0 - rho * rho), columns, step },
        }
    }

    /// The evidence that no single day makes alone.
    fn log_factor(&self, channel: usize, at: usize) -> f64 {
        let (total, rho) = (&self.totals[channel], self.days[at].rho);
        let all = total.whitened(rho);
        let [mean, slope] = all.fit(self.warm.is_some());
        let (mut after, mut ends) = (After::default(), [None::<(f64, Row)>; 2]);
        let mut first = Row::default();
        for i in at..self.days.len() {
            let row = self.whitened(channel, i, at, rho);
            after.add(1.0, row);
            if i == at {
                first = row;
            }
            let [one, warm, y] = row.columns;
            let value = y - mean * one - slope * warm;
            for (end, sign) in ends.iter_mut().zip([-1.0, 1.0]).filter(|_| row.weight > 0.0) {
                if end.is_none_or(|(known, _)| sign * (value - known) > 0.0) {
                    *end = Some((value, row));
                }
            }
        }
        let Some(step) = self.step(total.days, &all, &after) else { return 0.0 };
        let without = |row: Row| {
            let (mut after, mut all) = (after, all);
            after.add(-1.0, row);
            all.add(-row.weight, row.columns, row.columns);
            let days = total.days - usize::from(row.weight > 0.0);
            self.step(days, &all, &after).map_or(0.0, |step| step.log_factor)
        };
        let most = ends[usize::from(step.size > 0.0)].map_or(0.0, |(_, row)| without(row));
        step.log_factor.min(without(first)).min(most)
    }

    /// The regression of a channel's days on a mean, the temperature, and a step.
    fn step(&self, days: usize, all: &Products, after: &After) -> Option<Step> {
        let warm = self.warm.is_some();
        let unknowns = 1 + usize::from(warm);
        if after.days == 0 || days < unknowns + 3 || after.days >= days {
            return None;
        }
        let [one, other] = all.solve(warm, [after.ox, after.tx]);
        let square = after.xx - one * after.ox - other * after.tx;
        let slope = after.xy - one * all.oy - other * all.ty;
        let [mean, by_warmth] = all.fit(warm);
        let plain = all.yy - mean * all.oy - by_warmth * all.ty;
        if !(square > 1e-9 * after.xx && plain > 0.0) {
            return None;
        }
        let rest = (plain - slope * slope / square).max(1e-12 * plain);
        let freedom = (days - unknowns - 1) as f64;
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
