//! The leaves of a plan on their way to workers: which share of the work each gets, and bytes.

use std::sync::Arc;

use datafusion::common::{Result, exec_datafusion_err, internal_err};
use datafusion::execution::TaskContext;
use datafusion::physical_plan::ExecutionPlan;
use datafusion_distributed::{
    DesiredTaskCountEvent, DesiredTaskCountEventResponse, DistributedLeafExec, ScaleUpLeafNodeEvent,
    ScaleUpLeafNodeEventResponse,
};
use datafusion_proto::physical_plan::{PhysicalExtensionCodec, PhysicalProtoConverterExtension};
use serde::{Deserialize, Serialize};

use super::watch::{WatchExec, WatchParts};
use crate::recordings::{OfEachWorker, Parts, RecordingsExec};
use crate::robots::{RobotFile, Robots};

/// A leaf in the form in which it is sent.
#[derive(Serialize, Deserialize)]
enum Sent {
    Recordings(RobotFile, Parts),
    Watch(WatchParts),
}

/// Leaves as bytes. The receiver makes robots of the texts of their files, once each.
#[derive(Debug)]
pub(super) struct Codec(pub Arc<Robots>);

impl PhysicalExtensionCodec for Codec {
    fn try_decode(
        &self,
        bytes: &[u8],
        _: &[Arc<dyn ExecutionPlan>],
        _: &TaskContext,
        _: &dyn PhysicalProtoConverterExtension,
    ) -> Result<Arc<dyn ExecutionPlan>> {
        let sent = postcard::from_bytes(bytes);
        match sent.map_err(|e| exec_datafusion_err!("a part of a plan is of another version: {e}"))? {
            Sent::Recordings(file, parts) => Ok(Arc::new(RecordingsExec::new(self.0.given(file)?, parts)?)),
            Sent::Watch(parts) => Ok(Arc::new(WatchExec::new(parts, 1))),
        }
    }

    fn try_encode(
        &self,
        node: Arc<dyn ExecutionPlan>,
        bytes: &mut Vec<u8>,
        _: &dyn PhysicalProtoConverterExtension,
    ) -> Result<()> {
        let sent = if let Some(leaf) = node.downcast_ref::<RecordingsExec>() {
            let (robot, parts) = leaf.contents();
            Sent::Recordings(robot.file.clone(), parts.clone())
        } else if let Some(leaf) = node.downcast_ref::<WatchExec>() {
            Sent::Watch(leaf.parts().clone())
        } else {
            return internal_err!("{} is no leaf of a fleet", node.name());
        };
        bytes.extend(postcard::to_stdvec(&sent).map_err(|e| exec_datafusion_err!("a plan can't be sent: {e}"))?);
        Ok(())
    }
}

/// Tasks that a leaf can be cut into; the planner takes at most the number of workers.
pub(super) fn tasks(event: DesiredTaskCountEvent<'_>) -> Option<Result<DesiredTaskCountEventResponse>> {
    let parts = if let Some(leaf) = event.plan.downcast_ref::<RecordingsExec>() {
        leaf.contents().1.files.len()
    } else {
        event.plan.downcast_ref::<WatchExec>()?.parts().robots.len()
    };
    // One alone would stay at home.
    Some(Ok(DesiredTaskCountEventResponse::desired(parts.max(2))))
}

/// The share of each task.
pub(super) fn share(event: ScaleUpLeafNodeEvent<'_>) -> Option<Result<ScaleUpLeafNodeEventResponse>> {
    let count = event.task_count;
    let shares: Result<Vec<Arc<dyn ExecutionPlan>>> = if let Some(leaf) = event.plan.downcast_ref::<RecordingsExec>() {
        let (robot, parts) = leaf.contents();
        let partitions = event.session_config.get_extension::<OfEachWorker>().map_or(1, |each| each.0);
        let share = |k: usize| -> Result<Arc<dyn ExecutionPlan>> {
            let files = parts.files.iter().skip(k).step_by(count).cloned().collect();
            Ok(Arc::new(RecordingsExec::new(Arc::clone(robot), Parts { files, partitions, ..parts.clone() })?))
        };
        (0..count).map(share).collect()
    } else {
        let parts = event.plan.downcast_ref::<WatchExec>()?.parts();
        let each = parts.robots.len().div_ceil(count).max(1);
        let share = |k: usize| -> Result<Arc<dyn ExecutionPlan>> {
            let robots = parts.robots.iter().skip(k * each).take(each).cloned().collect();
            Ok(Arc::new(WatchExec::new(WatchParts { robots, ..parts.clone() }, 1)))
        };
        (0..count).map(share).collect()
    };
    let leaf = shares.and_then(|shares| DistributedLeafExec::try_new(Arc::clone(event.plan), shares));
    Some(leaf.map(|leaf| ScaleUpLeafNodeEventResponse::new(Arc::new(leaf))))
}
