//! Tests of the paper's figures and of calibrated recognition.

use super::bench::POSITION_NOISE;
use super::*;
use crate::identify::tool::{Entry, RecogniseSettings, Tolerance, catalogue};
use dh_codegen::robot::{Robot, no_files};

/// A bench with `noise` times the paper's noise.
fn bench(noise: f64) -> Bench {
    let text = std::fs::read_to_string("robots/kuka-lwr4.yaml").unwrap();
    let robot = Robot::from_yaml(&text, &no_files).unwrap().robot;
    let noise = SensorNoise { torque: PAPER_TORQUE_NOISE.map(|s| noise * s).to_vec(), position: POSITION_NOISE };
    Bench::new(&robot, noise, 10.0, 1).unwrap()
}

fn table() -> Vec<Entry> {
    catalogue().iter().filter_map(|t| Entry::new(t, None, &Tolerance::default())).collect()
}

fn settings(known: usize, unknown: usize, seed: u64) -> TrialSettings {
    let (tolerance, recognise) = (Tolerance::default(), RecogniseSettings::default());
    TrialSettings { known, unknown, tolerance, recognise, seed }
}

fn tell(t: &Trials) {
    println!("known {:?}, unknown {:?}, nearest {:?}", t.known, t.unknown, t.nearest_right);
    println!(
        "mean square {:.3}, coverage {:.3}, size error {:?}, fits {} of {}, false relatives {}",
        t.mean_square,
        t.coverage(),
        t.size_error(),
        t.sizes.iter().filter(|s| s.fits).count(),
        t.sizes.len(),
        t.false_relatives
    );
    for (row, counts) in t.confusion.iter().enumerate() {
        let name =
            t.names.get(row).map_or(if row == t.names.len() { "other roller" } else { "other body" }, String::as_str);
        let answers: Vec<String> = counts
            .iter()
            .enumerate()
            .filter(|(_, n)| **n > 0)
            .map(|(k, n)| format!("{} {n}", t.names.get(k).map_or("none", String::as_str)))
            .collect();
        println!("  {name}: {}", answers.join(", "));
    }
}

/// Table III: mass of the large roller within 2 %, standard deviations of well-determined
/// parameters no worse than the paper's. Its centre is within 2 mm from four motions of 10 s each
/// way, and within its stated deviation (2.2 mm) from one.
#[test]
fn table_three_of_the_paper() {
    let bench = bench(1.0);
    for seed in 0..3 {
        let large = &table_three(&bench, 1, seed).unwrap()[0];
        assert!(large.mass_error_percent.abs() < 2.0, "{}", large.mass_error_percent);
        assert!(large.center_std < 2.5e-3 && large.center_error < 3.0 * large.center_std, "{}", large.center_error);
        for name in ["M", "MSX", "MSZ", "XX", "YY"] {
            let row = large.rows.iter().find(|r| r.name == name).unwrap();
            let [paper, ours] = row.percent();
            assert!(ours <= paper, "{name}: {ours} % where the paper has {paper} %");
        }
        for row in &large.rows {
            assert!((row.ours[0] - row.truth).abs() < 4.5 * row.ours[1], "{row:?}");
        }
    }
    let columns = table_three(&bench, 4, 0).unwrap();
    assert!(columns[0].center_error < 2e-3 && columns[0].center_std < 1.5e-3, "{}", columns[0].center_error);
    for c in &columns {
        println!("{}: mass {:.2} %, centre {:.2} mm", c.tool, c.mass_error_percent, 1e3 * c.center_error);
        for r in &c.rows {
            let [paper, ours] = r.percent();
            println!(
                "  {:4} {:10.3e} {paper:6.1} %  {:10.3e}  {:10.3e} {ours:6.1} %",
                r.name, r.paper[0], r.truth, r.ours[0]
            );
        }
    }
}

#[test]
fn a_few_trials() {
    let t = trials(&bench(1.0), &table(), &settings(28, 16, 11), |_| {}).unwrap();
    tell(&t);
    assert!(t.known[1] >= 26 && t.known[3] == 0, "{:?}", t.known);
    assert!(t.unknown[1] >= 15, "{:?}", t.unknown);
}

/// Prints the largest errors of the interpolated sizes, worst last.
fn tell_sizes(t: &Trials) {
    let mut sizes = t.sizes.clone();
    let off = |s: &SizeTrial| (0..2).map(|k| (s.found[k] - s.truth[k]).abs()).fold(0.0, f64::max);
    sizes.sort_by(|a, b| off(a).total_cmp(&off(b)));
    for s in sizes.iter().rev().take(6).rev() {
        println!("{s:?}");
    }
    println!("median {:.4}", off(&sizes[sizes.len() / 2]));
}

/// 500 trials: minutes in debug, so run by `cargo test --release -- --ignored`.
#[test]
#[ignore = "takes half a minute in release"]
fn five_hundred_trials() {
    let t = trials(&bench(1.0), &table(), &settings(336, 164, 2018), |_| {}).unwrap();
    tell(&t);
    tell_sizes(&t);
    assert!(t.right() >= 0.98, "{}", t.right());
    assert!(t.rejected() >= 0.95, "{}", t.rejected());
    assert!((0.9..1.0).contains(&t.coverage()), "{}", t.coverage());
    // With five times the noise the distance measures differ.
    let noisy = trials(&bench(5.0), &table(), &settings(168, 0, 2019), |_| {}).unwrap();
    tell(&noisy);
    assert!(noisy.nearest_right[0] >= noisy.nearest_right[2], "{:?}", noisy.nearest_right);
}
