//! All reactions that a regime admits.
//!
//! The reactions form a polyhedron, given by equations and nonnegative forms. It lies in the friction cones, so that
//! its vertices are found by making conditions tight until the equations have one solution. A regular regime has one
//! candidate. A singular one may admit no motion, one motion with many reactions (a statically indeterminate body), or
//! a continuum of motions.

use super::conditions::Conditions;
use super::dry::Pairs;
use super::{Dry, Form, Mode, Ordered, Touch, conditions, equations};
use std::cmp::Ordering;

/// The reactions with which a regime satisfies the laws of contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reactions<S, const K: usize> {
    /// The regime is inconsistent.
    None,
    /// One motion is consistent.
    One {
        /// Reactions of this motion; the only ones if `determined`.
        reactions: Pairs<S, K>,
        /// Whether the motion determines its reactions.
        determined: bool,
    },
    /// Infinitely many motions are consistent; the reactions are those of one.
    Continuum(Pairs<S, K>),
}

/// The reactions with which a regime satisfies the laws of contact.
pub fn reactions<S: Ordered, const K: usize>(
    dry: &Dry<S, K>,
    touches: &[Touch; K],
    regime: &[Mode; K],
) -> Reactions<S, K> {
    let equations = equations(dry, regime);
    let mut rows = Echelon::new();
    if equations.as_flattened().iter().any(|equation| rows.insert(equation) == Inserted::Contradicts) {
        return Reactions::None;
    }
    let conditions = conditions(dry, touches, regime);
    let mut span = Span { dry, first: None, reactions: Spread::One, motions: Spread::One };
    vertices(&rows, &conditions, 0, &mut |vertex| span.vertex(vertex));
    let Some(reactions) = span.first else { return Reactions::None };
    if !rows.is_full() {
        rays(dry, regime, &conditions, &mut |ray| span.ray(ray));
    }
    match span.motions {
        Spread::Many => Reactions::Continuum(reactions),
        Spread::One => Reactions::One { reactions, determined: span.reactions == Spread::One },
    }
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Spread {
    One,
    Many,
}

/// The vertices and rays of the polyhedron found so far, to decide whether reactions and motions are unique.
struct Span<'a, S, const K: usize> {
    dry: &'a Dry<S, K>,
    first: Option<Pairs<S, K>>,
    reactions: Spread,
    motions: Spread,
}

impl<S: Ordered, const K: usize> Span<'_, S, K> {
    fn vertex(&mut self, vertex: &Pairs<S, K>) {
        let Some(first) = self.first else {
            self.first = Some(*vertex);
            return;
        };
        let difference = std::array::from_fn(|k| std::array::from_fn(|i| vertex[k][i] - first[k][i]));
        let size = size(vertex) + size(&first);
        if difference.as_flattened().iter().any(|d: &S| d.sign_among(size) != Ordering::Equal) {
            self.reactions = Spread::Many;
            self.moves(&difference, size);
        }
    }

    fn ray(&mut self, ray: &Pairs<S, K>) {
        self.reactions = Spread::Many;
        self.moves(ray, size(ray));
    }

    /// Records a difference of reactions. W kappa is zero if and only if kappa does not change the motion, since W is
    /// semidefinite.
    fn moves(&mut self, change: &Pairs<S, K>, among: S) {
        for row in self.dry.response.as_flattened() {
            let effect = Form { constant: S::zero(), row: *row }.at(change);
            if effect.sign_among(size(row) * among) != Ordering::Equal {
                self.motions = Spread::Many;
            }
        }
    }
}

fn size<S: Ordered, const K: usize>(pairs: &Pairs<S, K>) -> S {
    pairs.as_flattened().iter().fold(S::zero(), |sum, x| sum + x.size())
}

/// The sign of a form for given reactions; zero within rounding.
pub(super) fn sign_at<S: Ordered, const K: usize>(form: &Form<S, K>, reactions: &Pairs<S, K>) -> Ordering {
    let terms = form.row.as_flattened().iter().zip(reactions.as_flattened());
    // a reaction much smaller than the others has their rounding errors
    let all = size(reactions) * form.row.as_flattened().iter().fold(S::zero(), |most, a| most + a.size());
    let scale = terms.fold(form.constant.size() + all, |sum, (a, x)| sum + (*a * *x).size());
    form.at(reactions).sign_among(scale)
}

/// Visits the vertices: at each, enough of the conditions from `next` on are tight for a unique solution.
fn vertices<S: Ordered, const K: usize>(
    rows: &Echelon<S, K>,
    conditions: &Conditions<S, K>,
    next: usize,
    visit: &mut dyn FnMut(&Pairs<S, K>),
) {
    if rows.is_full() {
        let vertex = rows.solution();
        let mut all = conditions.as_flattened().iter().flatten();
        if all.all(|(_, form)| sign_at(form, &vertex) != Ordering::Less) {
            visit(&vertex);
        }
        return;
    }
    for (place, condition) in conditions.as_flattened().iter().enumerate().skip(next) {
        let mut more = *rows;
        if let Some((_, form)) = condition
            && more.insert(form) == Inserted::Adds
        {
            vertices(&more, conditions, place + 1, visit);
        }
    }
}

/// Visits the rays, normalised to a sum 1 of the normal reactions.
fn rays<S: Ordered, const K: usize>(
    dry: &Dry<S, K>,
    regime: &[Mode; K],
    conditions: &Conditions<S, K>,
    visit: &mut dyn FnMut(&Pairs<S, K>),
) {
    let mut rows = Echelon::new();
    for equation in equations(dry, regime).as_flattened() {
        rows.insert(&equation.homogeneous());
    }
    let mut total = Form { constant: -S::one(), row: [[S::zero(); 2]; K] };
    for (pair, mode) in total.row.iter_mut().zip(regime) {
        if let Mode::Stick(face) | Mode::Slip(_, face) = mode {
            pair[0] = face.sign();
        }
    }
    if rows.insert(&total) == Inserted::Adds {
        let directions =
            conditions.map(|of_contact| of_contact.map(|c| c.map(|(name, form)| (name, form.homogeneous()))));
        vertices(&rows, &directions, 0, visit);
    }
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Inserted {
    Adds,
    Follows,
    Contradicts,
}

/// Linear equations in reduced row echelon form: each row has 1 at its pivot, where all other rows have 0.
#[derive(Clone, Copy)]
struct Echelon<S, const K: usize> {
    rows: [[Option<Form<S, K>>; 2]; K],
}

impl<S: Ordered, const K: usize> Echelon<S, K> {
    fn new() -> Self {
        Echelon { rows: [[None; 2]; K] }
    }

    fn is_full(&self) -> bool {
        self.rows.as_flattened().iter().all(Option::is_some)
    }

    /// The solution of a full set of equations.
    fn solution(&self) -> Pairs<S, K> {
        self.rows.map(|pair| pair.map(|row| row.map_or(S::zero(), |row| -row.constant)))
    }

    /// Adds the equation form = 0, with its largest entry as pivot.
    fn insert(&mut self, form: &Form<S, K>) -> Inserted {
        let (mut new, mut among) = (*form, form.constant.size());
        let mut width = size(&form.row);
        for (k, i) in places::<K>() {
            let factor = new.row[k][i];
            if let Some(row) = &self.rows[k][i].filter(|_| !factor.is_zero()) {
                subtract(&mut new, row, factor);
                new.row[k][i] = S::zero();
                among += (factor * row.constant).size();
                width += (factor * size(&row.row)).size();
            }
        }
        let mut pivot: Option<(usize, usize)> = None;
        for (k, i) in places::<K>().filter(|&(k, i)| new.row[k][i].sign_among(width) != Ordering::Equal) {
            let larger = |(a, b): (usize, usize)| {
                (new.row[k][i].size() - new.row[a][b].size()).sign_among(S::zero()) == Ordering::Greater
            };
            if pivot.is_none_or(larger) {
                pivot = Some((k, i));
            }
        }
        let Some((k, i)) = pivot else {
            let holds = new.constant.sign_among(among) == Ordering::Equal;
            return if holds { Inserted::Follows } else { Inserted::Contradicts };
        };
        let scale = new.row[k][i];
        new = Form { constant: new.constant / scale, row: new.row.map(|pair| pair.map(|entry| entry / scale)) };
        for row in self.rows.as_flattened_mut().iter_mut().flatten() {
            let factor = row.row[k][i];
            subtract(row, &new, factor);
            row.row[k][i] = S::zero();
        }
        self.rows[k][i] = Some(new);
        Inserted::Adds
    }
}

fn subtract<S: Ordered, const K: usize>(from: &mut Form<S, K>, row: &Form<S, K>, factor: S) {
    from.constant -= factor * row.constant;
    for (entry, other) in from.row.as_flattened_mut().iter_mut().zip(row.row.as_flattened()) {
        *entry -= factor * *other;
    }
}

fn places<const K: usize>() -> impl Iterator<Item = (usize, usize)> {
    (0..K).flat_map(|k| [(k, 0), (k, 1)])
}
