//! `recordings(path, robot)`: a table whose scan reads whole recordings, file by file.
//!
//! The planner cuts files of rows into pieces and mixes them; a low-pass that runs forward and
//! backward would see pieces. So the leaf of the plan deals out files, and a batch is a recording.

use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use async_trait::async_trait;
use datafusion::arrow::datatypes::SchemaRef;
use datafusion::catalog::{Session, TableFunctionArgs, TableFunctionImpl, TableProvider};
use datafusion::common::tree_node::TreeNodeRecursion;
use datafusion::common::{Result, ScalarValue, plan_err};
use datafusion::datasource::TableType;
use datafusion::execution::{SendableRecordBatchStream, TaskContext};
use datafusion::logical_expr::Expr;
use datafusion::physical_expr::{EquivalenceProperties, PhysicalExpr};
use datafusion::physical_plan::execution_plan::{Boundedness, EmissionType};
use datafusion::physical_plan::stream::RecordBatchReceiverStreamBuilder;
use datafusion::physical_plan::{
    DisplayAs, DisplayFormatType, ExecutionPlan, Partitioning, PlanProperties, ReplaceChildrenOptions,
};
use denavit::identify::RecordingReader;
use denavit::identify::recording::plain_preparation;
use serde::{Deserialize, Serialize};

use crate::open::row;
use crate::output::say;
use crate::remote::{Place, RecordingFile, fetched};
use crate::robots::{KnownRobot, Robots};
use crate::table::{SCHEMA, batch};

/// The table function.
#[derive(Debug)]
pub struct Recordings(pub Arc<Robots>);

impl TableFunctionImpl for Recordings {
    fn call_with_args(&self, args: TableFunctionArgs<'_, '_>) -> Result<Arc<dyn TableProvider>> {
        let words: Vec<&str> = args.exprs().iter().filter_map(text).collect();
        let (path, robot, name) = match words.as_slice() {
            [path, robot] => (path, robot, None),
            [path, robot, name] => (path, robot, Some(*name)),
            _ => {
                return plan_err!(
                    "recordings(path, robot) or recordings(path, robot, name): texts; a file or folder of recordings, \
                     a robot file, and the name of the one arm where many share that file"
                );
            }
        };
        let robot = self.0.open(PathBuf::from(robot).as_path())?;
        let name = name.unwrap_or(&robot.robot.name).to_string();
        let place = Place::of(path)?;
        Ok(Arc::new(RecordingsTable { robot, name, place, day: None }))
    }
}

/// A literal text.
fn text(expr: &Expr) -> Option<&str> {
    match expr {
        Expr::Literal(ScalarValue::Utf8(Some(text)) | ScalarValue::Utf8View(Some(text)), _) => Some(text),
        _ => None,
    }
}

/// Recordings of one robot file below one place.
#[derive(Debug)]
pub struct RecordingsTable {
    /// The robot.
    pub robot: Arc<KnownRobot>,
    /// Its name in the table.
    pub name: String,
    /// Where they are.
    pub place: Place,
    /// Day of recordings whose time is not that of a calendar.
    pub day: Option<i32>,
}

#[async_trait]
impl TableProvider for RecordingsTable {
    fn schema(&self) -> SchemaRef {
        Arc::clone(&SCHEMA)
    }

    fn table_type(&self) -> TableType {
        TableType::Base
    }

    async fn scan(
        &self,
        state: &dyn Session,
        projection: Option<&Vec<usize>>,
        _filters: &[Expr],
        _limit: Option<usize>,
    ) -> Result<Arc<dyn ExecutionPlan>> {
        let files = self.place.recordings(state.runtime_env()).await?;
        let wanted = state.config_options().execution.target_partitions;
        let partitions = match state.config().get_extension::<OfEachWorker>() {
            // A plan of one partition would be kept at home; the shares have their own number.
            Some(_) => wanted.max(2),
            None => wanted.clamp(1, files.len().max(1)),
        };
        let (name, base, projection) = (self.name.clone(), std::env::current_dir()?, projection.cloned());
        let parts = Parts { name, base, files, partitions, projection, day: self.day };
        Ok(Arc::new(RecordingsExec::new(Arc::clone(&self.robot), parts)?))
    }
}

/// The leaf: partition `k` reads every `partitions`-th file from the `k`-th on.
#[derive(Debug)]
pub(crate) struct RecordingsExec {
    robot: Arc<KnownRobot>,
    parts: Arc<Parts>,
    properties: Arc<PlanProperties>,
}

/// What a leaf reads, beside the robot.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Parts {
    /// The arm's name in the table.
    pub name: String,
    /// The folder that relative paths start from; rows have the paths without it.
    pub base: PathBuf,
    /// The recordings.
    pub files: Vec<RecordingFile>,
    /// Recordings at once.
    pub partitions: usize,
    /// Columns.
    pub projection: Option<Vec<usize>>,
    /// Day of recordings without one.
    pub day: Option<i32>,
}

/// Recordings at once on each worker, in a session that has workers.
#[derive(Debug, Clone, Copy)]
pub(crate) struct OfEachWorker(#[cfg_attr(not(feature = "cluster"), expect(dead_code))] pub usize);

/// What this process has done for others, which its log says; in the sessions of a worker.
#[derive(Debug, Default)]
pub(crate) struct DoneForOthers(AtomicUsize);

impl DoneForOthers {
    /// So many recordings or robots more.
    pub fn say(&self, count: usize, what: &str) {
        let all = self.0.fetch_add(count, Ordering::Relaxed) + count;
        say(&format!("{count} {what}, {all} since the start"));
    }
}

impl RecordingsExec {
    pub(crate) fn new(robot: Arc<KnownRobot>, parts: Parts) -> Result<Self> {
        let schema = match &parts.projection {
            Some(columns) => Arc::new(SCHEMA.project(columns)?),
            None => Arc::clone(&SCHEMA),
        };
        let properties = PlanProperties::new(
            EquivalenceProperties::new(schema),
            Partitioning::UnknownPartitioning(parts.partitions),
            EmissionType::Incremental,
            Boundedness::Bounded,
        );
        Ok(Self { robot, parts: Arc::new(parts), properties: Arc::new(properties) })
    }

    /// The robot and what is read.
    #[cfg(feature = "cluster")]
    pub(crate) fn contents(&self) -> (&Arc<KnownRobot>, &Parts) {
        (&self.robot, &self.parts)
    }
}

impl DisplayAs for RecordingsExec {
    fn fmt_as(&self, _: DisplayFormatType, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Parts { files, partitions, .. } = &*self.parts;
        write!(f, "RecordingsExec: {} files in {partitions} partitions, {:?}", files.len(), self.robot)
    }
}

impl ExecutionPlan for RecordingsExec {
    fn name(&self) -> &'static str {
        "RecordingsExec"
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
        let schema = self.properties.equivalence_properties().schema();
        let mut stream = RecordBatchReceiverStreamBuilder::new(Arc::clone(schema), 1);
        let (send, robot, parts) = (stream.tx(), Arc::clone(&self.robot), Arc::clone(&self.parts));
        let runtime = tokio::runtime::Handle::current();
        let others = context.session_config().get_extension::<DoneForOthers>();
        stream.spawn_blocking(move || {
            let mut count = 0;
            let prepare = plain_preparation(&robot.robot);
            let read = RecordingReader::with(&robot.robot, robot.digest, prepare, |reader| {
                for file in parts.files.iter().skip(partition).step_by(parts.partitions) {
                    let mut row = match file {
                        RecordingFile::Local(path) => {
                            row(&path.display().to_string(), &parts.base.join(path), &parts.name, reader)
                        }
                        RecordingFile::Remote(remote) => {
                            let local = runtime.block_on(fetched(&context.runtime_env(), remote))?;
                            row(&remote.name, local.path(), &parts.name, reader)
                        }
                    };
                    row.day = row.day.or(parts.day);
                    count += 1;
                    let rows = batch(&[row])?;
                    let rows = match &parts.projection {
                        Some(columns) => rows.project(columns)?,
                        None => rows,
                    };
                    if send.blocking_send(Ok(rows)).is_err() {
                        break;
                    }
                }
                Ok(())
            });
            if let Some(others) = others {
                others.say(count, &format!("recordings of {} read", parts.name));
            }
            read
        });
        Ok(stream.build())
    }
}
