//! The readable form of equations: angles, constants, lengths, units.

use crate::form;
use crate::rolling_bodies::{bowl, joined_bodies, sliding_wedge, turntable};
use crate::systems::{double_pendulum, free_top, oscillator, slider_crank};
use dalembert_model::principles::Principle;
use dalembert_model::{BodySource, MatrixForm, Model, Source, Trace};
use symbolic::{Language, apart};

#[test]
fn derived_vectors_are_typeset_beside_their_text() {
    let model = Model::of(&double_pendulum()).expect("it is a system");
    let vectors = apart(|| dalembert_model::derived_vectors(&Trace::of(&model)));
    let value = |name: &str| vectors.iter().find(|vector| vector.name == name).and_then(|vector| vector.value.clone());
    let [text, latex] = value("velocity(P)").expect("P has a velocity");
    assert_eq!([&*text, &*latex], ["l1*a'*A.x", r"l_1\dot{a}\,\mathbf{A}_x"]);
    let [text, latex] = value("acceleration(P)").expect("P has an acceleration");
    assert!(latex.matches(r"\mathbf{A}").count() == text.matches("A.").count() && !latex.contains('*'), "{latex}");
}

#[test]
fn angles_stay_together_and_constants_are_as_written() {
    let text = |source: Source, principle| {
        let model = Model::of(&source).expect("it is a system");
        apart(|| {
            let trace = Trace::of(&model);
            let form = MatrixForm::of(&trace, principle).ok()?.for_reading();
            Some([
                dalembert_model::text(&trace, &form),
                dalembert_model::latex(&trace, &form),
                dalembert_model::vectors(&trace).join("\n"),
            ])
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
    // 30 deg is pi/6, whose cosine contains sqrt(3); decimal numbers stay decimal
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
        // the moment of inertia is `Jrod` and the Jacobian is written out, because `J` is a parameter of the system
        "M q'' + h = Q + jacobian^T lambda, with q = (theta, phi, s)",
        "M[phi, phi] = l^2*mrod/4 + Jrod",
        "Q[theta] = T - r*mrod*g*cos(theta)",
        "constraint 1 `pin` along R.x: of positions",
        "f1 = l + r*cos(theta + phi) - s*cos(phi)",
    ] {
        assert!(crank.lines().any(|known| known.trim() == line), "{line}\n{crank}");
    }
}

/// In generated code, a parameter has the unit of its text if this unit is coherent (SI). Angles are in radians, all other parameters in
/// the coherent unit.
#[test]
fn parameters_of_code_have_readable_units() {
    let mut source = double_pendulum();
    for (name, value) in [
        ("c", "0.1 kg/s"),
        ("al", "10 deg"),
        ("p", "2 kN"),
        ("mu", "0.3"),
        ("w", "30 rpm"),
        ("d", "3 g/s"),
        ("e", "2 g mm/s^3"),
    ] {
        source.parameters.push((name, value).into());
    }
    let model = Model::of(&source).unwrap_or_else(|faults| panic!("{faults:?}"));
    let code = apart(|| {
        let trace = Trace::of(&model);
        let form = MatrixForm::of(&trace, Principle::VirtualPower).expect("it applies");
        dalembert_model::code(&trace, &form, Language::C).expect("it can be written")
    });
    for line in ["c; // kg/s", "al; // rad", "p; // N", "mu; // 1", "w; // rad/s", "d; // kg/s", "e; // kg m/s^3"] {
        assert!(code.contains(&format!("double {line}\n")), "{line}\n{code}");
    }
}

/// Four bodies, each with a free frame relative to the previous body: the equations are too long for a SymPy module.
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
        assert!(dalembert_model::code(&trace, &form, Language::C).is_ok());
        dalembert_model::sympy(&trace, &form).map(|module| module.len())
    });
    let refused = refused.expect_err("it is long");
    assert!(refused.contains("operations is too long for SymPy; c, python and rust"), "{refused}");
}

/// Returns the equations in quasi-velocities as readable text, with the start values for the remarks on divisors.
fn text_of(source: &Source, start: &[f64]) -> String {
    let model = Model::of(source).unwrap_or_else(|faults| panic!("{faults:?}"));
    apart(|| {
        let trace = Trace::of(&model);
        dalembert_model::text(&trace, &form(&trace).with_start(&trace, start).for_reading())
    })
}

/// For every orientation of the ball, the mass of its equations is 7/5 m; no direction cosine remains, and none is a divisor.
#[test]
fn balls_that_roll_have_the_equations_of_textbooks() {
    let text = text_of(&turntable(), &[]);
    let lines = [
        "M[ux, ux] = 7*m/5",
        "M[uy, uy] = 7*m/5",
        "M[n, n] = 2*m*r^2/5",
        "h[ux] = -m*W^2*x*cos(W*t) - m*W^2*y*sin(W*t) - 12*m*W*uy/5",
    ];
    for line in lines {
        assert!(text.lines().any(|known| known.trim() == line), "{line}\n{text}");
    }
    assert!(!text.contains("divisor"), "{text}");
    let text = text_of(&sliding_wedge(), &[]);
    // the mass matrix is called `mass`, because `M` is a parameter of the system
    assert!(text.contains("mass[V, V] = m + M - 3*m*cos(al)^2/5") && !text.contains("divisor"), "{text}");
}

/// `lambda1` and `lambda_1` have one LaTeX form. The second symbol is therefore printed upright, by its name.
#[test]
fn letters_that_would_look_alike_are_told_apart_in_latex() {
    let mut source = turntable();
    source.parameters.push(("lambda1", "1 N s/m").into());
    source.speeds[2].name = "lambda_1".into();
    source.speeds[1].name = "t_".into();
    source.forces.push(dalembert_model::LoadSource {
        along: Some("x".into()),
        is: "-lambda1*x'".into(),
        ..dalembert_model::LoadSource::default()
    });
    let model = Model::of(&source).unwrap_or_else(|faults| panic!("{faults:?}"));
    let latex = apart(|| dalembert_model::latex(&Trace::of(&model), &form(&Trace::of(&model)).for_reading()));
    let vector = r"\mathbf{u} &= (\mathrm{ux}, t_{\_}, \mathrm{lambda\_1})^T";
    assert!(latex.lines().any(|line| line.trim().trim_end_matches(r" \\") == vector), "{latex}");
    assert!(latex.contains(r"\lambda_1 &= 1\,\mathrm{N\,s/m}"), "{latex}");
}

/// Constraints without stabilisation are eliminated by the quasi-velocities: the SymPy module must not use names that it does not define.
#[test]
fn a_module_without_multipliers_does_not_speak_of_them() {
    let model = Model::of(&turntable()).unwrap_or_else(|faults| panic!("{faults:?}"));
    let module = apart(|| dalembert_model::sympy(&Trace::of(&model), &form(&Trace::of(&model)))).expect("it is short");
    for name in ["multiplier", "jacobian", "bias"] {
        assert!(!module.contains(name), "{name}\n{module}");
    }
    assert!(module.starts_with("# mass_matrix*u' + inertia = forces\n"), "{module}");
}

#[test]
fn a_divisor_is_told_with_the_start_at_which_it_vanishes() {
    let beside = [0.3, 0.1, -0.4, 1.0, 0.0, 0.0, 0.0];
    let text = text_of(&bowl(), &beside);
    let divisor = "where this divisor does not vanish: r^2*x^2/(x^2 + y^2 + z^2) + r^2*y^2/(x^2 + y^2 + z^2).";
    assert!(text.contains(&format!("{divisor} It does not vanish at the start.")), "{text}");
    let lowest = [0.0, 0.0, -0.5, 1.0, 0.0, 0.0, 0.0];
    assert!(text_of(&bowl(), &lowest).contains(&format!("{divisor} It vanishes at the start")));
}

/// B.y x B.z = B.x: products of two direction cosines that form a cofactor are simplified to a single direction cosine.
#[test]
fn products_of_direction_cosines_that_are_cofactors_are_one() {
    let text = text_of(&joined_bodies(), &[]);
    let line = "x2' = l*p1*A.Rxy - l*q1*A.Rxx - l*p2*A.Ryx*B.Rzz/2 + l*p2*A.Rzx*B.Ryz/2 - l*q2*A.Ryy*B.Rzz/2 \
                + l*q2*A.Rzy*B.Ryz/2 - l*r2*A.Ryz*B.Rzz/2 + l*r2*A.Rzz*B.Ryz/2";
    assert!(text.lines().any(|known| known.trim() == line), "{text}");
}
