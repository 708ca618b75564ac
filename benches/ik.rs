//! All branches of one pose, and the swivel intervals of one branch. Prints medians per pose over
//! random poses, and clock cycles of the best round, which do not depend on the clock rate.
//! `benches/peers` measures other crates in the same run.
//!
//! For the figures of the README: `RUSTFLAGS="-C target-cpu=native" cargo bench --bench ik`.

#[path = "ik/measure.rs"]
mod measure;

use std::hint::black_box;

use measure::{Bench, cycles};

fn row<const N: usize>(name: &str) {
    measured(name, &Bench::<N>::new(name));
}

fn measured<const N: usize>(name: &str, bench: &Bench<N>) {
    let (ns, branches) = bench.solve();
    let (all, one) = bench.cycles();
    let (mut intervals, mut at) = (String::from("-"), String::from("-"));
    if bench.class == "srs" {
        intervals = format!("{:.2} us", bench.intervals() / 1e3);
        at = format!("{one:.0}");
    }
    let (us, slow) = (ns / 1e3, all / 2.5e3);
    println!(
        "| {name} | {} | {branches:.1} | {us:.2} us | {all:.0} | {slow:.2} us | {intervals} | {at} |",
        bench.class
    );
}

/// The same with the function of a generated crate, whose arm is a constant.
macro_rules! generated {
    ($name:literal, $krate:ident) => {{
        let bench = Bench::<{ $krate::DOF }>::new($name);
        let all = cycles(&bench.poses, |(pose, redundancy)| {
            let query = $krate::ik::Query { redundancy: *redundancy, ..Default::default() };
            black_box(&$krate::inverse_kinematics(pose, &query));
        });
        println!("| {} | {all:.0} | {:.2} us |", $name, all / 2.5e3);
    }};
}

fn main() {
    println!("| robot | class | branches | all branches | cycles | at 2.5 GHz | swivel intervals | cycles |");
    println!("|---|---|---:|---:|---:|---:|---:|---:|");
    row::<7>("kuka-lwr4");
    row::<7>("kuka-iiwa14");
    row::<7>("franka-panda");
    row::<6>("ur10e");
    row::<6>("puma560");
    row::<6>("staubli-tx40");
    row::<4>("scara");
    row::<6>("stanford");
    measured("xarm6", &Bench::<6>::of(include_str!("ik/xarm6.yaml")));
    measured("jaco2", &Bench::<6>::of(include_str!("ik/jaco2.yaml")));
    measured("gen3-lite", &Bench::<6>::of(include_str!("ik/gen3-lite.yaml")));
    println!("\n| generated crate | cycles | at 2.5 GHz |\n|---|---:|---:|");
    generated!("kuka-lwr4", kuka_lwr4);
    generated!("franka-panda", franka_panda);
    generated!("ur10e", ur10e);
    generated!("stanford", stanford);
}
