//! Straight-line programs as machine code of this processor, made while the program runs.
//!
//! A law that is known only at run time (text of a scene, a mechanism of masses and a chart) would otherwise be followed
//! operation by operation through a table. Here each of its operations is one instruction: in the order of the tape, none
//! regrouped and none fused that is not so on the tape, so that the values have the very bits of [`symbolic::Tape::evaluate`] in
//! `f64`.

mod write;

use cranelift_codegen::isa::OwnedTargetIsa;
use cranelift_codegen::settings::{self, Configurable};
use memmap2::{Mmap, MmapMut};
use std::fmt;
use std::sync::OnceLock;
use symbolic::Tape;

/// A program of numbers: all inputs but the last, the last, room for the outputs, the constants.
type Entry = unsafe extern "C" fn(*const f64, f64, *mut f64, *const f64);

/// A tape over `f64` as machine code. It may be run by many threads at a time.
pub struct Code {
    entry: Entry,
    inputs: usize,
    outputs: usize,
    constants: Box<[f64]>,
    /// Where the code stands, as long as this lives.
    pages: Mmap,
}

impl Code {
    /// The code of a tape whose last input is the time.
    ///
    /// None where it has no input, where this processor or system is not known, where the tape has fused operations and the
    /// processor none, or where the system gives no pages to run: then the tape itself is followed.
    pub fn of(tape: &Tape) -> Option<Self> {
        let (isa, inputs) = (processor()?, tape.inputs().checked_sub(1)?);
        let instructions = write::instructions(tape, isa)?;
        let mut pages = MmapMut::map_anon(instructions.len()).ok()?;
        pages.copy_from_slice(&instructions);
        let pages = pages.make_exec().ok()?;
        // SAFETY: the pages hold a whole function of this signature in the calling convention of `extern "C"`, which
        // refers to nothing but them and `write::circle`.
        let entry = unsafe { std::mem::transmute::<*const u8, Entry>(pages.as_ptr()) };
        Some(Code { entry, inputs, outputs: tape.outputs(), constants: tape.rounded().into(), pages })
    }

    /// The values at a state and a time; none, and nothing written, where their numbers are not those of the tape.
    #[inline]
    pub fn run(&self, state: &[f64], time: f64, values: &mut [f64]) -> Option<()> {
        if state.len() != self.inputs || values.len() < self.outputs {
            return None;
        }
        // SAFETY: the code reads the `inputs` first numbers and all constants, and writes the `outputs` first, which are there.
        unsafe { (self.entry)(state.as_ptr(), time, values.as_mut_ptr(), self.constants.as_ptr()) };
        Some(())
    }
}

impl fmt::Debug for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Code of {} inputs, {} outputs, {} bytes", self.inputs + 1, self.outputs, self.pages.len())
    }
}

/// Where `extern "C"` gives two numbers back in two registers, as the code expects of [`write::circle`].
const KNOWN: bool = cfg!(all(unix, any(target_arch = "x86_64", target_arch = "aarch64")));

/// What this processor can, where the code generator knows it.
fn processor() -> Option<&'static OwnedTargetIsa> {
    static PROCESSOR: OnceLock<Option<OwnedTargetIsa>> = OnceLock::new();
    let found = PROCESSOR.get_or_init(|| {
        if !KNOWN {
            return None;
        }
        let mut flags = settings::builder();
        // what is read twice is read once; of sums and products nothing changes
        flags.set("opt_level", "speed").ok()?;
        // a long program's room on the stack is touched page by page, by the code itself
        flags.set("probestack_strategy", "inline").ok()?;
        flags.set("enable_verifier", "false").ok()?;
        cranelift_native::builder().ok()?.finish(settings::Flags::new(flags)).ok()
    });
    found.as_ref()
}
