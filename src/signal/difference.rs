//! Derivatives by centred differences over one sample to each side, as in the paper (section III.E).

/// `dx[k] = (x[k+1] - x[k-1]) / (2 T)`; one-sided at the ends. `period` is `T`, s.
pub fn central(x: &[f64], period: f64) -> Vec<f64> {
    let n = x.len();
    if n < 2 {
        return vec![0.0; n];
    }
    let mut dx = Vec::with_capacity(n);
    dx.push((x[1] - x[0]) / period);
    dx.extend(x.windows(3).map(|w| (w[2] - w[0]) / (2.0 * period)));
    dx.push((x[n - 1] - x[n - 2]) / period);
    dx
}

/// `ddx[k] = (x[k+1] - 2 x[k] + x[k-1]) / T^2`, the centred difference of the half-step differences; the ends repeat their
/// neighbours.
pub fn central_second(x: &[f64], period: f64) -> Vec<f64> {
    let n = x.len();
    if n < 3 {
        return vec![0.0; n];
    }
    let inner: Vec<f64> = x.windows(3).map(|w| (w[2] - 2.0 * w[1] + w[0]) / (period * period)).collect();
    let mut ddx = Vec::with_capacity(n);
    ddx.push(inner[0]);
    ddx.extend_from_slice(&inner);
    ddx.push(inner[n - 3]);
    ddx
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_on_a_parabola() {
        let x: Vec<f64> = (0..9).map(|k| (0.1 * k as f64).powi(2)).collect();
        let (dx, ddx) = (central(&x, 0.1), central_second(&x, 0.1));
        for k in 1..8 {
            assert!((dx[k] - 0.2 * k as f64).abs() < 1e-12 && (ddx[k] - 2.0).abs() < 1e-10);
        }
    }

    #[test]
    fn too_short() {
        assert_eq!(central(&[1.0], 0.1), [0.0]);
        assert_eq!(central_second(&[1.0, 2.0], 0.1), [0.0, 0.0]);
    }
}
