//! The only room that formats results: plain data in, text, JSON or a page out. Writes no file and no terminal.

pub mod check_json;
pub mod check_text;
pub mod eval_json;
mod identify_html;
mod identify_json;
mod identify_text;
pub mod ik_json;
pub mod ik_text;
mod number;

pub use identify_html::identify_html;
pub use identify_json::identify_json;
pub use identify_text::{identify_text, identify_verdict};

#[cfg(test)]
mod tests;

/// Where a result comes from, for the foot of a report: what and value, in order.
pub type Provenance = [(String, String)];
