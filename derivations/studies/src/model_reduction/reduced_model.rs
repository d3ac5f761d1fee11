//! A reduced model of a full one: the states that it retains, and the expressions that replace the others.
//!
//! Let y' = F(t, y) be the full law. A reduced model is a lift y = Y(t, z) and a law z' = f(t, z). Its defect is
//!
//!   d = dY/dt + Y_z f - F(t, Y)
//!
//! the residual of the full law along the lifted motion. If d vanishes identically, the reduction is exact. Most
//! reduced models need no law of their own: f consists of the full rates of the retained states at the lifted state.

use field::{Analytic, Over};
use integrators::Ode;
use simulation::{CompiledLaw, Law, SymbolicLaw};
use std::sync::Arc;
use symbolic::{Hypotheses, Sym, decide};

/// A symbolic function of time and state.
pub type Expressed = dyn Fn(Sym, &[Sym]) -> Vec<Sym> + Send + Sync;

/// A lift, with the law of the retained states.
#[derive(Clone)]
pub struct Lower {
    /// The number of retained states.
    pub dimension: usize,
    /// The lift Y(t, z).
    pub lift: Arc<Expressed>,
    /// The law f(t, z).
    pub rates: Arc<Expressed>,
    /// The indices of the retained states in the full state, if they are states of the full law.
    pub kept: Option<Vec<usize>>,
}

/// Expressions, over every scalar type, that replace the states which are not retained.
pub trait Fill: Send + Sync + 'static {
    /// Completes y, in which the retained states already have their values.
    fn fill<S: Over<f64> + Analytic>(&self, y: &mut [S]);
}

impl Lower {
    /// A reduction to the states with these indices under the full law; `fill` completes the full state.
    pub fn keeping(written: &Arc<dyn SymbolicLaw>, kept: Vec<usize>, fill: impl Fill) -> Self {
        let n = written.dimension();
        let places = kept.clone();
        let expressed = Arc::clone(written);
        let whole = move |z: &[Sym]| {
            let mut y = vec![Sym::ZERO; n];
            places.iter().zip(z).for_each(|(&place, &z)| y[place] = z);
            fill.fill(&mut y);
            y
        };
        let whole = Arc::new(whole);
        let (lift, followed) = (Arc::clone(&whole), kept.clone());
        let rates = move |time: Sym, z: &[Sym]| {
            let mut dy = vec![Sym::ZERO; n];
            expressed.rates(time, &whole(z), &mut dy);
            followed.iter().map(|&place| dy[place]).collect()
        };
        Lower {
            dimension: kept.len(),
            lift: Arc::new(move |_, z: &[Sym]| lift(z)),
            rates: Arc::new(rates),
            kept: Some(kept),
        }
    }

    /// A model with another law for all states.
    pub fn other(law: &Arc<dyn SymbolicLaw>) -> Self {
        let n = law.dimension();
        let expressed = Arc::clone(law);
        let rates = move |time: Sym, z: &[Sym]| {
            let mut dz = vec![Sym::ZERO; n];
            expressed.rates(time, z, &mut dz);
            dz
        };
        Lower {
            dimension: n,
            lift: Arc::new(|_, z: &[Sym]| z.to_vec()),
            rates: Arc::new(rates),
            kept: Some((0..n).collect()),
        }
    }

    /// The compiled law of the retained states; `None` where it cannot be recorded.
    pub fn law(&self) -> Option<Arc<dyn Law>> {
        Some(Arc::new(straight(self.dimension, Arc::clone(&self.rates))?))
    }

    /// The defect d, by component, as symbolic expressions of time and state.
    pub fn defect(&self, written: &dyn SymbolicLaw, time: Sym, z: &[Sym]) -> Vec<Sym> {
        let (y, f) = ((self.lift)(time, z), (self.rates)(time, z));
        let mut rates = vec![Sym::ZERO; y.len()];
        written.rates(time, &y, &mut rates);
        let along = |y: Sym| z.iter().zip(&f).fold(y.diff(time), |sum, (&z, &f)| sum + y.diff(z) * f);
        y.iter().zip(rates).map(|(&y, rate)| along(y) - rate).collect()
    }

    /// Whether the defect is proved to vanish identically, so that the reduction is exact.
    pub fn is_exact(&self, written: &dyn SymbolicLaw) -> bool {
        let (time, z) = (Sym::symbol("t"), symbols("z", self.dimension));
        let defect = self.defect(written, time, &z);
        defect.into_iter().all(|part| decide(part, &Hypotheses::none()).is_zero())
    }
}

/// Numbered symbols.
pub fn symbols(letter: &str, count: usize) -> Vec<Sym> {
    (0..count).map(|i| Sym::symbol(&format!("{letter}{i}"))).collect()
}

/// A law given by expressions.
struct Straight {
    dimension: usize,
    rates: Arc<Expressed>,
}

/// A compiled law from expressions; `None` where it cannot be recorded.
pub fn straight(dimension: usize, rates: Arc<Expressed>) -> Option<CompiledLaw> {
    let law = CompiledLaw::new(Straight { dimension, rates });
    law.program().is_some().then_some(law)
}

impl Ode<Sym> for Straight {
    fn dimension(&self) -> usize {
        self.dimension
    }

    fn rates(&self, t: Sym, y: &[Sym], dy: &mut [Sym]) {
        dy.copy_from_slice(&(self.rates)(t, y));
    }
}

/// A reduced model in numbers, to be compared with the motion of a full one.
pub struct Lifted<'a> {
    /// The lift Y(t, z).
    pub lift: &'a dyn Fn(f64, &[f64]) -> Vec<f64>,
    /// The law z' = f(t, z).
    pub law: &'a dyn Law,
    /// The indices of the retained states in the full state.
    pub kept: &'a [usize],
    pub start: &'a [f64],
}

impl Lifted<'_> {
    /// The distance y - Y(t, z).
    pub fn above(&self, time: f64, y: &[f64], z: &[f64]) -> Vec<f64> {
        y.iter().zip((self.lift)(time, z)).map(|(y, lifted)| y - lifted).collect()
    }

    /// The defect d, where z are the retained states of the full motion. The lift is differentiated by central
    /// differences over a short time `beside` along the reduced motion.
    pub fn defect(&self, richer: &dyn Law, (time, beside): (f64, f64), y: &[f64]) -> Vec<f64> {
        let z: Vec<f64> = self.kept.iter().map(|&place| y[place]).collect();
        let (mut f, mut rates) = (vec![0.0; z.len()], vec![0.0; y.len()]);
        self.law.rates(time, &z, &mut f);
        richer.rates(time, &(self.lift)(time, &z), &mut rates);
        let moved = |by: f64| (self.lift)(time + by, &z.iter().zip(&f).map(|(z, f)| z + by * f).collect::<Vec<_>>());
        let along =
            moved(beside).into_iter().zip(moved(-beside)).map(|(after, before)| (after - before) / (2.0 * beside));
        along.zip(rates).map(|(along, rate)| along - rate).collect()
    }
}
