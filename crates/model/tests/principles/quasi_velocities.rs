//! Equations in quasi-velocities, compared with textbooks, with the multiplier equations and between all principles.

use crate::systems::{double_pendulum, entries, held, rolling_disc, sleigh, slider_crank};
use dalembert_model::equations::Equations;
use dalembert_model::{
    Agreement, BodySource, Fault, InertiaSource, LoadSource, MatrixForm, Model, QuasiPrinciple, QuasiVelocities,
    Source, Trace, quasi_agreement,
};
use std::collections::HashMap;
use symbolic::{Hypotheses, Identity, Sym, apart, identified};

fn model(source: &Source) -> Model {
    Model::of(source).unwrap_or_else(|faults| panic!("{faults:?}"))
}

fn with(source: Source, speeds: &[(&str, &str)]) -> Source {
    Source { speeds: entries(speeds), ..source }
}

fn sleigh_along() -> Source {
    with(sleigh(), &[("v", "velocity(P) . B.x"), ("w", "psi'")])
}

/// The rolling disc. Its quasi-velocities are components of the angular velocity along axes that follow the disc without spinning.
fn rolling() -> Source {
    with(
        rolling_disc(),
        &[
            ("w1", "angular_velocity(C) . C.x"),
            ("w2", "angular_velocity(D) . C.y"),
            ("w3", "angular_velocity(C) . C.z"),
        ],
    )
}

/// A free rigid body about its centre, with viscous drag about one axis.
fn tumbling() -> Source {
    let entry = |text: &str| Some(text.into());
    let moments = [entry("A"), entry("B"), entry("C"), None, None, None];
    Source {
        parameters: entries(&[("A", "1 kg m^2"), ("B", "2 kg m^2"), ("C", "2.5 kg m^2"), ("k", "1 N m s")]),
        speeds: entries(&[("p", "F.wx"), ("q", "F.w . F.y"), ("s", "F.wz")]),
        frames: entries(&[("F", "N free")]),
        bodies: vec![BodySource {
            name: "stone".into(),
            frame: entry("F"),
            inertia: Some(InertiaSource::Tensor { axes: None, entries: Box::new(moments) }),
            ..BodySource::default()
        }],
        torques: vec![LoadSource { on: entry("stone"), is: "-k*p*F.x".into(), ..LoadSource::default() }],
        ..Source::default()
    }
}

/// A ball on a turntable whose angular velocity grows: rheonomic affine constraints, a free frame, components along moving axes.
fn ball_on_a_turntable() -> Source {
    let entry = |text: &str| Some(text.into());
    let moments = [entry("J"), entry("J"), entry("1.5*J"), None, None, None];
    let slip = "velocity(ball at K) - cross((t*w/(1 s))*N.z, K - O)";
    Source {
        parameters: entries(&[
            ("m", "2 kg"),
            ("r", "0.1 m"),
            ("J", "0.01 kg m^2"),
            ("w", "3 rad/s"),
            ("c", "0.2 N s/m"),
        ]),
        coordinates: entries(&[("x", "m"), ("y", "m")]),
        speeds: entries(&[("a", "F.wx"), ("b", "F.w . S.x - t*w*x/(1 m*s)"), ("n", "2*F.wz + F.wx")]),
        frames: entries(&[("F", "N free"), ("S", "N turned x/r about z")]),
        points: entries(&[("P", "O + x*N.x + y*N.y"), ("K", "P - r*N.z")]),
        bodies: vec![BodySource {
            name: "ball".into(),
            frame: entry("F"),
            centre: entry("P"),
            mass: entry("m"),
            inertia: Some(InertiaSource::Tensor { axes: None, entries: Box::new(moments) }),
            ..BodySource::default()
        }],
        forces: vec![LoadSource { on: entry("ball at K"), is: "-c*velocity(ball)".into(), ..LoadSource::default() }],
        constraints: vec![held("rolling", &[&format!("({slip}) . N.x"), &format!("({slip}) . N.y")])],
        ..Source::default()
    }
}

/// A sleigh with loads of every kind, a rheonomic affine constraint and a stabilised constraint.
fn led() -> Source {
    let mut source = sleigh_along();
    source.parameters.extend(entries(&[("k", "3 N/m"), ("c", "0.4 N s/m"), ("n", "0.2 N m s")]));
    source.speeds = entries(&[("v", "velocity(P) . B.x - (1 m/s^2)*t"), ("w", "psi' + (0.2 rad/s)*sin(t*(1 rad/s))")]);
    source.energies = entries(&[("potential", "k/2*(x^2 + x*y)"), ("dissipation", "c/2*x'^2")]);
    source.forces.push(LoadSource { along: Some("psi".into()), is: "-n*w".into(), ..LoadSource::default() });
    source.forces.push(LoadSource { along: Some("v".into()), is: "-c*v".into(), ..LoadSource::default() });
    source.constraints[0].zero = vec!["velocity(sleigh at P) . B.y - (0.1 m/s)*cos(t*(1 rad/s))".into()];
    let mut path = held("path", &["x - (1 m/s)*t"]);
    path.gains = Some(vec!["(8 1/s)".into(), "(16 1/s^2)".into()]);
    source.constraints.push(path);
    source
}

fn all() -> [Source; 7] {
    let pendulum = with(double_pendulum(true), &[("u", "a' + b'"), ("v", "velocity(Q) . B.x")]);
    let crank = with(slider_crank(), &[("w", "theta'")]);
    [sleigh_along(), rolling(), tumbling(), ball_on_a_turntable(), led(), pendulum, crank]
}

#[test]
fn principles_agree_in_quasi_velocities() {
    for source in all() {
        let model = model(&source);
        apart(|| {
            let trace = Trace::of(&model);
            let quasi = QuasiVelocities::of(&trace).expect("they are independent");
            for other in QuasiPrinciple::ALONG_ANY {
                let found = quasi_agreement(&quasi, QuasiPrinciple::Maggi, other).expect("it applies");
                let known = matches!(found, Agreement::Proved { .. } | Agreement::Identified { .. });
                assert!(known, "{:?}, {}: {found}", source.speeds, other.name());
            }
        });
    }
}

/// A particle with `count` angles. Every quasi-velocity is a linear combination of all rates, so all are solved as one block: by
/// cofactors, or by elimination if the block is large.
fn tied(count: usize) -> Source {
    let angles: Vec<String> = (0..count).map(|i| format!("a{i}")).collect();
    let sum = |i: usize| (0..count).map(|j| format!("cos({}*a{i})*a{j}'", j + 1)).collect::<Vec<_>>().join(" + ");
    let sums: Vec<(String, String)> = (0..count).map(|i| (format!("v{i}"), sum(i))).collect();
    let place = angles.iter().map(|angle| format!("sin({angle})*(1 m)*N.x")).collect::<Vec<_>>().join(" + ");
    Source {
        parameters: entries(&[("m", "2 kg")]),
        coordinates: entries(&angles.iter().map(|angle| (angle.as_str(), "rad")).collect::<Vec<_>>()),
        speeds: entries(&sums.iter().map(|(name, is)| (name.as_str(), is.as_str())).collect::<Vec<_>>()),
        points: entries(&[("P", &format!("O + {place}"))]),
        bodies: vec![BodySource::particle("bob", "P", "m")],
        ..Source::default()
    }
}

#[test]
fn speeds_that_all_depend_on_each_other_are_solved_for() {
    for count in [3, 7, 9] {
        let model = model(&tied(count));
        apart(|| {
            let trace = Trace::of(&model);
            let quasi = QuasiVelocities::of(&trace).expect("they are independent");
            assert!(count == 9 || quasi.divisors.len() == 1, "{}", quasi.divisors.len());
            let mut values: Values = [("pi".to_owned(), std::f64::consts::PI), ("m".to_owned(), 2.0)].into();
            let letters = trace.coordinates.iter().chain(&quasi.symbols).enumerate();
            values.extend(letters.map(|(k, letter)| (letter.to_string(), 0.2 + 0.23 * k as f64)));
            let speeds: Vec<(String, f64)> = (trace.speeds.iter().zip(&quasi.speeds))
                .map(|(speed, is)| (speed.to_string(), value(*is, &values)))
                .collect();
            let size = speeds.iter().fold(1.0, |most: f64, (_, speed)| most.max(speed.abs()));
            values.extend(speeds);
            for (definition, symbol) in quasi.definitions.iter().zip(&quasi.symbols) {
                let (found, given) = (value(*definition, &values), values[&symbol.to_string()]);
                assert!((found - given).abs() < 1e-9 * size, "{symbol}: {found} for {given}");
            }
        });
    }
}

#[test]
fn equations_with_letters_for_slopes_are_those_without() {
    let mut letters = 0;
    for source in all() {
        let model = model(&source);
        letters += apart(|| {
            let trace = Trace::of(&model);
            let plain = QuasiVelocities::of(&trace).expect("they are independent");
            let named = QuasiVelocities::named(&trace).expect("they are independent");
            let rates: Vec<(Sym, Sym)> = named.coefficients.iter().map(|each| (each.rate, each.rate_is)).collect();
            let slopes: Vec<(Sym, Sym)> = named.coefficients.iter().map(|each| (each.letter, each.is)).collect();
            for principle in [QuasiPrinciple::Maggi, QuasiPrinciple::VirtualPower, QuasiPrinciple::Appell] {
                let [plain, named] = [&plain, &named].map(|quasi| principle.residual(quasi).expect("it applies"));
                let differences = plain.into_iter().zip(named);
                let differences = differences
                    .map(|(one, other)| one - other.substitute(&rates).substitute(&slopes))
                    .collect::<Vec<_>>();
                let found = identified(&differences);
                assert!(
                    matches!(found, Identity::Identified { .. }),
                    "{:?}, {}: {found:?}",
                    source.speeds,
                    principle.name()
                );
            }
            slopes.len()
        });
    }
    assert!(letters > 10, "{letters}");
}

/// Values of symbols by name.
type Values = HashMap<String, f64>;

fn value(expression: Sym, values: &Values) -> f64 {
    expression.evaluate_analytic(&|name| values.get(name).copied()).expect("every letter has a value")
}

/// The accelerations of the multiplier equations, in rates of coordinates and solved by pivoting, must satisfy the equations in
/// quasi-velocities. Both ways are independent of each other.
#[test]
fn the_equations_have_the_accelerations_of_those_with_multipliers() {
    for source in all() {
        let model = model(&source);
        apart(|| {
            let trace = Trace::of(&model);
            let quasi = QuasiVelocities::of(&trace).expect("they are independent");
            let mut values: Values = [("t".to_owned(), 0.4), ("pi".to_owned(), std::f64::consts::PI)].into();
            values.extend(model.parameters.iter().map(|one| (one.name.clone(), one.value.unwrap_or(1.3))));
            let letters = trace.coordinates.iter().chain(&quasi.symbols).enumerate();
            values.extend(letters.map(|(k, letter)| (letter.to_string(), 0.3 + 0.37 * (1.0 + k as f64).sin())));
            let speeds: Vec<(String, f64)> = (trace.speeds.iter().zip(&quasi.speeds))
                .map(|(speed, is)| (speed.to_string(), value(*is, &values)))
                .collect();
            values.extend(speeds);
            let (accelerations, multipliers) = Equations::of(&trace).solved().expect("it is regular");
            let accelerations: Vec<f64> = accelerations.iter().map(|each| value(*each, &values)).collect();
            values.extend(trace.accelerations.iter().map(Sym::to_string).zip(accelerations));
            for multiplier in multipliers.iter().zip(Equations::of(&trace).constraints) {
                let (is, equation) = multiplier;
                values.insert(equation.multiplier.to_string(), value(*is, &values));
            }
            let rates = quasi.definitions.iter().map(|is| value(trace.rate_of(*is), &values)).collect::<Vec<f64>>();
            values.extend(quasi.accelerations.iter().map(Sym::to_string).zip(rates));
            for principle in QuasiPrinciple::ALONG_ANY {
                let residual = principle.residual(&quasi).expect("it applies");
                for (r, (&w, residual)) in quasi.symbols.iter().zip(residual).enumerate() {
                    // a stabilised constraint is not eliminated: its reaction remains in the equations
                    let reaction: f64 = (quasi.programmed.iter())
                        .map(|one| {
                            let power = quasi.by_quasi_velocities(&[one.rate])[0].diff(w);
                            values[&one.multiplier.to_string()] * value(power, &values)
                        })
                        .sum();
                    let left = value(residual, &values) - reaction;
                    assert!(left.abs() < 1e-10, "{:?}, {}, equation {r}: {left}", source.speeds, principle.name());
                }
            }
        });
    }
}

/// Asserts that equations printed in textbooks, given as residuals in the model's symbols, equal the equations of every principle.
fn beside(source: &Source, printed: &[&str]) {
    let model = model(source);
    apart(|| {
        let trace = Trace::of(&model);
        let quasi = QuasiVelocities::of(&trace).expect("they are independent");
        let letter = |name: &str| Some(Sym::symbol(name));
        let printed = printed.iter().map(|text| symbolic::parse(text, &letter).expect("it is an expression"));
        let printed: Vec<Sym> = printed.collect();
        for principle in QuasiPrinciple::ALONG_ANY {
            let residual = principle.residual(&quasi).expect("it applies");
            assert_eq!(residual.len(), printed.len());
            for (own, printed) in residual.iter().zip(&printed) {
                let decided = Hypotheses::none().equal(*own, *printed);
                assert!(decided.is_zero(), "{}: {printed}: {decided}", principle.name());
            }
        }
    });
}

/// Chaplygin's sleigh: Neimark and Fufaev; Bloch, Nonholonomic Mechanics and Control, 1.7.
#[test]
fn the_sleigh_has_the_equations_of_textbooks() {
    beside(&sleigh_along(), &["m*v' - m*a*w^2 - F", "(J + m*a^2)*w' + m*a*v*w"]);
}

/// Euler's equations of a rigid body with a drag torque.
#[test]
fn a_body_has_the_equations_of_euler() {
    beside(&tumbling(), &["A*p' + (C - B)*q*s + k*p", "B*q' + (A - C)*p*s", "C*s' + (B - A)*p*q"]);
}

/// The rolling disc of Kane and Levinson, Dynamics, 5.6, rewritten for the axes and the lean angle of the model. The moments of inertia
/// are A across the axis of the disc and B about it.
#[test]
fn the_rolling_disc_has_the_equations_of_textbooks() {
    beside(
        &rolling(),
        &[
            "5*m*r^2/4*w1' - 3*m*r^2/2*w2*w3 - m*r^2/4*w3^2*sin(lean)/cos(lean) + m*g*r*sin(lean)",
            "3*m*r^2/2*w2' + m*r^2*w1*w3",
            "m*r^2/4*w3' + m*r^2/2*w1*w2 + m*r^2/4*w1*w3*sin(lean)/cos(lean)",
        ],
    );
}

#[test]
fn the_matrix_form_has_kinematic_equations_and_no_reactions() {
    let model = model(&sleigh_along());
    let text = apart(|| {
        let trace = Trace::of(&model);
        let quasi = QuasiVelocities::of(&trace).expect("they are independent");
        let form = MatrixForm::in_quasi_velocities(&trace, &quasi, QuasiPrinciple::Hamel).expect("it applies");
        dalembert_model::text(&trace, &form.for_reading())
    });
    for line in [
        "M u' + h = Q, with u = (v, w)",
        "  v = x'*cos(psi) + y'*sin(psi), in m/s",
        "  x' = v*cos(psi)",
        "  psi' = w",
        "  M[w, w] = m*a^2 + J",
        "  h[v] = -m*a*w^2",
        "  Q[v] = F",
        "    0 = -x'*sin(psi) + y'*cos(psi)",
    ] {
        assert!(text.lines().any(|known| known == line), "{line}\n{text}");
    }
    assert!(!text.contains("lambda"), "{text}");
}

/// A drag that is no polynomial in the speeds, and a conditional force: both are printed in quasi-velocities.
#[test]
fn forces_that_are_no_polynomials_are_written_as_they_are() {
    let mut source = sleigh_along();
    source.parameters.push(("c", "0.3 N s^2/m^2").into());
    let drag = "-c*norm(velocity(P))*velocity(P) - if(v > (1 m/s), c*v^2, 0)*B.x";
    source.forces.push(LoadSource { on: Some("sleigh at P".into()), is: drag.into(), ..LoadSource::default() });
    let model = model(&source);
    apart(|| {
        let trace = Trace::of(&model);
        let quasi = QuasiVelocities::of(&trace).expect("they are independent");
        let form = MatrixForm::in_quasi_velocities(&trace, &quasi, QuasiPrinciple::VirtualPower).expect("it applies");
        let text = dalembert_model::text(&trace, &form.for_reading());
        let force = text.lines().find(|line| line.contains("Q[v]")).expect("there is one").to_owned();
        assert!(force.contains("sqrt(v^2)") && !force.contains("undefined"), "{force}");
        assert!(text.lines().any(|line| line.contains("condition 1 = -1 + v, in m/s")), "{text}");
        for language in [symbolic::Language::C, symbolic::Language::Python, symbolic::Language::Rust] {
            dalembert_model::code(&trace, &form, language).expect("it can be written");
        }
        dalembert_model::sympy(&trace, &form).expect("it can be written");
    });
}

fn faults(source: Source, speeds: &[(&str, &str)]) -> Vec<Fault> {
    Model::of(&with(source, speeds)).expect_err("it is refused")
}

#[test]
fn what_determines_no_speeds_is_refused_by_name() {
    let one = |source: Source, speeds: &[(&str, &str)], title: &str, accepted: &str| {
        let found = faults(source, speeds);
        assert_eq!(found.len(), 1, "{found:?}");
        assert!(found[0].title.contains(title) && found[0].accepted.contains(accepted), "{found:?}");
    };
    let two = "the speeds have 2 degrees of freedom";
    let v = ("v", "velocity(P) . B.x");
    one(sleigh(), &[v], &format!("{two}, and [speeds] has 1: 1 missing"), "one more that holds `psi'`");
    one(
        sleigh(),
        &[v, ("w", "psi'"), ("n", "x'")],
        &format!("{two}, and [speeds] has 3: 1 too many"),
        "without `v` or `n`",
    );
    let along = [v, ("p", "x'"), ("w", "psi'"), ("q", "2*y'")];
    one(sleigh(), &along, "4: 2 too many", "without 2 of `v`, `p` and `q`");
    one(sleigh(), &[("e", "velocity(P) . B.y"), v, ("w", "psi'")], "3: 1 too many", "without `e`");
    let both = [("w", "psi'"), v, ("n", "2*psi'"), ("q", "y'")];
    one(sleigh(), &both, "4: 2 too many", "without `w` or `n`, and without `v` or `q`");
    let idle = [v, ("p", "2*x'"), ("q", "2*y'")];
    one(sleigh(), &idle, "3: 1 too many", "without 2 of `v`, `p` and `q`, and one more that holds `psi'`");
    one(sleigh(), &[v, ("w", "velocity(P) . B.y")], "`w` is determined by the constraints", "`psi'`");
    one(sleigh(), &[v, ("w", "velocity(P) . B.x*psi/2")], "`v` and `w` depend on each other", "`psi'`");
    one(sleigh(), &[("v", "norm(velocity(P))"), ("w", "psi'")], "`v` is not linear in the speeds", "sums of speeds");
    one(sleigh(), &[("v", "x"), ("w", "psi'")], "`v` holds no speed", "linear in rates");
    one(sleigh(), &[("v", "if(x > y, x', y')"), ("w", "psi'")], "`v` changes at a condition", "without `if`");
    one(sleigh(), &[v, ("w", "psi''*(1 s)")], "`w` holds accelerations", "");
    one(double_pendulum(false), &[("u", "a'"), ("v", "2*a'")], "`u` and `v` depend on each other", "`b'`");
    let mut fast = sleigh();
    fast.constraints.push(held("fast", &["x'^2 + y'^2 - (1 m/s)^2"]));
    one(fast, &[("w", "psi'")], "constraint 2 `fast` is not linear in the speeds", "without [speeds]");
}
