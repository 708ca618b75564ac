//! Comparison with published numbers from tables outside the project. Without these files the tests
//! pass and print a message.

use std::collections::BTreeMap;
use std::path::Path;

use dh_codegen::arm::param;
use nalgebra::DVector;

use super::Numeric;
use super::base::Reduction;
use super::samples;

/// Rows of a table in `shared/data/reference`, split at commas, without the header.
fn table(name: &str) -> Option<Vec<Vec<String>>> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/data/reference").join(name);
    let Ok(text) = std::fs::read_to_string(&path) else {
        println!("skipped: no {}", path.display());
        return None;
    };
    Some(text.lines().skip(1).map(|line| line.split(',').map(str::to_string).collect()).collect())
}

/// `Ixx2` -> `XX2`, `mx2` -> `MSX2`, `m3` -> `M3`.
fn our_name(published: &str) -> String {
    match published.strip_prefix('I') {
        Some(tensor) => tensor.to_uppercase(),
        None => {
            let rest = published.trim_start_matches('m');
            if rest.starts_with(['x', 'y', 'z']) { format!("MS{}", rest.to_uppercase()) } else { format!("M{rest}") }
        }
    }
}

/// Factor of each parameter in `Ixx2 + Iyy3 - Iyy2 + 0.8*mz3`.
fn factors(grouping: &str) -> BTreeMap<String, f64> {
    let spaced = grouping.replace('-', "+ -").replace("- ", "-");
    let terms = spaced.split('+').map(str::trim).filter(|t| !t.is_empty());
    let term = |t: &str| {
        let (sign, t) = t.strip_prefix('-').map_or((1.0, t), |t| (-1.0, t.trim()));
        match t.split_once('*') {
            Some((factor, name)) => (our_name(name), sign * factor.parse::<f64>().unwrap()),
            None => (our_name(t), sign),
        }
    };
    terms.map(term).collect()
}

/// The 43 base parameters of the KUKA LWR IV+, their leaders and their factors: C. Gaz, F. Flacco
/// and A. De Luca, ICRA 2014.
#[test]
fn lwr_groupings_are_the_published_ones() {
    let Some(rows) = table("kuka_lwr4_gaz_base_parameters.csv") else { return };
    let robot = samples::kuka_lwr4();
    let names: Vec<String> = param::standard(&robot).iter().map(|p| p.name()).collect();
    let reduction = Reduction::customary(&robot, 5, 40).unwrap();
    assert_eq!(rows.len(), reduction.independent.len());
    for row in &rows {
        let leader = our_name(&row[1]);
        let i = reduction.independent.iter().position(|&k| names[k] == leader);
        let i = i.unwrap_or_else(|| panic!("{leader} is not kept"));
        let mut expected = factors(&row[2]);
        assert_eq!(expected.remove(&leader), Some(1.0));
        for (&k, found) in reduction.dependent.iter().zip(reduction.grouping.row(i).iter()) {
            let published = expected.remove(&names[k]).unwrap_or(0.0);
            assert!((found - published).abs() < 1e-9, "{leader}: {} {found} {published}", names[k]);
        }
        assert!(expected.is_empty(), "{leader}: {expected:?}");
    }
}

/// `g(q)` and `M(q) ddq` of the manufacturer's model at fifty states (the same paper).
#[test]
fn lwr_torques_are_the_published_ones() {
    let (Some(parameters), Some(vectors)) =
        (table("kuka_lwr4_gaz_base_parameters.csv"), table("kuka_lwr4_gaz_check_vectors.csv"))
    else {
        return;
    };
    let mut robot = samples::kuka_lwr4();
    robot.gravity = [0.0, 0.0, -9.80665];
    let numeric = Numeric::new(&robot);
    let names: Vec<String> = param::standard(&robot).iter().map(|p| p.name()).collect();
    // The manufacturer's model has other first moments in g than in M. A leader gets the value of
    // its group, all others are zero.
    let phi = |column: usize| {
        let mut phi = vec![0.0; names.len()];
        for row in &parameters {
            let k = names.iter().position(|n| *n == our_name(&row[1])).unwrap();
            phi[k] = row[column].parse().unwrap_or(0.0);
        }
        phi
    };
    let (phi_g, phi_m) = (phi(3), phi(4));
    let mut worst: (f64, f64) = (0.0, 0.0);
    assert_eq!(vectors.len(), 50);
    for row in &vectors {
        let numbers: Vec<f64> = row.iter().map(|x| x.parse().unwrap()).collect();
        let part = |i: usize| DVector::from_column_slice(&numbers[7 * i..7 * i + 7]);
        let (q, ddq, g, m_ddq) = (part(0), part(1), part(2), part(3));
        let inertial = numeric.mass_matrix(q.as_slice(), &phi_m) * ddq;
        worst.0 = worst.0.max((numeric.gravity(q.as_slice(), &phi_g) - g).amax());
        worst.1 = worst.1.max((inertial - m_ddq).amax());
    }
    println!("largest deviation: g {:.1e} N m, M ddq {:.1e} N m", worst.0, worst.1);
    // The table has nine digits; the manufacturer's closed form of M has coefficients rounded to
    // about 1e-8.
    assert!(worst.0 < 1e-6 && worst.1 < 1e-4, "{worst:?}");
}
