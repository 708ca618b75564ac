//! Logs are recognised by their samples, with bounded memory.

use super::*;

/// Rows made as they are asked for: a noisy motion whose sample `k` depends on `seed` and `k`
/// alone.
struct Endless {
    layout: Layout,
    next: u64,
    end: u64,
    step: u64,
    seed: u64,
}

impl Endless {
    fn new(seed: u64, rows: std::ops::Range<u64>, step: u64) -> Self {
        let layout = Layout::new("endless", &["t", "q1", "q2", "tau1", "tau2"]).unwrap();
        Self { layout, next: rows.start, end: rows.end, step, seed }
    }
}

fn value(seed: u64, k: u64, channel: u64) -> f64 {
    let mut x = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ (k * 8 + channel).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x ^= x >> 31;
    x = x.wrapping_mul(0x94d0_49bb_1331_11eb);
    (k as f64 / 700.0).sin() + 1e-3 * (x >> 40) as f64 / (1u64 << 24) as f64
}

impl Source for Endless {
    fn layout(&self) -> &Layout {
        &self.layout
    }

    fn next_block(&mut self, rows: usize, block: &mut Block) -> Result<(), LogError> {
        block.clear(5);
        while block.len() < rows && self.next < self.end {
            block.lines.push(self.next + 2);
            block.columns[0].push(self.next as f64 / 1000.0);
            (0..4).for_each(|c| block.columns[c as usize + 1].push(value(self.seed, self.next, c)));
            self.next += self.step;
        }
        Ok(())
    }
}

fn fingerprint(mut source: Endless) -> Fingerprint {
    let mut reading = Fingerprinted::new(&mut source);
    let mut block = Block::default();
    loop {
        reading.next_block(8192, &mut block).unwrap();
        if block.is_empty() {
            return reading.finish();
        }
    }
}

#[test]
fn a_minute_of_an_hour_is_found() {
    let hour = fingerprint(Endless::new(1, 0..1_000_000, 1));
    let seconds = |print: &Fingerprint| match hour.common(print) {
        Some(Common::Stretch(seconds)) => seconds,
        other => panic!("{other:?}"),
    };
    assert!((seconds(&fingerprint(Endless::new(1, 300_000..360_000, 1))) - 60.0).abs() < 1.0);
    assert!((seconds(&fingerprint(Endless::new(1, 300_000..360_000, 4))) - 60.0).abs() < 1.0);
    assert!((seconds(&fingerprint(Endless::new(1, 990_000..1_060_000, 1))) - 10.0).abs() < 1.0);
    assert_eq!(hour.common(&fingerprint(Endless::new(1, 0..1_000_000, 1))), Some(Common::All));
    assert_eq!(hour.common(&fingerprint(Endless::new(2, 0..200_000, 1))), None);
    assert_eq!(hour.common(&fingerprint(Endless::new(1, 1_000_000..1_100_000, 1))), None);
}
