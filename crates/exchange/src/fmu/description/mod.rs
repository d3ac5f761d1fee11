//! The model description of a unit: its variables with their causality and variability, and its structure (states, derivatives, outputs).

mod version_2;
mod version_3;

use super::{Unit, Variable, Version};
use quick_xml::Writer;
use quick_xml::events::{BytesDecl, Event};
use std::collections::BTreeSet;
use std::io;

/// A variable of the model description.
struct Listed<'a> {
    name: String,
    unit: &'a str,
    description: &'a str,
    kind: Kind,
    /// The initial value, in `unit`; `None` for a computed variable.
    start: Option<f64>,
}

/// The kind of a variable.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Time,
    State,
    /// The derivative of the state with this value reference.
    Derivative(usize),
    Parameter,
    Input,
    Output,
    Local,
    Indicator,
}

type Attributes = Vec<(&'static str, String)>;

impl Unit {
    /// The file `modelDescription.xml`.
    pub(super) fn description(&self) -> io::Result<Vec<u8>> {
        match self.version {
            Version::Two => version_2::description(self),
            Version::Three => version_3::description(self),
        }
    }

    /// The file `buildDescription.xml`; `None` for FMI 2.0, which has no such file.
    pub(super) fn build_description(&self) -> io::Result<Option<Vec<u8>>> {
        match self.version {
            Version::Two => Ok(None),
            Version::Three => version_3::build_description(self).map(Some),
        }
    }

    /// The times and the tolerance of a default simulation.
    fn experiment(&self) -> Attributes {
        let experiment = [("startTime", 0.0), ("stopTime", self.span), ("tolerance", self.tolerance)];
        experiment.into_iter().map(|(name, value)| (name, format!("{value:?}"))).collect()
    }

    /// All variables in the order of their value references.
    fn variables(&self) -> Vec<Listed<'_>> {
        let listed = |kind: Kind| move |variable| Listed::of(variable, kind);
        let rates = |(place, state): (usize, &Variable)| (place, format!("der({})", state.name));
        let time = Listed { name: "time".to_owned(), unit: "s", description: "", kind: Kind::Time, start: None };
        let derivatives = self.states.iter().enumerate().map(rates).map(|(place, name)| Listed {
            name,
            unit: "",
            description: "",
            kind: Kind::Derivative(place + 1),
            start: None,
        });
        let mut all: Vec<Listed<'_>> = std::iter::once(time)
            .chain(self.states.iter().map(listed(Kind::State)))
            .chain(derivatives)
            .chain(self.parameters.iter().map(listed(Kind::Parameter)))
            .chain(self.inputs.iter().map(listed(Kind::Input)))
            .chain(self.outputs.iter().map(listed(Kind::Output)))
            .chain(self.locals.iter().map(listed(Kind::Local)))
            .chain(self.indicators.iter().map(listed(Kind::Indicator)))
            .collect();
        // a name that the standard uses for another variable gets a suffix
        let mut own: Vec<usize> = (0..all.len()).collect();
        own.sort_by_key(|&place| {
            matches!(all[place].kind, Kind::Time | Kind::Derivative(_) | Kind::Local | Kind::Indicator)
        });
        let mut taken = BTreeSet::new();
        for place in own {
            while !taken.insert(all[place].name.clone()) {
                all[place].name.push('_');
            }
        }
        all
    }
}

impl<'a> Listed<'a> {
    fn of(variable: &'a Variable, kind: Kind) -> Self {
        let Variable { name, unit, description, value } = variable;
        let start = matches!(kind, Kind::State | Kind::Parameter | Kind::Input).then_some(*value);
        Listed { name: name.clone(), unit, description, kind, start }
    }

    /// The causality, the variability and the kind of initial value in the words of the standard.
    fn words(&self) -> (&'static str, &'static str, Option<&'static str>) {
        match self.kind {
            Kind::Time => ("independent", "continuous", None),
            Kind::State => ("local", "continuous", Some("exact")),
            Kind::Parameter => ("parameter", "tunable", Some("exact")),
            Kind::Input => ("input", "continuous", None),
            Kind::Output => ("output", "continuous", Some("calculated")),
            Kind::Derivative(_) | Kind::Local | Kind::Indicator => ("local", "continuous", Some("calculated")),
        }
    }

    /// The attributes of a variable that both versions of the standard have in common.
    fn attributes(&self, reference: usize) -> Attributes {
        let (causality, variability, initial) = self.words();
        let mut attributes: Attributes = vec![("name", self.name.clone()), ("valueReference", reference.to_string())];
        if !self.description.is_empty() {
            attributes.push(("description", self.description.to_owned()));
        }
        attributes.extend([("causality", causality.to_owned()), ("variability", variability.to_owned())]);
        attributes.extend(initial.map(|initial| ("initial", initial.to_owned())));
        attributes
    }

    /// The attributes for the unit and the initial value, if there are any.
    fn unit_and_start(&self) -> Attributes {
        let unit = Some(self.unit).filter(|unit| !matches!(*unit, "" | "1")).map(|unit| ("unit", unit.to_owned()));
        unit.into_iter().chain(self.start.map(|start| ("start", format!("{start:?}")))).collect()
    }
}

/// Writes the units of the variables, each once, in terms of SI base units.
fn measures(xml: &mut Xml, variables: &[Listed<'_>]) -> io::Result<()> {
    let names: BTreeSet<&str> =
        variables.iter().map(|variable| variable.unit).filter(|unit| !matches!(*unit, "" | "1")).collect();
    names.into_iter().try_for_each(|name| {
        let Ok(parsed) = units::Unit::parse(name) else { return empty(xml, "Unit", &[("name", name.to_owned())]) };
        let exponents = ["kg", "m", "s", "A"].into_iter().zip(parsed.dimension().exponents());
        let mut base: Attributes =
            exponents.filter(|(_, power)| *power != 0).map(|(of, power)| (of, power.to_string())).collect();
        let [times, per] = parsed.factors();
        if times != per {
            base.push(("factor", format!("{:?}", times / per)));
        }
        element(xml, "Unit", &[("name", name.to_owned())], |xml| empty(xml, "BaseUnit", &base))
    })
}

type Xml = Writer<Vec<u8>>;

fn begun() -> io::Result<Xml> {
    let mut xml = Writer::new_with_indent(Vec::new(), b' ', 2);
    xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    Ok(xml)
}

/// The text of an attribute, with control characters replaced by spaces.
fn plain(text: &str) -> String {
    text.chars().map(|letter| if letter.is_control() { ' ' } else { letter }).collect()
}

fn element(
    xml: &mut Xml,
    name: &str,
    attributes: &[(&'static str, String)],
    content: impl FnOnce(&mut Xml) -> io::Result<()>,
) -> io::Result<()> {
    let attributes: Vec<(&str, String)> = attributes.iter().map(|(name, value)| (*name, plain(value))).collect();
    let attributes = attributes.iter().map(|(name, value)| (*name, value.as_str()));
    xml.create_element(name).with_attributes(attributes).write_inner_content(content)?;
    Ok(())
}

fn empty(xml: &mut Xml, name: &str, attributes: &[(&'static str, String)]) -> io::Result<()> {
    let attributes: Vec<(&str, String)> = attributes.iter().map(|(name, value)| (*name, plain(value))).collect();
    let attributes = attributes.iter().map(|(name, value)| (*name, value.as_str()));
    xml.create_element(name).with_attributes(attributes).write_empty()?;
    Ok(())
}
