//! The watch over a fleet: references, tests of drift, causes.
//!
//! Two passes over the table, day by day: the first merges each robot's reference days and solves
//! them, the second tests. What is kept per robot is its model and its detector, whatever the
//! number of days. A robot with a change is read a third time, for the cause and its history.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use datafusion::arrow::array::{Array, AsArray, RecordBatch};
use datafusion::arrow::datatypes::{Date32Type, Float64Type};
use datafusion::dataframe::DataFrame;
use datafusion::datasource::listing::ListingTableUrl;
use datafusion::functions_aggregate::expr_fn::max;
use datafusion::prelude::{Expr, ParquetReadOptions, col, lit};
use datafusion::scalar::ScalarValue;
use denavit::identify::{JointFactor, KeyedFactors, RecordingFactor};
use futures::StreamExt;
use serde::{Deserialize, Serialize};

use crate::Fleet;
use crate::attribution::{Assumptions, DayEvidence, Explanation, clearest, explanations};
use crate::channel::ChannelEstimate;
use crate::error::FleetError;
use crate::functions::diagnose::verdict;
use crate::reference::Reference;
use crate::remote::{is_url, store};
use crate::robots::KnownRobot;
use crate::sequential::{Detection, Detector, Observed, Sequential};

/// Name of the table in the session.
pub const TABLE: &str = "factors";

/// A robot that changed.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Change {
    /// The robot.
    pub robot: String,
    /// Its robot file.
    pub robot_file: PathBuf,
    /// Last day before the robot's previous change; its reference days are those after it.
    pub since: Option<i32>,
    /// Last day without the change, days since 1970.
    pub before: i32,
    /// Day on which it was certain enough.
    pub found: i32,
    /// Value of the detector there, days.
    pub evidence: f64,
    /// Parameter that shows it best.
    pub parameter: String,
    /// Its change and standard deviation.
    pub size: [f64; 2],
    /// Unit of both.
    pub unit: Cow<'static, str>,
    /// Causes that may explain it, best first.
    pub causes: Vec<Explanation>,
    /// Days and estimates of the best cause's clearest parameter, alone.
    pub history: Vec<(i32, f64, f64)>,
    /// The parameter of the history.
    pub plotted: String,
    /// Its unit.
    pub plotted_unit: Cow<'static, str>,
    /// Base parameters of its reference days.
    pub reference: Vec<f64>,
    /// Recordings of the day on which it was found.
    pub files: Vec<String>,
    /// What the diagnosis of the raw log says, where it was asked for.
    pub diagnosis: Option<String>,
}

/// What a watch found.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Watched {
    /// In the order of robots and days.
    pub changes: Vec<Change>,
    /// Robots.
    pub robots: usize,
    /// Days with a factor, summed over robots.
    pub robot_days: usize,
    /// Recordings without a factor: file and reason.
    pub unusable: Vec<(String, String)>,
    /// Recordings with a factor and without a day, which no test can take.
    pub undated: usize,
    /// Robots without enough days for a test, or without a model: name and reason.
    pub untested: Vec<(String, String)>,
    /// Mean number of days of one robot between false alarms, at least.
    pub days_between: f64,
}

impl Watched {
    /// By robots and days, whatever the order in which they were found.
    fn sort(&mut self) {
        self.changes.sort_by(|a, b| (&a.robot, a.found).cmp(&(&b.robot, b.found)));
        self.unusable.sort();
        self.unusable.truncate(MOST_LISTED);
        self.untested.sort();
    }

    /// What was found of other robots.
    #[cfg(feature = "cluster")]
    pub(crate) fn add(&mut self, other: Self) {
        self.changes.extend(other.changes);
        self.unusable.extend(other.unusable);
        self.untested.extend(other.untested);
        self.robots += other.robots;
        self.robot_days += other.robot_days;
        self.undated += other.undated;
        self.sort();
    }
}

/// Most recordings without a factor that are listed.
const MOST_LISTED: usize = 200;

/// Robots that are worked on at once: some MB.
const TOGETHER: usize = 64;

/// What is kept of a robot.
struct Watching {
    known: Arc<KnownRobot>,
    reference: Reference,
    /// Robots are tested side by side, each by one thread.
    detector: Mutex<Detector>,
}

/// A change that the test found, and its place.
struct Alarm {
    robot: String,
    day: i32,
    detection: Detection,
    /// Last day before the change that was found before this one.
    since: Option<i32>,
    files: Vec<String>,
}

/// Recordings of one robot and day.
#[derive(Default)]
struct RobotDay {
    robot: String,
    day: i32,
    /// Keys and factors, as they are in the table.
    recordings: Vec<(String, Vec<u8>)>,
    warmth: Vec<f64>,
    files: Vec<String>,
}

impl Fleet {
    /// Registers a table of factors: a file, a folder of Parquet, or a URL of one.
    ///
    /// # Errors
    /// Where it can't be read.
    pub async fn factors(&self, path: &str) -> Result<(), FleetError> {
        if is_url(path) {
            store(&self.context.runtime_env(), &ListingTableUrl::parse(path)?)?;
        }
        Ok(self.context.register_parquet(TABLE, path, ParquetReadOptions::default()).await?)
    }

    /// Narrows the table to rows of which this is true.
    async fn narrow(&self, rows: Expr) -> Result<(), FleetError> {
        let some = self.table().await?.filter(rows)?;
        self.context.deregister_table(TABLE)?;
        self.context.register_table(TABLE, some.into_view())?;
        Ok(())
    }

    /// Leaves days before this one out of the table; recordings without a day stay.
    ///
    /// # Errors
    /// What the engine says.
    pub async fn from(&self, day: i32) -> Result<(), FleetError> {
        self.narrow(col("day").is_null().or(col("day").gt_eq(lit(ScalarValue::Date32(Some(day)))))).await
    }

    /// Narrows the table to the robots from the first of these names to the last.
    ///
    /// # Errors
    /// What the engine says.
    #[cfg(feature = "cluster")]
    pub(crate) async fn only(&self, sorted: &[String]) -> Result<(), FleetError> {
        let (Some(first), Some(last)) = (sorted.first(), sorted.last()) else { return Ok(()) };
        self.narrow(col("robot").between(lit(first), lit(last))).await
    }

    /// Names of the robots, sorted.
    #[cfg(feature = "cluster")]
    pub(crate) async fn names(&self) -> Result<Vec<String>, FleetError> {
        let rows = self.table().await?.select(vec![col("robot")])?.distinct()?.sort_by(vec![col("robot")])?;
        let mut names = Vec::new();
        for batch in rows.collect().await? {
            names.extend(batch.column(0).as_string::<i32>().iter().flatten().map(String::from));
        }
        Ok(names)
    }

    /// Diagnoses the raw log of each flagged robot-day, against the robot file with the friction and
    /// offsets of the reference days. Relative paths start from `base`.
    ///
    /// # Errors
    /// Where a robot file can't be read. A log that can't be used is no error.
    pub fn diagnose(&self, watched: &mut Watched, base: &Path) -> Result<(), FleetError> {
        let stores = self.context.runtime_env();
        for change in &mut watched.changes {
            let robot = self.robots.open(&change.robot_file)?.with_friction(&change.reference);
            let said = change.files.iter().map(|file| {
                let place = if is_url(file) { file.clone() } else { base.join(file).display().to_string() };
                format!("{file}: {}", verdict(&place, &robot, &stores))
            });
            change.diagnosis = Some(said.collect::<Vec<_>>().join("\n"));
        }
        Ok(())
    }

    /// Tests every robot of the table.
    ///
    /// # Errors
    /// Where the table can't be read, or has a factor of an unknown robot file.
    pub async fn watch(&self, settings: &Sequential) -> Result<Watched, FleetError> {
        let mut watched = Watched { days_between: settings.days_between, ..Watched::default() };
        self.unusable(&mut watched).await?;
        let undated = col("why").is_null().and(col("day").is_null());
        watched.undated = self.table().await?.filter(undated)?.count().await?;
        let days = self.days().await?;
        let robots = self.references(&days, settings, &mut watched).await?;
        let (mut found, mut last) = (Vec::<Alarm>::new(), BTreeMap::<String, i32>::new());
        for &day in &days {
            self.each_robot(day, |some| {
                watched.robot_days += some.len();
                let tested = self.parallel(&some, |today| robots.get(&today.robot).map(|robot| robot.tested(today)));
                for (today, tested) in some.into_iter().zip(tested) {
                    let Some(detection) = tested.transpose()?.flatten() else { continue };
                    let since = last.insert(today.robot.clone(), detection.before);
                    found.push(Alarm { robot: today.robot, day, detection, since, files: today.files });
                }
                Ok(())
            })
            .await?;
        }
        for alarm in found {
            if let Some(robot) = robots.get(&alarm.robot) {
                watched.changes.push(self.change(robot, alarm, settings).await?);
            }
        }
        watched.sort();
        Ok(watched)
    }

    async fn table(&self) -> Result<DataFrame, FleetError> {
        Ok(self.context.table(TABLE).await?)
    }

    /// Recordings without a factor.
    async fn unusable(&self, watched: &mut Watched) -> Result<(), FleetError> {
        let rows = self.table().await?.filter(col("why").is_not_null())?;
        let rows =
            rows.select(vec![col("file"), col("why")])?.sort_by(vec![col("file")])?.limit(0, Some(MOST_LISTED))?;
        for batch in rows.collect().await? {
            let (files, whys) = (batch.column(0).as_string::<i32>(), batch.column(1).as_string::<i32>());
            for (file, why) in files.iter().zip(whys) {
                watched.unusable.push((file.unwrap_or_default().into(), why.unwrap_or_default().into()));
            }
        }
        Ok(())
    }

    /// Days with a factor, in order.
    async fn days(&self) -> Result<Vec<i32>, FleetError> {
        let rows = self.table().await?.filter(with_factor())?;
        let rows = rows.select(vec![col("day")])?.distinct()?.sort_by(vec![col("day")])?;
        let mut days = Vec::new();
        for batch in rows.collect().await? {
            days.extend(batch.column(0).as_primitive::<Date32Type>().iter().flatten());
        }
        Ok(days)
    }

    /// The models of all robots from their reference days.
    async fn references(
        &self,
        days: &[i32],
        settings: &Sequential,
        watched: &mut Watched,
    ) -> Result<BTreeMap<String, Watching>, FleetError> {
        let wanted = settings.reference_days.max(4);
        let last = self.last_days().await?;
        let mut open: BTreeMap<String, (usize, RecordingFactor)> = BTreeMap::new();
        let mut done: BTreeMap<String, Watching> = BTreeMap::new();
        watched.robots = last.len();
        for &day in days {
            if done.len() + watched.untested.len() == last.len() {
                break;
            }
            self.each_robot(day, |some| {
                let some: Vec<RobotDay> = some.into_iter().filter(|today| !done.contains_key(&today.robot)).collect();
                let merged = self.parallel(&some, |today| today.merged_into(open.get(&today.robot)));
                let merged: Vec<(usize, RecordingFactor)> = merged.into_iter().collect::<Result<_, _>>()?;
                let solved = self
                    .parallel(&merged, |(count, merged)| (*count >= wanted).then(|| self.reference(merged, settings)));
                for ((today, merged), solved) in some.into_iter().zip(merged).zip(solved) {
                    open.remove(&today.robot);
                    match solved {
                        None => drop(open.insert(today.robot, merged)),
                        Some(Ok(watching)) => drop(done.insert(today.robot, watching)),
                        Some(Err(why)) => watched.untested.push((today.robot, why.to_string())),
                    }
                }
                Ok(())
            })
            .await?;
        }
        let short = |(name, (count, _)): (String, (usize, _))| {
            (name, format!("days with a factor: {count}; the reference takes {wanted}"))
        };
        watched.untested.extend(open.into_iter().map(short));
        Ok(done)
    }

    /// The model of a robot from its reference days.
    fn reference(&self, merged: &RecordingFactor, settings: &Sequential) -> Result<Watching, FleetError> {
        let known = self.robots.of(merged)?;
        let none = || FleetError::NoReference { what: known.robot.name.clone() };
        let reference = Reference::of(&merged.factors).ok_or_else(none)?;
        Ok(Watching { known, reference, detector: Mutex::new(Detector::new(*settings)) })
    }

    /// The same of all, on the threads of the session, in order.
    fn parallel<T: Sync, R: Send>(&self, all: &[T], of: impl Fn(&T) -> R + Sync) -> Vec<R> {
        let each = all.len().div_ceil(self.threads).max(1);
        let of = &of;
        std::thread::scope(|scope| {
            let parts = all.chunks(each);
            let started: Vec<_> =
                parts.map(|part| scope.spawn(move || part.iter().map(of).collect::<Vec<R>>())).collect();
            let ended = started.into_iter().map(|thread| thread.join());
            ended.flat_map(|part| part.unwrap_or_else(|panic| std::panic::resume_unwind(panic))).collect()
        })
    }

    /// Each robot's last day.
    async fn last_days(&self) -> Result<BTreeMap<String, i32>, FleetError> {
        let rows = self.table().await?.filter(with_factor())?;
        let rows = rows.aggregate(vec![col("robot")], vec![max(col("day"))])?;
        let mut last = BTreeMap::new();
        for batch in rows.collect().await? {
            let (names, days) = (batch.column(0).as_string::<i32>(), batch.column(1).as_primitive::<Date32Type>());
            for (name, day) in names.iter().zip(days) {
                last.extend(name.map(String::from).zip(day));
            }
        }
        Ok(last)
    }

    /// Calls `then` with the robots that have a factor of this day, their recordings merged, some
    /// at a time.
    async fn each_robot(
        &self,
        day: i32,
        mut then: impl FnMut(Vec<RobotDay>) -> Result<(), FleetError>,
    ) -> Result<(), FleetError> {
        let rows = self.table().await?.filter(col("day").eq(lit(ScalarValue::Date32(Some(day)))))?;
        let mut some = Vec::new();
        each(rows, |today| {
            some.push(today);
            if some.len() < TOGETHER { Ok(()) } else { then(std::mem::take(&mut some)) }
        })
        .await?;
        then(some)
    }

    /// The cause of a change, and its history.
    async fn change(&self, robot: &Watching, alarm: Alarm, settings: &Sequential) -> Result<Change, FleetError> {
        let Alarm { robot: name, day, detection, since, files } = alarm;
        let channels = &robot.known.channels;
        let (mut before, mut after) = (Vec::<DayEvidence>::new(), Vec::<DayEvidence>::new());
        let mut estimates: Vec<(i32, Vec<ChannelEstimate>)> = Vec::new();
        each(self.table().await?.filter(col("robot").eq(lit(&name)))?, |today| {
            let factors = today.factor()?.factors;
            estimates.push((today.day, channels.estimates(&factors, &robot.reference)));
            if today.day <= day && since.is_none_or(|since| today.day > since) {
                let days = if today.day > detection.before { &mut after } else { &mut before };
                days.push(channels.evidence(&factors, &robot.reference));
            }
            Ok(())
        })
        .await?;
        let assumptions = Assumptions { change: settings.change, correlation: detection.correlation };
        let causes = explanations(&channels.list, &before, &after, assumptions);
        let parameter = causes.first().and_then(clearest).map(|by| by.parameter.as_str());
        let shown = parameter.and_then(|name| channels.list.iter().position(|channel| channel.parameter == name));
        let shown = shown.unwrap_or(detection.channel);
        let point = |(day, all): (i32, Vec<ChannelEstimate>)| (day, all[shown].value, all[shown].variance.sqrt());
        let best = &channels.list[detection.channel];
        Ok(Change {
            robot: name,
            robot_file: robot.known.file.path.clone(),
            since,
            before: detection.before,
            found: day,
            evidence: detection.evidence,
            parameter: best.parameter.clone(),
            size: detection.size,
            unit: best.unit.into(),
            causes,
            history: estimates.into_iter().map(point).collect(),
            plotted: channels.list[shown].parameter.clone(),
            plotted_unit: channels.list[shown].unit.into(),
            reference: robot.reference.beta.clone(),
            files,
            diagnosis: None,
        })
    }
}

/// Rows with a factor of a day. A test on the column of factors would read it all.
fn with_factor() -> Expr {
    col("why").is_null().and(col("day").is_not_null())
}

impl Watching {
    /// Takes a day into the test.
    fn tested(&self, today: &RobotDay) -> Result<Option<Detection>, FleetError> {
        let estimates = self.known.channels.estimates(&today.factor()?.factors, &self.reference);
        let seen: Vec<Observed> =
            estimates.into_iter().map(|e| Observed { value: e.value, variance: e.variance }).collect();
        let mut detector = self.detector.lock().unwrap_or_else(PoisonError::into_inner);
        Ok(detector.day(today.day, today.temperature(), &seen))
    }
}

/// Calls `then` with each day of each robot of some rows, day by day.
async fn each(rows: DataFrame, mut then: impl FnMut(RobotDay) -> Result<(), FleetError>) -> Result<(), FleetError> {
    let rows = rows.filter(with_factor())?;
    let columns = ["robot", "sha256", "temperature", "factor", "file", "day"].map(col);
    let rows = rows.select(columns.to_vec())?.sort_by(["day", "robot", "sha256"].map(col).to_vec())?;
    let mut stream = rows.execute_stream().await?;
    let mut open = RobotDay::default();
    while let Some(batch) = stream.next().await {
        let batch: RecordBatch = batch?;
        for row in 0..batch.num_rows() {
            let name = batch.column(0).as_string::<i32>().value(row);
            let day = batch.column(5).as_primitive::<Date32Type>().value(row);
            if name != open.robot || day != open.day {
                let begun = RobotDay { robot: name.into(), day, ..RobotDay::default() };
                std::mem::replace(&mut open, begun).close(&mut then)?;
            }
            open.take(&batch, row);
        }
    }
    open.close(&mut then)
}

impl RobotDay {
    fn take(&mut self, batch: &RecordBatch, row: usize) {
        let (digests, factors) = (batch.column(1).as_string::<i32>(), batch.column(3).as_binary::<i32>());
        let file = batch.column(4).as_string::<i32>().value(row);
        let key = if digests.is_null(row) { file } else { digests.value(row) };
        if factors.is_null(row) {
            return;
        }
        self.recordings.push((key.into(), factors.value(row).to_vec()));
        self.files.push(file.into());
        let warmth = batch.column(2).as_primitive::<Float64Type>();
        self.warmth.extend((!warmth.is_null(row)).then(|| warmth.value(row)));
    }

    fn close(self, then: &mut impl FnMut(Self) -> Result<(), FleetError>) -> Result<(), FleetError> {
        if self.recordings.is_empty() { Ok(()) } else { then(self) }
    }

    /// Mean over the recordings that have one, deg C.
    fn temperature(&self) -> Option<f64> {
        let mean = self.warmth.iter().sum::<f64>() / self.warmth.len().max(1) as f64;
        (!self.warmth.is_empty()).then_some(mean)
    }

    /// The factor of all recordings of the day.
    fn factor(&self) -> Result<RecordingFactor, FleetError> {
        if let [(key, bytes)] = self.recordings.as_slice() {
            let factor = RecordingFactor::from_bytes(key, bytes)?;
            // Merging leaves joints without torque out; without such, one recording is itself.
            if factor.factors.joints.iter().all(JointFactor::is_live) {
                return Ok(factor);
            }
        }
        let mut factors = KeyedFactors::default();
        for (key, bytes) in &self.recordings {
            factors.insert(key.clone(), RecordingFactor::from_bytes(key, bytes)?)?;
        }
        let folded = factors.fold(&self.robot)?;
        folded.ok_or_else(|| FleetError::NoReference { what: self.robot.clone() })
    }

    /// Number of days and factor of a robot's days so far, with this one.
    fn merged_into(&self, before: Option<&(usize, RecordingFactor)>) -> Result<(usize, RecordingFactor), FleetError> {
        let today = self.factor()?;
        let Some((count, before)) = before else { return Ok((1, today)) };
        let mut merged = before.clone();
        merged.merge(&today)?;
        Ok((count + 1, merged))
    }
}
