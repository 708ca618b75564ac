//! Tests that fitted samples do not validate, and that none counts twice, whatever their file's
//! format.

use denavit::numerics::prng::Random;

use super::*;

const ROBOT: &str = "robots/planar2r.yaml";

/// Rows of a moving arm with sensor noise: `t, q1, q2, tau1, tau2`, 100 per second.
fn rows(seconds: usize, seed: u64) -> Vec<Vec<f64>> {
    let mut random = Random::new(seed);
    let phase = random.even(3.0);
    let row = |k: usize, random: &mut Random| {
        let t = k as f64 / 100.0;
        let (a, b) = (2.1 * t + phase, 3.3 * t - phase);
        let q = [a.sin(), 0.8 * b.cos() + 0.2 * (0.7 * a).sin()];
        let tau = [3.0 * q[0].cos() - 2.0 * q[0], 1.2 * (q[0] + q[1]).cos() - 1.1 * q[1]];
        let noisy = |x: f64, random: &mut Random| x + random.even(1e-3);
        vec![t, noisy(q[0], random), noisy(q[1], random), noisy(tau[0], random), noisy(tau[1], random)]
    };
    (0..100 * seconds).map(|k| row(k, &mut random)).collect()
}

fn header() -> Vec<String> {
    ["t", "q1", "q2", "tau1", "tau2"].map(String::from).to_vec()
}

fn identify(arguments: &[&str]) -> Run {
    denavit(&[&["identify", ROBOT], arguments].concat())
}

#[test]
fn equal_samples_are_refused() {
    let folder = folder("same-samples");
    let one = rows(30, 1);
    let log = file(&folder, "one.csv", csv(&header(), &one));
    let other = file(&folder, "other.csv", csv(&header(), &rows(30, 2)));
    // Other order of columns, an additional column, other digits, and compressed.
    let mixed: Vec<String> =
        one.iter().map(|r| format!("{:e},{:.17},7,{:e},{:+e},{:e}", r[4], r[2], r[0], r[1], r[3])).collect();
    let mixed = format!("tau2,q2,dq_note,t,q1,tau1\n{}\n", mixed.join("\n"));
    let mut packed = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
    std::io::Write::write_all(&mut packed, mixed.as_bytes()).unwrap();
    let mixed = file(&folder, "mixed.csv.gz", packed.finish().unwrap());
    // A later part, with every second row left out.
    let part: Vec<Vec<f64>> = one[1000..2200].iter().step_by(2).map(|r| [&[r[0] + 1e4], &r[1..]].concat()).collect();
    let part = file(&folder, "part.csv", csv(&header(), &part));
    // Fewer digits.
    let fewer = |print: fn(f64) -> String| {
        let line = |r: &Vec<f64>| r.iter().map(|x| print(*x)).collect::<Vec<_>>().join(",");
        format!("{}\n{}\n", header().join(","), one.iter().map(line).collect::<Vec<_>>().join("\n"))
    };
    let places = file(&folder, "places.csv", fewer(|x| format!("{x:.5}")));
    let digits = file(&folder, "digits.csv", fewer(|x| format!("{x:.4e}")));
    // Half new, half old.
    let mut half = rows(15, 3);
    half.extend(one[2000..].iter().map(|r| [&[r[0]], &r[1..]].concat()));
    half.iter_mut().enumerate().for_each(|(k, r)| r[0] = k as f64 / 100.0);
    let half = file(&folder, "half.csv", csv(&header(), &half));

    assert_eq!(identify(&[&log, "--validate", &other]).status, Some(0));
    for (copy, words) in [
        (&log, "the same samples"),
        (&mixed, "the same samples"),
        (&part, " s with"),
        (&half, " s with"),
        (&places, "as many digits"),
        (&digits, "as many digits"),
    ] {
        for arguments in [vec![log.as_str(), "--validate", copy], vec![&log, copy], vec![copy, "--validate", &log]] {
            let run = identify(&arguments);
            assert_eq!(run.status, Some(2), "{arguments:?}: {}{}", run.out, run.err);
            assert!(run.err.contains(words), "{arguments:?}: {}", run.err);
        }
    }
    let shares = identify(&[&log, "--validate", &half]);
    assert!(shares.err.contains("10.0 of its 25.0 s"), "{}", shares.err);
    let run = denavit(&["diagnose", ROBOT, &log, "--validate", &mixed]);
    assert_eq!(run.status, Some(2), "{}", run.err);
    assert!(run.err.contains("the same samples") && !run.out.contains("not used"), "{}", run.err);
}

/// A repeated motion with other noise, rest in the same posture, and coarse sensors: none of it is
/// a copy.
#[test]
fn motions_that_resemble_each_other_are_apart() {
    let folder = folder("resembling-samples");
    let coarse = |seed: u64| {
        let mut rows = rows(30, 1);
        let mut random = Random::new(seed);
        for row in &mut rows {
            for (x, step) in row[1..].iter_mut().zip([1e-3, 1e-3, 0.02, 0.02]) {
                *x = ((*x + random.even(step)) / step).round() * step;
            }
        }
        // Three seconds of rest before the motion.
        let first = rows[0].clone();
        let still = |k: usize| [&[k as f64 / 100.0], &first[1..]].concat();
        let moved = rows.iter().map(|r| [&[r[0] + 3.0], &r[1..]].concat());
        (0..300).map(still).chain(moved).collect::<Vec<_>>()
    };
    let a = file(&folder, "a.csv", csv(&header(), &coarse(5)));
    let b = file(&folder, "b.csv", csv(&header(), &coarse(6)));
    let run = identify(&[&a, "--validate", &b, "--keep", "all"]);
    assert_eq!(run.status, Some(0), "{}", run.err);
}
