//! Reads and prepares a log in parallel with its processing, each on its own thread.
//!
//! Threads of the standard library and bounded queues suffice for three steps in a row. Rows and
//! motions keep the order of the log, so results are bit-identical to those of one thread.

use std::panic::resume_unwind;
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::thread;

use super::{Motion, Prepare, PrepareError, Prepared};
use crate::data::log::{Block, Layout, LogError, Source};
use crate::data::signal::prepare::{ROWS, motions};
use crate::numerics::parallel::threads;

/// Blocks, or motions, queued between two steps: enough to smooth out delays, few enough to bound
/// memory.
const WAITING: usize = 2;

/// Reads a log to its end and passes each [`Motion`] to `sink`, in the order of the log.
///
/// # Errors
/// If the log can't be read, or can't be prepared with these settings.
pub fn each_motion(
    source: &mut dyn Source,
    dof: usize,
    prepare: &Prepare,
    sink: impl FnMut(&Motion),
) -> Result<Prepared, PrepareError> {
    if threads() == 1 {
        each_motion_in_turn(source, dof, prepare, sink)
    } else {
        overlapped(source, dof, prepare, sink)
    }
}

/// Does the same on the caller's thread alone, for many logs read at once.
///
/// # Errors
/// Like [`each_motion`].
pub fn each_motion_in_turn(
    source: &mut dyn Source,
    dof: usize,
    prepare: &Prepare,
    mut sink: impl FnMut(&Motion),
) -> Result<Prepared, PrepareError> {
    motions(source, dof, prepare, |motion| sink(&motion))
}

fn overlapped(
    source: &mut dyn Source,
    dof: usize,
    prepare: &Prepare,
    mut sink: impl FnMut(&Motion),
) -> Result<Prepared, PrepareError> {
    let layout = source.layout().clone();
    thread::scope(|scope| {
        let (to_preparer, full) = sync_channel(WAITING);
        let (to_reader, emptied) = sync_channel(WAITING + 1);
        let (to_sink, ready) = sync_channel(WAITING);
        scope.spawn(move || read(source, &to_preparer, &emptied));
        let preparer = scope.spawn(move || {
            let mut ahead = ReadAhead { layout, full, to_reader };
            // The receiver of motions is gone only if the sink has panicked.
            motions(&mut ahead, dof, prepare, |motion| drop(to_sink.send(motion)))
        });
        ready.iter().for_each(|motion| sink(&motion));
        preparer.join().unwrap_or_else(|panic| resume_unwind(panic))
    })
}

/// Reads blocks until the log ends, an error occurs, or the receiver is gone.
fn read(source: &mut dyn Source, to_preparer: &SyncSender<Result<Block, LogError>>, emptied: &Receiver<Block>) {
    loop {
        let mut block = emptied.try_recv().unwrap_or_default();
        let read = source.next_block(ROWS, &mut block).map(|()| block);
        let last = read.as_ref().map_or(true, Block::is_empty);
        if to_preparer.send(read).is_err() || last {
            return;
        }
    }
}

/// A log whose next blocks are read on another thread.
struct ReadAhead {
    layout: Layout,
    full: Receiver<Result<Block, LogError>>,
    /// Returns blocks to the reader, so that their memory is reused.
    to_reader: SyncSender<Block>,
}

impl Source for ReadAhead {
    fn layout(&self) -> &Layout {
        &self.layout
    }

    /// Takes the next block; the reader determines its number of rows.
    fn next_block(&mut self, _rows: usize, block: &mut Block) -> Result<(), LogError> {
        // A reader that has finished sent an error or an empty block before.
        let next = self.full.recv().unwrap_or_else(|_| Ok(Block::default()))?;
        drop(self.to_reader.try_send(std::mem::replace(block, next)));
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::data::log::open;

    /// A sampled motion of one joint, 5000 rows at 500 Hz, with a rest and, if `bad`, a non-numeric
    /// cell.
    fn log(bad: bool) -> String {
        let mut text = String::from("t,q1,tau1\n");
        for k in 0..5000 {
            let t = 0.002 * f64::from(k);
            let tau = if bad && k == 4000 { "none".into() } else { format!("{}", 2.0 * (1.3 * t).cos()) };
            text += &format!("{t},{},{tau}\n", (2.0 * t).sin());
        }
        text
    }

    fn both(text: &str) -> [(Result<Prepared, PrepareError>, Vec<Motion>); 2] {
        let mut source = open("log.csv", text.as_bytes()).unwrap();
        let mut alone = Vec::new();
        let first = each_motion_in_turn(&mut *source, 1, &Prepare::default(), |motion| alone.push(motion.clone()));
        let mut source = open("log.csv", text.as_bytes()).unwrap();
        let mut beside = Vec::new();
        let second = overlapped(&mut *source, 1, &Prepare::default(), |motion| beside.push(motion.clone()));
        [(first, alone), (second, beside)]
    }

    #[test]
    fn motions_are_the_same_on_one_thread_and_on_three() {
        let [(first, alone), (second, beside)] = both(&log(false));
        assert_eq!(first.unwrap(), second.unwrap());
        assert!(!alone.is_empty() && alone == beside);
    }

    #[test]
    fn an_error_is_the_same_on_one_thread_and_on_three() {
        let [(first, alone), (second, beside)] = both(&log(true));
        assert_eq!(first.unwrap_err().to_string(), second.unwrap_err().to_string());
        assert_eq!(alone, beside);
    }
}
