//! Table III: both paint rollers, identified by equation (7) from 10 s with an empty hand and 10 s with the roller.

use super::honesty::STRIDE;
use super::loaded::{carry, identified, loaded};
use super::lwr::Lwr;
use super::many::many;
use super::motions::Motion;
use super::verdict::Verdict;
use super::{ReproduceError, Watch};
use crate::simulate::Recording;
use crate::tool::rerun::{Column, Row, TABLE_THREE};
use crate::tool::{Entry, Tolerance, names};

/// Of the mass of the large roller, percent, and of its centre, m: what is asked of the rerun.
pub const ASKED: [f64; 2] = [2.0, 2e-3];

/// Both rollers on a motion that was designed for them; `unloaded`: with an empty hand.
pub fn columns(
    lwr: &Lwr,
    motion: &Motion,
    unloaded: &Recording,
    seed: u64,
    watch: Watch<'_>,
) -> Result<Vec<Column>, ReproduceError> {
    let mut columns = Vec::new();
    for (k, paper) in TABLE_THREE.iter().enumerate() {
        watch(paper.tool, k as f64 / TABLE_THREE.len() as f64);
        let found = loaded(lwr, motion, paper.tool, unloaded, &[], seed.wrapping_add(100 * k as u64))?;
        let Some(entry) = Entry::new(&found.tool, None, &Tolerance::default()) else { continue };
        let (truth, carried) = (entry.values, found.carried);
        let row = |(k, name): (usize, String)| Row {
            name,
            paper: [paper.values[k], 0.01 * paper.percent[k] * paper.values[k].abs()],
            truth: truth[k],
            ours: [carried.values[k], carried.std[k]],
        };
        let norm = |values: [f64; 3]| values.iter().map(|x| x * x).sum::<f64>().sqrt();
        let off = |center: &[f64; 3]| norm(std::array::from_fn(|k| center[k] - truth[k + 1] / truth[0]));
        columns.push(Column {
            tool: paper.tool.into(),
            rows: names().into_iter().enumerate().map(row).collect(),
            mass_error_percent: 100.0 * (carried.values[0] / truth[0] - 1.0),
            center_error: carried.body.as_ref().map_or(f64::NAN, |body| off(&body.center)),
            center_std: carried.body.as_ref().map_or(f64::NAN, |body| norm(body.center_std)),
            carried,
        });
    }
    Ok(columns)
}

/// The large roller over many runs with other noise: whether mass and centre are as good as asked, and the deviations honest.
#[derive(Debug, Clone, PartialEq)]
pub struct Repeated {
    /// Logs with an empty hand and with the roller, 10 s each.
    pub logs: [usize; 2],
    /// Runs.
    pub runs: usize,
    /// Share of the runs with the mass within [`ASKED`].
    pub mass_within: f64,
    /// Root mean square of the distance from the true centre, m.
    pub center_rms: f64,
    /// Share of the runs with the centre within [`ASKED`].
    pub center_within: f64,
    /// Root mean square of the centre's errors in their own standard deviations, over axes and runs.
    pub spread: f64,
}

/// Runs of [`repeated`].
pub const RUNS: usize = 50;

/// The large roller from one log of each kind (the first of `unloaded` and of `moving`), and from all of them.
pub fn repeated(
    lwr: &Lwr,
    unloaded: &[&Recording],
    moving: &[&Motion],
    seed: u64,
    watch: Watch<'_>,
) -> Result<Vec<Repeated>, ReproduceError> {
    let name = TABLE_THREE[0].tool;
    watch(name, 0.0);
    let with = moving.iter().map(|motion| carry(lwr, motion, name, &[], seed)).collect::<Result<Vec<_>, _>>()?;
    let Some(entry) = with.first().and_then(|(tool, _)| Entry::new(tool, None, &Tolerance::default())) else {
        return Ok(Vec::new());
    };
    let truth = entry.values;
    let mut all = Vec::new();
    for (k, logs) in [[1, 1], [unloaded.len(), with.len()]].into_iter().enumerate() {
        let one = |run: usize| {
            let noisy = |which: usize, recording: &Recording| {
                recording.seen_by(&Lwr::sensors(), seed.wrapping_add(1 + (1000 * run + 100 * k + which) as u64))
            };
            let empty: Vec<_> = unloaded[..logs[0]].iter().enumerate().map(|(i, r)| noisy(i, r)).collect();
            let full: Vec<_> = with[..logs[1]].iter().enumerate().map(|(i, (_, r))| noisy(50 + i, r)).collect();
            let found = identified(lwr, &empty.iter().collect::<Vec<_>>(), &full.iter().collect::<Vec<_>>(), STRIDE)?;
            let nothing = [f64::NAN; 3];
            let (center, std) = found.body.as_ref().map_or((nothing, nothing), |b| (b.center, b.center_std));
            let off: [f64; 3] = std::array::from_fn(|k| center[k] - truth[k + 1] / truth[0]);
            let own: f64 = off.iter().zip(std).map(|(o, s)| (o / s).powi(2)).sum();
            Ok([100.0 * (found.values[0] / truth[0] - 1.0), off.iter().map(|o| o * o).sum::<f64>(), own / 3.0])
        };
        let runs = many(RUNS, &one, &|what, share| watch(what, 0.1 + 0.45 * (k as f64 + share)))?;
        let mean = |f: &dyn Fn(&[f64; 3]) -> f64| runs.iter().map(f).sum::<f64>() / RUNS as f64;
        all.push(Repeated {
            logs,
            runs: RUNS,
            mass_within: mean(&|r| f64::from(u8::from(r[0].abs() <= ASKED[0]))),
            center_rms: mean(&|r| r[1]).sqrt(),
            center_within: mean(&|r| f64::from(u8::from(r[1].sqrt() <= ASKED[1]))),
            spread: mean(&|r| r[2]).sqrt(),
        });
    }
    Ok(all)
}

/// Standard deviations in SI units: relative ones of parameters that are zero say nothing.
pub fn verdict(row: &Row) -> Verdict {
    Verdict::less(row.ours[1], row.paper[1])
}
