//! Direct search: steps along given directions and along rotated frames, halved if none improves
//! (Kolda, Lewis and Torczon, SIAM Review 45, 2003). The rotated frames are those of Abramson,
//! Audet, Dennis and Le Digabel, SIAM J. Optimization 20, 2009; without them a search stops where
//! two limits meet obliquely.
//!
//! The problems have a few variables and a yes or no for the reach. The gradient of the cost is
//! discontinuous where another joint's limit becomes active or a branch of the inverse ends. A
//! search that only compares candidates suffices, gives the same answer on every machine, and stops
//! where no step of the smallest size improves. The quadratic programs of `excite` (hundreds of
//! smooth variables) would need derivatives of the inverse. These are infinite at the edge of the
//! reach, where the widest lanes end.

/// Step sizes and budget of a search.
pub(crate) struct Effort {
    /// First step, in units of the scale.
    pub first: f64,
    /// Number of times the steps are halved.
    pub halvings: usize,
    /// Maximum number of candidates.
    pub budget: usize,
    /// Rotated frames tried before the steps are halved.
    pub frames: usize,
}

/// Improves `x` and its candidate `best`. `scale` is the first step of each variable, `directions`
/// are further ones in its units. `make` builds a candidate for a point, which it may project to
/// the valid range. `beats` compares two candidates. It gets the size of the step, so that it can
/// require a significant improvement.
pub(crate) fn pattern_search<T>(
    x: &mut Vec<f64>,
    best: &mut T,
    scale: &[f64],
    directions: &[Vec<f64>],
    effort: &Effort,
    make: &mut dyn FnMut(&mut Vec<f64>, &T) -> Option<T>,
    beats: &dyn Fn(&T, &T, f64) -> bool,
) {
    let n = x.len();
    let axes = (0..n).map(|k| unit(n, k));
    let given: Vec<Vec<f64>> = axes.chain(directions.iter().cloned()).collect();
    let mut left = effort.budget;
    let mut size = effort.first;
    let mut again: Option<Vec<f64>> = None;
    let mut turn = 0;
    for _ in 0..=effort.halvings {
        let mut frame = 0;
        while frame <= effort.frames {
            let turned = if frame == 0 { given.clone() } else { mirror(n, turn) };
            turn += usize::from(frame > 0);
            // Try the last successful direction first.
            let both = turned.iter().flat_map(|d| [d.clone(), d.iter().map(|e| -e).collect()]);
            let order: Vec<Vec<f64>> = again.take().into_iter().chain(both).collect();
            let mut moved = false;
            for d in order {
                if left == 0 {
                    return;
                }
                left -= 1;
                let mut there: Vec<f64> = (0..n).map(|k| x[k] + size * scale[k] * d[k]).collect();
                if let Some(found) = make(&mut there, best)
                    && beats(&found, best, size)
                {
                    *x = there;
                    *best = found;
                    again = Some(d);
                    moved = true;
                }
            }
            frame = if moved { 0 } else { frame + 1 };
            if n < 2 {
                break;
            }
        }
        size *= 0.5;
    }
}

fn unit(n: usize, k: usize) -> Vec<f64> {
    (0..n).map(|i| f64::from(u8::from(i == k))).collect()
}

/// An orthogonal frame that differs for each `turn`: the reflection `1 - 2 v v'` for a unit vector
/// that moves over the sphere in irrational steps.
fn mirror(n: usize, turn: usize) -> Vec<Vec<f64>> {
    let root = |k: usize| (2.0 + k as f64).sqrt();
    let v: Vec<f64> = (0..n).map(|k| (1.0 + (1.0 + turn as f64) * root(k * k) * 1.618).sin()).collect();
    let size = v.iter().map(|v| v * v).sum::<f64>().max(1e-12);
    (0..n).map(|i| (0..n).map(|k| f64::from(u8::from(i == k)) - 2.0 * v[i] * v[k] / size).collect()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_that_meet_at_a_slant() {
        // Maximise 1.4 x + y under oblique limits, violations first: axes alone stop at an edge.
        let judge = |x: &[f64]| {
            let broken = (x[0] + 3.0 * x[1] - 2.0).max(0.0) + (3.0 * x[0] + x[1] - 2.0).max(0.0);
            (broken, -1.4 * x[0] - x[1])
        };
        let mut x = vec![-3.0, -2.0];
        let mut best = judge(&x);
        let effort = Effort { first: 1.0, halvings: 20, budget: 100_000, frames: 3 };
        pattern_search(&mut x, &mut best, &[1.0, 1.0], &[], &effort, &mut |x, _| Some(judge(x)), &|a, b, _| {
            a.0 < b.0 || (a.0 == b.0 && a.1 < b.1)
        });
        // The optimum is the corner (0.5, 0.5).
        assert!((x[0] - 0.5).abs() < 1e-3 && (x[1] - 0.5).abs() < 1e-3, "{x:?} {best:?}");
    }
}
