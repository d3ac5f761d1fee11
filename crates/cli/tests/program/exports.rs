//! Files for other simulators: their content, and refusals with file and line.

use crate::{program_in, root};
use std::fs;
use std::path::PathBuf;
use std::process::Output;

/// A folder with a scene and the files written from it, deleted with this value.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let folder = crate::temporary(name);
        fs::create_dir_all(&folder).expect("a folder can be made");
        Folder(folder)
    }

    fn scene(&self, text: &str) {
        fs::write(self.0.join("scene.toml"), text).expect("it can be written");
    }

    fn export(&self, arguments: &[&str]) -> Output {
        program_in(&self.0, &[&["export", "scene.toml"], arguments].concat()).output().expect("the program starts")
    }

    /// The content of a file written by an export of the scene, as text.
    fn text(&self, option: &str, file: &str) -> String {
        let output = self.export(&[option, file]);
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8_lossy(&fs::read(self.0.join(file)).expect("it was written")).into_owned()
    }

    /// The message of a refusal.
    fn refused(&self, arguments: &[&str]) -> String {
        let output = self.export(arguments);
        assert_eq!(output.status.code(), Some(2), "{}", String::from_utf8_lossy(&output.stdout));
        String::from_utf8_lossy(&output.stderr).into_owned()
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn of_repository(name: &str) -> String {
    fs::read_to_string(root().join("scenes").join(name)).expect("a scene")
}

/// A mass that slides along x under a force; `rows` follow in its file.
fn sliding(force: &str, rows: &str) -> String {
    format!(
        "title = \"A <mass> & a \\\"force\\\"\"\n[parameters]\nm = \"2 kg\"\nF = \"3 N\"\nv0 = \"1 m/s\"\n[coordinates]\nx = \"m\"\n\
         [energies]\nkinetic = \"m*x'^2/2\"\n[[force]]\nalong = \"x\"\nis = \"{force}\"\n{rows}[start]\nx = \"1 m\"\n[run]\nspan = \"1 s\"\n"
    )
}

#[test]
fn a_unit_holds_its_description_its_sources_and_its_origin() {
    let folder = Folder::new("unit");
    folder.scene(&of_repository("models/bouncing_ball.toml"));
    let unit = folder.text("--fmu", "ball.fmu");
    for file in ["modelDescription.xml", "sources/buildDescription.xml", "sources/fmi3.c", "sources/system.h"] {
        assert!(unit.contains(file), "{file}");
    }
    for part in [
        "<ModelExchange modelIdentifier=\"ball\"",
        "<CoSimulation modelIdentifier=\"ball\"",
        "name=\"y&apos;\"",
        "name=\"e\" valueReference=\"7\" description=\"0.8\" causality=\"parameter\" variability=\"tunable\"",
        "<EventIndicator valueReference=\"10\"/>",
        "sha256 of the scene: ",
        "generationTool=\"dalembert export, version ",
    ] {
        assert!(unit.contains(part), "{part}");
    }
    // the same scene gives the same bytes, and the program replaces its own file
    let [first, second] = [(); 2].map(|()| {
        folder.text("--fmu", "ball.fmu");
        fs::read(folder.0.join("ball.fmu")).expect("it is there")
    });
    assert!(first == second, "the same bytes");
}

#[test]
fn a_title_with_signs_of_xml_is_written_right() {
    let folder = Folder::new("title");
    folder.scene(&sliding("-F*tanh(x'/v0)", ""));
    let unit = folder.text("--fmu", "mass.fmu");
    assert!(unit.contains("modelName=\"A &lt;mass&gt; &amp; a &quot;force&quot;\""), "the title");
}

#[test]
fn programs_say_their_origin_and_hold_the_start() {
    let folder = Folder::new("programs");
    folder.scene(&of_repository("models/bouncing_ball.toml"));
    for (option, file, start) in [
        ("--c", "ball.c", "const double start[] = {1.0, 0.0};"),
        ("--python", "ball.py", "START = np.array([1.0, 0.0])"),
        ("--rust", "ball.rs", "START: [f64; COORDINATES + SPEEDS] = [1.0, 0.0];"),
        ("--casadi", "ball_casadi.py", "START = [1.0, 0.0]"),
        ("--modelica", "Ball.mo", "reinit(yprime, "),
    ] {
        let text = folder.text(option, file);
        assert!(text.contains(start), "{option}: {text}");
        let first = text.lines().next().unwrap_or_default();
        assert!(
            first.trim_start_matches(['/', '#', ' ']).starts_with("made by: dalembert export, version "),
            "{first}"
        );
        assert!(text.lines().any(|line| line.ends_with("scene: scene.toml")), "{text}");
    }
    let told = String::from_utf8_lossy(&folder.export(&["--c", "ball.c"]).stderr).into_owned();
    assert!(told.contains("Events are not part of these equations"), "{told}");
}

#[test]
fn what_no_other_simulator_has_a_law_for_is_refused_at_its_line() {
    let folder = Folder::new("refused");
    for (text, line, why) in [
        (of_repository("models/dry_friction.toml"), None, "as dry friction that sticks"),
        (of_repository("models/leaning_ladder.toml"), None, "a system with a contact cannot be exported"),
        (
            of_repository("models/bridge_rectifier.toml"),
            None,
            "a system with a diode or a freewheel cannot be exported",
        ),
        (sliding("-F*sign(x')", ""), Some("scene.toml:12:"), "as dry friction that sticks"),
        (
            sliding("-F*tanh(x'/v0)", "").replace("\"3 N\"", "\"N\""),
            Some("scene.toml:4:"),
            "the parameter `F` has no value",
        ),
    ] {
        folder.scene(&text);
        for (option, file) in [("--fmu", "unit.fmu"), ("--modelica", "Model.mo")] {
            let message = folder.refused(&[option, file]);
            assert!(message.contains(why) && message.contains(line.unwrap_or("scene.toml:")), "{message}");
            assert!(!folder.0.join(file).exists(), "nothing is written");
        }
    }
}

#[test]
fn forces_that_bend_at_a_speed_and_do_not_jump_are_carried() {
    let folder = Folder::new("bends");
    for force in ["-F*abs(x')*x'/v0^2", "-min(F, max(-F, F*x'/v0))", "if(x > (0 m), -F, F)"] {
        folder.scene(&sliding(force, ""));
        assert!(folder.text("--fmu", "unit.fmu").contains("name=\"condition 1\""), "{force}");
    }
}

#[test]
fn one_file_is_asked_for_and_its_name_has_the_end_of_its_form() {
    let folder = Folder::new("asked");
    folder.scene(&sliding("-F*tanh(x'/v0)", ""));
    assert!(folder.refused(&[]).contains("--fmu"));
    assert!(folder.refused(&["--fmu", "a.fmu", "--c", "a.c"]).contains("cannot be used with"));
    assert!(folder.refused(&["--fmu", "a.zip"]).contains("writes .fmu files only"));
    assert!(folder.refused(&["--fmu", "a.fmu", "--fmi", "1"]).contains("2 and 3 are accepted"));
    assert!(folder.refused(&["--c", "a.c", "--fmi", "2"]).contains("accepted with --fmu"));
    fs::write(folder.0.join("mine.c"), "int main(void) { return 0; }\n").expect("it can be written");
    assert!(folder.refused(&["--c", "mine.c"]).contains("--force"));
}

#[test]
fn a_run_is_an_archive_of_numpy_too() {
    let folder = Folder::new("archive");
    folder.scene(&sliding("-F*tanh(x'/v0)", ""));
    let run = |arguments: &[&str]| {
        let output = program_in(&folder.0, &[&["run", "scene.toml", "--samples", "4"], arguments].concat()).output();
        assert_eq!(output.expect("the program starts").status.code(), Some(0), "{arguments:?}");
    };
    // the second run replaces the file of the first
    for _ in 0..2 {
        run(&["--out", "run.npz"]);
    }
    let bytes = fs::read(folder.0.join("run.npz")).expect("it was written");
    let text = String::from_utf8_lossy(&bytes).replace('\0', "");
    for part in
        ["provenance.npy", "columns.npy", "units.npy", "time.npy", "x'.npy", "method: dormand_prince_8", "tolerance: "]
    {
        assert!(text.contains(part), "{part}");
    }
    let first = text.find("time.npy").map(|at| &text[at..]).expect("times");
    assert!(first.contains("{'descr': '<f8', 'fortran_order': False, 'shape': (5,), }"), "{first}");
}

#[test]
fn a_program_that_was_changed_by_hand_is_left_alone() {
    let folder = Folder::new("changed");
    folder.scene(&of_repository("models/double_pendulum.toml"));
    for (option, file) in [("--c", "law.c"), ("--modelica", "law.mo"), ("--python", "law.py"), ("--rust", "law.rs")] {
        let first = folder.text(option, file);
        assert_eq!(folder.text(option, file), first, "its own file is written again");
        let changed = first.replacen('1', "2", 1) + "mine\n";
        fs::write(folder.0.join(file), &changed).expect("it can be written");
        let said = folder.refused(&[option, file]);
        assert!(said.contains("exists and is no unchanged program of `dalembert export`"), "{said}");
        assert_eq!(fs::read_to_string(folder.0.join(file)).expect("it is there"), changed);
        let output = folder.export(&[option, file, "--force"]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
    }
}

#[test]
fn a_unit_that_was_changed_is_left_alone() {
    let folder = Folder::new("changed_unit");
    folder.scene(&of_repository("models/double_pendulum.toml"));
    folder.text("--fmu", "unit.fmu");
    folder.text("--fmu", "unit.fmu");
    let path = folder.0.join("unit.fmu");
    let mut changed = fs::read(&path).expect("it was written");
    let place = changed.windows(9).position(|part| part == b"TOLERANCE").expect("its sources are not packed");
    changed[place] = b'X';
    fs::write(&path, &changed).expect("it can be written");
    let said = folder.refused(&["--fmu", "unit.fmu"]);
    assert!(said.contains("exists and is no unchanged unit of `dalembert export`"), "{said}");
    assert!(fs::read(&path).expect("it is there") == changed);
}

#[test]
fn a_condition_with_equality_holds_at_equality_in_each_language() {
    let folder = Folder::new("equality");
    folder.scene(&sliding("if(t >= (0.5 s), F, -F) + if(x > (1 m), F, 0)", ""));
    for (option, file, [with, without]) in [
        ("--c", "law.c", ["r0 >= 0.0 ? 1.0 : 0.0", "r0 > 0.0 ? 1.0 : 0.0"]),
        ("--python", "law.py", ["1.0 if r0 >= 0.0", "1.0 if r0 > 0.0"]),
        ("--rust", "law.rs", ["if r0 >= 0.0", "if r0 > 0.0"]),
        ("--casadi", "law_casadi.py", ["if_else(r0 >= 0.0", "if_else(r0 > 0.0"]),
        ("--modelica", "Law.mo", ["condition1 = if r", ">= 0 then 1 else 0"]),
    ] {
        let text = folder.text(option, file);
        assert!(text.contains(with) && text.contains(without), "{option}: {text}");
    }
}

#[test]
fn conditions_with_equal_expressions_have_one_case() {
    let folder = Folder::new("equal_conditions");
    // the condition in the middle holds the case of x > 0, which the table has as x - 0 > 0
    let table = "table(x, (0 m), 0, (2 m), 1)";
    folder.scene(&sliding(&format!("F*if(sign(x)*x < (2 m)*cos(x/(1 m)), 1, 2) + F*{table}"), ""));
    let text = folder.text("--c", "law.c");
    let cases: Vec<&str> = text.lines().filter(|line| line.contains("? 1.0 : 0.0")).collect();
    assert_eq!(cases.iter().filter(|line| line.contains("q[0] > 0.0")).count(), 1, "{cases:?}");
    assert!(text.contains("double s[3];"), "{text}");
}

#[test]
fn a_program_calls_every_function_that_it_imports() {
    let folder = Folder::new("imports");
    folder.scene(&sliding("-F*tanh(x'/v0)", ""));
    assert!(folder.text("--python", "law.py").contains("\nfrom numpy import tanh\n"));
    assert!(folder.text("--casadi", "law_casadi.py").contains("\nfrom casadi import tanh\n"));
    folder.scene(&sliding("-F*x'/v0", ""));
    assert!(!folder.text("--python", "law.py").contains("from numpy"));
}

#[test]
fn a_program_names_the_conditions_that_may_stick() {
    let folder = Folder::new("named_conditions");
    folder.scene(&sliding("-F*sign(x') + if(x > (1 m), F, 0)", ""));
    let told = String::from_utf8_lossy(&folder.export(&["--c", "law.c"]).stderr).into_owned();
    assert!(told.contains("Conditions of speeds here: [x' > 0] (in m/s, line 12)"), "{told}");
    assert!(folder.text("--c", "law.c").contains("Conditions of speeds here: [x' > 0] (in m/s, line 12)"));
}

#[test]
fn quantities_of_one_name_keep_their_own_units_in_a_unit() {
    let folder = Folder::new("one_name");
    folder.scene(&sliding("-F*tanh(x'/v0)", "[outputs]\nm = \"2*x\"\n"));
    let unit = folder.text("--fmu", "unit.fmu");
    for part in ["name=\"m\" valueReference=\"5\" description=\"2 kg\"", "unit=\"kg\" start=\"2.0\"", "name=\"m_\""] {
        assert!(unit.contains(part), "{part}\n{unit}");
    }
}

#[test]
fn conditions_of_nested_functions_are_judged_in_no_time() {
    let folder = Folder::new("nested");
    let nested = "F*cos(tanh(if((if(x < (2 m), 3, x/(1 m)))/(1 + sign(x)^2) >= (1 + cos(x/(1 m))^2)^(1/3), cos(abs(x)/(1 m)), \
                  ln(2 + table(x/(1 m), -1, 0.5, 0, 0.681, 0.5, 0.2, 2, 1)^2))))";
    folder.scene(&sliding(nested, "[outputs]\nb = \"sign(x')*x\"\n"));
    let output = folder.export(&["--modelica", "Nested.mo", "--seconds", "30"]);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
}
