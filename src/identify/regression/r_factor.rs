//! Triangular factor that is updated by blocks of rows.

/// Factor `R` of `A = Q R`, with the rows of `A` added in blocks and `Q` never stored: `R' R = A'
/// A`.
///
/// A block is placed below the triangle and annihilated column by column with Householder
/// reflections. Each reflection touches one row of the triangle (Golub and Van Loan, Matrix
/// Computations, sections 5.2 and 6.5.3).
#[derive(Debug, Clone, PartialEq)]
pub struct RFactor {
    n: usize,
    /// Entries, column-major, `n * n`, zero below the diagonal.
    r: Vec<f64>,
}

impl RFactor {
    /// Factor of no rows, with `n` columns.
    pub fn new(n: usize) -> Self {
        Self { n, r: vec![0.0; n * n] }
    }

    /// Factor from its upper triangle, column by column; missing entries are zero.
    pub(in crate::identify) fn of_upper(n: usize, upper: &[f64]) -> Self {
        let mut factor = Self::new(n);
        let places = (0..n).flat_map(|k| (0..=k).map(move |i| i + k * n));
        places.zip(upper).for_each(|(place, value)| factor.r[place] = *value);
        factor
    }

    /// Number of columns.
    pub fn columns(&self) -> usize {
        self.n
    }

    /// Entry in row `i`, column `k`.
    pub fn get(&self, i: usize, k: usize) -> f64 {
        self.r[i + k * self.n]
    }

    /// Column `k`, rows `0..=k`.
    pub fn column(&self, k: usize) -> &[f64] {
        &self.r[k * self.n..=k * self.n + k]
    }

    /// Adds `rows` rows: column-major, `rows * n`. The block is used as working memory.
    pub fn absorb(&mut self, block: &mut [f64], rows: usize) {
        self.annihilate(block, rows, |_| rows);
    }

    /// Adds the rows represented by another factor.
    pub fn merge(&mut self, other: &Self) {
        let n = self.n;
        let mut block = other.r.clone();
        self.annihilate(&mut block, n, |k| (k + 1).min(n));
    }

    /// Annihilates a block whose column `k` has its nonzeros in the first `filled(k)` rows.
    /// `filled` must not decrease with `k`.
    fn annihilate(&mut self, block: &mut [f64], rows: usize, filled: impl Fn(usize) -> usize) {
        let n = self.n;
        if rows == 0 {
            return;
        }
        for k in 0..n {
            let (left, right) = block.split_at_mut((k + 1) * rows);
            let v = &left[k * rows..][..filled(k)];
            let squares = dot(v, v);
            let diagonal = self.r[k + k * n];
            // A filter can attenuate a constant so far that its square is subnormal.
            if squares == 0.0 || diagonal * diagonal + squares < 1e-280 {
                continue;
            }
            let norm = (diagonal * diagonal + squares).sqrt();
            let beta = if diagonal > 0.0 { -norm } else { norm };
            let top = diagonal - beta;
            let scale = 2.0 / (top * top + squares);
            self.r[k + k * n] = beta;
            let mirror = Mirror { v, head: top, scale };
            mirror.apply(right, rows, 0, Some((&mut self.r[(k + 1) * n..], k, n)));
        }
    }

    /// Negates the last column of `A`.
    pub(in crate::identify) fn negate_last(&mut self) {
        let from = self.n * self.n.saturating_sub(1);
        self.r[from..].iter_mut().for_each(|v| *v = -*v);
    }

    /// Norm of `A x`.
    pub fn norm_of(&self, x: &[f64]) -> f64 {
        self.apply(x).iter().map(|y| y * y).sum::<f64>().sqrt()
    }

    /// Product `R x`.
    pub fn apply(&self, x: &[f64]) -> Vec<f64> {
        let mut y = vec![0.0; self.n];
        for (k, &value) in x.iter().enumerate().take(self.n) {
            for (out, r) in y.iter_mut().zip(self.column(k)) {
                *out += r * value;
            }
        }
        y
    }

    /// Gram matrix `R' R = A' A`, column-major.
    pub fn gram(&self) -> Vec<f64> {
        let n = self.n;
        let mut gram = vec![0.0; n * n];
        for k in 0..n {
            for i in 0..=k {
                let value = dot(&self.column(i)[..=i], &self.column(k)[..=i]);
                gram[i + k * n] = value;
                gram[k + i * n] = value;
            }
        }
        gram
    }
}

/// A Householder reflection of one pivot entry and of entries below it.
pub(in crate::identify) struct Mirror<'a> {
    /// Entries of its vector below the pivot.
    pub v: &'a [f64],
    /// Entry of its vector at the pivot.
    pub head: f64,
    /// Scale `2 / |vector|^2`.
    pub scale: f64,
}

impl Mirror<'_> {
    /// Reflects columns of `rows` entries each, modifying the entries from `from` on. `pivots`:
    /// separate pivot entries (column-major array, row in it, number of its rows). `None`: the
    /// pivot is the entry at `from`, followed by the others.
    pub fn apply(&self, columns: &mut [f64], rows: usize, from: usize, pivots: Option<(&mut [f64], usize, usize)>) {
        reflect(self, columns, rows, from, pivots);
    }
}

/// Applies a reflection with the widest registers of the processor. Sums and products keep their
/// rounding, so results are bit-identical.
#[multiversion::multiversion(targets("x86_64+avx2"))]
fn reflect(
    mirror: &Mirror<'_>,
    columns: &mut [f64],
    rows: usize,
    from: usize,
    pivots: Option<(&mut [f64], usize, usize)>,
) {
    let Mirror { v, head, scale } = *mirror;
    match pivots {
        Some((apart, row, stride)) => {
            // Without closures, which would not inherit the function's target features.
            let (mut fours, mut blocks) = (apart.chunks_exact_mut(4 * stride), columns.chunks_exact_mut(4 * rows));
            for (pivots, block) in fours.by_ref().zip(blocks.by_ref()) {
                let products = dots(v, &block[from..], rows);
                for (k, product) in products.into_iter().enumerate() {
                    let entry = &mut pivots[k * stride + row];
                    let w = scale * (head * *entry + product);
                    *entry -= w * head;
                    subtract(&mut block[k * rows + from..][..v.len()], w, v);
                }
            }
            let rest = blocks.into_remainder();
            for (pivots, column) in fours.into_remainder().chunks_exact_mut(stride).zip(rest.chunks_exact_mut(rows)) {
                let (entry, rest) = (&mut pivots[row], &mut column[from..from + v.len()]);
                let w = scale * (head * *entry + dot(v, rest));
                *entry -= w * head;
                subtract(rest, w, v);
            }
        }
        None => {
            for column in columns.chunks_exact_mut(rows) {
                let (before, rest) = column.split_at_mut(from + 1);
                let (entry, rest) = (&mut before[from], &mut rest[..v.len()]);
                let w = scale * (head * *entry + dot(v, rest));
                *entry -= w * head;
                subtract(rest, w, v);
            }
        }
    }
}

/// [`dot`] of a vector with four others that begin `stride` apart.
#[inline(always)]
pub(crate) fn dots(a: &[f64], others: &[f64], stride: usize) -> [f64; 4] {
    let n = a.len();
    dots_of(a, [&others[..n], &others[stride..][..n], &others[2 * stride..][..n], &others[3 * stride..][..n]])
}

/// [`dot`] of a vector with four others of the same length, bit-identical: the four sums are
/// independent and run in parallel.
#[inline(always)]
pub(crate) fn dots_of(a: &[f64], [b0, b1, b2, b3]: [&[f64]; 4]) -> [f64; 4] {
    let n = a.len();
    let whole = n - n % 8;
    let (b0, b1, b2, b3) = (&b0[..n], &b1[..n], &b2[..n], &b3[..n]);
    let mut sums = [[0.0; 8]; 4];
    let mut at = 0;
    while at < whole {
        let x = &a[at..at + 8];
        let (y0, y1, y2, y3) = (&b0[at..at + 8], &b1[at..at + 8], &b2[at..at + 8], &b3[at..at + 8]);
        for i in 0..8 {
            sums[0][i] += x[i] * y0[i];
            sums[1][i] += x[i] * y1[i];
            sums[2][i] += x[i] * y2[i];
            sums[3][i] += x[i] * y3[i];
        }
        at += 8;
    }
    let mut out = [0.0; 4];
    for (k, other) in [b0, b1, b2, b3].into_iter().enumerate() {
        let mut rest = 0.0;
        for i in whole..n {
            rest += a[i] * other[i];
        }
        out[k] = total(&sums[k], rest);
    }
    out
}

/// Inner product with eight running sums, which the compiler can keep in vector registers.
#[inline(always)]
pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; 8];
    let (a8, b8) = (a.chunks_exact(8), b.chunks_exact(8));
    let rest: f64 = a8.remainder().iter().zip(b8.remainder()).map(|(x, y)| x * y).sum();
    for (x, y) in a8.zip(b8) {
        for i in 0..8 {
            sums[i] += x[i] * y[i];
        }
    }
    total(&sums, rest)
}

/// Sum of eight running sums and of the remainder.
#[inline(always)]
fn total(sums: &[f64; 8], rest: f64) -> f64 {
    rest + ((sums[0] + sums[4]) + (sums[1] + sums[5])) + ((sums[2] + sums[6]) + (sums[3] + sums[7]))
}

/// Update `b -= w v`.
#[inline(always)]
fn subtract(b: &mut [f64], w: f64, v: &[f64]) {
    for (x, y) in b.iter_mut().zip(v) {
        *x -= w * y;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn noise(n: usize, seed: u64) -> Vec<f64> {
        let mut state = seed;
        (0..n)
            .map(|_| {
                state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
                (state >> 11) as f64 / (1u64 << 53) as f64 - 0.5
            })
            .collect()
    }

    #[test]
    fn blocks_equal_one_shot_and_a_dense_qr() {
        let (m, n) = (137, 9);
        let a = noise(m * n, 3);
        let mut whole = RFactor::new(n);
        whole.absorb(&mut a.clone(), m);
        let mut parts = [RFactor::new(n), RFactor::new(n)];
        let mut row = 0;
        for (i, rows) in [1, 30, 6, 50, 50].into_iter().enumerate() {
            let mut block: Vec<f64> = (0..n).flat_map(|k| a[k * m + row..k * m + row + rows].to_vec()).collect();
            parts[i % 2].absorb(&mut block, rows);
            row += rows;
        }
        let [mut one, two] = parts;
        one.merge(&two);
        let dense = nalgebra::DMatrix::from_column_slice(m, n, &a).qr().unpack_r();
        for k in 0..n {
            for i in 0..=k {
                assert!((whole.get(i, k).abs() - dense[(i, k)].abs()).abs() < 1e-12);
                assert!((whole.get(i, k).abs() - one.get(i, k).abs()).abs() < 1e-12);
            }
        }
        let x = noise(n, 8);
        let direct = (nalgebra::DMatrix::from_column_slice(m, n, &a) * nalgebra::DVector::from_vec(x.clone())).norm();
        assert!((whole.norm_of(&x) - direct).abs() < 1e-12);
    }

    #[test]
    fn numbers_whose_squares_vanish() {
        let mut t = RFactor::new(2);
        t.absorb(&mut [1e-160, 3e-161, 0.0, 1e-162, 1.0, 2.0, 2.0, 0.0], 4);
        assert!((t.norm_of(&[0.0, 1.0]) - 3.0).abs() < 1e-12 && t.norm_of(&[1.0, 0.0]).is_finite());
    }

    /// `[[1, 1], [e, -e]]`: two nearly equal columns keep the digits of their difference.
    #[test]
    fn a_small_difference_keeps_its_digits() {
        let e = 1e-9;
        let mut t = RFactor::new(2);
        t.absorb(&mut [1.0, 1.0], 1);
        t.absorb(&mut [e, -e], 1);
        assert!((t.get(1, 1).abs() / (2.0 * e) - 1.0).abs() < 1e-9, "{}", t.get(1, 1));
        let mut turned = RFactor::new(2);
        turned.absorb(&mut [-1.0, -1.0], 1);
        turned.absorb(&mut [e, -e], 1);
        assert!((turned.get(1, 1).abs() / (2.0 * e) - 1.0).abs() < 1e-9, "{}", turned.get(1, 1));
    }

    #[test]
    fn empty_and_zero() {
        let mut t = RFactor::new(3);
        t.absorb(&mut [], 0);
        t.absorb(&mut [0.0; 12], 4);
        assert_eq!(t, RFactor::new(3));
        RFactor::new(0).absorb(&mut [], 5);
    }
}
