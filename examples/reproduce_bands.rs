//! One figure of the paper's experiments: how many of the 95 % bands of an estimated wrench hold
//! it, each run with its own identification.
//!
//! `cargo run --example reproduce_bands`

use std::error::Error;

use denavit::apps::paper::force::{Case, Stage, coverage};
use denavit::control::estimate::Method;

fn main() -> Result<(), Box<dyn Error>> {
    let runs = 10;
    // 100 Hz; 20 postures to identify from, 8 to estimate in.
    let stage = Stage::new(11, 100.0, 20, 8, [0.7, 0.0], [&[]; 2])?;
    let all = coverage(&stage, &[Method::Residual], Case::Right, runs, 500, &|_, _| {})?;
    for c in &all {
        println!("{:?}: {:.1} % of the bands hold the wrench, over {runs} runs", c.method, 100.0 * c.whole);
        assert!(c.whole > 0.85);
    }
    Ok(())
}
