//! The translation between the letters of a paper and the symbols of a model.

use crate::paper_text::{LetterText, PaperText};
use field::Analytic;
use latex::{Meaning, Value, plain_name};
use model::{Entry, Model, Text, Trace};
use reader::{Issue, SceneError};
use symbolic::{Dimension, Sym};

/// The letters of a paper as outputs of a model, in their order, with one output for each component of a vector. If the system is in another file,
/// positions in the paper are counted from the end of the system's text.
pub(crate) fn outputs(paper: &PaperText) -> Vec<Entry> {
    let offset = if paper.has_own_system() { 0 } else { paper.system.text.len() + 1 };
    let mut entries = Vec::new();
    for letter in &paper.letters {
        for (component, meaning) in letter.meaning.iter().enumerate() {
            let at = offset + meaning.start();
            entries.push(Entry {
                name: Text::at(output_name(letter, component), at),
                value: Text::at(meaning.text.clone(), at),
            });
        }
    }
    entries
}

fn output_name(letter: &LetterText, component: usize) -> String {
    match letter.is_vector {
        true => format!("letter {} {}", letter.latex, component + 1),
        false => format!("letter {}", letter.latex),
    }
}

/// The model with the letters as outputs.
///
/// # Errors
/// All faults of the system or of the meanings, each with its place in its file.
pub(crate) fn model(paper: &PaperText) -> Result<Model, SceneError> {
    if !paper.has_own_system() {
        paper.system.for_judgement()?;
    }
    let told = |issue: &mut Issue| {
        for text in [&mut issue.title, &mut issue.label] {
            *text = text.replace("the output `letter ", "the letter `").replace("`letter ", "`");
        }
    };
    paper.system.for_judgement_with(outputs(paper)).map_err(|mut error| {
        error.issues.iter_mut().for_each(told);
        if paper.has_own_system() {
            return error;
        }
        let offset = paper.system.text.len() + 1;
        for issue in &mut error.issues {
            if let Some(span) = &mut issue.span {
                *span = span.start.saturating_sub(offset)..span.end.saturating_sub(offset);
            }
        }
        SceneError { path: paper.path.clone(), text: paper.text.clone(), issues: error.issues }
    })
}

/// A letter with its meaning.
struct Letter {
    name: String,
    /// The meaning in the symbols of the model.
    value: Value,
    /// The paper's own symbol, or symbols of its components, with its LaTeX.
    own: Value,
    dimension: Dimension,
}

/// The letters of a paper with their meanings in a model.
pub(crate) struct Letters<'t, 'm> {
    pub trace: &'t Trace<'m>,
    letters: Vec<Letter>,
    /// The paper's expressions for symbols of the model.
    names: Vec<(Sym, Sym)>,
    dimensions: Vec<(Sym, Dimension)>,
}

impl<'t, 'm> Letters<'t, 'm> {
    pub fn of(paper: &PaperText, trace: &'t Trace<'m>) -> Self {
        let mut letters: Vec<Letter> = Vec::new();
        for text in &paper.letters {
            let plain = plain_name(&text.name);
            // two letters may have equal plain names, such as r and \mathbf{r}
            let is_taken = plain.is_empty() || letters.iter().any(|letter| plain_name(&letter.name) == plain);
            let plain = if is_taken { text.name.clone() } else { plain };
            let found = (0..text.meaning.len()).filter_map(|component| {
                let name = output_name(text, component);
                trace.model.outputs.iter().find(|output| output.name == name)
            });
            let found: Vec<(Sym, Dimension)> =
                found.map(|output| (trace.scalar(output.is), output.dimension)).collect();
            let dimension = found.first().map_or(Dimension::none(), |(_, dimension)| *dimension);
            let symbol = |component: usize| match text.is_vector {
                true => (format!("{plain}[{}]", component + 1), format!("{{{}}}_{{{}}}", text.latex, component + 1)),
                false => (plain.clone(), text.latex.clone()),
            };
            let own = (0..found.len()).map(|component| Own(symbol(component)).symbol(0));
            let (value, own) = match text.is_vector {
                true => {
                    let own = own.map(|symbol| vec![symbol]).collect();
                    (Value::Matrix(found.iter().map(|(symbol, _)| vec![*symbol]).collect()), Value::Matrix(own))
                }
                false => {
                    let own = own.collect::<Vec<Sym>>().first().copied().unwrap_or(Sym::ZERO);
                    (Value::Scalar(found.first().map_or(Sym::ZERO, |(symbol, _)| *symbol)), Value::Scalar(own))
                }
            };
            letters.push(Letter { name: text.name.clone(), value, own, dimension });
        }
        let mut found = Letters { trace, letters, names: Vec::new(), dimensions: Vec::new() };
        found.name_symbols();
        found
    }

    /// The names of all letters, each in one spelling.
    pub fn spelt(&self) -> Vec<String> {
        self.letters.iter().map(|letter| letter.name.clone()).collect()
    }

    /// All scalar letters: name, meaning, own symbol, dimension.
    pub fn scalars(&self) -> impl Iterator<Item = (&str, Sym, Sym, Dimension)> {
        self.letters.iter().filter_map(|letter| match (&letter.value, &letter.own) {
            (Value::Scalar(value), Value::Scalar(own)) => Some((letter.name.as_str(), *value, *own, letter.dimension)),
            _ => None,
        })
    }

    /// Finds the paper's expressions for symbols of the model: letters, or rates of letters, that are a multiple of one symbol.
    fn name_symbols(&mut self) {
        let pairs: Vec<(Sym, Sym, Dimension)> = self
            .letters
            .iter()
            .flat_map(|letter| {
                let dimension = letter.dimension;
                letter
                    .value
                    .entries()
                    .into_iter()
                    .zip(letter.own.entries())
                    .map(move |(value, own)| (value, own, dimension))
            })
            .collect();
        let mut names: Vec<(Sym, Sym)> = Vec::new();
        let mut named = |value: Sym, own: Sym| {
            let known = |symbol: &Sym| names.iter().any(|(known, _)| known == symbol);
            let [symbol] = value.symbols_of()[..] else { return };
            if known(&symbol) {
                return;
            }
            let factor = value.diff(symbol);
            if symbol == value {
                names.push((symbol, own));
            } else if factor.as_constant().is_some() && value.substitute(&[(symbol, Sym::ZERO)]) == Sym::ZERO {
                names.push((symbol, own / factor));
            }
        };
        for &(value, own, dimension) in &pairs {
            named(value, own);
            self.dimensions.push((own, dimension));
        }
        for &(value, own, dimension) in &pairs {
            let (mut value, mut dimension) = (value, dimension);
            for order in 1..=2 {
                let Ok(rate) = rate(self.trace, value) else { break };
                if rate == Sym::ZERO {
                    break;
                }
                let own = dotted(own, order);
                named(rate, own);
                dimension = dimension / Dimension::time();
                self.dimensions.push((own, dimension));
                value = rate;
            }
        }
        self.names = names;
    }

    /// An expression of the model in the paper's letters; a symbol without a letter keeps its name in the model.
    pub fn told(&self, expression: Sym) -> Sym {
        let mut names = self.names.clone();
        // a name of the model that is a letter of the paper with another meaning gets the prefix `model.`
        for symbol in expression.symbols_of() {
            let is_named = names.iter().any(|(known, _)| *known == symbol);
            let is_letter = self.letters.iter().any(|letter| letter.own.entries().contains(&symbol));
            if !is_named && is_letter {
                names.push((
                    symbol,
                    Sym::named(&format!("model.{symbol}"), &format!(r"\mathrm{{model}}.{}", symbol.latex())),
                ));
            }
        }
        expression.substitute(&names)
    }

    /// The dimension of a letter of the paper, or of a rate of a letter.
    pub fn dimension(&self, name: &str) -> Option<Dimension> {
        let symbol = Sym::symbol(name);
        self.dimensions
            .iter()
            .find(|(known, _)| *known == symbol)
            .map(|(_, dimension)| *dimension)
            .or_else(|| (name == "pi").then(Dimension::none))
    }

    /// The letters of the paper in an expression, including rates, each with its meaning.
    pub fn meanings(&self, printed: Sym) -> Vec<(Sym, Sym)> {
        let known = printed.symbols_of();
        let mut found = Vec::new();
        for letter in &self.letters {
            for (value, own) in letter.value.entries().into_iter().zip(letter.own.entries()) {
                let mut next = Some(value);
                for order in 0..=2 {
                    let Some(value) = next else { break };
                    let symbol = dotted(own, order);
                    if known.contains(&symbol) {
                        found.push((symbol, value));
                    }
                    next = rate(self.trace, value).ok();
                }
            }
        }
        found
    }

    /// The meanings of the letters in the symbols of the model.
    pub fn in_model(&self) -> InModel<'_, 't, 'm> {
        InModel(self)
    }

    /// The letters as the paper's own symbols.
    pub fn in_paper(&self) -> InPaper<'_, 't, 'm> {
        InPaper(self)
    }
}

/// A symbol of the paper: its plain name and its LaTeX.
struct Own((String, String));

impl Own {
    fn symbol(&self, order: usize) -> Sym {
        let Own((plain, latex)) = self;
        match order {
            0 => Sym::named(plain, latex),
            1 => Sym::named(&format!("{plain}'"), &format!(r"\dot{{{latex}}}")),
            _ => Sym::named(&format!("{plain}''"), &format!(r"\ddot{{{latex}}}")),
        }
    }
}

/// The rate of this order of a letter of the paper, as a symbol.
fn dotted(own: Sym, order: usize) -> Sym {
    Own((own.to_string(), own.latex())).symbol(order)
}

/// The time derivative of an expression along the motion.
///
/// # Errors
/// The expression contains a quantity without a known derivative.
pub(crate) fn rate(trace: &Trace<'_>, of: Sym) -> Result<Sym, String> {
    let symbols = of.symbols_of();
    if let Some(third) = trace.accelerations.iter().find(|symbol| symbols.contains(symbol)) {
        return Err(format!("its rate would hold that of the acceleration {third}, which no equation of motion gives"));
    }
    let rests = |symbol: &&Sym| {
        let is_known =
            [&trace.parameters, &trace.coordinates, &trace.speeds].into_iter().any(|known| known.contains(symbol));
        !is_known && **symbol != trace.time && **symbol != trace.pi
    };
    if let Some(open) = symbols.iter().find(rests) {
        return Err(format!("the rate of {open} is not known: it is an input, a reaction or a condition"));
    }
    Ok(trace.rate_of(of))
}

pub(crate) struct InModel<'a, 't, 'm>(&'a Letters<'t, 'm>);

impl Meaning for InModel<'_, '_, '_> {
    fn letter(&self, name: &str) -> Option<Value> {
        let known = self.0.letters.iter().find(|letter| letter.name == name).map(|letter| letter.value.clone());
        known.or_else(|| (name == r"\pi").then_some(Value::Scalar(self.0.trace.pi)))
    }

    fn rate(&self, of: Sym) -> Result<Sym, String> {
        rate(self.0.trace, of)
    }

    fn partial(&self, of: Sym, by: Sym) -> Result<Sym, String> {
        let trace = self.0.trace;
        if let Some(place) =
            trace.coordinates.iter().position(|symbol| *symbol == by).filter(|place| *place < trace.speeds.len())
        {
            return Ok(trace.by_coordinate(of, place));
        }
        if let Some(place) = trace.speeds.iter().position(|symbol| *symbol == by) {
            return Ok(trace.by_speed(of, place));
        }
        match by.symbol_name() {
            Some(_) => Ok(of.diff(by)),
            None => {
                Err("a partial derivative is by a letter that is one quantity of the model, or by its rate".to_owned())
            }
        }
    }

    fn circle(&self, angle: Sym) -> (Sym, Sym) {
        circle(angle, self.0.trace.pi)
    }
}

/// The cosine and the sine of an angle, with multiples of π/4 replaced by exact values.
pub(crate) fn circle(angle: Sym, pi: Sym) -> (Sym, Sym) {
    let part = angle.diff(pi).as_constant().filter(|part| part.sign() != Some(0));
    let rest = angle.substitute(&[(pi, Sym::ZERO)]);
    let point = match part.and_then(Sym::of_half_turns) {
        Some(turned) if (angle - rest).linear_terms().len() == 1 => rest.circle() + turned,
        _ => angle.circle(),
    };
    (point.cos, point.sin)
}

pub(crate) struct InPaper<'a, 't, 'm>(&'a Letters<'t, 'm>);

impl Meaning for InPaper<'_, '_, '_> {
    fn letter(&self, name: &str) -> Option<Value> {
        let known = self.0.letters.iter().find(|letter| letter.name == name).map(|letter| letter.own.clone());
        known.or_else(|| (name == r"\pi").then(|| Value::Scalar(Sym::named("pi", r"\pi"))))
    }

    fn rate(&self, of: Sym) -> Result<Sym, String> {
        // a derivative is a symbol here, and has no dot above it
        if of.symbol_name().is_some_and(|name| !name.starts_with("d(")) {
            return Ok(match of.to_string().ends_with('\'') {
                false => dotted(of, 1),
                true => {
                    let (plain, latex) = (of.to_string(), of.latex());
                    let latex = latex.strip_prefix(r"\dot").map_or(latex.clone(), |rest| format!(r"\ddot{rest}"));
                    Sym::named(&format!("{plain}'"), &latex)
                }
            });
        }
        Ok(Sym::named(&format!("d({of})/dt"), &format!(r"\frac{{d}}{{dt}}\left({}\right)", of.latex())))
    }

    fn partial(&self, of: Sym, by: Sym) -> Result<Sym, String> {
        let latex = format!(r"\frac{{\partial}}{{\partial {}}}\left({}\right)", by.latex(), of.latex());
        Ok(Sym::named(&format!("d({of})/d({by})"), &latex))
    }

    fn circle(&self, angle: Sym) -> (Sym, Sym) {
        let point = angle.circle_as_written();
        (point.cos, point.sin)
    }
}
