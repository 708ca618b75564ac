//! Tests of `denavit eval`: all nine quantities against the numeric recursion, which shares no code
//! with it.

use denavit::model::rigid_body::Numeric;
use denavit::numerics::prng::Random;
use dh_codegen::arm::param;
use nalgebra::{DMatrix, DVector};

use super::*;

const STATES: usize = 4;

/// A robot file with links, states and torques, and the oracle for the results.
struct Bench {
    robot: String,
    states: String,
    oracle: Numeric,
    phi: Vec<f64>,
    rows: Vec<[Vec<f64>; 4]>,
}

impl Bench {
    /// Uses a robot of the repository; if its file has no links, bodies are added.
    fn new(name: &str) -> Self {
        let folder = folder(&format!("eval-{name}"));
        let mut random = Random::new(7);
        let mut robot = read_robot(&format!("robots/{name}.yaml"));
        if robot.links.is_empty() {
            robot.links = robot.joints.iter().map(|_| Some(random.inertia())).collect();
        }
        let (oracle, phi) = (Numeric::new(&robot), param::standard_values(&robot).unwrap());
        let n = oracle.dof();
        let rows: Vec<[Vec<f64>; 4]> = (0..STATES)
            .map(|_| {
                let [q, dq, ddq] = [2.5, 2.0, 4.0].map(|size| random.vector(n, size));
                let tau = oracle.inverse_dynamics(&q, &dq, &ddq, &phi).as_slice().to_vec();
                [q, dq, ddq, tau]
            })
            .collect();
        let lines: Vec<Vec<f64>> = rows.iter().map(|r| r.concat()).collect();
        Self {
            robot: file(&folder, "robot.yaml", robot.to_yaml()),
            states: file(&folder, "states.csv", csv(&columns(&["q", "dq", "ddq", "tau"], n), &lines)),
            oracle,
            phi,
            rows,
        }
    }

    fn eval(&self, quantity: &str) -> serde_json::Value {
        json(&["eval", &self.robot, "--quantity", quantity, "--states", &self.states, "--json", "-"])
    }

    /// Values of a quantity, with a check of its shape.
    fn values(&self, quantity: &str, [rows, cols]: [usize; 2]) -> Vec<DMatrix<f64>> {
        let said = self.eval(quantity);
        assert_eq!(said["quantity"], quantity);
        assert_eq!((said["rows"].as_u64(), said["cols"].as_u64()), (Some(rows as u64), Some(cols as u64)));
        assert_eq!(strings(&said["column_names"]).len(), cols);
        let values = said["values"].as_array().unwrap();
        assert_eq!(values.len(), STATES);
        values.iter().map(|v| DMatrix::from_row_slice(rows, cols, &numbers(v))).collect()
    }

    fn agrees(&self, quantity: &str, expected: impl Fn(&[Vec<f64>; 4]) -> DMatrix<f64>) {
        let first = expected(&self.rows[0]);
        for (found, row) in self.values(quantity, [first.nrows(), first.ncols()]).iter().zip(&self.rows) {
            let expected = expected(row);
            let error = (found - &expected).amax() / expected.amax().max(1.0);
            assert!(error < 1e-10, "{}: {quantity} is off by {error}", self.robot);
        }
    }
}

fn column(v: DVector<f64>) -> DMatrix<f64> {
    DMatrix::from_column_slice(v.len(), 1, v.as_slice())
}

fn all_quantities(name: &str) {
    let bench = Bench::new(name);
    let (arm, phi) = (&bench.oracle, &bench.phi);
    let arm_rows = read_robot(&bench.robot).joints.len();
    bench.agrees("forward_kinematics", |[q, ..]| DMatrix::from_fn(4, 4, |i, j| arm.frames(q)[arm_rows - 1][(i, j)]));
    bench.agrees("jacobian", |[q, ..]| DMatrix::from_column_slice(6, arm.dof(), arm.jacobian(q).as_slice()));
    bench.agrees("regressor", |[q, dq, ddq, _]| arm.regressor(q, dq, ddq));
    bench.agrees("inverse_dynamics", |[_, _, _, tau]| column(DVector::from_column_slice(tau)));
    bench.agrees("mass_matrix", |[q, ..]| arm.mass_matrix(q, phi));
    bench.agrees("coriolis", |[q, dq, ..]| column(arm.coriolis(q, dq, phi)));
    bench.agrees("gravity", |[q, ..]| column(arm.gravity(q, phi)));
    // A base parameter's column is that of its leader.
    let (said, all) = (bench.eval("base_regressor"), bench.eval("regressor"));
    let standard = strings(&all["column_names"]);
    let leaders: Vec<usize> = strings(&said["column_names"])
        .iter()
        .map(|base| standard.iter().position(|s| *s == base.strip_suffix('R').unwrap_or(base)).unwrap())
        .collect();
    bench.agrees("base_regressor", |[q, dq, ddq, _]| arm.regressor(q, dq, ddq).select_columns(&leaders));
    // Forward dynamics maps the torques of inverse dynamics back to the accelerations, as
    // accurately as the mass matrix's condition permits.
    for (found, [.., ddq, _]) in bench.values("forward_dynamics", [arm.dof(), 1]).iter().zip(&bench.rows) {
        for (a, b) in found.iter().zip(ddq) {
            assert!((a - b).abs() < 1e-8, "{name}: {a} is not {b}");
        }
    }
}

#[test]
fn kuka_lwr4() {
    all_quantities("kuka-lwr4");
}

#[test]
fn ur10e() {
    all_quantities("ur10e");
}

#[test]
fn stanford() {
    all_quantities("stanford");
}

/// Only the inputs of a quantity must be present and be numbers; other columns are ignored.
#[test]
fn columns_that_are_not_needed_are_not_looked_at() {
    let folder = folder("eval-columns");
    let states = file(&folder, "states.csv", "note, q1, dq1, q2\nfirst, 0.1, NaN, 0.2\nsecond, 0.3, oops, 0.4\n");
    let out = folder.join("gravity.json").display().to_string();
    let run = denavit(&["eval", "robots/planar2r.yaml", "--quantity", "gravity", "--states", &states, "--json", &out]);
    assert_eq!((run.status, run.out.as_str()), (Some(0), ""), "{}", run.err);
    let said: serde_json::Value = serde_json::from_slice(&std::fs::read(out).unwrap()).unwrap();
    assert_eq!(said["values"].as_array().unwrap().len(), 2);
}
