//! A mechanism without its type: in the list by its name, read from the tables of a file, asked by its scene.

use super::reductions::of_mechanism;
use super::rewritten::{Rewritten, ready};
use super::{Balanced, Diagnosis, Ended, Mechanism};
use crate::ladder::Ladder;
use integrators::Method;
use reader::{At, Issue, Quantity, Table};
use simulation::problem::{Invariant, Problem};
use simulation::work_precision::{Standing, Way};
use std::convert::Infallible;
use std::fmt::Debug;
use std::ops::Range;
use std::sync::Arc;

/// A mechanism in the list.
pub struct Entry {
    pub(super) name: &'static str,
    pub(super) summary: &'static str,
    pub(super) read: fn(&mut Table<'_>, &mut Vec<Issue>) -> Option<Read>,
}

/// What a file says of a mechanism and its start.
pub(super) struct Read {
    pub data: Vec<(&'static Quantity, f64)>,
    pub start: Vec<f64>,
    pub mechanism: Arc<dyn Erased>,
}

/// The entry of a mechanism.
pub const fn entry<M: Mechanism>() -> Entry {
    Entry { name: M::NAME, summary: M::SUMMARY, read: read::<M> }
}

/// A mechanism, its type forgotten once its data are known.
pub(super) trait Erased: Debug + Send + Sync {
    fn problem(&self, start: &[f64], span: f64) -> Problem;
    fn ways(&self, start: &[f64], span: f64) -> Vec<Way>;
    fn ladder(&self, start: &[f64], span: f64) -> Ladder;
    fn states(&self) -> &'static [Quantity];
    fn columns(&self) -> Vec<&'static Quantity>;
    fn diagnosis(&self, run: &Ended<'_>) -> Option<Diagnosis>;
    fn exact(&self, start: &[f64], time: f64) -> Option<(&'static str, Vec<f64>)>;
    fn theory(&self, start: &[f64], method: Method, span: f64) -> Vec<String>;
}

/// The last state: what has been done on the mechanism.
static WORK: Quantity = Quantity::any("work", "J", "work done on the mechanism");

impl<M: Mechanism> Erased for M {
    fn problem(&self, start: &[f64], span: f64) -> Problem {
        let count = M::STATE.len();
        let mut state = self.state(start);
        state.push(0.0);
        let law = ready(Balanced(self.clone()));
        let (energetic, showing, judging) = (self.clone(), self.clone(), self.clone());
        let start = start.to_vec();
        let balance = move |time: f64, y: &[f64]| energetic.energy(time, &y[..count]) - y[count];
        Problem {
            law,
            state,
            span,
            invariants: vec![Invariant { name: "energy_less_work", value: Box::new(balance) }],
            columns: self.columns().iter().map(|quantity| quantity.name.to_string()).collect(),
            row: Box::new(move |time, y| [y, &showing.shown(time, &y[..count])].concat()),
            margins: Box::new(move |_, y, dy| judging.margins(&start, &y[..count], &dy[..count])),
            switching: None,
        }
    }

    fn ways(&self, start: &[f64], span: f64) -> Vec<Way> {
        let own = Way::of(M::FORMULATION, "", Standing::Own, self.problem(start, span));
        let columns: Vec<String> = M::STATE.iter().map(|quantity| quantity.name.to_string()).collect();
        let other = |Rewritten { formulation, law, state, whole }| Way {
            formulation,
            model: "",
            standing: Standing::Exact,
            law,
            state,
            sizes: Vec::new(),
            columns: columns.clone(),
            row: Box::new(move |_, y| whole(y)),
        };
        std::iter::once(own).chain(self.rewritten(start).into_iter().map(other)).collect()
    }

    fn ladder(&self, start: &[f64], span: f64) -> Ladder {
        of_mechanism(self, start, self.problem(start, span))
    }

    fn states(&self) -> &'static [Quantity] {
        M::STATE
    }

    fn columns(&self) -> Vec<&'static Quantity> {
        M::STATE.iter().chain([&WORK]).chain(M::SHOWN).collect()
    }

    fn diagnosis(&self, run: &Ended<'_>) -> Option<Diagnosis> {
        Mechanism::diagnosis(self, run)
    }

    fn exact(&self, start: &[f64], time: f64) -> Option<(&'static str, Vec<f64>)> {
        Mechanism::exact(self, start, time)
    }

    fn theory(&self, start: &[f64], method: Method, span: f64) -> Vec<String> {
        Mechanism::theory(self, start, method, span)
    }
}

/// The tables `[data]` and `[start]`.
fn read<M: Mechanism>(top: &mut Table<'_>, issues: &mut Vec<Issue>) -> Option<Read> {
    let mut places: Vec<(&'static str, f64, Range<usize>)> = Vec::new();
    let mut table = top.table("data", "the mechanism's data, each with its unit");
    let mut data = Vec::new();
    let Ok(mechanism) = M::read::<Infallible>(&mut |quantity| {
        let value = number(&mut table, quantity, &mut places);
        data.push((quantity, value));
        Ok(value)
    });
    let mut sound = table.exists() && !table.has_issues();
    issues.extend(table.finish());
    let mut table = top.table("start", "the initial state");
    let start: Vec<f64> = M::START.iter().map(|quantity| number(&mut table, quantity, &mut places)).collect();
    sound &= table.exists() && !table.has_issues();
    issues.extend(table.finish());
    // data that are already known to be wrong have been replaced, and say nothing about the mechanism
    if !sound {
        return None;
    }
    for amiss in mechanism.amiss(&start) {
        let found = places.iter().find(|(name, ..)| *name == amiss.name);
        let (label, span) =
            found.map_or_else(Default::default, |(_, value, span)| (format!("it is {value}"), span.clone()));
        issues.push(Issue::at(span, amiss.what, label).accepted(amiss.accepted));
        sound = false;
    }
    sound.then(|| Read { data, start, mechanism: Arc::new(mechanism) })
}

/// A quantity, judged by its own bound.
fn number(
    table: &mut Table<'_>,
    quantity: &'static Quantity,
    places: &mut Vec<(&'static str, f64, Range<usize>)>,
) -> f64 {
    let At { value, span } = table.datum(quantity);
    places.push((&quantity.name, value, span));
    value
}
