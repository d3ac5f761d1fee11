//! Faults of systems that no motion can start from, each with its place in the file.

use crate::modes::{NEGATIVE, RESTITUTION, Refused, Unfit};
use crate::readiness::refused;
use crate::row_units::measured;
use model::Model;
use reader::Issue;

/// The fault of a start from which the modes of the system give no motion.
pub(crate) fn not_started(model: &Model, why: Refused) -> Issue {
    match why {
        Refused::Law(reason) => refused(model, &reason),
        Refused::Contact(Unfit { contact, why, accepted, found }) => {
            let one = &model.contacts[contact];
            let title = format!("this system cannot start: {why}");
            let found = found.map_or_else(String::new, |(value, unit)| format!(": {}", measured(value, unit)));
            let place = match why {
                NEGATIVE => &one.friction_at,
                RESTITUTION => &one.restitution_at,
                _ => &one.at,
            };
            Issue::at(place.clone(), title, one.title(contact) + &found).accepted(accepted)
        }
        Refused::Motion { why, switch: None } if !model.contacts.is_empty() => {
            let places = model.contacts.iter().map(|contact| &contact.at);
            let place =
                places.clone().map(|at| at.start).min().unwrap_or(0)..places.map(|at| at.end).max().unwrap_or(0);
            let issue = Issue::at(place, format!("this system cannot start: {why}"), "these contacts");
            issue.accepted("another start, or other coefficients of friction; `dalembert regimes` lists the regimes that agree with it")
        }
        Refused::Motion { why, switch } => {
            let place = switch.map_or(0..0, |switch| model.switch_places[switch].clone());
            let issue = Issue::at(place, format!("this system cannot start: {why}"), "this is at zero at the start");
            let accepted =
                "another start: the conditions of `if`, `sign`, `abs`, `min`, `max` and `table` choose its law";
            match switch.and_then(|switch| model.coordinate_of_switch(switch)) {
                Some(name) => issue.accepted(format!(
                    "`{name}'`, if the sign of a speed is meant, as in dry friction -F*sign({name}'); or {accepted}"
                )),
                None => issue.accepted(accepted),
            }
        }
    }
}
