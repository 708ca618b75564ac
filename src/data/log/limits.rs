//! Compares the values of a log with the limits of the robot file.

use super::Finding;
use super::Kind;
use super::Reached;
use super::Severity;

/// Limits of a joint; infinite if the file has none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Smallest and largest position, rad or m.
    pub position: [f64; 2],
    /// Largest torque or force, N m or N.
    pub torque: f64,
    /// Whether the joint is prismatic.
    pub slides: bool,
}

/// Tolerance of a position limit as a share of the range, since zeros and end stops are not known
/// to the degree.
const POSITION: f64 = 0.1;
/// Tolerance factor of a torque limit: short peaks may reach twice the continuous torque.
const TORQUE: f64 = 2.0;

/// Factor beyond the limits, for half of the joints or more, above which torques are taken to be in
/// another unit.
const UNIT: f64 = 20.0;

/// Reports torques in another unit than the limits; fatal unless `allowed`.
pub fn torque_unit(reached: &[Reached], joints: &[Limits], allowed: bool) -> Option<Finding> {
    let size = |r: &Reached| r.range[0].abs().max(r.range[1].abs());
    let of = |number: usize| {
        let columns = ["tau", "taum", "i"].map(|name| format!("{name}{number}"));
        reached.iter().find(|r| columns.contains(&r.column))
    };
    let limited = (1..).zip(joints).filter(|(_, limits)| limits.torque.is_finite() && limits.torque > 0.0);
    let shares: Vec<f64> = limited.filter_map(|(number, limits)| Some(size(of(number)?) / limits.torque)).collect();
    let beyond = shares.iter().filter(|share| **share > UNIT).count();
    let times = shares.iter().fold(0.0_f64, |most, share| most.max(*share));
    let kind = Kind::TorqueUnit { times, thousandth: times < 1000.0 * TORQUE };
    let severity = if allowed { Severity::Warning } else { Severity::Fatal };
    (beyond > 0 && 2 * beyond >= shares.len()).then_some(Finding { kind, severity, line: None, column: None, count: 1 })
}

/// Range within which a joint counts as not moving, rad or m.
const STILL: f64 = 2e-3;

/// Reports columns far outside the limits of the joints (in joint order), which suggests another
/// robot, unit or column order, and a log in which no joint moves.
pub fn beyond_limits(reached: &[Reached], joints: &[Limits]) -> Vec<Finding> {
    let mut findings = Vec::new();
    let positions = || reached.iter().filter(|r| r.column.starts_with('q'));
    if positions().count() > 0 && positions().all(|r| r.range[1] - r.range[0] < STILL) {
        let kind = Kind::Standstill;
        findings.push(Finding { kind, severity: Severity::Warning, line: None, column: None, count: 1 });
    }
    for (number, limits) in (1..).zip(joints) {
        let of = |name: &str| reached.iter().find(|r| r.column == format!("{name}{number}"));
        let mut note = |column: &str, reaches: f64, limit: f64, unit: &'static str| {
            let kind = Kind::BeyondLimit { reaches, limit, unit };
            let column = Some(column.to_string());
            findings.push(Finding { kind, severity: Severity::Warning, line: None, column, count: 1 });
        };
        if let Some(Reached { column, range: [least, most] }) = of("q") {
            let ([low, high], unit) = (limits.position, if limits.slides { "m" } else { "rad" });
            let room = POSITION * (high - low);
            if room.is_finite() && *most > high + room {
                note(column, *most, high, unit);
            } else if room.is_finite() && *least < low - room {
                note(column, *least, low, unit);
            }
        }
        for name in ["tau", "taum", "i"] {
            let Some(Reached { column, range }) = of(name) else { continue };
            let size = range[0].abs().max(range[1].abs());
            if size > TORQUE * limits.torque {
                note(column, size, limits.torque, if limits.slides { "N" } else { "N m" });
            }
        }
    }
    findings
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn degrees_and_millinewtons_are_beyond() {
        let joint = Limits { position: [-2.0, 2.0], torque: 100.0, slides: false };
        let free = Limits { position: [f64::NEG_INFINITY, f64::INFINITY], torque: f64::INFINITY, slides: false };
        let log = |q: [f64; 2], tau: [f64; 2]| {
            vec![Reached { column: "q1".into(), range: q }, Reached { column: "tau1".into(), range: tau }]
        };
        assert!(beyond_limits(&log([-2.1, 2.3], [-150.0, 20.0]), &[joint]).is_empty());
        assert!(beyond_limits(&log([-90.0, 2.0], [-1e5, 20.0]), &[free]).is_empty());
        let millinewtons = torque_unit(&log([-0.5, 0.5], [-8e4, 20.0]), &[joint], false).unwrap();
        assert!(millinewtons.is_fatal() && millinewtons.to_string().contains("N mm"), "{millinewtons}");
        assert!(torque_unit(&log([-0.5, 0.5], [-150.0, 20.0]), &[joint], false).is_none());
        assert!(torque_unit(&log([-0.5, 0.5], [-8e4, 20.0]), &[free], false).is_none());
        let found = beyond_limits(&log([-9.0, 2.0], [-1e5, 20.0]), &[joint]);
        let said: Vec<String> = found.iter().map(ToString::to_string).collect();
        assert_eq!(beyond_limits(&log([0.5, 0.5001], [0.0, 1.0]), &[joint])[0].kind, Kind::Standstill);
        assert!(
            said[0].contains("`q1`: reaches -9.0000 rad") && said[1].contains("`tau1`: reaches 100000.0000 N m"),
            "{said:?}"
        );
    }
}
