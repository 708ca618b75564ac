//! Tests of `denavit reproduce`: wrong uses here; the complete run in release, on request.

use super::denavit;
use super::folder;
use super::json;
use super::numbers;

#[test]
fn what_is_asked_wrongly_is_one_paragraph() {
    let help = denavit(&["reproduce", "--help"]);
    assert_eq!(help.status, Some(0));
    assert!(help.out.contains("Example:") && help.out.contains("identification"), "{}", help.out);
    for wrong in [
        &["reproduce", "identifcation"][..],
        &["reproduce", "--runs", "1000000"],
        &["reproduce", "--runs", "-1"],
        &["reproduce", "force", "--quick"],
        &["reproduce", "diagnosis", "--seed", "2"],
        &["reproduce", "painting", "--runs", "5"],
    ] {
        let run = denavit(wrong);
        assert_eq!((run.status, run.out.as_str()), (Some(2), ""), "{wrong:?}");
        assert!(!run.err.trim_end().contains("\n\n"), "{}", run.err);
    }
}

#[test]
#[ignore = "half a minute in release: cargo test --release -p denavit --test cli reproduce -- --ignored"]
fn rows_verdicts_and_page() {
    let page = folder("reproduce").join("page.html").display().to_string();
    let found = json(&["reproduce", "identification", "--runs", "10", "--json", "-", "--report", &page]);
    let part = &found["identification"];
    assert_eq!(part["table2"].as_array().unwrap().len(), 15);
    assert_eq!(numbers(&part["noise_floor"]).len(), 7);
    assert_eq!(part["table3"].as_array().unwrap().len(), 2);
    assert!(part["fig6"]["rows"].as_array().unwrap().iter().all(|row| row["verdict"].is_string()));
    let page = std::fs::read_to_string(page).unwrap();
    assert!(page.contains("Table III") && !page.contains("NaN") && !page.contains("http"), "a page of its own");
    assert_eq!(found, json(&["reproduce", "--runs", "10", "--json", "-"]));
}

#[test]
fn painting_in_brief() {
    let page = folder("reproduce-painting").join("page.html").display().to_string();
    let found = json(&["reproduce", "painting", "--quick", "--seed", "1", "--json", "-", "--report", &page]);
    let part = &found["painting"];
    let rows = part["table4"].as_array().unwrap();
    assert_eq!(rows.len(), 2, "{part}");
    for (row, [estimated, desired]) in rows.iter().zip([[1.0, 1.0], [5.0, 3.0]]) {
        let of = |key: &str| row[key].as_f64().unwrap();
        assert!(of("estimated_measured") < estimated && of("estimated_desired") < desired, "{row}");
        assert!(of("seconds_off") == 0.0 && of("aside") < 0.02, "{row}");
        assert_eq!(row["roller"], "large-roller");
    }
    // The model lacks the effects, and the errors show it.
    let error = |k: usize| part["torque_error"][k]["rms"].as_f64().unwrap();
    assert!(error(1) > 2.0 * error(0), "{part}");
    let page = std::fs::read_to_string(page).unwrap();
    assert!(page.contains("Table IV") && page.contains("Fig. 13a") && !page.contains("NaN"));
    assert_eq!(page.matches("http").count(), page.matches("http://www.w3.org").count());
}
