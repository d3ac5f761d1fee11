//! Projection onto constraints allocates no memory: twice as many steps need equally many allocations.

use super::scene;
use integrators::{Method, Span, Tolerance, integrate};
use simulation::{Axes, IvpScene};
use std::alloc::{GlobalAlloc, Layout, System as Heap};
use std::cell::Cell;

/// An allocator that counts the allocations of each thread.
struct Counting;

thread_local! {
    static COUNT: Cell<u64> = const { Cell::new(0) };
}

// SAFETY: every call is passed to the system's allocator unchanged; the counter does not allocate.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        COUNT.set(COUNT.get() + 1);
        // SAFETY: the caller guarantees the requirements of `alloc`.
        unsafe { Heap.alloc(layout) }
    }

    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        // SAFETY: the block was allocated by `alloc` above with this layout.
        unsafe { Heap.dealloc(block, layout) }
    }
}

#[global_allocator]
static COUNTING: Counting = Counting;

#[test]
fn steps_that_are_brought_back_allocate_nothing() {
    for name in ["foreign/cartesian_pendulum", "foreign/andrews_mechanism", "models/rolling_disc"] {
        let problem = scene(name).problem(Axes::First);
        let run = |method: Method, share: f64| {
            let span = Span::new(0.0, share * problem.span, &problem.state);
            let (before, mut steps) = (COUNT.get(), 0);
            let tolerance = Tolerance::both(1e-6);
            steps += integrate(&*problem.law, method, &tolerance, &span, &mut ()).work.steps;
            (COUNT.get() - before, steps)
        };
        for method in [Method::Taylor, Method::DormandPrince8, Method::RadauIIA { stages: 3 }] {
            // the first run compiles programs and allocates buffers
            run(method, 0.1);
            let ((short, few), (long, many)) = (run(method, 0.5), run(method, 1.0));
            assert!(many > few, "{name}, {method}: {few}, {many}");
            assert_eq!(short, long, "{name}, {method}");
        }
    }
}
