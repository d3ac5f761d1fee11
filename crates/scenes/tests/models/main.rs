//! Scene files: read, proved, run, and compared with closed forms and conserved quantities.

mod bodies;
mod conformity;
mod foreign;
mod formulations;
mod knowledge;
mod named_systems;
mod outputs;
mod poles;
mod power_balance;
mod quasi_velocities;
mod redundant;
mod singular;
mod smooth_branches;
mod trees;

// registers the motors of the catalogue
use dalembert_scenes::{ModelScene, Task, read_model};
use integrators::Method;
use machines as _;
use model::principles::Principle;
use model::{Agreement, Trace, agreement};
use simulation::models::holds_model;
use simulation::{Axes, Choice, IvpScene, Stored, references};
use std::path::{Path, PathBuf};
use std::time::Duration;
use studies as _;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes")
}

fn path(name: &str) -> PathBuf {
    folder().join("models").join(name).with_extension("toml")
}

/// The files with a system as text in a folder and in its subfolders.
fn within(folder: &Path) -> Vec<PathBuf> {
    let files = std::fs::read_dir(folder).expect("it is there");
    let mut all: Vec<PathBuf> = files.map(|file| file.expect("it can be listed").path()).collect();
    all.sort();
    let inside = |path: PathBuf| if path.is_dir() { within(&path) } else { vec![path] };
    let is_text = |path: &PathBuf| path.extension().is_some_and(|end| end == "toml");
    let holds = |path: &PathBuf| std::fs::read_to_string(path).is_ok_and(|text| holds_model(&text));
    all.into_iter().flat_map(inside).filter(is_text).filter(holds).collect()
}

fn all() -> Vec<PathBuf> {
    let all = within(&folder());
    assert!(all.len() >= 36, "{}", all.len());
    all
}

/// Scenes whose motion ends before their span.
const ENDING: [&str; 3] = ["blow_up.toml", "between_discs_blow_up.toml", "nodding_top.toml"];

/// The scenes that reach their span. Rough contacts may end a motion; `tests/rough` runs these.
fn going_on() -> Vec<PathBuf> {
    let ends = |path: &PathBuf| ENDING.iter().any(|name| path.ends_with(name));
    let is_rough = |path: &PathBuf| path.components().any(|part| part.as_os_str() == "friction");
    all().into_iter().filter(|path| !is_rough(path) && !ends(path)).collect()
}

fn parsed(text: &str) -> ModelScene {
    ModelScene::parse("scene.toml", text).unwrap_or_else(|error| panic!("{error}"))
}

fn open(path: &Path) -> ModelScene {
    parsed(&std::fs::read_to_string(path).expect("it is there"))
}

/// The last row of a run, and the largest change of each invariant.
fn end(scene: &ModelScene, method: Method, tolerance: f64) -> (Vec<f64>, Vec<f64>) {
    let problem = scene.problem(Axes::First);
    let choice = Choice {
        method,
        tolerance,
        axes: Axes::First,
        samples: 10,
        allowed: Duration::from_secs(60),
        through_singular_positions: scene.run().through_singular_positions,
    };
    let run = problem.simulate(&choice, |_| ());
    assert!(run.outcome.reached(), "{}: {method}: {:?}", scene.title, run.stopped());
    let start: Vec<f64> = problem.invariants.iter().map(|one| (one.value)(0.0, &problem.state)).collect();
    let kept = problem.invariants.iter().zip(&start);
    (run.last.clone(), kept.map(|(one, start)| (one.value)(run.outcome.time, &run.outcome.state) - start).collect())
}

#[test]
fn no_system_that_is_shown_has_a_warning() {
    for path in all() {
        let warnings = open(&path).model.warnings.clone();
        assert!(warnings.is_empty(), "{}: {warnings:?}", path.display());
    }
}

#[test]
fn every_principle_gives_every_model_the_same_equations() {
    for path in all() {
        let model = read_model(&path, Task::Write).unwrap_or_else(|error| panic!("{error}"));
        symbolic::apart(|| {
            let trace = Trace::of(&model);
            for other in Principle::ALL {
                let Ok(found) = agreement(&trace, Principle::Lagrange, other) else {
                    // without inertia, momenta do not determine speeds
                    let is_massless = model.bodies.is_empty() && model.energies.kinetic.is_none();
                    let is_open = other == Principle::Hamilton && (is_massless || !model.algebraic_speeds.is_empty());
                    assert!(model.energies.kinetic.is_some() || is_open, "{}, {}", path.display(), other.name());
                    continue;
                };
                assert_eq!(found.degree(), "proved", "{}, {}: {found}", path.display(), other.name());
            }
        });
    }
}

/// Chaotic motions, for which methods agree for a short time only: neighbouring motions diverge by a factor of e about every second.
const CHAOTIC: [&str; 2] = ["double_pendulum.toml", "five_links.toml"];

#[test]
fn methods_of_different_families_come_to_the_same_end_and_invariants_stay() {
    let is_chaotic = |path: &PathBuf| CHAOTIC.iter().any(|name| path.ends_with(name));
    for path in going_on().into_iter().filter(|path| !is_chaotic(path)) {
        let scene = open(&path);
        let (explicit, kept) = end(&scene, Method::DormandPrince8, 1e-11);
        assert!(kept.iter().all(|moved| moved.abs() < 1e-8), "{}: {kept:?}", path.display());
        for other in [Method::Taylor, Method::RadauIIA { stages: 5 }] {
            let (found, _) = end(&scene, other, 1e-11);
            for (a, b) in explicit.iter().zip(&found) {
                assert!((a - b).abs() < 1e-6 * (1.0 + a.abs()), "{}, {other}: {a} {b}", path.display());
            }
        }
    }
}

/// m = 1 kg, J = 0.1 kg m^2, a = 0.1 m, u = 1 m/s, w = 1 rad/s.
#[test]
fn chaplygins_sleigh_has_its_closed_form() {
    let scene = open(&path("chaplygin_sleigh"));
    let problem = scene.problem(Axes::First);
    let (row, _) = end(&scene, Method::DormandPrince8, 1e-12);
    let of = |name: &str| row[problem.columns.iter().position(|known| known == name).expect("a column")];
    assert!((of("along") - 1.04550269978978).abs() < 1e-12, "{}", of("along"));
    assert!((of("psi'") - 0.392244181048335).abs() < 1e-12, "{}", of("psi'"));
}

#[test]
fn a_start_is_completed_so_that_the_constraints_hold() {
    let text = std::fs::read_to_string(path("slider_crank")).expect("it is there");
    let turned = text.replace("s = \"0.4 m\"", "theta = \"0.5 rad\"\n\"theta'\" = \"2 rad/s\"\ns = \"guess 0.35 m\"");
    let scene = ModelScene::parse("scene.toml", &turned).unwrap_or_else(|error| panic!("{error}"));
    let [theta, phi, s] = [scene.start[0], scene.start[1], scene.start[2]];
    assert_eq!(theta, 0.5);
    // r sin(theta) = l sin(phi), s = r cos(theta) + l cos(phi)
    assert!(
        (0.1 * theta.sin() - 0.3 * phi.sin()).abs() < 1e-10 && (s - 0.1 * theta.cos() - 0.3 * phi.cos()).abs() < 1e-10
    );
    let [rate, slide] = [scene.start[4], scene.start[5]];
    assert!((0.2 * theta.cos() - 0.3 * phi.cos() * rate).abs() < 1e-9 && slide < 0.0, "{rate} {slide}");
    let wrong = text.replace("s = \"0.4 m\"", "theta = \"0 rad\"\nphi = \"0 rad\"\ns = \"0.5 m\"");
    let refused = ModelScene::parse("scene.toml", &wrong).expect_err("the loop is open").to_string();
    assert!(
        refused.contains("`pin` along R.x does not hold at the start")
            && refused.contains("0.1 m with the coordinates"),
        "{refused}"
    );
}

/// A bead on a hoop that turns at constant speed: its energy is not constant, and is not listed as an invariant.
#[test]
fn a_driven_system_is_not_said_to_keep_its_energy() {
    let hoop = |turned: &str| {
        format!(
            "title = \"A bead\"\ngravity = \"-g*N.z\"\n[parameters]\nm = \"0.1 kg\"\nR = \"20 cm\"\ng = \"9.81 m/s^2\"\nw = \"10 rad/s\"\n\
             [coordinates]\nth = \"rad\"\n[frames]\nH = \"N turned {turned} about z\"\n\
             [points]\nP = \"O + R*(sin(th)*H.x - cos(th)*H.z)\"\n[bodies.bead]\ncentre = \"P\"\nmass = \"m\"\n\
             [start]\nth = \"1 rad\"\n[run]\nspan = \"2 s\"\n"
        )
    };
    let kept = |turned: &str| {
        let scene = ModelScene::parse("scene.toml", &hoop(turned)).unwrap_or_else(|error| panic!("{error}"));
        scene.system.keeps_energy
    };
    assert!(!kept("w*t") && kept("0*w*t") && kept("0.3"));
}

/// A cylinder rolls down a plane of 20 degrees with the acceleration 2/3 g sin(20 deg). The second component of its constraint vanishes
/// identically by cos^2 + sin^2 = 1.
#[test]
fn components_of_a_constraint_that_vanish_identically_drop_out() {
    let text = "title = \"A cylinder\"\ngravity = \"-g*N.y\"\n[parameters]\nm = \"2 kg\"\nR = \"0.1 m\"\ng = \"9.81 m/s^2\"\n\
                inc = \"20 deg\"\n[coordinates]\nx = \"m\"\nw = \"rad\"\n[frames]\nI = \"N turned -inc about z\"\nC = \"I turned w about z\"\n\
                [points]\nK = \"O + x*I.x\"\nG = \"K + R*I.y\"\n[bodies.cyl]\nframe = \"C\"\ncentre = \"G\"\nmass = \"m\"\ninertia = \"m*R^2/2\"\n\
                [[constraint]]\nzero = \"velocity(cyl at K)\"\n[run]\nspan = \"1 s\"\n";
    let scene = ModelScene::parse("scene.toml", text).unwrap_or_else(|error| panic!("{error}"));
    let (row, _) = end(&scene, Method::DormandPrince8, 1e-12);
    let exact = 9.81 * 20.0_f64.to_radians().sin() / 3.0;
    assert!((row[0] - exact).abs() < 1e-11, "{} {exact}", row[0]);
}

/// Models whose references have fewer digits, or none. A load step and a wheel that spins up within milliseconds cost two digits. The co-energy
/// of saturated iron, a logarithm of sums of exponentials, and the frequent saturation of the wheelset's creep forces prevent a reference.
/// The four-bar mechanisms have no unique motion at their singular positions.
const FEWER: [(&str, Option<f64>); 5] = [
    ("four_bars", None),
    ("interior_magnet", Some(23.0)),
    ("reaction_wheel", Some(23.0)),
    ("switched_reluctance", None),
    ("wheelset", None),
];

#[test]
fn every_model_has_a_reference_of_25_digits_that_is_its_own() {
    for path in going_on() {
        let name = path.file_stem().map(|name| name.to_string_lossy().into_owned());
        let fewer = FEWER.iter().find(|(fewer, _)| name.as_deref() == Some(*fewer));
        let Some(digits) = fewer.map_or(Some(25.0), |(_, digits)| *digits) else { continue };
        let text = std::fs::read_to_string(references::place(&path))
            .unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let kept = Stored::read(&text).unwrap_or_else(|wrong| panic!("{}: {wrong}", path.display()));
        assert!(kept.reference.digits >= digits, "{}: {} digits", path.display(), kept.reference.digits);
        let scene = open(&path);
        let mut problem = scene.problem(Axes::First);
        let is_own = match scene.hybrid() {
            Some(hybrid) => kept.belongs_to(&*hybrid.owner()),
            None => kept.belongs_to(&problem),
        };
        assert!(is_own, "{} has changed: `dalembert reference` makes its reference anew", path.display());
        if scene.hybrid().is_none() {
            // the reference of a run that ends early has a shorter span
            problem.span = *kept.reference.times.last().expect("there are instants");
        }
        let run = problem.simulate(
            &Choice {
                method: Method::Taylor,
                tolerance: 1e-12,
                axes: Axes::First,
                samples: 8,
                allowed: Duration::from_secs(60),
                through_singular_positions: false,
            },
            |_| (),
        );
        let (last, exact) = (&run.outcome.state, kept.reference.states.last().expect("there are instants"));
        for ((found, exact), size) in last.iter().zip(exact).zip(&kept.reference.sizes) {
            assert!((found - exact.hi()).abs() < 1e-7 * size.max(1e-9), "{}: {found} {exact:?}", path.display());
        }
    }
}

/// A chain of links, each turned relative to the one before, horizontal at the start.
fn chain(links: usize) -> String {
    let numbered = |line: &dyn Fn(usize) -> String| (1..=links).map(|k| line(k) + "\n").collect::<String>();
    let before = |name: &str, first: &str, k: usize| if k == 1 { first.to_owned() } else { format!("{name}{}", k - 1) };
    [
        "title = \"A chain\"\ngravity = \"-g*N.y\"\n[parameters]\nm = \"1 kg\"\nl = \"0.5 m\"\ng = \"9.81 m/s^2\"\n[coordinates]\n".to_owned(),
        numbered(&|k| format!("q{k} = \"rad\"")),
        "[frames]\n".to_owned(),
        numbered(&|k| format!("A{k} = \"{} turned q{k} about z\"", before("A", "N", k))),
        "[points]\n".to_owned(),
        numbered(&|k| format!("G{k} = \"{0} - l/2*A{k}.y\"\nE{k} = \"{0} - l*A{k}.y\"", before("E", "O", k))),
        numbered(&|k| format!("[bodies.b{k}]\nframe = \"A{k}\"\ncentre = \"G{k}\"\nmass = \"m\"\ninertia = \"m*l^2/12\"")),
        "[start]\nq1 = \"90 deg\"\n[run]\nspan = \"0.2 s\"\n".to_owned(),
    ]
    .concat()
}

#[test]
fn a_chain_of_twenty_links_is_proved_and_runs() {
    let scene = ModelScene::parse("chain.toml", &chain(20)).unwrap_or_else(|error| panic!("{error}"));
    symbolic::apart(|| {
        let trace = Trace::of(&scene.model);
        for other in Principle::ALL.into_iter().skip(1) {
            let found = agreement(&trace, Principle::Lagrange, other).expect("it applies");
            let Agreement::Theorem { error, .. } = found else { panic!("{}: {found}", other.name()) };
            assert!(error < -100.0, "{error}");
        }
    });
    let (_, kept) = end(&scene, Method::DormandPrince8, 1e-10);
    assert!(!kept.is_empty() && kept.iter().all(|moved| moved.abs() < 1e-7), "{kept:?}");
}

/// The rod of a pendulum carries m (l a'^2 + g cos(a)); the reaction of a hoop, given as a constraint in its place, is equal.
#[test]
fn loads_of_joints_and_reactions_are_outputs_of_a_run() {
    let text = "title = \"A bob\"\ngravity = \"-g*N.y\"\n[parameters]\nm = \"2 kg\"\nl = \"0.5 m\"\ng = \"9.81 m/s^2\"\n\
                [coordinates]\na = \"rad\"\nx = \"m\"\ny = \"m\"\n[frames]\nA = \"N turned a about z\"\n\
                [points]\nP = \"O - l*A.y\"\nQ = \"O + x*N.x + y*N.y\"\n\
                [bodies.bob]\ncentre = \"P\"\nmass = \"m\"\n[bodies.bead]\ncentre = \"Q\"\nmass = \"m\"\n\
                [[constraint]]\nname = \"hoop\"\nzero = \"distance(O, Q) - l\"\n\
                [outputs]\nrod = \"joint_force(bob) . A.y\"\nacross = \"joint_force(bob) . A.x\"\nhoop = \"reaction(hoop)\"\n\
                free = \"norm(joint_force(bead))\"\n\
                [start]\na = \"60 deg\"\nx = \"0.43301270189221935 m\"\ny = \"-0.25 m\"\n[run]\nspan = \"0.7 s\"\n";
    let scene = ModelScene::parse("scene.toml", text).unwrap_or_else(|error| panic!("{error}"));
    let problem = scene.problem(Axes::First);
    let (row, _) = end(&scene, Method::DormandPrince8, 1e-12);
    let of = |name: &str| row[problem.columns.iter().position(|known| known == name).expect("a column")];
    let carried = 2.0 * (0.5 * of("a'").powi(2) + 9.81 * of("a").cos());
    assert!((of("rod") - carried).abs() < 1e-12 * carried && of("across").abs() < 1e-12, "{carried} {row:?}");
    assert!((of("hoop") + carried).abs() < 1e-8 * carried, "{carried} {}", of("hoop"));
    assert!(of("free").abs() < 1e-12, "{}", of("free"));
}
