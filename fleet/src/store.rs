//! The folder of factors: one committed file per recording while a run lasts, one table per run
//! afterwards.
//!
//! A row is written beside its name and renamed, so it is there whole or not at all; its name is
//! made of the recording's digest and the robot, so it is there once. A run that was killed, or a
//! worker of it, is repeated by the same command: what is there is not read again. Runs of one folder
//! are kept apart by a lock, for a table is made of all rows that are there.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use datafusion::arrow::array::{Array, AsArray, RecordBatch};
use datafusion::parquet::arrow::ArrowWriter;
use datafusion::parquet::basic::Compression;
use datafusion::parquet::errors::ParquetError;
use datafusion::parquet::file::properties::WriterProperties;
use datafusion::prelude::{ParquetReadOptions, col};
use denavit::data::log::hexadecimal;
use futures::StreamExt;
use sha2::{Digest, Sha256};
use tempfile::NamedTempFile;

use crate::Fleet;
use crate::error::FleetError;
use crate::open::digest;
use crate::output::unnamed;
use crate::recordings::RecordingsTable;
use crate::remote::RecordingFile;

/// Rows of recordings that are not in a table yet, below the folder.
const UNFINISHED: &str = "unfinished";

/// Endings of tables, and of rows that are in none yet.
const TABLE: &str = ".parquet";
const ROW: &str = ".row";

/// Rows of a row group: some MB of factors.
const GROUP: usize = 64;

/// A folder of factors.
#[derive(Debug, Clone)]
pub struct Store(PathBuf);

/// A folder that other runs keep away from. The system ends it with the process.
#[derive(Debug)]
pub struct Claim {
    folder: PathBuf,
    file: fs::File,
}

impl Claim {
    /// For this run alone.
    ///
    /// # Errors
    /// Where another run has the folder.
    pub fn alone(&self) -> Result<(), FleetError> {
        self.taken(self.file.try_lock())
    }

    /// For several runs that make no table.
    ///
    /// # Errors
    /// Where a run has the folder for itself.
    pub fn shared(&self) -> Result<(), FleetError> {
        self.taken(self.file.try_lock_shared())
    }

    fn taken(&self, lock: Result<(), fs::TryLockError>) -> Result<(), FleetError> {
        match lock {
            Ok(()) => Ok(()),
            Err(fs::TryLockError::WouldBlock) => Err(FleetError::Busy { path: self.folder.clone() }),
            // A file system without locks keeps the rest of its promises.
            Err(fs::TryLockError::Error(why)) if why.kind() == std::io::ErrorKind::Unsupported => Ok(()),
            Err(fs::TryLockError::Error(why)) => Err(unwritable(&self.folder)(why)),
        }
    }
}

/// What one run did.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Written {
    /// Recordings that were read.
    pub recordings: usize,
    /// Of them, those without a factor.
    pub without: usize,
}

impl Written {
    /// With what another run did.
    #[cfg(feature = "cluster")]
    pub(crate) fn and(self, other: Self) -> Self {
        Self { recordings: self.recordings + other.recordings, without: self.without + other.without }
    }
}

impl Store {
    /// A folder, which is made.
    ///
    /// # Errors
    /// What the system says.
    pub fn new(path: &Path) -> Result<Self, FleetError> {
        let store = Self(path.into());
        let unfinished = store.0.join(UNFINISHED);
        fs::create_dir_all(&unfinished).map_err(unwritable(&unfinished))?;
        Ok(store)
    }

    /// The folder for one run alone, until the claim is dropped.
    ///
    /// # Errors
    /// Where another run has it.
    pub fn claim(&self) -> Result<Claim, FleetError> {
        let claim = self.lock()?;
        claim.alone()?;
        Ok(claim)
    }

    /// The folder for one of several runs which make no table.
    ///
    /// # Errors
    /// Where a run has it for itself.
    pub fn share(&self) -> Result<Claim, FleetError> {
        let claim = self.lock()?;
        claim.shared()?;
        Ok(claim)
    }

    fn lock(&self) -> Result<Claim, FleetError> {
        let path = self.0.join(UNFINISHED).join("lock");
        let file = fs::OpenOptions::new().create(true).truncate(false).write(true).open(&path);
        Ok(Claim { folder: self.0.clone(), file: file.map_err(unwritable(&path))? })
    }

    /// What has a row of this robot.
    ///
    /// # Errors
    /// Where the folder or its tables can't be read.
    pub async fn known(&self, name: &str) -> Result<Known, FleetError> {
        let mut known = Known { robot: name.into(), ..Known::default() };
        if !self.tables()?.is_empty() {
            known.add(&self.0, TABLE).await?;
        }
        let folder = self.0.join(UNFINISHED);
        if self.unfinished()?.is_empty() { Ok(known) } else { known.add(&folder, ROW).await.map(|()| known) }
    }

    /// Rows that are not in a table yet, sorted.
    fn unfinished(&self) -> Result<Vec<PathBuf>, FleetError> {
        let (folder, mut rows) = (self.0.join(UNFINISHED), Vec::new());
        for entry in fs::read_dir(&folder).map_err(unreadable(&folder))? {
            let path = entry.map_err(unreadable(&folder))?.path();
            rows.extend(path.extension().is_some_and(|e| e == "row").then_some(path));
        }
        rows.sort();
        Ok(rows)
    }

    /// The tables of the folder.
    ///
    /// # Errors
    /// What the system says.
    pub fn tables(&self) -> Result<Vec<PathBuf>, FleetError> {
        let mut tables = Vec::new();
        for entry in fs::read_dir(&self.0).map_err(unreadable(&self.0))? {
            let path = entry.map_err(unreadable(&self.0))?.path();
            tables.extend(path.extension().is_some_and(|e| e == "parquet").then_some(path));
        }
        tables.sort();
        Ok(tables)
    }

    /// Factors recordings, and commits each row by itself, but for those that are known.
    ///
    /// # Errors
    /// Where a row can't be written. A recording that can't be used is a row.
    pub async fn factor(
        &self,
        fleet: &Fleet,
        table: RecordingsTable,
        known: &Known,
        mut said: impl FnMut(&str, &str),
    ) -> Result<Written, FleetError> {
        let name = &table.name.clone();
        let rows = fleet.context.read_table(std::sync::Arc::new(table))?;
        let mut stream = rows.execute_stream().await?;
        let mut written = Written::default();
        while let Some(batch) = stream.next().await {
            let batch = batch?;
            for row in 0..batch.num_rows() {
                let column = |name: &str| batch.column_by_name(name).map(|c| c.as_string::<i32>());
                let text = |name: &str| column(name).filter(|c| !c.is_null(row)).map(|c| c.value(row));
                let file = text("file").unwrap_or_default();
                written.recordings += 1;
                if let Some(why) = text("why") {
                    written.without += 1;
                    said(file, why);
                }
                let key = key(name, text("sha256"), file);
                // A second copy of a recording, under another name.
                if !known.rows.contains(&key) {
                    self.commit(&key, &batch.slice(row, 1))?;
                }
            }
        }
        Ok(written)
    }

    /// Writes a row, whole or not at all.
    fn commit(&self, key: &str, row: &RecordBatch) -> Result<(), FleetError> {
        let folder = self.0.join(UNFINISHED);
        let path = folder.join(row_name(key));
        let mut writer = writer(&folder, row)?;
        writer.write(row).map_err(refused(&path))?;
        let file = writer.into_inner().map_err(refused(&path))?;
        file.persist(&path).map_err(|e| unwritable(&path)(e.error))?;
        Ok(())
    }

    /// Makes one table of the rows that are not in one yet, in the order of days and robots.
    ///
    /// # Errors
    /// Where it can't be written; the rows are then still there.
    pub async fn finish(&self, fleet: &Fleet) -> Result<Option<PathBuf>, FleetError> {
        let folder = self.0.join(UNFINISHED);
        let (done, rows) = self.tabled().await?;
        // Of a run that was killed below.
        done.iter().try_for_each(|row| fs::remove_file(row).map_err(unwritable(row)))?;
        if rows.is_empty() {
            return Ok(None);
        }
        let names = rows.iter().filter_map(|path| path.file_name());
        let names: Vec<u8> = names.flat_map(|name| name.to_string_lossy().into_owned().into_bytes()).collect();
        let name = &hexadecimal(&Sha256::digest(names))[..16];
        let table = self.0.join(format!("factors-{name}.parquet"));
        let options = ParquetReadOptions::default().file_extension(ROW);
        let all = fleet.context.read_parquet(folder.display().to_string(), options).await?;
        let mut stream = all.sort_by(["day", "robot", "sha256", "file"].map(col).to_vec())?.execute_stream().await?;
        let mut open = None;
        while let Some(batch) = stream.next().await {
            let batch = batch?;
            let mut current = match open.take() {
                Some(current) => current,
                None => writer(&self.0, &batch)?,
            };
            current.write(&batch).map_err(refused(&table))?;
            open = Some(current);
        }
        if let Some(open) = open {
            let file = open.into_inner().map_err(refused(&table))?;
            file.persist(&table).map_err(|e| unwritable(&table)(e.error))?;
        }
        rows.iter().try_for_each(|row| fs::remove_file(row).map_err(unwritable(row)))?;
        Ok(Some(table))
    }

    /// The rows that are in a table already, and those that are not.
    async fn tabled(&self) -> Result<(Vec<PathBuf>, Vec<PathBuf>), FleetError> {
        let rows = self.unfinished()?;
        if rows.is_empty() || self.tables()?.is_empty() {
            return Ok((Vec::new(), rows));
        }
        let mut names = BTreeSet::new();
        each_row(&self.0, TABLE, |robot, sha256, file| {
            names.insert(row_name(&key(robot, sha256, file)));
        })
        .await?;
        let known = |path: &PathBuf| path.file_name().is_some_and(|name| names.contains(&*name.to_string_lossy()));
        Ok(rows.into_iter().partition(known))
    }
}

/// The recordings of a robot that have a row.
#[derive(Debug, Clone, Default)]
pub struct Known {
    robot: String,
    /// Keys of the rows.
    rows: BTreeSet<String>,
    /// Paths and URLs of the rows.
    files: BTreeSet<String>,
}

/// Name of the file of a row.
fn row_name(key: &str) -> String {
    format!("{key}{ROW}")
}

/// How a recording is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum By {
    /// By the digest of the file, which is read for that. An object of a store would have to be
    /// fetched, so it is known by its URL.
    Content,
    /// By its path or URL.
    Name,
}

impl Known {
    /// The recordings that have no row. Two copies of one recording are one recording, where their
    /// contents are read.
    pub fn missing(&self, files: Vec<RecordingFile>, by: By) -> Vec<RecordingFile> {
        let mut met = BTreeSet::new();
        let mut new = |file: &RecordingFile| match file {
            RecordingFile::Local(path) if by == By::Content => {
                let key = key(&self.robot, digest(path).as_deref(), &file.name());
                !self.rows.contains(&key) && met.insert(key)
            }
            RecordingFile::Local(_) | RecordingFile::Remote(_) => !self.files.contains(&file.name()),
        };
        files.into_iter().filter(|file| new(file)).collect()
    }

    /// Adds the robot's rows in a folder of Parquet files.
    async fn add(&mut self, folder: &Path, ending: &str) -> Result<(), FleetError> {
        each_row(folder, ending, |robot, sha256, file| {
            if robot == self.robot {
                self.rows.insert(key(robot, sha256, file));
                self.files.insert(file.into());
            }
        })
        .await
    }
}

/// Robot, digest and file of each row in a folder of Parquet files.
async fn each_row(
    folder: &Path,
    ending: &str,
    mut each: impl FnMut(&str, Option<&str>, &str),
) -> Result<(), FleetError> {
    let context = Fleet::new(1).context;
    let options = ParquetReadOptions::default().file_extension(ending);
    let rows = context.read_parquet(folder.display().to_string(), options).await?;
    let mut stream = rows.select(vec![col("robot"), col("sha256"), col("file")])?.execute_stream().await?;
    while let Some(batch) = stream.next().await {
        let batch = batch?;
        let column = |k: usize| batch.column(k).as_string::<i32>();
        for row in 0..batch.num_rows() {
            let digest = column(1);
            each(column(0).value(row), (!digest.is_null(row)).then(|| digest.value(row)), column(2).value(row));
        }
    }
    Ok(())
}

/// A Parquet file that has no name yet, for rows like these.
fn writer(folder: &Path, like: &RecordBatch) -> Result<ArrowWriter<NamedTempFile>, FleetError> {
    let file = unnamed(folder).map_err(unwritable(folder))?;
    let properties = WriterProperties::builder()
        .set_compression(Compression::SNAPPY)
        .set_dictionary_enabled(false)
        .set_max_row_group_row_count(Some(GROUP))
        .build();
    ArrowWriter::try_new(file, like.schema(), Some(properties)).map_err(refused(folder))
}

/// What a row is known by: the robot and the recording's digest, or its path where it can't be
/// read.
fn key(robot: &str, sha256: Option<&str>, file: &str) -> String {
    let recording = sha256.map_or_else(|| format!("path {file}"), String::from);
    hexadecimal(&Sha256::digest(format!("{robot}\n{recording}")))
}

fn unreadable(path: &Path) -> impl FnOnce(std::io::Error) -> FleetError + use<'_> {
    move |source| FleetError::File { path: path.into(), verb: "read", source }
}

fn unwritable(path: &Path) -> impl FnOnce(std::io::Error) -> FleetError + use<'_> {
    move |source| FleetError::File { path: path.into(), verb: "written", source }
}

fn refused(path: &Path) -> impl FnOnce(ParquetError) -> FleetError + use<'_> {
    move |error| FleetError::File { path: path.into(), verb: "written", source: std::io::Error::other(error) }
}
