//! Lowers the cutoff for logs sampled too slowly for the usual one.

use super::prepare::PrepareError;

/// Lowest cutoff that is tried, Hz.
const LOWEST: f64 = 1.0;
/// Factor between successive cutoffs.
const FACTOR: f64 = 0.6;

/// Calls `attempt` with the cutoff `highest`, Hz. As long as the log is sampled too slowly for it,
/// retries with 0.6 of the last cutoff, down to 1 Hz. Returns the result and the cutoff, Hz.
///
/// # Errors
/// Errors of the last attempt.
pub fn lower_cutoff<T>(
    highest: f64,
    mut attempt: impl FnMut(f64) -> Result<T, PrepareError>,
) -> Result<(T, f64), PrepareError> {
    let mut cutoff = highest;
    loop {
        match attempt(cutoff) {
            Err(PrepareError::Cutoff { .. }) if cutoff > LOWEST => cutoff *= FACTOR,
            result => return result.map(|found| (found, cutoff)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::butterworth::low_pass;

    #[test]
    fn the_cutoff_falls_until_the_rate_allows_it() {
        let attempt = |rate: f64| {
            lower_cutoff(15.0, |cutoff| {
                let made = low_pass(5, cutoff, rate);
                made.map(drop).map_err(|source| PrepareError::Cutoff { file: "log.csv".into(), source })
            })
        };
        assert_eq!(attempt(1000.0).unwrap().1, 15.0);
        let (_, cutoff) = attempt(20.0).unwrap();
        assert!(cutoff < 10.0 && low_pass(5, cutoff / FACTOR, 20.0).is_err());
        assert!(attempt(0.5).is_err());
    }
}
