//! Generated code of each language, compiled and run.

use crate::{agree, answers, cases, code, folder, listed, named_form, output};
use dalembert_model::Trace;
use std::fs;
use std::process::Command;
use symbolic::{Language, apart};

#[test]
fn the_c_has_the_accelerations_and_multipliers() {
    if !answers("gcc", &["--version"]) {
        return;
    }
    for case in cases() {
        let (n, m) = (case.speeds.len(), case.expected.len() - case.speeds.len());
        let text = format!(
            "{}\n#include <stdio.h>\nint main(void)\n{{\n    const double q[] = {{{}}}, u[] = {{{}}}, y[] = {{{}}};\n    \
             double a[{n}], lambda[{}], dy[{}];\n    const double t = {:?};\n    \
             if (accelerations(t, q, u, &defaults, a, lambda) || rates(t, y, &defaults, dy)) return 1;\n    \
             for (int i = 0; i < {n}; ++i) printf(\"%.17g\\n\", a[i]);\n    \
             for (int i = 0; i < {m}; ++i) printf(\"%.17g\\n\", lambda[i]);\n    \
             for (int i = 0; i < COORDINATES + SPEEDS; ++i) printf(\"%.17g\\n\", dy[i]);\n    return 0;\n}}\n",
            code(&case, Language::C),
            listed(&case.coordinates),
            listed(&case.speeds),
            listed(&[&case.coordinates[..], &case.speeds].concat()),
            m.max(1),
            case.rates.len(),
            case.time,
        );
        let (source, program) =
            (folder("c").join(format!("{}.c", case.name)), folder("c").join(format!("{}.out", case.name)));
        fs::write(&source, text).expect("the code is written");
        let warnings = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-O1", "-o"];
        output(Command::new("gcc").args(warnings).arg(&program).arg(&source).arg("-lm"));
        agree(&case, &output(&mut Command::new(&program)));
    }
}

#[test]
fn the_rust_has_the_accelerations_and_multipliers() {
    if !answers("rustc", &["--version"]) {
        return;
    }
    for case in cases() {
        let text = format!(
            "{}\nfn main() {{\n    let p = Parameters::default();\n    let (q, u) = ([{}], [{}]);\n    \
             let Some((a, lambda)) = accelerations({:?}, &q, &u, &p) else {{ std::process::exit(1) }};\n    \
             let Some(dy) = rates({:?}, &[{}], &p) else {{ std::process::exit(1) }};\n    \
             a.iter().chain(&lambda).chain(&dy).for_each(|value| println!(\"{{value:?}}\"));\n    \
             let _ = (constraints({:?}, &q, &u, &p), p.clone());\n}}\n",
            code(&case, Language::Rust),
            listed(&case.coordinates),
            listed(&case.speeds),
            case.time,
            case.time,
            listed(&[&case.coordinates[..], &case.speeds].concat()),
            case.time,
        );
        let (source, program) =
            (folder("rust").join(format!("{}.rs", case.name)), folder("rust").join(format!("{}.out", case.name)));
        fs::write(&source, text).expect("the code is written");
        output(Command::new("rustc").args(["--edition", "2024", "-Dwarnings", "-o"]).arg(&program).arg(&source));
        agree(&case, &output(&mut Command::new(&program)));
    }
}

#[test]
fn the_python_has_the_accelerations_and_multipliers() {
    if !answers("python3", &["-c", "import numpy"]) {
        return;
    }
    for case in cases() {
        let text = format!(
            "{}\nq, u = [{}], [{}]\na, multipliers = accelerations({:?}, q, u)\n\
             print(*map(repr, map(float, [*a, *multipliers, *rates({:?}, q + u)])))\n",
            code(&case, Language::Python),
            listed(&case.coordinates),
            listed(&case.speeds),
            case.time,
            case.time,
        );
        let source = folder("python").join(format!("{}.py", case.name));
        fs::write(&source, text).expect("the code is written");
        agree(&case, &output(Command::new("python3").arg(&source)));
    }
}

#[test]
fn sympy_solves_the_equations_to_the_accelerations_and_multipliers() {
    if !answers("python3", &["-c", "import sympy"]) {
        return;
    }
    // Excluded: SymPy needs minutes to substitute numbers for the fourteen coordinates of the two bodies.
    for case in cases().into_iter().filter(|case| case.name != "joined_bodies") {
        let module = apart(|| {
            let trace = Trace::of(&case.model);
            dalembert_model::sympy(&trace, &named_form(&trace)).expect("it can be written")
        });
        let text = format!(
            "{module}\nfrom sympy import Matrix as M_, zeros\nturns = \"kinematics\" in globals()\n\
             speeds, rates = [{}], [{}]\nu_ = list(u) if turns else [q[k].diff(t) for k in range(len(q))]\n\
             state = [(q[k].diff(t), v) for k, v in enumerate(rates)]\n\
             state += [(s, v) for s, v in zip(u_, speeds) if not s.is_Derivative]\n\
             state += [(q[k], v) for k, v in enumerate([{}])] + [(t, {:?})] + list(values.items())\n\
             held = \"jacobian\" in globals()\n\
             rows = mass_matrix.row_join(-jacobian.T).col_join(jacobian.row_join(zeros(*[jacobian.shape[0]]*2))) if held else mass_matrix\n\
             right = (forces - inertia).col_join(-bias) if held else forces - inertia\n\
             a, b = rows.subs(state).evalf(30), right.subs(state).evalf(30)\n\
             assert not turns or max(abs(k) for k in kinematics.subs(state).evalf(30)) < 1e-14\n\
             found = list(a.LUsolve(b))\nprint(*map(float, found + rates + found[:len(speeds)]))\n\
             assert len(equations) == len(speeds)\n",
            listed(&case.speeds),
            listed(&case.rates[..case.coordinates.len()]),
            listed(&case.coordinates),
            case.time,
        );
        let source = folder("sympy").join(format!("{}.py", case.name));
        fs::write(&source, text).expect("the code is written");
        agree(&case, &output(Command::new("python3").arg(&source)));
    }
}
