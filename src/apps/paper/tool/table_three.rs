//! Rerun of the paper's Table III: both rollers identified in simulation, beside the paper's
//! figures and the true values.

use super::bench::{Bench, BenchError};
use crate::identify::tool::{Carried, Entry, Tolerance, catalogue, names};
use crate::numerics::prng::Random;

/// A roller of Table III.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PaperRoller {
    /// Name of its tool file.
    pub tool: &'static str,
    /// Values identified by the paper.
    pub values: [f64; 10],
    /// Relative standard deviations in the paper, percent.
    pub percent: [f64; 10],
}

/// Table III as printed.
pub const TABLE_THREE: [PaperRoller; 2] = [
    PaperRoller {
        tool: "large-roller",
        values: [2.37e-1, -3.93e-3, -1.53e-5, 6.50e-2, 1.98e-2, 2.10e-2, 2.08e-3, 5.57e-4, 6.27e-4, 8.25e-5],
        percent: [0.5, 8.1, 21.0, 0.6, 1.9, 2.0, 14.9, 56.6, 41.5, 49.9],
    },
    PaperRoller {
        tool: "small-roller",
        values: [9.73e-2, 4.54e-5, 7.17e-5, 2.44e-2, 7.36e-3, 7.12e-3, 1.55e-4, 2.01e-4, -4.25e-4, 2.06e-4],
        percent: [1.3, 28.4, 25.4, 1.4, 4.4, 5.1, 31.0, 102.8, 54.7, 47.5],
    },
];

/// A row of the table.
#[derive(Debug, Clone, PartialEq)]
pub struct ToolRow {
    /// Name of the parameter, such as `MSX`.
    pub name: String,
    /// The paper's value and its standard deviation.
    pub paper: [f64; 2],
    /// True value of the simulated roller.
    pub truth: f64,
    /// Our identified value and its standard deviation.
    pub ours: [f64; 2],
}

impl ToolRow {
    /// Relative standard deviations of the paper and ours, percent.
    pub fn percent(&self) -> [f64; 2] {
        [self.paper, self.ours].map(|[value, std]| 100.0 * std / value.abs())
    }
}

/// Results for one roller.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Name of its tool file.
    pub tool: String,
    /// Rows of the ten parameters.
    pub rows: Vec<ToolRow>,
    /// Identified minus true mass, percent.
    pub mass_error_percent: f64,
    /// Distance from the identified to the true centre of mass, m; NaN if no centre was found.
    pub center_error: f64,
    /// Standard deviation of the centre, root of the sum of squares over the axes, m.
    pub center_std: f64,
    /// Identified parameters.
    pub carried: Carried,
}

/// Identifies both rollers on the bench from `repeats` logs of each kind (1 in the paper).
pub fn table_three(bench: &Bench, repeats: usize, seed: u64) -> Result<Vec<Column>, BenchError> {
    let mut random = Random::new(seed);
    let tools = catalogue();
    let mut columns = Vec::new();
    for paper in TABLE_THREE {
        let Some(entry) =
            tools.iter().find(|t| t.name == paper.tool).and_then(|t| Entry::new(t, None, &Tolerance::default()))
        else {
            continue;
        };
        let truth = entry.values;
        let carried = bench.identify(&truth, repeats, &mut random)?;
        let rows = names()
            .into_iter()
            .enumerate()
            .map(|(k, name)| ToolRow {
                name,
                paper: [paper.values[k], 0.01 * paper.percent[k] * paper.values[k].abs()],
                truth: truth[k],
                ours: [carried.values[k], carried.std[k]],
            })
            .collect();
        let (center_error, center_std) = carried.body.as_ref().map_or((f64::NAN, f64::NAN), |body| {
            let square = |k: usize| (body.center[k] - truth[k + 1] / truth[0]).powi(2);
            let norm = |squares: f64| squares.sqrt();
            (norm((0..3).map(square).sum()), norm(body.center_std.iter().map(|s| s * s).sum()))
        });
        columns.push(Column {
            tool: paper.tool.into(),
            rows,
            mass_error_percent: 100.0 * (carried.values[0] / truth[0] - 1.0),
            center_error,
            center_std,
            carried,
        });
    }
    Ok(columns)
}
