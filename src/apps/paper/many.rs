//! The same with other noise, many times over, on all processors; the same answer whoever was
//! first.

use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use super::ReproduceError;
use super::Watch;

/// Results of `one(0)`, `one(1)`, ..., in this order.
pub fn many<T: Send>(
    runs: usize,
    one: &(dyn Fn(usize) -> Result<T, ReproduceError> + Sync),
    watch: Watch<'_>,
) -> Result<Vec<T>, ReproduceError> {
    let threads = std::thread::available_parallelism().map_or(1, usize::from).min(runs.max(1));
    let (next, done) = (AtomicUsize::new(0), AtomicUsize::new(0));
    let all: Mutex<Vec<(usize, Result<T, ReproduceError>)>> = Mutex::new(Vec::new());
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                loop {
                    let run = next.fetch_add(1, Ordering::Relaxed);
                    if run >= runs {
                        break;
                    }
                    let result = one(run);
                    let finished = done.fetch_add(1, Ordering::Relaxed) + 1;
                    watch(&format!("run {finished} of {runs}"), finished as f64 / runs as f64);
                    if let Ok(mut all) = all.lock() {
                        all.push((run, result));
                    }
                }
            });
        }
    });
    let mut all = all.into_inner().unwrap_or_default();
    all.sort_by_key(|(run, _)| *run);
    all.into_iter().map(|(_, result)| result).collect()
}
