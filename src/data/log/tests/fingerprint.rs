//! Tests that logs are recognised by their samples, in bounded memory.

use super::*;

/// Source of generated rows: a noisy motion whose sample `k` depends on `seed` and `k` alone.
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

/// Rows rounded to fewer digits, as in a file.
struct Printed {
    inner: Endless,
    print: fn(f64) -> String,
}

impl Source for Printed {
    fn layout(&self) -> &Layout {
        &self.inner.layout
    }

    fn next_block(&mut self, rows: usize, block: &mut Block) -> Result<(), LogError> {
        self.inner.next_block(rows, block)?;
        for column in &mut block.columns[1..] {
            column.iter_mut().for_each(|x| *x = (self.print)(*x).parse().unwrap());
        }
        Ok(())
    }
}

fn fingerprint_of(source: &mut dyn Source) -> Fingerprint {
    let mut reading = Fingerprinted::new(source);
    let mut block = Block::default();
    loop {
        reading.next_block(8192, &mut block).unwrap();
        if block.is_empty() {
            return reading.finish();
        }
    }
}

#[test]
fn a_copy_with_fewer_digits_is_found() {
    let prints: [fn(f64) -> String; 5] = [
        |x| format!("{x:.6}"),
        |x| format!("{x:.4}"),
        |x| format!("{x:.4e}"),
        |x| format!("{x:.5e}"),
        |x| ((x * 1e5).round() / 1e5).to_string(),
    ];
    let whole = fingerprint(Endless::new(1, 0..30_000, 1));
    for (k, print) in prints.into_iter().enumerate() {
        let copy = |seed, rows| fingerprint_of(&mut Printed { inner: Endless::new(seed, rows, 1), print });
        let stretch = copy(1, 10_000..20_000);
        let Some(Common::Rounded(seconds)) = whole.common(&stretch) else { panic!("{k}") };
        assert!((seconds - 10.0).abs() < 0.5, "{k}: {seconds}");
        assert!(matches!(stretch.common(&whole), Some(Common::Rounded(_))), "{k}");
        assert_eq!(whole.common(&copy(2, 0..30_000)), None, "{k}");
        assert_eq!(copy(1, 0..10_000).common(&copy(3, 0..10_000)), None, "{k}");
    }
    // A rounded copy of a rounded copy.
    let [fine, coarse] = [prints[0], prints[1]]
        .map(|print| fingerprint_of(&mut Printed { inner: Endless::new(1, 0..30_000, 1), print }));
    assert!(matches!(fine.common(&coarse), Some(Common::Rounded(_))));
}

#[test]
fn copies_are_recognised_in_a_hundredth_of_the_memory() {
    let mut minute = fingerprint(Endless::new(1, 0..60_000, 1));
    let mut copy = fingerprint(Endless::new(1, 0..60_000, 1));
    let mut part = fingerprint(Endless::new(1, 20_000..50_000, 1));
    let mut other = fingerprint(Endless::new(2, 0..60_000, 1));
    [&mut minute, &mut copy, &mut part, &mut other].into_iter().for_each(|print| print.shrink(1 << 10));
    assert_eq!(minute.common(&copy), Some(Common::All));
    assert!(matches!(minute.common(&part), Some(Common::Stretch(s)) if (s - 30.0).abs() < 1.0));
    assert_eq!(minute.common(&other), None);
}
