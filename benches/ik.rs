//! All branches of one pose, and the swivel intervals of one branch: medians per pose over random poses. `benches/peers` measures
//! other crates in the same run.
//!
//! For the figures of the README: `RUSTFLAGS="-C target-cpu=native" cargo bench --bench ik`.

#[path = "ik/measure.rs"]
mod measure;

use measure::Bench;

fn row<const N: usize>(name: &str) {
    let bench = Bench::<N>::new(name);
    let (ns, branches) = bench.solve();
    let intervals = if bench.class == "srs" { format!("{:.2} us", bench.intervals() / 1e3) } else { "-".into() };
    println!("| {name} | {} | {branches:.1} | {:.2} us | {intervals} |", bench.class, ns / 1e3);
}

fn main() {
    println!("| robot | class | branches | all branches | swivel intervals |\n|---|---|---:|---:|---:|");
    row::<7>("kuka-lwr4");
    row::<7>("kuka-iiwa14");
    row::<7>("franka-panda");
    row::<6>("ur10e");
    row::<6>("puma560");
    row::<6>("staubli-tx40");
    row::<4>("scara");
    row::<6>("stanford");
}
