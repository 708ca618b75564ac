//! Runs independent tasks on several threads, with results in order.
//!
//! Uses threads of the standard library: tasks are few and large, a nested task has its share of
//! the threads, and the order of all sums is the caller's. A work-stealing pool would only add
//! dependencies.

use std::cell::Cell;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

thread_local! {
    /// Number of threads available to tasks of this thread; `None`: all of the process.
    static SHARE: Cell<Option<usize>> = const { Cell::new(None) };
}

/// Number of threads that this process may use; inside a task its share of them.
pub(crate) fn threads() -> usize {
    SHARE.get().unwrap_or_else(|| std::thread::available_parallelism().map_or(1, usize::from))
}

/// Count of numbers below which a pass over them takes less time than the start of a thread.
const FEW: usize = 10_000;

/// Count of numbers above which memory is the limit: each thread has its own allocations.
const MANY: usize = 120_000;

/// Number of threads for a pass over `numbers` numbers.
pub(crate) fn threads_for(numbers: usize) -> usize {
    if (FEW..=MANY).contains(&numbers) { threads() } else { 1 }
}

/// Calls `work` with `0..count` on several threads. Results are in order, whatever the number of
/// threads.
pub(crate) fn parallel<T: Send>(threads: usize, count: usize, work: impl Fn(usize) -> T + Sync) -> Vec<T> {
    if threads <= 1 || count <= 1 {
        return (0..count).map(work).collect();
    }
    let used = threads.min(count);
    let share = (self::threads() / used).max(1);
    let next = AtomicUsize::new(0);
    let done: Mutex<Vec<(usize, T)>> = Mutex::new(Vec::new());
    std::thread::scope(|scope| {
        for _ in 0..used {
            scope.spawn(|| {
                SHARE.set(Some(share));
                loop {
                    let k = next.fetch_add(1, Ordering::Relaxed);
                    if k >= count {
                        return;
                    }
                    let result = work(k);
                    if let Ok(mut done) = done.lock() {
                        done.push((k, result));
                    }
                }
            });
        }
    });
    let mut done = done.into_inner().unwrap_or_default();
    done.sort_by_key(|d| d.0);
    done.into_iter().map(|d| d.1).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_are_in_order_for_any_number_of_threads() {
        for threads in [1, 2, 7, 100] {
            for count in [0, 1, 5, 64] {
                let found = parallel(threads, count, |k| {
                    if k % 3 == 0 {
                        std::thread::yield_now();
                    }
                    k * k
                });
                assert_eq!(found, (0..count).map(|k| k * k).collect::<Vec<_>>());
            }
        }
    }

    /// Two concurrent tasks have half of the threads each, and all are available afterwards.
    #[test]
    fn work_inside_work_shares_the_threads() {
        let all = threads();
        let inside = parallel(2, 2, |_| threads());
        assert_eq!(inside, [(all / 2).max(1); 2]);
        assert_eq!(threads(), all);
    }
}
