//! A just-in-time compiler from straight-line programs to machine code of this processor.
//!
//! For laws that are known only at run time, such as the text of a scene; without this crate they are interpreted,
//! operation by operation. Each operation of the tape becomes one instruction, in the order of the tape. Operations are
//! neither regrouped nor fused, except as on the tape. The values are bitwise equal to those of
//! [`symbolic::Tape::evaluate`] in `f64`.
//!
//! This is the only crate with unsafe code. Four conditions make it sound: the code is complete before it becomes
//! executable; it lives as long as [`Code`]; its stack frame is bounded and probed page by page; and [`Code::run`]
//! checks every length on which the code relies.
//!
//! # Example
//! ```
//! use dalembert_native::Code;
//! use symbolic::{Sym, Tape};
//!
//! let (x, time) = (Sym::symbol("x"), Sym::symbol("t"));
//! let tape = Tape::record(&[x, time], &[x * x + time]).expect("a polynomial");
//! // no code where the processor is not supported: then the tape is evaluated
//! if let Some(code) = Code::of(&tape) {
//!     let mut values = [0.0];
//!     code.run(&[3.0], 1.0, &mut values).expect("one state, one value");
//!     assert_eq!(values, [10.0]);
//! }
//! ```

mod c_entry;
mod live;
mod pieces;
mod write;

use cranelift_codegen::isa::OwnedTargetIsa;
use cranelift_codegen::settings::{self, Configurable};
use memmap2::{Mmap, MmapMut};
use pieces::Pieces;
use std::cell::RefCell;
use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::OnceLock;
use symbolic::Tape;

/// The entry of a piece of a program: the state, the time, the outputs, the constants, and the numbers passed between
/// pieces.
type Entry = unsafe extern "C" fn(*const f64, f64, *mut f64, *const f64, *mut f64);

thread_local! {
    /// The buffer of numbers passed between the pieces of a long program, one for each thread, as large as its largest
    /// program needs.
    static ROOM: RefCell<Vec<f64>> = const { RefCell::new(Vec::new()) };
}

/// A tape over `f64` as machine code. Several threads may run it at once.
pub struct Code {
    entries: Box<[Entry]>,
    inputs: usize,
    outputs: usize,
    constants: Box<[f64]>,
    /// The number of values passed between pieces.
    room: usize,
    /// The entry points of the pieces, valid as long as `pages`.
    pages: Mmap,
}

impl Code {
    /// The code of a tape whose last input is the time. A long tape is split into several functions.
    ///
    /// `None` where the tape has no input, the processor or system is not supported, the tape has fused operations and
    /// the processor has none, the tape is longer than [`MOST_STEPS`], or no executable pages are available: the tape
    /// must then be interpreted.
    pub fn of(tape: &Tape) -> Option<Self> {
        let (isa, inputs) = (processor()?, tape.inputs().checked_sub(1)?);
        if tape.steps().len() > MOST_STEPS {
            return None;
        }
        let pieces = Pieces::of(tape, MOST_STACK as usize / WAITING);
        let (mut instructions, mut begins) = (Vec::new(), Vec::new());
        for piece in 0..pieces.ranges.len() {
            let written = write::instructions(tape, &pieces, piece, isa)?;
            if written.frame > MOST_STACK {
                return None;
            }
            instructions.resize(instructions.len().next_multiple_of(ALIGNED), 0);
            begins.push(instructions.len());
            instructions.extend(written.instructions);
        }
        let pages = executable(&instructions)?;
        let entry = |begin: usize| {
            let first: *const u8 = &pages[begin];
            // SAFETY: the first instruction of one complete function is at `begin`. Cranelift generated it for this
            // processor, in the calling convention of `extern "C"` on this system, with the five parameters of `Entry`
            // and no result. The pages are executable, no longer writable, and known to the instruction cache. Outside
            // its own code the function refers only to `write::circle` and similar functions, which live as long as the
            // program. `Code` owns the pages, and does not give the entries to other objects.
            unsafe { std::mem::transmute::<*const u8, Entry>(first) }
        };
        let entries = begins.into_iter().map(entry).collect();
        let constants = tape.rounded().into();
        Some(Code { entries, inputs, outputs: tape.outputs(), constants, room: pieces.room, pages })
    }

    /// The size of the instructions and constants in bytes.
    pub fn size(&self) -> usize {
        self.pages.len() + size_of_val(&*self.constants)
    }

    /// Computes the values at a state and a time. `None`, without writing, where the lengths differ from those of the
    /// tape.
    #[inline]
    pub fn run(&self, state: &[f64], time: f64, values: &mut [f64]) -> Option<()> {
        if state.len() != self.inputs || values.len() < self.outputs {
            return None;
        }
        match *self.entries {
            [whole] => {
                let none = std::ptr::dangling_mut();
                // SAFETY: as in `run_pieces`; a single piece passes no numbers on, so that it does not use the last
                // pointer.
                unsafe { whole(state.as_ptr(), time, values.as_mut_ptr(), self.constants.as_ptr(), none) };
            }
            _ => self.run_pieces(state, time, values),
        }
        Some(())
    }

    #[inline(never)]
    fn run_pieces(&self, state: &[f64], time: f64, values: &mut [f64]) {
        ROOM.with_borrow_mut(|room| {
            if room.len() < self.room {
                room.resize(self.room, 0.0);
            }
            for piece in &self.entries {
                // SAFETY: the code reads `inputs` numbers at the first pointer and the tape's constants at the fourth,
                // and writes `outputs` numbers at the third. `run` has checked the lengths of `state` and `values`;
                // `constants` contains the numbers that `tape.rounded()` returned when the code was generated. At the
                // last pointer the code writes and reads at indices below `room`, the length of the buffer, and reads
                // only numbers that an earlier piece of this run has written. All pointers are aligned like slices of
                // `f64`. The memory that is written overlaps no other, since `values` and `room` are borrowed mutably.
                // The code does not retain the pointers and has no state of its own. It touches its stack frame of at
                // most `MOST_STACK` bytes page by page: if the stack is too short, the access hits its guard page.
                unsafe {
                    piece(state.as_ptr(), time, values.as_mut_ptr(), self.constants.as_ptr(), room.as_mut_ptr());
                }
            }
        });
    }
}

impl fmt::Debug for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [inputs, outputs, pieces] = [self.inputs + 1, self.outputs, self.entries.len()];
        write!(f, "Code of {inputs} inputs, {outputs} outputs, {pieces} pieces, {} bytes", self.pages.len())
    }
}

/// A function of the time and a state that writes values.
type Law = dyn Fn(f64, &[f64], &mut [f64]) + Send + Sync;

/// A function with the lengths of its state and values.
struct Called {
    inputs: usize,
    outputs: usize,
    law: Box<Law>,
}

/// A function with an address that C can call: `void f(double time, const double *state, double *values)`.
///
/// The address is valid as long as this object lives, and may be called from several threads. If the function panics,
/// all values are NaN.
pub struct CFunction {
    pages: Mmap,
    /// Owns the context whose address is in the machine code.
    _called: Box<Called>,
}

impl CFunction {
    /// Creates an address for a function of `inputs` numbers that writes `outputs` values.
    ///
    /// `None` where the processor or system is not supported, or no executable pages are available.
    pub fn of(
        [inputs, outputs]: [usize; 2],
        law: impl Fn(f64, &[f64], &mut [f64]) + Send + Sync + 'static,
    ) -> Option<Self> {
        let called = Box::new(Called { inputs, outputs, law: Box::new(law) });
        let context: *const Called = &raw const *called;
        let target: extern "C" fn(*const Called, f64, *const f64, *mut f64) = call;
        let instructions = c_entry::instructions(context.addr(), target as usize, processor()?)?;
        Some(CFunction { pages: executable(&instructions)?, _called: called })
    }

    /// The address. The caller must pass `inputs` readable numbers, and space for `outputs` values.
    pub fn address(&self) -> usize {
        self.pages.as_ptr().addr()
    }
}

impl fmt::Debug for CFunction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "CFunction at {:#x}", self.address())
    }
}

/// Calls a Rust function on behalf of C.
extern "C" fn call(called: *const Called, time: f64, state: *const f64, values: *mut f64) {
    // SAFETY: only the code of a `CFunction` contains this address, and it passes the context that lives as long as its
    // pages.
    let Called { inputs, outputs, law } = unsafe { &*called };
    let is_shared =
        state < values.cast_const().wrapping_add(*outputs) && values.cast_const() < state.wrapping_add(*inputs);
    // SAFETY: the caller guarantees `inputs` readable numbers, aligned as required in C, and space for `outputs`
    // values. If the two share memory, the state is copied, and the slice of the caller's memory is dropped before the
    // values are borrowed.
    let copied = is_shared.then(|| unsafe { std::slice::from_raw_parts(state, *inputs) }.to_vec());
    let values = unsafe { std::slice::from_raw_parts_mut(values, *outputs) };
    let state = copied.as_deref().unwrap_or_else(|| unsafe { std::slice::from_raw_parts(state, *inputs) });
    // a panic must not unwind into C
    if catch_unwind(AssertUnwindSafe(|| law(time, state, values))).is_err() {
        values.fill(f64::NAN);
    }
}

/// Executable, read-only pages with these instructions.
fn executable(instructions: &[u8]) -> Option<Mmap> {
    let mut pages = MmapMut::map_anon(instructions.len()).ok()?;
    pages.copy_from_slice(instructions);
    let pages = pages.make_exec().ok()?;
    fetch_anew(&pages)?;
    Some(pages)
}

/// Whether `extern "C"` returns two numbers in two registers on this platform, as the code expects of
/// [`write::circle`].
const KNOWN: bool = cfg!(all(unix, any(target_arch = "x86_64", target_arch = "aarch64")));

/// The largest number of operations compiled to machine code: code generation takes some microseconds per operation,
/// interpretation a hundredth of that.
pub const MOST_STEPS: usize = 1 << 20;

/// The alignment of functions in bytes.
const ALIGNED: usize = 32;

/// The largest stack frame in bytes; a thread has two megabytes by default.
pub const MOST_STACK: u32 = 1 << 15;

/// The stack space in bytes of a spilled number: the code generator stores a whole SIMD register.
const WAITING: usize = 16;

/// Flushes the instruction caches of all cores for these pages; x86-64 does this by itself.
fn fetch_anew(pages: &Mmap) -> Option<()> {
    // SAFETY: the range is that of one mapping, which exists and is readable.
    unsafe { wasmtime_internal_jit_icache_coherence::clear_cache(pages.as_ptr().cast(), pages.len()) }.ok()?;
    wasmtime_internal_jit_icache_coherence::pipeline_flush_mt().ok()
}

/// The instruction set of this processor, if the code generator supports it.
fn processor() -> Option<&'static OwnedTargetIsa> {
    static PROCESSOR: OnceLock<Option<OwnedTargetIsa>> = OnceLock::new();
    let found = PROCESSOR.get_or_init(|| {
        if !KNOWN {
            return None;
        }
        let mut flags = settings::builder();
        // merges repeated loads; sums and products are unchanged
        flags.set("opt_level", "speed").ok()?;
        // the code itself touches its stack frame page by page, so that it cannot skip a guard page
        flags.set("enable_probestack", "true").ok()?;
        flags.set("probestack_strategy", "inline").ok()?;
        flags.set("enable_verifier", "false").ok()?;
        cranelift_native::builder().ok()?.finish(settings::Flags::new(flags)).ok()
    });
    found.as_ref()
}

#[cfg(test)]
mod tests {
    use super::*;
    use field::{Analytic, Scalar};
    use symbolic::Sym;

    /// A tape with `numbers` values in use at once: each is needed by a first product, and by a second one at the end.
    fn crowded(numbers: i64) -> Tape {
        let [x, t] = ["x", "t"].map(Sym::symbol);
        let roots: Vec<Sym> = (1..=numbers).map(|k| (x * x + Sym::ONE + Sym::ratio(1, k)).sqrt()).collect();
        let product = |by: Sym| roots.iter().fold(Sym::ONE, |product, root| product * (*root + by));
        Tape::record(&[x, t], &[product(x), product(t)]).expect("it has values")
    }

    #[test]
    #[cfg(target_arch = "x86_64")]
    fn a_frame_of_several_pages_is_touched_page_by_page_before_it_is_used() {
        let Some(isa) = processor() else { return };
        let written = |numbers: i64| {
            let tape = crowded(numbers);
            let pieces = Pieces::cut(&tape, tape.steps().len());
            write::instructions(&tape, &pieces, 0, isa).expect("it can be written")
        };
        let large = written(1300);
        assert!((8192..=MOST_STACK).contains(&large.frame), "{} bytes", large.frame);
        // mov dword ptr [rsp], 0: in the prologue, once for each page or in a loop
        let touch = [0xC7, 0x04, 0x24, 0, 0, 0, 0];
        let prologue = &large.instructions[..256];
        assert!(prologue.windows(touch.len()).any(|bytes| bytes == touch), "{prologue:02X?}");
        let small = written(3);
        assert!(small.frame < 4096 && !small.instructions.windows(touch.len()).any(|bytes| bytes == touch));
    }

    #[test]
    fn a_tape_that_is_long_or_has_many_numbers_in_use_has_its_values_in_pieces() {
        let mut pieces_of = Vec::new();
        for numbers in [5, i64::from(MOST_STACK) / 16 + 100, 20_000] {
            let tape = crowded(numbers);
            let Some(code) = Code::of(&tape) else { return };
            pieces_of.push(code.entries.len());
            let [mut own, mut all] = [[0.0; 2]; 2];
            tape.over::<f64>().evaluate(&[1e-3, 1e-4], &mut all);
            code.run(&[1e-3], 1e-4, &mut own);
            assert_eq!(own.map(f64::to_bits), all.map(f64::to_bits), "{code:?}");
            // the buffer belongs to the thread: a run of another length has its own values
            code.run(&[2e-3], 1e-4, &mut own);
            assert_ne!(own.map(f64::to_bits), all.map(f64::to_bits), "{code:?}");
        }
        assert!(pieces_of[0] == 1 && pieces_of[1] > 1 && pieces_of[2] > 100, "{pieces_of:?}");
    }

    #[test]
    fn a_function_with_an_address_is_called_as_c_calls_it() {
        let law = |time: f64, state: &[f64], values: &mut [f64]| {
            assert!(time >= 0.0, "a law that panics");
            values[0] = time * state[1];
            values[1] = state[0] - state[1];
        };
        let Some(function) = CFunction::of([2, 2], law) else { return };
        // SAFETY: a function with this signature is at the address.
        let entry: extern "C" fn(f64, *const f64, *mut f64) = unsafe { std::mem::transmute(function.address()) };
        let (state, mut values) = ([3.0, 5.0], [0.0; 2]);
        entry(2.0, state.as_ptr(), values.as_mut_ptr());
        assert_eq!(values, [10.0, -2.0]);
        let mut shared = state;
        entry(2.0, shared.as_ptr(), shared.as_mut_ptr());
        assert_eq!(shared, values);
        entry(-1.0, state.as_ptr(), values.as_mut_ptr());
        assert!(values.iter().all(|value| value.is_nan()));
    }

    #[test]
    fn numbers_in_use_are_counted_from_their_first_reader_to_the_last() {
        let [x, t] = ["x", "t"].map(Sym::symbol);
        let chain = (0..9).fold(x, |y, k| (y * y + Sym::int(k)).sqrt());
        let tape = Tape::record(&[x, t], &[chain]).expect("it has values");
        assert_eq!(live::most_live(&tape), 1);
        let points = Tape::record(&[x, t], &[x.circle().cos, x.circle().sin, t.circle().sin]).expect("it has values");
        assert_eq!(live::most_live(&points), 3);
        assert!((100..110).contains(&live::most_live(&crowded(100))));
        assert_eq!(live::most_live(&Tape::record(&[x, t], &[x, Sym::ONE]).expect("it has values")), 0);
    }

    #[test]
    fn code_with_a_large_frame_has_the_values_of_its_tape() {
        let tape = crowded(300);
        let Some(code) = Code::of(&tape) else { return };
        let (mut own, mut all) = ([0.0; 2], [0.0; 2]);
        tape.over::<f64>().evaluate(&[1e-3, 0.5], &mut all);
        // on a stack only slightly larger than the frame
        let run = std::thread::Builder::new().stack_size(1 << 18);
        own = run
            .spawn(move || code.run(&[1e-3], 0.5, &mut own).map(|()| own))
            .expect("a thread begins")
            .join()
            .expect("it ends")
            .expect("it runs");
        assert_eq!(own.map(f64::to_bits), all.map(f64::to_bits));
    }
}
