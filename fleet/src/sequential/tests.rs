use denavit::numerics::prng::Random;

use super::{Detector, Observed, Sequential};

/// Normal, by Box and Muller.
fn gauss(draws: &mut Random) -> f64 {
    let (u, v) = (draws.uniform(1e-300, 1.0), draws.uniform(0.0, std::f64::consts::TAU));
    (-2.0 * u.ln()).sqrt() * v.cos()
}

/// How a channel scatters from day to day, with variance 1.
#[derive(Debug, Clone, Copy)]
enum Scatter {
    Normal,
    /// Student's t of so many degrees of freedom.
    Heavy(usize),
    /// An autoregressive process of first order, in all channels or in every second.
    Correlated {
        rho: f64,
        every: usize,
    },
}

/// Days of a robot whose channels have means and scatters of their own.
struct Robot {
    draws: Random,
    means: Vec<f64>,
    scatters: Vec<f64>,
    /// Share of the scatter that all channels have in common.
    common: f64,
    scatter: Scatter,
    /// Last scatters: of the channels, and the common one.
    last: Vec<f64>,
}

impl Robot {
    fn new(seed: u64, channels: usize, common: f64, scatter: Scatter) -> Self {
        let mut draws = Random::new(seed);
        let means = (0..channels).map(|_| 10.0 * gauss(&mut draws)).collect();
        let scatters = (0..channels).map(|_| (2.0 * gauss(&mut draws)).exp()).collect();
        let last = (0..=channels).map(|_| gauss(&mut draws)).collect();
        Self { draws, means, scatters, common, scatter, last }
    }

    fn next(&mut self, channel: usize) -> f64 {
        let x = gauss(&mut self.draws);
        match self.scatter {
            Scatter::Normal => x,
            Scatter::Heavy(degrees) => {
                let n = degrees as f64;
                let squares: f64 = (0..degrees).map(|_| gauss(&mut self.draws).powi(2)).sum();
                x / (squares / n).sqrt() * ((n - 2.0) / n).sqrt()
            }
            Scatter::Correlated { rho, every } if channel.is_multiple_of(every) => {
                self.last[channel] = rho * self.last[channel] + (1.0 - rho * rho).sqrt() * x;
                self.last[channel]
            }
            Scatter::Correlated { .. } => x,
        }
    }

    fn day(&mut self) -> Vec<Observed> {
        let shared = self.next(self.means.len());
        (0..self.means.len())
            .map(|k| {
                let own = self.next(k);
                let x = self.common.sqrt() * shared + (1.0 - self.common).sqrt() * own;
                // Noise is a tenth of the scatter.
                let variance = 0.01 * self.scatters[k].powi(2);
                Observed { value: self.means[k] + self.scatters[k] * x, variance }
            })
            .collect()
    }
}

/// False alarms, and days on which there could have been one.
fn alarms(settings: Sequential, robots: u64, days: i32, common: f64, scatter: Scatter) -> (usize, f64) {
    let mut count = 0;
    for seed in 0..robots {
        let mut robot = Robot::new(1000 + seed, 20, common, scatter);
        let mut detector = Detector::new(settings);
        count += (0..days).filter(|day| detector.day(*day, None, &robot.day()).is_some()).count();
    }
    (count, robots as f64 * f64::from(days - settings.reference_days as i32))
}

const LAWS: [(&str, f64, Scatter); 8] = [
    ("normal", 0.0, Scatter::Normal),
    ("normal, half of the scatter in common", 0.5, Scatter::Normal),
    ("Student's t, 5 degrees", 0.0, Scatter::Heavy(5)),
    ("Student's t, 3 degrees", 0.0, Scatter::Heavy(3)),
    ("correlation 0.3 from day to day", 0.0, Scatter::Correlated { rho: 0.3, every: 1 }),
    ("correlation 0.6", 0.0, Scatter::Correlated { rho: 0.6, every: 1 }),
    ("correlation 0.5, half in common", 0.5, Scatter::Correlated { rho: 0.5, every: 1 }),
    ("correlation 0.6 in every second channel", 0.0, Scatter::Correlated { rho: 0.6, every: 2 }),
];

/// The stated rate holds for days with outliers and for days that follow each other.
fn rates(limit: f64, robots: u64, days: i32) -> Vec<(usize, f64)> {
    let settings = Sequential { days_between: limit, ..Sequential::default() };
    let rate = |(name, common, scatter): (&str, f64, Scatter)| {
        let (count, days) = alarms(settings, robots, days, common, scatter);
        println!("limit {limit}, {name}: {count} in {days} days, at most {:.1} stated", days / limit);
        (count, days / limit)
    };
    LAWS.into_iter().map(rate).collect()
}

#[test]
fn false_alarms_are_rarer_than_stated() {
    let all = rates(50.0, 30, 200);
    assert!(all.iter().all(|(count, stated)| (*count as f64) < *stated), "{all:?}");
    assert!(all[0].0 > 0, "a bound of which nothing is used");
}

/// `cargo test --release --lib -- --ignored --nocapture rates`
#[test]
#[ignore = "minutes"]
fn rates_of_many_robots() {
    for (limit, robots) in [(50.0, 60), (365.25, 200), (3652.5, 400)] {
        let all = rates(limit, robots, 200);
        assert!(all.iter().all(|(count, stated)| *count as f64 <= 1.5 * stated), "{all:?}");
    }
}

/// Days until a change of so many scatters in one channel of twenty is found: mean over robots.
fn delay(limit: f64, size: f64, ramp: f64, scatter: Scatter) -> f64 {
    let settings = Sequential { days_between: limit, ..Sequential::default() };
    let one = |seed: u64| {
        let mut robot = Robot::new(9000 + seed, 20, 0.0, scatter);
        let mut detector = Detector::new(settings);
        let mean = robot.means[3];
        let found = (0..50).find(|&day| {
            robot.means[3] = mean + size * robot.scatters[3] * (f64::from(day - 19) / ramp).clamp(0.0, 1.0);
            detector.day(day, None, &robot.day()).is_some() && day >= 20
        });
        f64::from(found.unwrap_or(50) - 19)
    };
    (0..40).map(one).sum::<f64>() / 40.0
}

#[test]
fn changes_are_found_within_days() {
    for (limit, most) in [(365.25, 5.0), (36525.0, 7.0)] {
        for (size, ramp) in [(3.0, 1.0), (5.0, 1.0), (10.0, 1.0), (5.0, 8.0)] {
            for scatter in [Scatter::Normal, Scatter::Heavy(3), Scatter::Correlated { rho: 0.5, every: 1 }] {
                let days = delay(limit, size, ramp, scatter);
                println!("limit {limit}: {size} scatters over {ramp} days, {scatter:?}: {days:.1} days");
                assert!(size < 5.0 || ramp > 1.0 || !matches!(scatter, Scatter::Normal) || days < most, "{days}");
            }
        }
    }
}

#[test]
fn a_change_of_some_scatters_is_found_in_its_channel_within_days() {
    for seed in 0..20 {
        let mut robot = Robot::new(seed, 20, 0.2, Scatter::Normal);
        let mut detector = Detector::new(Sequential::default());
        let found = (0..40).find_map(|day| {
            if day == 20 {
                robot.means[3] -= 5.0 * robot.scatters[3];
            }
            detector.day(day, None, &robot.day()).map(|found| (day, found))
        });
        let (day, found) = found.expect("the change is found");
        assert!((20..=26).contains(&day) && found.channel == 3 && (18..=20).contains(&found.before), "{day} {found:?}");
        assert!((found.size[0] + 5.0 * robot.scatters[3]).abs() < 4.0 * found.size[1], "{found:?}");
    }
}

#[test]
fn friction_that_follows_the_temperature_is_no_change() {
    let mut robot = Robot::new(7, 20, 0.0, Scatter::Normal);
    let mut detector = Detector::new(Sequential::default());
    for day in 0..60 {
        // Winter after forty days.
        let temperature = 25.0 + 4.0 * gauss(&mut robot.draws) - if day > 40 { 12.0 } else { 0.0 };
        let mut seen = robot.day();
        seen[5].value -= 2.0 * robot.scatters[5] * (temperature - 25.0);
        assert_eq!(detector.day(day, Some(temperature), &seen), None, "day {day}");
    }
}

#[test]
fn scale_and_place_of_a_channel_change_no_evidence() {
    let mut first = Robot::new(3, 4, 0.0, Scatter::Normal);
    let (mut a, mut b) = (Detector::new(Sequential::default()), Detector::new(Sequential::default()));
    for day in 0..25 {
        let seen = first.day();
        let other: Vec<Observed> =
            seen.iter().map(|o| Observed { value: 1e3 - 7.0 * o.value, variance: 49.0 * o.variance }).collect();
        let found = (a.day(day, None, &seen).is_some(), b.day(day, None, &other).is_some());
        assert!(!found.0 && !found.1);
        assert!((a.evidence() - b.evidence()).abs() < 1e-6 * (1.0 + a.evidence()), "{} {}", a.evidence(), b.evidence());
    }
}
