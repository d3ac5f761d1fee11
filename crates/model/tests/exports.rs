//! Systems as code of other languages, compiled and run, have the accelerations and multipliers of our own equations.

use model::equations::Equations;
use model::principles::Principle;
use model::{BodySource, ConstraintSource, Entry, InertiaSource, LoadSource, MatrixForm, Model, Source, Trace};
use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use symbolic::{Language, apart};

fn entries(list: &[(&str, &str)]) -> Vec<Entry> {
    list.iter().map(|&entry| entry.into()).collect()
}

/// Letters that are words of the languages, a start in radians, a turn by thirty degrees.
fn oscillator() -> Source {
    Source {
        parameters: entries(&[("double", "2 kg"), ("lambda", "30 N/m"), ("fn", "0.4 N s/m"), ("M", "1.5 m")]),
        coordinates: entries(&[("q", "m"), ("u", "m")]),
        frames: entries(&[("A", "N turned (30 deg) about z")]),
        points: entries(&[("P", "O + q*A.x + u*A.y")]),
        bodies: vec![BodySource::particle("bob", "P", "double")],
        energies: entries(&[
            ("potential", "lambda/2*(distance(O, P) - M)^2"),
            ("dissipation", "fn/2*(q'^2 + 0.35*u'^2)"),
        ]),
        gravity: Some("-(9.81 m/s^2)*N.y".into()),
        ..Source::default()
    }
}

/// No parameter, no letter.
fn faller() -> Source {
    Source {
        coordinates: entries(&[("y", "m")]),
        points: entries(&[("P", "O + y*N.y")]),
        bodies: vec![BodySource::particle("stone", "P", "(2 kg)")],
        gravity: Some("-(9.81 m/s^2)*N.y".into()),
        ..Source::default()
    }
}

/// A mass that meets a stiff stop, by a condition, and slides with a friction that saturates.
fn stop() -> Source {
    Source {
        parameters: entries(&[("m", "2 kg"), ("k", "300 N/m"), ("f", "0.7 N"), ("w", "0.1 m/s")]),
        coordinates: entries(&[("x", "m")]),
        points: entries(&[("P", "O + x*N.x")]),
        bodies: vec![BodySource::particle("mass", "P", "m")],
        forces: vec![LoadSource {
            on: Some("mass".into()),
            is: "(if(x > (0.15 m), -k*(x - (0.15 m)), 0*k*x) - f*tanh(x'/w))*N.x".into(),
            ..LoadSource::default()
        }],
        ..Source::default()
    }
}

fn double_pendulum() -> Source {
    Source {
        parameters: entries(&[
            ("m1", "1 kg"),
            ("m2", "2 kg"),
            ("l1", "1 m"),
            ("l2", "0.5 m"),
            ("g", "9.81 m/s^2"),
            ("T", "0.3 N m"),
        ]),
        coordinates: entries(&[("a", "rad"), ("b", "rad")]),
        frames: entries(&[("A", "N turned a about z"), ("B", "N turned b about z")]),
        points: entries(&[("P", "O - l1*A.y"), ("Q", "P - l2*B.y")]),
        bodies: vec![BodySource::particle("first", "P", "m1"), BodySource::particle("second", "Q", "m2")],
        gravity: Some("-g*N.y".into()),
        torques: vec![LoadSource { on: Some("A".into()), is: "T*cos(t/(1 s))*N.z".into(), ..LoadSource::default() }],
        ..Source::default()
    }
}

fn slider_crank() -> Source {
    let body = |name: &str| BodySource { name: name.into(), ..BodySource::default() };
    let text = |text: &str| Some(text.into());
    Source {
        parameters: entries(&[
            ("r", "0.1 m"),
            ("l", "0.3 m"),
            ("J", "0.01 kg m^2"),
            ("Jrod", "0.003 kg m^2"),
            ("mrod", "0.4 kg"),
            ("m", "0.5 kg"),
            ("T", "0.2 N m"),
            ("g", "9.81 m/s^2"),
        ]),
        coordinates: entries(&[("theta", "rad"), ("phi", "rad"), ("s", "m")]),
        frames: entries(&[("R", "N turned -phi about z")]),
        points: entries(&[
            ("A", "O + r*(cos(theta)*N.x + sin(theta)*N.y)"),
            ("G", "A + l/2*R.x"),
            ("B", "A + l*R.x"),
            ("S", "O + s*N.x"),
        ]),
        bodies: vec![
            BodySource { turns: text("theta"), inertia: Some(InertiaSource::Axial("J".into())), ..body("crank") },
            BodySource {
                frame: text("R"),
                centre: text("G"),
                mass: text("mrod"),
                inertia: Some(InertiaSource::Axial("Jrod".into())),
                ..body("rod")
            },
            BodySource::particle("slider", "S", "m"),
        ],
        gravity: text("-g*N.y"),
        torques: vec![LoadSource {
            between: Some(["ground".into(), "crank".into()]),
            is: "T*N.z".into(),
            ..LoadSource::default()
        }],
        constraints: vec![ConstraintSource {
            name: text("pin"),
            zero: vec!["B - S".into()],
            ..ConstraintSource::default()
        }],
        ..Source::default()
    }
}

/// A top about a fixed point, dragged by the air, in a frame that turns freely or by three angles.
fn top(coordinates: &[(&str, &str)], frames: &[(&str, &str)]) -> Source {
    let entry = |text: &str| Some(text.into());
    let moments = [entry("A"), entry("1.2*A"), entry("C"), None, None, None];
    Source {
        parameters: entries(&[
            ("m", "1.5 kg"),
            ("l", "0.2 m"),
            ("A", "0.03 kg m^2"),
            ("C", "0.01 kg m^2"),
            ("k", "0.02 N m s"),
        ]),
        coordinates: entries(coordinates),
        frames: entries(frames),
        points: entries(&[("P", "O + l*F.z")]),
        bodies: vec![BodySource {
            name: "top".into(),
            frame: entry("F"),
            centre: entry("P"),
            mass: entry("m"),
            inertia: Some(InertiaSource::Tensor { axes: None, entries: Box::new(moments) }),
            ..BodySource::default()
        }],
        gravity: entry("-(9.81 m/s^2)*N.z"),
        torques: vec![LoadSource { on: entry("top"), is: "-k*angular_velocity(top)".into(), ..LoadSource::default() }],
        ..Source::default()
    }
}

fn free_top() -> Source {
    top(&[], &[("F", "N free")])
}

fn turned_top() -> Source {
    top(
        &[("yaw", "rad"), ("tilt", "rad"), ("spin", "rad")],
        &[("Y", "N turned yaw about z"), ("T", "Y turned tilt about x"), ("F", "T turned spin about z")],
    )
}

/// A body on a slide, its frame free, its corner on a plane.
fn pinned_plate() -> Source {
    Source {
        coordinates: entries(&[("x", "m"), ("z", "m")]),
        points: entries(&[("P", "O + x*N.x + z*N.z"), ("E", "P + l*F.x - l/2*F.z")]),
        constraints: vec![ConstraintSource {
            name: Some("plane".into()),
            zero: vec!["(E - O) . N.z".into(), "velocity(top at E) . N.y".into()],
            ..ConstraintSource::default()
        }],
        ..free_top()
    }
}

/// A system, a state of it, and the accelerations and multipliers there.
struct Case {
    name: &'static str,
    model: Model,
    time: f64,
    coordinates: Vec<f64>,
    speeds: Vec<f64>,
    /// Accelerations, then multipliers.
    expected: Vec<f64>,
    /// The rates of the state.
    rates: Vec<f64>,
}

fn cases() -> Vec<Case> {
    let case = |name, source: Source, coordinates: &[f64], speeds: &[f64]| {
        let model = Model::of(&source).unwrap_or_else(|faults| panic!("{name}: {faults:?}"));
        let (coordinates, speeds, time) = (coordinates.to_vec(), speeds.to_vec(), 0.7);
        let expected = expected(&model, time, &coordinates, &speeds);
        let mut rates = vec![0.0; coordinates.len()];
        model.position_rates(&[&coordinates[..], &speeds].concat(), &mut rates);
        rates.extend(&expected[..speeds.len()]);
        Case { name, model, time, coordinates, speeds, expected, rates }
    };
    vec![
        case("faller", faller(), &[0.2], &[0.1]),
        case("oscillator", oscillator(), &[0.8, -0.3], &[0.4, 1.1]),
        case("stop", stop(), &[0.2], &[-0.3]),
        case("double_pendulum", double_pendulum(), &[0.9, -0.4], &[1.3, 0.7]),
        case("slider_crank", slider_crank(), &[0.6, 0.2, 0.35], &[2.0, -0.7, 0.3]),
        case("free_top", free_top(), &[0.8, -0.3, 0.5, 0.2], &[0.4, 3.0, -7.0]),
        case("pinned_plate", pinned_plate(), &[0.1, 0.4, 0.8, -0.3, 0.5, 0.2], &[0.3, -0.2, 0.4, 3.0, -7.0]),
    ]
}

fn expected(model: &Model, time: f64, coordinates: &[f64], speeds: &[f64]) -> Vec<f64> {
    apart(|| {
        let trace = Trace::of(model);
        let (accelerations, multipliers) = Equations::of(&trace).solved().expect("it is regular");
        let mut values: HashMap<String, f64> =
            [("t".to_owned(), time), ("pi".to_owned(), std::f64::consts::PI)].into_iter().collect();
        for parameter in &model.parameters {
            values.insert(parameter.name.clone(), parameter.value.expect("it has one"));
        }
        let state = coordinates.iter().chain(speeds);
        values.extend(model.state_names().into_iter().zip(state).map(|((name, _), value)| (name, *value)));
        for (letter, condition) in trace.switches.iter().zip(&model.switches) {
            let condition = trace.scalar(*condition).evaluate_analytic(&|name| values.get(name).copied());
            let is_positive = condition.expect("every letter has a value") > 0.0;
            values.insert(letter.to_string(), if is_positive { 1.0 } else { 0.0 });
        }
        let all = accelerations.into_iter().chain(multipliers);
        all.map(|each| each.evaluate_analytic(&|name| values.get(name).copied()).expect("every letter has a value"))
            .collect()
    })
}

fn code(case: &Case, language: Language) -> String {
    apart(|| {
        let trace = Trace::of(&case.model);
        let form = MatrixForm::of(&trace, Principle::Lagrange).expect("it applies");
        model::code(&trace, &form, language).expect("it can be written")
    })
}

fn agree(case: &Case, output: &str) {
    let found: Vec<f64> = output.split_whitespace().map(|word| word.parse().expect("a number")).collect();
    let known = [&case.expected[..], &case.rates].concat();
    assert_eq!(found.len(), known.len(), "{}: {output}", case.name);
    let size = known.iter().fold(1.0, |most: f64, value| most.max(value.abs()));
    for (found, value) in found.iter().zip(&known) {
        assert!((found - value).abs() <= 1e-12 * size, "{}: {found} for {value}", case.name);
    }
}

fn folder(language: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("systems_{language}"));
    fs::create_dir_all(&folder).expect("a folder for the code");
    folder
}

/// Whether a program answers to a command; where it does not, the test says so.
fn answers(program: &str, arguments: &[&str]) -> bool {
    let answers = Command::new(program).args(arguments).output().is_ok_and(|output| output.status.success());
    if !answers {
        eprintln!("skipped: `{program} {}` is not there", arguments.join(" "));
    }
    answers
}

fn output(command: &mut Command) -> String {
    let output = command.output().expect("the program runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8_lossy(&output.stdout).into_owned()
}

fn listed(values: &[f64]) -> String {
    values.iter().map(|value| format!("{value:?}")).collect::<Vec<_>>().join(", ")
}

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
    for case in cases() {
        let module = apart(|| {
            let trace = Trace::of(&case.model);
            model::sympy(&trace, &MatrixForm::of(&trace, Principle::Lagrange).expect("it applies"))
                .expect("it can be written")
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

/// The top of three angles beside the free one, each by its own code and the same steps: the axis and a mark on the rim stand at one place.
#[test]
fn the_code_of_a_free_top_moves_it_as_that_of_three_turns() {
    if !answers("python3", &["-c", "import numpy"]) {
        return;
    }
    let case = |name, source: Source| {
        let model = Model::of(&source).unwrap_or_else(|faults| panic!("{name}: {faults:?}"));
        let (coordinates, speeds, expected, rates) = Default::default();
        code(&Case { name, model, time: 0.0, coordinates, speeds, expected, rates }, Language::Python)
    };
    for (name, source) in [("free", free_top()), ("turned", turned_top())] {
        fs::write(folder("python").join(format!("top_{name}.py")), case(name, source)).expect("the code is written");
    }
    let text = "import numpy as np\nimport top_free as free_top, top_turned as turned_top\nfrom numpy import cos, sin\n\
        def ends(rates, y):\n    h, t = 0.0005, 0.0\n    for _ in range(1000):\n        k1 = rates(t, y)\n        \
        k2 = rates(t + h/2, y + h/2*k1)\n        k3 = rates(t + h/2, y + h/2*k2)\n        k4 = rates(t + h, y + h*k3)\n        \
        y, t = y + h/6*(k1 + 2*k2 + 2*k3 + k4), t + h\n    return y\n\
        about = lambda a, i: np.array([cos(a/2)] + [sin(a/2) if k == i else 0.0 for k in range(3)])\n\
        def times(p, q):\n    return np.concatenate([[p[0]*q[0] - p[1:] @ q[1:]], p[0]*q[1:] + q[0]*p[1:] + np.cross(p[1:], q[1:])])\n\
        yaw, tilt, spin = 0.2, 0.7, 0.3\ndyaw, dtilt, dspin = 0.4, 0.5, 30.0\n\
        q = times(times(about(yaw, 2), about(tilt, 0)), about(spin, 2))\n\
        w = [dyaw*sin(tilt)*sin(spin) + dtilt*cos(spin), dyaw*sin(tilt)*cos(spin) - dtilt*sin(spin), dyaw*cos(tilt) + dspin]\n\
        free = ends(free_top.rates, np.concatenate([q, w]))\n\
        turned = ends(turned_top.rates, np.array([yaw, tilt, spin, dyaw, dtilt, dspin]))\n\
        one = times(times(about(turned[0], 2), about(turned[1], 0)), about(turned[2], 2))\n\
        other = free[:4]/np.linalg.norm(free[:4])\nprint(repr(float(1 - abs(one @ other))))\n";
    let source = folder("python").join("both_tops.py");
    fs::write(&source, text).expect("the code is written");
    let apart: f64 = output(Command::new("python3").arg(&source)).trim().parse().expect("a number");
    // half of the square of half the angle between them
    assert!(apart.abs() < 1e-10, "{apart}");
}

#[test]
fn angles_stay_together_and_constants_are_as_written() {
    let text = |source: Source, principle| {
        let model = Model::of(&source).expect("it is a system");
        apart(|| {
            let trace = Trace::of(&model);
            let form = MatrixForm::of(&trace, principle).ok()?.for_reading();
            Some([model::text(&trace, &form), model::latex(&trace, &form), model::vectors(&trace).join("\n")])
        })
    };
    let mut applied = 0;
    for principle in Principle::ALL {
        let Some([pendulum, latex, vectors]) = text(double_pendulum(), principle) else { continue };
        applied += 1;
        for line in [
            "m1 = 1 kg",
            "M[a, a] = (m1 + m2)*l1^2",
            "M[a, b] = m2*l1*l2*cos(a - b)",
            "M[b, b] = m2*l2^2",
            "h[a] = m2*l1*l2*b'^2*sin(a - b)",
            "h[b] = -m2*l1*l2*a'^2*sin(a - b)",
            "Q[b] = -m2*l2*g*sin(b)",
        ] {
            assert!(pendulum.lines().any(|known| known.trim() == line), "{}: {line}\n{pendulum}", principle.name());
        }
        assert!(latex.contains(r"h_{1} &= m_2l_1l_2\dot{b}^2\sin(a - b)"), "{latex}");
        assert!(latex.contains(r"\begin{align}") && latex.contains(r"m_1 &= 1\,\mathrm{kg}"), "{latex}");
        assert!(
            vectors.contains("P - O = -l1*A.y") && !vectors.contains("+ -") && !vectors.contains("0*"),
            "{vectors}"
        );
    }
    assert!(applied >= 4, "{applied} principles");
    let [oscillator, ..] = text(oscillator(), Principle::Lagrange).expect("it applies");
    // thirty degrees are pi/6, whose cosine is a root; decimals stay decimals
    assert!(
        oscillator.contains("Q[u] = -lambda*u + lambda*M*u/sqrt(q^2 + u^2) - 0.35*fn*u' - 4.905*double*sqrt(3)"),
        "{oscillator}"
    );
    assert!(
        !oscillator.chars().collect::<Vec<_>>().windows(12).any(|window| window.iter().all(char::is_ascii_digit)),
        "{oscillator}"
    );
    let [top, latex, _] = text(free_top(), Principle::VirtualPower).expect("it applies");
    let line = "F.q0' = -1/2*(F.q1*F.wx + F.q2*F.wy + F.q3*F.wz)";
    assert!(top.lines().any(|known| known.trim() == line), "{top}");
    assert!(latex.contains(r"\dot{q_{F,3}} &= "), "{latex}");
    let [crank, ..] = text(slider_crank(), Principle::VirtualPower).expect("it applies");
    for line in [
        "M q'' + h = Q + J^T lambda, with q = (theta, phi, s)",
        "M[phi, phi] = l^2*mrod/4 + Jrod",
        "Q[theta] = T - r*mrod*g*cos(theta)",
        "constraint 1 `pin` along R.x: of positions",
        "f1 = l + r*cos(theta + phi) - s*cos(phi)",
    ] {
        assert!(crank.lines().any(|known| known.trim() == line), "{line}\n{crank}");
    }
}

/// Four bodies, each of which turns freely on the one before: written out, their equations have more operations than anybody reads.
#[test]
fn a_module_that_would_be_too_long_is_refused_by_name() {
    let mut tower = free_top();
    for (frame, parent, point, place) in [
        ("H", "F", "Q", "O + 2*l*F.z + l*H.x"),
        ("I", "H", "R", "Q + l*H.x + l*I.y"),
        ("K", "I", "S", "R + l*I.x + l*K.y"),
    ] {
        tower.frames.push((frame, format!("{parent} free").as_str()).into());
        tower.points.push((point, place).into());
        let (name, frame, centre) = (point.to_lowercase(), Some(frame.into()), Some(point.into()));
        tower.bodies.push(BodySource { name: name.as_str().into(), frame, centre, ..tower.bodies[0].clone() });
    }
    let model = Model::of(&tower).unwrap_or_else(|faults| panic!("{faults:?}"));
    let refused = apart(|| {
        let trace = Trace::of(&model);
        let form = MatrixForm::of(&trace, Principle::VirtualPower).expect("it applies");
        assert!(model::code(&trace, &form, Language::C).is_ok());
        model::sympy(&trace, &form).map(|module| module.len())
    });
    let refused = refused.expect_err("it is long");
    assert!(refused.contains("operations is too long for SymPy; c, python and rust"), "{refused}");
}
