//! Table III: both paint rollers, identified by equation (7) from 10 s without a tool and 10 s with
//! the roller in the same motion. The robot's own parameters then contribute equally to both logs,
//! and the roller is determined as from a log that is twice as noisy.

use super::ReproduceError;
use super::Tally;
use super::Watch;
use super::honesty::STRIDE;
use super::loaded::{carry, loaded, stacked};
use super::lwr::Lwr;
use super::many::many;
use super::motions::PaperMotion;
use super::verdict::Verdict;
use crate::apps::paper::tool::{Column, TABLE_THREE, ToolRow};
use crate::identify::tool::{Entry, Tolerance, ToolSettings, identify_tool, names};
use crate::numerics::prng::Random;
use crate::simulate::Recording;

/// Required accuracy of the large roller's mass, percent, and of its centre of mass, m.
pub const ASKED: [f64; 2] = [2.0, 2e-3];

/// Identifies both rollers on a motion designed for them; `unloaded` is without a tool.
pub fn columns(
    lwr: &Lwr,
    motion: &PaperMotion,
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
        let row = |(k, name): (usize, String)| ToolRow {
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

/// Number of logs used in a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LogCounts {
    /// Number of logs without a tool and with the roller, 10 s each.
    pub logs: [usize; 2],
    /// Standard deviation of a scale on which the roller was weighed, kg.
    pub scale: Option<f64>,
}

impl std::fmt::Display for LogCounts {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} + {}", self.logs[0], self.logs[1])?;
        if self.scale.is_some() { write!(f, ", weighed") } else { Ok(()) }
    }
}

/// Standard deviation of a scale with a resolution of one gram, kg: a gram over the square root of
/// twelve.
pub const SCALE: f64 = 0.29e-3;

/// Cases: one log of each kind; also the logs from which the robot was identified (the same robot
/// without a tool); a scale; more logs of both kinds. The paper's number of logs, twice and four
/// times as many.
pub const CASES: [LogCounts; 6] = [
    LogCounts { logs: [1, 1], scale: None },
    LogCounts { logs: [4, 1], scale: None },
    LogCounts { logs: [1, 1], scale: Some(SCALE) },
    LogCounts { logs: [4, 1], scale: Some(SCALE) },
    LogCounts { logs: [2, 2], scale: None },
    LogCounts { logs: [4, 4], scale: None },
];

/// The large roller over many runs with other noise: whether mass and centre have the required
/// accuracy, and whether the standard deviations are correct.
#[derive(Debug, Clone, PartialEq)]
pub struct Repeated {
    /// Data of the runs.
    pub case: LogCounts,
    /// Runs with the mass within [`ASKED`].
    pub mass_within: Tally,
    /// Root mean square distance from the true centre of mass, m.
    pub center_rms: f64,
    /// Reported standard deviation of the centre, root of the sum of squares over the axes, mean
    /// over the runs, m.
    pub center_std: f64,
    /// Largest distance from the true centre, m.
    pub center_worst: f64,
    /// Runs with the centre within [`ASKED`].
    pub center_within: Tally,
    /// Root mean square of the centre's errors in their own standard deviations, over axes and
    /// runs.
    pub spread: f64,
}

impl Repeated {
    /// Required lower bound of the share's 95 % interval.
    pub const NEARLY_ALWAYS: f64 = 0.95;

    /// Whether mass and centre have the required accuracy in nearly all runs.
    pub fn holds(&self) -> bool {
        [self.mass_within, self.center_within].iter().all(|s| s.interval()[0] > Self::NEARLY_ALWAYS)
    }
}

/// Number of runs of [`repeated`].
pub const RUNS: usize = 100;

/// Identifies the large roller from one log of each kind, and from more. `unloaded` and `moving`
/// have the same motions, used in turn; all logs of a run have their own noise.
pub fn repeated(
    lwr: &Lwr,
    unloaded: &[&Recording],
    moving: &[&PaperMotion],
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
    let most = CASES.iter().flat_map(|c| c.logs).max().unwrap_or(1);
    // Mass error, percent; centre error squared, m^2; its reported variance; its error in its own
    // standard deviations, squared.
    let one = |run: usize| -> Result<Vec<[f64; 4]>, ReproduceError> {
        let noisy = |which: usize, recording: &Recording| {
            recording.seen_by(&Lwr::sensors(), seed.wrapping_add(1 + (1000 * run + which) as u64))
        };
        let pair = |k: usize| {
            let (empty, full) = (unloaded[k % unloaded.len()], &with[k % with.len()].1);
            stacked(lwr, &noisy(k, empty), &noisy(50 + k, full), STRIDE)
        };
        let pairs = (0..most).map(pair).collect::<Result<Vec<_>, _>>()?;
        // Reading of the scale in this run.
        let mut random = Random::new(seed.wrapping_add(1 + (1000 * run + 99) as u64));
        random.bits();
        let reads = random.even(3.0_f64.sqrt());
        CASES
            .iter()
            .map(|case| {
                let (empty, full): (Vec<_>, Vec<_>) = pairs.iter().cloned().unzip();
                let settings = match case.scale {
                    Some(std) => ToolSettings {
                        known_mass: Some(truth[0] + std * reads),
                        mass_std: std,
                        ..ToolSettings::default()
                    },
                    None => ToolSettings::default(),
                };
                let found = identify_tool(&lwr.arm, &empty[..case.logs[0]], &full[..case.logs[1]], &settings)?;
                let nothing = [f64::NAN; 3];
                let (center, std) = found.body.as_ref().map_or((nothing, nothing), |b| (b.center, b.center_std));
                let off: [f64; 3] = std::array::from_fn(|k| center[k] - truth[k + 1] / truth[0]);
                let square = |v: [f64; 3]| v.iter().map(|x| x * x).sum::<f64>();
                let own = square(std::array::from_fn(|k| off[k] / std[k])) / 3.0;
                Ok([100.0 * (found.values[0] / truth[0] - 1.0), square(off), square(std), own])
            })
            .collect()
    };
    let runs = many(RUNS, &one, watch)?;
    let of = |k: usize, case: LogCounts| {
        let each = || runs.iter().map(move |run| run[k]);
        let mean = |f: fn(&[f64; 4]) -> f64| each().map(|r| f(&r)).sum::<f64>() / RUNS as f64;
        Repeated {
            case,
            mass_within: Tally::of(each().map(|r| r[0].abs() <= ASKED[0])),
            center_rms: mean(|r| r[1]).sqrt(),
            center_std: mean(|r| r[2].sqrt()),
            center_worst: each().map(|r| r[1].sqrt()).fold(0.0, f64::max),
            center_within: Tally::of(each().map(|r| r[1].sqrt() <= ASKED[1])),
            spread: mean(|r| r[3]).sqrt(),
        }
    };
    Ok(CASES.iter().enumerate().map(|(k, &case)| of(k, case)).collect())
}

/// Compares standard deviations in SI units: relative ones of parameters that are zero are
/// meaningless.
pub fn verdict(row: &ToolRow) -> Verdict {
    Verdict::less(row.ours[1], row.paper[1])
}
