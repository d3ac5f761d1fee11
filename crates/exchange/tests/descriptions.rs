//! The model description of a functional mock-up unit.

use dalembert_exchange::fmu::{Unit, Variable, Version, seal_holds};

fn variable(name: &str, unit: &str) -> Variable {
    Variable { name: name.to_owned(), unit: unit.to_owned(), description: String::new(), value: 0.5 }
}

fn unit() -> Unit {
    Unit {
        version: Version::Three,
        identifier: "one".to_owned(),
        title: "A \"title\" <with> signs & a\nline".to_owned(),
        origin: "an origin */ of its own".to_owned(),
        tool: "a tool".to_owned(),
        tolerance: 1e-8,
        span: 2.0,
        states: vec![variable("time", "m"), variable("v", "m/s")],
        parameters: vec![variable("g", "m/s^2")],
        inputs: vec![variable("u", "N")],
        outputs: vec![variable("der(v)", "1")],
        locals: vec![variable("energy", "J")],
        indicators: vec![variable("event 1", "1")],
        source: "/* nothing */\n".to_owned(),
    }
}

/// The archive as text.
fn written(unit: &Unit) -> String {
    let mut bytes = Vec::new();
    unit.write(&mut bytes, None).expect("memory takes it");
    String::from_utf8_lossy(&bytes).into_owned()
}

#[test]
fn names_of_the_system_stay_and_those_of_the_standard_give_way() {
    let text = written(&unit());
    for part in [
        // a state with the name of the time
        "name=\"time\" valueReference=\"1\"",
        "name=\"time_\" valueReference=\"0\" causality=\"independent\"",
        // an output with the name of a derivative
        "name=\"der(v)\" valueReference=\"7\"",
        "name=\"der(v)_\" valueReference=\"4\"",
    ] {
        assert!(text.contains(part), "{part}: {text}");
    }
}

#[test]
fn texts_are_escaped_and_stay_on_one_line() {
    let text = written(&unit());
    assert!(text.contains("modelName=\"A &quot;title&quot; &lt;with&gt; signs &amp; a line\""), "{text}");
    assert!(text.contains("/* an origin * / of its own */"), "{text}");
}

#[test]
fn units_stand_by_the_base_units() {
    let text = written(&unit());
    assert!(
        text.contains("<BaseUnit kg=\"1\" m=\"1\" s=\"-2\"/>") && text.contains("<BaseUnit m=\"1\" s=\"-2\"/>"),
        "{text}"
    );
    assert!(!text.contains("unit=\"1\""), "a number has none");
}

#[test]
fn another_source_has_another_token() {
    let token = |unit: &Unit| {
        let text = written(unit);
        text.split("instantiationToken=\"").nth(1).and_then(|rest| rest.split('"').next()).map(str::to_owned)
    };
    let other = Unit { source: "/* something */\n".to_owned(), ..unit() };
    assert_eq!(token(&unit()), token(&unit()));
    assert_ne!(token(&unit()), token(&other));
}

#[test]
fn version_2_counts_from_one_and_has_no_variables_of_indicators() {
    let unit = Unit { version: Version::Two, ..unit() };
    let text = written(&unit);
    for part in [
        "fmiVersion=\"2.0\"",
        "numberOfEventIndicators=\"1\"",
        "<File name=\"fmi2.c\"/>",
        // the state is the second variable, its derivative the fourth
        "name=\"time\" valueReference=\"1\"",
        "<Real unit=\"m\" start=\"0.5\"/>",
        "name=\"der(time)\" valueReference=\"3\"",
        "<Real derivative=\"2\"/>",
        "<Unknown index=\"4\"/>",
    ] {
        assert!(text.contains(part), "{part}: {text}");
    }
    assert!(!text.contains("event 1\" valueReference") && !text.contains("buildDescription"));
    assert!(text.contains("sources/fmi2.c") && text.contains("sources/fmi3.c"));
}

#[test]
fn a_unit_is_sealed() {
    let mut bytes = Vec::new();
    unit().write(&mut bytes, None).expect("memory takes it");
    assert_eq!(seal_holds(&bytes), Some(true));
}
