//! The only room that formats results: plain data in, text, JSON or a page out. Writes no file and no terminal.

mod bodies_html;
pub mod check_json;
pub mod check_text;
mod consistent;
mod diagnose_html;
mod diagnose_json;
mod diagnose_text;
pub mod eval_json;
mod excite_html;
mod excite_text;
mod force_html;
mod force_json;
mod force_text;
mod identify_html;
mod identify_json;
mod identify_text;
pub mod ik_json;
pub mod ik_text;
mod motion_check;
mod next_experiment;
mod number;
mod page;
mod paint_html;
mod paint_run;
mod paint_run_html;
mod paint_text;
mod paint_trace;
mod reproduce_diagnosis;
mod reproduce_excitation;
mod reproduce_force;
mod reproduce_html;
mod reproduce_json;
mod reproduce_painting;
mod reproduce_text;
mod simulate_json;
mod simulate_text;
mod stick_figure;
mod tool_html;
mod tool_json;
mod tool_text;
mod visible;

pub use bodies_html::Links;
pub use consistent::{Possible, carry_over_json, carry_over_text, consistent_json, consistent_text};
pub use diagnose_html::diagnose_html;
pub use diagnose_json::diagnose_json;
pub use diagnose_text::{diagnose_text, diagnose_verdict};
pub use excite_html::excite_html;
pub use excite_text::{Outcome, excite_json, excite_text, joint_trajectory, missing_text, motion_csv};
pub use force_html::force_html;
pub use force_json::{force_json, uncertainty_of_json};
pub use force_text::{Forces, force_text};
pub use identify_html::identify_html;
pub use identify_json::identify_json;
pub use identify_text::{identify_text, identify_verdict};
pub use motion_check::{motion_check_json, motion_check_text};
pub use next_experiment::{next_experiment_json, next_experiment_text};
pub use paint_html::paint_html;
pub use paint_run::{paint_run_csv, paint_run_json, paint_run_text};
pub use paint_run_html::{Painted, paint_run_html};
pub use paint_text::{Planned, paint_csv, paint_json, paint_path_csv, paint_text};
pub use reproduce_html::reproduce_html;
pub use reproduce_json::reproduce_json;
pub use reproduce_text::{Parts, reproduce_text};
pub use simulate_json::simulate_json;
pub use simulate_text::simulate_text;
pub use tool_html::tool_html;
pub use tool_json::tool_json;
pub use tool_text::{tool_text, tool_verdict};
pub use visible::{is_control, visible};

#[cfg(test)]
mod tests;

/// Where a result comes from, for the foot of a report: what and value, in order.
pub type Provenance = [(String, String)];
