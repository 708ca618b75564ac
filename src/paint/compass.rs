//! Compass search (Kolda, Lewis and Torczon, SIAM Review 45, 2003): steps along given directions, halved when none helps.
//!
//! A handful of variables, a cost whose gradient jumps where another joint begins to bind or a branch of the inverse ends, and a yes
//! or no for the reach: a search that asks only which of two candidates is better needs no more than that, gives the same answer on every
//! machine, and stops where no step of the smallest size helps. The quadratic programs of `excite` (hundreds of smooth variables) would
//! need derivatives of the inverse that are infinite at the edge of the reach, which is where the widest lanes end.

/// Improves `x` and what belongs to it. `make` gives a candidate for a point (or none), `beats` compares. Steps are halved `halvings` times.
pub(super) fn compass<T>(
    x: &mut Vec<f64>,
    best: &mut T,
    directions: &[Vec<f64>],
    halvings: usize,
    budget: usize,
    make: &mut dyn FnMut(&mut Vec<f64>, &T) -> Option<T>,
    beats: &dyn Fn(&T, &T) -> bool,
) {
    let mut left = budget;
    let mut size = 1.0;
    let mut again: Option<(usize, f64)> = None;
    for _ in 0..=halvings {
        loop {
            let mut moved = false;
            // What helped last is tried first.
            let order = again.into_iter().chain((0..directions.len()).flat_map(|d| [(d, 1.0), (d, -1.0)]));
            for (d, sign) in order.collect::<Vec<_>>() {
                if left == 0 {
                    return;
                }
                left -= 1;
                let mut there: Vec<f64> = x.iter().zip(&directions[d]).map(|(x, e)| x + sign * size * e).collect();
                if let Some(found) = make(&mut there, best)
                    && beats(&found, best)
                {
                    *x = there;
                    *best = found;
                    again = Some((d, sign));
                    moved = true;
                }
            }
            if !moved {
                break;
            }
        }
        size *= 0.5;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_valley() {
        let f = |x: &[f64]| (x[0] - 1.0).powi(2) + 10.0 * (x[1] - x[0] * x[0]).abs();
        let mut x = vec![-0.5, 2.0];
        let mut best = f(&x);
        let directions = [vec![1.0, 0.0], vec![0.0, 1.0], vec![1.0, 2.0], vec![1.0, -1.0]];
        compass(&mut x, &mut best, &directions, 30, 100_000, &mut |x, _| Some(f(x)), &|a, b| a < b);
        assert!((x[0] - 1.0).abs() < 0.2 && best < 0.05, "{x:?} {best}");
    }
}
