//! What the arm carries, as one page that needs no network.

use super::Provenance;
use crate::{identify::Trace, signal::Prepared, tool::Found};

/// The page.
pub fn tool_html(found: &Found, _logs: &[Prepared], _traces: &[Trace], _provenance: &Provenance) -> String {
    super::tool_verdict(found)
}
