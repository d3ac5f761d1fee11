//! Line breaks in long formulas. Since MathML does not break lines, a long formula is cut into pieces that follow each other.

mod element;

use element::{Element, children, element_width, space, width};

/// A part of a formula that stays on one line.
#[derive(Debug, PartialEq)]
pub struct Piece {
    pub mathml: String,
    /// The estimated width in em.
    pub width: f64,
}

/// The pieces of the content of a `<math>` element. Content wider than `limit` (em) is cut before relations and before plus and minus signs:
/// first outside all parentheses, then at increasing depth inside them where a piece is still too wide.
pub fn pieces(math: &str, limit: f64) -> Vec<Piece> {
    let content = math.find('>').map_or("", |end| &math[end + 1..]).trim_end_matches("</math>");
    let elements: Vec<_> = children(content).into_iter().flat_map(|element| opened(element, limit)).collect();
    let mut parts = vec![&elements[..]];
    for depth in 0..DEEPEST {
        parts = parts
            .into_iter()
            .flat_map(|part| if width(part) > limit { cut(part, depth, limit) } else { vec![part] })
            .collect();
    }
    let piece = |(position, part)| Piece { mathml: write(part, position > 0), width: width(part) };
    parts.into_iter().enumerate().map(piece).collect()
}

/// The largest depth of parentheses at which a line may break.
const DEEPEST: i32 = 4;

/// The elements of a bracketed row that is too wide for a line, or the element itself. Brackets about fractions
/// keep their height. A fraction wider than two lines becomes a quotient of bracketed expressions, which may break.
fn opened(element: Element<'_>, limit: f64) -> Vec<Element<'_>> {
    let mut inner = children(element.inner);
    if element.name == "mfrac" && inner.len() == 2 && element_width(&element) > 2.0 * limit {
        let (above, below) = (operand(inner[0], limit), operand(inner[1], limit));
        return [above, vec![sign("/")], below].concat();
    }
    let bracketed =
        inner.first().is_some_and(|first| first.name == "mo") && inner.last().is_some_and(|last| last.name == "mo");
    if element.name != "mrow" || !bracketed || element_width(&element) <= limit || element.inner.contains("<mtable") {
        return vec![element];
    }
    let tall = element.inner.contains("<mfrac");
    let last = inner.len() - 1;
    for at in [0, last] {
        inner[at].attributes = if tall { TALL } else { "stretchy=\"false\"" };
    }
    inner
}

/// The numerator or denominator of a fraction written with a slash: in brackets where it has more than one element.
fn operand(element: Element<'_>, limit: f64) -> Vec<Element<'_>> {
    if element.name != "mrow" {
        return vec![element];
    }
    let content = children(element.inner).into_iter().flat_map(|inner| opened(inner, limit));
    std::iter::once(sign("(")).chain(content).chain([sign(")")]).collect()
}

fn sign(sign: &'static str) -> Element<'static> {
    Element { name: "mo", attributes: "stretchy=\"false\"", inner: sign }
}

const TALL: &str = "minsize=\"2.4em\" maxsize=\"2.4em\"";

/// Cuts before every relation or sign at a depth of at most `depth` parentheses, and after every wide space. Short
/// parentheses are not cut.
fn cut<'e, 'a>(elements: &'e [Element<'a>], depth: i32, limit: f64) -> Vec<&'e [Element<'a>]> {
    let mut parts = Vec::new();
    let (mut start, mut open) = (0, 0);
    for (at, element) in elements.iter().enumerate().skip(1) {
        let before = &elements[at - 1];
        open = (open + nesting(before)).max(0);
        let binary = element.name == "mo" && BREAKS.contains(&element.inner) && !starts_an_operand(before);
        let spaced = before.name == "mspace" && space(before) >= 1.0;
        let room = open == 0 || (open <= depth && group_width(elements, at) > 0.5 * limit);
        if room && (binary || spaced) {
            parts.push(&elements[start..at]);
            start = at;
        }
    }
    parts.push(&elements[start..]);
    parts
}

/// The width of the parentheses about a position, including their content, in em.
fn group_width(elements: &[Element], at: usize) -> f64 {
    let outwards = |steps: &mut dyn Iterator<Item = &Element>, sign: i32| {
        let depths = steps.scan(0, |depth, element| {
            *depth += sign * nesting(element);
            Some(*depth)
        });
        depths.take_while(|depth| *depth >= 0).count()
    };
    let before = outwards(&mut elements[..at].iter().rev(), -1);
    let after = outwards(&mut elements[at..].iter(), 1);
    width(&elements[at - before..at + after])
}

/// 1 for an opening parenthesis, -1 for a closing one (which may have an exponent), 0 for any other element.
fn nesting(element: &Element) -> i32 {
    let scripted = matches!(element.name, "msup" | "msub" | "msubsup");
    let base = if scripted { children(element.inner).first().map_or("", |base| base.inner) } else { element.inner };
    match base {
        "(" | "[" | "{" => 1,
        ")" | "]" | "}" => -1,
        _ => 0,
    }
}

const BREAKS: [&str; 12] = ["=", "+", "−", "±", "≤", "≥", "&lt;", "&gt;", "≠", "≡", "⟹", "⟺"];

/// Whether a sign after this element is the unary sign of the next operand.
fn starts_an_operand(before: &Element) -> bool {
    before.name == "mo" && !matches!(before.inner, ")" | "]" | "}" | "|")
}

fn write(part: &[Element], continued: bool) -> String {
    let mut out = String::new();
    for (position, element) in part.iter().enumerate() {
        let Element { name, attributes, inner } = element;
        let form = if continued && position == 0 && *name == "mo" { " form=\"infix\"" } else { "" };
        let space = if attributes.is_empty() { "" } else { " " };
        out += &format!("<{name}{space}{attributes}{form}>{inner}</{name}>");
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cut_all(content: &str) -> Vec<String> {
        pieces(&format!("<math>{content}</math>"), 0.1).into_iter().map(|piece| piece.mathml).collect()
    }

    #[test]
    fn a_sign_after_a_relation_stays_with_its_operand() {
        let parts = cut_all("<mi>a</mi><mo>=</mo><mo>−</mo><mi>b</mi>");
        assert_eq!(parts, ["<mi>a</mi>", "<mo form=\"infix\">=</mo><mo>−</mo><mi>b</mi>"]);
    }

    #[test]
    fn a_short_parenthesis_stays_whole_beside_a_long_one() {
        let sum = |terms| vec!["<mi>xxxx</mi>"; terms].join("<mo>+</mo>");
        let content = format!("<mo>(</mo>{}<mo>)</mo><mo>[</mo>{}<mo>]</mo>", sum(2), sum(9));
        assert_eq!(pieces(&format!("<math>{content}</math>"), 20.0).len(), 9);
    }

    #[test]
    fn a_parenthesis_with_an_exponent_is_closed() {
        let sum = ["<mi>xxxx</mi>"; 9].join("<mo>+</mo>");
        let content = format!("<mo>(</mo>{sum}<msup><mo>)</mo><mn>2</mn></msup><mo>=</mo><mi>y</mi>");
        let parts = pieces(&format!("<math>{content}</math>"), 30.0);
        assert_eq!(parts.last().map(|part| part.mathml.as_str()), Some("<mo form=\"infix\">=</mo><mi>y</mi>"));
    }

    #[test]
    fn a_fraction_of_two_lines_or_less_stays_whole() {
        let fraction = "<mfrac><mrow><mi>a</mi><mo>+</mo><mi>b</mi></mrow><mi>c</mi></mfrac>";
        assert_eq!(pieces(&format!("<math>{fraction}</math>"), 2.0)[0].mathml, fraction);
    }

    #[test]
    fn a_fraction_wider_than_two_lines_becomes_a_quotient_that_may_break() {
        let sum = ["<mi>xxxx</mi>"; 9].join("<mo>+</mo>");
        let fraction = format!("<mfrac><mrow>{sum}</mrow><mi>c</mi></mfrac>");
        let parts = pieces(&format!("<math>{fraction}</math>"), 10.0);
        assert_eq!(parts.len(), 9);
        assert!(parts[8].mathml.ends_with("<mo stretchy=\"false\">/</mo><mi>c</mi>"), "{parts:?}");
    }

    #[test]
    fn cutting_loses_nothing() {
        let content = "<mi>a</mi><mo stretchy=\"false\">(</mo><mi>b</mi><mo>+</mo><mspace width=\"1em\"></mspace><mi>c</mi>\
                       <mo stretchy=\"false\">)</mo><mo>&lt;</mo><mn>3</mn>";
        assert_eq!(cut_all(content).concat().replace(" form=\"infix\"", ""), content);
    }

    #[test]
    fn an_empty_formula_is_one_empty_piece() {
        assert_eq!(cut_all(""), [""]);
    }
}
