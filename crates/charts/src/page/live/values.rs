//! Sliders for the numbers of a file, and the lines that would give the file the values of the sliders.

use maud::html;

/// A slider for a number of the file.
#[derive(Clone, Debug, Default)]
pub struct Slider {
    /// The path of the number in the file: `parameters.m`.
    pub id: String,
    /// The present value, in `unit`.
    pub number: f64,
    /// The unit as written in the file; empty for a pure number.
    pub unit: String,
    /// The ends of the slider, in `unit`.
    pub range: [f64; 2],
}

/// HTML with a slider for each number, and a button that undoes all changes.
pub fn sliders(all: &[Slider], about: &str) -> String {
    html! {
        @if !all.is_empty() {
            p.note { (about) }
            div.sliders.long[all.iter().any(|slider| name(&slider.id).len() > SHORT)] {
                @for Slider { id, number, unit, range: [low, high] } in all {
                    label {
                        code { (name(id)) }
                        input type="range" name=(id) min=(low) max=(high) step="any" value=(number) data-own=(number)
                            autocomplete="off";
                        span { output { (number) } " " (unit) }
                    }
                }
            }
            button type="button" .reset disabled { "Reset" }
        }
    }
    .into_string()
}

/// The largest length of a name, in bytes, that fits the narrow column of names.
const SHORT: usize = 8;

/// The name next to the slider: the name alone of a parameter, and the whole path of any other number.
fn name(id: &str) -> String {
    id.strip_prefix("parameters.").unwrap_or(id).replace('"', "")
}

/// HTML of lines of the file with their line numbers; a line without a number is to be added to the file.
pub fn lines(all: &[(Option<usize>, String)]) -> String {
    html! {
        @if !all.is_empty() {
            p.note { "The file itself is not changed." }
            table.lines { tbody { @for (number, text) in all {
                tr {
                    th scope="row" { @if let Some(number) = number { "line " (number) } @else { "new" } }
                    td { code { (text) } }
                }
            } } }
        }
    }
    .into_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slider_has_the_ends_and_the_unit_of_its_number() {
        let slider = Slider { id: "start.\"theta'\"".into(), number: 2.5, unit: "rad/s".into(), range: [-5.0, 5.0] };
        let shown = sliders(&[slider], "about");
        assert!(shown.contains("min=\"-5\" max=\"5\" step=\"any\" value=\"2.5\""), "{shown}");
        assert!(shown.contains("name=\"start.&quot;theta'&quot;\"") && shown.contains("</output> rad/s"), "{shown}");
        assert!(shown.contains("<code>start.theta'</code>") && shown.contains("\"sliders long\""), "{shown}");
        assert_eq!(sliders(&[], "about"), "");
    }

    #[test]
    fn a_line_that_is_new_is_told_so() {
        let shown = lines(&[(Some(3), "m = \"2 kg\"".into()), (None, "[start]".into())]);
        assert!(shown.contains("line 3") && shown.contains("new") && shown.contains("m = &quot;2 kg&quot;"), "{shown}");
        assert_eq!(lines(&[]), "");
    }
}
