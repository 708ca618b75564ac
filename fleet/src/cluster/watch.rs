//! The watch of a fleet by workers: each watches some robots, whole, and sends what it found.

use std::path::PathBuf;
use std::sync::Arc;

use async_trait::async_trait;
use datafusion::arrow::array::{AsArray, BinaryArray, RecordBatch};
use datafusion::arrow::datatypes::{DataType, Field, Schema, SchemaRef};
use datafusion::catalog::{Session, TableProvider};
use datafusion::common::tree_node::TreeNodeRecursion;
use datafusion::common::{Result, exec_datafusion_err};
use datafusion::datasource::TableType;
use datafusion::execution::{SendableRecordBatchStream, TaskContext};
use datafusion::logical_expr::Expr;
use datafusion::physical_expr::{EquivalenceProperties, PhysicalExpr};
use datafusion::physical_plan::execution_plan::{Boundedness, EmissionType};
use datafusion::physical_plan::stream::RecordBatchReceiverStreamBuilder;
use datafusion::physical_plan::{
    DisplayAs, DisplayFormatType, ExecutionPlan, Partitioning, PlanProperties, ReplaceChildrenOptions,
};
use serde::{Deserialize, Serialize};

use super::Workers;
use crate::Fleet;
use crate::error::FleetError;
use crate::output::say;
use crate::recordings::DoneForOthers;
use crate::remote::is_url;
use crate::robots::RobotFile;
use crate::sequential::Sequential;
use crate::watch::Watched;

/// Which robots are watched, and how.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct WatchParts {
    /// The table of factors.
    pub table: String,
    /// Robot files.
    pub files: Vec<RobotFile>,
    /// Names of robots, sorted.
    pub robots: Vec<String>,
    /// First day.
    pub from: Option<i32>,
    /// The test.
    pub settings: Sequential,
    /// Whether flagged robot-days are diagnosed. Paths of recordings start from this folder.
    pub diagnose: Option<PathBuf>,
}

/// The leaf.
#[derive(Debug)]
pub(super) struct WatchExec {
    parts: Arc<WatchParts>,
    properties: Arc<PlanProperties>,
}

impl WatchExec {
    pub fn new(parts: WatchParts, partitions: usize) -> Self {
        let schema = Arc::new(Schema::new(vec![Field::new("watched", DataType::Binary, false)]));
        let properties = PlanProperties::new(
            EquivalenceProperties::new(schema),
            Partitioning::UnknownPartitioning(partitions),
            EmissionType::Final,
            Boundedness::Bounded,
        );
        Self { parts: Arc::new(parts), properties: Arc::new(properties) }
    }

    pub fn parts(&self) -> &WatchParts {
        &self.parts
    }
}

impl WatchParts {
    /// What is found of these robots.
    async fn watched(&self) -> Result<Watched, FleetError> {
        let threads = std::thread::available_parallelism().map_or(1, usize::from);
        let fleet = Fleet::new(threads);
        for file in &self.files {
            fleet.robots.given(file.clone())?;
        }
        fleet.factors(&self.table).await?;
        fleet.only(&self.robots).await?;
        if let Some(day) = self.from {
            fleet.from(day).await?;
        }
        let mut watched = fleet.watch(&self.settings).await?;
        if let Some(base) = &self.diagnose {
            fleet.diagnose(&mut watched, base)?;
        }
        Ok(watched)
    }
}

impl DisplayAs for WatchExec {
    fn fmt_as(&self, _: DisplayFormatType, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "WatchExec: {} robots", self.parts.robots.len())
    }
}

impl ExecutionPlan for WatchExec {
    fn name(&self) -> &'static str {
        "WatchExec"
    }

    fn properties(&self) -> &Arc<PlanProperties> {
        &self.properties
    }

    fn children(&self) -> Vec<&Arc<dyn ExecutionPlan>> {
        Vec::new()
    }

    fn apply_expressions(
        &self,
        _: &mut dyn FnMut(&Arc<dyn PhysicalExpr>) -> Result<TreeNodeRecursion>,
    ) -> Result<TreeNodeRecursion> {
        Ok(TreeNodeRecursion::Continue)
    }

    fn replace_children(
        self: Arc<Self>,
        _: Vec<Arc<dyn ExecutionPlan>>,
        _: ReplaceChildrenOptions,
    ) -> Result<Arc<dyn ExecutionPlan>> {
        Ok(self)
    }

    fn with_new_children(self: Arc<Self>, _: Vec<Arc<dyn ExecutionPlan>>) -> Result<Arc<dyn ExecutionPlan>> {
        Ok(self)
    }

    fn execute(&self, partition: usize, context: Arc<TaskContext>) -> Result<SendableRecordBatchStream> {
        let schema = Arc::clone(self.properties.equivalence_properties().schema());
        let mut stream = RecordBatchReceiverStreamBuilder::new(Arc::clone(&schema), 1);
        let (send, parts) = (stream.tx(), Arc::clone(&self.parts));
        let runtime = tokio::runtime::Handle::current();
        let others = context.session_config().get_extension::<DoneForOthers>();
        stream.spawn_blocking(move || {
            if parts.robots.is_empty() || partition > 0 {
                return Ok(());
            }
            let watched = runtime.block_on(parts.watched())?;
            if let Some(others) = others {
                others.say(parts.robots.len(), "robots watched");
            }
            let bytes = postcard::to_stdvec(&watched).map_err(|e| exec_datafusion_err!("can't be sent: {e}"))?;
            let row = BinaryArray::from_iter_values([bytes]);
            // Nobody waits for the row of a query that has ended.
            let _ = send.blocking_send(Ok(RecordBatch::try_new(schema, vec![Arc::new(row)])?));
            Ok(())
        });
        Ok(stream.build())
    }
}

/// The leaf's table.
#[derive(Debug)]
struct WatchTable(WatchParts);

#[async_trait]
impl TableProvider for WatchTable {
    fn schema(&self) -> SchemaRef {
        WatchExec::new(self.0.clone(), 1).schema()
    }

    fn table_type(&self) -> TableType {
        TableType::Base
    }

    async fn scan(
        &self,
        _: &dyn Session,
        _: Option<&Vec<usize>>,
        _: &[Expr],
        _: Option<usize>,
    ) -> Result<Arc<dyn ExecutionPlan>> {
        // One partition would be kept at home.
        Ok(Arc::new(WatchExec::new(self.0.clone(), 2)))
    }
}

impl Fleet {
    /// The same as [`Fleet::watch`], each robot by one of these workers, to which the table and,
    /// for a diagnosis, the recordings are known by the same paths or URLs. If a worker dies, the
    /// others do it again.
    ///
    /// # Errors
    /// As [`Fleet::watch`]; where no worker is left.
    pub async fn watch_by(
        &self,
        workers: &Workers,
        table: &str,
        from: Option<i32>,
        settings: &Sequential,
        diagnose: bool,
    ) -> Result<Watched, FleetError> {
        let base =
            std::env::current_dir().map_err(|source| FleetError::File { path: ".".into(), verb: "read", source })?;
        let table = if is_url(table) { table.into() } else { base.join(table).display().to_string() };
        let (files, robots) = (self.robots.files(), self.names().await?);
        let parts = WatchParts { table, files, robots, from, settings: *settings, diagnose: diagnose.then_some(base) };
        let mut asked = workers.clone();
        loop {
            let (present, absent) = asked.present().await?;
            absent.iter().for_each(|why| say(why));
            let fleet = Self::on(&present, 1);
            let rows = fleet.context.read_table(Arc::new(WatchTable(parts.clone())))?.collect().await;
            match rows {
                Ok(rows) => {
                    let mut all = Watched { days_between: settings.days_between, ..Watched::default() };
                    for batch in rows {
                        for bytes in batch.column(0).as_binary::<i32>().iter().flatten() {
                            let share = postcard::from_bytes(bytes)
                                .map_err(|e| exec_datafusion_err!("a worker's answer is of another version: {e}"))?;
                            all.add(share);
                        }
                    }
                    return Ok(all);
                }
                Err(why) => {
                    let (left, gone) = present.present().await?;
                    if left == present {
                        return Err(why.into());
                    }
                    say(&format!("{}; once more without", gone.join("; ")));
                    asked = left;
                }
            }
        }
    }
}
