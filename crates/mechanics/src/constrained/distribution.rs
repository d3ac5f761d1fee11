//! The distribution of admissible directions of constraints, and its closure under Lie brackets.
//!
//! Rows of linear forms in (dt, dx) are solved for as many dx as they determine. The vectors that they annihilate are
//! spanned by fields X_0 (in time) and X_j (one for each free coordinate). By Frobenius' theorem the rows are spanned
//! by differentials of functions f(x, t) if and only if the brackets [X_i, X_j] stay in the span. Otherwise iterated
//! brackets are added until the span is closed; its codimension is the number of such functions.

use symbolic::{Decision, Hypotheses, Sym, decide, substitute_all};

/// The reason why the constraints were not classified.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unclassified {
    /// The zero test of an expression at the position failed, for this reason.
    Undecided(String),
    /// The constraint with this index contradicts those before it: no motion in time satisfies it.
    Contradiction(usize),
}

impl std::fmt::Display for Unclassified {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Undecided(reason) => write!(f, "whether an expression vanishes was not decided: {reason}"),
            Self::Contradiction(k) => write!(f, "constraint {} contradicts those before it", k + 1),
        }
    }
}

impl std::error::Error for Unclassified {}

/// The coordinates (t, x), and a general position that satisfies the geometric constraints.
#[derive(Clone, Debug)]
pub(super) struct Place {
    /// The symbols of t, then of x.
    pub coordinates: Vec<Sym>,
    /// The values of these symbols at the position, as expressions in other symbols.
    pub values: Vec<(Sym, Sym)>,
}

impl Place {
    /// Whether an expression in the coordinates vanishes at the position.
    pub fn vanishes(&self, expression: Sym) -> Result<bool, Unclassified> {
        match decide(expression.substitute(&self.values), &Hypotheses::none()) {
            Decision::Zero(_) => Ok(true),
            Decision::NonZero(_) => Ok(false),
            other => Err(Unclassified::Undecided(other.to_string())),
        }
    }

    /// The index of the first component, at or after `from`, that does not vanish at the position.
    fn first_present(&self, vector: &[Sym], from: usize) -> Result<Option<usize>, Unclassified> {
        for (column, &component) in vector.iter().enumerate().skip(from) {
            if !self.vanishes(component)? {
                return Ok(Some(column));
            }
        }
        Ok(None)
    }

    /// A vector evaluated at the position.
    fn values_of(&self, vector: &[Sym]) -> Vec<Sym> {
        substitute_all(vector, &self.values)
    }
}

/// Rows in reduced echelon form.
#[derive(Clone, Debug)]
pub(super) struct Solved {
    /// Pairs of the column of a determined coordinate and its row, which has the entry 1 there.
    rows: Vec<(usize, Vec<Sym>)>,
    /// The numbers of the rows that depend on those before them.
    pub redundant: Vec<usize>,
}

/// Gauss-Jordan elimination with pivots that do not vanish at the position; the column of dt is never a pivot.
pub(super) fn solve(place: &Place, numbered: &[(usize, Vec<Sym>)]) -> Result<Solved, Unclassified> {
    let mut solved = Solved { rows: Vec::new(), redundant: Vec::new() };
    for (number, row) in numbered {
        let mut row = row.clone();
        for (column, known) in &solved.rows {
            let factor = row[*column];
            row = row.iter().zip(known).map(|(&entry, &below)| entry - factor * below).collect();
        }
        let pivot = place.first_present(&row, 1)?;
        let Some(pivot) = pivot else {
            if !place.vanishes(row[0])? {
                return Err(Unclassified::Contradiction(*number));
            }
            solved.redundant.push(*number);
            continue;
        };
        let scale = row[pivot];
        let row: Vec<Sym> = row.iter().map(|&entry| entry / scale).collect();
        for (_, known) in &mut solved.rows {
            let factor = known[pivot];
            *known = known.iter().zip(&row).map(|(&entry, &new)| entry - factor * new).collect();
        }
        solved.rows.push((pivot, row));
    }
    Ok(solved)
}

impl Solved {
    /// The number of independent rows.
    pub fn rank(&self) -> usize {
        self.rows.len()
    }

    /// The fields X_0 and X_j, each with the index of the coordinate that it changes by one.
    pub fn fields(&self, columns: usize) -> Vec<(usize, Vec<Sym>)> {
        let determined = |column: usize| self.rows.iter().any(|(pivot, _)| *pivot == column);
        let free = (0..columns).filter(|&column| !determined(column));
        free.map(|column| {
            let mut field = vec![Sym::ZERO; columns];
            field[column] = Sym::ONE;
            for (pivot, row) in &self.rows {
                field[*pivot] = -row[column];
            }
            (column, field)
        })
        .collect()
    }
}

/// A Lie bracket outside the span of the fields.
#[derive(Clone, Debug, PartialEq)]
pub struct Obstruction {
    /// The coordinates of the two fields: 0 for the time, i for the i-th x.
    pub fields: [usize; 2],
    /// The components of their bracket along (t, x), at the position.
    pub bracket: Vec<Sym>,
}

/// The dimension of the closure under brackets, and the first bracket outside the span.
pub(super) fn reach(place: &Place, fields: &[(usize, Vec<Sym>)]) -> Result<(usize, Option<Obstruction>), Unclassified> {
    let mut span = Span::default();
    for (_, field) in fields {
        span.add(place, field)?;
    }
    let mut obstruction = None;
    let mut latest: Vec<(usize, Vec<Sym>)> = fields.to_vec();
    while !latest.is_empty() && span.rows.len() < place.coordinates.len() {
        let mut new = Vec::new();
        for (i, first) in fields {
            for (j, second) in &latest {
                let bracket = bracket(&place.coordinates, first, second);
                if span.add(place, &bracket)? {
                    obstruction
                        .get_or_insert_with(|| Obstruction { fields: [*i, *j], bracket: place.values_of(&bracket) });
                    new.push((*j, bracket));
                }
            }
        }
        latest = new;
    }
    Ok((span.rows.len(), obstruction))
}

/// The Lie bracket [X, Y]^i = X(Y^i) - Y(X^i).
fn bracket(coordinates: &[Sym], x: &[Sym], y: &[Sym]) -> Vec<Sym> {
    let along = |field: &[Sym], component: Sym| {
        let moved = coordinates.iter().zip(field).filter(|(_, speed)| **speed != Sym::ZERO);
        moved.fold(Sym::ZERO, |sum, (&coordinate, &speed)| sum + speed * component.diff(coordinate))
    };
    x.iter().zip(y).map(|(&xi, &yi)| along(x, yi) - along(y, xi)).collect()
}

/// Independent vectors at the position, in echelon form.
#[derive(Default)]
struct Span {
    rows: Vec<(usize, Vec<Sym>)>,
}

impl Span {
    /// Adds a vector. Returns whether it was independent of the span.
    fn add(&mut self, place: &Place, vector: &[Sym]) -> Result<bool, Unclassified> {
        let mut rest = place.values_of(vector);
        for (pivot, row) in &self.rows {
            let factor = rest[*pivot];
            rest = rest.iter().zip(row).map(|(&entry, &known)| entry - factor * known).collect();
        }
        let Some(pivot) = place.first_present(&rest, 0)? else { return Ok(false) };
        let scale = rest[pivot];
        self.rows.push((pivot, rest.iter().map(|&entry| entry / scale).collect()));
        Ok(true)
    }
}
