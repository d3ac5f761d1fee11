//! The page of a paper: its claims in the paper's order, each written in a few lines of Rust.

use crate::certificate::Certificate;
use crate::proof::Combination;
use crate::{Claim, Condition, Judged, Line, Point, Proof, Statement, Theorem, Verdict};
use symbolic::{Dimension, Hypotheses, Sym};

/// The claims of a paper, with the dimensions of its letters.
pub struct Page {
    paper: &'static str,
    dimensions: fn(&str) -> Option<Dimension>,
    section: &'static str,
    claims: Vec<Claim>,
}

/// A claim under construction. A method such as [`Draft::holds`] completes it and adds it to the page.
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
    /// An empty page of the paper with this key. `dimensions` returns the dimension of every letter of the paper.
    pub fn of(paper: &'static str, dimensions: fn(&str) -> Option<Dimension>) -> Self {
        Page { paper, dimensions, section: "", claims: Vec::new() }
    }

    /// The key of the paper.
    pub fn paper(&self) -> &'static str {
        self.paper
    }

    /// The function that returns the dimension of a letter.
    pub fn dimensions(&self) -> fn(&str) -> Option<Dimension> {
        self.dimensions
    }

    /// The dimension of a letter of the page.
    pub fn dimension(&self, name: &str) -> Option<Dimension> {
        (self.dimensions)(name)
    }

    /// The claims in the order of the page.
    pub fn claims(&self) -> &[Claim] {
        &self.claims
    }

    /// Starts a section of the paper; the claims that follow belong to it.
    pub fn section(&mut self, title: &'static str) {
        self.section = title;
    }

    /// Starts a claim about a numbered equation or statement of the paper.
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

    /// Decides all claims.
    pub fn judge(&self) -> Vec<Judged> {
        self.judged(|_| true).collect()
    }

    /// Decides the claims that `asked` selects, one after the other.
    pub fn judged(&self, asked: impl Fn(&Claim) -> bool) -> impl Iterator<Item = Judged> {
        self.claims.iter().filter(move |claim| asked(claim)).map(|claim| claim.judge(self.dimensions))
    }

    /// Decides the claims that `asked` selects. Each is returned with the certificates of its verdict and of that of its correction.
    pub fn certified(&self, asked: impl Fn(&Claim) -> bool) -> impl Iterator<Item = (Judged, Vec<Certificate>)> {
        self.claims.iter().filter(move |claim| asked(claim)).map(|claim| {
            let judged = claim.judge(self.dimensions);
            let certificates = Certificate::of(claim, &judged);
            (judged, certificates)
        })
    }

    /// Removes the last claim from the page and makes it the correction of the claim before it.
    pub fn correct(&mut self) {
        if let Some(correction) = self.claims.pop()
            && let Some(wrong) = self.claims.last_mut()
        {
            wrong.correction = Some(Box::new(correction));
        }
    }
}

impl<'a> Draft<'a> {
    /// Sets equalities that always hold, which the proof may use.
    pub fn under(mut self, rules: &Hypotheses) -> Self {
        self.rules = rules.clone();
        self
    }

    /// Sets the reason for which the printed statement fails, one sentence about the slip behind it. Every refuted claim needs it.
    pub fn why(mut self, why: impl Into<String>) -> Self {
        self.why = why.into();
        self
    }

    /// Sets the reading of a damaged or ambiguous text: the signs of the source, the restored signs, and the reading that is judged.
    pub fn reading(mut self, reading: impl Into<String>) -> Self {
        self.reading = reading.into();
        self
    }

    /// Sets a remark.
    pub fn note(mut self, note: impl Into<String>) -> Self {
        self.note = note.into();
        self
    }

    /// Shows only the sentence of the claim, where its expressions would not help a reader.
    pub fn in_words(mut self) -> Self {
        self.in_words = true;
        self
    }

    /// Adds premises of the claim.
    pub fn given(mut self, conditions: impl IntoIterator<Item = Condition>) -> Self {
        self.given.extend(conditions);
        self
    }

    /// Completes the claim as equalities that are expected to be proved.
    pub fn holds(self, lines: impl IntoIterator<Item = Line>) -> &'a mut Page {
        self.equations(lines, Verdict::Proved)
    }

    /// Completes the claim as equalities that are expected to be refuted; [`Page::correct`] adds the correction.
    pub fn fails(self, lines: impl IntoIterator<Item = Line>) -> &'a mut Page {
        self.equations(lines, Verdict::Refuted)
    }

    /// Completes the claim as a definition, which is not judged.
    pub fn defines(self, lines: impl IntoIterator<Item = Line>) -> &'a mut Page {
        let lines = lines.into_iter().collect();
        self.finish(Statement::Definition(lines), Verdict::Definition)
    }

    /// Completes the claim as a theorem; each conclusion is to have the normal form zero under the rules.
    pub fn follows(self, then: impl IntoIterator<Item = Condition>) -> &'a mut Page {
        self.theorem(then, Proof::NormalForm, Verdict::Proved)
    }

    /// Completes the claim as a theorem. Each conclusion comes with indices of the given conditions that form the multiplier, and with cofactors.
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

    /// Completes the claim f ≠ 0: `factor` times f is the product of the given expressions with the indices `places`, plus a combination of
    /// given equalities with `cofactors`.
    pub fn nonvanishing(self, f: Sym, factor: Sym, places: Vec<usize>, cofactors: Vec<(usize, Sym)>) -> &'a mut Page {
        let certificate = Combination { multiplier: places, cofactors, factor: Some(factor) };
        self.theorem([Condition::NonZero(f)], Proof::Combinations(vec![certificate]), Verdict::Proved)
    }

    /// Completes the claim as a theorem; each conclusion follows from the signs of its terms, with the given conditions that a symbol is positive.
    pub fn by_signs(self, then: impl IntoIterator<Item = Condition>) -> &'a mut Page {
        let positive = self.given.iter().filter_map(|c| match c {
            Condition::Positive(symbol) if symbol.symbol_name().is_some() => Some(*symbol),
            _ => None,
        });
        let proof = Proof::Signs { positive: positive.collect() };
        self.theorem(then, proof, Verdict::Proved)
    }

    /// Completes the claim as a theorem that fails: a conclusion is false at this exact point.
    pub fn refuted(self, then: impl IntoIterator<Item = Condition>, at: Point) -> &'a mut Page {
        self.theorem(then, Proof::Counterexample(at), Verdict::Refuted)
    }

    /// Completes the claim that some value of the unknown satisfies the conclusions; it fails at this exact point of all other letters.
    pub fn without_root(self, then: impl IntoIterator<Item = Condition>, unknown: Sym, at: Point) -> &'a mut Page {
        self.theorem(then, Proof::NoRoot { unknown, at }, Verdict::Refuted)
    }

    /// Completes the claim as an existence theorem: at this exact point all conditions and conclusions hold.
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
