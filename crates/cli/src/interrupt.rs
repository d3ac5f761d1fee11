//! Ctrl-C: what runs is asked to end, and keeps what there is.

use signal_hook::consts::SIGINT;
use signal_hook::flag;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

/// Whether the user has asked for the end.
pub struct Interrupt(Arc<AtomicBool>);

impl Interrupt {
    /// From here on the first Ctrl-C asks; the second ends the program as ever.
    pub fn watched() -> Self {
        let asked = Arc::new(AtomicBool::new(false));
        // where signals cannot be watched the first ends it too
        let _ = flag::register_conditional_default(SIGINT, Arc::clone(&asked))
            .and_then(|_| flag::register(SIGINT, Arc::clone(&asked)));
        Interrupt(asked)
    }

    /// Whether it was asked for.
    pub fn is_asked(&self) -> bool {
        self.0.load(Relaxed)
    }

    /// Breaks off what asks this, once the end was asked for.
    pub fn goes_on(&self) -> ControlFlow<()> {
        if self.is_asked() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}
