//! Repetition of an experiment with other noise on all processors; the result does not depend on
//! their order.

use std::sync::atomic::{AtomicUsize, Ordering};

use super::ReproduceError;
use super::Watch;
use crate::numerics::parallel::{parallel, threads};

/// Results of `one(0)`, `one(1)`, ..., in this order.
pub fn many<T: Send>(
    runs: usize,
    one: &(dyn Fn(usize) -> Result<T, ReproduceError> + Sync),
    watch: Watch<'_>,
) -> Result<Vec<T>, ReproduceError> {
    let done = AtomicUsize::new(0);
    let all = parallel(threads(), runs, |run| {
        let result = one(run);
        let finished = done.fetch_add(1, Ordering::Relaxed) + 1;
        watch(&format!("run {finished} of {runs}"), finished as f64 / runs as f64);
        result
    });
    all.into_iter().collect()
}
