//! Ctrl-C: one handler for the process. It stops a search that can be stopped early, or ends the
//! program without leaving a temporary file.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, Once, PoisonError};

static INSTALLED: Once = Once::new();
static TEMPORARIES: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());
static STOP: Mutex<Option<Arc<AtomicBool>>> = Mutex::new(None);

/// Sets `stop` at the first Ctrl-C; the second ends the program.
pub(super) fn stop_on_interrupt(stop: &Arc<AtomicBool>) {
    *STOP.lock().unwrap_or_else(PoisonError::into_inner) = Some(Arc::clone(stop));
    install();
}

/// Removes this file when Ctrl-C ends the program. If it has been renamed by then, there is nothing
/// to remove.
pub(super) fn remove_on_interrupt(path: &Path) {
    TEMPORARIES.lock().unwrap_or_else(PoisonError::into_inner).push(path.to_path_buf());
    install();
}

fn install() {
    // If no handler can be set, the first Ctrl-C ends the program.
    INSTALLED.call_once(|| drop(ctrlc::set_handler(interrupted)));
}

fn interrupted() {
    let stop = STOP.lock().unwrap_or_else(PoisonError::into_inner).clone();
    if stop.is_some_and(|stop| !stop.swap(true, Ordering::Relaxed)) {
        return;
    }
    for path in TEMPORARIES.lock().unwrap_or_else(PoisonError::into_inner).iter() {
        let _ = std::fs::remove_file(path);
    }
    std::process::exit(130);
}
