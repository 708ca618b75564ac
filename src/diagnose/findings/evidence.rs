//! Sentences and curves that show the evidence for a cause.

use super::result::Evidence;
use crate::diagnose::fit::model::{Chosen, Fitted, ModelUnderTest};
use crate::diagnose::hypotheses::{Hypothesis, Over, Quantity, Term};
use crate::diagnose::windows::windowed_data::JointSeries;
use crate::model::StandardParameter;

/// A number with at most four significant digits.
pub(in crate::diagnose) fn short(value: f64) -> String {
    let size = value.abs();
    if size != 0.0 && !(1e-3..1e4).contains(&size) {
        return format!("{value:.2e}");
    }
    let decimals = if size >= 100.0 {
        1
    } else if size >= 1.0 {
        2
    } else if size >= 0.1 {
        3
    } else {
        4
    };
    format!("{value:.decimals$}")
}

/// Content of a sentence of evidence.
pub(in crate::diagnose) struct Shown<'a> {
    pub cause: &'a dyn Hypothesis,
    /// Shape of the cause; `None` for plain friction.
    pub shape: Option<&'a [f64]>,
    /// Joints, from 0.
    pub place: &'a [usize],
    pub parameters: &'a [Quantity],
    /// Root mean square errors without and with it, N m, on the data named by `on`.
    pub all: [&'a [f64]; 2],
    /// The same where the joints move.
    pub moving: [&'a [f64]; 2],
    pub noise: &'a [f64],
    pub on: &'a str,
    /// Share of held-out parts that agree, if computed.
    pub confirmed: Option<f64>,
    /// Ratio of its size on the validating data to the fitted one, where observable.
    pub repeats: Option<f64>,
}

/// One sentence with figures.
pub(in crate::diagnose) fn sentence(shown: &Shown<'_>) -> String {
    let Shown { cause, shape, place, parameters, all, moving, noise, on, confirmed, repeats } = *shown;
    // Effects at rest and about reversals alone are visible in all samples only.
    let most_taken = |[before, after]: [&[f64]; 2]| {
        before.iter().zip(after).map(|(b, a)| if *b > 0.0 { 1.0 - (a / b).powi(2) } else { 0.0 }).fold(0.0, f64::max)
    };
    let moves = most_taken(moving) > most_taken(all) + 0.1;
    let [before, after] = if moves { moving } else { all };
    let where_it_moves = if moves { " where it moves" } else { "" };
    let gain = |j: &usize| before[*j].powi(2) - after[*j].powi(2);
    let most = |joints: &mut dyn Iterator<Item = usize>| joints.max_by(|a, b| gain(a).total_cmp(&gain(b)));
    // Prefer its own joint if the error falls there.
    let main = most(&mut place.iter().copied())
        .filter(|j| gain(j) > 0.0)
        .or_else(|| most(&mut (0..before.len())))
        .unwrap_or(0);
    let where_ = match place {
        [] => "the whole robot".to_string(),
        [j] => format!("joint {}", j + 1),
        many => format!("joints {}", many.iter().map(|j| (j + 1).to_string()).collect::<Vec<_>>().join(" and ")),
    };
    let numbers: Vec<String> = parameters
        .iter()
        .map(|p| match p.std {
            Some(std) => format!("{} = {} +- {}", p.symbol, short(p.value), short(std)),
            None => format!("{} = {}", p.symbol, short(p.value)),
        })
        .collect();
    let attainable = before[main].powi(2) - noise[main].powi(2);
    let gain = before[main].powi(2) - after[main].powi(2);
    let gained = match gain > 0.0 && attainable > 0.0 {
        true => format!(", {:.0} % of the variance above its noise", (100.0 * gain / attainable).min(100.0)),
        false => String::new(),
    };
    let [from, to] = [before[main], after[main]].map(short);
    let change = match gain < 0.0 {
        _ if from == to => format!("stays at {from} N m"),
        true => format!("grows from {from} to {to} N m"),
        false => format!("falls from {from} to {to} N m"),
    };
    let confirmed = confirmed.map_or(String::new(), |share| {
        if cause.local() {
            String::new()
        } else {
            format!("; {:.0} % of held-out parts of the fitted logs agree", 100.0 * share)
        }
    });
    let repeats = repeats.map_or(String::new(), |size| {
        format!("; estimated from data that were not fitted, its size is {:.0} % of this", 100.0 * size)
    });
    format!(
        "{where_}: {} ({}); the error of joint {}{where_it_moves} {change} on {on}{gained}{confirmed}{repeats}",
        shape.map_or(cause.says(), |shape| cause.says_of(shape)),
        numbers.join(", "),
        main + 1,
    )
}

/// The joint with the largest effect.
fn most_affected(dof: usize, terms: &[Term], x: &[f64]) -> Option<usize> {
    let size = |j: usize| {
        let squares = terms.iter().zip(x).flat_map(|(t, x)| {
            let own = t.column.rows.iter().filter(move |r| r.0 == j);
            own.flat_map(move |r| r.1.iter().map(move |s| (s * x).powi(2)))
        });
        squares.sum::<f64>()
    };
    (0..dof).max_by(|a, b| size(*a).total_cmp(&size(*b)))
}

/// The error without a cause and the cause's torque, averaged over the quantity that shows it best.
pub(in crate::diagnose) fn curve(
    tested: &ModelUnderTest<'_>,
    fitted: &Fitted,
    index: usize,
    chosen: &Chosen,
) -> Option<Evidence> {
    let scene = &tested.scene;
    let terms = &fitted.terms[index];
    let joint = chosen.place.first().copied().or_else(|| most_affected(scene.dof(), terms, &chosen.x))?;
    let mut says = vec![0.0; scene.len];
    for (term, x) in terms.iter().zip(&chosen.x) {
        for (_, series) in term.column.rows.iter().filter(|r| r.0 == joint) {
            says.iter_mut().zip(&**series).for_each(|(a, s)| *a += x * s);
        }
    }
    let coarse = |f: &dyn Fn(&JointSeries<'_>, usize) -> f64| -> Vec<f64> {
        scene.own[joint].iter().flat_map(|own| scene.average_of(own, |k| f(own, k))).collect()
    };
    let (over, x): (&str, Vec<f64>) = match chosen.cause.over() {
        Over::Position => ("position, rad", coarse(&|o, k| o.q[k])),
        Over::Velocity => ("velocity, rad/s", coarse(&|o, k| o.v[k])),
        Over::Acceleration => ("acceleration, rad/s^2", coarse(&|o, k| o.a[k])),
        Over::Torque => ("torque of the model, N m", scene.whole[joint].to_vec()),
        Over::Time => ("time, s", scene.time.clone()),
    };
    let live: Vec<usize> = (0..scene.len).filter(|&w| scene.live[joint][w]).collect();
    let low = live.iter().map(|&w| x[w]).fold(f64::INFINITY, f64::min);
    let high = live.iter().map(|&w| x[w]).fold(f64::NEG_INFINITY, f64::max);
    if high <= low {
        return None;
    }
    const BINS: usize = 80;
    let mut sums = vec![[0.0; 4]; BINS];
    for &w in &live {
        let bin = (((x[w] - low) / (high - low) * BINS as f64) as usize).min(BINS - 1);
        let s = &mut sums[bin];
        *s = [s[0] + 1.0, s[1] + x[w], s[2] + fitted.residual[joint][w] + says[w], s[3] + says[w]];
    }
    let used = || sums.iter().filter(|s| s[0] >= 3.0);
    Some(Evidence {
        over: format!("{over} (joint {})", joint + 1),
        x: used().map(|s| s[1] / s[0]).collect(),
        measured: used().map(|s| s[2] / s[0]).collect(),
        explained: used().map(|s| s[3] / s[0]).collect(),
    })
}

/// Joints with base parameters more than five standard deviations from the file's: those of their
/// links, and those of their rotors alone.
pub(in crate::diagnose) fn changed_links(
    tested: &ModelUnderTest<'_>,
    fitted: &Fitted,
    covariance: &nalgebra::DMatrix<f64>,
) -> [Vec<usize>; 2] {
    let base = tested.plant.base_parameters();
    let Some(given) = tested.plant.given() else { return Default::default() };
    let mut changed: [Vec<usize>; 2] = Default::default();
    let wanted: Vec<usize> = (0..base.len()).filter(|&b| !base[b].leader.is_friction()).collect();
    for (at, &b) in wanted.iter().enumerate() {
        let file: f64 = base[b].coefficients.iter().map(|(i, k)| k * given[*i]).sum();
        let std = covariance[(at, at)].max(0.0).sqrt();
        let (StandardParameter::Link(row, _) | StandardParameter::Drive(row, _)) = base[b].leader else { continue };
        let joint = tested.plant.rows().iter().position(|r| *r == row);
        if let Some(j) = joint
            && std > 0.0
            && (fitted.solution.x[at] - file).abs() > 5.0 * std
        {
            changed[usize::from(base[b].leader.is_rotor())].push(j + 1);
        }
    }
    for joints in &mut changed {
        joints.sort_unstable();
        joints.dedup();
    }
    changed
}
