//! Inverse of six joints in general position by elimination: selects the hidden joint and the
//! eliminated side.

use super::Found;
use super::lines::{self, Vector};
use crate::ik::{Axis, CHOICES, Family, General, NO_CHOICE};

/// Number of postures by which the choices are compared, and how many of them a choice may fail.
const TRIALS: usize = 16;
const FAILURES: usize = 1;

/// Candidates by elimination: six joints, or seven with one locked. Prismatic joints are locked
/// first, as an arm on a rail is solved best without it; then the last, the first, and those
/// between.
pub(super) fn candidates(axes: &[Axis]) -> Vec<Found> {
    let locks: Vec<Option<usize>> = match axes.len() {
        6 => vec![None],
        7 => {
            let mut order = [6, 0, 5, 1, 4, 2, 3];
            order.sort_by_key(|&joint| !axes[joint].slides);
            order.into_iter().map(Some).collect()
        }
        _ => Vec::new(),
    };
    locks.into_iter().filter_map(|locked| found(axes, locked)).collect()
}

fn found(axes: &[Axis], locked: Option<usize>) -> Option<Found> {
    let kept: Vec<usize> = (0..axes.len()).filter(|&k| Some(k) != locked).collect();
    let six: [Axis; 6] = kept.iter().map(|&k| axes[k]).collect::<Vec<_>>().try_into().ok()?;
    let joints: [u8; 6] = kept.iter().map(|&k| k as u8).collect::<Vec<_>>().try_into().ok()?;
    let (six, size) = gathered(six);
    let order = order(&General { axes: six, joints, locked: None, size, order: [NO_CHOICE; CHOICES] })?;
    let why = "no axes that simplify the equations were found, exactly or nearly";
    let by = match six.iter().filter(|a| a.slides).count() {
        0 | 1 => "five joints are eliminated, and the polynomial of degree 16 in the other solved",
        2 => "turns before slides, and the polynomial of degree 8 in one angle solved",
        _ => "three turns make the rotation, three slides the rest",
    };
    let given = locked.map_or(String::new(), |joint| format!("; joint {} is given", joint + 1));
    let general = General { axes: six, joints, locked: locked.map(|joint| joint as u8), size, order };
    Some(Found { class: "none", reason: format!("{why}: {by}{given}"), family: Family::General(general) })
}

/// The same lines, by their points nearest to the middle of the arm (those of a calibrated table
/// may be far away), and the size of the arm, m.
fn gathered(mut axes: [Axis; 6]) -> ([Axis; 6], f64) {
    let middle = |axes: &[Axis; 6]| axes.iter().fold([0.0; 3], |m, a| lines::add(m, lines::scale(1.0 / 6.0, a.c)));
    let foot = |a: &Axis, of: Vector| lines::add(a.c, lines::scale(lines::dot(a.h, lines::sub(of, a.c)), a.h));
    for _ in 0..3 {
        let at = middle(&axes);
        axes = axes.map(|a| Axis { c: foot(&a, at), ..a });
    }
    let at = middle(&axes);
    let square = |a: &Axis| lines::dot(lines::sub(a.c, at), lines::sub(a.c, at));
    let size = 2.0 * (axes.iter().map(square).sum::<f64>() / 6.0).sqrt();
    (axes, if size > 0.0 { size } else { 1.0 })
}

/// Choices that find the test postures and detect that there are no others, the most accurate
/// first; `None` if there is none.
fn order(general: &General) -> Option<[u8; CHOICES]> {
    let mut state = 11u64;
    let postures: [[f64; 6]; TRIALS] = core::array::from_fn(|_| {
        core::array::from_fn(|_| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1u64 << 53) as f64 * 2.0 - 1.0
        })
    });
    let range = general.axes.map(|a| if a.slides { general.size } else { core::f64::consts::PI });
    let postures = postures.map(|unit| core::array::from_fn(|k| unit[k] * range[k]));
    let mut rated: Vec<(usize, f64, u8)> = Vec::new();
    for choice in 0..12 {
        let (mut failures, mut digits) = (0, 0.0);
        for q in &postures {
            match general.trial(q, choice) {
                Some(error) => digits += error.max(1e-16).ln(),
                None => failures += 1,
            }
            if failures > FAILURES {
                break;
            }
        }
        if failures <= FAILURES {
            rated.push((failures, digits, choice));
        }
    }
    rated.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let mut order = [NO_CHOICE; CHOICES];
    for (place, (_, _, choice)) in order.iter_mut().zip(&rated) {
        *place = *choice;
    }
    (!rated.is_empty()).then_some(order)
}
