//! Parser of the table `[failure]` of a scene.

use super::{FailureEntry, MARGIN, THRESHOLD, Varied};
use crate::letters::Letters;
use crate::quoted_keys::with_quoted_primes;
use crate::row_units::unit_of;
use crate::scene::{Given, ModelScene};
use field::Rational;
use model::{Entry, Text, Trace};
use reader::{At, Issue, SceneError, Table, tables};
use simulation::FailureKind;
use std::collections::BTreeSet;
use symbolic::{Sym, apart};
use units::Dimension;

/// The default for `within`.
const WITHIN: usize = 1_000;

/// The largest number of digits of a printed fraction.
const MOST_DIGITS: usize = 24;

/// The values of the keys of `[failure]`.
struct Keys {
    texts: [String; 5],
    threshold: At<String>,
    margin: Option<At<String>>,
    vary: At<String>,
    between: [At<(f64, Dimension)>; 2],
    expects: Option<FailureKind>,
    within: u32,
    outputs: Vec<Entry>,
}

impl FailureEntry {
    /// Reads a scene with the table `[failure]`; `name` is the name of the file in messages.
    ///
    /// # Errors
    /// The file has errors; each is given with its position.
    pub fn parse(name: &str, text: &str) -> Result<Self, SceneError> {
        let read = tables(name, text, |top, issues| {
            top.known(&["ensemble"]);
            let mut table = top.table("failure", "the way in which this scene fails");
            let keys = Keys::read(&mut table);
            let sound = table.exists() && !table.has_issues();
            issues.extend(table.finish());
            let keys = keys.filter(|_| sound);
            let outputs = keys.as_ref().map_or_else(Vec::new, |keys| keys.outputs.clone());
            let scene = ModelScene::read_with(top, issues, text, Given { outputs, ..Given::default() })?;
            keys?.entry(scene).map_err(|issue| issues.push(issue)).ok()
        });
        read.map_err(with_quoted_primes)
    }
}

impl Keys {
    fn read(table: &mut Table<'_>) -> Option<Self> {
        let texts = [
            ("name", "the name by which `dalembert failures` calls it"),
            ("title", "what goes wrong, in one line"),
            ("why", "why it must happen"),
            ("advice", "what to do, in one sentence"),
            ("of", "what is at the threshold"),
        ];
        let texts =
            texts.map(|(key, needed)| table.text(key, needed).value.split_whitespace().collect::<Vec<_>>().join(" "));
        let vary = table.text("vary", "\"step\", \"span\", or the name of a parameter or of a value in [start]");
        let threshold = table.text("threshold", "an expression of the parameters");
        let margin = table.optional_text("while", "an expression that is positive while the run counts as successful");
        let expects = table.optional_text("expects", "the name of a failure");
        let within =
            table.optional_count("within", "one by the part of the threshold to which runs agree", 10, 1_000_000);
        let [holds, fails] = ["holds_at", "fails_at"].map(|key| {
            // reading a key as text reports it if missing
            if !table.has(key) {
                table.text(key, "a value with its unit, such as \"0.1 s\"");
            }
            table.of_any_unit(key)
        });
        let expects = expects.and_then(|At { value, span }| {
            let found = FailureKind::ALL.into_iter().find(|kind| short(*kind) == value);
            if found.is_none() {
                let known: Vec<&str> = FailureKind::ALL.into_iter().map(short).collect();
                let issue = Issue::at(span, format!("no failure is called `{value}`"), "not known");
                table.report(issue.accepted(format!("known: {}", known.join(", "))));
            }
            found
        });
        let output = |table: &Table<'_>, name: &str, text: &At<String>| {
            let start = table.part(text, &(0..0)).start;
            Entry { name: Text::at(name, start), value: Text::at(text.value.clone(), start) }
        };
        let mut outputs = vec![output(table, THRESHOLD, &threshold)];
        outputs.extend(margin.as_ref().map(|margin| output(table, MARGIN, margin)));
        let within = within.map_or(WITHIN, |within| within.value) as u32;
        Some(Keys { texts, threshold, margin, vary, between: [holds?, fails?], expects, within, outputs })
    }

    /// The entry for a scene that contains the expressions as outputs.
    ///
    /// # Errors
    /// Dimensions do not agree, the threshold depends on the motion, or it does not lie between `holds_at` and `fails_at`.
    fn entry(self, scene: ModelScene) -> Result<FailureEntry, Issue> {
        let Keys { texts: [name, title, why, advice, of], threshold, margin, vary, between, expects, within, .. } =
            self;
        let (varies, dimension) = varied(&scene, &vary)?;
        for At { value: (_, found), span } in &between {
            if *found != dimension {
                let title = format!("`{}` is varied, and this is no value of it", vary.value);
                return Err(Issue::at(span.clone(), title, format!("its unit is {}", found.coherent()))
                    .accepted(format!("a value in {}", dimension.coherent())));
            }
        }
        let output = scene.model.outputs.iter().find(|output| output.name == THRESHOLD);
        let found = output.map(|output| output.dimension);
        if found != Some(dimension.of_expressions()) {
            let is = found.map_or_else(|| "none".to_owned(), |found| found.to_string());
            let title = format!("the threshold is no value of `{}`", vary.value);
            return Err(Issue::at(threshold.span, title, format!("its dimension is {is}"))
                .accepted(format!("an expression whose unit is {}", dimension.coherent())));
        }
        let (exact, written, value) = evaluated(&scene).map_err(|moves| {
            Issue::at(threshold.span.clone(), "the threshold depends on the motion", format!("by {moves}"))
                .accepted("an expression of parameters")
        })?;
        let [holds, fails] = between.map(|at| at.value.0);
        if !((holds < value && value < fails) || (fails < value && value < holds)) {
            let title = "the threshold does not lie between `holds_at` and `fails_at`";
            return Err(Issue::at(threshold.span, title, format!("it is {value} in SI units"))
                .accepted("two values with the threshold between them"));
        }
        let unit = match dimension.is_number() {
            true => String::new(),
            false => unit_of(&scene.model, THRESHOLD),
        };
        let margin = margin.map(|margin| margin.value);
        let formula = threshold.value;
        let between = [holds, fails];
        Ok(FailureEntry {
            name,
            title,
            why,
            advice,
            of,
            formula,
            exact,
            written,
            threshold: value,
            unit,
            within,
            margin,
            expects,
            between,
            varies,
            scene,
        })
    }
}

/// The name of a failure without the explanation after the colon.
fn short(kind: FailureKind) -> &'static str {
    kind.name().split(':').next().unwrap_or_default()
}

/// The varied number and its dimension.
fn varied(scene: &ModelScene, At { value, span }: &At<String>) -> Result<(Varied, Dimension), Issue> {
    let parameter = scene.model.parameters.iter().find(|parameter| parameter.name == *value);
    if let Some(parameter) = parameter {
        return Ok((Varied::Value(value.clone()), Dimension::of(&parameter.unit)));
    }
    let states = scene.model.state_names();
    if let Some((_, unit)) = states.iter().find(|(name, _)| name == value) {
        return Ok((Varied::Value(value.clone()), Dimension::of(unit)));
    }
    match value.as_str() {
        "span" => Ok((Varied::Span, Dimension::of("s"))),
        "step" if scene.run.method.steps().is_some() => Ok((Varied::Step, Dimension::of("s"))),
        "step" => Err(Issue::at(span.clone(), "the method of this scene has no constant step", "`step` is varied")
            .accepted("a method with a constant step in [run], such as \"runge_kutta_4:1000\"")),
        _ => {
            let known = scene.model.parameters.iter().map(|one| &one.name).chain(states.iter().map(|(name, _)| name));
            let known: BTreeSet<&str> = known.map(String::as_str).collect();
            let known: Vec<&str> = known.into_iter().collect();
            Err(Issue::at(span.clone(), format!("nothing is called `{value}`"), "it cannot be varied")
                .accepted(format!("step, span, or one of {}", known.join(", "))))
        }
    }
}

/// The threshold as a fraction, as text, and as a number in SI units.
///
/// # Errors
/// The letter of the motion on which the threshold depends.
fn evaluated(scene: &ModelScene) -> Result<(Option<Rational>, String, f64), String> {
    let model = &*scene.model;
    let place = model.outputs.iter().position(|output| output.name == THRESHOLD).unwrap_or_default();
    let value = scene.system.outputs(0.0, &scene.start)[place];
    apart(|| {
        let trace = Trace::of(model);
        let state: Vec<Sym> = trace.coordinates.iter().chain(&trace.speeds).copied().collect();
        // exact decimals of the file instead of doubles
        let data = model.parameters.iter().zip(&trace.parameters);
        let data: Vec<Sym> = data
            .map(|(own, letter)| own.value.map_or(*letter, |value| Sym::constant(Rational::decimal(value))))
            .collect();
        let letters = Letters::with_parameters(trace.time, &state, &data);
        let exact = letters.put_into(&trace, &[trace.scalar(model.outputs[place].is)])[0];
        if let Some(letter) = exact.symbols_of().first() {
            return Err(format!("`{letter}`"));
        }
        let number = exact.as_constant().filter(|number| number.to_string().len() <= MOST_DIGITS);
        Ok((number, exact.to_string(), value))
    })
}
