//! The conditions of a claim: short conditions share a line, each long condition has its own line, and a long list is folded.

use crate::text::{Typesetter, sole_formula};
use maud::{Markup, html};

/// The width in em up to which conditions share a line; where one is wider, each has its own line.
const SHORT: f64 = 18.0;
/// The largest number of conditions that are shown unfolded.
const MANY: usize = 4;

pub(super) fn requires(conditions: &[String], set: &mut Typesetter) -> Markup {
    let all_short = conditions.iter().all(|condition| set.width(condition) <= SHORT);
    html! {
        @if conditions.is_empty() {
        } @else if all_short {
            p.requires { b { "Requires " } @for (position, condition) in conditions.iter().enumerate() {
                @if position > 0 { "; " } span.condition { (set.text(condition)) }
            } }
        } @else if conditions.len() <= MANY {
            div.requires { b { "Requires" } (list(conditions, set)) }
        } @else {
            details.requires { summary { b { "Requires" } " " (conditions.len()) " conditions" } (list(conditions, set)) }
        }
    }
}

fn list(conditions: &[String], set: &mut Typesetter) -> Markup {
    html! {
        ul { @for condition in conditions { li {
            @match sole_formula(condition) {
                Some(latex) => (set.formula(latex)),
                None => (set.text(condition)),
            }
        } } }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(conditions: &[&str]) -> String {
        let conditions: Vec<String> = conditions.iter().map(|condition| (*condition).to_owned()).collect();
        requires(&conditions, &mut Typesetter::default()).into_string()
    }

    #[test]
    fn short_conditions_stand_in_a_line() {
        let html = shown(&["$a > 0$", "$b \\ne 0$", "$c = 1$", "$d = 1$", "$f = 1$"]);
        assert!(html.starts_with("<p") && html.matches("; ").count() == 4, "{html}");
    }

    #[test]
    fn long_conditions_stand_on_lines_of_their_own_and_many_are_folded() {
        let long = format!("${} = 0$", ["x_1 y_1 z_1"; 12].join(" + "));
        let few = shown(&[&long, "$a > 0$"]);
        let many = shown(&[&long, &long, &long, &long, "for all $x$"]);
        assert!(few.starts_with("<div") && few.matches("<li>").count() == 2, "{few}");
        assert!(
            many.starts_with("<details") && many.contains("5 conditions") && many.contains("<li>for all"),
            "{many}"
        );
    }

    #[test]
    fn no_conditions_leave_nothing() {
        assert_eq!(shown(&[]), "");
    }
}
