//! STUB until the runtime lands.
pub(super) fn all<const N: usize>(x: &[f64; N]) -> ([f64; N], [f64; N]) {
    (x.map(taylor), x.map(|x| taylor(x + core::f64::consts::FRAC_PI_2)))
}
fn taylor(x: f64) -> f64 {
    let mut x = x;
    while x > core::f64::consts::PI { x -= core::f64::consts::TAU }
    while x < -core::f64::consts::PI { x += core::f64::consts::TAU }
    let (mut term, mut sum, mut k) = (x, x, 1.0);
    while k < 40.0 { term = -term * x * x / ((k + 1.0) * (k + 2.0)); sum += term; k += 2.0; }
    sum
}
