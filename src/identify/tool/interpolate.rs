//! Estimates length and width of a tool that is not in the table from similar tools that are: the
//! paper's future work (section VII).
//!
//! Tools of one make differ in length and width alone, and their parameters are smooth in both.
//! Masses of straight parts grow with the size, first moments with its square, tensors with its
//! cube. A polynomial `f(length, width)` is fitted to the family's entries of the table, and
//! inverted by generalised least squares: `min (Phi - f)' S^-1 (Phi - f)`. `S = C + C_t + C_f` is
//! the covariance of the identification, of the table's tolerance, and of the polynomial's error
//! (from leaving one out). The minimum has a chi-squared distribution, so a tool outside the family
//! is reported.

use nalgebra::{DMatrix, DVector, Matrix2, SMatrix, SVector, Vector2};
use statrs::distribution::{ContinuousCDF, FisherSnedecor, StudentsT};

use super::identify::Carried;
use super::recognise::scale_freedom;
use super::table::{Entry, Tolerance, family};

/// A value with its confidence interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    /// Best estimate, m.
    pub value: f64,
    /// Standard deviation, m.
    pub std: f64,
    /// Limits of the 95 % confidence interval, m.
    pub ends: [f64; 2],
}

/// A tool estimated as a member of a family.
#[derive(Debug, Clone, PartialEq)]
pub struct Relative {
    /// Name of the family: `roller`.
    pub family: String,
    /// Number of the table's tools used for the interpolation.
    pub members: usize,
    /// Length from the mount to the far end.
    pub length: Interval,
    /// Width of the working part.
    pub width: Interval,
    /// Mahalanobis distance from the nearest possible member of the family.
    pub distance: f64,
    /// Distance beyond which the tool is not a member.
    pub limit: f64,
    /// Whether the tool can be a member.
    pub fits: bool,
    /// Whether length or width lie outside the range of the table.
    pub extrapolated: bool,
}

impl Relative {
    /// Whether the table's tool of this name belongs to the family.
    pub fn family_of(&self, name: &str) -> bool {
        family(name).is_some_and(|f| f == self.family)
    }
}

/// Terms of `f`: exponents of length and width.
const TERMS: [&[(i32, i32)]; 3] =
    [&[(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2)], &[(0, 0), (1, 0), (0, 1), (1, 1)], &[(0, 0), (1, 0), (0, 1)]];

/// Parameters of a family as a function of the tool's size.
#[derive(Debug, Clone, PartialEq)]
struct Family {
    name: String,
    sizes: Vec<[f64; 2]>,
    /// Middle and half width of the ranges of length and width, m.
    range: [[f64; 2]; 2],
    terms: &'static [(i32, i32)],
    /// Coefficients, `terms * 10`.
    coefficients: DMatrix<f64>,
    /// Covariance of the polynomial's error.
    misfit: SMatrix<f64, 10, 10>,
}

impl Family {
    fn new(name: &str, members: &[&Entry]) -> Option<Self> {
        let sizes: Vec<[f64; 2]> = members.iter().filter_map(|e| e.geometry.map(|g| [g.length, g.width])).collect();
        let range = [0, 1].map(|k| {
            let (low, high) =
                sizes.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), s| (l.min(s[k]), h.max(s[k])));
            [0.5 * (low + high), 0.5 * (high - low)]
        });
        if sizes.len() != members.len() || range.iter().any(|[_, half]| half.is_nan() || *half <= 0.0) {
            return None;
        }
        let values = DMatrix::from_fn(members.len(), 10, |i, k| members[i].values[k]);
        TERMS.into_iter().find_map(|terms| {
            // Two more tools than terms, so that leaving one out still leaves a residual.
            if sizes.len() < terms.len() + 2 {
                return None;
            }
            let design = DMatrix::from_fn(sizes.len(), terms.len(), |i, k| term(terms[k], &range, &sizes[i]));
            let root = (design.transpose() * &design).cholesky()?;
            let coefficients = root.solve(&(design.transpose() * &values));
            let rest = &values - &design * &coefficients;
            let mut misfit = SMatrix::<f64, 10, 10>::zeros();
            for i in 0..sizes.len() {
                // If left out, the residual grows by 1 / (1 - h_ii).
                let row: DVector<f64> = design.row(i).transpose();
                let leverage = row.dot(&root.solve(&row));
                // A corner that alone determines a term can't be left out: this basis is too rich
                // for this table.
                if leverage > 1.0 - 1e-6 {
                    return None;
                }
                let missed = SVector::<f64, 10>::from_fn(|k, _| rest[(i, k)] / (1.0 - leverage));
                misfit += missed * missed.transpose() / sizes.len() as f64;
            }
            Some(Self { name: name.into(), sizes: sizes.clone(), range, terms, coefficients, misfit })
        })
    }

    fn at(&self, size: &[f64; 2]) -> [f64; 10] {
        let row = DVector::from_fn(self.terms.len(), |k, _| term(self.terms[k], &self.range, size));
        let values = self.coefficients.transpose() * row;
        std::array::from_fn(|k| values[k])
    }
}

/// Term `x^a y^b` of length and width, each scaled to -1 .. 1 over the table.
fn term((a, b): (i32, i32), range: &[[f64; 2]; 2], size: &[f64; 2]) -> f64 {
    let [x, y] = [0, 1].map(|k| (size[k] - range[k][0]) / range[k][1]);
    x.powi(a) * y.powi(b)
}

/// Family that fits the tool best, with the tool's size; `None` if the table has no family (see
/// [`Entry::family`]) of at least five tools of several lengths and widths.
pub fn interpolate(carried: &Carried, table: &[Entry], tolerance: &Tolerance, level: f64) -> Option<Relative> {
    let mut names: Vec<String> = table.iter().filter_map(Entry::family).collect();
    names.sort();
    names.dedup();
    let kept: Vec<usize> = (0..10).filter(|&k| carried.determined()[k]).collect();
    if kept.len() < 4 {
        return None;
    }
    let found = names.iter().filter_map(|name| {
        let members: Vec<&Entry> = table.iter().filter(|e| e.family().as_ref() == Some(name)).collect();
        relative(carried, &Family::new(name, &members)?, &kept, tolerance, level)
    });
    // A family in which the tool lies between others is better evidence than one that must be
    // extrapolated.
    let rank = |r: &Relative| (!r.fits, r.extrapolated);
    found.min_by(|a, b| rank(a).cmp(&rank(b)).then((a.distance / a.limit).total_cmp(&(b.distance / b.limit))))
}

/// Gauss-Newton descent from the best member of the family, with a shorter step if the full one
/// increases the cost.
fn relative(carried: &Carried, family: &Family, kept: &[usize], tolerance: &Tolerance, level: f64) -> Option<Relative> {
    let n = kept.len();
    let whitener = |size: &[f64; 2]| {
        let table = tolerance.covariance(&family.at(size)) + family.misfit;
        let sum = DMatrix::from_fn(n, n, |i, k| carried.covariance[10 * kept[i] + kept[k]] + table[(kept[i], kept[k])]);
        let floor = DMatrix::from_fn(n, n, |i, k| if i == k { 1e-12 * sum[(i, i)] } else { 0.0 });
        (sum + floor).cholesky()
    };
    let difference = |size: &[f64; 2]| {
        let values = family.at(size);
        DVector::from_fn(n, |i, _| carried.values[kept[i]] - values[kept[i]])
    };
    let start = |size: &&[f64; 2]| whitener(size).map_or(f64::INFINITY, |root| cost(&root, &difference(size)));
    let mut size = *family.sizes.iter().min_by(|a, b| start(a).total_cmp(&start(b)))?;
    let mut information = Matrix2::zeros();
    let mut root = whitener(&size)?;
    for _ in 0..50 {
        root = whitener(&size)?;
        let slope = DMatrix::from_fn(n, 2, |i, k| {
            let step = 1e-4 * family.range[k][1];
            let (mut ahead, mut behind) = (size, size);
            ahead[k] += step;
            behind[k] -= step;
            (family.at(&ahead)[kept[i]] - family.at(&behind)[kept[i]]) / (2.0 * step)
        });
        let weighted = root.solve(&slope);
        let normal = slope.transpose() * &weighted;
        information = Matrix2::from_fn(|i, k| normal[(i, k)]);
        let gradient = weighted.transpose() * difference(&size);
        let step = information.try_inverse()? * Vector2::new(gradient[0], gradient[1]);
        let here = cost(&root, &difference(&size));
        let mut share = 1.0;
        let next = loop {
            let next = [size[0] + share * step[0], size[1] + share * step[1]];
            if cost(&root, &difference(&next)) <= here {
                break Some(next);
            }
            share *= 0.5;
            if share < 1e-6 {
                break None;
            }
        };
        let Some(next) = next else { break };
        let moved = (0..2).map(|k| (next[k] - size[k]).abs() / family.range[k][1]).fold(0.0, f64::max);
        size = next;
        if moved < 1e-9 {
            break;
        }
    }
    let distance = cost(&root, &difference(&size)).sqrt();
    let covariance = information.try_inverse()?;
    let freedom = scale_freedom(carried);
    let unknowns = (n - 2) as f64;
    let limit = (unknowns * FisherSnedecor::new(unknowns, freedom).ok()?.inverse_cdf(1.0 - level)).sqrt();
    let reach = StudentsT::new(0.0, 1.0, freedom).ok()?.inverse_cdf(0.975);
    let interval = |k: usize| {
        let std = covariance[(k, k)].max(0.0).sqrt();
        Interval { value: size[k], std, ends: [size[k] - reach * std, size[k] + reach * std] }
    };
    let beyond = |by: f64| (0..2).any(|k| (size[k] - family.range[k][0]).abs() > by * family.range[k][1]);
    let finite = distance.is_finite() && size.iter().all(|s| s.is_finite());
    finite.then(|| Relative {
        family: family.name.clone(),
        members: family.sizes.len(),
        length: interval(0),
        width: interval(1),
        distance,
        limit,
        // Beyond the table's ends by half its range the polynomial is meaningless.
        fits: distance <= limit && size.iter().all(|s| *s > 0.0) && !beyond(2.0),
        // A tenth of the range beyond the ends is tolerated.
        extrapolated: beyond(1.2),
    })
}

fn cost(root: &nalgebra::Cholesky<f64, nalgebra::Dyn>, difference: &DVector<f64>) -> f64 {
    difference.dot(&root.solve(difference))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::prng::Random;
    use dh_codegen::robot::ToolGeometry;

    /// The polynomial's error is that of each tool when it is left out of the fit.
    #[test]
    fn the_misfit_is_that_of_leaving_one_out() {
        let mut random = Random::new(4);
        let entries: Vec<Entry> = (0..9)
            .map(|k| {
                let (length, width) = (0.2 + 0.03 * f64::from(k), 0.1 + 0.05 * f64::from(k * 2 % 5));
                let values = std::array::from_fn(|i| length * (1.0 + i as f64) + width * width + random.even(0.02));
                Entry {
                    name: format!("roller-{k}"),
                    values,
                    covariance: SMatrix::zeros(),
                    geometry: Some(ToolGeometry { length, width }),
                    pose: ([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], [0.0; 3]),
                }
            })
            .collect();
        let members: Vec<&Entry> = entries.iter().collect();
        let family = Family::new("roller", &members).unwrap();
        let design =
            DMatrix::from_fn(9, family.terms.len(), |i, k| term(family.terms[k], &family.range, &family.sizes[i]));
        let mut expected = SMatrix::<f64, 10, 10>::zeros();
        for out in 0..9 {
            let others = design.clone().remove_row(out);
            let values = DMatrix::from_fn(8, 10, |i, k| entries[i + usize::from(i >= out)].values[k]);
            let fitted = others.svd(true, true).solve(&values, 1e-12).unwrap();
            let row = design.row(out) * fitted;
            let missed = SVector::<f64, 10>::from_fn(|k, _| entries[out].values[k] - row[k]);
            expected += missed * missed.transpose() / 9.0;
        }
        assert!((family.misfit - expected).norm() < 1e-8 * expected.norm(), "{} {expected}", family.misfit);
    }
}
