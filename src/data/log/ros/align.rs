//! Interpolates streams with separate clocks to the stamps of one of them.

use std::collections::VecDeque;

/// Longest gap that is interpolated, in mean periods of the stream.
const LONGEST_GAP: f64 = 5.0;
/// Most rows that wait for a slower stream, and most samples that wait for a row.
const LONGEST_WAIT: usize = 1 << 15;

/// Samples of a stream that later rows may still need.
struct Stream {
    samples: VecDeque<(i64, Vec<f64>)>,
    width: usize,
    first: Option<i64>,
    count: u64,
    last: i64,
}

impl Stream {
    /// Mean period so far, ns.
    fn period(&self) -> f64 {
        match self.first {
            Some(first) if self.count > 1 => (self.last - first) as f64 / (self.count - 1) as f64,
            _ => f64::INFINITY,
        }
    }

    /// Appends the values at `time`, ns, linear between neighbours; NaN outside, and across a gap.
    fn at(&self, time: i64, out: &mut Vec<f64>) {
        let after = self.samples.partition_point(|(t, _)| *t < time);
        let right = self.samples.get(after);
        if let Some((t, values)) = right
            && *t == time
        {
            out.extend(values);
            return;
        }
        let left = after.checked_sub(1).and_then(|i| self.samples.get(i));
        match (left, right) {
            (Some((t0, a)), Some((t1, b))) if (t1 - t0) as f64 <= LONGEST_GAP * self.period() => {
                let share = (time - t0) as f64 / (t1 - t0) as f64;
                out.extend(a.iter().zip(b).map(|(a, b)| a + share * (b - a)));
            }
            _ => out.extend(std::iter::repeat_n(f64::NAN, self.width)),
        }
    }
}

/// Rows of a base stream with the values of the other streams interpolated to its stamps, in
/// bounded memory.
pub(super) struct Aligner {
    /// Rows of the base stream that wait for the other streams.
    rows: VecDeque<(i64, Vec<f64>)>,
    others: Vec<Stream>,
    ended: bool,
}

impl Aligner {
    /// Creates an aligner; `widths`: number of values of each stream other than the base.
    pub(super) fn new(widths: &[usize]) -> Self {
        let stream = |&width: &usize| Stream { samples: VecDeque::new(), width, first: None, count: 0, last: i64::MIN };
        Self { rows: VecDeque::new(), others: widths.iter().map(stream).collect(), ended: false }
    }

    /// Adds a row of the base stream.
    pub(super) fn base(&mut self, time: i64, values: Vec<f64>) {
        self.rows.push_back((time, values));
    }

    /// Adds a sample of another stream, unless it is not later than the previous one.
    pub(super) fn other(&mut self, stream: usize, time: i64, values: Vec<f64>) {
        let stream = &mut self.others[stream];
        if time <= stream.last && stream.count > 0 {
            return;
        }
        stream.first.get_or_insert(time);
        stream.count += 1;
        stream.last = time;
        stream.samples.push_back((time, values));
        if stream.samples.len() > LONGEST_WAIT {
            stream.samples.pop_front();
        }
    }

    /// Marks the end of all streams.
    pub(super) fn end(&mut self) {
        self.ended = true;
    }

    /// Next row for which every stream has the required samples: its stamp, ns, and the values of
    /// the base followed by those of the other streams.
    pub(super) fn next(&mut self) -> Option<(i64, Vec<f64>)> {
        let time = self.rows.front()?.0;
        let ready = self.ended || self.rows.len() > LONGEST_WAIT || self.others.iter().all(|s| s.last >= time);
        if !ready {
            return None;
        }
        let (time, mut values) = self.rows.pop_front()?;
        for stream in &mut self.others {
            stream.at(time, &mut values);
            while stream.samples.len() > 1 && stream.samples[1].0 <= time {
                stream.samples.pop_front();
            }
        }
        Some((time, values))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn another_clock_is_interpolated_and_gaps_are_not() {
        let mut aligner = Aligner::new(&[1]);
        // A line of slope 1 per ns, sampled at 0, 10, 20, ... with a gap from 100 to 400.
        for t in (0..=100).step_by(10).chain((400..500).step_by(10)) {
            aligner.other(0, t, vec![t as f64]);
        }
        for t in [3, 50, 77, 200, 405] {
            aligner.base(t, vec![1.0]);
        }
        aligner.end();
        let rows: Vec<(i64, Vec<f64>)> = std::iter::from_fn(|| aligner.next()).collect();
        assert_eq!(rows.len(), 5);
        for (t, values) in rows {
            assert!(if t == 200 { values[1].is_nan() } else { (values[1] - t as f64).abs() < 1e-9 }, "{t}: {values:?}");
        }
    }

    #[test]
    fn a_row_waits_for_the_slower_stream() {
        let mut aligner = Aligner::new(&[1]);
        aligner.other(0, 0, vec![0.0]);
        aligner.base(5, vec![]);
        assert!(aligner.next().is_none());
        aligner.other(0, 10, vec![1.0]);
        assert_eq!(aligner.next(), Some((5, vec![0.5])));
        // A stream that ends early does not block rows for ever.
        aligner.base(50, vec![]);
        aligner.end();
        assert!(aligner.next().unwrap().1[0].is_nan());
    }
}
