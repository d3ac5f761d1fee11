//! The bodies of a scene.

use nalgebra::Vector3;
use reader::{At, Issue, Table};
use std::ops::Range;
use systems::gyrostat::admissible::Inadmissible;
use systems::gyrostat::{Carrier, Gyrostat, Rotor};

/// Reads carrier, rotor and gravity; `None` where such bodies cannot exist.
pub fn gyrostat(top: &mut Table<'_>, issues: &mut Vec<Issue>) -> Option<Gyrostat<f64>> {
    let gravity = top.scalar("gravity", "acceleration of gravity", "m/s^2");

    let mut table = top.table("carrier", "the body with the fixed point O: mass, centre, inertia");
    let mass = table.scalar("mass", "mass of the carrier", "kg");
    let centre = table.vector("centre", "vector from O to the carrier's centre of mass", "m");
    let inertia = table.matrix("inertia", "inertia tensor of the carrier about O", "kg m^2");
    let carrier_found = table.exists();
    issues.extend(table.finish());

    let mut table = top.table("rotor", "the balanced rotor: mass, centre, axis, axial, transverse");
    let rotor_mass = table.scalar("mass", "mass of the rotor", "kg");
    let rotor_centre = table.vector("centre", "vector from O to the rotor's centre of mass", "m");
    let axis = table.vector("axis", "unit vector of the rotor's axis", "1");
    let axial = table.scalar("axial", "moment of inertia of the rotor about its axis", "kg m^2");
    let transverse = table.scalar("transverse", "moment of inertia of the rotor across its axis", "kg m^2");
    let complete = carrier_found && table.exists() && !table.has_issues();
    issues.extend(table.finish());

    let gyrostat = Gyrostat {
        carrier: Carrier { mass: mass.value, centre: centre.value, inertia: inertia.value },
        rotor: Rotor {
            mass: rotor_mass.value,
            centre: rotor_centre.value,
            axis: axis.value,
            axial: axial.value,
            transverse: transverse.value,
        },
        gravity: gravity.value,
    };
    // after invalid data a judgement on the bodies would be meaningless
    if !complete || !issues.is_empty() || top.has_issues() {
        return None;
    }
    let Err(broken) = gyrostat.admissible() else { return Some(gyrostat) };
    let size = |data: &[f64]| data.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let sizes = [
        (size(&[gravity.value]), &gravity.span),
        (size(&[mass.value]), &mass.span),
        (size(centre.value.as_slice()), &centre.span),
        (size(inertia.value.as_slice()), &inertia.span),
        (size(&[rotor_mass.value]), &rotor_mass.span),
        (size(rotor_centre.value.as_slice()), &rotor_centre.span),
        (size(&[axial.value]), &axial.span),
        (size(&[transverse.value]), &transverse.span),
    ];
    let largest = sizes.into_iter().max_by(|a, b| a.0.total_cmp(&b.0)).map_or(0..0, |(_, span)| span.clone());
    let places = Places {
        largest,
        gravity: gravity.span,
        carrier_mass: mass.span,
        inertia: inertia.span,
        rotor_mass: rotor_mass.span,
        axis,
        axial: axial.span,
        transverse: transverse.span,
    };
    // one datum beyond the range makes all derived quantities infinite: only that cause is reported
    let mut beyond = broken.iter().filter(|condition| matches!(condition, Inadmissible::NotFinite { .. }));
    match beyond.next() {
        Some(first) => issues.push(places.issue(first)),
        None => issues.extend(broken.iter().map(|condition| places.issue(condition))),
    }
    None
}

/// Reads the axial moment of inertia of a rotor in a housing at rest, kg m^2.
pub fn bench(top: &mut Table<'_>, issues: &mut Vec<Issue>) -> Option<f64> {
    let mut table = top.table("rotor", "the rotor's moment of inertia: axial");
    let axial = table.scalar("axial", "moment of inertia of the rotor about its axis", "kg m^2");
    if axial.value <= 0.0 {
        let issue = Issue::at(axial.span, "A' > 0 is broken", format!("it is {}", axial.value));
        table.report(issue.accepted("a positive moment of inertia is accepted"));
    }
    let sound = table.exists() && !table.has_issues();
    issues.extend(table.finish());
    sound.then_some(axial.value)
}

/// The positions in the file of the data of the conditions.
struct Places {
    /// The datum with the largest number.
    largest: Range<usize>,
    gravity: Range<usize>,
    carrier_mass: Range<usize>,
    inertia: Range<usize>,
    rotor_mass: Range<usize>,
    axis: At<Vector3<f64>>,
    axial: Range<usize>,
    transverse: Range<usize>,
}

impl Places {
    fn issue(&self, condition: &Inadmissible) -> Issue {
        use Inadmissible as Is;
        let (span, accepted) = match condition {
            Is::NotFinite { .. } => {
                let accepted = "a smaller value is accepted: products of the data must be in the range of numbers";
                (&self.largest, accepted.to_owned())
            }
            Is::NotPositive { quantity, .. } => {
                let span = match *quantity {
                    "m0" => &self.carrier_mass,
                    "m'" => &self.rotor_mass,
                    "A'" => &self.axial,
                    _ => &self.transverse,
                };
                (span, "a positive value is accepted".to_owned())
            }
            Is::NegativeGravity { .. } => (&self.gravity, "zero or a positive value is accepted".to_owned()),
            Is::AxisNotUnit { .. } => (&self.axis.span, normalised(&self.axis.value)),
            Is::NotSymmetric { .. } => (&self.inertia, "a symmetric tensor about O is accepted".to_owned()),
            Is::Indefinite { .. } => (&self.inertia, "a tensor with positive principal moments is accepted".to_owned()),
            Is::Triangle { .. } => (
                &self.inertia,
                "moments J1 <= J2 + J3 are accepted, about O and, after m0 (c0.c0 - c0 c0) is taken off, about the centre \
                 of mass"
                    .to_owned(),
            ),
            Is::RotorTriangle { .. } => (&self.axial, "at most twice the transverse moment is accepted".to_owned()),
            Is::Undetermined { .. } => {
                (&self.inertia, "a carrier whose mass does not all lie on the rotor's axis is accepted".to_owned())
            }
        };
        let problem = match condition {
            Is::Undetermined { .. } => "the motion is not determined",
            Is::NotFinite { .. } => "what follows from this value is beyond the range of numbers",
            _ => "no such body exists",
        };
        Issue::at(span.clone(), problem, condition.to_string()).accepted(accepted)
    }
}

/// The hint with the accepted unit vector in the direction of another vector.
pub fn normalised(vector: &Vector3<f64>) -> String {
    match vector.try_normalize(0.0).filter(|unit| unit.iter().all(|x| x.is_finite())) {
        Some(unit) => format!("accepted in this direction: \"{} {} {}\"", unit.x, unit.y, unit.z),
        None => "a vector of length 1 is accepted, such as \"0 0 1\"".to_owned(),
    }
}
