//! Table II: base parameters, true, identified here, and as identified by the paper and by Jubien
//! et al.

use super::lwr::Lwr;
use super::verdict::Verdict;
use crate::identify::Identification;
use crate::model::{Arm, StandardParameter};

/// A row as printed: name, CAD, identified, its %sigma, Jubien's, its %sigma.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Printed {
    /// Name, such as `XX2R`.
    pub name: &'static str,
    /// Value from CAD, if given.
    pub cad: Option<f64>,
    /// Value identified by the paper, and its relative standard deviation, percent.
    pub paper: [f64; 2],
    /// Value identified by Jubien, Gautier and Janot, and its relative standard deviation, percent.
    pub jubien: [f64; 2],
}

/// Number of samples in 10 s at 1 kHz.
const SAMPLES: f64 = 10_000.0;

impl Printed {
    /// For a Coulomb level, whose column is a sign: the largest residual, N m, that is compatible
    /// with the printed standard deviation from 10 s, by the textbook's formula. (Correlation with
    /// other parameters only tightens the bound.)
    pub fn residual(&self) -> f64 {
        0.01 * self.paper[1] * self.paper[0].abs() * SAMPLES.sqrt()
    }
}

const fn row(name: &'static str, cad: Option<f64>, paper: [f64; 2], jubien: [f64; 2]) -> Printed {
    Printed { name, cad, paper, jubien }
}

/// Table II as printed.
pub const TABLE_TWO: [Printed; 15] = [
    row("XX2R", Some(1.32), [1.35, 0.30], [1.30, 1.5]),
    row("ZZ2R", Some(1.32), [1.36, 0.34], [1.28, 1.6]),
    row("MSY2R", Some(3.60), [3.43, 0.05], [3.45, 0.18]),
    row("XX4R", Some(0.46), [0.44, 0.18], [0.44, 0.91]),
    row("ZZ4R", Some(0.47), [0.43, 0.20], [0.44, 1.0]),
    row("MSY4R", Some(-1.45), [-1.34, 0.05], [-1.35, 0.18]),
    row("MSY5R", Some(0.036), [0.047, 0.86], [0.040, 3.6]),
    row("MSY6R", Some(0.0104), [0.034, 0.50], [0.035, 6.4]),
    row("MSY7", Some(0.0), [0.001, 13.3], [0.006, 14.0]),
    row("FC1", None, [0.28, 4.8], [0.39, 6.1]),
    row("FC2", None, [0.43, 4.1], [0.52, 5.5]),
    row("FC3", None, [0.05, 1.6], [0.45, 2.8]),
    row("FC4", None, [0.16, 5.8], [0.32, 3.7]),
    row("FC5", None, [0.34, 1.2], [0.86, 3.0]),
    row("FC7", None, [0.20, 1.2], [0.08, 6.0]),
];

/// A row of our table.
#[derive(Debug, Clone, PartialEq)]
pub struct Table2Row {
    /// The paper's row.
    pub printed: Printed,
    /// Standard parameter that leads the base parameter's column.
    pub leader: StandardParameter,
    /// Value of the simulated robot.
    pub truth: f64,
    /// Value identified with noise alone, and its standard deviation.
    pub noise_only: [f64; 2],
    /// Value identified with effects that the model lacks, and its standard deviation.
    pub unmodelled: [f64; 2],
    /// Standard deviation of the latter by the textbook's formula, which treats the 10,000
    /// residuals after the low-pass as independent.
    pub textbook: f64,
}

impl Table2Row {
    /// Relative standard deviation with noise alone, percent.
    pub fn percent(&self) -> f64 {
        100.0 * self.noise_only[1] / self.noise_only[0].abs()
    }

    /// Error with noise alone, in its own standard deviations.
    pub fn off(&self) -> f64 {
        (self.noise_only[0] - self.truth) / self.noise_only[1]
    }

    /// The textbook's standard deviation at a residual as large as the paper's, percent of the true
    /// value (not of the identified value, as friction parameters absorb the hysteresis).
    pub fn textbook_percent(&self) -> f64 {
        100.0 * self.textbook / self.truth.abs()
    }

    /// Comparison with the paper's standard deviation, by the same formula at the same residual.
    pub fn like_for_like(&self) -> Verdict {
        Verdict::less(self.textbook_percent(), self.printed.paper[1])
    }

    /// Comparison of %sigma with the paper's.
    pub fn verdict(&self) -> Verdict {
        Verdict::less(self.percent(), self.printed.paper[1])
    }
}

/// Factor by which standard deviations that include the correlation of neighbouring samples exceed
/// the textbook's where the model lacks effects: median over the rows.
pub fn too_small(rows: &[Table2Row]) -> f64 {
    let mut ratios: Vec<f64> = rows.iter().map(|r| r.unmodelled[1] / r.textbook).collect();
    ratios.sort_by(f64::total_cmp);
    ratios.get(ratios.len() / 2).copied().unwrap_or(f64::NAN)
}

/// Rows of the parameters that the paper prints and the robot has.
pub fn rows(lwr: &Lwr, noise_only: &Identification, unmodelled: &Identification) -> Vec<Table2Row> {
    let estimate = |found: &Identification, c: usize| [found.parameters[c].value, found.parameters[c].std];
    TABLE_TWO
        .iter()
        .filter_map(|printed| {
            let base = lwr.arm.base_parameters();
            let c = base.iter().position(|b| b.name == printed.name)?;
            Some(Table2Row {
                printed: *printed,
                leader: base[c].leader,
                truth: lwr.truth[c],
                noise_only: estimate(noise_only, c),
                unmodelled: estimate(unmodelled, c),
                textbook: unmodelled.parameters[c].white_std,
            })
        })
        .collect()
}
