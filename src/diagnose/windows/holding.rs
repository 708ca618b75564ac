//! The recordings that a diagnosis holds: all that is read, or pieces of it, evenly spread, where all
//! would take too much memory.
//!
//! How much will come is not known beforehand. So each piece has a rank as it comes, the fraction of
//! its number times the golden ratio, and where memory ends those of the highest ranks go: what ranks
//! below a limit is spread evenly, whatever the limit (H. Weyl 1916). The first piece of each use
//! always stays.

use super::recording::{Recording, Stretch};
use super::windowed_data::samples_of_window;
use crate::data::signal::Motion;
use crate::model::Arm;

/// Memory of a diagnosis beside what does not grow with the recordings, bytes: with the program, the
/// fingerprints of the logs and the columns that a search keeps, less than 200 MB.
const MOST: usize = 90_000_000;

/// Bytes of a joint's sample: in the recording, in the part of it that is fitted or validated, in the
/// errors of two models.
const SAMPLE: usize = 150;

/// Bytes of a joint's window: motion, torques, columns that are tried. In a refit each entry of the base
/// regressor is a column, too.
const WINDOW: usize = 60;
const ENTRY: usize = 6;

/// Length of a piece, s: many times what a stretch loses at its ends and what its filters remember.
const PIECE: f64 = 4.0;

/// The golden ratio less 1.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// What a log is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Use {
    /// Causes are looked for in it.
    Fit,
    /// The gain is measured on it.
    Validate,
}

/// Recordings of both uses, of bounded size.
#[derive(Debug)]
pub struct Holding {
    /// Windows per second.
    rate: f64,
    /// Bytes of a window of all joints.
    window: usize,
    /// Most bytes.
    most: usize,
    /// Pieces below this rank are held; `None`: everything, uncut.
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
    /// Pieces that came, those that are not held included.
    pieces: usize,
    /// Seconds that came.
    seconds: f64,
    /// Ranks of the stretches, where they are pieces.
    ranks: Vec<f64>,
}

/// A recording that is being read.
#[derive(Debug)]
pub struct Coming {
    of: Use,
    held: Held,
}

/// What was left out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Thinning {
    /// Length of the pieces that were used, s.
    pub piece: f64,
    /// Seconds that were used, and those that the recordings have.
    pub seconds: [f64; 2],
    /// Recordings, shorter than what is left out between two pieces, of which nothing is used.
    pub without: usize,
}

/// Pieces of a stretch.
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

    /// Holds the pieces of a stretch below a rank; `number`: of its first piece.
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

    /// Cuts what is whole.
    fn cut(&mut self) {
        let mut number = self.first;
        for stretch in std::mem::take(&mut self.recording.stretches) {
            self.hold(&stretch, number, 1.0);
            number += pieces(&stretch);
        }
    }

    /// Leaves pieces below a rank.
    fn leave(&mut self, limit: f64) {
        let mut ranks = self.ranks.iter();
        self.recording.stretches.retain(|_| ranks.next().is_some_and(|rank| *rank < limit));
        self.ranks.retain(|rank| *rank < limit);
    }
}

impl Holding {
    /// For a diagnosis of this arm with so many windows per second.
    pub fn new(arm: &dyn Arm, rate: f64) -> Self {
        let window = WINDOW * arm.dof() + ENTRY * arm.base_pattern().len();
        Self { rate, window, most: MOST, limit: None, fit: Vec::new(), validate: Vec::new() }
    }

    /// Bytes that a diagnosis of a recording takes.
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

    /// Before a recording is read; one that is read again begins again.
    pub fn begin(&mut self, of: Use, name: &str) -> Coming {
        let first = self.of(of).iter().map(|held| held.pieces).sum();
        let recording = Recording::new(name);
        Coming { of, held: Held { recording, first, pieces: 0, seconds: 0.0, ranks: Vec::new() } }
    }

    /// Takes in a stretch of motion of the recording that is being read.
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

    /// Bytes of what is held.
    fn held(&self) -> usize {
        self.fit.iter().chain(&self.validate).map(|held| self.bytes(held)).sum()
    }

    /// The recording was read to its end. Whether what is held is no more than wanted.
    pub fn end(&mut self, coming: Coming) -> bool {
        let Coming { of, held } = coming;
        self.of(of).push(held);
        self.held() <= self.most
    }

    /// Recordings to fit and to validate, those without a sample left out where that is too much;
    /// what is missing.
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

    /// For so many samples of joints, ten of which are a window.
    fn holding(most: usize) -> Holding {
        Holding { rate: 10.0, window: 20 * 50, most: 200 * most, limit: None, fit: Vec::new(), validate: Vec::new() }
    }

    /// The shares of a sample and of a window.
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

    /// A log of so many samples that comes in chunks.
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

    /// Of an hour as much is held as of minutes, evenly spread, and with its times.
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
            // Neighbouring numbers of Fibonacci, and their sum.
            gaps.for_each(|gap| assert!([13.0, 21.0, 34.0].contains(&gap), "{gap}"));
        }
    }

    /// Hundreds of logs of a piece each: some are used, the first of each use always.
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

    /// A single piece that is too much can't be halved.
    #[test]
    fn one_piece_that_is_too_much_is_said() {
        let mut held = holding(700);
        let mut coming = held.begin(Use::Fit, "a log");
        held.absorb(&mut coming, &motion(0, 400));
        assert!(!held.end(coming));
    }
}
