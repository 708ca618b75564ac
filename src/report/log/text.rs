//! Channels of a recording and the proposed mapping, as text.

use core::fmt::Write;

use crate::data::log::{Channel, ChannelSummary, Passed, Proposal, Quantity};

/// Table of the channels, and the mapping.
pub fn inspect_text(file: &str, channels: &[ChannelSummary], proposal: &Proposal) -> String {
    let mut t = String::new();
    let _ = writeln!(t, "{file}: {} channels of numbers\n", channels.len());
    let width = channels.iter().map(|c| c.name.chars().count()).max().unwrap_or(7).clamp(7, 60);
    let _ = writeln!(
        t,
        "  {:<width$} {:>9} {:>8} {:>10} {:>11} {:>11}  remarks",
        "channel", "samples", "rate", "longest gap", "min", "max"
    );
    for channel in channels {
        let rate = channel.rate().map_or(String::new(), |r| format!("{r:.4}"));
        let gap = channel.clock.map_or(String::new(), |clock| format!("{:.4}", clock.longest_gap));
        let [low, high] =
            if channel.samples > 0 { channel.range.map(|v| format!("{v:.5}")) } else { [String::new(), String::new()] };
        let _ = writeln!(
            t,
            "  {:<width$} {:>9} {rate:>8} {gap:>10} {low:>11} {high:>11}  {}",
            channel.name,
            channel.samples,
            remarks(channel)
        );
    }
    let clock = "Rate and gap are in the clock's own unit (per second and seconds for a recording of messages).";
    let _ = writeln!(t, "\n{clock}\n");
    let by_joint = channels.iter().any(|c| c.name.starts_with('/') && !c.name.ends_with(']'));
    if proposal.mapping.columns.is_empty() && by_joint {
        t += "Joints of a recording are found by their names in the robot file, and its stamps are the time: \
              a mapping is needed only where names differ.\n";
        return t;
    }
    if proposal.mapping.columns.is_empty() {
        let _ = writeln!(t, "No mapping is proposed: no name says what its channel is.");
    } else {
        let _ = writeln!(t, "Proposed mapping, from names and ranges; check it before use (--map):\n");
        t += &mapping_yaml(proposal, file);
    }
    if !proposal.missing.is_empty() {
        let _ = writeln!(t, "\nNot found: {}. Add it to the mapping.", proposal.missing.join("; "));
    }
    t
}

fn remarks(channel: &ChannelSummary) -> String {
    let mut remarks = Vec::new();
    if channel.missing > 0 {
        remarks.push(format!("{} values are no numbers", channel.missing));
    }
    if channel.samples > 1 && channel.range[0] == channel.range[1] {
        remarks.push("constant".into());
    }
    if let (Some(clock), Some(rate)) = (channel.clock, channel.rate()) {
        if clock.longest_gap * rate > 5.0 {
            remarks.push("gaps".into());
        }
        if clock.restarts > 0 {
            let times = if clock.restarts == 1 { String::new() } else { format!(" {} times", clock.restarts) };
            remarks.push(format!("clock restarts{times}"));
        }
    }
    remarks.join(", ")
}

/// The mapping in the format of `--map`.
pub fn mapping_yaml(proposal: &Proposal, file: &str) -> String {
    let mut t = format!("# Mapping of the channels of {}.\ncolumns:\n", file.replace(|c: char| c.is_control(), " "));
    for ((column, channel), reason) in proposal.mapping.columns.iter().zip(&proposal.reasons) {
        let _ = writeln!(t, "  {}: {{ {} }}  # {}", quoted(column), entry(channel), reason.replace('\n', " "));
    }
    t
}

fn entry(channel: &Channel) -> String {
    let mut text = format!("channel: {}", quoted(&channel.name));
    if let Some(unit) = &channel.unit {
        let _ = write!(text, ", unit: {}", quoted(unit));
    }
    text
}

/// A YAML scalar: plain for letters and digits, otherwise in double quotes.
fn quoted(text: &str) -> String {
    let plain = !text.is_empty() && text.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    // JSON strings are YAML strings.
    if plain && text != "y" && text != "n" { text.into() } else { serde_json::Value::from(text).to_string() }
}

/// Summary of the written file.
pub fn converted_text(file: &str, log: &Passed, out: &str) -> String {
    let quantities: Vec<&str> =
        Quantity::ALL.iter().filter(|(q, _)| log.layout.has(*q)).map(|(_, prefix)| *prefix).collect();
    let stretches = if log.segments == 1 { "one stretch".to_string() } else { format!("{} stretches", log.segments) };
    format!(
        "{file}: {} rows, {} joints, {} ({stretches}) written to {out}\n",
        log.rows,
        log.layout.dof,
        quantities.join(", ")
    )
}
