//! With the widest instructions that the processor has, chosen when the program runs.

#[cfg(target_arch = "x86_64")]
use super::permuting::Permuting;
use super::pick::{OneByOne, Pick};
use super::small::{Never, Small, SmallSeries};
use field::{Analytic, DoubleDouble, Over};
use std::sync::OnceLock;

/// A field with a product added to a sum as fast as the processor can.
pub trait Fused: Analytic + Over<f64> {
    /// Whether it holds more digits than `f64`.
    const FINER: bool = false;

    /// How small right-hand sides are expanded.
    #[doc(hidden)]
    #[allow(private_bounds)]
    type Small: SmallSeries<Self>;

    /// self + a b, rounded once or twice.
    #[inline(always)]
    fn plus_product(self, a: Self, b: Self, _fused: bool) -> Self {
        self + a * b
    }

    /// Runs what works on groups of so many.
    #[doc(hidden)]
    #[allow(private_bounds)]
    #[inline]
    fn run<T: Task<Self>>(task: T, _group: usize) {
        task.run(OneByOne::<false>);
    }
}

/// Work that is compiled once for each set of instructions.
pub(crate) trait Task<S> {
    fn run<P: Pick<S>>(self, pick: P);
}

impl Fused for DoubleDouble {
    const FINER: bool = true;
    type Small = Never;
}

/// A number with its derivatives in D directions: the series of a solution and of how it depends on its beginning.
impl<const D: usize> Fused for num_dual::DualSVec64<D> {
    type Small = Never;
}

impl Fused for f64 {
    type Small = Small;

    #[inline(always)]
    fn plus_product(self, a: Self, b: Self, fused: bool) -> Self {
        if fused { a.mul_add(b, self) } else { self + a * b }
    }

    #[allow(private_bounds)]
    #[inline]
    fn run<T: Task<f64>>(task: T, group: usize) {
        match widest() {
            #[cfg(target_arch = "x86_64")]
            pulp::Arch::V4(widest) if group == 8 => {
                pulp::Simd::vectorize(widest, With(task, Permuting(widest)));
            }
            other => otherwise(other, task),
        }
    }
}

/// Apart: what this needs of the stack is not taken where the widest registers are.
#[inline(never)]
fn otherwise(arch: pulp::Arch, task: impl Task<f64>) {
    match arch {
        pulp::Arch::Scalar => task.run(OneByOne::<false>),
        wide => wide.dispatch(With(task, OneByOne::<true>)),
    }
}

/// What the processor has, asked once: to ask takes as long as a small task.
#[inline]
fn widest() -> pulp::Arch {
    static FOUND: OnceLock<pulp::Arch> = OnceLock::new();
    *FOUND.get_or_init(pulp::Arch::new)
}

struct With<T, P>(T, P);

impl<T: Task<f64>, P: Pick<f64>> pulp::WithSimd for With<T, P> {
    type Output = ();

    #[inline(always)]
    fn with_simd<I: pulp::Simd>(self, _: I) {
        self.0.run(self.1);
    }
}
