//! Report on equation (14) and the paper's future work: tables, a verdict.

use serde_json::{Value, json};

use crate::apps::paper::Force;
use crate::apps::paper::force::{AMPLITUDES, NEAR, share};
use crate::control::estimate::{COMPONENTS, Comparison};
use crate::report::parts::number::digits;
use crate::report::reproduce::text::Table;

/// The verdict in one paragraph.
pub(in crate::report) fn verdict(found: &Force) -> String {
    let mut text = String::from("The wrench on the tool from joint torques, on the simulated KUKA LWR.");
    if let Some(row) = found.accuracy.iter().find(|r| r.state == "moving") {
        let mean = |range: std::ops::Range<usize>| {
            let squares: f64 = range.clone().map(|i| row.components[i].rms.powi(2)).sum();
            (squares / range.len() as f64).sqrt()
        };
        text += &format!(
            " In motion, over the whole workspace, forces are estimated to {} N and moments to {} N m (RMS per component, torque noise as in the paper's Table II).",
            digits(mean(0..3), 2),
            digits(mean(3..6), 2)
        );
    }
    if let Some(c) = found.coverage.first() {
        text += &format!(
            " Over {} runs the 95 % bands hold the true value in {:.1} % of the samples (from {:.0} to {:.0} % in a single run).",
            c.runs,
            100.0 * c.whole,
            100.0 * c.of_runs[0],
            100.0 * c.of_runs[1]
        );
    }
    text
}

/// Accuracy and coverage of the bands.
pub(in crate::report) fn tables(found: &Force) -> Vec<Table> {
    let cells = |f: &dyn Fn(usize) -> String| (0..6).map(f).collect::<Vec<_>>();
    let rows = found.accuracy.iter().map(|r| {
        let rms = |i: usize| format!("{} ± {}", digits(r.components[i].rms, 2), digits(r.components[i].half, 2));
        let observable = r.components.iter().map(|c: &Comparison| c.observable).sum::<f64>() / 6.0;
        let mut row = vec![r.method.name().to_string(), r.state.to_string()];
        row.extend(cells(&rms));
        row.push(format!("{:.1}", 100.0 * share(&r.components)));
        row.push(format!("{:.0}", 100.0 * observable));
        row
    });
    let mut head = vec!["estimator", "arm"];
    head.extend(COMPONENTS);
    head.extend(["in band %", "observable %"]);
    let accuracy = Table {
        title: "Accuracy over the whole workspace".into(),
        note: format!(
            "RMS error ± mean half-width of the 95 % band, N and N m. {} random postures, a move and a rest for each, all six components at once (sines of {} N and {} N m, 0.1 to 0.7 Hz). The model is identified from a log with noise. Near a singularity: smallest singular value of the Jacobian (angular rows times 0.5 m) under {NEAR} m/rad. At rest the Coulomb friction may be anything between its levels, and the band says so. Observable: share of samples in which the component is observable (standard deviation under a tenth of 300 N, 100 N m); the other figures are of these.",
            found.settings.postures, AMPLITUDES[0], AMPLITUDES[3]
        ),
        head: head.clone(),
        rows: rows.collect(),
    };
    let mut all = vec![accuracy];
    if !found.coverage.is_empty() {
        let rows = found.coverage.iter().map(|c| {
            let mut row =
                vec![c.method.name().to_string(), format!("{}, {}, {} runs", c.robot, c.case.words(), c.runs)];
            row.extend(cells(&|i| format!("{:.1}", 100.0 * c.components[i])));
            row.push(format!("{:.1}", 100.0 * c.whole));
            row.push(format!("{:.0}–{:.0}", 100.0 * c.of_runs[0], 100.0 * c.of_runs[1]));
            row.push(format!("{:.0}", 100.0 * c.found_right));
            row
        });
        let mut head = vec!["estimator", "model"];
        head.extend(COMPONENTS);
        head.extend(["all", "single runs", "bands believed %"]);
        all.push(Table {
            title: "How often the 95 % band holds the true value, %".into(),
            note: "Over samples and runs, each with parameters of its own identification, or with those of a right file and the noise of the log. Last column: runs in which the report does not call the model too wrong for the bands; only an arm with a spare joint can detect it.".into(),
            head,
            rows: rows.collect(),
        });
    }
    all
}

/// The result as JSON, one key per table.
pub(in crate::report) fn to_json(found: &Force) -> Value {
    json!({
        "seed": found.settings.seed,
        "postures": found.settings.postures,
        "accuracy": found.accuracy.iter().map(|r| json!({
            "estimator": r.method.name(), "state": r.state, "samples": r.components[0].samples,
            "rms": r.components.map(|c| c.rms), "half_width": r.components.map(|c| c.half), "inside": r.components.map(|c| c.inside),
            "told": r.components.map(|c| c.observable),
        })).collect::<Vec<_>>(),
        "coverage": found.coverage.iter().map(|c| json!({
            "estimator": c.method.name(), "robot": c.robot, "model": c.case.words(), "runs": c.runs, "samples": c.samples, "components": c.components,
            "all": c.whole, "single_runs": c.of_runs, "half_width": c.half, "rms": c.rms, "believed": c.found_right,
        })).collect::<Vec<_>>(),
    })
}
