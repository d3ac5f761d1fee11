//! Scenes with a motor as models: bodies, a free frame and a drive give the same accelerations as the compiled law.

use dalembert_derivations::studies::scene::Scene;
use integrators::Ode;
use reader::Family;
use scenes::{CompiledSystem, Mode, Task, read_model, start_of};
use simulation::Axes;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Every scene of the family below a folder.
fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("the folder can be read");
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry").path()).collect();
    paths.sort();
    let of = |path: PathBuf| match path.is_dir() {
        true => files(&path),
        false => Vec::from_iter(
            (path.extension().is_some_and(|is| is == "toml") && Scene::open(&path).is_ok()).then_some(path),
        ),
    };
    paths.into_iter().flat_map(of).collect()
}

/// The rates at the start: the carrier's angular acceleration in the axes of the data, those of the rotor and of the
/// currents.
fn by_law(scene: &Scene) -> Vec<f64> {
    let problem = scene.problem(Axes::First);
    let mut rates = vec![0.0; problem.state.len()];
    problem.law.rates(0.0, &problem.state, &mut rates);
    scene.back(Axes::First)(&mut rates);
    let carrier = if scene.on_bench() { 0 } else { 3 };
    let names = scene.names();
    let rotor = names.iter().position(|name| name == "slip").map_or(0.0, |slip| rates[slip]);
    let own = motor::state_names(&scene.machine);
    let currents =
        names.len() - (own.len() - own.iter().position(|name| name == "slip").map_or(own.len(), |slip| slip + 1));
    [&rates[..carrier], &[rotor], &rates[currents..]].concat()
}

fn by_model(path: &Path) -> Vec<f64> {
    let model = read_model(path, Task::Run).unwrap_or_else(|error| panic!("{error}"));
    let start = start_of(&model).expect("it starts");
    let system = CompiledSystem::of(&Arc::new(model.clone()), &Mode::default()).expect("it has a law");
    let mut rates = vec![0.0; start.len()];
    Ode::<f64>::rates(&system, 0.0, &start, &mut rates);
    let names: Vec<String> = model.state_names().into_iter().map(|(name, _)| name).collect();
    let speeds = names.iter().zip(&rates).skip(model.positions());
    let of = |is: &dyn Fn(&str) -> bool| speeds.clone().filter(|(name, _)| is(name)).map(|(_, &rate)| rate).collect();
    let parts: [Vec<f64>; 3] =
        [of(&|name| name.starts_with("C.")), of(&|name| name == "phi'"), of(&|name| name.starts_with("motor."))];
    parts.concat()
}

#[test]
fn every_scene_with_a_motor_is_a_model_with_the_accelerations_of_its_law() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes");
    let files = files(&folder);
    assert!(files.len() > 20, "{files:?}");
    for path in files {
        let scene = Scene::open(&path).expect("it is sound");
        let (law, model) = (by_law(&scene), by_model(&path));
        assert_eq!(law.len(), model.len(), "{}", path.display());
        let size = law.iter().fold(1.0, |most: f64, rate| most.max(rate.abs()));
        for (one, other) in law.iter().zip(&model) {
            assert!((one - other).abs() < 1e-9 * size, "{}: {law:?}, {model:?}", path.display());
        }
    }
}
