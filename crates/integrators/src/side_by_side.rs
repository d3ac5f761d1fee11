//! The classical Runge-Kutta method with a constant step on many systems of one kind, one in each lane.

use crate::Ode;
use field::Lanes;
use pulp::{Arch, Simd, WithSimd};

/// Room for a law over lanes, always advanced with the widest registers that the processor has. What one lane holds never
/// depends on another.
///
/// `FUSED` numbers, which round a product and a sum once, are the fast ones where [`fuses`]; elsewhere the others are.
/// The law must be `#[inline(always)]` throughout, or it is compiled for narrow registers: six times slower.
#[derive(Clone, Debug)]
pub struct SideBySide<const L: usize, const FUSED: bool> {
    slope: Vec<Lanes<L, FUSED>>,
    stage: Vec<Lanes<L, FUSED>>,
    sum: Vec<Lanes<L, FUSED>>,
}

/// Whether this processor rounds a product and a sum once in one instruction.
pub fn fuses() -> bool {
    !matches!(Arch::new(), Arch::Scalar)
}

impl<const L: usize, const FUSED: bool> SideBySide<L, FUSED> {
    /// For so many states.
    pub fn new(dimension: usize) -> Self {
        let room = || vec![Lanes::all(0.0); dimension];
        SideBySide { slope: room(), stage: room(), sum: room() }
    }

    /// So many steps from the time `start`, in s if the law's time is; allocates nothing. States beyond the room are left.
    pub fn steps(
        &mut self,
        law: &impl Ode<Lanes<L, FUSED>>,
        start: f64,
        step: f64,
        steps: usize,
        state: &mut [Lanes<L, FUSED>],
    ) {
        Arch::new().dispatch(Steps { law, start, step, steps, state, room: self });
    }
}

struct Steps<'a, O, const L: usize, const FUSED: bool> {
    law: &'a O,
    start: f64,
    step: f64,
    steps: usize,
    state: &'a mut [Lanes<L, FUSED>],
    room: &'a mut SideBySide<L, FUSED>,
}

impl<O: Ode<Lanes<L, FUSED>>, const L: usize, const FUSED: bool> WithSimd for Steps<'_, O, L, FUSED> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let SideBySide { slope, stage, sum } = self.room;
        let (n, h) = (self.state.len().min(slope.len()), self.step);
        let state = &mut self.state[..n];
        // where the next slope is taken, and the share of this one
        let stages = [(h / 2.0, h / 6.0), (h / 2.0, h / 3.0), (h, h / 3.0), (0.0, h / 6.0)];
        for number in 0..self.steps {
            let begin = self.start + number as f64 * h;
            let mut time = begin;
            stage.copy_from_slice(state);
            sum.copy_from_slice(state);
            // one call of the law, so that it is compiled once
            for (reach, share) in stages {
                self.law.rates(Lanes::all(time), stage, slope);
                for (((stage, sum), state), slope) in stage.iter_mut().zip(&mut *sum).zip(&*state).zip(&*slope) {
                    *stage = plus(simd, state, reach, slope);
                    *sum = plus(simd, sum, share, slope);
                }
                time = begin + reach;
            }
            state.copy_from_slice(sum);
        }
    }
}

/// y + h k by whole registers: as loops over lanes this would be taken for a loop over states, and its numbers gathered
/// one by one.
#[inline(always)]
fn plus<S: Simd, const L: usize, const FUSED: bool>(
    simd: S,
    y: &Lanes<L, FUSED>,
    h: f64,
    k: &Lanes<L, FUSED>,
) -> Lanes<L, FUSED> {
    let mut sum = *y;
    let (wide, rest) = S::as_mut_simd_f64s(&mut sum.0);
    let (slopes, others) = S::as_simd_f64s(&k.0);
    for (sum, slope) in wide.iter_mut().zip(slopes) {
        let h = simd.splat_f64s(h);
        *sum = if FUSED { simd.mul_add_f64s(h, *slope, *sum) } else { simd.add_f64s(*sum, simd.mul_f64s(h, *slope)) };
    }
    for (sum, slope) in rest.iter_mut().zip(others) {
        *sum = if FUSED { h.mul_add(*slope, *sum) } else { *sum + h * slope };
    }
    sum
}
