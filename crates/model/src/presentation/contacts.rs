//! Contacts for a reader: their symbols and their laws.

use super::matrix_form::MatrixForm;
use super::{reading_of, simplified, vectors};
use crate::equations::{balances, constraints_of};
use crate::{Contact, Restitution, Sides, Trace};
use symbolic::Sym;

/// Returns inputs without a value, and reactions of contacts, each with its unit.
pub(super) fn open_letters(trace: &Trace<'_>) -> Vec<(Sym, String)> {
    let open = trace.model.inputs.iter().filter(|input| input.value.is_none());
    let open = open.map(|input| (Sym::symbol(&input.name), input.unit.clone()));
    let reactions = (0..trace.model.contacts.len()).flat_map(|place| {
        let unit = &trace.model.contacts[place].reaction_unit;
        letters_of(trace, place).into_iter().map(move |letter| (letter, unit.clone()))
    });
    open.chain(reactions).collect()
}

/// Returns the symbol N, and for a contact with friction also T.
fn letters_of(trace: &Trace<'_>, place: usize) -> Vec<Sym> {
    let contact = &trace.model.contacts[place];
    let count = if contact.friction.is_some() { contact.reactions.len() } else { 1 };
    (0..count).map(|component| trace.reaction(place, component)).collect()
}

/// Returns lines with Coulomb's law of a contact.
fn coulomb(trace: &Trace<'_>, place: usize, friction: &str) -> Vec<String> {
    let contact = &trace.model.contacts[place];
    let slides = contact.slides.iter().map(|&slide| simplified(trace.scalar(slide)).decimal_text());
    let slides: Vec<String> = slides.collect();
    let letters: Vec<Sym> = (0..contact.reactions.len()).map(|component| trace.reaction(place, component)).collect();
    let mut reading = reading_of(trace);
    let mut direction = |tangent: usize| vectors::of(trace, &mut reading, trace.vector(contact.tangents[tangent]));
    match (slides.as_slice(), letters.as_slice()) {
        ([first, second], [normal, one, other]) => vec![
            format!("  v1 = {first}, v2 = {second}, the sliding velocity along the tangents t1 and t2"),
            format!("  t1 = {}, t2 = {}", direction(0), direction(1)),
            format!(
                "  where v1 = v2 = 0, sqrt({one}^2 + {other}^2) <= {friction}*|{normal}|, else ({one}, {other}) = \
                 -{friction}*|{normal}|*(v1, v2)/sqrt(v1^2 + v2^2)"
            ),
        ],
        ([slide], [normal, tangent]) => vec![
            format!("  v = {slide}, the sliding velocity"),
            format!(
                "  where v = 0, |{tangent}| <= {friction}*|{normal}|, else {tangent} = -{friction}*|{normal}|*sign(v)"
            ),
        ],
        _ => Vec::new(),
    }
}

/// Returns the laws of the contacts, several lines for each.
pub(super) fn laws(trace: &Trace<'_>, form: &MatrixForm) -> Vec<String> {
    let multipliers = constraints_of(trace).into_iter().map(|one| one.multiplier);
    let multipliers: Vec<(Sym, Sym)> = multipliers.zip(form.multipliers.iter().copied()).collect();
    let balances = balances(trace).into_iter().map(|balance| Some(balance?.substitute(&multipliers)));
    let contacts = trace.model.contacts.iter().zip(balances).enumerate();
    contacts.flat_map(|(place, (contact, balance))| law(trace, place, contact, balance)).collect()
}

fn law(trace: &Trace<'_>, place: usize, contact: &Contact, balance: Option<Sym>) -> Vec<String> {
    let normal = trace.reaction(place, 0);
    let text = |scalar: Sym| simplified(scalar).decimal_text();
    if contact.one_way.is_some() {
        return vec![
            contact.title(place),
            format!("  u = {}, which is not negative", text(trace.scalar(contact.gap))),
            format!("  where u = 0, u' = 0 and {normal} >= 0, or {normal} = 0 and u begins to grow; else {normal} = 0"),
        ];
    }
    let sides = match contact.sides {
        Sides::One => "pushes on one side",
        Sides::Both => "holds on both sides",
    };
    let mut lines = vec![format!("{}: {sides}", contact.title(place))];
    match balance {
        None => lines.push(format!("  gap = {}", text(trace.scalar(contact.gap)))),
        Some(balance) => {
            // the reaction occurs in the balance with the factor -1
            let shown = text(balance.substitute(&[(normal, Sym::ZERO)]));
            lines.push(format!("  {normal} = {shown}, the balance of forces across the guide"));
        }
    }
    match contact.sides {
        Sides::One => lines.push(format!("  in touch gap'' = 0 and {normal} >= 0, else {normal} = 0")),
        Sides::Both if contact.guide.is_none() => lines.push("  gap'' = 0".to_owned()),
        Sides::Both => {}
    }
    if let Some(friction) = contact.friction {
        lines.extend(coulomb(trace, place, &text(trace.scalar(friction))));
    }
    if let Some(restitution) = contact.restitution {
        let restitution = text(trace.scalar(restitution));
        lines.push(match contact.law {
            Restitution::Newton => format!("  an impact leaves -{restitution} times the rate of the gap"),
            Restitution::Moreau => format!(
                "  an impact of this or another contact leaves -{restitution} times the rate of the gap, or a larger rate without an \
                 impulse"
            ),
            Restitution::Poisson => {
                format!("  the impulse of the restitution is {restitution} times that of the compression")
            }
        });
    }
    lines
}
