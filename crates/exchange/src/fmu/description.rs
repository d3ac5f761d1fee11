//! The description of a unit: its variables with their causality and variability, and the states, derivatives and outputs among them.

use super::{Unit, Variable};
use quick_xml::Writer;
use quick_xml::events::{BytesDecl, Event};
use std::collections::BTreeSet;
use std::io;

/// A variable with the attributes of its kind in the standard.
struct Listed<'a> {
    name: String,
    unit: &'a str,
    description: &'a str,
    kind: Kind,
    start: Option<f64>,
}

/// The kind of a variable.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Time,
    State,
    /// The rate of the state with this value reference.
    Derivative(usize),
    Parameter,
    Input,
    Output,
    Local,
    Indicator,
}

type Attributes = Vec<(&'static str, String)>;

impl Unit {
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
        // a name of the standard that the system uses too is changed
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

    /// `modelDescription.xml`.
    pub(super) fn description(&self) -> io::Result<Vec<u8>> {
        let variables = self.variables();
        let mut xml = begun()?;
        let root = [
            ("fmiVersion", "3.0".to_owned()),
            ("modelName", self.title.clone()),
            ("instantiationToken", self.token()),
            ("description", self.origin.clone()),
            ("generationTool", self.tool.clone()),
            ("variableNamingConvention", "flat".to_owned()),
        ];
        let offers = || -> Attributes {
            vec![
                ("modelIdentifier", self.identifier.clone()),
                ("canGetAndSetFMUState", "true".to_owned()),
                ("providesDirectionalDerivatives", "true".to_owned()),
            ]
        };
        element(&mut xml, "fmiModelDescription", &root, |xml| {
            let mut exchange = offers();
            exchange.push(("needsCompletedIntegratorStep", "true".to_owned()));
            empty(xml, "ModelExchange", &exchange)?;
            let mut steps = offers();
            steps.push(("canHandleVariableCommunicationStepSize", "true".to_owned()));
            empty(xml, "CoSimulation", &steps)?;
            element(xml, "UnitDefinitions", &[], |xml| measures(xml, &variables))?;
            element(xml, "LogCategories", &[], |xml| empty(xml, "Category", &[("name", "system".to_owned())]))?;
            let experiment = [("startTime", 0.0), ("stopTime", self.span), ("tolerance", self.tolerance)];
            let experiment: Attributes =
                experiment.into_iter().map(|(name, value)| (name, format!("{value:?}"))).collect();
            empty(xml, "DefaultExperiment", &experiment)?;
            element(xml, "ModelVariables", &[], |xml| {
                variables.iter().enumerate().try_for_each(|(place, variable)| variable.write(xml, place))
            })?;
            element(xml, "ModelStructure", &[], |xml| structure(xml, &variables))
        })?;
        Ok(xml.into_inner())
    }

    /// `buildDescription.xml`.
    pub(super) fn build_description(&self) -> io::Result<Vec<u8>> {
        let mut xml = begun()?;
        element(&mut xml, "fmiBuildDescription", &[("fmiVersion", "3.0".to_owned())], |xml| {
            element(xml, "BuildConfiguration", &[("modelIdentifier", self.identifier.clone())], |xml| {
                element(xml, "SourceFileSet", &[("language", "C99".to_owned())], |xml| {
                    empty(xml, "SourceFile", &[("name", "fmi3.c".to_owned())])
                })?;
                empty(xml, "Library", &[("name", "m".to_owned())])
            })
        })?;
        Ok(xml.into_inner())
    }
}

impl<'a> Listed<'a> {
    fn of(variable: &'a Variable, kind: Kind) -> Self {
        let Variable { name, unit, description, value } = variable;
        let start = matches!(kind, Kind::State | Kind::Parameter | Kind::Input).then_some(*value);
        Listed { name: name.clone(), unit, description, kind, start }
    }

    fn write(&self, xml: &mut Xml, reference: usize) -> io::Result<()> {
        let mut attributes: Attributes = vec![("name", self.name.clone()), ("valueReference", reference.to_string())];
        let (causality, variability, initial) = match self.kind {
            Kind::Time => ("independent", "continuous", None),
            Kind::State => ("local", "continuous", Some("exact")),
            Kind::Parameter => ("parameter", "tunable", Some("exact")),
            Kind::Input => ("input", "continuous", None),
            Kind::Output => ("output", "continuous", Some("calculated")),
            Kind::Derivative(_) | Kind::Local | Kind::Indicator => ("local", "continuous", Some("calculated")),
        };
        if !self.description.is_empty() {
            attributes.push(("description", self.description.to_owned()));
        }
        attributes.extend([("causality", causality.to_owned()), ("variability", variability.to_owned())]);
        attributes.extend(initial.map(|initial| ("initial", initial.to_owned())));
        if !self.unit.is_empty() && self.unit != "1" {
            attributes.push(("unit", self.unit.to_owned()));
        }
        attributes.extend(self.start.map(|start| ("start", format!("{start:?}"))));
        if let Kind::Derivative(of) = self.kind {
            attributes.push(("derivative", of.to_string()));
        }
        empty(xml, "Float64", &attributes)
    }
}

/// The units of variables, each once, by the base units of SI.
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

/// The model structure: outputs, derivatives of states, initial unknowns, event indicators.
fn structure(xml: &mut Xml, variables: &[Listed<'_>]) -> io::Result<()> {
    let is_derivative = |kind: Kind| matches!(kind, Kind::Derivative(_));
    let is_output = |kind: Kind| kind == Kind::Output;
    let parts: [(&str, &dyn Fn(Kind) -> bool); 4] = [
        ("Output", &is_output),
        ("ContinuousStateDerivative", &is_derivative),
        ("InitialUnknown", &|kind| is_output(kind) || is_derivative(kind)),
        ("EventIndicator", &|kind| kind == Kind::Indicator),
    ];
    for (name, is_of) in parts {
        for (reference, _) in variables.iter().enumerate().filter(|(_, variable)| is_of(variable.kind)) {
            empty(xml, name, &[("valueReference", reference.to_string())])?;
        }
    }
    Ok(())
}

type Xml = Writer<Vec<u8>>;

fn begun() -> io::Result<Xml> {
    let mut xml = Writer::new_with_indent(Vec::new(), b' ', 2);
    xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    Ok(xml)
}

/// An attribute without characters that XML cannot contain.
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
