//! Formats results: plain data in, text, JSON or an HTML page out. The only module that does so;
//! writes to no file and no terminal.

pub use check::{json::check_json, text::check_text};
pub use diagnose::calibrate::{Identified, calibrate_text, calibrate_verdict};
pub use diagnose::json::diagnose_json;
pub use diagnose::next_experiment::{next_experiment_json, next_experiment_text};
pub use diagnose::page::diagnose_html;
pub use diagnose::text::{diagnose_text, diagnose_verdict, diagnose_warnings};
pub use diagnose::written::{WrittenCheck, written_json, written_text};
pub use eval::json::eval_json;
pub use excite::motion_check::{motion_check_json, motion_check_text};
pub use excite::page::excite_html;
pub use excite::saved::{trajectory_json, trajectory_of_json};
pub use excite::text::{Outcome, excite_json, excite_text, joint_trajectory, missing_text, motion_csv};
pub use export::{export_json, export_text};
pub use factor::json::factor_json;
pub use factor::table::{FactorRow, FactorTable, FactorTableError};
pub use factor::text::{factor_text, factor_verdict};
pub use force::json::{force_json, uncertainty_of_json};
pub use force::page::force_html;
pub use force::text::{Forces, force_text};
pub use identify::consistent::{
    Possible, consistent_json, consistent_text, extrapolation_json, held_text, identify_warnings,
};
pub use identify::json::identify_json;
pub use identify::page::identify_html;
pub use identify::text::{identify_text, identify_verdict};
pub use ik::{json::ik_json, text::ik_text};
pub use import::{
    json::import_json,
    text::{import_reason, import_text},
};
pub use log::json::inspect_json;
pub use log::text::{converted_text, inspect_text, mapping_yaml};
pub use paint::page::paint_html;
pub use paint::run::{paint_run_csv, paint_run_ended, paint_run_json, paint_run_text};
pub use paint::run_page::{Painted, paint_run_html};
pub use paint::saved::{plan_json, plan_of_json};
pub use paint::text::{Planned, paint_csv, paint_json, paint_path_csv, paint_text};
pub use parts::bodies::Links;
pub use parts::fields::FieldError;
pub use parts::visible::{is_control, visible};
pub use parts::warnings::Warnings;
pub use reproduce::json::reproduce_json;
pub use reproduce::page::reproduce_html;
pub use reproduce::text::{Parts, reproduce_text};
pub use robot_template::{RobotTemplate, robot_template};
pub use simulate::json::simulate_json;
pub use simulate::text::simulate_text;
pub use tool::json::tool_json;
pub use tool::page::tool_html;
pub use tool::text::{tool_text, tool_verdict, tool_warnings};

pub(crate) mod check;
pub(crate) mod diagnose;
pub(crate) mod eval;
pub(crate) mod excite;
pub(crate) mod export;
pub(crate) mod factor;
pub(crate) mod force;
pub(crate) mod identify;
pub(crate) mod ik;
pub(crate) mod import;
pub(crate) mod log;
pub(crate) mod paint;
pub(crate) mod parts;
pub(crate) mod reproduce;
mod robot_template;
pub(crate) mod simulate;
#[cfg(test)]
mod tests;
pub(crate) mod tool;

/// Provenance of a result, for the foot of a report: name and value, in order.
pub type Provenance = [(String, String)];
