//! Fit of the true form: the best possible estimate of the size from the data.

use nalgebra::{DMatrix, DVector};

use super::addition::Addition;
use super::session::{Excerpt, Session};
use crate::model::{Arm, PerturbableArm, StandardParameter, States};

/// Number of averaged samples per second.
const RATE: f64 = 40.0;

/// Averages over an excerpt: states, torques with the addition, and the addition itself.
struct Averages {
    states: States,
    torque: Vec<Vec<f64>>,
    added: Vec<Vec<f64>>,
}

fn averages(session: &Session, e: &Excerpt, added: &[Vec<f64>]) -> Averages {
    let dof = session.numeric.dof();
    let t = e.time();
    let period = (t[t.len() - 1] - t[0]) / t.len().max(2) as f64;
    let per = ((1.0 / (RATE * period.max(1e-6))).round() as usize).max(1);
    let mean = |x: &[f64]| -> Vec<f64> { x.chunks_exact(per).map(|c| c.iter().sum::<f64>() / per as f64).collect() };
    let rows = |series: &[f64]| -> Vec<f64> { (0..dof).flat_map(|j| mean(e.of(series, j))).collect() };
    let states = States { len: t.len() / per, q: rows(&e.states.q), dq: rows(&e.states.dq), ddq: rows(&e.states.ddq) };
    let torque = (0..dof)
        .map(|j| mean(&e.torque(j).iter().zip(&added[j]).map(|(tau, by)| tau + by).collect::<Vec<f64>>()))
        .collect();
    Averages { states, torque, added: added.iter().map(|row| mean(row)).collect() }
}

/// Normal matrix, right-hand side, sum of squares and number of samples of a joint.
type Equations = (DMatrix<f64>, DVector<f64>, f64, f64);

/// Relative size found by least squares in all base parameters, friction and this form, from the
/// fitted logs with the addition of size `x`. It is 1 if the size is found exactly. The file's
/// bodies are kept if a refit of all of them would explain the addition.
pub(super) fn recovered(session: &Session, addition: &Addition, x: f64) -> f64 {
    let dof = session.numeric.dof();
    let base = session.plant.base_parameters();
    let given = session.plant.given().unwrap_or(&[]);
    let file: Vec<f64> =
        base.iter().map(|b| b.coefficients.iter().map(|(i, k)| k * given.get(*i).unwrap_or(&0.0)).sum()).collect();
    // Plain friction is already a parameter of the arm, and the size is relative to it.
    let row = |term| StandardParameter::Drive(session.plant.rows()[addition.joint()], term);
    let own = addition.form.plain().map(row);
    let open = |b: usize| {
        let leader = base[b].leader;
        (!addition.form.within_bodies() || leader.is_friction()) && own != Some(leader)
    };
    let unknowns = base.len() + 1;
    let mut grams: Vec<Equations> = vec![(DMatrix::zeros(unknowns, unknowns), DVector::zeros(unknowns), 0.0, 0.0); dof];
    for (number, e) in session.fit.iter().enumerate() {
        let signal = addition.signal(session, e, x, number == 0);
        let data = averages(session, e, &signal);
        let (len, pattern) = (data.states.len, session.plant.base_pattern());
        let mut entries = vec![0.0; pattern.len() * len];
        session.plant.base_regressor(&data.states, &mut entries);
        for (j, (gram, rhs, squares, count)) in grams.iter_mut().enumerate() {
            let entry: Vec<(usize, usize)> =
                pattern.iter().enumerate().filter(|(_, p)| p.0 == j).map(|(k, p)| (k, p.1)).collect();
            for s in 0..len {
                let mut y = data.torque[j][s];
                let mut row: Vec<(usize, f64)> = vec![(base.len(), data.added[j][s])];
                for &(k, b) in &entry {
                    let value = entries[k * len + s];
                    if open(b) { row.push((b, value)) } else { y -= file[b] * value }
                }
                for &(a, va) in &row {
                    rhs[a] += va * y;
                    row.iter().for_each(|&(b, vb)| gram[(a, b)] += va * vb);
                }
                (*squares, *count) = (*squares + y * y, *count + 1.0);
            }
        }
    }
    weighed(&grams)
}

/// Last unknown of the joints' equations, each joint weighted by the inverse variance of its
/// residual.
fn weighed(grams: &[Equations]) -> f64 {
    let unknowns = grams.first().map_or(0, |g| g.1.len());
    let mut weights: Vec<f64> = grams.iter().map(|g| if g.2 > 0.0 { g.3 / g.2 } else { 0.0 }).collect();
    let mut found = 0.0;
    for _ in 0..4 {
        let (mut matrix, mut right) = (DMatrix::zeros(unknowns, unknowns), DVector::zeros(unknowns));
        for ((gram, rhs, ..), weight) in grams.iter().zip(&weights) {
            matrix += gram * *weight;
            right += rhs * *weight;
        }
        let scale: Vec<f64> = (0..unknowns).map(|i| matrix[(i, i)].max(1e-30).sqrt()).collect();
        let scaled = DMatrix::from_fn(unknowns, unknowns, |i, k| matrix[(i, k)] / (scale[i] * scale[k]));
        let Ok(inverse) = scaled.pseudo_inverse(1e-9) else { return f64::NAN };
        let mut beta = inverse * DVector::from_fn(unknowns, |i, _| right[i] / scale[i]);
        (0..unknowns).for_each(|i| beta[i] /= scale[i]);
        found = beta[unknowns - 1];
        weights = grams
            .iter()
            .map(|(gram, rhs, squares, count)| {
                let left = squares - 2.0 * beta.dot(rhs) + beta.dot(&(gram * &beta));
                if *squares > 0.0 { count / left.max(1e-9 * squares) } else { 0.0 }
            })
            .collect();
    }
    found
}
