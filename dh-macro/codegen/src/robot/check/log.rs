//! Reads `log:` at the top of a robot file, and the file of a mapping.

use super::super::keys;
use super::super::log::{LogChannel, LogMapping, log_column};
use super::super::problem::Problems;
use super::super::reader::{Fields, Findings, join};
use super::super::yaml::{self, Kind, Node, Word, shortened};

impl LogMapping {
    /// Reads the file of a mapping, which has the format of `log` in a robot file.
    ///
    /// # Errors
    /// All mistakes, each with its line and column.
    pub fn from_yaml(text: &str) -> Result<Self, Problems> {
        let root = yaml::parse(text).map_err(Problems)?;
        let mut found = Findings::default();
        let mapping = found.fields(&root, "", &keys::LOG).map(|fields| mapping(&fields, &mut found));
        match mapping {
            Some(mapping) if found.problems.is_empty() => Ok(mapping),
            _ => Err(Problems(found.problems)),
        }
    }
}

/// Reads the mapping from these keys.
pub(super) fn mapping(fields: &Fields<'_>, to: &mut Findings) -> LogMapping {
    let arrival = fields.choice("clock", to) == Some("arrival");
    let mut columns: Vec<(String, LogChannel)> = Vec::new();
    let Some((node, path)) = fields.node("columns") else { return LogMapping { columns, arrival } };
    let Kind::Map(entries) = &node.kind else {
        let mend = "write `columns: { t: NAME, \"q*\": { channel: \"NAME_{number}\", unit: deg } }`";
        to.problem(node.mark, &path, format!("{} stands here", node.kind.describe()), mend);
        return LogMapping { columns, arrival };
    };
    for (word, value) in entries {
        columns.extend(channel(word, value, &path, to).map(|channel| (word.text.clone(), channel)));
    }
    LogMapping { columns, arrival }
}

/// Reads the channel of a column.
fn channel(word: &Word, value: &Node, path: &str, to: &mut Findings) -> Option<LogChannel> {
    let path = join(path, &shortened(&word.text));
    let dimension = match log_column(&word.text) {
        Ok(dimension) => dimension,
        Err(columns) => {
            to.problem(
                word.mark,
                &path,
                format!("`{}` is no column of a log", shortened(&word.text)),
                columns.to_string(),
            );
            return None;
        }
    };
    if let Kind::Scalar { text, .. } = &value.kind
        && !text.trim().is_empty()
    {
        return Some(LogChannel { name: text.trim().into(), ..LogChannel::default() });
    }
    let fields = to.fields(value, &path, &keys::CHANNEL)?;
    let unit = fields.text("unit", to);
    if let (Some(unit), Some((node, path))) = (&unit, fields.node("unit"))
        && dimension.and_then(|d| d.scale(unit)).is_none()
    {
        let units = dimension.map(|d| d.units().join(", "));
        let mend = units.map_or("leave it out".to_string(), |units| format!("choose among {units}"));
        to.problem(node.mark, &path, format!("`{}` is no unit of `{}`", shortened(unit), word.text), mend);
    }
    let (gain, offset) = (fields.numbers("gain", to), fields.numbers("offset", to));
    Some(LogChannel { name: fields.text("channel", to)?, unit, gain, offset })
}
