//! A simulation as text.

use crate::data::log::Quantity;
use crate::numerics::sums::root_mean_square;
use crate::report::Warnings;
use crate::simulate::{Method, Mode, Recording, Request};

/// Report of a simulation: torques, tracking error and speed; `seconds` is the run time.
pub fn simulate_text(
    robot: &str,
    recording: &Recording,
    request: &Request,
    seconds: f64,
    warnings: &Warnings,
) -> String {
    let Recording { log, truth, .. } = recording;
    let (n, len) = (log.layout.dof, log.len());
    let span = truth.t[len - 1] - truth.t[0];
    let mode = Mode::ALL.iter().find(|(_, mode)| *mode == request.control.mode).map_or("", |(name, _)| name);
    let how = match recording.integration {
        Some(i) => {
            let method = match i.method {
                Method::DormandPrince => "Dormand-Prince 5(4)",
                Method::Auto | Method::Rosenbrock => "ROS34PW2",
            };
            format!("{method}, {} steps, {} taken again", i.steps, i.rejected)
        }
        None => "motion followed exactly".into(),
    };
    let mut out = format!(
        "{robot}: {} s of motion, {len} samples at {} Hz, control {mode}, seed {}\n{how}\n",
        span, request.sensors.rate, request.seed
    );
    let row = |values: Vec<f64>| values.into_iter().map(|v| format!("{v:>10.4}")).collect::<String>();
    let of = |f: &dyn Fn(usize) -> f64| row((0..n).map(f).collect());
    out += &format!("{:<34}{}\n", "joint", (1..=n).map(|j| format!("{j:>10}")).collect::<String>());
    let tau = |j: usize| log.joint(Quantity::Tau, j).unwrap_or_default();
    out += &format!("{:<34}{}\n", "torque, rms (N m)", of(&|j| root_mean_square(tau(j))));
    out +=
        &format!("{:<34}{}\n", "torque, largest (N m)", of(&|j| tau(j).iter().fold(0.0, |a: f64, v| a.max(v.abs()))));
    if !matches!(request.control.mode, Mode::Free | Mode::Torque) {
        let off = |j: usize| {
            let range = j * len..(j + 1) * len;
            let offset = recording.drives[j].encoder_offset;
            let pairs = truth.motor_q[range.clone()].iter().zip(&truth.desired[range]);
            1e3 * pairs.map(|(q, d)| (q - offset - d[0]).abs()).fold(0.0, f64::max)
        };
        out += &format!("{:<34}{}\n", "largest following error (mrad)", of(&off));
    }
    out + &format!("{seconds:.2} s: {}\n", pace(span / seconds.max(1e-9))) + &warnings.text()
}

/// Ratio of simulated to computing time, in words.
fn pace(ratio: f64) -> String {
    match ratio {
        r if r >= 9.5 => format!("{r:.0} times faster than real time"),
        r if r >= 1.15 => format!("{r:.1} times faster than real time"),
        r if r > 0.87 => "about real time".into(),
        r => format!("{:.1} times slower than real time", r.recip()),
    }
}

#[cfg(test)]
mod tests {
    use super::pace;

    #[test]
    fn what_is_not_faster_is_not_called_faster() {
        let said = [120.0, 2.0, 1.04, 0.25].map(pace);
        let faster = "times faster than real time";
        assert_eq!(
            said,
            [
                format!("120 {faster}"),
                format!("2.0 {faster}"),
                "about real time".into(),
                "4.0 times slower than real time".into()
            ]
        );
    }
}
