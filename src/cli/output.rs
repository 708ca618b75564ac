//! Outputs of all verbs: a file is complete or absent, however the process ends.
//!
//! A file is written without a name in its destination folder, synced, then linked to its name. If
//! the file system does not support files without names, a temporary file with a unique name is
//! used.

use std::fs::{self, File, Metadata};
use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::{Component, Path, PathBuf};

use tempfile::TempPath;

use super::Failure;
use super::interrupt;

/// Longest chain of symbolic links, as in Linux.
const MOST_LINKS: usize = 40;

/// Target of a path.
enum Target {
    /// Standard output, under any of its names.
    Stdout,
    /// A pipe, a device or an open descriptor, which has no name to replace.
    Stream(PathBuf),
    /// A plain file, links followed, with the metadata of the present one.
    File { folder: PathBuf, path: PathBuf, present: Option<Metadata> },
}

/// An output being written; it appears with [`Output::finish`], or not at all.
pub(super) struct Output {
    shown: String,
    writer: BufWriter<File>,
    place: Place,
}

enum Place {
    /// Written to directly.
    Direct,
    /// A file without a name.
    #[cfg_attr(not(target_os = "linux"), allow(dead_code))]
    Unnamed { folder: PathBuf, path: PathBuf, present: Option<Metadata> },
    /// A temporary file beside the target.
    Named { beside: TempPath, folder: PathBuf, path: PathBuf, present: Option<Metadata> },
}

impl Output {
    /// Opens the target of `path`. An existing plain file is unchanged until [`Output::finish`].
    pub(super) fn create(path: &Path) -> Result<Self, Failure> {
        let shown = path.display().to_string();
        let (file, place) = Self::open(path).map_err(|e| unwritable(&shown, &e))?;
        Ok(Self { shown, writer: BufWriter::with_capacity(1 << 16, file), place })
    }

    fn open(path: &Path) -> io::Result<(File, Place)> {
        let (folder, path, present) = match resolve(path)? {
            Target::Stdout => return Ok((stdout()?, Place::Direct)),
            Target::Stream(path) => {
                // A plain file behind a descriptor belongs to whoever opened it: its content is
                // kept.
                let append = fs::metadata(&path)?.is_file();
                let mut options = File::options();
                return Ok((options.write(!append).append(append).open(&path)?, Place::Direct));
            }
            Target::File { folder, path, present } => (folder, path, present),
        };
        refuse_read_only(&folder, &path, present.as_ref())?;
        #[cfg(target_os = "linux")]
        if let Ok(file) = unnamed(&folder) {
            return Ok((file, Place::Unnamed { folder, path, present }));
        }
        let named = temporary_names(&path, present.is_none()).tempfile_in(&folder)?;
        let (file, beside) = named.into_parts();
        interrupt::remove_on_interrupt(&beside);
        Ok((file, Place::Named { beside, folder, path, present }))
    }

    /// Replaces the previous file, with its mode, and its owner if permitted.
    pub(super) fn finish(self) -> Result<(), Failure> {
        let shown = self.shown;
        Self::commit(self.writer, self.place).map_err(|e| unwritable(&shown, &e))
    }

    fn commit(writer: BufWriter<File>, place: Place) -> io::Result<()> {
        let file = writer.into_inner().map_err(io::IntoInnerError::into_error)?;
        let folder = match place {
            Place::Direct => return Ok(()),
            Place::Named { beside, folder, path, present } => {
                keep(&file, present.as_ref())?;
                file.sync_all()?;
                beside.persist(&path).map_err(|e| e.error)?;
                folder
            }
            #[cfg(target_os = "linux")]
            Place::Unnamed { folder, path, present } => {
                keep(&file, present.as_ref())?;
                file.sync_all()?;
                link(&file, &folder, &path)?;
                folder
            }
            #[cfg(not(target_os = "linux"))]
            Place::Unnamed { folder, .. } => folder,
        };
        // The name reaches the disk when the folder is synced; some file systems can't sync one.
        let _ = File::open(folder).and_then(|folder| folder.sync_all());
        Ok(())
    }

    /// Failure to write to this output.
    pub(super) fn failed(&self, error: &io::Error) -> Failure {
        unwritable(&self.shown, error)
    }
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.writer.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.writer.flush()
    }
}

/// Unique names beside a target. A new file has the permissions of `umask`; otherwise it is private
/// until the mode is copied.
fn temporary_names(path: &Path, new: bool) -> tempfile::Builder<'static, 'static> {
    let mut builder = tempfile::Builder::new();
    #[cfg(unix)]
    if new {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    let _ = (path, new);
    builder.prefix(".denavit-").suffix(".tmp");
    builder
}

/// A file without a name in `folder`; it disappears with the process unless it is linked.
#[cfg(target_os = "linux")]
fn unnamed(folder: &Path) -> io::Result<File> {
    use rustix::fs::{Mode, OFlags};
    // Linking needs /proc; without it the file could never get a name.
    fs::metadata("/proc/self/fd")?;
    let flags = OFlags::TMPFILE | OFlags::WRONLY | OFlags::CLOEXEC;
    Ok(File::from(rustix::fs::open(folder, flags, Mode::from_raw_mode(0o666))?))
}

/// Links a file without a name to a name, replacing an existing file.
#[cfg(target_os = "linux")]
fn link(file: &File, folder: &Path, path: &Path) -> io::Result<()> {
    use std::os::fd::AsRawFd;
    let source = format!("/proc/self/fd/{}", file.as_raw_fd());
    let name = |path: &Path| -> io::Result<()> {
        use rustix::fs::{AtFlags, CWD};
        Ok(rustix::fs::linkat(CWD, &source, CWD, path, AtFlags::SYMLINK_FOLLOW)?)
    };
    match name(path) {
        Err(e) if e.kind() == ErrorKind::AlreadyExists => {
            let beside = temporary_names(path, false).make_in(folder, name)?;
            beside.into_temp_path().persist(path).map_err(|e| e.error)
        }
        done => done,
    }
}

/// Copies mode and owner of the previous file.
fn keep(file: &File, present: Option<&Metadata>) -> io::Result<()> {
    let Some(present) = present else { return Ok(()) };
    #[cfg(unix)]
    {
        use std::os::unix::fs::{MetadataExt, fchown};
        let new = file.metadata()?;
        // Only root may give a file away; a group that is not the writer's can't be kept either.
        if (new.uid(), new.gid()) != (present.uid(), present.gid()) {
            let _ = fchown(file, Some(present.uid()), Some(present.gid()));
        }
    }
    file.set_permissions(present.permissions())
}

/// Follows symbolic links, also to a file that does not exist yet.
fn resolve(path: &Path) -> io::Result<Target> {
    let mut path = path.to_path_buf();
    for _ in 0..MOST_LINKS {
        if path == Path::new("-") {
            return Ok(Target::Stdout);
        }
        let Some(Component::Normal(name)) = path.components().next_back() else {
            return Err(ErrorKind::IsADirectory.into());
        };
        if path.as_os_str().to_string_lossy().ends_with('/') {
            return Err(ErrorKind::IsADirectory.into());
        }
        let folder = path.parent().filter(|f| !f.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let folder = fs::canonicalize(folder).map_err(|e| missing_folder(folder, e))?;
        let whole = folder.join(name);
        if folder.starts_with("/proc") && folder.ends_with("fd") {
            let own = fs::canonicalize("/proc/self/fd").is_ok_and(|own| own == folder);
            return Ok(if own && name == "1" { Target::Stdout } else { Target::Stream(whole) });
        }
        let meta = match fs::symlink_metadata(&whole) {
            Err(e) if e.kind() == ErrorKind::NotFound => {
                return Ok(Target::File { folder, path: whole, present: None });
            }
            meta => meta?,
        };
        if meta.is_symlink() {
            path = folder.join(fs::read_link(&whole)?);
        } else if meta.is_dir() {
            return Err(ErrorKind::IsADirectory.into());
        } else if meta.is_file() {
            return Ok(Target::File { folder, path: whole, present: Some(meta) });
        } else {
            return Ok(Target::Stream(whole));
        }
    }
    Err(io::Error::other(format!("more than {MOST_LINKS} symbolic links, one after the other")))
}

fn missing_folder(folder: &Path, error: io::Error) -> io::Error {
    if error.kind() != ErrorKind::NotFound {
        return error;
    }
    let shown = folder.display();
    io::Error::new(ErrorKind::NotFound, format!("there is no folder {shown}; create it, or correct the path"))
}

/// Refuses files and folders that are read-only, even where the superuser could write.
fn refuse_read_only(folder: &Path, path: &Path, present: Option<&Metadata>) -> io::Result<()> {
    let refused = |what: &str| Err(io::Error::new(ErrorKind::PermissionDenied, what.to_string()));
    if let Some(present) = present {
        if present.permissions().readonly() {
            return refused("the file there is read-only; make it writable (chmod u+w), or choose another name");
        }
        // Checks the permission of this user without changing the file.
        File::options().write(true).open(path)?;
    }
    let shown = folder.display();
    if fs::metadata(folder)?.permissions().readonly() {
        return refused(&format!("the folder {shown} is read-only; make it writable (chmod u+w), or choose another"));
    }
    #[cfg(unix)]
    if let Err(e) = rustix::fs::access(folder, rustix::fs::Access::WRITE_OK | rustix::fs::Access::EXEC_OK) {
        let e = io::Error::from(e);
        return refused(&format!("the folder {shown} is not writable ({e}); choose another"));
    }
    Ok(())
}

/// Standard output by its descriptor, so that all writers share one position.
fn stdout() -> io::Result<File> {
    let mut stdout = io::stdout().lock();
    stdout.flush()?;
    #[cfg(unix)]
    {
        use std::os::fd::AsFd;
        Ok(File::from(stdout.as_fd().try_clone_to_owned()?))
    }
    #[cfg(not(unix))]
    {
        use std::os::windows::io::AsHandle;
        Ok(File::from(stdout.as_handle().try_clone_to_owned()?))
    }
}

/// Failure for an output that can't be written, with advice.
pub(super) fn unwritable(shown: &str, error: &io::Error) -> Failure {
    let advice = match error.kind() {
        ErrorKind::IsADirectory => "; name a file in this folder",
        ErrorKind::StorageFull => "; make room, or write elsewhere",
        ErrorKind::BrokenPipe => "; its reader closed it before everything was written",
        _ => "",
    };
    Failure::other(format!("{shown} can't be written: {error}{advice}"))
}

/// Whether this is standard output under any of its names, so that nothing else may go there.
pub(super) fn is_stdout(path: &Path) -> bool {
    matches!(resolve(path), Ok(Target::Stdout))
}

/// Identity of a file: two paths that lead to the same file have the same one.
#[derive(PartialEq)]
enum Identity {
    Inode(u64, u64),
    Path(PathBuf),
}

impl Identity {
    #[cfg(unix)]
    fn of_metadata(meta: &Metadata, _path: &Path) -> Self {
        use std::os::unix::fs::MetadataExt;
        Self::Inode(meta.dev(), meta.ino())
    }

    #[cfg(not(unix))]
    fn of_metadata(_meta: &Metadata, path: &Path) -> Self {
        Self::Path(fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf()))
    }

    fn of_input(path: &Path) -> Option<Self> {
        fs::metadata(path).ok().filter(Metadata::is_file).map(|meta| Self::of_metadata(&meta, path))
    }
}

/// Checks the outputs before work begins: every output has its folder and is writable, no two are
/// the same file, and none is an input. Outputs are given with the option that names them.
pub(super) fn check_outputs<'a>(
    outputs: &[(&str, &Option<PathBuf>)],
    inputs: impl IntoIterator<Item = &'a PathBuf>,
) -> Result<(), Failure> {
    let read: Vec<(Identity, &Path)> = inputs
        .into_iter()
        .filter(|p| p.as_os_str() != "-")
        .filter_map(|p| Some((Identity::of_input(p)?, p.as_path())))
        .collect();
    let mut seen: Vec<(Identity, &str)> = Vec::new();
    for (option, path) in outputs.iter().filter_map(|(option, path)| Some((*option, path.as_ref()?))) {
        let shown = path.display().to_string();
        let target = resolve(path).map_err(|e| unwritable(&shown, &e))?;
        let identity = match &target {
            Target::Stdout => match stdout().and_then(|out| out.metadata()) {
                Ok(meta) if meta.is_file() => Identity::of_metadata(&meta, path),
                _ => Identity::Path("-".into()),
            },
            Target::Stream(path) => {
                let meta = fs::metadata(path).map_err(|e| unwritable(&shown, &e))?;
                if is_character_device(&meta) {
                    continue;
                }
                Identity::of_metadata(&meta, path)
            }
            Target::File { folder, path, present } => {
                refuse_read_only(folder, path, present.as_ref()).map_err(|e| unwritable(&shown, &e))?;
                match present {
                    Some(meta) => Identity::of_metadata(meta, path),
                    None => Identity::Path(path.clone()),
                }
            }
        };
        if let Some((_, input)) = read.iter().find(|(other, _)| *other == identity) {
            return Err(Failure::input(format!(
                "{option} {shown}: this is {}, which is read by this command; choose another name",
                input.display()
            )));
        }
        if let Some((_, other)) = seen.iter().find(|(other, _)| *other == identity) {
            return Err(Failure::input(format!(
                "{option} {shown}: {other} leads to the same place; give each output its own"
            )));
        }
        seen.push((identity, option));
    }
    Ok(())
}

#[cfg(unix)]
fn is_character_device(meta: &Metadata) -> bool {
    use std::os::unix::fs::FileTypeExt;
    meta.file_type().is_char_device()
}

#[cfg(not(unix))]
fn is_character_device(_meta: &Metadata) -> bool {
    false
}
