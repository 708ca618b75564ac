//! Tests of the reports.

use super::*;
use crate::identify::{
    Accuracy, Condition, Confused, Estimate, Identification, LogSummary, Noise, Standing, Trace, TraceJoint,
};
use crate::model::{Inertial, StandardParameter};

fn found() -> Identification {
    let accuracy = Accuracy {
        rms: vec![0.5, f64::NAN],
        nrms: vec![0.01, f64::NAN],
        torque_rms: vec![10.0, f64::NAN],
        samples: vec![100, 0],
    };
    let estimate = |name: &str, which, row, std: f64, standing| Estimate {
        leader: StandardParameter::Link(row, which),
        name: name.into(),
        unit: "kg m^2".into(),
        grouping: format!("{name} = ZZ1 + L1**2*M2"),
        value: 1.25,
        std,
        white_std: std,
        standing,
        prior: Some(1.0),
    };
    Identification {
        robot: "two <links>".into(),
        parameters: vec![
            estimate("ZZ1R", Inertial::ZZ, 0, 0.0125, Standing::Identified),
            estimate("MSX2", Inertial::MSX, 1, f64::INFINITY, Standing::NotIdentifiable),
        ],
        correlation: vec![1.0, f64::NAN, f64::NAN, f64::NAN],
        noise: Noise {
            sigma: vec![0.5, 0.0],
            inflation: vec![3.0, 1.0],
            effective_samples: vec![33.0, 0.0],
            batches: vec![20, 0],
        },
        fit: accuracy.clone(),
        validation: Some(accuracy.clone()),
        fit_before: None,
        validation_before: None,
        logs: vec![LogSummary {
            name: "a.csv".into(),
            samples: vec![100, 0],
            seconds: 1.0,
            validates: false,
            accuracy,
        }],
        condition: Condition { weighted: 3.0, scaled: 2.0, plain: f64::INFINITY },
        confused: vec![Confused { parameters: vec!["MSX2".into()], open: 1 }],
        dropped: vec![],
        iterations: 3,
        weighted: true,
        budget: None,
        findings: vec![],
        samples: 100,
        independent: 33.0,
        unknowns: 1,
    }
}

#[test]
fn json_of_the_contract() {
    let value = identify_json(&found(), &[], &Warnings::default(), &[("version".into(), "1".into())]);
    let text = value.to_string();
    let back: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(back["parameters"][0]["name"], "ZZ1R");
    assert!((back["parameters"][0]["relative_std_percent"].as_f64().unwrap() - 1.0).abs() < 1e-12);
    assert!(back["parameters"][1]["relative_std_percent"].is_null());
    assert_eq!(back["rms"]["fit"][0], 0.5);
    assert!(back["rms"]["validate"][1].is_null() && back["condition_number"].is_null());
    assert_eq!(back["nrms"]["fit"][0], 0.01);
    assert_eq!(back["samples"], 100);
    assert_eq!(back["provenance"]["version"], "1");
}

#[test]
fn text_names_what_is_open() {
    let text = identify_text(&found(), &[], &Warnings::default());
    assert!(text.contains("ZZ1R  1.250  0.01250"), "{text}");
    assert!(text.contains("MSX2 does not act in this data."), "{text}");
    assert!(text.contains("5.0 %"), "{text}");
}

#[test]
fn page_stands_alone() {
    let curve = vec![[1.0, 1.0], [2.0, 2.5]];
    let joint = TraceJoint { measured: curve.clone(), estimated: curve.clone(), residual: curve };
    let trace = Trace {
        name: "</script>.csv".into(),
        time: vec![0.0, 0.01],
        segment: vec![0, 0],
        joints: vec![joint.clone(), joint],
        thinning: 1,
        validates: true,
    };
    let page = {
        let ball = [2.0, 0.6, 0.0, 0.2, 0.028, 0.208, 0.188, 0.0, -0.06, 0.0];
        let mut ghost = ball;
        ghost[4] = -1.0;
        let body = |ten: &[f64; 10]| crate::identify::tool::Body::new(ten, &[0.0; 100]);
        let links = Links { now: vec![body(&ball), body(&ghost), None], file: vec![body(&ball), None], possible: None };
        identify_html(
            &found(),
            &[],
            &Warnings::default(),
            &[trace],
            Some(&links),
            &[("robot file".into(), "a & b".into())],
        )
    };
    // A ball of 2 kg, radius 0.1 m, 0.3 m out and 0.1 m up.
    assert!(page.contains("<td class=words>300.0, 0.0, 100.0"), "{page}");
    assert!(page.contains("<td class=words>8.00, 8.00, 8.00"), "{page}");
    assert_eq!(page.matches("<td class=words>no: ").count(), 2, "{page}");
    for outside in ["http://", "https://", "src=", "href=", "@import", "url("] {
        let used = page.replace("http://www.w3.org/2000/svg", "").replace("href='#s", "").contains(outside);
        assert!(!used, "{outside}");
    }
    assert!(page.contains("two &lt;links&gt;") && page.contains("a &amp; b"));
    assert_eq!(page.matches("</script>").count(), 2);
    assert!(page.len() < 60_000);
}

#[test]
fn diagnosis_page_stands_alone() {
    use crate::diagnose::{
        Cause, Curve, Diagnosis, ErrorMap, Errors, Evidence, NextExperiment, Offer, Offered, Quantity, Verdict,
    };
    let identification = found();
    let errors = |x: f64| Errors { fit: vec![x], validate: vec![x], moving: vec![x] };
    let found = Diagnosis {
        changed: Vec::new(),
        file_holds: false,
        changes: Vec::new(),
        robot: "a <b>".into(),
        verdict: Verdict::Explained,
        noise_floor: vec![0.1],
        budget: Default::default(),
        torque_rms: vec![10.0],
        baseline: errors(1.0),
        refitted: errors(0.5),
        extended: errors(0.1),
        offer: Offer { offered: Offered::Extended, left_out: [1.0, 0.5, 0.1], why: vec!["it <i> is better".into()] },
        has_links: true,
        links_refitted: false,
        transmission: false,
        standard: None,
        rejected: Vec::new(),
        causes: vec![Cause {
            shape: Vec::new(),
            refuted: None,
            recurrence: 0.9,
            found_again: [2, 2],
            cause: "joint_elasticity",
            joints: vec![1],
            probability: 0.95,
            support: 40.0,
            margin: 8.0,
            share: 0.9,
            parameters: vec![Quantity { symbol: "td1".into(), value: 0.02, std: Some(0.001) }],
            keys: vec![],
            evidence: "joint 1: </script> late".into(),
            rms_before: vec![1.0],
            rms_after: vec![f64::NAN],
            interval: [0.9, 0.99],
            on: "validate",
            not_distinguished_from: vec!["viscous_friction"],
            shown_by: "a second speed",
            decided_by: None,
            law: None,
            in_extended: true,
            curve: Some(Evidence {
                over: "velocity, rad/s (joint 1)".into(),
                x: vec![-1.0, 1.0],
                measured: vec![0.5, f64::INFINITY],
                explained: vec![0.5, 0.25],
            }),
        }],
        friction: vec![],
        band: None,
        forgotten: vec![],
        next_experiment: Some(NextExperiment {
            between: vec!["joint_elasticity", "viscous_friction"],
            joints: vec![1],
            motion: "a second speed".into(),
        }),
        own_validation: true,
        seconds: [20.0, 10.0],
        curves: vec![Curve {
            t: vec![0.0, 0.1],
            measured: vec![1.0, 2.0],
            before: vec![0.5, 0.4],
            after: vec![0.1, 0.123456789],
        }],
        maps: vec![vec![ErrorMap { over: "velocity, rad/s", x: vec![0.0], before: vec![1.0], after: vec![0.1] }]],
    };
    let page = diagnose_html(&found, &[], &Warnings::default(), None, &[("robot file".into(), "a & b".into())]);
    for outside in ["http://", "https://", "src=", "href=", "@import", "url("] {
        let used = page.replace("http://www.w3.org/2000/svg", "").replace("href='#s", "").contains(outside);
        assert!(!used, "{outside}");
    }
    assert_eq!(page.matches("</script>").count(), 2);
    assert!(page.contains("a &lt;b&gt;") && page.contains("a &amp; b"));
    assert!(page.contains("<tr><th>td1<td>0.02000<td>0.0010</tr>"), "value and deviation");
    assert!(page.contains("Not separated from viscous friction") && page.contains("a second speed"));
    // (1 - 0.01) / (1 - 0.01): the whole possible gain.
    assert!(page.contains("<td>100 %</tr>"));
    let start = page.find("application/json>").unwrap() + "application/json>".len();
    let end = start + page[start..].find("</script>").unwrap();
    let data: serde_json::Value = serde_json::from_str(&page[start..end].replace("<\\/", "</")).unwrap();
    assert!(data["causes"][0]["after"][0].is_null() && data["causes"][0]["curve"]["measured"][1].is_null());
    assert_eq!(data["curves"][0]["after"][1], 0.12346);
    // The same after an identification: the most improved joint, and the parameters.
    let mut warnings = Warnings::default();
    warnings.push("few samples");
    let identified = Identified { found: &identification, warnings: &warnings };
    let page = diagnose_html(&found, &[], &Warnings::default(), Some(&identified), &[]);
    assert!(page.contains("data-joint=0") && page.contains("Parameters as identified") && page.contains("few samples"));
    let text = calibrate_text(&found, &identified, &Warnings::default());
    assert!(text.contains("warning of the identification: few samples"), "{text}");
    // What an excerpt of the logs lacks is the first doubt.
    let mut late = found;
    let doubt =
        |found: &Diagnosis| diagnose_json(found, &[], &Warnings::default(), &[])["causes"][0]["against"][0].clone();
    assert_eq!(doubt(&late), "viscous friction would explain nearly as much");
    late.causes[0].found_again = [1, 2];
    assert_eq!(doubt(&late), "one of two excerpts of the fitted logs does not show it");
    late.causes[0].found_again = [0, 2];
    assert_eq!(doubt(&late), "no excerpt of the fitted logs shows it");
    late.causes[0].found_again = [0, 1];
    assert_eq!(doubt(&late), "no excerpt of the fitted logs shows it");
    // A delay has no curve of its own.
    late.causes[0].cause = "time_delay";
    assert!(diagnose_html(&late, &[], &Warnings::default(), None, &[]).contains("\"curve\":null"));
}
