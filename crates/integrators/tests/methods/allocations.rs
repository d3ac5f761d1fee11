//! The inner loops do not allocate: twice as many steps cause no additional allocations.

use std::alloc::{GlobalAlloc, Layout, System as Heap};
use std::cell::Cell;

use crate::held::methods;
use crate::problems::{Chain, Kepler, Rim};
use dalembert_integrators::{
    Jacobian, Method, Ode, Span, Tolerance, Working, integrate, integrate_in, integrate_index2,
};
use field::DoubleDouble;

/// Counts the allocations of each thread.
struct Counting;

thread_local! {
    static COUNT: Cell<u64> = const { Cell::new(0) };
}

// SAFETY: every call is passed unchanged to the system's allocator; the counter itself does not allocate.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        COUNT.set(COUNT.get() + 1);
        // SAFETY: the caller guarantees what `alloc` requires.
        unsafe { Heap.alloc(layout) }
    }

    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        // SAFETY: the block came from `alloc` above, with this layout.
        unsafe { Heap.dealloc(block, layout) }
    }
}

#[global_allocator]
static COUNTING: Counting = Counting;

fn allocations(work: impl FnOnce()) -> u64 {
    let before = COUNT.get();
    work();
    COUNT.get() - before
}

/// The number of allocations of a run over Kepler's ellipse, and its number of steps.
fn run<S: Working>(method: Method, length: f64) -> (u64, u64) {
    let ellipse = Kepler { eccentricity: 0.3 };
    let span = Span::new(0.0, length, &ellipse.state::<S>(0.0));
    let (tolerance, mut steps) = (Tolerance::both(1e-8), 0);
    let count = allocations(|| steps = integrate_in(&ellipse, method, &tolerance, &span, &mut ()).work.steps);
    (count, steps)
}

#[test]
fn the_allocations_of_a_run_do_not_depend_on_its_number_of_steps() {
    let constant = [(Method::Euler { steps: 100 }, Method::Euler { steps: 200 })];
    let constant =
        constant.into_iter().chain([(Method::RungeKutta4 { steps: 100 }, Method::RungeKutta4 { steps: 200 })]);
    let implicit = [(Method::BackwardEuler { steps: 100 }, Method::BackwardEuler { steps: 200 })];
    for (few, many) in constant.chain(implicit) {
        assert_eq!(run::<f64>(few, 5.0).0, run::<f64>(many, 5.0).0, "{few}");
    }
    for method in [Method::GraggBulirschStoer, Method::Gauss { stages: 3 }, Method::RadauIIA { stages: 3 }] {
        let ((short, few), (long, many)) = (run::<f64>(method, 5.0), run::<f64>(method, 50.0));
        assert!(many > 5 * few && short == long, "{method}: {short} in {few} steps, {long} in {many}");
        let ((short, few), (long, many)) = (run::<DoubleDouble>(method, 5.0), run::<DoubleDouble>(method, 50.0));
        assert!(many > 5 * few && short == long, "{method}: {short} in {few} steps, {long} in {many}");
    }
}

#[test]
fn the_allocations_of_a_held_run_do_not_depend_on_its_number_of_steps() {
    let span = Span::new(0.0, 2.0, &Rim::state::<f64>(0.0));
    let count = |method| allocations(|| assert!(integrate_index2(&Rim, method, &span, &mut ()).reached()));
    for (few, many) in methods(50).into_iter().zip(methods(500)) {
        assert_eq!(count(few), count(many), "{few}");
    }
}

#[test]
fn the_allocations_of_methods_in_f64_do_not_depend_on_their_number_of_steps() {
    let ellipse = Kepler { eccentricity: 0.3 };
    let count = |method, length| {
        let span = Span::new(0.0, length, &ellipse.state::<f64>(0.0));
        allocations(|| drop(integrate(&ellipse, method, &Tolerance::both(1e-8), &span, &mut ())))
    };
    for method in [Method::DormandPrince5, Method::DormandPrince8, Method::Rodas4, Method::BaderDeuflhard] {
        assert_eq!(count(method, 5.0), count(method, 50.0), "{method}");
    }
}

#[test]
fn rates_and_jacobians_do_not_allocate() {
    let chain = Chain { bars: 10, frequency: 1.0 };
    let (y, mut dy, mut matrix) = (vec![0.1; 20], vec![0.0; 20], vec![0.0; 400]);
    let mut jacobian = Jacobian::new(&chain);
    let count = allocations(|| {
        for k in 0..100 {
            chain.rates(f64::from(k), &y, &mut dy);
            jacobian.matrix(f64::from(k), &y, &mut matrix);
            jacobian.time_derivatives(f64::from(k), &y, &mut dy);
        }
    });
    assert_eq!(count, 0);
}
