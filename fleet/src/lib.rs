//! Factors of a robot fleet's recordings, on DataFusion: a table function that reads recordings, an
//! aggregate that merges factors, functions on them, a test of drift, and one page on a fleet.
//!
//! Between machines nothing is home-made: rows are Parquet, questions are SQL. The mathematics are
//! those of `denavit`.

pub mod attribution;
pub mod calendar;
pub mod channel;
pub mod cli;
#[cfg(feature = "cluster")]
pub mod cluster;
pub mod error;
pub mod functions;
pub mod merge;
mod open;
mod output;
pub mod recordings;
pub mod reference;
mod remote;
pub mod report;
pub mod robots;
pub mod sequential;
pub mod store;
mod table;
pub mod watch;

use std::sync::Arc;

use datafusion::execution::context::SessionContext;
use datafusion::logical_expr::AggregateUDF;
use datafusion::prelude::SessionConfig;

use robots::Robots;

/// A session with the functions of a fleet.
pub struct Fleet {
    /// The engine.
    pub context: SessionContext,
    /// The robot files that were read.
    pub robots: Arc<Robots>,
    threads: usize,
}

impl Fleet {
    /// With so many partitions at once.
    pub fn new(partitions: usize) -> Self {
        let context = SessionContext::new_with_config(Self::config(partitions));
        Self::with(context, Arc::default(), partitions)
    }

    fn config(partitions: usize) -> SessionConfig {
        SessionConfig::new()
            .with_target_partitions(partitions.max(1))
            // A factor has 30 kB: a batch is some MB.
            .with_batch_size(64)
            .set_bool("datafusion.execution.parquet.schema_force_view_types", false)
    }

    /// The functions and robots in a session.
    fn with(context: SessionContext, robots: Arc<Robots>, partitions: usize) -> Self {
        // Files of samples can be named in a query, too.
        let context = context.enable_url_table();
        context.register_udtf("recordings", Arc::new(recordings::Recordings(Arc::clone(&robots))));
        context.register_udaf(AggregateUDF::from(merge::MergeFactor::default()));
        functions::all(&robots, &context.runtime_env()).into_iter().for_each(|own| context.register_udf(own));
        Self { context, robots, threads: partitions.max(1) }
    }
}
