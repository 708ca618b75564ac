//! Recognition rate of known tools and rejection rate of unknown ones: seeded trials of the whole
//! chain.

use std::f64::consts::PI;

use nalgebra::Rotation3;

use super::bench::{Bench, BenchError};
use super::recording::normal;
use crate::identify::tool::{
    Assembly, Entry, FLANGE, MINI_ROLLERS, RecogniseSettings, Tolerance, WALL_ROLLERS, interpolate, moving, recognise,
};
use crate::numerics::prng::Random;

/// Settings of the trials.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TrialSettings {
    /// Number of trials with a tool of the table.
    pub known: usize,
    /// Number of trials with an unknown tool: rollers of other sizes and random bodies in turn.
    pub unknown: usize,
    /// Spread of the tools about their entries, as given to recognition.
    pub tolerance: Tolerance,
    /// Settings of the recognition: share and level.
    pub recognise: RecogniseSettings,
    /// Seed of all random numbers.
    pub seed: u64,
}

/// Smallest difference of length or width, m, from every roller of the table for a roller to count
/// as another one. With a smaller difference it is the same for painting.
pub const OTHER_SIZE: f64 = 0.02;

/// A trial with a roller that is not in the table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SizeTrial {
    /// True length and width, m.
    pub truth: [f64; 2],
    /// Interpolated length and width, m.
    pub found: [f64; 2],
    /// Ends of the 95 % intervals of length and width, m.
    pub ends: [[f64; 2]; 2],
    /// Whether it was recognised as a member of a family.
    pub fits: bool,
}

/// Results of the trials.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Trials {
    /// Names of the table; answers have one more: none.
    pub names: Vec<String>,
    /// Rows: the tool, then unknown rollers, then unknown bodies. Columns: the answer, then "none".
    pub confusion: Vec<Vec<usize>>,
    /// Known tools: number, recognised correctly, rejected, recognised wrongly.
    pub known: [usize; 4],
    /// Known tools whose nearest entry was the right one, whether rejected or not: by the weighted
    /// distance, by the weighted distance in the reduced space, by the paper's distance.
    pub nearest_right: [usize; 3],
    /// Unknown tools: number, rejected.
    pub unknown: [usize; 2],
    /// Sizes of unknown rollers.
    pub sizes: Vec<SizeTrial>,
    /// Unknown bodies that were recognised as a roller of another size.
    pub false_relatives: usize,
    /// Mean squared distance of the right tool, relative to its expectation (the number of
    /// parameters).
    pub mean_square: f64,
}

impl Trials {
    /// Share of known tools that are recognised correctly.
    pub fn right(&self) -> f64 {
        share(self.known[1], self.known[0])
    }

    /// Share of unknown tools that are rejected.
    pub fn rejected(&self) -> f64 {
        share(self.unknown[1], self.unknown[0])
    }

    /// Share of intervals (lengths and widths of unknown rollers that fit a family) that contain
    /// the true value.
    pub fn coverage(&self) -> f64 {
        let fitting = || self.sizes.iter().filter(|s| s.fits);
        let held =
            fitting().flat_map(|s| (0..2).map(move |k| (s.truth[k], s.ends[k]))).filter(|(t, [a, b])| a <= t && t <= b);
        share(held.count(), 2 * fitting().count())
    }

    /// Root mean square errors of length and width over unknown rollers that fit a family, m.
    #[cfg(test)]
    pub(super) fn size_error(&self) -> [f64; 2] {
        let fitting: Vec<&SizeTrial> = self.sizes.iter().filter(|s| s.fits).collect();
        [0, 1].map(|k| {
            let squares: f64 = fitting.iter().map(|s| (s.found[k] - s.truth[k]).powi(2)).sum();
            (squares / fitting.len().max(1) as f64).sqrt()
        })
    }
}

fn share(part: usize, whole: usize) -> f64 {
    part as f64 / whole.max(1) as f64
}

/// Runs the trials; `progress` receives the number of finished ones.
pub fn trials(
    bench: &Bench,
    table: &[Entry],
    settings: &TrialSettings,
    mut progress: impl FnMut(usize),
) -> Result<Trials, BenchError> {
    let none = table.len();
    let mut out = Trials {
        names: table.iter().map(|e| e.name.clone()).collect(),
        confusion: vec![vec![0; none + 1]; none + 2],
        ..Trials::default()
    };
    let mut random = Random::new(settings.seed);
    for trial in 0..settings.known + settings.unknown {
        progress(trial);
        let known = trial < settings.known;
        let roller = !known && trial % 2 == 0;
        let (row, truth, size) = if known {
            let entry = trial % none.max(1);
            let Some(tool) = table.get(entry) else { continue };
            (entry, as_mounted(&tool.values, &settings.tolerance, &mut random), None)
        } else if roller {
            let (values, size) = other_roller(table, &mut random);
            (none, as_mounted(&values, &settings.tolerance, &mut random), Some(size))
        } else {
            (none + 1, some_body(&mut random), None)
        };
        let carried = bench.identify(&truth, 1, &mut random)?;
        let Some(answer) = recognise(&carried, table, &settings.recognise) else { continue };
        let nearest = answer.nearest().entry;
        out.confusion[row][if answer.rejected { none } else { nearest }] += 1;
        if known {
            let right = nearest == row;
            out.known[0] += 1;
            out.known[if answer.rejected {
                2
            } else if right {
                1
            } else {
                3
            }] += 1;
            let space = answer.candidates.iter().min_by(|a, b| a.distance_in_space.total_cmp(&b.distance_in_space));
            out.nearest_right[0] += usize::from(right);
            out.nearest_right[1] += usize::from(space.is_some_and(|c| c.entry == row));
            out.nearest_right[2] += usize::from(answer.by_plain_distance == table[row].name);
            if let Some(own) = answer.candidates.iter().find(|c| c.entry == row) {
                out.mean_square += own.distance.powi(2) / (answer.determined.max(1) * settings.known.max(1)) as f64;
            }
            continue;
        }
        out.unknown[0] += 1;
        out.unknown[1] += usize::from(answer.rejected);
        let relative = interpolate(&carried, table, &settings.tolerance, settings.recognise.level);
        match (size, relative) {
            (Some(truth), Some(r)) => out.sizes.push(SizeTrial {
                truth,
                found: [r.length.value, r.width.value],
                ends: [r.length.ends, r.width.ends],
                fits: r.fits,
            }),
            (None, Some(r)) => out.false_relatives += usize::from(r.fits),
            _ => {}
        }
    }
    Ok(out)
}

/// A tool of the table as mounted: with random errors within the tolerance.
fn as_mounted(values: &[f64; 10], tolerance: &Tolerance, random: &mut Random) -> [f64; 10] {
    let mass = 1.0 + tolerance.mass * normal(random);
    let origin: [f64; 3] = std::array::from_fn(|_| tolerance.position * normal(random));
    let turn = Rotation3::new(nalgebra::Vector3::from_fn(|_, _| tolerance.angle * normal(random)));
    let rotation = std::array::from_fn(|i| std::array::from_fn(|k| turn[(i, k)]));
    (moving(&rotation, &origin) * nalgebra::SVector::from(values.map(|v| mass * v))).into()
}

/// Parameters, in the last frame, and size of a roller of either series whose size is not in the
/// table.
fn other_roller(table: &[Entry], random: &mut Random) -> ([f64; 10], [f64; 2]) {
    loop {
        let (series, lengths, widths) = match random.chance(0.5) {
            true => (WALL_ROLLERS, [0.30, 0.50], [0.15, 0.25]),
            false => (MINI_ROLLERS, [0.25, 0.45], [0.06, 0.16]),
        };
        let size = [random.uniform(lengths[0], lengths[1]), random.uniform(widths[0], widths[1])];
        let near = |e: &&Entry| {
            e.geometry
                .is_some_and(|g| (g.length - size[0]).abs() < OTHER_SIZE && (g.width - size[1]).abs() < OTHER_SIZE)
        };
        if table.iter().filter(near).count() == 0 {
            let identity = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
            return (series.roller(size[0], size[1]).moved(&identity, &[0.0, 0.0, FLANGE]).to_array(), size);
        }
    }
}

/// Two or three cuboids of 0.05 to 0.6 kg at random within half a metre of the flange.
fn some_body(random: &mut Random) -> [f64; 10] {
    let parts = 2 + random.below(2);
    let body = (0..parts).fold(Assembly::new(), |body, _| {
        let size = std::array::from_fn(|_| random.uniform(0.01, 0.15));
        let (out, turn) = (random.uniform(0.0, 0.1), random.uniform(0.0, 2.0 * PI));
        let center = [out * turn.cos(), out * turn.sin(), FLANGE + random.uniform(0.0, 0.4)];
        body.cuboid(random.uniform(0.05, 0.6), size, center)
    });
    body.inertia.to_array()
}
