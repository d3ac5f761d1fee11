//! The power balance of supply, friction and heat in the frame of the rotating field, integrated along runs.

use dalembert_derivations::studies::scene::Scene;
use reader::Family;
use simulation::Axes;

#[test]
fn the_work_that_is_metered_is_what_the_energy_gains() {
    for name in ["brushed", "brushed_bench", "permanent_magnet", "permanent_magnet_bench"] {
        let scene = Scene::open(format!("scenes/machines/{name}.toml").as_ref()).expect("the scene is sound");
        let run = scene.metered(Axes::Second).simulate(&scene.choice(), |_| ());
        assert!(run.outcome.reached(), "{name}: {:?}", run.outcome.end);
        let kept = run.outcome.deviations.iter().find(|kept| kept.name == "jacobi_less_work").expect("it is metered");
        let work = run.last.last().copied().unwrap_or_default();
        assert!(work.abs() > 1e-3 && kept.largest < 1e-8 * work.abs(), "{name}: {kept:?} beside {work}");
    }
}

#[test]
fn what_no_supply_feeds_runs_without_a_meter() {
    let scene = Scene::open("scenes/machines/crossed_windings.toml".as_ref()).expect("the scene is sound");
    assert_eq!(scene.metered(Axes::First).columns, scene.problem(Axes::First).columns);
}
