//! Recordings in an object store that the session knows: listed by it, and read from a temporary
//! file, one at a time.

use std::io::Write;
use std::path::PathBuf;

use datafusion::common::Result;
use datafusion::common::error::DataFusionError;
use datafusion::datasource::listing::ListingTableUrl;
use datafusion::execution::object_store::ObjectStoreUrl;
use datafusion::execution::runtime_env::RuntimeEnv;
use futures::StreamExt;
use object_store::ObjectStoreExt;
use object_store::path::Path;
use tempfile::NamedTempFile;

use crate::open::is_recording;

/// Where recordings are.
#[derive(Debug, Clone)]
pub enum Place {
    /// These files.
    Files(Vec<PathBuf>),
    /// A file or folder.
    Folder(PathBuf),
    /// A prefix of an object store: `s3://fleet/2026-11-21/`.
    Store(ListingTableUrl),
}

impl Place {
    /// Of a path or URL.
    ///
    /// # Errors
    /// Where a URL has no meaning.
    pub fn of(text: &str) -> Result<Self> {
        if !text.contains("://") {
            return Ok(Self::Folder(text.into()));
        }
        let url = ListingTableUrl::parse(text)?;
        Ok(match text.strip_prefix("file://") {
            Some(path) => Self::Folder(path.into()),
            None => Self::Store(url),
        })
    }
}

/// One object.
#[derive(Debug, Clone)]
pub struct RemoteFile {
    store: ObjectStoreUrl,
    location: Path,
    /// Its URL.
    pub name: String,
}

/// The recordings of a prefix, sorted.
pub(crate) async fn listed(runtime: &RuntimeEnv, url: &ListingTableUrl) -> Result<Vec<RemoteFile>> {
    let store = runtime.object_store(url)?;
    let mut objects = store.list(Some(url.prefix()));
    let mut found = Vec::new();
    while let Some(object) = objects.next().await {
        let location = object.map_err(external)?.location;
        let base = url.object_store();
        let name = format!("{}{location}", base.as_str());
        if is_recording(&name) {
            found.push(RemoteFile { store: base, location, name });
        }
    }
    found.sort_by(|a, b| a.name.cmp(&b.name));
    Ok(found)
}

/// A copy of an object, until it is dropped. Memory holds a chunk of it.
pub(crate) async fn fetched(runtime: &RuntimeEnv, file: &RemoteFile) -> Result<NamedTempFile> {
    let store = runtime.object_store(&file.store)?;
    let mut local = NamedTempFile::new()?;
    let mut chunks = store.get(&file.location).await.map_err(external)?.into_stream();
    while let Some(chunk) = chunks.next().await {
        local.write_all(&chunk.map_err(external)?)?;
    }
    Ok(local)
}

fn external(error: object_store::Error) -> DataFusionError {
    DataFusionError::External(Box::new(error))
}
