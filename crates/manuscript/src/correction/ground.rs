//! The context in which edits of a formula are tried: its letters, its test points, and the judge of edited formulas.

use super::edit::Edit;
use super::letter_rates::LetterRate;
use super::places::Places;
use claims::Judged;
use claims::certificate::Certificate;
use latex::{Chain, Form, Relation, Statement, Term};
use symbolic::Sym;

/// The result of the test points for an edited formula.
pub(super) enum Look {
    /// The formula is false at a point, or states nothing, such as 0 = 0.
    Fails,
    Holds,
    /// The formula has no value at the points.
    Open,
}

/// The proof of an edited formula.
pub(super) struct Proof {
    pub judged: Judged,
    /// The certificate, if requested.
    pub certificate: Option<Certificate>,
}

/// A refuted printed formula, with all that is necessary to judge its edits.
pub(super) trait Ground {
    /// The printed formula in LaTeX.
    fn text(&self) -> &str;

    /// The names of the letters that a formula may contain.
    fn known(&self) -> Vec<String>;

    /// The letters and their rates, in the form in which edits write them.
    fn rates(&self) -> &[LetterRate];

    /// The difference of the two sides in the printed letters; `None` if the formula does not have two sides.
    fn own_difference(&self, statement: &Statement) -> Option<Sym>;

    /// The number of parts of a formula that state nothing.
    fn redundancies(&self, statement: &Statement) -> usize;

    /// Whether there are test points that can refute an edited formula.
    fn has_points(&self) -> bool;

    /// The result of the test points for an edited formula.
    fn look(&self, text: &str, statement: &Statement) -> Look;

    /// The residual of the formula at some points, in double precision; it vanishes for a true formula. `None` if it cannot be evaluated.
    fn residual(&self, statement: &Statement) -> Option<Vec<f64>>;

    /// The value that the letter of the unknown term must have, in normal form in the symbols of the model.
    fn lack(&self, statement: &Statement) -> Option<Sym>;

    /// The values that the letter of the unknown term may have, in the printed letters.
    fn sought(&self, statement: &Statement) -> Vec<Sym>;

    /// Edits that add the terms which a sum lacks, if these are at most `most` terms.
    fn lost(&self, places: &Places, most: usize) -> Vec<Edit>;

    /// The proof of an edited formula; `None` if there is no proof, or an objection to it.
    fn proved(&self, text: &str) -> Option<Proof>;

    /// Whether there is time for further edits.
    fn goes_on(&self) -> bool;
}

/// An equality multiplied by its common denominator, and this denominator. In this form, edits of numerators and denominators change the residual
/// additively.
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

/// A product of fractions as one fraction: its numerator, and its denominator if it has one.
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
