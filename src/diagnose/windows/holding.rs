//! Stores the recordings of a diagnosis within a memory limit: everything that is read, or evenly
//! spread pieces of it.
//!
//! The total length is not known in advance. Each piece therefore gets a rank when it arrives, the
//! fraction of its number times the golden ratio. When memory is exhausted, the pieces with the
//! highest ranks are dropped. Pieces with ranks below a limit are evenly spread, whatever the limit
//! (H. Weyl 1916). The first piece of each use always stays.

use super::recording::{Recording, Stretch};
use super::windowed_data::samples_of_window;
use crate::data::signal::Motion;
use crate::model::Arm;

/// Memory limit, bytes, of the part that grows with the recordings. Together with the program, the
/// fingerprints of the logs and the columns that a search stores it is less than 200 MB.
const MOST: usize = 90_000_000;

/// Bytes per sample of a joint: in the recording, in the fitted or validating part of it, in the
/// errors of two models.
const SAMPLE: usize = 150;

/// Bytes per window of a joint: motion, torques, tried columns. In a refit each entry of the base
/// regressor is a column, too.
const WINDOW: usize = 60;
const ENTRY: usize = 6;

/// Length of a piece, s: many times the part that a stretch loses at its ends, and the memory of
/// its filters.
const PIECE: f64 = 4.0;

/// The golden ratio minus 1.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// Use of a log.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Use {
    /// The model is fitted to it.
    Fit,
    /// The gain is measured on it.
    Validate,
}

/// Recordings of both uses, of limited total size.
#[derive(Debug)]
pub struct Holding {
    /// Windows per second.
    rate: f64,
    /// Bytes of a window of all joints.
    window: usize,
    /// Memory limit, bytes.
    most: usize,
    /// Rank below which pieces are kept; `None`: everything is kept, uncut.
    limit: Option<f64>,
    fit: Vec<Held>,
    validate: Vec<Held>,
}

/// A recording, or pieces of it.
#[derive(Debug)]
struct Held {
    recording: Recording,
    /// Number of its first piece.
    first: usize,
    /// Number of pieces read, including dropped ones.
    pieces: usize,
    /// Duration read, s.
    seconds: f64,
    /// Ranks of the stretches, if they are pieces.
    ranks: Vec<f64>,
}

/// A recording that is being read.
#[derive(Debug)]
pub struct Coming {
    of: Use,
    held: Held,
}

/// Amount of data left out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Thinning {
    /// Length of the pieces that were used, s.
    pub piece: f64,
    /// Duration used, and total duration of the recordings, s.
    pub seconds: [f64; 2],
    /// Number of recordings of which nothing is used, because they are shorter than the gap between
    /// two pieces.
    pub without: usize,
}

/// Number of pieces of a stretch.
fn pieces(stretch: &Stretch) -> usize {
    ((stretch.states.len as f64 * stretch.period / PIECE).round() as usize).max(1)
}

impl Held {
    fn absorb(&mut self, motion: &Motion, limit: Option<f64>) {
        if self.pieces == 0 {
            self.recording.begin = motion.segment_start;
        }
        let stretch = Stretch::new(motion);
        self.seconds += stretch.states.len as f64 * stretch.period;
        let number = self.first + self.pieces;
        self.pieces += pieces(&stretch);
        match limit {
            None => self.recording.stretches.push(stretch),
            Some(limit) => self.hold(&stretch, number, limit),
        }
    }

    /// Keeps the pieces of a stretch with ranks below `limit`; `number`: that of its first piece.
    fn hold(&mut self, stretch: &Stretch, number: usize, limit: f64) {
        let (len, count) = (stretch.states.len, pieces(stretch));
        for k in 0..count {
            let rank = (GOLDEN * (number + k) as f64).fract();
            if rank < limit {
                self.recording.stretches.push(stretch.cut(k * len / count..(k + 1) * len / count));
                self.ranks.push(rank);
            }
        }
    }

    /// Cuts whole stretches into pieces.
    fn cut(&mut self) {
        let mut number = self.first;
        for stretch in std::mem::take(&mut self.recording.stretches) {
            self.hold(&stretch, number, 1.0);
            number += pieces(&stretch);
        }
    }

    /// Keeps only pieces with ranks below `limit`.
    fn leave(&mut self, limit: f64) {
        let mut ranks = self.ranks.iter();
        self.recording.stretches.retain(|_| ranks.next().is_some_and(|rank| *rank < limit));
        self.ranks.retain(|rank| *rank < limit);
    }
}

impl Holding {
    /// An empty store for a diagnosis of this arm with `rate` windows per second.
    pub fn new(arm: &dyn Arm, rate: f64) -> Self {
        let window = WINDOW * arm.dof() + ENTRY * arm.base_pattern().len();
        Self { rate, window, most: MOST, limit: None, fit: Vec::new(), validate: Vec::new() }
    }

    /// Bytes that the diagnosis of a recording needs.
    fn bytes(&self, held: &Held) -> usize {
        let of =
            |s: &Stretch| s.tau.len() * SAMPLE + s.states.len / samples_of_window(self.rate, s.period) * self.window;
        held.recording.stretches.iter().map(of).sum()
    }

    fn of(&mut self, of: Use) -> &mut Vec<Held> {
        match of {
            Use::Fit => &mut self.fit,
            Use::Validate => &mut self.validate,
        }
    }

    /// Starts to read a recording; one that is read again starts from its beginning.
    pub fn begin(&mut self, of: Use, name: &str) -> Coming {
        let first = self.of(of).iter().map(|held| held.pieces).sum();
        let recording = Recording::new(name);
        Coming { of, held: Held { recording, first, pieces: 0, seconds: 0.0, ranks: Vec::new() } }
    }

    /// Adds a stretch of motion to the recording that is being read.
    pub fn absorb(&mut self, coming: &mut Coming, motion: &Motion) {
        coming.held.absorb(motion, self.limit);
        while self.held() + self.bytes(&coming.held) > self.most {
            let all = self.fit.iter_mut().chain(&mut self.validate).chain([&mut coming.held]);
            if self.limit.is_none() {
                self.limit = Some(1.0);
                all.for_each(Held::cut);
                continue;
            }
            let highest = all.flat_map(|held| held.ranks.iter()).fold(0.0_f64, |most, rank| most.max(*rank));
            if highest == 0.0 {
                return;
            }
            self.limit = Some(highest);
            let all = self.fit.iter_mut().chain(&mut self.validate).chain([&mut coming.held]);
            all.for_each(|held| held.leave(highest));
        }
    }

    /// Bytes that the stored recordings need.
    fn held(&self) -> usize {
        self.fit.iter().chain(&self.validate).map(|held| self.bytes(held)).sum()
    }

    /// Ends a recording. Returns whether the stored data are within the limit.
    pub fn end(&mut self, coming: Coming) -> bool {
        let Coming { of, held } = coming;
        self.of(of).push(held);
        self.held() <= self.most
    }

    /// Recordings to fit and to validate, and the amount left out. After thinning, recordings
    /// without a sample are omitted.
    pub fn recordings(self) -> ([Vec<Recording>; 2], Option<Thinning>) {
        let Self { limit, fit, validate, .. } = self;
        let came = fit.iter().chain(&validate).map(|held| held.seconds).sum();
        let all = fit.len() + validate.len();
        let used = |held: &Held| limit.is_none() || !held.recording.stretches.is_empty();
        let recordings = [fit, validate]
            .map(|of| of.into_iter().filter(used).map(|held| held.recording).collect::<Vec<Recording>>());
        let seconds = recordings.iter().flatten().map(Recording::seconds).sum();
        let without = all - recordings.iter().map(Vec::len).sum::<usize>();
        let thinning = Thinning { piece: PIECE, seconds: [seconds, came], without };
        (recordings, limit.map(|_| thinning))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::data::signal::Band;
    use crate::model::States;

    const PERIOD: f64 = 0.01;

    /// A store for `most` samples of joints, ten of which are a window.
    fn holding(most: usize) -> Holding {
        Holding { rate: 10.0, window: 20 * 50, most: 200 * most, limit: None, fit: Vec::new(), validate: Vec::new() }
    }

    /// Both the share of samples and that of windows count.
    #[test]
    fn bytes_are_those_of_samples_and_windows() {
        let bytes = |rate: f64| {
            let mut held = Holding { rate, ..holding(10_000) };
            assert!(read(&mut held, Use::Fit, 1_000, 1_000));
            held.held()
        };
        assert_eq!(bytes(10.0), 2_000 * 150 + 100 * 1_000);
        assert_eq!(bytes(1_000.0), 2_000 * 150 + 1_000 * 1_000);
    }

    /// Samples `from..to` of a log of two joints at 100 Hz; the torque is the number of the sample.
    fn motion(from: usize, to: usize) -> Motion {
        let number: Vec<f64> = (0..2).flat_map(|_| (from..to).map(|k| k as f64)).collect();
        let states = States { len: to - from, q: number.clone(), dq: number.clone(), ddq: number.clone() };
        Motion {
            start: 5.0 + from as f64 * PERIOD,
            segment_start: 5.0,
            period: PERIOD,
            states,
            tau: number,
            core: 0..to - from,
            velocity_noise: vec![1e-3; 2],
            band: Band::default(),
            ..Motion::default()
        }
    }

    /// Reads a log of `len` samples in chunks.
    fn read(held: &mut Holding, of: Use, len: usize, chunk: usize) -> bool {
        let mut coming = held.begin(of, "a log");
        for from in (0..len).step_by(chunk) {
            held.absorb(&mut coming, &motion(from, (from + chunk).min(len)));
            assert!(held.held() + held.bytes(&coming.held) <= held.most);
        }
        held.end(coming)
    }

    #[test]
    fn what_fits_is_held_as_it_came() {
        let mut held = holding(40_000);
        assert!(read(&mut held, Use::Fit, 12_000, 5_000) && read(&mut held, Use::Validate, 8_000, 8_000));
        let ([fit, validate], thinning) = held.recordings();
        assert_eq!(thinning, None);
        let mut plain = Recording::new("a log");
        for (from, to) in [(0, 5_000), (5_000, 10_000), (10_000, 12_000)] {
            plain.absorb(&motion(from, to));
        }
        assert_eq!((&fit[..], validate.len()), (&[plain][..], 1));
    }

    /// An hour takes as much memory as minutes, evenly spread, and with its times.
    #[test]
    fn of_what_is_too_long_pieces_are_held() {
        let mut held = holding(40_000);
        assert!(read(&mut held, Use::Fit, 360_000, 8_000) && read(&mut held, Use::Validate, 36_000, 8_000));
        let ([fit, validate], thinning) = held.recordings();
        let Thinning { seconds: [used, all], without, .. } = thinning.unwrap();
        assert_eq!((without, all), (0, 3_960.0));
        // 200 s fit, fifty pieces; every twentieth does.
        assert!((190.0..=200.0).contains(&used), "{used}");
        for (recordings, [least, most]) in [(&fit, [43, 47]), (&validate, [3, 7])] {
            let [recording] = &recordings[..] else { panic!("{}", recordings.len()) };
            assert_eq!((recording.begin, recording.stretches[0].tau[0]), (5.0, 0.0));
            assert!((least..=most).contains(&recording.stretches.len()), "{}", recording.stretches.len());
            for stretch in &recording.stretches {
                let first = stretch.tau[0];
                assert_eq!((first % 400.0, stretch.states.len, stretch.tau[400]), (0.0, 400, first));
                assert!((stretch.start - 5.0 - first * PERIOD).abs() < 1e-9, "{}", stretch.start);
            }
            let gaps = recording.stretches.windows(2).map(|w| (w[1].tau[0] - w[0].tau[0]) / 400.0);
            // Neighbouring Fibonacci numbers, and their sum.
            gaps.for_each(|gap| assert!([13.0, 21.0, 34.0].contains(&gap), "{gap}"));
        }
    }

    /// Hundreds of logs of one piece each: some are used, always including the first of each use.
    #[test]
    fn of_many_short_logs_some_are_used() {
        let mut held = holding(40_000);
        for k in 0..500 {
            assert!(read(&mut held, Use::Fit, 400 + k % 3, 1_000));
        }
        assert!(read(&mut held, Use::Validate, 400, 1_000));
        let ([fit, validate], thinning) = held.recordings();
        let without = thinning.unwrap().without;
        assert_eq!((validate.len(), fit[0].stretches[0].states.len), (1, 400));
        assert!((45..50).contains(&fit.len()) && without == 500 - fit.len(), "{} {without}", fit.len());
    }

    /// A single piece above the limit cannot be halved.
    #[test]
    fn one_piece_that_is_too_much_is_said() {
        let mut held = holding(700);
        let mut coming = held.begin(Use::Fit, "a log");
        held.absorb(&mut coming, &motion(0, 400));
        assert!(!held.end(coming));
    }
}
