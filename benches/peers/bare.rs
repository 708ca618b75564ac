//! Time of the full regressor of the peers' arm: without the drives of its robot file. Prints the
//! median, ns per call, of 400 times 512 calls over 64 states, sines and cosines included, into the
//! caller's array.

use std::{hint::black_box, time::Instant};

use bare as arm;

fn main() {
    let number = |k: usize| (k as f64 * 12.9898).sin() * 2.0;
    let states: Vec<[[f64; arm::DOF]; 3]> = (0..64)
        .map(|s| core::array::from_fn(|part| core::array::from_fn(|j| number((3 * s + part) * arm::DOF + j))))
        .collect();
    let mut out = [[0.0; arm::STANDARD]; arm::DOF];
    let mut times: Vec<f64> = (0..400)
        .map(|_| {
            let start = Instant::now();
            for k in 0..512 {
                let [q, dq, ddq] = black_box(&states[k % states.len()]);
                arm::kernel::regressor::dense(&arm::Trig::new(q), dq, ddq, black_box(&mut out));
            }
            start.elapsed().as_nanos() as f64 / 512.0
        })
        .collect();
    times.sort_by(f64::total_cmp);
    println!("{:.1}", times[times.len() / 2]);
}
