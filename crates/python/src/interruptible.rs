//! Work that Ctrl-C breaks off: it has a thread of its own, while the thread of Python looks for signals.

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use std::cell::RefCell;
use std::sync::Mutex;
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::thread;
use std::time::Duration;

/// The time between two looks for signals.
const LOOK: Duration = Duration::from_millis(50);

/// The stack of the work, in bytes: that of a main thread, since expressions are deep.
const STACK: usize = 8 << 20;

/// A message of the work to the thread that waits for it.
enum Told<R> {
    Warning(String),
    Result(R),
}

/// Hands a warning to the thread that waits.
type Hand = Box<dyn Fn(&str)>;

thread_local! {
    /// Set in the thread of some work.
    static HAND: RefCell<Option<Hand>> = const { RefCell::new(None) };
}

/// Hands a warning to the thread that waits for this one: Python says the place of a warning by its caller, which only that thread has. False
/// where no thread waits.
pub fn handed(warning: &str) -> bool {
    HAND.with_borrow(|hand| hand.as_ref().map(|hand| hand(warning)).is_some())
}

/// The result of some work without Python. Ctrl-C raises KeyboardInterrupt within a twentieth of a second; the thread of the work, which nothing
/// can end, goes on until its result is there, and drops it.
pub fn interruptible<R: Send + 'static>(py: Python<'_>, work: impl FnOnce() -> R + Send + 'static) -> PyResult<R> {
    let (tell, hear) = channel();
    let worker = thread::Builder::new().stack_size(STACK).spawn(move || {
        let warnings: Sender<Told<R>> = tell.clone();
        HAND.set(Some(Box::new(move |text| drop(warnings.send(Told::Warning(text.to_owned()))))));
        // after Ctrl-C nobody hears
        drop(tell.send(Told::Result(work())));
    })?;
    let hear = Mutex::new(hear);
    let next = || match hear.lock() {
        Ok(hear) => hear.recv_timeout(LOOK),
        Err(_) => Err(RecvTimeoutError::Disconnected),
    };
    loop {
        match py.detach(next) {
            Ok(Told::Result(found)) => return Ok(found),
            Ok(Told::Warning(text)) => crate::warn(&text),
            Err(RecvTimeoutError::Timeout) => py.check_signals()?,
            Err(RecvTimeoutError::Disconnected) => {
                if let Err(panic) = worker.join() {
                    std::panic::resume_unwind(panic);
                }
                return Err(PyRuntimeError::new_err("a computation ended without a result"));
            }
        }
    }
}
