//! Tests of the diagnosis on real recordings: known causes are added to measured torques, and the
//! diagnosis reads the changed logs.
//!
//! The chain is `recordings of an arm -> identification -> residual -> a drawn cause, added ->
//! bytes of a log -> diagnosis -> figures`. The cause has 3, 1 or 0.5 times the size of that
//! residual. The unchanged logs are diagnosed as well. Noise, friction and clock are those of the
//! recordings; labels are exact. Additions are written here with the numeric recursion, and share
//! no law with `simulate` or `diagnose`.

mod addition;
mod arms;
mod figures;
mod identified;
mod informed;
mod motion;
mod session;

#[cfg(test)]
mod tests;

use super::super::{ReproduceError, Watch};
use crate::diagnose::Diagnosis;
use crate::numerics::prng::Random;
use addition::{Addition, Form};
use session::Session;

pub use addition::Added;
pub use arms::{ARMS, ArmData};
pub use figures::{Figures, Stability, calibration_error, reliability};

/// Settings of the cases on real recordings.
#[derive(Debug, Clone, PartialEq)]
pub struct RealSettings {
    /// Number of causes drawn; each is added in every size.
    pub cases: usize,
    /// Seed of the draw.
    pub seed: u64,
    /// Sizes: root mean square of the addition on its main joint, relative to that of the
    /// identified model's residual there.
    pub sizes: Vec<f64>,
    /// Longest total duration used of an arm's fitted logs and of its validating ones, s.
    pub seconds: [f64; 2],
    /// Whether to skip causes whose size is not recovered by a fit of the known form.
    pub recoverable: bool,
}

impl Default for RealSettings {
    fn default() -> Self {
        Self { cases: 30, seed: 1, sizes: vec![3.0, 1.0, 0.5], seconds: [40.0, 15.0], recoverable: false }
    }
}

/// Recordings of an arm, unchanged.
#[derive(Debug, Clone, PartialEq)]
pub struct Recorded {
    /// Data of the arm and its recordings.
    pub arm: ArmData,
    /// Bytes of the fitted logs, in the order of [`ArmData::fit`].
    pub fit: Vec<Vec<u8>>,
    /// Bytes of the validating logs, in the order of [`ArmData::validate`].
    pub validate: Vec<Vec<u8>>,
}

/// A cause added in one size, and the diagnosis of the changed logs.
#[derive(Debug, Clone, PartialEq)]
pub struct RealCase {
    /// Name of the arm.
    pub arm: String,
    /// Desired size, in residuals.
    pub size: f64,
    /// The addition.
    pub added: Added,
    /// Size found by a fit of the true form, relative to the true size.
    pub informed: f64,
    /// Found causes.
    pub found: Diagnosis,
    /// Causes (indices into `found`) that the unchanged logs do not have.
    pub new: Vec<usize>,
}

/// The unchanged logs of an arm.
#[derive(Debug, Clone, PartialEq)]
pub struct Untouched {
    /// Name of the arm.
    pub arm: String,
    /// Root mean square of the identified model's residual on the fitted logs, per joint, N m.
    pub residual: Vec<f64>,
    /// Diagnosis of the whole excerpt.
    pub whole: Diagnosis,
    /// Diagnoses of its first and second half; `None` if one is too short.
    pub halves: [Option<Diagnosis>; 2],
}

/// Results of all cases.
#[derive(Debug, Clone, PartialEq)]
pub struct RealBattery {
    /// Settings of the cases.
    pub settings: RealSettings,
    /// Results without an addition, one per arm.
    pub untouched: Vec<Untouched>,
    /// Cases, one per draw and size.
    pub cases: Vec<RealCase>,
    /// Reasons why a draw or an arm has no case, as sentences.
    pub skipped: Vec<String>,
    /// Figures for each size.
    pub figures: Vec<Figures>,
    /// Causes named in unchanged logs, and whether other excerpts agree.
    pub stability: Stability,
}

/// Identifies each arm, diagnoses its logs, adds causes and diagnoses again.
///
/// # Errors
/// Returns an error if a log can't be read. An arm that can't be identified is skipped with a
/// reason.
pub fn on_real(
    settings: &RealSettings,
    recorded: &[Recorded],
    watch: Watch<'_>,
) -> Result<RealBattery, ReproduceError> {
    let arms = recorded.len().max(1);
    let steps = (recorded.len() * 3 + settings.cases * settings.sizes.len()).max(1) as f64;
    let mut done = 0.0;
    let mut tell = |what: &str, by: f64| {
        done += by;
        watch(what, (done / steps).min(1.0));
    };
    let (mut untouched, mut cases, mut skipped) = (Vec::new(), Vec::new(), Vec::new());
    for (number, recorded) in recorded.iter().enumerate() {
        let name = recorded.arm.folder;
        tell(&format!("{name}: identification"), 0.0);
        let session = match Session::new(recorded, settings.seconds) {
            Ok(session) => session,
            Err(ReproduceError::Prepare(error)) => return Err(error.into()),
            Err(error) => {
                skipped.push(format!("{name}: {error}"));
                continue;
            }
        };
        tell(&format!("{name}: untouched"), 1.0);
        let plain = session.untouched()?;
        tell(&format!("{name}: untouched"), 2.0);
        let mine = settings.cases / arms + usize::from(number < settings.cases % arms);
        let mut random = Random::stream(settings.seed, number as u64);
        for form in deck(&mut random).into_iter().cycle().take(mine) {
            for &size in &settings.sizes {
                tell(&format!("{name}: {} of {size} residuals", form.cause()), 1.0);
                match case(&session, &plain.whole, (form, size), random.clone(), settings.recoverable)? {
                    Ok(case) => cases.push(case),
                    Err(why) => skipped.push(format!("{name}: {} of {size} residuals {why}", form.cause())),
                }
            }
            random.bits();
        }
        untouched.push(plain);
    }
    let figures = settings.sizes.iter().map(|&size| Figures::of(size, &cases)).collect();
    let stability = Stability::of(&untouched);
    Ok(RealBattery { settings: settings.clone(), untouched, cases, skipped, figures, stability })
}

/// All forms in random order.
fn deck(random: &mut Random) -> Vec<Form> {
    let mut deck = Form::ALL.to_vec();
    for last in (1..deck.len()).rev() {
        deck.swap(last, random.below(last + 1));
    }
    deck
}

/// Reason why a drawn cause is not diagnosed, as the end of a sentence.
type Skipped = &'static str;

/// Adds one cause in one size; the same `random` draws the same cause for every size.
fn case(
    session: &Session,
    plain: &Diagnosis,
    (form, size): (Form, f64),
    mut random: Random,
    recoverable: bool,
) -> Result<Result<RealCase, Skipped>, ReproduceError> {
    let named = |joints: &[usize]| plain.causes.iter().any(|c| c.cause == form.cause() && c.joints == joints);
    let drawn = (0..20).find_map(|_| {
        let addition = Addition::draw(form, session, &mut random)?;
        // A cause that the unchanged logs already have can't be recognised as new.
        (!named(&addition.joints)).then_some(addition)
    });
    let Some((addition, x)) = drawn.and_then(|a| Some((a.sized(session, size)?, a)).map(|(x, a)| (a, x))) else {
        return Ok(Err("can't be drawn"));
    };
    let informed = informed::recovered(session, &addition, x);
    if recoverable && !figures::is_recovered(informed) {
        return Ok(Err("are not recovered by a fit that knows the form"));
    }
    let found = session.diagnose(Some((&addition, x)))?;
    let new = figures::new_causes(&found, plain);
    let added = addition.added(session, x);
    Ok(Ok(RealCase { arm: session.name.clone(), size, added, informed, found, new }))
}
