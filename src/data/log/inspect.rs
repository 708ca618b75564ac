//! Summarises the channels of a file and proposes a mapping to the columns of the log format.

use super::{Block, Channel, LogError, Mapping, Quantity, Role, SourceJoint, Table, unit};

/// Summary of a channel over the whole file.
#[derive(Debug, Clone, PartialEq)]
pub struct ChannelSummary {
    /// Name of the channel in the file.
    pub name: String,
    /// Number of numeric samples.
    pub samples: u64,
    /// Number of samples that are not finite numbers.
    pub missing: u64,
    /// Smallest and largest value; `[inf, -inf]` without samples.
    pub range: [f64; 2],
    /// Largest difference between consecutive samples.
    pub largest_step: f64,
    /// Stamps of its samples, if there is a clock.
    pub clock: Option<ClockSummary>,
}

/// Summary of the stamps of a channel, in the clock's unit.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ClockSummary {
    /// Duration from the first to the last sample of each part between restarts, summed.
    pub duration: f64,
    /// Longest time between two samples.
    pub longest_gap: f64,
    /// How often the stamp fell: a new recording begins there.
    pub restarts: u64,
}

/// Accumulates the summary of a channel.
#[derive(Debug, Clone)]
pub(super) struct Summing {
    summary: ChannelSummary,
    last: Option<f64>,
    last_stamp: Option<f64>,
}

impl Summing {
    pub(super) fn new(name: &str) -> Self {
        let summary = ChannelSummary {
            name: name.into(),
            samples: 0,
            missing: 0,
            range: [f64::INFINITY, f64::NEG_INFINITY],
            largest_step: 0.0,
            clock: None,
        };
        Self { summary, last: None, last_stamp: None }
    }

    /// Adds a sample, with its stamp if there is a clock.
    pub(super) fn add(&mut self, time: Option<f64>, value: f64) {
        let s = &mut self.summary;
        if !value.is_finite() {
            s.missing += 1;
            return;
        }
        s.samples += 1;
        s.range = [s.range[0].min(value), s.range[1].max(value)];
        if let Some(last) = self.last.replace(value) {
            s.largest_step = s.largest_step.max((value - last).abs());
        }
        if let Some(t) = time {
            let clock = s.clock.get_or_insert_default();
            let step = t - self.last_stamp.replace(t).unwrap_or(t);
            if step < 0.0 {
                clock.restarts += 1;
            } else {
                clock.duration += step;
                clock.longest_gap = clock.longest_gap.max(step);
            }
        }
    }

    pub(super) fn finish(self) -> ChannelSummary {
        self.summary
    }
}

impl ChannelSummary {
    /// Mean rate, samples per unit of the clock.
    pub fn rate(&self) -> Option<f64> {
        let ClockSummary { duration, restarts, .. } = self.clock?;
        (duration > 0.0).then(|| self.samples.saturating_sub(1 + restarts) as f64 / duration)
    }
}

/// Summarises all numeric columns of a table whose rows share one clock.
pub(super) fn summarise_rows<T: Table + ?Sized>(table: &mut T) -> Result<Vec<ChannelSummary>, LogError> {
    let names = table.names().to_vec();
    let columns: Vec<usize> = (0..names.len()).filter(|&i| table.is_numeric(i)).collect();
    let Some(&first) = columns.first() else { return Ok(Vec::new()) };
    let clock = columns.iter().position(|&i| is_time(&names[i]));
    table.select(&columns, clock.map_or(first, |c| columns[c]))?;
    let mut sums: Vec<Summing> = columns.iter().map(|&i| Summing::new(&names[i])).collect();
    let mut block = Block::default();
    loop {
        block.clear(columns.len());
        table.next_rows(8192, &mut block)?;
        if block.is_empty() {
            break;
        }
        for (sum, column) in sums.iter_mut().zip(&block.columns) {
            for (row, value) in column.iter().enumerate() {
                sum.add(clock.map(|c| block.columns[c][row]).filter(|t| t.is_finite()), *value);
            }
        }
    }
    Ok(sums.into_iter().map(Summing::finish).collect())
}

fn is_time(name: &str) -> bool {
    let words = words(unit::split(name).0);
    words.iter().any(|w| matches!(w.as_str(), "t" | "time" | "timestamp" | "stamp" | "secs" | "seconds" | "zeit"))
        && !words.iter().any(|w| w == "temp" || w == "delta")
}

/// Splits a name into lower-case words: between letters and digits, at punctuation, and before a
/// capital that follows a lower-case letter.
fn words(name: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut before = ' ';
    for c in name.chars() {
        let cut = !c.is_alphanumeric()
            || c.is_ascii_digit() != before.is_ascii_digit()
            || (c.is_uppercase() && before.is_lowercase());
        if cut && words.last().is_some_and(|w| !w.is_empty()) {
            words.push(String::new());
        }
        if c.is_alphanumeric()
            && let Some(word) = words.last_mut()
        {
            word.extend(c.to_lowercase());
        }
        before = c;
    }
    words.retain(|w| !w.is_empty());
    words
}

/// Quantity suggested by the words of a channel's name.
fn quantity(words: &[String]) -> Option<Quantity> {
    let has = |list: &[&str]| words.iter().any(|w| list.contains(&w.as_str()));
    if has(&["temp", "temperature"]) {
        return Some(Quantity::Temperature);
    }
    let wanted = has(&["desired", "target", "ref", "reference", "command", "cmd", "commanded", "setpoint", "des"]);
    let motor = has(&["motor", "rotor"]);
    let speed = has(&["velocity", "velocities", "vel", "speed", "dq", "qd", "qdot"]);
    let acceleration = has(&["acceleration", "accelerations", "acc", "ddq", "qdd"]);
    // LeRobot calls the positions `observation.state`.
    let observed = has(&["observation"]) && has(&["state"]);
    let position = observed || has(&["position", "positions", "pos", "angle", "angles", "q"]);
    let found = if has(&["current", "currents", "curr", "amps", "i"]) {
        Quantity::Current
    } else if has(&["torque", "torques", "tau", "effort", "efforts", "trq", "moment"]) {
        if motor { Quantity::Taum } else { Quantity::Tau }
    } else if acceleration {
        Quantity::Ddq
    } else if speed {
        Quantity::Dq
    } else if position {
        if motor { Quantity::Qm } else { Quantity::Q }
    } else {
        return None;
    };
    match (wanted, found) {
        (false, found) => Some(found),
        (true, Quantity::Q) => Some(Quantity::Qd),
        (true, _) => None,
    }
}

/// Channels that differ only in the joint, in joint order.
struct Group {
    pattern: String,
    quantity: Quantity,
    /// Joint index, from 0, and channel index.
    members: Vec<(usize, usize)>,
    /// Whether the name itself says that the channel is a measurement (`actual`, `feedback`, ..).
    measured: bool,
}

/// Mapping suggested by names and value ranges of channels; none of it is certain.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Proposal {
    /// Suggested mapping.
    pub mapping: Mapping,
    /// Reason for each of its columns, and alternatives.
    pub reasons: Vec<String>,
    /// Required channels that were not found.
    pub missing: Vec<String>,
}

/// Suggests a mapping. `joints`: names of the robot's moving joints, if known.
pub fn propose(channels: &[ChannelSummary], joints: &[SourceJoint]) -> Proposal {
    let mut proposal = Proposal::default();
    match channels.iter().find(|c| is_time(&c.name)) {
        Some(time) => propose_time(time, &mut proposal),
        // Messages carry their own stamps; the names of their channels begin with the topic.
        None if channels.iter().all(|c| c.name.starts_with('/')) => {}
        None => proposal.missing.push("t (time)".into()),
    }
    let groups = groups(channels, joints);
    let dof = if joints.is_empty() {
        let largest = |of: &dyn Fn(&Group) -> bool| groups.iter().filter(|g| of(g)).map(|g| g.members.len()).max();
        largest(&|g| g.quantity == Quantity::Q).or_else(|| largest(&|_| true)).unwrap_or(0)
    } else {
        joints.len()
    };
    for (quantity, prefix) in Quantity::ALL {
        let mut fitting: Vec<&Group> =
            groups.iter().filter(|g| g.quantity == quantity && g.members.len() == dof).collect();
        // Channels named as measured come first; the stable sort keeps the file's order otherwise.
        fitting.sort_by_key(|g| !g.measured);
        let Some(group) = fitting.first() else {
            if matches!(quantity, Quantity::Q) {
                proposal.missing.push("q1.. (positions of all joints)".into());
            }
            continue;
        };
        let members: Vec<&ChannelSummary> = group.members.iter().map(|&(_, i)| &channels[i]).collect();
        let (unit, mut reason) = guess_unit(quantity, &members);
        if fitting.len() > 1 {
            let others: Vec<&str> = fitting[1..].iter().map(|g| g.pattern.as_str()).collect();
            reason += &format!("; it may also be {}", others.join(", "));
        }
        let channel = Channel { name: group.pattern.clone(), unit, gain: Vec::new(), offset: Vec::new() };
        proposal.mapping.columns.push((format!("{prefix}*"), channel));
        proposal.reasons.push(reason);
    }
    let has = |prefix: &str| proposal.mapping.columns.iter().any(|(c, _)| c == prefix);
    if !["tau*", "taum*", "i*"].into_iter().any(has) {
        proposal.missing.push("tau1.. (torques), or i1.. (motor currents)".into());
    }
    proposal
}

fn propose_time(time: &ChannelSummary, proposal: &mut Proposal) {
    let given = unit::split(&time.name).1.filter(|u| unit::scale(u, Role::Time).is_ok());
    let rate = time.rate().unwrap_or(f64::NAN);
    // Plausible logging rates of robots: 5 Hz to 20 kHz.
    let fits = |per_second: f64| (5.0..=2e4).contains(&(rate * per_second));
    let (unit, reason) = match given {
        Some(unit) => (Some(unit.to_string()), "the unit stands in its name".to_string()),
        None => match [("s", 1.0), ("ms", 1e3), ("us", 1e6), ("ns", 1e9)].into_iter().find(|(_, f)| fits(*f)) {
            Some((unit, f)) => {
                ((unit != "s").then(|| unit.to_string()), format!("{:.5} Hz if it is in {unit}", rate * f))
            }
            None => (None, "its unit is not clear from its steps".into()),
        },
    };
    let channel = Channel { name: time.name.clone(), unit, gain: Vec::new(), offset: Vec::new() };
    proposal.mapping.columns.push(("t".into(), channel));
    proposal.reasons.push(reason);
}

/// Unit given in the name or suggested by the range; `None`: SI.
fn guess_unit(quantity: Quantity, members: &[&ChannelSummary]) -> (Option<String>, String) {
    let role = Role::Joint(quantity, 0);
    if let Some(given) = unit::split(&members[0].name).1.filter(|u| unit::scale(u, role).is_ok()) {
        return (Some(given.into()), "the unit stands in the name".into());
    }
    let largest = members.iter().flat_map(|m| m.range).map(f64::abs).filter(|v| v.is_finite()).fold(0.0, f64::max);
    if largest == 0.0 {
        return (None, "zero throughout: nothing was measured".into());
    }
    let shown = format!("up to {largest:.4}");
    match quantity {
        Quantity::Q | Quantity::Qm | Quantity::Qd if largest > 3.0 * std::f64::consts::PI => {
            (Some("deg".into()), format!("{shown}: too large for rad"))
        }
        Quantity::Dq if largest > 30.0 => (Some("deg/s".into()), format!("{shown}: too large for rad/s")),
        Quantity::Current if largest > 200.0 => (Some("mA".into()), format!("{shown}: too large for A")),
        Quantity::Tau | Quantity::Taum if largest > 5000.0 => {
            (Some("N mm".into()), format!("{shown}: too large for N m"))
        }
        _ => (None, shown),
    }
}

fn groups(channels: &[ChannelSummary], joints: &[SourceJoint]) -> Vec<Group> {
    let mut groups: Vec<Group> = Vec::new();
    for (i, channel) in channels.iter().enumerate() {
        let plain = unit::split(&channel.name).0;
        // Names of the log format keep their meaning without a mapping.
        let own = Role::of(plain).and_then(|role| if let Role::Joint(own, _) = role { Some(own) } else { None });
        let Some(found) = own.or_else(|| quantity(&words(plain))) else { continue };
        if is_time(&channel.name) {
            continue;
        }
        for (pattern, joint) in patterns(&channel.name, joints) {
            let group = match groups.iter_mut().find(|g| g.pattern == pattern && g.quantity == found) {
                Some(group) => group,
                None => {
                    let measured = words(&pattern).iter().any(|w| {
                        matches!(
                            w.as_str(),
                            "actual" | "measured" | "meas" | "feedback" | "sensed" | "state" | "states"
                        )
                    });
                    groups.push(Group { pattern, quantity: found, members: Vec::new(), measured });
                    groups.last_mut().expect("just pushed")
                }
            };
            group.members.push((joint, i));
        }
    }
    for group in &mut groups {
        group.members.sort_unstable();
    }
    // A group must contain each joint exactly once, without gaps.
    groups.retain(|g| g.members.iter().enumerate().all(|(place, (joint, _))| place == *joint));
    groups
}

/// Patterns of the name with the joint replaced by a placeholder, and the joint's index from 0.
fn patterns(name: &str, joints: &[SourceJoint]) -> Vec<(String, usize)> {
    let named = joints.iter().enumerate().filter(|(_, j)| !j.name.is_empty() && name.contains(&j.name));
    // Takes the longest matching name, since `joint1` is contained in `joint10`.
    if let Some((joint, source)) = named.max_by_key(|(_, j)| j.name.len()) {
        return vec![(name.replacen(&source.name, "{joint}", 1), joint)];
    }
    let digits = |c: char| c.is_ascii_digit();
    let Some(end) = name.rfind(digits).map(|i| i + 1) else { return Vec::new() };
    let start = name[..end].trim_end_matches(|c: char| c.is_ascii_digit()).len();
    let Ok(number) = name[start..end].parse::<usize>() else { return Vec::new() };
    let with = |mark: &str| format!("{}{mark}{}", &name[..start], &name[end..]);
    let from_one = number.checked_sub(1).map(|joint| (with("{number}"), joint));
    std::iter::once((with("{index}"), number)).chain(from_one).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn channel(name: &str, range: [f64; 2]) -> ChannelSummary {
        let clock = Some(ClockSummary { duration: 10.0, longest_gap: 0.02, restarts: 0 });
        ChannelSummary { name: name.into(), samples: 1001, missing: 0, range, largest_step: 0.1, clock }
    }

    fn named(proposal: &Proposal, column: &str) -> Option<(String, Option<String>)> {
        proposal.mapping.columns.iter().find(|(c, _)| c == column).map(|(_, c)| (c.name.clone(), c.unit.clone()))
    }

    #[test]
    fn a_ur_log_is_mapped() {
        let mut channels = vec![channel("timestamp", [0.0, 10.0])];
        for i in 0..6 {
            for part in ["target_q", "actual_q", "actual_qd", "actual_current", "joint_temperatures"] {
                channels.push(channel(&format!("{part}_{i}"), [-2.0, 2.0]));
            }
        }
        let found = propose(&channels, &[]);
        assert_eq!(named(&found, "q*"), Some(("actual_q_{index}".into(), None)));
        assert_eq!(named(&found, "qd*"), Some(("target_q_{index}".into(), None)));
        assert_eq!(named(&found, "dq*"), Some(("actual_qd_{index}".into(), None)));
        assert_eq!(named(&found, "i*"), Some(("actual_current_{index}".into(), None)));
        assert!(found.missing.is_empty(), "{:?}", found.missing);
    }

    #[test]
    fn degrees_milliseconds_and_milliamperes_are_seen() {
        let mut time = channel("Time", [0.0, 10_000.0]);
        time.clock = Some(ClockSummary { duration: 10_000.0, longest_gap: 10.0, restarts: 0 });
        let channels = [time, channel("Axis 1 Pos", [-170.0, 100.0]), channel("Axis 1 Current", [-900.0, 900.0])];
        let found = propose(&channels, &[]);
        assert_eq!(named(&found, "t"), Some(("Time".into(), Some("ms".into()))));
        assert_eq!(named(&found, "q*"), Some(("Axis {number} Pos".into(), Some("deg".into()))));
        assert_eq!(named(&found, "i*").unwrap().1.as_deref(), Some("mA"));
    }

    #[test]
    fn the_formats_own_names_stay_what_they_are() {
        let ranges = [("t", [0.0, 10.0]), ("q1", [0.0, 1.0]), ("qd1", [0.0, 1.0]), ("qm1", [0.0, 1.0])];
        let torques = [("tau1", [0.0, 0.0]), ("taum1", [-3.0, 3.0])];
        let channels: Vec<_> = ranges.into_iter().chain(torques).map(|(name, range)| channel(name, range)).collect();
        let found = propose(&channels, &[]);
        for (column, name) in [("q*", "q"), ("qd*", "qd"), ("qm*", "qm"), ("tau*", "tau"), ("taum*", "taum")] {
            assert_eq!(named(&found, column).unwrap().0, format!("{name}{{number}}"));
        }
        let torque = found.mapping.columns.iter().position(|(column, _)| column == "tau*").unwrap();
        assert!(found.reasons[torque].contains("nothing was measured"), "{:?}", found.reasons);
    }

    /// Recordings in one file, each with a clock of its own, have the rate of one recording.
    #[test]
    fn a_clock_that_restarts_keeps_its_rate() {
        let mut sum = Summing::new("q1");
        (0..303).for_each(|k| sum.add(Some(f64::from(k % 101) * 0.005), 0.0));
        let found = sum.finish();
        let clock = found.clock.unwrap();
        assert_eq!(clock.restarts, 2);
        assert!((clock.duration - 1.5).abs() < 1e-9 && (clock.longest_gap - 0.005).abs() < 1e-9);
        assert!((found.rate().unwrap() - 200.0).abs() < 1e-6);
    }

    #[test]
    fn stamps_of_messages_are_the_time() {
        let channels = ["/joint_states/position/a", "/joint_states/effort/a"].map(|name| channel(name, [0.0, 1.0]));
        let joints = [SourceJoint { name: "a".into(), sign: 1.0, offset: 0.0 }];
        assert!(propose(&channels, &joints).missing.is_empty());
        let table = ["observation.state[0]", "observation.effort[0]"].map(|name| channel(name, [0.0, 1.0]));
        let found = propose(&table, &[]);
        assert_eq!(named(&found, "q*").unwrap().0, "observation.state[{index}]");
        assert_eq!(found.missing, ["t (time)"]);
    }

    #[test]
    fn joints_by_name_in_any_order() {
        let joints: Vec<SourceJoint> =
            ["a", "bee"].map(|n| SourceJoint { name: n.into(), sign: 1.0, offset: 0.0 }).to_vec();
        let channels = [channel("bee position", [0.0, 1.0]), channel("x position", [0.0, 1.0])];
        assert!(named(&propose(&channels, &joints), "q*").is_none());
        assert!(propose(&channels, &joints).missing.iter().any(|m| m.contains("q1")));
    }
}
