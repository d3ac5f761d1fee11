//! The model description of a unit of FMI 3.0.

use super::{Attributes, Kind, Listed, Xml, begun, element, empty, measures};
use crate::fmu::Unit;
use std::io;

/// The file `modelDescription.xml`.
pub(super) fn description(unit: &Unit) -> io::Result<Vec<u8>> {
    let variables = unit.variables();
    let mut xml = begun()?;
    let root = [
        ("fmiVersion", "3.0".to_owned()),
        ("modelName", unit.title.clone()),
        ("instantiationToken", unit.token()),
        ("description", unit.origin.clone()),
        ("generationTool", unit.tool.clone()),
        ("variableNamingConvention", "flat".to_owned()),
    ];
    let offers = || -> Attributes {
        vec![
            ("modelIdentifier", unit.identifier.clone()),
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
        empty(xml, "DefaultExperiment", &unit.experiment())?;
        element(xml, "ModelVariables", &[], |xml| {
            variables.iter().enumerate().try_for_each(|(place, variable)| written(xml, place, variable))
        })?;
        element(xml, "ModelStructure", &[], |xml| structure(xml, &variables))
    })?;
    Ok(xml.into_inner())
}

/// The file `buildDescription.xml`.
pub(super) fn build_description(unit: &Unit) -> io::Result<Vec<u8>> {
    let mut xml = begun()?;
    element(&mut xml, "fmiBuildDescription", &[("fmiVersion", "3.0".to_owned())], |xml| {
        element(xml, "BuildConfiguration", &[("modelIdentifier", unit.identifier.clone())], |xml| {
            element(xml, "SourceFileSet", &[("language", "C99".to_owned())], |xml| {
                empty(xml, "SourceFile", &[("name", "fmi3.c".to_owned())])
            })?;
            empty(xml, "Library", &[("name", "m".to_owned())])
        })
    })?;
    Ok(xml.into_inner())
}

fn written(xml: &mut Xml, reference: usize, variable: &Listed<'_>) -> io::Result<()> {
    let mut attributes = variable.attributes(reference);
    attributes.extend(variable.unit_and_start());
    if let Kind::Derivative(of) = variable.kind {
        attributes.push(("derivative", of.to_string()));
    }
    empty(xml, "Float64", &attributes)
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
