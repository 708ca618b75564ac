//! The commands: `factor`, `watch`, `report`, `sql`, `worker`.

use std::path::{Path, PathBuf};
use std::process::Command as Process;
#[cfg(feature = "cluster")]
use std::sync::Arc;

use clap::{Args, Parser, Subcommand};
use datafusion::arrow::util::pretty::pretty_format_batches;
use denavit::report::visible;

use crate::Fleet;
use crate::calendar::{date, day};
#[cfg(feature = "cluster")]
use crate::cluster::{self, Workers};
use crate::error::FleetError;
pub use crate::output::say;
use crate::output::{check, print, write};
use crate::recordings::RecordingsTable;
use crate::remote::{Place, RecordingFile, is_url};
use crate::report;
use crate::sequential::Sequential;
use crate::store::{By, Store, Written};
use crate::watch::Watched;

/// Models of a fleet of robots from its recordings: factors, tests of drift, SQL.
#[derive(Parser)]
#[command(name = "denavit-fleet", version, arg_required_else_help = true)]
pub struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Factor recordings into a folder of tables. Recordings that have a row there are not read
    /// again.
    Factor(Factor),
    /// Test each robot for drift, and name the cause of a change.
    Watch(Watch),
    /// The same as `watch`, as one page that needs no network.
    Report(Report),
    /// Ask a question in SQL. The table is `factors`; functions are `recordings`, `merge_factor`,
    /// `solve`, `drift`, `predict_error` and `diagnose`.
    Sql(Sql),
    /// Work for `factor`, `watch`, `report` and `sql` on other machines. Who reaches the address
    /// can have any file read that this process may read: for a network of one's own.
    #[cfg(feature = "cluster")]
    Worker(Worker),
}

/// Threads of the engine.
#[derive(Args, Clone)]
struct Threads {
    /// Threads. Default: the machine's.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
}

impl Threads {
    fn count(&self) -> usize {
        let own = || std::thread::available_parallelism().map_or(1, usize::from);
        self.threads.map_or_else(own, usize::from)
    }
}

#[derive(Args)]
struct Factor {
    /// Recordings, or folders of them; or URLs of an object store (`s3://`, `https://`, `http://`,
    /// `file://`), with the credentials of the environment.
    #[arg(required = true, value_name = "LOG")]
    logs: Vec<PathBuf>,
    /// Robot file.
    #[arg(long, value_name = "ROBOT")]
    robot: PathBuf,
    /// Name of the arm in the table, where many share a robot file. Default: the name in the file.
    #[arg(long, value_name = "NAME")]
    name: Option<String>,
    /// Day of recordings whose time starts at 0 instead of being that of a calendar.
    #[arg(long, value_name = "YYYY-MM-DD", value_parser = date_of)]
    day: Option<i32>,
    /// Folder of the tables; it is made.
    #[arg(long, value_name = "FOLDER")]
    out: PathBuf,
    /// Who shares the recordings: a number of processes of this machine, or addresses of workers
    /// (`10.0.0.7:7070,10.0.0.8:7070`) that find the recordings by the same paths or URLs. If one
    /// dies, the other workers do the rest, or the same command does what is missing.
    #[arg(long, default_value = "1", value_name = "N|ADDRESSES", value_parser = Sharing::parse)]
    workers: Sharing,
    /// Only every n-th recording from the k-th on, as `k/n`; the rows are committed, and no table
    /// is made of them. For runners of one's own.
    #[arg(long, value_name = "K/N", conflicts_with = "workers")]
    share: Option<String>,
    #[command(flatten)]
    threads: Threads,
}

/// Who does the work.
#[derive(Debug, Clone)]
enum Sharing {
    /// So many processes of this machine.
    Processes(usize),
    /// Workers on other machines.
    #[cfg(feature = "cluster")]
    Workers(Workers),
}

impl Sharing {
    fn parse(text: &str) -> Result<Self, FleetError> {
        match text.parse::<usize>() {
            Ok(count @ 1..=256) => Ok(Self::Processes(count)),
            Ok(_) => Err(FleetError::Option(format!("--workers {text}: 1 to 256 processes"))),
            Err(_) => Self::addresses(text),
        }
    }

    #[cfg(feature = "cluster")]
    fn addresses(text: &str) -> Result<Self, FleetError> {
        Workers::parse(text).map(Self::Workers)
    }

    #[cfg(not(feature = "cluster"))]
    fn addresses(text: &str) -> Result<Self, FleetError> {
        let built = "for addresses this program needs the feature `cluster`, without which it was built";
        Err(FleetError::Option(format!("--workers {text}: no number; {built}")))
    }
}

#[cfg(feature = "cluster")]
#[derive(Args)]
struct Worker {
    /// Address and port to listen on. `0.0.0.0:7070` is every network of the machine.
    #[arg(long, default_value = "127.0.0.1:7070", value_name = "ADDRESS:PORT")]
    listen: std::net::SocketAddr,
    /// Robot files of factors, for `solve` and `drift` in SQL. `factor` and `watch` send theirs.
    #[arg(long, num_args = 1.., value_name = "ROBOT")]
    robot: Vec<PathBuf>,
    #[command(flatten)]
    threads: Threads,
}

#[derive(Args)]
struct Watch {
    /// Table of factors: a file, a folder, or a URL that ends with `/`.
    #[arg(value_name = "FACTORS")]
    factors: PathBuf,
    /// Robot files.
    #[arg(long, required = true, num_args = 1.., value_name = "ROBOT")]
    robot: Vec<PathBuf>,
    /// Days of a robot that make its reference.
    #[arg(long, default_value_t = 10, value_name = "DAYS", value_parser = clap::value_parser!(u16).range(4..=1000))]
    reference: u16,
    /// False alarms per robot and year, at most.
    #[arg(long, default_value_t = 1.0, value_name = "RATE")]
    false_alarms: f64,
    /// Leave days before this one out; the reference is then of the first days from it on.
    #[arg(long, value_name = "YYYY-MM-DD", value_parser = date_of)]
    from: Option<i32>,
    /// Diagnose the raw log of each flagged robot-day; its files must still be there.
    #[arg(long)]
    diagnose: bool,
    /// Write the result as JSON.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Addresses of workers that share the robots, and find the table (and, for `--diagnose`, the
    /// recordings) by the same paths or URLs.
    #[cfg(feature = "cluster")]
    #[arg(long, value_name = "ADDRESSES", value_parser = Workers::parse)]
    workers: Option<Workers>,
    #[command(flatten)]
    threads: Threads,
}

#[derive(Args)]
struct Report {
    #[command(flatten)]
    watch: Watch,
    /// Page to write.
    #[arg(long, value_name = "FILE.html")]
    out: PathBuf,
}

#[derive(Args)]
struct Sql {
    /// Query.
    #[arg(value_name = "QUERY")]
    query: String,
    /// Table of factors: a file, a folder, or a URL that ends with `/`.
    #[arg(long, value_name = "FACTORS")]
    factors: Option<PathBuf>,
    /// Robot files of the factors.
    #[arg(long, num_args = 1.., value_name = "ROBOT")]
    robot: Vec<PathBuf>,
    /// Addresses of workers that share the query, and find what it reads by the same absolute
    /// paths or URLs.
    #[cfg(feature = "cluster")]
    #[arg(long, value_name = "ADDRESSES", value_parser = Workers::parse)]
    workers: Option<Workers>,
    #[command(flatten)]
    threads: Threads,
}

impl Cli {
    /// Threads that the command asks for.
    pub fn threads(&self) -> usize {
        match &self.command {
            Command::Factor(factor) => factor.threads.count(),
            Command::Watch(watch) => watch.threads.count(),
            Command::Report(report) => report.watch.threads.count(),
            Command::Sql(sql) => sql.threads.count(),
            // One more answers while the others work.
            #[cfg(feature = "cluster")]
            Command::Worker(worker) => worker.threads.count() + 1,
        }
    }

    /// Runs the command.
    ///
    /// # Errors
    /// What stands in its way.
    pub async fn run(self) -> Result<(), FleetError> {
        match self.command {
            Command::Factor(factor) => factor.run().await,
            Command::Watch(watch) => {
                let watched = watch.watched().await?;
                print(&report::text(&watched))
            }
            Command::Report(report) => {
                check(&report.out)?;
                let watched = report.watch.watched().await?;
                write(&report.out, &report::page(&watched))?;
                print(&report::text(&watched))
            }
            Command::Sql(sql) => sql.run().await,
            #[cfg(feature = "cluster")]
            Command::Worker(worker) => {
                let ready = |address| print(&format!("listening on {address}\n"));
                cluster::serve(worker.listen, &worker.robot, ready).await
            }
        }
    }
}

impl Factor {
    async fn run(&self) -> Result<(), FleetError> {
        let fleet = Fleet::new(self.threads.count());
        let robot = fleet.robots.open(&self.robot)?;
        let all = self.files(&fleet).await?;
        let store = Store::new(&self.out)?;
        let claim = if self.share.is_some() { store.share()? } else { store.claim()? };
        let name = self.name.clone().unwrap_or_else(|| robot.robot.name.clone());
        let (count, known) = (all.len(), store.known(&name).await?);
        let mut said = match &self.workers {
            Sharing::Processes(1) => {
                let files = known.missing(self.shared(all)?, By::Content);
                let table = RecordingsTable { robot, name, place: Place::Files(files), day: self.day };
                let written = store.factor(&fleet, table, &known, Self::say).await?;
                done(count, written)
            }
            Sharing::Processes(workers) => {
                let missing = known.missing(all, By::Content);
                let todo = missing.len();
                claim.shared()?;
                self.spread(*workers)?;
                claim.alone()?;
                let left = store.known(&name).await?.missing(missing, By::Content).len();
                format!("{todo} of {count} recordings were missing, {left} still are\n")
            }
            #[cfg(feature = "cluster")]
            Sharing::Workers(workers) => {
                let files = known.missing(all, By::Name);
                let table = RecordingsTable { robot, name, place: Place::Files(files), day: self.day };
                done(count, self.by(workers, &store, table).await?)
            }
        };
        if self.share.is_none()
            && let Some(table) = store.finish(&fleet).await?
        {
            said += &format!("wrote {}\n", visible(&table.display().to_string()));
        }
        print(&said)
    }

    fn say(file: &str, why: &str) {
        say(&format!("{file}: no factor: {why}"));
    }

    /// The table by these workers, and what one leaves undone by the others.
    #[cfg(feature = "cluster")]
    async fn by(&self, workers: &Workers, store: &Store, mut table: RecordingsTable) -> Result<Written, FleetError> {
        let (mut asked, mut all) = (workers.clone(), Written::default());
        loop {
            let known = store.known(&table.name).await?;
            let Place::Files(files) = table.place else { return Ok(all) };
            let files = known.missing(files, By::Name);
            let todo = files.len();
            table.place = Place::Files(files.clone());
            let (present, absent) = asked.present().await?;
            absent.iter().for_each(|why| say(why));
            if todo == 0 {
                return Ok(all);
            }
            let fleet = Fleet::on(&present, self.threads.count());
            let (robot, name, day) = (Arc::clone(&table.robot), table.name.clone(), table.day);
            let mut without = 0;
            let said = |file: &str, why: &str| {
                without += 1;
                Self::say(file, why);
            };
            match store.factor(&fleet, table, &known, said).await {
                Ok(written) => return Ok(all.and(written)),
                Err(FleetError::Engine(why)) => {
                    let left = store.known(&name).await?.missing(files, By::Name);
                    let (still, gone) = present.present().await?;
                    // Neither has anything come, nor is a worker gone: it would end the same way.
                    if left.len() == todo && still == present {
                        return Err(FleetError::Engine(why));
                    }
                    let said = match gone.is_empty() {
                        true => cluster::first_line(&why.to_string()).to_string(),
                        false => gone.join("; "),
                    };
                    say(&format!("{said}; once more, for {} recordings", left.len()));
                    all = all.and(Written { recordings: todo - left.len(), without });
                    table = RecordingsTable { robot, name, place: Place::Files(left), day };
                    asked = still;
                }
                Err(other) => return Err(other),
            }
        }
    }

    async fn files(&self, fleet: &Fleet) -> Result<Vec<RecordingFile>, FleetError> {
        let mut all = Vec::new();
        for path in &self.logs {
            let text = path.to_string_lossy();
            let place = if is_url(&text) { Place::of(&text)? } else { Place::Folder(path.clone()) };
            all.extend(place.recordings(&fleet.context.runtime_env()).await?);
        }
        all.sort_by_key(RecordingFile::name);
        all.dedup_by_key(|file| file.name());
        match all.is_empty() {
            true => Err(FleetError::Empty {
                path: self.logs[0].clone(),
                what: "recordings",
                advice: "name a folder with logs (.csv, .csv.gz, .parquet, .mcap, .npz, .mat)",
            }),
            false => Ok(all),
        }
    }

    /// The recordings of `--share`.
    fn shared(&self, all: Vec<RecordingFile>) -> Result<Vec<RecordingFile>, FleetError> {
        let Some(share) = &self.share else { return Ok(all) };
        let parts = share.split_once('/').and_then(|(k, n)| Some((k.parse::<usize>().ok()?, n.parse::<usize>().ok()?)));
        match parts.filter(|(k, n)| (1..=*n).contains(k)) {
            Some((k, n)) => Ok(all.into_iter().skip(k - 1).step_by(n).collect()),
            None => {
                Err(FleetError::Option(format!("--share {share}: two numbers as 1/4, the first at most the second")))
            }
        }
    }

    /// One process for each share, and all of them to their ends.
    fn spread(&self, workers: usize) -> Result<(), FleetError> {
        let own = |source| FleetError::File { path: "denavit-fleet".into(), verb: "started", source };
        let program = std::env::current_exe().map_err(own)?;
        let start = |k: usize| {
            let mut process = Process::new(&program);
            process.arg("factor").args(&self.logs).arg("--robot").arg(&self.robot).arg("--out").arg(&self.out);
            process.args(self.name.iter().flat_map(|name| ["--name", name]));
            process.args(self.day.iter().flat_map(|day| ["--day".into(), date(*day)]));
            process.args(["--threads", "1", "--share", &format!("{}/{workers}", k + 1)]);
            process.stdout(std::process::Stdio::null()).spawn().map_err(own)
        };
        let started: Vec<_> = (0..workers).map(start).collect::<Result<_, _>>()?;
        let mut failed = None;
        for (k, mut process) in started.into_iter().enumerate() {
            let sound = process.wait().is_ok_and(|status| status.success());
            failed = failed.or((!sound).then_some(k + 1));
        }
        failed.map_or(Ok(()), |number| Err(FleetError::Worker { number }))
    }
}

impl Watch {
    async fn watched(&self) -> Result<Watched, FleetError> {
        if !(self.false_alarms > 0.0 && self.false_alarms.is_finite()) {
            let text = format!("--false-alarms {}: a rate above 0 per robot and year", self.false_alarms);
            return Err(FleetError::Option(text));
        }
        self.json.as_deref().map_or(Ok(()), check)?;
        let fleet = opened(Some(&self.factors), &self.robot, Fleet::new(self.threads.count())).await?;
        let settings = Sequential {
            reference_days: usize::from(self.reference),
            days_between: 365.25 / self.false_alarms,
            ..Sequential::default()
        };
        if let Some(day) = self.from {
            fleet.from(day).await?;
        }
        let watched = self.found(&fleet, &settings).await?;
        if let Some(path) = &self.json {
            write(path, &format!("{:#}\n", report::json(&watched)))?;
        }
        Ok(watched)
    }

    async fn found(&self, fleet: &Fleet, settings: &Sequential) -> Result<Watched, FleetError> {
        #[cfg(feature = "cluster")]
        if let Some(workers) = &self.workers {
            let table = self.factors.display().to_string();
            return fleet.watch_by(workers, &table, self.from, settings, self.diagnose).await;
        }
        let mut watched = fleet.watch(settings).await?;
        if self.diagnose {
            fleet.diagnose(&mut watched, Path::new(""))?;
        }
        Ok(watched)
    }
}

impl Sql {
    async fn run(&self) -> Result<(), FleetError> {
        let fleet = opened(self.factors.as_deref(), &self.robot, self.session().await?).await?;
        let batches = fleet.context.sql(&self.query).await?.collect().await?;
        let table = pretty_format_batches(&batches).map_err(|e| FleetError::Engine(e.into()))?;
        print(&format!("{table}\n"))
    }

    async fn session(&self) -> Result<Fleet, FleetError> {
        #[cfg(feature = "cluster")]
        if let Some(workers) = &self.workers {
            let (present, absent) = workers.present().await?;
            absent.iter().for_each(|why| say(why));
            return Ok(Fleet::on(&present, self.threads.count()));
        }
        Ok(Fleet::new(self.threads.count()))
    }
}

/// What a run did.
fn done(count: usize, written: Written) -> String {
    let Written { recordings, without } = written;
    format!("{recordings} of {count} recordings were missing and are read, {without} without a factor\n")
}

/// A day on the command line.
fn date_of(text: &str) -> Result<i32, FleetError> {
    day(text).ok_or_else(|| FleetError::Option(format!("{text} is no date such as 2026-11-23")))
}

fn unreadable(path: &Path) -> impl FnOnce(std::io::Error) -> FleetError + use<'_> {
    move |source| FleetError::File { path: path.into(), verb: "read", source }
}

/// Whether a path is a table, or a folder with one at any depth.
fn has_tables(path: &Path) -> std::io::Result<bool> {
    if !std::fs::metadata(path)?.is_dir() {
        return Ok(path.extension().is_some_and(|ending| ending == "parquet"));
    }
    let mut folders = vec![path.to_path_buf()];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder)? {
            let entry = entry?;
            match entry.path() {
                // Not by links, which may lead back.
                folder if entry.file_type()?.is_dir() => folders.push(folder),
                file if file.extension().is_some_and(|ending| ending == "parquet") => return Ok(true),
                _ => {}
            }
        }
    }
    Ok(false)
}

/// A session with a table of factors and robots.
async fn opened(factors: Option<&Path>, robots: &[PathBuf], fleet: Fleet) -> Result<Fleet, FleetError> {
    for path in robots {
        fleet.robots.open(path)?;
    }
    if let Some(path) = factors {
        let name = path.display().to_string();
        if !is_url(&name) && !has_tables(path).map_err(unreadable(path))? {
            let advice = "`denavit-fleet factor` makes them";
            return Err(FleetError::Empty { path: path.into(), what: "tables of factors (.parquet)", advice });
        }
        fleet.factors(&name).await?;
    }
    Ok(fleet)
}
