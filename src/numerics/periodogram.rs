//! Periodogram of a series over an angle: the power at each of many evenly spaced orders.
//!
//! From order to order each sample's phase advances by a constant: two complex multiplications
//! replace the sines. Samples are processed four at a time over a few orders, so that their state
//! stays in registers.

/// A value averaged over an interval of the angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    pub value: f64,
    /// Middle of the interval, rad.
    pub angle: f64,
    /// Half length of the interval, rad.
    pub half: f64,
}

/// Evenly spaced orders, 1/turn, above zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Orders {
    pub first: f64,
    pub step: f64,
    pub count: usize,
}

impl Orders {
    /// Order with index `i`.
    pub fn at(&self, i: usize) -> f64 {
        self.first + i as f64 * self.step
    }
}

/// Number of samples processed at once.
const LANES: usize = 4;

/// Number of orders in one pass over the samples.
const PASS: usize = 32;

/// Least half length of an interval, rad: averaging over less has no effect.
const LEAST: f64 = 1e-6;

type Lanes = [f64; LANES];

/// Cosines and sines of the phases.
#[derive(Debug, Clone, Copy)]
struct Turn {
    cos: Lanes,
    sin: Lanes,
}

impl Turn {
    fn of(angles: Lanes) -> Self {
        Self { cos: angles.map(f64::cos), sin: angles.map(f64::sin) }
    }

    #[inline(always)]
    fn on(&mut self, by: &Self) {
        for l in 0..LANES {
            let (cos, sin) = (self.cos[l], self.sin[l]);
            self.cos[l] = cos * by.cos[l] - sin * by.sin[l];
            self.sin[l] = sin * by.cos[l] + cos * by.sin[l];
        }
    }
}

/// Samples that are processed at once, at one order.
#[derive(Debug, Clone, Copy)]
struct Block {
    value: Lanes,
    /// Inverse of the half length; 0 in unused lanes.
    inverse: Lanes,
    angle: Turn,
    /// Phase increment per order.
    angle_by: Turn,
    half: Turn,
    half_by: Turn,
}

impl Block {
    fn new(samples: &[Sample], orders: &Orders) -> Self {
        let of = |f: fn(&Sample) -> f64| -> Lanes { std::array::from_fn(|l| samples.get(l).map_or(0.0, f)) };
        let half = |sample: &Sample| sample.half.abs().max(LEAST);
        let times = |lanes: Lanes, by: f64| lanes.map(|x| by * x);
        let (angle, covers) = (of(|s| s.angle), of(half));
        Self {
            value: of(|s| s.value),
            inverse: covers.map(|half| if half > 0.0 { 1.0 / half } else { 0.0 }),
            angle: Turn::of(times(angle, orders.first)),
            angle_by: Turn::of(times(angle, orders.step)),
            half: Turn::of(times(covers, orders.first)),
            half_by: Turn::of(times(covers, orders.step)),
        }
    }
}

/// Sums over the samples at one order: value times cosine and sine, and the squared weights, all
/// multiplied by the order.
#[derive(Debug, Clone, Copy, Default)]
struct Sums {
    cos: Lanes,
    sin: Lanes,
    norm: Lanes,
}

/// Power at the cosine and sine of each order, in units of the sum of squares of the values. Each
/// sample is weighted by the attenuation of the order over its interval.
pub fn periodogram(samples: &[Sample], orders: &Orders) -> Vec<f64> {
    let mut blocks: Vec<Block> = samples.chunks(LANES).map(|chunk| Block::new(chunk, orders)).collect();
    let mut power = Vec::with_capacity(orders.count);
    while power.len() < orders.count {
        let mut sums = [Sums::default(); PASS];
        let next = PASS.min(orders.count - power.len());
        pass(&mut blocks, &mut sums[..next]);
        for Sums { cos, sin, norm } in &sums[..next] {
            let order = orders.at(power.len());
            let [cos, sin, norm] = [cos, sin, norm].map(|lanes| lanes.iter().sum::<f64>() / order);
            power.push((cos * cos + sin * sin) / (norm / order).max(1.0));
        }
    }
    power
}

/// Adds the samples' contributions to the next orders and advances their phases, in the widest
/// registers of this processor. The result is bitwise equal to any other width.
#[multiversion::multiversion(targets("x86_64+avx2"))]
fn pass(blocks: &mut [Block], sums: &mut [Sums]) {
    for block in blocks {
        let mut b = *block;
        for sum in sums.iter_mut() {
            for l in 0..LANES {
                // The mean of a cosine over a sample's interval, times the order.
                let weight = b.half.sin[l] * b.inverse[l];
                let weighed = b.value[l] * weight;
                sum.cos[l] += weighed * b.angle.cos[l];
                sum.sin[l] += weighed * b.angle.sin[l];
                sum.norm[l] += weight * weight;
            }
            b.angle.on(&b.angle_by);
            b.half.on(&b.half_by);
        }
        *block = b;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::prng::Random;

    /// Comparison with direct sums of sines, for numbers of samples and orders that fill no pass.
    #[test]
    fn it_is_the_sum_over_the_samples() {
        let mut random = Random::new(7);
        for (len, count) in [(0, 5), (1, 1), (7, 33), (203, 100)] {
            let samples: Vec<Sample> = (0..len)
                .map(|k| Sample {
                    value: random.uniform(-1.0, 1.0),
                    angle: random.uniform(-2.0, 2.0),
                    half: if k % 5 == 0 { 0.0 } else { random.uniform(-0.02, 0.02) },
                })
                .collect();
            let orders = Orders { first: 3.0, step: 0.7, count };
            let power = periodogram(&samples, &orders);
            assert_eq!(power.len(), count);
            for (i, power) in power.iter().enumerate() {
                let n = orders.at(i);
                let sums = samples.iter().fold([0.0; 3], |[c, s, norm], sample| {
                    let half = n * sample.half;
                    let weight = if half == 0.0 { 1.0 } else { half.sin() / half };
                    let weighed = weight * sample.value;
                    let angle = n * sample.angle;
                    [c + weighed * angle.cos(), s + weighed * angle.sin(), norm + weight * weight]
                });
                let wanted = (sums[0].powi(2) + sums[1].powi(2)) / sums[2].max(1.0);
                assert!((power - wanted).abs() < 1e-7 * (1.0 + wanted), "{len} {i}: {power} {wanted}");
            }
        }
    }

    /// The order present in the series has the largest power.
    #[test]
    fn an_order_stands_out() {
        let angle = |k: usize| 1.3 * (0.01 * k as f64).sin();
        let sample = |k: usize| Sample { value: (17.0 * angle(k) + 0.4).cos(), angle: angle(k), half: 0.003 };
        let samples: Vec<Sample> = (0..3000).map(sample).collect();
        let orders = Orders { first: 4.0, step: 0.25, count: 200 };
        let power = periodogram(&samples, &orders);
        let most = (0..200).max_by(|a, b| power[*a].total_cmp(&power[*b])).unwrap();
        assert!((orders.at(most) - 17.0).abs() < 0.3, "{}", orders.at(most));
    }
}
