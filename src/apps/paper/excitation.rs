//! Section III of the paper: Fig. 5 (gain of a longer motion, for each criterion), and the same
//! task on other arms.

use dh_codegen::robot::{Robot, no_files};

use super::ReproduceError;
use super::Watch;
use super::lwr::Lwr;
use super::motions::{ACCELERATION_TIME, CRITERIA};
use crate::excite::{AtDuration, Criterion, Effort, Progress, Task, by_duration};
use crate::model::differentiated::Differentiated;

/// Duration chosen in the paper, s (section III.D): "no significant minimization of cost function
/// values can be observed after 10 s".
pub const CHOSEN: f64 = 10.0;

/// A published condition number, with the conditions under which it was obtained.
type Published = Option<(f64, &'static str)>;

/// Other arms: name, robot file, and the published condition number of a motion on a similar
/// problem, with its scaling of the columns.
const OTHERS: [(&str, &str, Published); 5] = [
    (
        "franka-panda",
        include_str!("../../../robots/franka-panda.yaml"),
        Some((121.9, "its authors' columns and scaling")),
    ),
    (
        "kuka-iiwa14",
        include_str!("../../../robots/kuka-iiwa14.yaml"),
        Some((116.7, "with a payload, 10 s, its authors' columns and scaling")),
    ),
    ("ur10e", include_str!("../../../robots/ur10e.yaml"), None),
    ("kinova-gen3", include_str!("../../../robots/kinova-gen3.yaml"), None),
    ("staubli-tx40", include_str!("../../../robots/staubli-tx40.yaml"), None),
];

/// Settings of the experiment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ExcitationSettings {
    /// Longest motion of Fig. 5, s. Default 15.
    pub longest: usize,
    /// Number of random motions with which each search begins. Default 8.
    pub starts: usize,
    /// Seed of the random motions. Default 1.
    pub seed: u64,
}

impl Default for ExcitationSettings {
    fn default() -> Self {
        Self { longest: 15, starts: 8, seed: 1 }
    }
}

/// The motion with the smallest condition number for another arm.
#[derive(Debug, Clone, PartialEq)]
pub struct Other {
    /// Name of the arm.
    pub robot: &'static str,
    /// Number of columns used: those of the links.
    pub columns: usize,
    /// Condition number of the unscaled columns; `None` if no motion inside the limits was found.
    pub condition: Option<f64>,
    /// Published condition number, with the conditions under which it was obtained.
    pub published: Option<(f64, &'static str)>,
}

/// Gain of a criterion after [`CHOSEN`] seconds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Late {
    /// Share of the total decrease, from the shortest to the longest motion, that comes after
    /// [`CHOSEN`]; of the logarithm for the condition number.
    pub share: f64,
    /// Mean standard deviation of a parameter at the end relative to that at [`CHOSEN`], from
    /// `log det`.
    pub deviation: Option<f64>,
    /// The same ratio if only the number of samples grew: `sqrt(T_chosen / T)`.
    pub by_samples: f64,
}

/// Results of the experiment.
#[derive(Debug, Clone, PartialEq)]
pub struct Excitation {
    /// Settings used.
    pub settings: ExcitationSettings,
    /// Number of columns used.
    pub columns: usize,
    /// Fig. 5: one row per criterion and second.
    pub fig5: Vec<AtDuration>,
    /// Motions of [`CHOSEN`] seconds for other arms.
    pub others: Vec<Other>,
}

impl Excitation {
    /// Rows of one criterion.
    pub fn of<'a>(&'a self, criterion: &'a str) -> impl Iterator<Item = &'a AtDuration> {
        self.fig5.iter().filter(move |row| row.criterion == criterion)
    }

    /// Late gain, if the criterion has values at both ends and at [`CHOSEN`].
    pub fn late(&self, criterion: &str) -> Option<Late> {
        let value = |row: &AtDuration| row.value.map(|v| if criterion == "cond" { v.ln() } else { v });
        let at = self.of(criterion).find(|row| row.seconds == CHOSEN).and_then(value)?;
        let first = self.of(criterion).find_map(value)?;
        let last = self.of(criterion).filter(|row| row.seconds > CHOSEN).last()?;
        let end = value(last)?;
        let deviation = (criterion == "logdet").then(|| ((end - at) / (2.0 * self.columns as f64)).exp());
        Some(Late { share: (at - end) / (first - end), deviation, by_samples: (CHOSEN / last.seconds).sqrt() })
    }
}

/// Designs all motions: three criteria for 1 to [`ExcitationSettings::longest`] seconds on the LWR,
/// then one motion for each other arm. Columns are those of the links, unscaled, at 100 Hz.
///
/// # Errors
/// Returns an error if a built-in robot can't be used.
pub fn excitation(settings: &ExcitationSettings, watch: Watch<'_>) -> Result<Excitation, ReproduceError> {
    let effort = Effort { starts: settings.starts, seed: settings.seed, ..Effort::default() };
    let durations: Vec<f64> = (1..=settings.longest).map(|s| s as f64).collect();
    let criteria: Vec<Criterion> = CRITERIA.iter().map(|(_, criterion)| criterion.clone()).collect();
    let runs = (criteria.len() * durations.len() + OTHERS.len()) as f64;

    let lwr = Lwr::new()?;
    let arm = Differentiated::new(&lwr.robot);
    let task = task(&arm, &lwr.robot)?;
    let tell = |run: usize, p: &Progress| {
        let what = format!("{} {} s", CRITERIA[run / durations.len()].0, durations[run % durations.len()]);
        watch(&what, (run as f64 + p.done as f64 / p.total.max(1) as f64) / runs);
    };
    let fig5 = by_duration(&task, &criteria, &durations, &effort, &tell);

    let mut others = Vec::new();
    for (name, text, published) in OTHERS {
        let read = Robot::from_yaml(text, &no_files);
        let robot = read.map_err(ReproduceError::in_file(name))?.robot;
        let arm = Differentiated::new(&robot);
        let task = self::task(&arm, &robot)?;
        let tell = |_: usize, p: &Progress| {
            let done = (fig5.len() + others.len()) as f64;
            watch(name, (done + p.done as f64 / p.total.max(1) as f64) / runs);
        };
        let rows = by_duration(&task, &[Criterion::Condition], &[CHOSEN], &effort, &tell);
        let condition = rows.first().and_then(|row| row.condition);
        others.push(Other { robot: name, columns: task.base.len(), condition, published });
    }
    Ok(Excitation { settings: *settings, columns: task.base.len(), fig5, others })
}

fn task<'a>(arm: &'a Differentiated, robot: &Robot) -> Result<Task<'a>, ReproduceError> {
    let what = format!("a motion for {}", robot.name);
    let mut task = Task::new(arm, robot, CHOSEN, ACCELERATION_TIME).map_err(ReproduceError::design(&what))?;
    task.links_only();
    Ok(task)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(criterion: &'static str, seconds: f64, value: f64) -> AtDuration {
        AtDuration { criterion, seconds, value: Some(value), condition: None, change: None }
    }

    #[test]
    fn samples_alone_are_no_better_motion() {
        let columns = 43;
        let log_det = |t: f64| -500.0 - columns as f64 * (t / CHOSEN).ln();
        let fig5 = [1.0, 10.0, 15.0].map(|t| row("logdet", t, log_det(t))).to_vec();
        let found = Excitation { settings: ExcitationSettings::default(), columns, fig5, others: Vec::new() };
        let late = found.late("logdet").unwrap();
        assert!((late.deviation.unwrap() - late.by_samples).abs() < 1e-12, "{late:?}");
        assert!((late.share - 1.5_f64.ln() / 15.0_f64.ln()).abs() < 1e-12, "{late:?}");
        assert_eq!(found.late("cond"), None);
    }
}
