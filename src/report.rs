//! The only room that formats results: plain data in, text, JSON or a page out. Writes no file and no terminal.

pub mod check_json;
pub mod check_text;
pub mod eval_json;
mod excite_html;
mod excite_text;
mod identify_html;
mod identify_json;
mod identify_text;
mod motion_check;
mod number;

pub use excite_html::excite_html;
pub use excite_text::{Outcome, excite_json, excite_text, joint_trajectory, motion_csv};
pub use identify_html::identify_html;
pub use identify_json::identify_json;
pub use identify_text::{identify_text, identify_verdict};
pub use motion_check::{motion_check_json, motion_check_text};

#[cfg(test)]
mod tests;

/// Where a result comes from, for the foot of a report: what and value, in order.
pub type Provenance = [(String, String)];
