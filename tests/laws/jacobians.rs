//! The Jacobian used by the implicit methods is machine code from exact differentiation of the laws. It agrees with
//! that of dual numbers for every machine and form, and for every mechanism, at states other than the initial one.

use crate::physical::machines::with_bars;
use crate::physical::rounded;
use dalembert_derivations::papers::konosevich2022::gyrostats;
use dalembert_derivations::studies::AnyScene;
use dalembert_derivations::systems::gyrostat::driven::Driven;
use dalembert_derivations::systems::gyrostat::forms::Form;
use integrators::{Dual8, Jacobian, Ode, System};
use motor::{Motor, catalogue};
use reader::Family as _;
use simulation::{Axes, CompiledLaw, SymbolicLaw};
use std::path::Path;
use std::sync::Arc;

/// Whether the system has its own Jacobian; if so, it is compared with that of a law at a few states, with the
/// tolerance `allowed` relative to the largest entry.
fn compared(
    system: &dyn System,
    law: &dyn Ode<Dual8>,
    allowed: f64,
    states: impl IntoIterator<Item = Vec<f64>>,
) -> bool {
    let n = Ode::<f64>::dimension(system);
    let (mut own, mut dual) = (Jacobian::of(system), Jacobian::new(law));
    let (mut ours, mut theirs) = (vec![f64::NAN; n * n + n], vec![f64::NAN; n * n + n]);
    for (turn, y) in states.into_iter().enumerate() {
        let t = 0.1 + 0.3 * turn as f64;
        for (jacobian, into) in [(&mut own, &mut ours), (&mut dual, &mut theirs)] {
            let (matrix, by_time) = into.split_at_mut(n * n);
            jacobian.matrix(t, &y, matrix);
            jacobian.time_derivatives(t, &y, by_time);
        }
        let size = theirs.iter().fold(1.0, |most: f64, entry| most.max(entry.abs()));
        for (place, (ours, theirs)) in ours.iter().zip(&theirs).enumerate() {
            let difference = (ours - theirs).abs();
            assert!(difference < allowed * size, "row {}, column {}: {ours} for {theirs}", place / n, place % n);
        }
    }
    system.jacobian_fn().is_some()
}

fn has_slopes(form: impl Form<f64> + Send + Sync + 'static, machine: Motor) -> bool {
    let law = Arc::new(Driven::new(form, machine));
    let system = CompiledLaw::of(Arc::clone(&law) as Arc<dyn SymbolicLaw>);
    let n = Ode::<f64>::dimension(&system);
    let state = |turn: usize| (0..n).map(|i| 2.0 * ((7 * turn + 3 * i) as f64).sin()).collect();
    compared(&system, &*law, 1e-13, (0..5).map(state))
}

#[test]
fn the_jacobian_of_a_machine_is_that_of_dual_numbers() {
    let g = rounded(&gyrostats::opposite_sign().gyrostat);
    let mut with = Vec::new();
    for entry in catalogue::entries() {
        for bars in [1, 6] {
            let machine = with_bars(entry.name, bars);
            let first = has_slopes(g.first_form().0, machine.clone());
            if first && has_slopes(g.second_form().0, machine) {
                with.push(entry.name);
            }
        }
    }
    // otherwise nothing would have been compared
    assert!(with.contains(&"synchronous") && with.contains(&"multi_current"), "{with:?}");
}

/// Whether a scene's law has its own Jacobian; if so, it is compared with dual numbers near the initial state.
fn is_that_of_dual_numbers(name: &str, allowed: f64) -> bool {
    scenes::register(|_| ());
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes").join(name).with_extension("toml");
    let scene = AnyScene::open(&path).unwrap_or_else(|error| panic!("{error}"));
    let problem = scene.smooth().problem(Axes::First);
    let away = |turn: usize| {
        let moved = |(i, y): (usize, &f64)| y + 0.01 * ((5 * turn + 2 * i) as f64).cos();
        problem.state.iter().enumerate().map(moved).collect()
    };
    compared(&*problem.law, &*problem.law, allowed, (0..3).map(away))
}

#[test]
fn the_jacobian_of_a_mechanism_is_that_of_dual_numbers_and_so_are_its_slopes_in_time() {
    for name in
        ["bodies/crank_slider", "bodies/coin", "drive/stiff_diode", "governors/drum_programme", "governors/released"]
    {
        let has_slopes = is_that_of_dual_numbers(name, 1e-13);
        assert!(has_slopes || !["bodies/crank_slider", "governors/drum_programme"].contains(&name), "{name}");
    }
}

#[test]
fn the_jacobian_of_a_long_law_is_that_of_dual_numbers_and_so_are_its_slopes_in_time() {
    // by the recursion over the tree of bodies, and by the mass matrix with a drive
    for name in ["foreign/andrews_mechanism", "foreign/bicycle", "foreign/flexible_slider_crank", "foreign/five_links"]
    {
        assert!(is_that_of_dual_numbers(name, 1e-12), "{name}");
    }
}
