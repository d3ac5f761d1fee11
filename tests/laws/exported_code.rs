//! A scene's right-hand side and Jacobian, printed as C, Python and Rust, compiled and run, agree with the law up to
//! rounding.

use dalembert_derivations::studies::scene::Scene;
use integrators::{Dual8, Jacobian, Ode};
use reader::Family;
use simulation::Axes;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use symbolic::Language;

/// The expected values of the printed functions at the initial state of the scene: the rates, then the Jacobian by dual
/// numbers.
struct Expected {
    state: Vec<f64>,
    values: Vec<f64>,
}

fn open(file: &str) -> Scene {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
    Scene::open(&path).unwrap_or_else(|error| panic!("{}", error.render(false)))
}

fn expected(scene: &Scene, axes: Axes) -> Expected {
    let problem = scene.problem(axes);
    let n = problem.state.len();
    let mut values = vec![0.0; n + n * n];
    let (rates, matrix) = values.split_at_mut(n);
    Ode::<f64>::rates(&*problem.law, 0.0, &problem.state, rates);
    let dual: &dyn Ode<Dual8> = &*problem.law;
    Jacobian::new(dual).matrix(0.0, &problem.state, matrix);
    Expected { state: problem.state, values }
}

/// The source code of the rates and of their Jacobian in a language.
fn printed(scene: &Scene, axes: Axes, language: Language) -> String {
    let (rates, jacobian) = (scene.tape(axes), scene.jacobian_tape(axes));
    let (Ok(rates), Ok(jacobian)) = (rates, jacobian) else { panic!("the law has a tape") };
    format!("{}\n{}", rates.source(language, "rates"), jacobian.source(language, "jacobian"))
}

fn agree(expected: &Expected, output: &str, what: &str) {
    let found: Vec<f64> = output.split_whitespace().map(|word| word.parse().expect("a number")).collect();
    assert_eq!(found.len(), expected.values.len(), "{what}");
    for (place, (found, value)) in found.iter().zip(&expected.values).enumerate() {
        // terms of a row may cancel: the rounding error is relative to the largest one
        let size = expected.values.iter().fold(1.0, |most: f64, value| most.max(value.abs()));
        assert!((found - value).abs() <= 1e-14 * size + 1e-12 * value.abs(), "{what}, {place}: {found} for {value}");
    }
}

/// A folder for one language's files.
fn folder(language: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("exported_{language}"));
    fs::create_dir_all(&folder).expect("a folder for the code");
    folder
}

fn there(program: &str) -> bool {
    let there = Command::new(program).arg("--version").output().is_ok();
    if !there {
        eprintln!("skipped: there is no `{program}` on this machine");
    }
    there
}

fn output(command: &mut Command) -> String {
    let output = command.output().expect("the program runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8_lossy(&output.stdout).into_owned()
}

const SCENES: [&str; 3] = ["scenes/spin_up.toml", "scenes/bench.toml", "benches/peers/synchronous.toml"];

#[test]
fn the_c_agrees_with_the_law() {
    if !there("gcc") {
        return;
    }
    for (number, (scene, axes)) in SCENES.iter().flat_map(|s| [(s, Axes::First), (s, Axes::Second)]).enumerate() {
        let (scene, folder) = (open(scene), folder("c"));
        let (expected, code) = (expected(&scene, axes), printed(&scene, axes, Language::C));
        let n = expected.state.len();
        let numbers = expected.state.iter().map(|y| format!("{y:?}")).collect::<Vec<_>>().join(", ");
        let text = format!(
            "#include <math.h>\n#include <stdio.h>\n{code}\nint main(void)\n{{\n    const double y[] = {{{numbers}}};\n    \
             double out[{m}];\n    rates(y, out);\n    jacobian(y, out + {n});\n    \
             for (int i = 0; i < {m}; ++i) printf(\"%.17g\\n\", out[i]);\n    return 0;\n}}\n",
            m = n + n * n,
        );
        let (source, program) = (folder.join(format!("{number}.c")), folder.join(format!("{number}.out")));
        fs::write(&source, text).expect("the code is written");
        output(Command::new("gcc").args(["-Wall", "-Werror", "-O1", "-o"]).arg(&program).arg(&source).arg("-lm"));
        agree(&expected, &output(&mut Command::new(&program)), &scene.title);
    }
}

#[test]
fn the_python_agrees_with_the_law() {
    if !there("python3") {
        return;
    }
    for (number, (scene, axes)) in SCENES.iter().flat_map(|s| [(s, Axes::First), (s, Axes::Second)]).enumerate() {
        let (scene, folder) = (open(scene), folder("python"));
        let (expected, code) = (expected(&scene, axes), printed(&scene, axes, Language::Python));
        let call = format!("y = {:?}\nprint(*map(repr, rates(y) + jacobian(y)))", expected.state);
        let source = folder.join(format!("{number}.py"));
        fs::write(&source, format!("from math import cos, sin, sqrt\n\n\n{code}\n{call}\n"))
            .expect("the code is written");
        agree(&expected, &output(Command::new("python3").arg(&source)), &scene.title);
    }
}

#[test]
fn the_rust_agrees_with_the_law() {
    if !there("rustc") {
        return;
    }
    let (scene, folder) = (open(SCENES[0]), folder("rust"));
    let (expected, code) = (expected(&scene, Axes::Second), printed(&scene, Axes::Second, Language::Rust));
    let n = expected.state.len();
    let text = format!(
        "{code}\nfn main() {{\n    let y = {:?};\n    let (mut dy, mut matrix) = ([0.0; {n}], [0.0; {}]);\n    \
         rates(&y, &mut dy);\n    jacobian(&y, &mut matrix);\n    \
         dy.iter().chain(&matrix).for_each(|value| println!(\"{{value:?}}\"));\n}}\n",
        expected.state,
        n * n,
    );
    let (source, program) = (folder.join("code.rs"), folder.join("code.out"));
    fs::write(&source, text).expect("the code is written");
    output(Command::new("rustc").args(["--edition", "2024", "-Dwarnings", "-o"]).arg(&program).arg(&source));
    agree(&expected, &output(&mut Command::new(&program)), &scene.title);
}
