//! Families of steady motions, and motions in which the equations leave friction undetermined.

use super::steady_box::{Found, enclosed, number};
use super::verdict::{FEEDS, RESISTS, singular};
use crate::spectrum;
use ::scenes::linearisation::{Linear, Stability, Standing};
use ::scenes::steady_motions::{Family, Friction, Member, SteadyMotions};
use serde_json::{Value, json};
use std::f64::consts::PI;
use std::fmt::Write;

/// The largest width of an enclosure that is printed as a number, as a fraction of 1 SI unit and of the value.
const NARROW: f64 = 1e-9;

/// Eigenvalues below this fraction of the largest may be a double zero that rounding has moved.
const ZEROS: f64 = 1e-6;

/// A sentence on the numbers of isolated motions, of positions that the coordinates do not describe, of motions with undetermined friction, and of
/// families.
pub(super) fn count([alone, singular, open, families]: [usize; 4], is_complete: bool) -> String {
    let motions = |count: usize| match count {
        1 => "one steady motion".to_owned(),
        count => format!("{count} steady motions"),
    };
    let alone = match alone {
        0 => None,
        1 => Some("one steady motion, alone in its box".to_owned()),
        count => Some(format!("{}, each alone in its box", motions(count))),
    };
    let singular = match singular {
        0 => None,
        1 => Some("one place at which the coordinates are singular".to_owned()),
        count => Some(format!("{count} places at which the coordinates are singular")),
    };
    let open = (open > 0).then(|| format!("{} with an undetermined share of friction or force", motions(open)));
    let is_first = alone.is_none() && open.is_none();
    let families = match families {
        0 => None,
        1 if is_first => Some("one family of steady motions".to_owned()),
        1 => Some("one family".to_owned()),
        count if is_first => Some(format!("{count} families of steady motions")),
        count => Some(format!("{count} families")),
    };
    let all: Vec<String> = [alone, open, families, singular].into_iter().flatten().collect();
    match all.is_empty() {
        false => all.join(", and "),
        true if is_complete => "no steady motion".to_owned(),
        true => "no steady motion that is shown to be alone in a box".to_owned(),
    }
}

pub(super) fn family_lines(all: &Found, place: usize, family: &Family, members: &[Member]) -> String {
    let found = &all.motions;
    let shape = match family.dimension {
        1 => "a curve".to_owned(),
        2 => "a surface".to_owned(),
        dimension => format!("of {dimension} dimensions"),
    };
    let ranges = found.unknowns.iter().zip(&family.hull).enumerate().map(|(place, (unknown, at))| {
        if unknown.is_circle && at[1] - at[0] >= 2.0 * PI - NARROW {
            return format!("every angle {}", unknown.name);
        }
        let [low, high] = ends(*at);
        // only parameters of the family take all values of their ranges; enclosures of the other unknowns are wider than their values
        let runs = family.pieces.iter().all(|(parameters, _)| parameters.contains(&place));
        let word = if runs { "from" } else { "within" };
        let middle = 0.5 * (at[0] + at[1]);
        let unit = all.unit(&unknown.name);
        let open = match family.reached[place].map(ends) {
            _ if family.reached[place].is_some_and(|reached| are_ends(*at, reached)) => String::new(),
            Some([from, to]) => format!(" (known to come to {from}{unit} and {to}{unit})"),
            None => " (bounds: no value between them is known to be reached)".to_owned(),
        };
        match !runs && at[1] - at[0] <= NARROW * (1.0 + middle.abs()) {
            true => format!("{} = {}{unit}", unknown.name, enclosed(*at, unknown.range)),
            false => format!("{} {word} {low} to {high}{unit}{open}", unknown.name),
        }
    });
    let is_placed = is_one_place(found, family);
    let (ranges, kind) = (ranges.collect::<Vec<_>>().join(", "), format!("a family, {shape}: "));
    let mut out = format!("  {place}  {}{ranges}\n", if is_placed { "" } else { &kind });
    if is_placed {
        // writing to a String cannot fail
        let _ = writeln!(
            out,
            "     one state: the equations do not determine {}, and hold for every value in its range",
            running(found, family).join(" or ")
        );
        out += &stability(family, members);
        return out;
    }
    // writing to a String cannot fail
    let pieces =
        if family.pieces.len() == 1 { "one piece".to_owned() } else { format!("{} pieces", family.pieces.len()) };
    let running = running(found, family).join(" or ");
    let _ = match family.border == family.pieces.len() {
        true => writeln!(
            out,
            "     enclosed in {pieces}: in each the equations have one solution, and no other, for every value of {running}; it is not decided which \
             of these fulfil the conditions, and are motions"
        ),
        false => writeln!(
            out,
            "     enclosed in {pieces}: in each there is one motion, and no other, for every value of {running}"
        ),
    };
    if family.border > 0 && family.border < family.pieces.len() && family.dimension > 1 {
        let _ = writeln!(
            out,
            "     of these pieces {} at the border have such motions for a part of the values only",
            family.border
        );
    }
    if !family.along.is_empty() {
        let _ = writeln!(
            out,
            "     the cause is an identity: the forces do no work along the displacement {}",
            family.along.join(", nor along ")
        );
    }
    out + &stability(family, members)
}

/// Whether motions are known up to both ends of a range, except for rounding.
fn are_ends(within: [f64; 2], reached: [f64; 2]) -> bool {
    within.iter().zip(reached).all(|(end, reached)| (end - reached).abs() <= 2.0 * NARROW * (1.0 + end.abs()))
}

/// The lines on the stability of the motions of a family.
fn stability(family: &Family, members: &[Member]) -> String {
    if let Some(names) = members.iter().map(|member| &member.without_inertia).find(|names| !names.is_empty())
        && members.iter().all(|member| !member.without_inertia.is_empty())
    {
        return format!("     {}\n", singular(names));
    }
    let of_friction = |friction| match friction {
        Friction::Resists => format!("where every share lies inside its range: {RESISTS}"),
        Friction::Feeds => format!("where every share lies inside its range: {FEEDS}"),
        Friction::Partial => "stability is not decided: dry friction does not act on every motion".to_owned(),
        Friction::OfContacts => {
            "stability is not decided: friction depends on normal forces, which may change when contacts slide"
                .to_owned()
        }
        Friction::Open => "stability is not decided: a condition of the law is zero at these motions".to_owned(),
    };
    if let Some(friction) = family.friction {
        return format!("     {}\n", of_friction(friction));
    }
    let judged: Vec<bool> = members
        .iter()
        .filter_map(|member| member.linear.as_ref())
        .filter(|linear| linear.standing != Standing::Moving)
        .map(|linear| matches!(linear.stability, Stability::Unstable(_)) && grows(linear))
        .collect();
    if members.iter().all(|member| member.linear.is_none()) {
        return "     stability is not decided: these motions have no linear equations\n".to_owned();
    }
    if judged.is_empty() {
        return of_moving(members);
    }
    let unstable = judged.iter().filter(|is_unstable| **is_unstable).count();
    format!(
        "     tested motions of it: {}; of these {unstable} have an eigenvalue with a positive real part, by numbers\n",
        judged.len()
    )
}

/// The line on members in which cyclic coordinates change, by eigenvalues of the equations without cyclic coordinates, which are constant then.
fn of_moving(members: &[Member]) -> String {
    let words: Vec<&str> = members.iter().filter_map(|member| member.enclosed.as_ref()).map(spectrum::word).collect();
    if words.is_empty() {
        return "     stability is not decided: these motions move, and eigenvalues of an instant say nothing; linearise --along encloses those of \
                chosen motions\n"
            .to_owned();
    }
    let count = |word: &str| words.iter().filter(|own| **own == word).count();
    format!(
        "     tested motions of it: {}, by enclosed eigenvalues without cyclic coordinates: {} unstable, {} asymptotically stable but for zeros with \
         reasons, {} not decided by linear equations\n",
        words.len(),
        count("unstable"),
        count("asymptotically stable"),
        count("not decided")
    )
}

/// Whether a real part is larger than the rounding errors of the zero eigenvalues of a family.
fn grows(linear: &Linear) -> bool {
    let largest = linear.eigenvalues.iter().map(|[re, im]| re.hypot(*im)).fold(0.0, f64::max);
    linear.eigenvalues.iter().any(|[re, _]| *re > ZEROS * largest)
}

/// Whether a family is a single state in which the equations leave friction, or the value of a law between two cases, undetermined.
pub(super) fn is_one_place(found: &SteadyMotions, family: &Family) -> bool {
    let state = found.state_size;
    let is_share = |place: &usize| found.unknowns.get(*place).is_none_or(|unknown| unknown.place >= state);
    if !family.pieces.iter().all(|(parameters, _)| parameters.iter().all(is_share)) {
        return false;
    }
    found
        .unknowns
        .iter()
        .zip(&family.hull)
        .all(|(unknown, [low, high])| unknown.place >= state || high - low <= NARROW * (1.0 + 0.5 * (low + high).abs()))
}

/// The names of the unknowns that parametrise the pieces of the family.
fn running(found: &SteadyMotions, family: &Family) -> Vec<String> {
    let mut all: Vec<String> = family
        .pieces
        .iter()
        .map(|(parameters, _)| {
            let own = parameters.iter().filter_map(|&place| found.unknowns.get(place));
            own.map(|unknown| unknown.name.clone()).collect::<Vec<_>>().join(", ")
        })
        .collect();
    all.sort();
    all.dedup();
    all
}

pub(super) fn family_object(found: &SteadyMotions, family: &Family, members: &[Member]) -> Value {
    json!({
        "dimension": family.dimension,
        "hull": family.hull,
        "reached": family.reached,
        "along": family.along,
        "border": family.border,
        "friction": family.friction.map(|friction| match friction {
            Friction::Resists => "resists every motion",
            Friction::Feeds => "feeds every motion",
            Friction::Partial => "acts on some motions",
            Friction::OfContacts => "of contacts",
            Friction::Open => "not decided",
        }),
        "parameters": running(found, family),
        "pieces": family.pieces.iter().map(|(parameters, at)| json!({
            "parameters": parameters.iter().filter_map(|&place| found.unknowns.get(place)).map(|unknown| unknown.name.clone()).collect::<Vec<_>>(),
            "enclosure": at,
        })).collect::<Vec<_>>(),
        "members": members.iter().map(|member| json!({
            "values": member.values,
            "state": member.state,
            "eigenvalues": member.linear.as_ref().map(|linear| &linear.eigenvalues),
            "enclosed": member.enclosed.as_ref().map(spectrum::object),
        })).collect::<Vec<_>>(),
    })
}

/// The ends of a range as text, with five digits where these differ.
pub(super) fn ends([low, high]: [f64; 2]) -> [String; 2] {
    let few = [low, high].map(short);
    if few[0] == few[1] { [low, high].map(number) } else { few }
}

/// A number with five significant digits.
fn short(value: f64) -> String {
    number(format!("{value:.4e}").parse().unwrap_or(value))
}
