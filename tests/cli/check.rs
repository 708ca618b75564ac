use super::*;

#[test]
fn every_robot_passes_and_says_what_the_contract_lists() {
    let robots = std::fs::read_dir(PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("robots")).unwrap();
    let mut seen = 0;
    for path in robots.map(|entry| entry.unwrap().path()).filter(|p| p.extension().is_some_and(|e| e == "yaml")) {
        let path = path.display().to_string();
        let said = json(&["check", &path, "--json", "-"]);
        assert_eq!(said["dof"], read_robot(&path).dof());
        assert!(said["name"].is_string() && said["ik"]["class"].is_string());
        for parameter in said["base_parameters"].as_array().unwrap() {
            let (name, grouping) = (parameter["name"].as_str().unwrap(), parameter["grouping"].as_str().unwrap());
            let coefficients = parameter["coefficients"].as_object().unwrap();
            let leader = name.strip_suffix('R').unwrap_or(name);
            assert_eq!(coefficients[leader], 1.0, "{path}: {name}");
            assert_eq!(name.ends_with('R'), coefficients.len() > 1, "{path}: {name}");
            assert!(
                coefficients.len() == 1 || grouping.starts_with(&format!("{name} = {leader}")),
                "{path}: {grouping}"
            );
        }
        for function in ["base_regressor", "inverse_dynamics_base", "regressor", "mass_matrix"] {
            for count in ["mul", "add", "sincos"] {
                assert!(said["operations"][function][count].is_u64(), "{path}: {function}.{count}");
            }
        }
        seen += 1;
    }
    assert!(seen >= 10);
}

#[test]
fn the_text_holds_table_class_groupings_and_counts() {
    let run = denavit(&["check", "robots/kuka-lwr4.yaml"]);
    assert_eq!(run.status, Some(0));
    for part in ["7 degrees of freedom", "pi/2", "L3", "kinematic class", "57 of 84", "ZZ1R = ZZ1 + ", "base_regressor"]
    {
        assert!(run.out.contains(part), "no `{part}` in\n{}", run.out);
    }
}

#[test]
fn json_goes_to_a_file_and_the_text_still_to_the_terminal() {
    let path = folder("check").join("check.json");
    let run = denavit(&["check", "robots/scara.yaml", "--json", &path.display().to_string()]);
    assert_eq!(run.status, Some(0));
    assert!(run.out.contains("scara"));
    let said: serde_json::Value = serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap();
    assert_eq!(said["name"], "scara");
}

#[test]
fn every_verb_shows_an_example() {
    let all = denavit(&["--help"]);
    assert_eq!(all.status, Some(0));
    for verb in ["check", "generate", "eval", "factor", "identify"] {
        assert!(all.out.contains(verb));
        let help = denavit(&[verb, "--help"]);
        assert_eq!(help.status, Some(0));
        assert!(help.out.contains(&format!("Example:\n  denavit {verb} ")), "{}", help.out);
    }
}
