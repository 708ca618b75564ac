//! Table III: both paint rollers, identified by equation (7) from 10 s with an empty hand and 10 s with the roller.

use super::loaded::loaded;
use super::lwr::Lwr;
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

/// Standard deviations in SI units: relative ones of parameters that are zero say nothing.
pub fn verdict(row: &Row) -> Verdict {
    Verdict::less(row.ours[1], row.paper[1])
}
