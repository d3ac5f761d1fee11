//! Every formulation of a model's constraints, compared with the run of the model.

use super::open;
use dalembert_scenes::ModelScene;
use integrators::{Index2Method, Method, Record, Span, Tolerance, integrate, integrate_index2};
use simulation::work_precision::{Formulation, Treated};
use simulation::{Axes, IvpScene};

/// A body on a free frame, fixed at one of its points: position constraints that contain a quaternion.
const HELD_AT_A_POINT: &str = "title = \"A body held at a point\"\ngravity = \"-(9.81 m/s^2)*N.z\"\n\
     [coordinates]\nx = \"m\"\ny = \"m\"\nz = \"m\"\n[frames]\nF = \"N free\"\n\
     [points]\nG = \"O + x*N.x + y*N.y + z*N.z\"\nP = \"G - (0.3 m)*F.x\"\n\
     [bodies.b]\nframe = \"F\"\ncentre = \"G\"\nmass = \"(2 kg)\"\n\
     inertia = { principal = [\"(0.02 kg m^2)\", \"(0.03 kg m^2)\", \"(0.04 kg m^2)\"] }\n\
     [[constraint]]\nzero = \"P - O\"\n[start]\nx = \"0.3 m\"\n\"F.wz\" = \"2 rad/s\"\n[run]\nspan = \"1 s\"\n";

fn parsed(text: &str) -> ModelScene {
    ModelScene::parse("scene.toml", text).unwrap_or_else(|error| panic!("{error}"))
}

/// The last state of a run with a formulation.
fn end(law: &Treated, span: &Span<'_, f64>) -> Vec<f64> {
    let (gauss, mut record) = (Index2Method::ProjectedGauss { stages: 3, steps: 400 }, Record::new());
    let outcome = match law {
        Treated::Free(law) => integrate(&**law, Method::DormandPrince8, &Tolerance::both(1e-10), span, &mut record),
        Treated::Held(law) => integrate_index2(&**law, gauss, span, &mut record),
        Treated::Hybrid(_) => panic!("these have no events"),
    };
    assert!(outcome.reached(), "{:?}", outcome.end);
    outcome.state
}

#[test]
fn every_formulation_of_a_model_tends_to_one_motion() {
    let shown = ["models/rolling_disc", "models/chaplygin_sleigh", "models/slider_crank", "foreign/andrews_mechanism"]
        .map(|name| open(&super::folder().join(name).with_extension("toml")));
    for scene in shown.into_iter().chain([parsed(HELD_AT_A_POINT)]) {
        let problem = scene.problem(Axes::First);
        let span = Span::new(0.0, problem.span.min(1.0), &problem.state);
        let mut own = ();
        let exact = integrate(&*problem.law, Method::DormandPrince8, &Tolerance::both(1e-12), &span, &mut own).state;
        let size = exact.iter().fold(1.0, |size: f64, part| size.max(part.abs()));
        let ways = scene.ways();
        let found: Vec<Formulation> = ways.iter().map(|way| way.formulation).collect();
        let treated = [Formulation::IndexReduced, Formulation::Led, Formulation::Projected, Formulation::Held];
        assert!(treated.iter().all(|one| found.contains(one)), "{}: {found:?}", scene.title);
        for way in &ways {
            let off = end(&way.law, &span).iter().zip(&exact).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(off < 1e-7 * size, "{}, {}: {off:e}", scene.title, way.formulation);
        }
    }
}

/// The multipliers of the position and velocity levels remove violations of the constraints.
#[test]
fn what_is_held_stays_on_its_constraints() {
    let scene = parsed(HELD_AT_A_POINT);
    let ways = scene.ways();
    let held = ways.iter().find(|way| way.formulation == Formulation::Held).expect("it is offered");
    let problem = scene.problem(Axes::First);
    let last = end(&held.law, &Span::new(0.0, 1.0, &problem.state));
    let length = last[..3].iter().map(|part| part * part).sum::<f64>().sqrt();
    assert!((length - 0.3).abs() < 1e-14, "{length}");
}
