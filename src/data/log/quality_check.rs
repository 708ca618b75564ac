//! Checks every row of a log once, in order, and decides which rows are used. All findings are
//! returned at the end.

use super::Acceptance;
use super::Block;
use super::Finding;
use super::Kind;
use super::Layout;
use super::Quantity;
use super::Role;
use super::Severity;

/// Range of a column's values.
#[derive(Debug, Clone, PartialEq)]
pub struct Reached {
    /// Name of the column: `q3`, `tau3`.
    pub column: String,
    /// Smallest and largest value.
    pub range: [f64; 2],
}

/// Verdict on a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// The row is used and continues the segment.
    Continue,
    /// The row is used and starts a segment.
    Start,
    /// The row is left out.
    Drop,
}

/// Longest step in periods that is no gap: one or two missing samples are interpolated.
const GAP: f64 = 2.5;

/// Quality check of a log, fed block by block.
#[derive(Debug, Clone)]
pub struct QualityCheck {
    keep: Acceptance,
    /// Index of `t` and of `seg` among a block's columns.
    time: usize,
    segment: Option<usize>,
    /// Indices of the used columns, whose cells must be numbers.
    needed: Vec<usize>,
    names: Vec<String>,
    channels: Vec<Channel>,
    findings: Vec<Finding>,
    period: Option<f64>,
    before: Option<Before>,
    split_next: bool,
    samples: usize,
    clock: ClockFigures,
}

#[derive(Debug, Clone, Copy)]
struct Before {
    time: f64,
    segment: f64,
}

#[derive(Debug, Clone, Default)]
struct ClockFigures {
    steps: usize,
    far: usize,
    squares: f64,
    shortest: f64,
    longest: f64,
    first_far: u64,
}

impl QualityCheck {
    /// Creates a check for a log with these columns. `q`, `torques` and every quantity that is not
    /// a torque are used.
    pub fn new(layout: &Layout, torques: &[Quantity], keep: Acceptance) -> Self {
        let names: Vec<String> = layout.roles.iter().map(|r| r.name()).collect();
        let mut findings = Vec::new();
        if !layout.ignored.is_empty() {
            let kind = Kind::UnknownColumns { names: layout.ignored.clone() };
            findings.push(Finding { kind, severity: Severity::Note, line: Some(1), column: None, count: 1 });
        }
        let used = |role: &Role| match role {
            Role::Time | Role::Segment => true,
            Role::Joint(q, _) => torques.contains(q) || matches!(q, Quantity::Q | Quantity::Dq | Quantity::Ddq),
            Role::Wrench(_) => false,
        };
        Self {
            keep,
            time: layout.find(Role::Time).unwrap_or(0),
            segment: layout.find(Role::Segment),
            needed: (0..layout.roles.len()).filter(|&i| used(&layout.roles[i])).collect(),
            channels: layout
                .roles
                .iter()
                .enumerate()
                .filter_map(|(column, role)| match *role {
                    Role::Joint(q, joint) if q == Quantity::Q || torques.contains(&q) => {
                        let position = layout.find(Role::Joint(Quantity::Q, joint)).filter(|_| torques.contains(&q));
                        Some(Channel::new(column, position))
                    }
                    _ => None,
                })
                .collect(),
            names,
            findings,
            period: None,
            before: None,
            split_next: true,
            samples: 0,
            clock: ClockFigures { shortest: f64::INFINITY, ..Default::default() },
        }
    }

    /// Usual step of the clock, s; known once a block was checked.
    pub fn period(&self) -> Option<f64> {
        self.period
    }

    /// Decides on each row of the next block.
    pub fn admit(&mut self, block: &Block, verdicts: &mut Vec<Verdict>) {
        verdicts.clear();
        if self.period.is_none() {
            self.period = median_step(&block.columns[self.time]);
        }
        let mut bad = block.bad.iter().peekable();
        let finite = self.needed.iter().all(|&column| all_finite(&block.columns[column]));
        for row in 0..block.len() {
            let line = block.lines[row];
            let mut usable = true;
            while let Some(cell) = bad.next_if(|cell| cell.row <= row) {
                let text = cell.text.clone();
                match cell.column {
                    None => {
                        self.note(Kind::RowLength { text }, self.keep.bad_rows, line, None);
                        usable = false;
                    }
                    Some(column) if self.needed.contains(&column) => {
                        self.note(Kind::NotANumber { text }, self.keep.bad_rows, line, Some(column));
                        usable = false;
                    }
                    Some(_) => {}
                }
            }
            if usable && !finite {
                for i in 0..self.needed.len() {
                    let column = self.needed[i];
                    if !block.columns[column][row].is_finite() {
                        self.note(Kind::NotFinite, self.keep.bad_rows, line, Some(column));
                        usable = false;
                    }
                }
            }
            let verdict = if usable { self.judge_time(block, row, line) } else { Verdict::Drop };
            self.split_next = !usable || (self.split_next && verdict == Verdict::Drop);
            self.samples += usize::from(verdict != Verdict::Drop);
            verdicts.push(verdict);
        }
        // Column by column: most stretches pass without a check of each single row.
        let time = &block.columns[self.time];
        for channel in &mut self.channels {
            let (mut look, values) = (channel.clone(), &block.columns[channel.column]);
            let positions = channel.position.map(|column| &block.columns[column]);
            let mut from = 0;
            for part in verdicts.chunks(STRETCH) {
                let rows = from..from + part.len();
                let at = |row: usize| (positions.map_or(0.0, |column| column[row]), time[row], block.lines[row]);
                from = rows.end;
                let plain = part.iter().fold(true, |all, v| all & (*v == Verdict::Continue));
                if plain && look.passes(&values[rows.clone()], at(rows.end - 1)) {
                    continue;
                }
                for (row, verdict) in rows.zip(part).filter(|(_, v)| **v != Verdict::Drop) {
                    look.look(values[row], at(row), *verdict == Verdict::Start);
                }
            }
            *channel = look;
        }
    }

    fn judge_time(&mut self, block: &Block, row: usize, line: u64) -> Verdict {
        let time = block.columns[self.time][row];
        let segment = self.segment.map_or(0.0, |i| block.columns[i][row]);
        let before = self.before.replace(Before { time, segment });
        let Some(before) = before else { return Verdict::Start };
        if self.split_next || segment != before.segment {
            return Verdict::Start;
        }
        let step = time - before.time;
        let time_column = Some(self.time);
        if step < 0.0 {
            let kind = Kind::TimeRunsBack { from: before.time, to: time };
            self.note(kind, self.keep.restarts, line, time_column);
            return Verdict::Start;
        }
        if step == 0.0 {
            self.note(Kind::DuplicateTime { at: time }, self.keep.duplicates, line, time_column);
            return Verdict::Drop;
        }
        let Some(period) = self.period else { return Verdict::Continue };
        if step > GAP * period {
            self.note(Kind::Gap { longest: step, period }, self.keep.gaps, line, time_column);
            return Verdict::Start;
        }
        let clock = &mut self.clock;
        clock.steps += 1;
        clock.squares += (step - period) * (step - period);
        clock.shortest = clock.shortest.min(step);
        clock.longest = clock.longest.max(step);
        if (step - period).abs() > 0.5 * period {
            clock.far += 1;
            if clock.first_far == 0 {
                clock.first_far = line;
            }
        }
        Verdict::Continue
    }

    /// Counts a finding of this kind in this column, adding it if it is new.
    fn note(&mut self, kind: Kind, allowed: bool, line: u64, column: Option<usize>) {
        let name = column.map(|c| self.names[c].clone());
        let same =
            |f: &&mut Finding| std::mem::discriminant(&f.kind) == std::mem::discriminant(&kind) && f.column == name;
        if let Some(known) = self.findings.iter_mut().find(same) {
            known.count += 1;
            if let (Kind::Gap { longest, .. }, Kind::Gap { longest: here, .. }) = (&mut known.kind, &kind) {
                *longest = longest.max(*here);
            }
            return;
        }
        let severity = if allowed { Severity::Warning } else { Severity::Fatal };
        self.findings.push(Finding { kind, severity, line: Some(line), column: name, count: 1 });
    }

    /// Ranges reached so far by the position columns and the used torque columns.
    pub fn reached(&self) -> Vec<Reached> {
        let of = |channel: &Channel| Reached {
            column: self.names[channel.column].clone(),
            range: [-channel.bottom.level, channel.top.level],
        };
        self.channels.iter().filter(|c| c.top.samples > 0).map(of).collect()
    }

    /// All findings, the most severe first, otherwise in the order of the file.
    pub fn finish(mut self) -> Vec<Finding> {
        let period = self.period.unwrap_or(0.0);
        let clock = self.clock.clone();
        if clock.steps > 0 {
            let rms = (clock.squares / clock.steps as f64).sqrt();
            let share = clock.far as f64 / clock.steps as f64;
            if share > 0.05 {
                let kind = Kind::IrregularClock { period, share };
                self.note(kind, self.keep.irregular_clock, clock.first_far, Some(self.time));
            } else if rms > 1e-3 * period {
                let kind = Kind::Jitter { period, rms, shortest: clock.shortest, longest: clock.longest };
                self.findings.push(Finding {
                    kind,
                    severity: Severity::Note,
                    line: None,
                    column: Some(self.names[self.time].clone()),
                    count: 1,
                });
            }
        }
        let channels = std::mem::take(&mut self.channels);
        for channel in &channels {
            for (kind, line, count) in channel.findings(period, self.samples) {
                let allowed = match kind {
                    Kind::Stuck { .. } => self.keep.stuck,
                    Kind::Clipped { .. } => self.keep.clipped,
                    Kind::DeadTorque => self.keep.dead_torque,
                    _ => self.keep.large_angles,
                };
                self.note(kind, allowed, line, Some(channel.column));
                if let Some(last) = self.findings.last_mut() {
                    last.count = count;
                }
            }
        }
        let size = match self.samples {
            0..20 => Some((Kind::TooFew { samples: self.samples }, Severity::Fatal)),
            20..200 => Some((Kind::TooFew { samples: self.samples }, Severity::Warning)),
            5_000_000.. => Some((Kind::VeryLong { samples: self.samples }, Severity::Note)),
            _ => None,
        };
        if let Some((kind, severity)) = size {
            self.findings.push(Finding { kind, severity, line: None, column: None, count: 1 });
        }
        self.findings.sort_by_key(|f| (std::cmp::Reverse(f.severity), f.line));
        self.findings
    }
}

/// Whether all values are finite.
fn all_finite(column: &[f64]) -> bool {
    column.chunks(64).all(|part| part.iter().fold(true, |all, x| all & x.is_finite()))
}

/// Median of the positive time steps, s.
fn median_step(time: &[f64]) -> Option<f64> {
    let mut steps: Vec<f64> = time.windows(2).map(|w| w[1] - w[0]).filter(|d| d.is_finite() && *d > 0.0).collect();
    let middle = steps.len().checked_sub(1)? / 2;
    Some(*steps.select_nth_unstable_by(middle, f64::total_cmp).1)
}

/// Range within which a joint counts as resting, rad or m: its torque may then be constant.
const REST: f64 = 1e-3;

/// Shortest run of equal values that is examined, samples.
const LONG: usize = 10;
/// Number of rows that are passed at once.
const STRETCH: usize = 64;

/// Running statistics of a `q` or torque column.
#[derive(Debug, Clone)]
struct Channel {
    column: usize,
    torque: bool,
    /// For a torque: the position column of the joint.
    position: Option<usize>,
    largest: f64,
    /// Sum and number of nonzero changes.
    moved: f64,
    moves: usize,
    last: f64,
    before_stay: f64,
    stay: Stay,
    /// Longest constant run that ended with a jump, number of such runs, and start of the first
    /// one.
    stuck: Option<(f64, f64, u64, usize)>,
    top: Plateau,
    bottom: Plateau,
}

/// A run of equal values.
#[derive(Debug, Clone, Copy, Default)]
struct Stay {
    samples: usize,
    since: f64,
    line: u64,
    until: f64,
    /// Joint position at the start of the run, and largest distance from it, rad or m.
    from: f64,
    travel: f64,
}

/// Number and length of the runs at a channel's extreme value.
#[derive(Debug, Clone, Copy, Default)]
struct Plateau {
    level: f64,
    samples: usize,
    run: usize,
    longest: usize,
    runs: usize,
    line: u64,
}

impl Plateau {
    fn look(&mut self, value: f64, line: u64) {
        if value > self.level || self.samples == 0 {
            *self = Self { level: value, samples: 1, run: 1, longest: 1, runs: 0, line };
        } else if value == self.level {
            self.samples += 1;
            self.run += 1;
            self.longest = self.longest.max(self.run);
            if self.run == 3 {
                self.runs += 1;
            }
        } else {
            self.run = 0;
        }
    }

    /// Whether the extreme value is a saturation level. A noisy sensor does not repeat its largest
    /// value often: a level needs 20 samples in all, two runs of at least 3 and one of at least 8.
    fn is_cut_off(&self) -> bool {
        self.longest >= 8 && self.runs >= 2 && self.samples >= 20 && self.level != 0.0
    }
}

impl Channel {
    fn new(column: usize, position: Option<usize>) -> Self {
        Self {
            column,
            torque: position.is_some(),
            position,
            largest: 0.0,
            moved: 0.0,
            moves: 0,
            last: f64::NAN,
            before_stay: 0.0,
            stay: Stay::default(),
            stuck: None,
            top: Plateau::default(),
            bottom: Plateau::default(),
        }
    }

    /// Accepts consecutive rows that affect only the sums: no value equals the previous one, none
    /// is a new extreme, and none ends a constant run. Returns false if they must be checked one by
    /// one. `end`: position, time and line of the last row.
    fn passes(&mut self, values: &[f64], end: (f64, f64, u64)) -> bool {
        let (Some((&first, &last)), false) = (values.first().zip(values.last()), self.stay.samples >= LONG) else {
            return false;
        };
        let (mut apart, mut top, mut bottom) = (first != self.last, first, first);
        for pair in values.windows(2) {
            apart &= pair[0] != pair[1];
            top = if pair[1] > top { pair[1] } else { top };
            bottom = if pair[1] < bottom { pair[1] } else { bottom };
        }
        let inside = self.top.samples > 0 && top < self.top.level && -bottom < self.bottom.level;
        if !apart || !inside || values.len() < 2 {
            return false;
        }
        self.moved += (first - self.last).abs();
        self.moved += values.windows(2).map(|pair| (pair[1] - pair[0]).abs()).sum::<f64>();
        self.moves += values.len();
        (self.top.run, self.bottom.run) = (0, 0);
        self.before_stay = last - values[values.len() - 2];
        self.begin(last, end);
        true
    }

    /// Starts a run of equal values.
    fn begin(&mut self, value: f64, (position, time, line): (f64, f64, u64)) {
        self.last = value;
        self.stay = Stay { samples: 1, since: time, line, until: time, from: position, travel: 0.0 };
    }

    /// Checks one row: value, and its position, time and line. `start`: first row of a segment.
    #[inline]
    fn look(&mut self, value: f64, (position, time, line): (f64, f64, u64), start: bool) {
        self.largest = self.largest.max(value.abs());
        self.top.look(value, line);
        self.bottom.look(-value, line);
        if start {
            self.before_stay = 0.0;
        } else if value == self.last {
            self.stay.samples += 1;
            self.stay.until = time;
            self.stay.travel = self.stay.travel.max((position - self.stay.from).abs());
            return;
        } else {
            let change = value - self.last;
            // Stuck: it was moving, stayed constant for 10 samples or more, then caught up with one
            // jump in the same direction. A torque counts as stuck only while its joint moves: at
            // rest it may be constant, and it changes with the first motion.
            let frozen = || {
                let usual = self.moved / self.moves.max(1) as f64;
                let jumps = change.abs() > 5.0 * self.before_stay.abs().max(usual);
                let moving = self.before_stay.abs() > 0.2 * usual && change * self.before_stay > 0.0;
                jumps && if self.torque { self.stay.travel > REST } else { moving }
            };
            if self.stay.samples >= LONG && self.moves > 20 && frozen() {
                let seconds = self.stay.until - self.stay.since;
                let entry = self.stuck.get_or_insert((self.last, seconds, self.stay.line, 0));
                entry.3 += 1;
                if seconds > entry.1 {
                    (entry.0, entry.1) = (self.last, seconds);
                }
            }
            self.before_stay = change;
            self.moved += change.abs();
            self.moves += 1;
        }
        self.begin(value, (position, time, line));
    }

    fn findings(&self, period: f64, samples: usize) -> Vec<(Kind, u64, usize)> {
        let mut found = Vec::new();
        if samples < 20 {
            return found;
        }
        if self.torque && self.largest == 0.0 {
            found.push((Kind::DeadTorque, 2, 1));
        } else if self.torque && self.moves == 0 {
            found.push((Kind::Stuck { value: self.last, seconds: samples as f64 * period }, 2, 1));
        }
        if let Some((value, seconds, line, count)) = self.stuck {
            found.push((Kind::Stuck { value, seconds }, line, count));
        }
        if self.torque {
            for (plateau, sign) in [(self.top, 1.0), (self.bottom, -1.0)] {
                if plateau.is_cut_off() && self.moves > 20 {
                    let level = sign * plateau.level;
                    found.push((Kind::Clipped { level, samples: plateau.samples }, plateau.line, 1));
                    break;
                }
            }
        } else if self.largest > 4.0 * std::f64::consts::PI {
            found.push((Kind::Degrees { largest: self.largest }, 2, 1));
        }
        found
    }
}
