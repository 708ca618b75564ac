use denavit::numerics::prng::Random;

use super::{Detector, Observed, Sequential};

/// Normal, by Box and Muller.
fn gauss(draws: &mut Random) -> f64 {
    let (u, v) = (draws.uniform(1e-300, 1.0), draws.uniform(0.0, std::f64::consts::TAU));
    (-2.0 * u.ln()).sqrt() * v.cos()
}

/// Days of a robot whose channels have means and scatters of their own.
struct Robot {
    draws: Random,
    means: Vec<f64>,
    scatters: Vec<f64>,
    /// Share of the scatter that all channels have in common.
    common: f64,
    /// Degrees of freedom of the scatter; none: normal.
    heavy: bool,
}

impl Robot {
    fn new(seed: u64, channels: usize, common: f64, heavy: bool) -> Self {
        let mut draws = Random::new(seed);
        let means = (0..channels).map(|_| 10.0 * gauss(&mut draws)).collect();
        let scatters = (0..channels).map(|_| (2.0 * gauss(&mut draws)).exp()).collect();
        Self { draws, means, scatters, common, heavy }
    }

    fn normal(&mut self) -> f64 {
        // A Student's t of five degrees of freedom, scaled to variance 1.
        let squares: f64 = (0..5).map(|_| gauss(&mut self.draws).powi(2)).sum();
        let x = gauss(&mut self.draws);
        if self.heavy { x / (squares / 5.0).sqrt() * (3.0_f64 / 5.0).sqrt() } else { x }
    }

    fn day(&mut self) -> Vec<Observed> {
        let shared = self.normal();
        (0..self.means.len())
            .map(|k| {
                let own = self.normal();
                let x = self.common.sqrt() * shared + (1.0 - self.common).sqrt() * own;
                // Noise is a tenth of the scatter.
                let variance = 0.01 * self.scatters[k].powi(2);
                Observed { value: self.means[k] + self.scatters[k] * x, variance }
            })
            .collect()
    }
}

/// False alarms, and days on which there could have been one.
fn alarms(settings: Sequential, robots: u64, days: i32, common: f64, heavy: bool) -> (usize, f64) {
    let mut count = 0;
    for seed in 0..robots {
        let mut robot = Robot::new(1000 + seed, 20, common, heavy);
        let mut detector = Detector::new(settings);
        count += (0..days).filter(|day| detector.day(*day, None, &robot.day()).is_some()).count();
    }
    (count, robots as f64 * f64::from(days - settings.reference_days as i32))
}

#[test]
fn false_alarms_are_rarer_than_stated() {
    let settings = Sequential { days_between: 50.0, ..Sequential::default() };
    let (count, days) = alarms(settings, 60, 200, 0.0, false);
    println!("independent channels: {count} in {days} days, at most {} stated", days / 50.0);
    let (common, _) = alarms(settings, 60, 200, 0.5, false);
    println!("half of the scatter in common: {common}");
    let (heavy, _) = alarms(settings, 60, 200, 0.0, true);
    println!("heavy tails (t5): {heavy}");
    assert!((count as f64) < days / 50.0 && (common as f64) < days / 50.0, "{count} and {common}");
    assert!(count > 0, "a bound of which nothing is used");
}

#[test]
fn a_change_of_some_scatters_is_found_in_its_channel_within_days() {
    for seed in 0..20 {
        let mut robot = Robot::new(seed, 20, 0.2, false);
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
    let mut robot = Robot::new(7, 20, 0.0, false);
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
    let mut first = Robot::new(3, 4, 0.0, false);
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
