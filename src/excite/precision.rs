//! Expected precision of the parameters after a motion, from the information alone:
//! `cov = (W' P W + prior)^-1`.

use nalgebra::DMatrix;

use crate::model::States;

use super::information::Information;
use super::task::Task;

/// Expected precision of one column.
#[derive(Debug, Clone, PartialEq)]
pub struct Expected {
    /// Name of the parameter.
    pub name: String,
    /// Nominal value, if known.
    pub value: Option<f64>,
    /// Standard deviation of its estimate, in the parameter's unit.
    pub std: f64,
    /// Whether its contribution to some joint's torque exceeds that torque's noise (RMS over the
    /// motion). `None` without a nominal value.
    pub essential: Option<bool>,
}

impl Expected {
    /// Standard deviation as a percentage of the nominal value.
    pub fn relative_percent(&self) -> Option<f64> {
        self.value.filter(|v| *v != 0.0).map(|v| 100.0 * self.std / v.abs())
    }
}

/// Nominal values of the selected base parameters, then of the payload in the tool frame if it is
/// selected and in the file.
pub fn nominal(task: &Task<'_>) -> Option<Vec<f64>> {
    let base = task.arm.base_parameters();
    let standard = task.standard.as_deref();
    let value = |b: &usize| base[*b].coefficients.iter().map(|&(i, c)| Some(c * standard?[i])).sum::<Option<f64>>();
    let mut values = task.base.iter().map(value).collect::<Option<Vec<f64>>>()?;
    values.extend(task.body.iter().filter(|_| task.payload).flatten());
    Some(values)
}

/// Expected precision after these states at the task's rate, with the task's noise (standard
/// deviation per sample, as if noise of successive samples were independent) and prior.
pub fn expected(task: &Task<'_>, states: &States) -> Vec<Expected> {
    let columns = task.columns();
    let plain = Task { scale: Vec::new(), ..task.clone() };
    let information = Information::new(&columns, states, &plain.scaling(1.0));
    let covariance = information.covariance();
    let values = nominal(task);
    let shares = information.torque_shares(&columns, &plain.scaling(1.0));
    let one = |(k, name): (usize, &String)| {
        let value = values.as_ref().and_then(|v| v.get(k).copied());
        Expected {
            name: name.clone(),
            value,
            std: covariance[(k, k)].max(0.0).sqrt(),
            essential: value.map(|v| v.abs() * shares[k] > 1.0),
        }
    };
    columns.names().iter().enumerate().map(one).collect()
}

/// Information from motions already played, with the task's noise.
pub fn known_from(task: &Task<'_>, played: &[States]) -> DMatrix<f64> {
    let columns = task.columns();
    let plain = Task { scale: Vec::new(), prior: None, ..task.clone() };
    let mut sum = DMatrix::zeros(columns.count(), columns.count());
    for states in played {
        sum += Information::new(&columns, states, &plain.scaling(1.0)).gram();
    }
    sum
}

/// Information of nominal values with this relative standard deviation. Values that are zero or
/// missing count as unknown.
pub fn known_values(task: &Task<'_>, share: f64) -> Option<DMatrix<f64>> {
    let values = nominal(task).filter(|values| !values.is_empty())?;
    let count = task.columns().count();
    let mut prior = DMatrix::zeros(count, count);
    for (k, value) in values.iter().enumerate().filter(|(_, v)| **v != 0.0) {
        prior[(k, k)] = 1.0 / (share * value).powi(2);
    }
    Some(prior)
}
