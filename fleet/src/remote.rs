//! Recordings in folders and object stores. Those of a store are listed by it, and read from a
//! temporary file, one at a time.

use std::io::Write;
use std::path::PathBuf;
use std::sync::Arc;

use datafusion::common::error::DataFusionError;
use datafusion::common::{Result, plan_err};
use datafusion::datasource::listing::ListingTableUrl;
use datafusion::execution::runtime_env::RuntimeEnv;
use futures::StreamExt;
use object_store::path::Path;
use object_store::{ObjectStore, ObjectStoreExt};
use serde::{Deserialize, Serialize};
use tempfile::NamedTempFile;

use crate::error::FleetError;
use crate::open::{is_recording, recordings_below};

/// Where recordings are.
#[derive(Debug, Clone)]
pub enum Place {
    /// These files.
    Files(Vec<RecordingFile>),
    /// A file or folder.
    Folder(PathBuf),
    /// A prefix or an object of an object store: `s3://fleet/2026-11-21/`.
    Store(ListingTableUrl),
}

/// Where one recording is.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub enum RecordingFile {
    /// In a file.
    Local(PathBuf),
    /// In an object store.
    Remote(RemoteFile),
}

/// One object.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct RemoteFile {
    /// Place in the store.
    location: String,
    /// Its URL.
    pub name: String,
}

/// Whether a name is a URL, and no path.
pub fn is_url(text: &str) -> bool {
    text.contains("://")
}

impl Place {
    /// Of a path or URL.
    ///
    /// # Errors
    /// Where a URL has no meaning.
    pub fn of(text: &str) -> Result<Self> {
        if !is_url(text) {
            return Ok(Self::Folder(text.into()));
        }
        let url = ListingTableUrl::parse(text)?;
        if url.scheme() != "file" {
            return Ok(Self::Store(url));
        }
        match url.get_url().to_file_path() {
            Ok(path) => Ok(Self::Folder(path)),
            Err(()) => plan_err!("{text}: a path on this machine follows file://"),
        }
    }

    /// The recordings there, sorted.
    pub(crate) async fn recordings(&self, runtime: &RuntimeEnv) -> Result<Vec<RecordingFile>> {
        match self {
            Self::Files(files) => Ok(files.clone()),
            Self::Folder(path) => {
                let unreadable = |source| FleetError::File { path: path.clone(), verb: "read", source };
                let files = recordings_below(path).map_err(unreadable)?;
                Ok(files.into_iter().map(RecordingFile::Local).collect())
            }
            Self::Store(url) => Ok(listed(runtime, url).await?.into_iter().map(RecordingFile::Remote).collect()),
        }
    }
}

impl RecordingFile {
    /// Path or URL.
    pub fn name(&self) -> String {
        match self {
            Self::Local(path) => path.display().to_string(),
            Self::Remote(remote) => remote.name.clone(),
        }
    }
}

/// A file of this machine: the recording's own, or a copy that ends with this.
pub(crate) enum LocalFile {
    Own(PathBuf),
    Copy(NamedTempFile),
}

impl LocalFile {
    pub(crate) fn path(&self) -> &std::path::Path {
        match self {
            Self::Own(path) => path,
            Self::Copy(file) => file.path(),
        }
    }
}

/// The recording of a path or URL, in a file. For callers that do not await: within a runtime.
pub(crate) fn local(runtime: &RuntimeEnv, name: &str) -> Result<LocalFile> {
    let url = match Place::of(name)? {
        Place::Folder(path) => return Ok(LocalFile::Own(path)),
        Place::Store(url) => url,
        Place::Files(_) => return plan_err!("{name}: no recording"),
    };
    let handle = tokio::runtime::Handle::current();
    let fetching = || handle.block_on(fetched(runtime, &object(&url)));
    let waited = std::thread::scope(|scope| scope.spawn(fetching).join());
    waited.unwrap_or_else(|panic| std::panic::resume_unwind(panic)).map(LocalFile::Copy)
}

/// The object that a URL names.
fn object(url: &ListingTableUrl) -> RemoteFile {
    RemoteFile { location: url.prefix().to_string(), name: url.as_str().into() }
}

/// The recordings of a prefix, sorted; or the one object that a URL names, which needs no listing.
async fn listed(runtime: &RuntimeEnv, url: &ListingTableUrl) -> Result<Vec<RemoteFile>> {
    if !url.as_str().ends_with('/') && is_recording(url.as_str()) {
        return Ok(vec![object(url)]);
    }
    let store = store(runtime, url)?;
    let mut objects = store.list(Some(url.prefix()));
    let mut found = Vec::new();
    while let Some(object) = objects.next().await {
        let location = object.map_err(external)?.location;
        let name = format!("{}{location}", url.object_store().as_str());
        if is_recording(&name) {
            found.push(RemoteFile { location: location.into(), name });
        }
    }
    found.sort_by(|a, b| a.name.cmp(&b.name));
    Ok(found)
}

/// A copy of an object, until it is dropped. Memory holds a chunk of it.
pub(crate) async fn fetched(runtime: &RuntimeEnv, file: &RemoteFile) -> Result<NamedTempFile> {
    let store = store(runtime, &ListingTableUrl::parse(&file.name)?)?;
    let location = Path::parse(&file.location).map_err(|e| external(e.into()))?;
    let mut local = NamedTempFile::new()?;
    let mut chunks = store.get(&location).await.map_err(external)?.into_stream();
    while let Some(chunk) = chunks.next().await {
        local.write_all(&chunk.map_err(external)?)?;
    }
    Ok(local)
}

/// The store of a URL: one that the session knows, or else one made of the environment's
/// credentials.
pub(crate) fn store(runtime: &RuntimeEnv, url: &ListingTableUrl) -> Result<Arc<dyn ObjectStore>> {
    let base = url.object_store();
    if let Ok(known) = runtime.object_store(&base) {
        return Ok(known);
    }
    let made = made(url)?;
    runtime.register_object_store(base.as_ref(), Arc::clone(&made));
    Ok(made)
}

/// As the tools of each store do it: `AWS_ACCESS_KEY_ID`, `AWS_REGION`, `AWS_ENDPOINT` and so on, or
/// the role of the machine.
#[cfg(feature = "cloud")]
fn made(url: &ListingTableUrl) -> Result<Arc<dyn ObjectStore>> {
    use object_store::ClientOptions;
    use object_store::aws::AmazonS3Builder;
    use object_store::http::HttpBuilder;
    match url.scheme() {
        "s3" | "s3a" => {
            let built = AmazonS3Builder::from_env().with_url(url.as_str()).build();
            Ok(Arc::new(built.map_err(external)?))
        }
        "http" | "https" => {
            let options = ClientOptions::new().with_allow_http(true);
            let base = url.object_store();
            let built = HttpBuilder::new().with_url(base.as_str()).with_client_options(options).build();
            Ok(Arc::new(built.map_err(external)?))
        }
        other => plan_err!("{}: no store is known for {other}://; s3, http, https and file are", url.as_str()),
    }
}

#[cfg(not(feature = "cloud"))]
fn made(url: &ListingTableUrl) -> Result<Arc<dyn ObjectStore>> {
    plan_err!("{}: this program was built without the feature `cloud`", url.as_str())
}

fn external(error: object_store::Error) -> DataFusionError {
    DataFusionError::External(Box::new(error))
}
