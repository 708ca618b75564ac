//! Small systems of linear equations, in place.

use super::real::root;

/// Places for rows: a power of two, so that a masked index is in bounds.
const PLACES: usize = 16;
const MASK: usize = PLACES - 1;

/// Up to 16 rows of `C` columns, of which the first are the matrix and the others right-hand sides.
pub(super) type Rows<const C: usize> = [[f64; C]; PLACES];

/// Gaussian elimination of the first `N` rows and columns, the largest pivot first; the columns
/// beyond go along. Returns the determinant. `C` is a multiple of four.
#[inline(always)]
pub(super) fn eliminate<const N: usize, const C: usize>(a: &mut Rows<C>) -> f64 {
    let mut determinant = 1.0;
    for k in 0..N {
        let (mut at, mut most) = (k, a[k & MASK][k].abs());
        for r in k + 1..N {
            let size = a[r & MASK][k].abs();
            if size > most {
                (at, most) = (r, size);
            }
        }
        if at != k {
            (a[k & MASK], a[at & MASK]) = (a[at & MASK], a[k & MASK]);
            determinant = -determinant;
        }
        let top = a[k & MASK];
        determinant *= top[k];
        let reciprocal = if most > 0.0 { 1.0 / top[k] } else { 0.0 };
        for r in k + 1..N {
            let row = &mut a[r & MASK];
            let f = row[k] * reciprocal;
            // Whole registers: what stands left of the diagonal is not read again.
            for chunk in k / 4..C / 4 {
                for l in 0..4 {
                    row[4 * chunk + l] -= f * top[4 * chunk + l];
                }
            }
        }
    }
    determinant
}

/// Gaussian elimination like [`eliminate`], of complex rows.
#[inline(always)]
pub(super) fn eliminate_complex<const N: usize, const C: usize>(re: &mut Rows<C>, im: &mut Rows<C>) {
    for k in 0..N {
        let square = |re: &Rows<C>, im: &Rows<C>, r: usize| {
            re[r & MASK][k] * re[r & MASK][k] + im[r & MASK][k] * im[r & MASK][k]
        };
        let (mut at, mut most) = (k, square(re, im, k));
        for r in k + 1..N {
            let size = square(re, im, r);
            if size > most {
                (at, most) = (r, size);
            }
        }
        (re[k & MASK], re[at & MASK]) = (re[at & MASK], re[k & MASK]);
        (im[k & MASK], im[at & MASK]) = (im[at & MASK], im[k & MASK]);
        let (top, top_im) = (re[k & MASK], im[k & MASK]);
        let n = 1.0 / (most + 1e-290);
        for r in k + 1..N {
            let (row, row_im) = (&mut re[r & MASK], &mut im[r & MASK]);
            let f = n * (row[k] * top[k] + row_im[k] * top_im[k]);
            let g = n * (row_im[k] * top[k] - row[k] * top_im[k]);
            for chunk in k / 4..C / 4 {
                for l in 0..4 {
                    let (x, y) = (top[4 * chunk + l], top_im[4 * chunk + l]);
                    row[4 * chunk + l] -= f * x - g * y;
                    row_im[4 * chunk + l] -= f * y + g * x;
                }
            }
        }
    }
}

/// `U x = b` of an eliminated matrix. A pivot that vanishes counts as `least`.
#[inline(always)]
pub(super) fn back<const N: usize, const C: usize>(a: &Rows<C>, b: &[f64; N], least: f64) -> [f64; N] {
    let mut x = *b;
    for i in (0..N).rev() {
        let row = &a[i & MASK];
        let mut sum = x[i];
        for j in i + 1..N {
            sum -= row[j] * x[j];
        }
        let pivot = if row[i].abs() < least { least } else { row[i] };
        x[i] = sum / pivot;
    }
    x
}

/// The direction that an eliminated matrix takes nearest to zero: `U x = 1`, of length one.
#[inline(always)]
pub(super) fn kernel<const N: usize, const C: usize>(a: &Rows<C>) -> [f64; N] {
    let x = back(a, &[1.0; N], 1e-150);
    // The largest first: the squares could overflow.
    let most = x.iter().fold(1e-300f64, |m, x| m.max(x.abs()));
    let x = x.map(|x| x / most);
    let n = root(x.iter().fold(0.0, |s, x| s + x * x));
    x.map(|x| x / n)
}
