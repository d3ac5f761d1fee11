//! Inputs that the program refuses, and its messages.

use crate::{root, run};

/// Asserts exit code 2 and an empty standard output, and compares the message with its snapshot.
fn refused(name: &str, arguments: &[&str]) {
    let output = run(arguments);
    let message = String::from_utf8(output.stderr).expect("messages are text");
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(output.stdout.is_empty());
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(root().join("snapshots/program"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, message));
}

#[test]
fn a_system_in_its_file_has_no_machine() {
    refused("a_system_in_its_file_has_no_machine", &["run", "scenes/friction/jam.toml", "--model", "synchronous"]);
}

#[test]
fn a_system_in_its_file_has_one_form() {
    refused("a_system_in_its_file_has_one_form", &["run", "scenes/friction/jam.toml", "--form", "first"]);
}

#[test]
fn a_scene_that_is_not_there() {
    refused("a_scene_that_is_not_there", &["run", "scenes/no_such.toml"]);
}

#[test]
fn a_folder_in_place_of_a_scene() {
    refused("a_folder_in_place_of_a_scene", &["run", "scenes"]);
}

#[test]
fn a_model_whose_data_the_scene_lacks() {
    refused("a_model_whose_data_the_scene_lacks", &["run", "scenes/spin_up.toml", "--model", "asynchronous"]);
}

#[test]
fn a_model_that_does_not_exist() {
    refused("a_model_that_does_not_exist", &["run", "scenes/spin_up.toml", "--model", "synchronos"]);
}

#[test]
fn a_motor_whose_laws_stand_nowhere() {
    refused("a_motor_whose_laws_stand_nowhere", &["conform", "text"]);
    refused("a_model_whose_laws_stand_nowhere", &["run", "scenes/spin_up.toml", "--model", "text"]);
}

#[test]
fn nothing_of_an_argument_acts_on_the_terminal() {
    let hostile = "A\u{1b}[31m\u{1b}]0;T\u{7}\u{9b}2J\u{202e}B";
    for arguments in [
        ["run", "scenes/spin_up.toml", "--model", hostile],
        ["run", hostile, "--seconds", "1"],
        ["run", "scenes/spin_up.toml", "--method", hostile],
        ["derive", hostile, "--principle", hostile],
        ["conform", hostile, "--format", "text"],
        ["bodies", "scenes/spin_up.toml", hostile, hostile],
    ] {
        let output = run(&arguments);
        let message = String::from_utf8(output.stderr).expect("messages are text");
        assert_eq!(output.status.code(), Some(2), "{message:?}");
        assert!(!message.contains(['\u{1b}', '\u{7}', '\u{9b}', '\u{202e}']), "{message:?}");
    }
}

#[test]
fn a_method_that_does_not_exist() {
    refused("a_method_that_does_not_exist", &["run", "scenes/spin_up.toml", "--method", "radau5"]);
}

#[test]
fn a_method_with_too_many_stages() {
    refused("a_method_with_too_many_stages", &["run", "scenes/spin_up.toml", "--method", "gauss:99"]);
}

#[test]
fn a_tolerance_of_zero() {
    refused("a_tolerance_of_zero", &["run", "scenes/spin_up.toml", "--tol", "0"]);
}

#[test]
fn a_tolerance_that_is_no_number() {
    refused("a_tolerance_that_is_no_number", &["run", "scenes/spin_up.toml", "--tol", "NaN"]);
}

#[test]
fn a_time_that_is_no_whole_number_of_seconds() {
    refused("a_time_that_is_no_whole_number_of_seconds", &["run", "scenes/spin_up.toml", "--seconds", "0.2"]);
}

#[test]
fn a_form_that_does_not_exist() {
    refused("a_form_that_does_not_exist", &["run", "scenes/spin_up.toml", "--form", "third"]);
}

#[test]
fn a_name_that_ends_as_no_form_of_the_command() {
    for (name, arguments) in [
        ("output_run", &["run", "scenes/bench.toml", "--out", "table.png"][..]),
        ("output_chart", &["chart", "scenes/bench.toml", "--out", "chart.png"]),
        ("output_choose", &["choose", "scenes/bench.toml", "--out", "models.csv"]),
        ("output_reference", &["reference", "scenes/bench.toml", "--out", "bench.txt"]),
        ("output_ensemble", &["ensemble", "scenes/ensembles/spread.toml", "--out", "table"]),
        ("output_report", &["--out", "report.txt"]),
    ] {
        refused(name, arguments);
    }
}

#[test]
fn an_output_over_an_input_or_over_what_the_program_did_not_write() {
    refused("output_over_its_scene", &["run", "scenes/bench.toml", "--out", "scenes/bench.toml"]);
}

#[test]
fn options_that_would_be_ignored() {
    for (name, arguments) in [
        ("ignored_form_bench", &["run", "scenes/bench.toml", "--form", "second"][..]),
        ("ignored_form_chart", &["chart", "scenes/bench.toml", "--form", "second"]),
        ("ignored_form_derive", &["derive", "gyrostat", "--form", "second"]),
        ("ignored_form_code", &["derive", "scenes/bench.toml", "--form", "first", "--format", "c"]),
        ("ignored_form_motor", &["derive", "scenes/spin_up.toml", "--form", "first"]),
        ("ignored_tolerance", &["run", "scenes/bench.toml", "--method", "runge_kutta_4:10", "--tol", "1e-3"]),
        ("ignored_model", &["conform", "synchronous", "--model", "kloss"]),
        ("ignored_omega0", &["numerical-stability", "scenes/bench.toml", "--omega0", "3"]),
        ("ignored_axis", &["chart", "scenes/bench.toml", "--x", "time", "--out", "chart.html"]),
        ("ignored_force", &["run", "scenes/bench.toml", "--force"]),
    ] {
        refused(name, arguments);
    }
}

#[test]
fn a_folder_in_place_of_a_table() {
    refused("a_folder_in_place_of_a_table", &["run", "scenes/bench.toml", "--out", "scenes"]);
}

#[test]
fn a_folder_of_scenes_that_does_not_exist() {
    refused("a_folder_of_scenes_that_does_not_exist", &["scenes", "no_such_folder"]);
}

#[test]
fn a_folder_without_scenes() {
    refused("a_folder_without_scenes", &["scenes", "snapshots"]);
}

/// A scene with absurdly large values: the model does not exist for a mechanism, and the message says so.
#[test]
fn a_mechanism_has_no_machine() {
    refused("a_mechanism_has_no_machine", &["run", "scenes/governors/blow_up.toml", "--model", "synchronous"]);
}

#[test]
fn a_chart_across_events_has_one_form_and_its_reference_one_end() {
    refused("a_chart_across_events", &["chart", "scenes/friction/jam.toml", "--form", "second"]);
    refused("a_reference_across_events", &["reference", "scenes/friction/jam.toml", "--until", "0.01"]);
}

#[test]
fn stationary_motions_of_what_has_none_are_refused() {
    refused("stationary_bench", &["stationary", "scenes/bench.toml"]);
    refused("stationary_ladder", &["stationary", "scenes/friction/painleve.toml"]);
    refused("stationary_speed", &["stationary", "scenes/spin_up.toml", "--omega0", "fast"]);
    refused("stationary_infinite", &["stationary", "scenes/spin_up.toml", "--momentum", "inf"]);
}

#[test]
fn a_map_over_what_is_no_range_or_one_datum_or_the_motor_is_refused() {
    let scene = "scenes/closed_forms/upright_rotation.toml";
    refused("map_falling", &["stationary", scene, "--map", "load=0.1..-0.1"]);
    refused("map_single", &["stationary", scene, "--map", "load=-0.1..0.1"]);
    refused("map_motor", &["stationary", scene, "--map", "gravity=0..9", "--map", "machine.b0=0..1"]);
}

#[test]
fn motors_that_follow_no_field_are_refused() {
    refused("motor_asynchronous", &["motor", "scenes/asynchronous_drive.toml"]);
    refused("motor_ladder", &["motor", "scenes/friction/painleve.toml"]);
    refused("motor_without_data", &["motor", "scenes/bench.toml", "--model", "kloss"]);
}

#[test]
fn a_way_to_fail_that_is_not_known() {
    refused("a_way_to_fail_that_is_not_known", &["failures", "sunspots"]);
}

#[test]
fn what_cannot_be_chosen_from_is_refused() {
    refused("choose_in_its_file", &["choose", "scenes/friction/jam.toml", "--model", "synchronous"]);
    refused("choose_output", &["choose", "scenes/bench.toml", "--outputs", "slip,speed"]);
    refused("choose_model", &["choose", "scenes/governors/released.toml", "--model", "synchronous"]);
}

#[test]
fn a_place_that_cannot_be_written_is_told_before_the_work() {
    let begin = std::time::Instant::now();
    for (place, why) in [("scenes", "this is a folder"), ("README.md/page.html", "a part of its path is not a folder")]
    {
        for command in [&["--out", place][..], &["chart", "scenes/spin_up.toml", "--out", place]] {
            let output = run(command);
            let message = String::from_utf8(output.stderr).expect("messages are text");
            assert_eq!(output.status.code(), Some(2), "{message}");
            assert!(message.contains(&format!("{place} cannot be written: {why}")), "{message}");
            assert!(output.stdout.is_empty());
        }
    }
    // the computation itself would take minutes
    assert!(begin.elapsed().as_secs() < 20, "{:?}", begin.elapsed());
}
