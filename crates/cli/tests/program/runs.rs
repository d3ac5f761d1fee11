//! Runs, charts and lists of scenes.

use crate::{json, program, root, run, table_at, temporary};
use serde_json::Value;
use std::io::Read;
use std::process::Stdio;

#[test]
fn a_run_prints_one_object_with_what_was_promised() {
    let output = run(&["run", "scenes/free_rotor.toml", "--format", "json", "--samples", "10"]);
    assert_eq!(output.status.code(), Some(0));
    let run = json(&output);
    let keys: Vec<&String> = run.as_object().expect("an object").keys().collect();
    assert!(
        ["time", "state", "work", "invariants", "model", "method"].iter().all(|key| keys.contains(&&(*key).to_owned()))
    );
    assert_eq!(run["time"], 2.0);
    assert_eq!(run["model"], "free_rotor");
    let invariants = run["invariants"].as_object().expect("an object");
    assert_eq!(invariants.len(), 4);
    assert!(invariants.values().all(|invariant| invariant["largest_deviation"].as_f64().is_some_and(|d| d < 1e-7)));
}

#[test]
fn both_forms_print_the_same_state() {
    let [first, second] = ["first", "second"].map(|form| {
        json(&run(&["run", "scenes/permanent_rotation.toml", "--form", form, "--samples", "1", "--format", "json"]))
    });
    assert_ne!(first["form"], second["form"]);
    let (first, second) = (first["state"].as_object().expect("states"), second["state"].as_object().expect("states"));
    for (name, value) in first {
        let (a, b) = (value.as_f64().expect("a number"), second[name].as_f64().expect("a number"));
        assert!((a - b).abs() < 1e-9, "{name}: {a} {b}");
    }
}

#[test]
fn the_table_has_a_row_for_the_start_and_for_every_sample() {
    let path = temporary("table.csv");
    let output = run(&["run", "scenes/bench.toml", "--samples", "8", "--out", &path.to_string_lossy()]);
    assert_eq!(output.status.code(), Some(0));
    let table = table_at(&path);
    std::fs::remove_file(&path).expect("it is there");
    let lines: Vec<&str> = table.lines().collect();
    assert_eq!(lines.len(), 10);
    assert!(lines[0].starts_with("time [s],angle [rad],slip [rad/s],x [A],i1 [A]"));
    assert!(lines[1].starts_with("0,0,-150,"));
    assert!(lines[9].starts_with("2,"));
}

/// Explicit steps much longer than the damper's time constant of 2 microseconds diverge at once.
#[test]
fn a_run_that_stops_says_why_and_keeps_what_it_has() {
    let path = temporary("stopped.csv");
    let asked = ["run", "scenes/stiff_damper.toml", "--method", "runge_kutta_4:2000", "--format", "json", "--out"];
    let output = run(&[&asked[..], &[&path.to_string_lossy()]].concat());
    let table = table_at(&path);
    std::fs::remove_file(&path).expect("it is there");
    assert_eq!(output.status.code(), Some(1));
    let run = json(&output);
    assert_eq!(run["reached"], false);
    assert!(run["stopped"].as_str().is_some_and(|reason| reason.contains("not finite")), "{run}");
    assert!(run["time"].as_f64().is_some_and(|time| time < 0.5));
    assert!(run["state"].as_object().expect("states").values().all(Value::is_number));
    assert!(table.lines().count() >= 2 && !table.contains("NaN") && !table.contains("inf"), "{table}");
}

/// A step of 1 ms is 500 time constants of the damper's currents: a backward sub-step of 1/24 of it lets them grow by exp(21).
#[test]
fn a_splitting_that_would_go_back_on_stiff_windings_says_which_step_it_takes() {
    let output = run(&[
        "run",
        "scenes/stiff_damper.toml",
        "--method",
        "blanes_moan_4:500",
        "--format",
        "json",
        "--samples",
        "1",
    ]);
    assert_eq!(output.status.code(), Some(1));
    let run = json(&output);
    assert_eq!((&run["reached"], &run["time"]), (&Value::from(false), &Value::from(0.0)));
    let parts = [
        "at t = 0: a sub-step goes back by 0.042 of the step 1.00e-3",
        "5.00e5 would grow by exp(21.0)",
        "at most 9.51e-5",
    ];
    assert!(run["stopped"].as_str().is_some_and(|why| parts.iter().all(|part| why.contains(part))), "{run}");
}

/// The field rotates so fast that even steps at the size of rounding are too long.
#[test]
fn a_step_that_collapses_ends_the_run_with_a_reason() {
    let path = temporary("collapse.toml");
    let text = std::fs::read_to_string(root().join("scenes/bench.toml")).expect("it is there");
    std::fs::write(&path, text.replace("150 rad/s", "1e200 rad/s")).expect("it can be written");
    let output = run(&["run", &path.to_string_lossy(), "--format", "json"]);
    std::fs::remove_file(&path).expect("it is there");
    assert_eq!(output.status.code(), Some(1));
    let run = json(&output);
    assert!(run["stopped"].as_str().is_some_and(|reason| reason.starts_with("step collapsed")), "{run}");
    assert!(run["state"].as_object().expect("states").values().all(Value::is_number));
}

#[test]
fn a_run_that_takes_too_long_is_stopped() {
    let path = temporary("long.toml");
    let text = std::fs::read_to_string(root().join("scenes/bench.toml")).expect("it is there");
    std::fs::write(&path, text.replace("150 rad/s", "1e200 rad/s")).expect("it can be written");
    let output = run(&["run", &path.to_string_lossy(), "--method", "gauss", "--seconds", "1", "--format", "json"]);
    std::fs::remove_file(&path).expect("it is there");
    assert_eq!(output.status.code(), Some(1));
    assert!(json(&output)["stopped"].as_str().is_some_and(|reason| reason.starts_with("out of time")));
}

#[test]
fn a_chart_lists_every_method_and_draws_itself() {
    for (file, needle) in [("chart.svg", "<svg"), ("chart.html", "<!DOCTYPE html>")] {
        let path = temporary(file);
        let output = run(&["chart", "scenes/constant_speed.toml", "--seconds", "10", "--out", &path.to_string_lossy()]);
        let table = String::from_utf8(output.stdout).expect("text");
        assert_eq!(output.status.code(), Some(0), "{table}");
        assert!(["Dormand-Prince 8", "Gauss", "Rodas4", "1e-13"].iter().all(|word| table.contains(word)), "{table}");
        let drawn = std::fs::read_to_string(&path).expect("it was written");
        std::fs::remove_file(&path).expect("it is there");
        assert!(drawn.contains(needle) && drawn.contains("Runge-Kutta 4"));
    }
}

/// The report on a folder with one small scene.
#[test]
fn the_report_is_one_page_with_the_scene_and_its_charts() {
    let folder = temporary("scenes");
    std::fs::create_dir_all(&folder).expect("a temporary folder");
    std::fs::copy(root().join("scenes/free_rotor.toml"), folder.join("free_rotor.toml")).expect("it can be copied");
    let page = folder.join("page/index.html");
    let output = run(&["--scenes", &folder.to_string_lossy(), "--out", &page.to_string_lossy()]);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let html = std::fs::read_to_string(&page).expect("it was written");
    std::fs::remove_dir_all(&folder).expect("it is there");
    assert!(html.contains("a fall from the unstable top") && html.matches("<svg").count() >= 3);
    let mut ids: Vec<&str> =
        html.split(" id=\"").skip(1).filter_map(|rest| rest.split('"').next()).filter(|id| !id.is_empty()).collect();
    let all = ids.len();
    ids.sort_unstable();
    ids.dedup();
    assert_eq!(ids.len(), all, "each place of the page has a name of its own");
}

#[test]
fn a_run_across_events_writes_its_table_and_its_log() {
    let path = temporary("rough.csv");
    let asked = ["run", "scenes/friction/climbed_ladder.toml", "--samples", "8", "--format", "json", "--out"];
    let output = run(&[&asked[..], &[&path.to_string_lossy()]].concat());
    assert_eq!(output.status.code(), Some(1), "it ends by an impact");
    let run = json(&output);
    let log = run["events"].as_array().expect("a log");
    assert_eq!(log.len(), 5);
    assert!(run["stopped"].as_str().is_some_and(|why| why.contains("impact")), "{run}");
    // each event is logged with the state and the reactions at its instant
    assert!(log.iter().all(|event| event["state"]["N_floor"].as_f64().is_some_and(|normal| normal > 0.0)), "{run}");
    assert_eq!((&log[4]["what"], &log[4]["then"]), (&"contact `top` closes".into(), &Value::Null));
    let table = table_at(&path);
    std::fs::remove_file(&path).expect("it is there");
    let head = "time [s],x [m],y [m],alpha [rad],x' [m/s],y' [m/s],alpha' [rad/s],N_wall [N],T_wall [N],";
    assert!(table.starts_with(head), "{table}");
    assert!(table.lines().count() > 3 && !table.contains("NaN"), "{table}");
}

#[test]
fn a_start_without_a_motion_ends_the_run_with_the_reason_and_its_place() {
    let output = run(&["run", "scenes/friction/painleve.toml"]);
    let told = String::from_utf8_lossy(&output.stdout).into_owned();
    assert_eq!(output.status.code(), Some(1), "{told}");
    for words in [
        "does not begin: no combination of cases of conditions and contacts is consistent",
        "these contacts; accepted is another start",
    ] {
        assert!(told.contains(words), "{words} in {told}");
    }
}

#[test]
fn the_report_tells_what_happened_across_events() {
    let folder = temporary("rough_scenes");
    std::fs::create_dir_all(folder.join("inside")).expect("a temporary folder");
    let copy = |from: &str, to: &str| std::fs::copy(root().join(from), folder.join(to)).expect("it can be copied");
    copy("scenes/friction/pushed_ladder.toml", "inside/pushed_ladder.toml");
    // a scene that cannot be read is reported, and does not stop the others
    let bench = std::fs::read_to_string(root().join("scenes/bench.toml")).expect("it is there");
    let unknown = bench.replace("\"multi_current\"", "\"not_built_yet\"");
    std::fs::write(folder.join("unread.toml"), unknown).expect("it can be written");
    let page = folder.join("page/index.html");
    let output = run(&["--scenes", &folder.to_string_lossy(), "--out", &page.to_string_lossy()]);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.code() == Some(1) && said.contains("unknown machine `not_built_yet`"), "{said}");
    let html = std::fs::read_to_string(&page).expect("it was written");
    std::fs::remove_dir_all(&folder).expect("it is there");
    let told =
        ["What happened, and why", "contact `wall` sticks, contact `floor` sticks", "not_built_yet", "unread.toml"];
    assert!(told.iter().all(|it| html.contains(it)));
}

#[test]
fn a_smaller_model_is_named_in_the_result() {
    let output = run(&["run", "scenes/spin_up.toml", "--model", "equivalent_windings", "--format", "json"]);
    assert_eq!(json(&output)["model"], "equivalent_windings");
}

#[test]
fn a_reader_who_stops_reading_is_no_error() {
    for arguments in [&["scenes"][..], &["run", "--help"], &["run", "scenes/bench.toml", "--format", "json"]] {
        let mut child = program(arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("it starts");
        drop(child.stdout.take());
        let mut message = String::new();
        child.stderr.take().expect("piped").read_to_string(&mut message).expect("messages are text");
        assert_eq!(child.wait().expect("it ends").code(), Some(0), "{arguments:?}: {message}");
        assert_eq!(message, "", "{arguments:?}");
    }
}

#[test]
fn the_list_of_scenes_names_each_with_its_machine() {
    let output = run(&["scenes"]);
    let list = String::from_utf8(output.stdout).expect("text");
    assert!(
        list.lines().count() >= 29
            && ["pull_out.toml", "friction/jam.toml", "governors/blow_up.toml"].iter().all(|file| list.contains(file)),
        "{list}"
    );
    assert!(!list.contains("faults"), "{list}");
}

#[test]
fn numbers_at_the_edge_of_the_range_end_with_a_reason() {
    let path = temporary("huge.toml");
    let text = std::fs::read_to_string(root().join("scenes/bench.toml")).expect("it is there");
    let text = text.replace("span = \"2 s\"", "span = \"1e300 s\"").replace("150 rad/s", "1e300 rad/s");
    std::fs::write(&path, text).expect("it can be written");
    let output = run(&["run", &path.to_string_lossy(), "--format", "json"]);
    std::fs::remove_file(&path).expect("it is there");
    assert_eq!(output.status.code(), Some(1), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(json(&output)["stopped"].is_string());
}

#[test]
fn a_row_of_the_ledger_says_in_text_and_json_how_it_was_read() {
    let output = run(&["ledger", "manglieva2022/eq3.17/sleeve", "--format", "json"]);
    let rows = json(&output);
    let reading = rows[0]["reading"].as_str().expect("a row that was read in one of two ways says so");
    let text = String::from_utf8(run(&["ledger", "manglieva2022/eq3.17/sleeve"]).stdout).expect("text");
    assert!(reading.contains(r"$+a\lambda$") && text.contains(&format!("reading: {reading}")), "{text}");
}

#[test]
fn the_ledger_lists_one_verdict_where_it_is_asked_to() {
    let output = run(&["ledger", "konosevich2022/statement", "--verdict", "refuted", "--format", "json"]);
    let rows = json(&output);
    let rows = rows.as_array().expect("an array");
    assert!(!rows.is_empty() && rows.iter().all(|row| row["verdict"] == "refuted"));
    let output = run(&["ledger", "--verdict", "wrong"]);
    assert_eq!(output.status.code(), Some(2));
    let message = String::from_utf8(output.stderr).expect("messages are text");
    assert!(message.contains("there is no verdict `wrong`; there are: refuted, "), "{message}");
}

#[test]
fn a_blow_up_is_said_by_name_beside_the_time_of_the_closed_form() {
    let output = run(&["run", "scenes/governors/blow_up.toml", "--format", "json"]);
    assert_eq!(output.status.code(), Some(1));
    let run = json(&output);
    let diagnosis = run["diagnosis"].as_str().expect("it is named");
    assert!(diagnosis.starts_with("blow-up in finite time") && diagnosis.contains("t = 1.102500000000 s"), "{run}");
    assert!(run["time"].as_f64().is_some_and(|time| (time - 1.1025).abs() < 1e-9), "{run}");
    assert!(run["closed_form"]["deviation"].as_f64().is_some_and(|off| off < 1e-10), "{run}");
    assert_eq!((&run["model"], &run["form"]), (&Value::from("as written in its file"), &Value::Null));
}

#[test]
fn a_start_beyond_the_end_of_the_law_is_refused() {
    let text = std::fs::read_to_string(super::root().join("scenes/governors/between_discs.toml")).expect("it is there");
    let path = temporary("beyond.toml");
    std::fs::write(&path, text.replace("rho = \"300 mm\"", "rho = \"900 mm\"")).expect("it can be written");
    let output = run(&["run", &path.to_string_lossy()]);
    std::fs::remove_file(&path).expect("it is there");
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(message.contains("the law does not hold at the start") && message.contains("second disc"), "{message}");
}

/// One motion beyond a pole of the law, and one motion that constant steps follow.
#[test]
fn constant_steps_say_whether_shorter_ones_come_nearer() {
    let asked = |scene, method| json(&run(&["run", scene, "--method", method, "--format", "json"]));
    // one long step ends beyond the pole; shorter steps end before it, with the domain of the law
    let behind = asked("scenes/failures/nodding_top.toml", "euler:20");
    assert_eq!(
        (&behind["reached"], &behind["steps"]["follows"]),
        (&Value::from(true), &Value::from(false)),
        "{behind}"
    );
    assert!(behind["steps"]["from"].as_f64().is_some_and(|from| (2.5..5.0).contains(&from)), "{behind}");
    let ended = asked("scenes/failures/nodding_top.toml", "runge_kutta_4:1000");
    assert!(ended["reached"] == false && ended["diagnosis"].is_string(), "{ended}");
    let followed = asked("scenes/bench.toml", "runge_kutta_4:4000");
    assert!(followed["steps"]["apart"].as_f64().is_some_and(|apart| apart < 1e-3), "{followed}");
    assert!(asked("scenes/bench.toml", "radau_5")["steps"].is_null());
}

#[test]
fn a_run_is_drawn_on_one_sheet_with_what_should_stay_zero() {
    let path = temporary("sheet.svg");
    let asked = ["run", "scenes/models/slider_crank.toml", "--plot", &path.to_string_lossy()].map(str::to_owned);
    let asked: Vec<&str> = asked.iter().map(String::as_str).collect();
    let output = run(&asked);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let picture = std::fs::read_to_string(&path).expect("it was written");
    for shown in ["time, s", "theta, rad", "theta', rad/s", "change of energy less work", "residual of constraints"] {
        assert!(picture.contains(&shown.replace('\'', "&#39;")) || picture.contains(shown), "{shown}: {picture}");
    }
    // the program replaces its own file
    assert_eq!(run(&asked).status.code(), Some(0));
    std::fs::write(&path, "mine").expect("it can be written");
    let output = run(&asked);
    assert_eq!((output.status.code(), std::fs::read_to_string(&path).ok().as_deref()), (Some(2), Some("mine")));
    std::fs::remove_file(&path).expect("it is there");
    let named = run(&["run", "scenes/models/slider_crank.toml", "--plot", "picture.png"]);
    assert!(named.status.code() == Some(2) && String::from_utf8_lossy(&named.stderr).contains(".svg"));
}

#[test]
fn a_mechanism_writes_its_table_and_takes_another_method() {
    let path = temporary("mechanism.csv");
    let asked =
        ["run", "scenes/drive/euler_bears.toml", "--method", "radau_5", "--tol", "1e-6", "--samples", "5", "--out"];
    let output = run(&[&asked[..], &[&path.to_string_lossy()]].concat());
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let table = table_at(&path);
    std::fs::remove_file(&path).expect("it is there");
    let columns = "time [s],q1 [C],q2 [C],q4 [C],q5 [C],q6 [rad],q7 [m],q1' [A],q2' [A],q4' [A],q5' [A],q6' [rad/s],q7' [m/s],\
                   q3 [s A],violation [m^2],violation_rate [m^2 s^-1],kinetic_energy [J],potential_energy [J],work [J]\n";
    assert!(table.starts_with(columns), "{table}");
    assert_eq!(table.lines().count(), 7);
}

#[test]
fn a_chart_of_a_mechanism_lists_every_method_and_says_why_there_is_none() {
    let output = run(&["chart", "scenes/governors/drum_programme.toml", "--seconds", "10"]);
    let table = String::from_utf8(output.stdout).expect("text");
    assert_eq!(output.status.code(), Some(0), "{table}");
    assert!(["Dormand-Prince 8", "Gauss", "Taylor", "1e-13"].iter().all(|word| table.contains(word)), "{table}");
    let output = run(&["chart", "scenes/governors/blow_up.toml", "--seconds", "10"]);
    let table = String::from_utf8(output.stdout).expect("text");
    assert_eq!(output.status.code(), Some(1), "{table}");
    assert!(table.contains("no reference") && table.contains("blow-up in finite time"), "{table}");
    let output = run(&["chart", "scenes/bodies/falling_disc.toml"]);
    let table = String::from_utf8(output.stdout).expect("text");
    assert_eq!(output.status.code(), Some(1), "{table}");
    assert!(table.contains("before its span") && table.contains("the disc lies flat"), "{table}");
    let output = run(&["reference", "scenes/bodies/falling_disc.toml", "--out", "/dev/null"]);
    let message = String::from_utf8(output.stderr).expect("text");
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(message.contains("--until with a time up to 0.8"), "{message}");
}

#[test]
fn nothing_of_a_title_acts_on_the_terminal_or_in_a_file() {
    let title = r#""A\u001b[31mRED\u001b]0;TITLE\u0007\u009b2J\u202e B </text><script>""#;
    let scene = std::fs::read_to_string(root().join("scenes/spin_up.toml")).expect("it is there");
    let line = scene.lines().find(|line| line.starts_with("title = ")).expect("it has a title");
    let path = temporary("hostile.toml");
    std::fs::write(&path, scene.replace(line, &format!("title = {title}"))).expect("a temporary file can be written");
    let name = path.to_str().expect("the name is text");
    for arguments in [
        vec!["run", name],
        vec!["run", name, "--format", "json"],
        vec!["stationary", name],
        vec!["conform", name],
        vec!["conform", name, "--format", "json"],
        vec!["bodies", name],
        vec!["derive", name, "--format", "c"],
    ] {
        let output = run(&arguments);
        let told = String::from_utf8([output.stdout, output.stderr].concat()).expect("it is text");
        assert!(!told.contains(['\u{1b}', '\u{7}', '\u{9b}', '\u{202e}']), "{arguments:?}: {told:?}");
    }
    let object = json(&run(&["conform", name, "--format", "json"]));
    assert!(object["motor"].as_str().is_some_and(|title| title.contains("\u{1b}[31mRED")), "{object}");
    std::fs::remove_file(&path).expect("it is there");
}
