//! Principles that eliminate the reactions of constraints: Maggi's and Shulgin's equations.

use crate::systems::{double_pendulum, entries, held, rolling_disc, sleigh, slider_crank};
use dalembert_model::equations::{Characteristics, constraints_of};
use dalembert_model::principles::Projection;
use dalembert_model::{Agreement, BodySource, InertiaSource, Model, Projected, Source, Trace, projected_agreement};
use symbolic::{Hypotheses, Sym, apart};

fn found(source: &Source, projection: Projection) -> Result<Projected, String> {
    let model = Model::of(source).unwrap_or_else(|faults| panic!("{faults:?}"));
    apart(|| projected_agreement(&Trace::of(&model), projection).map_err(|why| why.to_string()))
}

/// A disc that rolls on an accelerated belt.
fn belt() -> Source {
    let drives = held("belt", &["velocity(disc at P) . N.x - (1 m/s^2)*t", "velocity(disc at P) . N.y"]);
    Source { constraints: vec![drives], ..rolling_disc() }
}

#[test]
fn maggi_and_shulgin_agree_with_multipliers() {
    let varying = |mut source: Source, mass: &str| {
        source.bodies.last_mut().expect("it has a body").mass = Some(mass.into());
        source
    };
    let losing = varying(slider_crank(), "m - (0.1 kg/s)*t");
    // a mass that depends on a speed; the constraints determine this speed from others
    let fast = varying(sleigh(), "m + (0.1 kg s/m)*y' + (0.2 kg/m)*x");
    for source in [sleigh(), rolling_disc(), slider_crank(), belt(), losing, fast] {
        for projection in Projection::ALL {
            let Projected { agreement, points } = found(&source, projection).expect("it applies");
            assert!(matches!(agreement, Agreement::Proved { .. }), "{projection}: {agreement}; {points}");
        }
    }
}

/// Substituting the dependent speeds and accelerations makes the constraints' first and second rates zero for all independent ones.
#[test]
fn the_motion_by_independent_speeds_keeps_the_constraints() {
    for source in [sleigh(), rolling_disc(), slider_crank(), belt()] {
        let model = Model::of(&source).unwrap_or_else(|faults| panic!("{faults:?}"));
        apart(|| {
            let trace = Trace::of(&model);
            let constraints = constraints_of(&trace);
            let motion = Characteristics::of(&trace, &constraints).motion(&trace, &constraints).expect("it is linear");
            let rates = constraints.iter().flat_map(|constraint| [constraint.rate, trace.rate_of(constraint.rate)]);
            for left in motion.on_constraints(&rates.collect::<Vec<Sym>>()) {
                let decided = symbolic::decide(left, &Hypotheses::none());
                assert!(decided.is_zero(), "{decided}");
            }
        });
    }
}

/// A rolling ball with unequal moments of inertia and a free frame: rotations of the frame do not commute. Maggi's and Shulgin's equations
/// must take this into account.
#[test]
fn free_frames_are_taken_along() {
    let some = |text: &str| Some(text.into());
    let ball = Source {
        parameters: entries(&[("m", "kg"), ("r", "m"), ("J", "kg m^2"), ("K", "kg m^2")]),
        coordinates: entries(&[("x", "m"), ("y", "m")]),
        frames: entries(&[("F", "N free")]),
        points: entries(&[("P", "O + x*N.x + y*N.y"), ("G", "P + r*N.z")]),
        bodies: vec![BodySource {
            name: "ball".into(),
            frame: some("F"),
            centre: some("G"),
            mass: some("m"),
            inertia: Some(InertiaSource::Tensor {
                axes: None,
                entries: Box::new([some("J"), some("K"), some("K"), None, None, None]),
            }),
            ..BodySource::default()
        }],
        constraints: vec![held("rolling", &["velocity(ball at P) . N.x", "velocity(ball at P) . N.y"])],
        ..Source::default()
    };
    // virtual power, Appell, Gauss and Newton-Euler do not use the commutation rule of free frames
    crate::agree(&ball);
    for projection in Projection::ALL {
        let Projected { agreement, points } = found(&ball, projection).expect("it applies");
        assert!(matches!(agreement, Agreement::Proved { .. }), "{projection}: {agreement}; {points}");
    }
}

#[test]
fn the_points_on_the_constraints_are_told() {
    let Projected { points, .. } = found(&rolling_disc(), Projection::Shulgin).expect("it applies");
    assert_eq!(
        points,
        "at points on the constraints: all letters and heading', lean', spin' are free, x', y' and their rates follow"
    );
}

#[test]
fn a_principle_that_does_not_apply_says_why() {
    let free = found(&double_pendulum(false), Projection::Maggi).expect_err("there are no constraints");
    assert!(free.contains("without constraints"), "{free}");
    let mut fast = sleigh();
    fast.constraints = vec![held("speed", &["x'^2 + y'^2 - (1 m/s)^2"])];
    let nonlinear = found(&fast, Projection::Shulgin).expect_err("it is not linear");
    assert!(nonlinear.contains("constraint 1 `speed` is not linear in the speeds"), "{nonlinear}");
    let mut led = sleigh();
    led.constraints[0].gains = Some(vec!["(2 1/s)".into()]);
    let programmed = found(&led, Projection::Shulgin).expect_err("it need not hold");
    assert!(programmed.contains("constraint 1 `edge` is programmed: it need not hold along a motion"), "{programmed}");
    let Projected { agreement, .. } = found(&fast, Projection::Maggi).expect("it applies");
    assert!(matches!(agreement, Agreement::Proved { .. }), "{agreement}");
}
