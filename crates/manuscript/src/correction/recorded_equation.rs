//! Corrections of an equation that a page records as expressions and compares with the derived one, by edits of its printed form.

use super::edit::Edit;
use super::ground::{Ground, Look, Proof, cleared};
use super::letter_rates::LetterRate;
use super::lost::{SOUGHT, lost_terms, solved, sought};
use super::places::Places;
use super::printed_letters::{DERIVED, Letter, in_print, letters};
use super::samples::Samples;
use super::search::Search;
use super::values::weight;
use crate::change::Correction;
use crate::refutation::Refutation;
use claims::examine::mixed_lines;
use claims::{Line, Page, Verdict};
use latex::{Chain, Meaning, Statement, Term, Value, read, value};
use symbolic::{Decision, Dimension, Hypotheses, Identity, Sym, coefficients, decide, identified, normal};

/// A correction of a recorded equation.
#[derive(Clone, Debug)]
pub struct LineCorrection {
    pub correction: Correction,
    /// The corrected equation in the letters of the page.
    pub line: Line,
}

/// The reason for which the printed formula of a recorded equation cannot be edited.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotRead(pub String);

/// The smallest edits that turn an equation into the derived one. Each result is proved under the hypotheses.
///
/// # Errors
/// The LaTeX of the equation, parsed again, does not give the equation.
pub fn line_corrections(
    line: &Line,
    hypotheses: &Hypotheses,
    dimension: fn(&str) -> Option<Dimension>,
    goes_on: &dyn Fn() -> bool,
) -> Result<Vec<LineCorrection>, NotRead> {
    let is_identity = line.derived == Sym::ZERO && hypotheses.statements().is_empty();
    let ground = Recorded { is_identity, ..Recorded::of(line, hypotheses, dimension, goes_on)? };
    ground.corrections()
}

/// The smallest edits of a conclusion; `stand_for` contains letters with the expressions that they replace.
pub(super) fn conclusion_corrections(
    stand_for: &[(Sym, Sym)],
    line: &Line,
    hypotheses: &Hypotheses,
    dimension: fn(&str) -> Option<Dimension>,
    goes_on: &dyn Fn() -> bool,
) -> Result<Vec<LineCorrection>, NotRead> {
    Recorded { stand_for, ..Recorded::of(line, hypotheses, dimension, goes_on)? }.corrections()
}

struct Recorded<'a> {
    stand_for: &'a [(Sym, Sym)],
    /// Whether nothing was derived and nothing is assumed, so that the formula may be an identity in its letters.
    is_identity: bool,
    line: &'a Line,
    hypotheses: &'a Hypotheses,
    dimension: fn(&str) -> Option<Dimension>,
    goes_on: &'a dyn Fn() -> bool,
    letters: Vec<Letter>,
    rates: Vec<LetterRate>,
    text: String,
    /// A point at which the printed equation differs from the derived one.
    at: Option<Refutation>,
    samples: Option<Samples>,
}

impl<'a> Recorded<'a> {
    fn of(
        line: &'a Line,
        hypotheses: &'a Hypotheses,
        dimension: fn(&str) -> Option<Dimension>,
        goes_on: &'a dyn Fn() -> bool,
    ) -> Result<Self, NotRead> {
        let printed = if line.names { vec![line.right] } else { vec![line.left, line.right] };
        let stated = hypotheses.statements().iter().flat_map(|&(left, right)| [left, right]);
        let mut symbols: Vec<Sym> = Vec::new();
        for symbol in printed.into_iter().chain([line.derived]).chain(stated).flat_map(Sym::symbols_of) {
            if !symbols.contains(&symbol) {
                symbols.push(symbol);
            }
        }
        let letters = letters(&symbols);
        let own = in_print(&letters);
        let latex = |side: Sym| side.substitute(&own).latex();
        let left = if line.names { DERIVED.to_owned() } else { latex(line.left) };
        let text = format!("{left} = {}", latex(line.right));
        let of_letter = |letter: &Letter| LetterRate {
            name: letter.name.clone(),
            order: letter.order,
            latex: letter.latex.clone(),
            dimension: dimension(&letter.symbol.to_string()).unwrap_or(Dimension::none()),
            is_symbol: true,
            is_input: false,
            is_parameter: false,
            is_reaction: false,
            value: letter.symbol,
            vanishes: false,
        };
        let rates = letters.iter().filter(|letter| letter.is_recorded).map(of_letter).collect();
        let at = match decide(line.derived - line.printed(), hypotheses) {
            Decision::NonZero(witness) => Some(completed(witness.point, &symbols, hypotheses)),
            _ => None,
        };
        Ok(Recorded {
            stand_for: &[],
            is_identity: false,
            line,
            hypotheses,
            dimension,
            goes_on,
            letters,
            rates,
            text,
            at,
            samples: Samples::of(hypotheses),
        })
    }

    fn corrections(&self) -> Result<Vec<LineCorrection>, NotRead> {
        let line = self.line;
        let statement = read(&self.text, &self.known()).map_err(|fault| NotRead(fault.to_string()))?;
        let sides = self.sides(&statement).ok_or_else(|| NotRead("a side has no value".to_owned()))?;
        let is_same =
            |read: Sym, recorded: Sym| read == recorded || decide(read - recorded, &Hypotheses::none()).is_zero();
        if !is_same(sides.right, line.right) || !line.names && !is_same(sides.left, line.left) {
            return Err(NotRead(format!("{} is read as {}", self.text, sides.right)));
        }
        let search = Search::of(self, &statement);
        let mut found = search.small();
        if found.is_empty() {
            found = search.large();
        }
        let edited = |correction: Correction| {
            let statement = read(&correction.formula, &self.known()).ok()?;
            Some(LineCorrection { line: self.sides(&statement)?, correction })
        };
        Ok(found.into_iter().filter_map(edited).collect())
    }

    fn values(&self, statement: &Statement) -> Option<[Sym; 2]> {
        let [Chain { sides, .. }] = &statement.chains[..] else { return None };
        let [left, right] = &sides[..] else { return None };
        Some([self.value(left)?, self.value(right)?])
    }

    fn value(&self, term: &Term) -> Option<Sym> {
        match value(term, &Letters(self)) {
            Ok(Value::Scalar(value)) => Some(value),
            _ => None,
        }
    }

    /// An edited equation in the letters of the page; `None` if the name on its left side was edited.
    fn sides(&self, statement: &Statement) -> Option<Line> {
        let [left, right] = self.values(statement)?;
        match self.line.names {
            true => (left == self.line.derived).then_some(Line { right, ..*self.line }),
            false => Some(Line { left, right, ..*self.line }),
        }
    }

    /// An expression in its normal form, and in forms that use a letter for another expression.
    fn ways_to_tell(&self, expression: Sym) -> Vec<Sym> {
        let form = |expression: Sym| normal(expression, &Hypotheses::none()).map(|form| form.to_sym());
        let Ok(plain) = normal(expression, self.hypotheses).map(|form| form.to_sym()) else { return Vec::new() };
        // a letter with a numerical value is retained, so that dimensions still agree
        let lettered = with_letters(self.hypotheses).and_then(|known| normal(expression, &known).ok());
        let mut all: Vec<Sym> = [plain].into_iter().chain(lettered.map(|form| form.to_sym())).collect();
        for &(letter, stands_for) in self.hypotheses.statements() {
            let known = plain.symbols_of();
            if letter.symbol_name().is_none() {
                continue;
            }
            for symbol in stands_for.symbols_of().into_iter().filter(|symbol| known.contains(symbol)) {
                let zero = normal(stands_for - letter, &Hypotheses::none()).map(|form| form.numerator());
                let Ok(terms) = zero.map_err(|_| ()).and_then(|zero| coefficients(zero, &[symbol]).map_err(|_| ()))
                else {
                    continue;
                };
                let of =
                    |power: u32| terms.iter().find(|(exponents, _)| exponents[0] == power).map(|(_, value)| *value);
                if let (Some(factor), true) = (of(1), terms.iter().all(|(exponents, _)| exponents[0] <= 1)) {
                    let solved = -of(0).unwrap_or(Sym::ZERO) / factor;
                    all.extend(form(plain.substitute(&[(symbol, solved)])));
                }
            }
        }
        all.sort_by_key(|told| told.to_string().len());
        all.dedup();
        all
    }

    fn difference(&self, statement: &Statement) -> Option<Sym> {
        let [left, right] = self.values(statement)?;
        // a name on the left side denotes the derived expression
        Some(if self.line.names { right - left } else { left - right - self.line.derived })
    }
}

/// The point extended by the values of letters that hypotheses determine.
fn completed(point: Vec<(Sym, Sym)>, symbols: &[Sym], hypotheses: &Hypotheses) -> Refutation {
    let mut at = Refutation { point, is_formal: false };
    for &symbol in symbols {
        let is_known = at.point.iter().any(|(known, _)| *known == symbol);
        let reduced = normal(symbol, hypotheses).map(|form| form.to_sym());
        if let (false, Some(value)) = (is_known, reduced.ok().and_then(|reduced| at.value(reduced))) {
            at.point.push((symbol, value));
        }
    }
    at
}

/// The hypotheses without those that set a letter to a number; `None` if some of the others do not define a letter.
fn with_letters(hypotheses: &Hypotheses) -> Option<Hypotheses> {
    hypotheses.statements().iter().try_fold(Hypotheses::none(), |known, &(letter, value)| match value.as_constant() {
        Some(_) => Some(known),
        None => letter.symbol_name().map(|_| known.given(letter, value)),
    })
}

impl Ground for Recorded<'_> {
    fn text(&self) -> &str {
        &self.text
    }

    fn known(&self) -> Vec<String> {
        let mut names: Vec<String> = self.letters.iter().map(|letter| letter.name.clone()).collect();
        names.push(DERIVED.to_owned());
        names.dedup();
        names
    }

    fn rates(&self) -> &[LetterRate] {
        &self.rates
    }

    fn own_difference(&self, statement: &Statement) -> Option<Sym> {
        self.sides(statement).map(|line| line.printed())
    }

    fn redundancies(&self, _: &Statement) -> usize {
        // no part is redundant, since the equation is compared with the derived one term by term
        0
    }

    fn has_points(&self) -> bool {
        true
    }

    fn look(&self, _: &str, statement: &Statement) -> Look {
        let (Some(line), Some(zero)) = (self.sides(statement), self.difference(statement)) else { return Look::Fails };
        // an identity of the letters states nothing unless the claim is an identity; neither does a formula with both sides zero
        let is_zero = |side: Sym, hypotheses: &Hypotheses| decide(side, hypotheses).is_zero();
        let is_told_twice = !self.is_identity || weight(line.left) == weight(line.right);
        let is_empty = is_told_twice && is_zero(line.printed(), &Hypotheses::none())
            || [line.left, line.right].into_iter().all(|side| is_zero(side, self.hypotheses));
        if self.line.derived == Sym::ZERO && is_empty {
            return Look::Fails;
        }
        let value = self.at.as_ref().and_then(|at| at.value(zero));
        if value.is_some_and(|value| value != Sym::ZERO) {
            return Look::Fails;
        }
        match identified(&[zero]) {
            Identity::NotZero if self.hypotheses.statements().is_empty() => Look::Fails,
            Identity::Identified { .. } => Look::Holds,
            _ if value.is_some() => Look::Holds,
            _ => Look::Open,
        }
    }

    fn residual(&self, statement: &Statement) -> Option<Vec<f64>> {
        let zero = match cleared(statement) {
            Some((cleared, _)) if self.line.names => self.difference(&cleared)?,
            Some((cleared, below)) => {
                let ([left, right], below) = (self.values(&cleared)?, self.value(&below)?);
                left - right - self.line.derived * below
            }
            None => self.difference(statement)?,
        };
        self.samples.as_ref()?.values(&[zero])
    }

    fn lack(&self, statement: &Statement) -> Option<Sym> {
        normal(solved(self.difference(statement)?)?, self.hypotheses).ok().map(|form| form.to_sym())
    }

    fn sought(&self, statement: &Statement) -> Vec<Sym> {
        // for an identity there is no lost term, since a suitable term would make any equation an identity
        let zero = self.difference(statement).filter(|_| !self.is_identity);
        let Some(value) = zero.and_then(solved) else { return Vec::new() };
        let own = in_print(&self.letters);
        self.ways_to_tell(value).into_iter().map(|value| value.substitute(&own)).collect()
    }

    fn lost(&self, places: &Places, most: usize) -> Vec<Edit> {
        lost_terms(places, &self.text, self.known(), most, &|statement| self.sought(statement))
    }

    fn proved(&self, text: &str) -> Option<Proof> {
        let line = self.sides(&read(text, &self.known()).ok()?)?;
        let of = |side: Sym| side.substitute(self.stand_for);
        let told = Line { derived: of(line.derived), left: of(line.left), right: of(line.right), ..line };
        if !mixed_lines(&[told], self.dimension).is_empty() {
            return None;
        }
        let mut page = Page::of("print", self.dimension);
        page.claim("print", "edited", "").under(self.hypotheses).holds([line]);
        let judged = page.judge().into_iter().next().filter(|judged| judged.verdict == Verdict::Proved)?;
        Some(Proof { judged, certificate: None })
    }

    fn goes_on(&self) -> bool {
        (self.goes_on)()
    }
}

/// The meanings of printed letters in symbols of the page.
struct Letters<'a, 'b>(&'a Recorded<'b>);

impl Meaning for Letters<'_, '_> {
    fn letter(&self, name: &str) -> Option<Value> {
        let own = || self.0.letters.iter().find(|letter| letter.name == name && letter.order == 0);
        let symbol = match name {
            SOUGHT => sought(),
            DERIVED => self.0.line.derived,
            r"\pi" => Sym::symbol("pi"),
            _ => own()?.symbol,
        };
        Some(Value::Scalar(symbol))
    }

    fn rate(&self, of: Sym) -> Result<Sym, String> {
        let letters = &self.0.letters;
        let rate = letters
            .iter()
            .find(|letter| letter.symbol == of)
            .and_then(|of| letters.iter().find(|letter| letter.name == of.name && letter.order == of.order + 1));
        rate.map(|letter| letter.symbol).ok_or_else(|| "it has no rate here".to_owned())
    }

    fn partial(&self, _: Sym, _: Sym) -> Result<Sym, String> {
        Err("no derivative is recorded".to_owned())
    }

    fn circle(&self, angle: Sym) -> (Sym, Sym) {
        let point = angle.circle_as_written();
        (point.cos, point.sin)
    }
}
