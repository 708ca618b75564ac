//! Channels of a recording and the proposed mapping, as JSON.

use serde_json::{Value, json};

use crate::data::log::{ChannelSummary, Proposal};

/// The keys `channels` and `mapping`.
pub fn inspect_json(channels: &[ChannelSummary], proposal: &Proposal) -> Value {
    let channels: Vec<Value> = channels
        .iter()
        .map(|c| {
            let range = (c.samples > 0).then_some(c.range);
            json!({
                "name": c.name,
                "samples": c.samples,
                "missing": c.missing,
                "min": range.map(|r| r[0]),
                "max": range.map(|r| r[1]),
                "largest_step": c.largest_step,
                "rate": c.rate(),
                "longest_gap": c.clock.map(|clock| clock.longest_gap),
            })
        })
        .collect();
    let columns: serde_json::Map<String, Value> = proposal
        .mapping
        .columns
        .iter()
        .zip(&proposal.reasons)
        .map(|((column, channel), reason)| {
            (column.clone(), json!({ "channel": channel.name, "unit": channel.unit, "reason": reason }))
        })
        .collect();
    json!({ "channels": channels, "mapping": { "columns": columns }, "missing": proposal.missing })
}
