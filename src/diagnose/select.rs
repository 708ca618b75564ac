//! From accepted causes to the offered model: measurement on recordings, reduction, refinement,
//! choice.

pub(super) mod beside;
pub(super) mod beside_other_links;
pub(super) mod contenders;
mod drive_terms;
pub(super) mod excess;
mod from_the_file;
mod law_instead;
pub(super) mod measure;
pub(super) mod model_choice;
pub(super) mod offer;
mod prune;
pub(super) mod reduction;
pub(super) mod refine_and_select;
pub(super) mod remark;
pub(super) mod suspects;
