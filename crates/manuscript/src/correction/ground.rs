//! The ground on which edits of a formula are tried: its letters, points at which it must hold, the judge that decides.

use super::edit::Edit;
use super::letter_rates::LetterRate;
use super::places::Places;
use claims::Judged;
use claims::certificate::Certificate;
use latex::{Chain, Form, Relation, Statement, Term};
use symbolic::Sym;

/// The verdict of points on an edited formula.
pub(super) enum Look {
    /// It says nothing, or it is false.
    Fails,
    Holds,
    /// The points give it no value.
    Open,
}

/// An edited formula that is proved.
pub(super) struct Proof {
    pub judged: Judged,
    /// Where certificates are asked for.
    pub certificate: Option<Certificate>,
}

/// A printed formula that is refuted, with everything by which an edit of it is judged.
pub(super) trait Ground {
    /// The print in LaTeX.
    fn text(&self) -> &str;

    /// Names of the letters that the formula may have.
    fn known(&self) -> Vec<String>;

    /// Letters with their rates, as an edit may write them.
    fn rates(&self) -> &[LetterRate];

    /// The difference of the two sides in the letters of the print, where there is one.
    fn own_difference(&self, statement: &Statement) -> Option<Sym>;

    /// Whether points can tell that an edited formula is false.
    fn has_points(&self) -> bool;

    /// Their verdict.
    fn look(&self, text: &str, statement: &Statement) -> Look;

    /// The residual of the formula at some points, in double precision: zero where it is true. None where nothing can be measured.
    fn residual(&self, statement: &Statement) -> Option<Vec<f64>>;

    /// The value that the sought letter must have, in normal form over what the formula is judged by.
    fn lack(&self, statement: &Statement) -> Option<Sym>;

    /// The values that the sought letter must have, in the letters of the print.
    fn sought(&self, statement: &Statement) -> Vec<Sym>;

    /// Lost terms: what each sum lacks, as so many terms at most.
    fn lost(&self, places: &Places, most: usize) -> Vec<Edit>;

    /// The edited formula with its proof; none where it is not proved without an objection.
    fn proved(&self, text: &str) -> Option<Proof>;

    /// Whether there is time left.
    fn goes_on(&self) -> bool;
}

/// An equality over one denominator, without it, and the denominator: edits above and below change what is left of it by sums.
pub(super) fn cleared(statement: &Statement) -> Option<(Statement, Term)> {
    let [Chain { sides, relations }] = &statement.chains[..] else { return None };
    let ([left, right], [Relation::Equal]) = (&sides[..], &relations[..]) else { return None };
    let ((left, left_below), (right, right_below)) = (fraction(left), fraction(right));
    let below = left_below.clone().into_iter().chain(right_below.clone()).reduce(product)?;
    let times = |side: Term, below: Option<Term>| below.into_iter().fold(side, product);
    let sides = vec![times(left, right_below), times(right, left_below)];
    Some((Statement { chains: vec![Chain { sides, relations: relations.clone() }] }, below))
}

fn product(left: Term, right: Term) -> Term {
    Term { span: left.span.clone(), form: Form::Product(Box::new(left), Box::new(right)) }
}

/// A product of fractions as one: its numerator, and its denominator where there is one.
fn fraction(term: &Term) -> (Term, Option<Term>) {
    let with = |form: Form| Term { span: term.span.clone(), form };
    match &term.form {
        Form::Quotient(above, below) => ((**above).clone(), Some((**below).clone())),
        Form::Negation(of) => {
            let (above, below) = fraction(of);
            (with(Form::Negation(Box::new(above))), below)
        }
        Form::Product(a, b) => {
            let ((a, a_below), (b, b_below)) = (fraction(a), fraction(b));
            let below = a_below.into_iter().chain(b_below).reduce(product);
            (product(a, b), below)
        }
        _ => (term.clone(), None),
    }
}
