//! One figure of the paper's experiments: the share of the 95 % bands that contain the true wrench,
//! each run with its own identification.
//!
//! `cargo run --example reproduce_bands`

use std::error::Error;

use denavit::apps::paper::force::{Case, Stage, coverage};
use denavit::control::estimate::Method;

fn main() -> Result<(), Box<dyn Error>> {
    let runs = 10;
    // 100 Hz; 20 postures for the identification, 8 for the estimate.
    let stage = Stage::new(11, 100.0, 20, 8, [0.7, 0.0], [&[]; 2])?;
    let all = coverage(&stage, &[Method::Residual], Case::Right, runs, 500, &|_, _| {})?;
    for c in &all {
        println!("{:?}: {:.1} % of the bands hold the wrench, over {runs} runs", c.method, 100.0 * c.whole);
        assert!(c.whole > 0.85);
    }
    Ok(())
}
