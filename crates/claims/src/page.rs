//! A paper's page: its claims in order, written one line each.

use crate::certificate::Certificate;
use crate::proof::Combination;
use crate::{Claim, Condition, Judged, Line, Point, Proof, Statement, Theorem, Verdict};
use symbolic::{Dimension, Hypotheses, Sym};

/// The claims of a paper.
pub struct Page {
    paper: &'static str,
    dimensions: fn(&str) -> Option<Dimension>,
    section: &'static str,
    claims: Vec<Claim>,
}

/// A claim in the making: the methods finish it.
pub struct Draft<'a> {
    page: &'a mut Page,
    equation: &'static str,
    slug: &'static str,
    says: String,
    rules: Hypotheses,
    given: Vec<Condition>,
    why: String,
    reading: String,
    note: String,
    in_words: bool,
}

impl Page {
    /// An empty page. `dimensions` gives the dimension of every symbol of the paper.
    pub fn of(paper: &'static str, dimensions: fn(&str) -> Option<Dimension>) -> Self {
        Page { paper, dimensions, section: "", claims: Vec::new() }
    }

    /// The paper's key.
    pub fn paper(&self) -> &'static str {
        self.paper
    }

    /// The dimensions of its letters.
    pub fn dimensions(&self) -> fn(&str) -> Option<Dimension> {
        self.dimensions
    }

    /// The dimension of a letter of the page.
    pub fn dimension(&self, name: &str) -> Option<Dimension> {
        (self.dimensions)(name)
    }

    /// The claims in order.
    pub fn claims(&self) -> &[Claim] {
        &self.claims
    }

    /// Begins a section of the paper: the claims that follow belong to it.
    pub fn section(&mut self, title: &'static str) {
        self.section = title;
    }

    /// Begins a claim of an entry of the paper.
    pub fn claim(&mut self, equation: &'static str, slug: &'static str, says: impl Into<String>) -> Draft<'_> {
        Draft {
            page: self,
            equation,
            slug,
            says: says.into(),
            rules: Hypotheses::none(),
            given: Vec::new(),
            why: String::new(),
            reading: String::new(),
            note: String::new(),
            in_words: false,
        }
    }

    /// Decides every claim.
    pub fn judge(&self) -> Vec<Judged> {
        self.judged(|_| true).collect()
    }

    /// The claims that `asked` selects, judged one after the other.
    pub fn judged(&self, asked: impl Fn(&Claim) -> bool) -> impl Iterator<Item = Judged> {
        self.claims.iter().filter(move |claim| asked(claim)).map(|claim| claim.judge(self.dimensions))
    }

    /// As [`Page::judged`], each with the certificates of its verdict and of its correction's.
    pub fn certified(&self, asked: impl Fn(&Claim) -> bool) -> impl Iterator<Item = (Judged, Vec<Certificate>)> {
        self.claims.iter().filter(move |claim| asked(claim)).map(|claim| {
            let judged = claim.judge(self.dimensions);
            let certificates = Certificate::of(claim, &judged);
            (judged, certificates)
        })
    }

    /// Makes the last claim the correction of the claim before it.
    pub fn correct(&mut self) {
        if let Some(correction) = self.claims.pop()
            && let Some(wrong) = self.claims.last_mut()
        {
            wrong.correction = Some(Box::new(correction));
        }
    }
}

impl<'a> Draft<'a> {
    /// Relations that hold throughout.
    pub fn under(mut self, rules: &Hypotheses) -> Self {
        self.rules = rules.clone();
        self
    }

    /// Why the print fails: the slip that explains it, in a sentence. Every refuted claim has one.
    pub fn why(mut self, why: impl Into<String>) -> Self {
        self.why = why.into();
        self
    }

    /// The reading of a damaged or ambiguous text: the source's signs, the restored ones, and the reading that is judged.
    pub fn reading(mut self, reading: impl Into<String>) -> Self {
        self.reading = reading.into();
        self
    }

    /// A remark for the reader.
    pub fn note(mut self, note: impl Into<String>) -> Self {
        self.note = note.into();
        self
    }

    /// The sentence says everything: the derived expressions would tell a reader nothing more.
    pub fn in_words(mut self) -> Self {
        self.in_words = true;
        self
    }

    /// Adds conditions that the statement presupposes.
    pub fn given(mut self, conditions: impl IntoIterator<Item = Condition>) -> Self {
        self.given.extend(conditions);
        self
    }

    /// The paper is expected to be right.
    pub fn holds(self, lines: impl IntoIterator<Item = Line>) -> &'a mut Page {
        self.equations(lines, Verdict::Proved)
    }

    /// The paper is expected to be wrong; [`Page::correct`] adds the correction.
    pub fn fails(self, lines: impl IntoIterator<Item = Line>) -> &'a mut Page {
        self.equations(lines, Verdict::Refuted)
    }

    /// A definition.
    pub fn defines(self, lines: impl IntoIterator<Item = Line>) -> &'a mut Page {
        let lines = lines.into_iter().collect();
        self.finish(Statement::Definition(lines), Verdict::Definition)
    }

    /// Each conclusion has normal form zero under the rules.
    pub fn follows(self, then: impl IntoIterator<Item = Condition>) -> &'a mut Page {
        self.theorem(then, Proof::NormalForm, Verdict::Proved)
    }

    /// Each conclusion is a combination of given conditions: (multiplier places, cofactors) for each.
    pub fn by_combination(
        self,
        then: impl IntoIterator<Item = (Condition, Vec<usize>, Vec<(usize, Sym)>)>,
    ) -> &'a mut Page {
        let (conclusions, certificates) = then
            .into_iter()
            .map(|(conclusion, multiplier, cofactors)| {
                (conclusion, Combination { multiplier, cofactors, factor: None })
            })
            .unzip::<_, _, Vec<_>, Vec<_>>();
        self.theorem(conclusions, Proof::Combinations(certificates), Verdict::Proved)
    }

    /// An expression f does not vanish: `factor` f is the product of the given expressions at `places`, up to the
    /// combination.
    pub fn nonvanishing(self, f: Sym, factor: Sym, places: Vec<usize>, cofactors: Vec<(usize, Sym)>) -> &'a mut Page {
        let certificate = Combination { multiplier: places, cofactors, factor: Some(factor) };
        self.theorem([Condition::NonZero(f)], Proof::Combinations(vec![certificate]), Verdict::Proved)
    }

    /// Each conclusion holds by the signs of its terms, where the symbols are given as positive.
    pub fn by_signs(self, then: impl IntoIterator<Item = Condition>) -> &'a mut Page {
        let positive = self.given.iter().filter_map(|c| match c {
            Condition::Positive(symbol) if symbol.symbol_name().is_some() => Some(*symbol),
            _ => None,
        });
        let proof = Proof::Signs { positive: positive.collect() };
        self.theorem(then, proof, Verdict::Proved)
    }

    /// A conclusion fails at an exact point.
    pub fn refuted(self, then: impl IntoIterator<Item = Condition>, at: Point) -> &'a mut Page {
        self.theorem(then, Proof::Counterexample(at), Verdict::Refuted)
    }

    /// "Some value of the unknown satisfies the conclusions" fails at an exact point of everything else.
    pub fn without_root(self, then: impl IntoIterator<Item = Condition>, unknown: Sym, at: Point) -> &'a mut Page {
        self.theorem(then, Proof::NoRoot { unknown, at }, Verdict::Refuted)
    }

    /// There is a point at which everything holds.
    pub fn exists(self, then: impl IntoIterator<Item = Condition>, at: Point) -> &'a mut Page {
        self.theorem(then, Proof::Example(at), Verdict::Proved)
    }

    fn equations(self, lines: impl IntoIterator<Item = Line>, expected: Verdict) -> &'a mut Page {
        let statement = Statement::Equations { lines: lines.into_iter().collect(), hypotheses: self.rules.clone() };
        self.finish(statement, expected)
    }

    fn theorem(mut self, then: impl IntoIterator<Item = Condition>, proof: Proof, expected: Verdict) -> &'a mut Page {
        let given = std::mem::take(&mut self.given);
        let theorem = Theorem { given, then: then.into_iter().collect(), rules: self.rules.clone(), proof };
        self.finish(Statement::Theorem(theorem), expected)
    }

    fn finish(self, statement: Statement, expected: Verdict) -> &'a mut Page {
        self.page.claims.push(Claim {
            id: format!("{}/{}/{}", self.page.paper, self.equation, self.slug),
            section: self.page.section,
            equation: self.equation,
            says: self.says,
            statement,
            expected,
            correction: None,
            why: self.why,
            reading: self.reading,
            note: self.note,
            in_words: self.in_words,
        });
        self.page
    }
}
