//! Bounds on the data: every datum of a motor or scene that must be positive is checked, and named in the message.

use dalembert_derivations::studies::scene::Scene;
use reader::{Allowed, Bound, Family};

/// A motor of the catalogue on a bench, with the data of a small motor and one datum replaced.
fn on_a_bench(model: &str, other: &str, value: &str, allowed: &str) -> String {
    let motor = dalembert_derivations::studies::conformance::sample(model).expect("it is in the catalogue");
    let numbers = motor.data().map(|(quantity, number)| {
        let number = if quantity.name == other { value.to_owned() } else { number.to_string() };
        let unit = if quantity.unit == "1" { "" } else { &quantity.unit };
        format!("{} = \"{number} {unit}\"\n", quantity.name)
    });
    let counts = motor.laws().counts().iter().map(|(count, number)| format!("{} = {number}\n", count.name));
    let data: String = numbers.chain(counts).collect();
    let speed = if model == "constant_speed" { "" } else { "rotor_speed = \"0 rad/s\"\n" };
    format!(
        "title = \"a motor\"\nsystem = \"bench\"\n{allowed}[rotor]\naxial = \"1 g m^2\"\n[machine]\nmodel = \"{model}\"\n{data}\
         [start]\n{speed}[run]\nspan = \"1 s\"\n"
    )
}

#[test]
fn every_inductance_resistance_and_friction_of_the_motors_is_judged_and_named() {
    let mut judged = 0;
    for entry in motor::catalogue::entries() {
        let model = entry.name;
        for quantity in entry.data {
            let (words, accepts_zero) = match &*quantity.unit {
                "H" => (None, false),
                "ohm" => (Some("allow = [\"zero resistance\", \"negative resistance\"]\n"), false),
                "N m s" => (Some("allow = [\"negative friction\"]\n"), true),
                _ => continue,
            };
            for value in ["0", "-0.5"] {
                let parse =
                    |allowed: &str| Scene::parse("scene.toml", &on_a_bench(model, &quantity.name, value, allowed));
                let accepted = accepts_zero && value == "0";
                match parse("") {
                    Ok(_) => assert!(accepted, "{model}: {} = {value}", quantity.name),
                    Err(error) => {
                        let message = error.to_string();
                        let named = message.contains(&format!("`{}`", quantity.name));
                        assert!(!accepted && error.issues.len() == 1 && named, "{message}");
                        judged += 1;
                    }
                }
                if let Some(words) = words {
                    parse(words).unwrap_or_else(|error| panic!("{error}"));
                }
            }
        }
    }
    assert!(judged > 30, "{judged}");
}

#[test]
fn masses_inductances_resistances_and_friction_of_every_scene_are_judged() {
    let mut files = vec![std::path::PathBuf::from("scenes")];
    let mut judged = 0;
    while let Some(path) = files.pop() {
        if path.is_dir() {
            files.extend(std::fs::read_dir(&path).expect("a folder").map(|entry| entry.expect("an entry").path()));
            continue;
        }
        if path.extension().is_none_or(|extension| extension != "toml") {
            continue;
        }
        let text = std::fs::read_to_string(&path).expect("a scene is text");
        // for text models, `crates/scenes` checks the masses that result from expressions
        if text.contains("\n[coordinates]") {
            continue;
        }
        // data of an ensemble, and parameters of text motors, are checked by the laws that contain them
        let end = text.find("[ensemble").or_else(|| text.find("[machine.parameters]")).unwrap_or(text.len());
        for line in text[..end].lines() {
            let Some((key, value)) = line.split_once(" = \"") else { continue };
            let units = ["kg\"", "kg m^2\"", "H\"", "mH\"", "ohm\"", "N m s\"", "N s/m\""];
            let number =
                value.split(' ').next().filter(|number| value.split(' ').count() > 1 && number.parse::<f64>().is_ok());
            let (Some(number), true) = (number, units.iter().any(|unit| value.ends_with(&format!(" {unit}")))) else {
                continue;
            };
            // an angular momentum has the unit of friction, and a mutual inductance may have either sign
            if ["gyroscope", "mutual"].contains(&key.trim()) {
                continue;
            }
            let negative = line.replace(&format!("\"{number}"), "\"-1.25");
            let error =
                dalembert_derivations::studies::AnyScene::parse("scene.toml", &text.replacen(line, &negative, 1))
                    .expect_err(&format!("{}: {negative}", path.display()));
            assert!(error.to_string().contains("-1.25"), "{}: {error}", path.display());
            judged += 1;
        }
    }
    assert!(judged > 100, "{judged}");
}

#[test]
fn a_bound_holds_unless_a_file_asks_for_more() {
    let none = Allowed::default();
    assert!(Bound::Resistance.holds(1.0, none) && !Bound::Resistance.holds(0.0, none));
    assert!(Bound::Friction.holds(0.0, none) && !Bound::Friction.holds(-1.0, none));
    assert!(!Bound::Positive.holds(0.0, Allowed::ALL) && !Bound::NotZero.holds(0.0, Allowed::ALL));
    let mut asked = none;
    assert!(asked.add("negative resistance") && !asked.add("negative inductance"));
    assert!(Bound::Resistance.holds(-1.0, asked) && !Bound::Resistance.holds(0.0, asked));
    for bound in [Bound::Any, Bound::Positive, Bound::NotNegative, Bound::NotZero, Bound::Resistance, Bound::Friction] {
        assert!(!bound.holds(f64::NAN, Allowed::ALL), "{bound:?}");
    }
}

#[test]
fn every_word_of_the_key_is_known() {
    let mut all = Allowed::default();
    assert!(Allowed::WORDS.iter().all(|word| all.add(word)));
    assert_eq!(all, Allowed::ALL);
}
