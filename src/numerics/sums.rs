//! Sums of series.

/// Root mean square, summed in order; 0 for none.
pub(crate) fn root_mean_square(x: &[f64]) -> f64 {
    (x.iter().map(|x| x * x).sum::<f64>() / x.len().max(1) as f64).sqrt()
}

/// Sum of numbers by eight independent running sums, which fit vector registers.
pub(crate) fn sum(x: &[f64]) -> f64 {
    let (eights, rest) = x.as_chunks::<8>();
    let mut sums = [0.0; 8];
    for x in eights {
        for k in 0..8 {
            sums[k] += x[k];
        }
    }
    sums.iter().sum::<f64>() + rest.iter().sum::<f64>()
}

/// Sum of the squared differences of two series over their common length, by eight running sums.
pub(crate) fn squared_differences(a: &[f64], b: &[f64]) -> f64 {
    let n = a.len().min(b.len());
    let ((a8, a), (b8, b)) = (a[..n].as_chunks::<8>(), b[..n].as_chunks::<8>());
    let mut sums = [0.0; 8];
    for (a, b) in a8.iter().zip(b8) {
        for k in 0..8 {
            sums[k] += (a[k] - b[k]) * (a[k] - b[k]);
        }
    }
    sums.iter().sum::<f64>() + a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_of_any_length() {
        for n in [0, 1, 7, 8, 9, 100] {
            let x: Vec<f64> = (0..n).map(f64::from).collect();
            let y: Vec<f64> = x.iter().map(|x| x + 2.0).collect();
            assert_eq!(sum(&x), f64::from(n * (n - 1) / 2));
            assert_eq!(squared_differences(&x, &y), f64::from(4 * n));
            assert_eq!(squared_differences(&x, &[]), 0.0);
        }
    }
}
