//! The model description of a unit of FMI 2.0. Its structure refers to variables by their index from 1, not by their value reference.

use super::{Attributes, Kind, Listed, Xml, begun, element, empty, measures};
use crate::fmu::{Unit, Version};
use std::io;

/// The file `modelDescription.xml`.
pub(super) fn description(unit: &Unit) -> io::Result<Vec<u8>> {
    // event indicators are not variables in FMI 2.0; they are the last ones, so that other indices do not change
    let variables: Vec<Listed<'_>> =
        unit.variables().into_iter().filter(|variable| variable.kind != Kind::Indicator).collect();
    let mut xml = begun()?;
    let root = [
        ("fmiVersion", "2.0".to_owned()),
        ("modelName", unit.title.clone()),
        ("guid", unit.token()),
        ("description", unit.origin.clone()),
        ("generationTool", unit.tool.clone()),
        ("variableNamingConvention", "flat".to_owned()),
        ("numberOfEventIndicators", unit.indicators.len().to_string()),
    ];
    let offers = || -> Attributes {
        vec![
            ("modelIdentifier", unit.identifier.clone()),
            ("canNotUseMemoryManagementFunctions", "true".to_owned()),
            ("canGetAndSetFMUstate", "true".to_owned()),
            ("providesDirectionalDerivative", "true".to_owned()),
        ]
    };
    let sources = |xml: &mut Xml| {
        element(xml, "SourceFiles", &[], |xml| empty(xml, "File", &[("name", Version::Two.main_source().to_owned())]))
    };
    element(&mut xml, "fmiModelDescription", &root, |xml| {
        element(xml, "ModelExchange", &offers(), sources)?;
        let mut steps = offers();
        steps.push(("canHandleVariableCommunicationStepSize", "true".to_owned()));
        element(xml, "CoSimulation", &steps, sources)?;
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

fn written(xml: &mut Xml, reference: usize, variable: &Listed<'_>) -> io::Result<()> {
    element(xml, "ScalarVariable", &variable.attributes(reference), |xml| {
        let mut attributes = variable.unit_and_start();
        if let Kind::Derivative(of) = variable.kind {
            attributes.push(("derivative", (of + 1).to_string()));
        }
        empty(xml, "Real", &attributes)
    })
}

/// The model structure: outputs, derivatives of states, initial unknowns.
fn structure(xml: &mut Xml, variables: &[Listed<'_>]) -> io::Result<()> {
    let is_derivative = |kind: Kind| matches!(kind, Kind::Derivative(_));
    let is_output = |kind: Kind| kind == Kind::Output;
    let parts: [(&str, &dyn Fn(Kind) -> bool); 3] = [
        ("Outputs", &is_output),
        ("Derivatives", &is_derivative),
        ("InitialUnknowns", &|kind| is_output(kind) || is_derivative(kind)),
    ];
    for (name, is_of) in parts {
        let mut places = (0..variables.len()).filter(|place| is_of(variables[*place].kind)).peekable();
        if places.peek().is_some() {
            element(xml, name, &[], |xml| {
                places.try_for_each(|place| empty(xml, "Unknown", &[("index", (place + 1).to_string())]))
            })?;
        }
    }
    Ok(())
}
