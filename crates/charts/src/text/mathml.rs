//! Where a long formula may break. MathML breaks no line, so a long one is cut into pieces that stand in a row.

/// A part of a formula that stays on one line.
#[derive(Debug, PartialEq)]
pub struct Piece {
    pub mathml: String,
    /// Estimated, in em.
    pub width: f64,
}

/// The content of a `<math>` element, cut before relations and signs of sums where it is wider than `limit`: first
/// outside of all parentheses, then ever deeper inside them where a piece is still too wide.
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

/// So many parentheses deep a line may break.
const DEEPEST: i32 = 4;

/// The content of a bracketed row that is too wide for a line, or the element itself. Brackets that stood around
/// fractions keep their height.
fn opened(element: Element<'_>, limit: f64) -> Vec<Element<'_>> {
    let mut inner = children(element.inner);
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

const TALL: &str = "minsize=\"2.4em\" maxsize=\"2.4em\"";

/// An element and what it holds.
#[derive(Clone, Copy, Debug)]
struct Element<'a> {
    name: &'a str,
    attributes: &'a str,
    inner: &'a str,
}

/// The elements at the top level of well-formed markup; text between them is skipped.
fn children(markup: &str) -> Vec<Element<'_>> {
    let mut found = Vec::new();
    let mut rest = markup;
    while let Some(start) = rest.find('<') {
        let Some(length) = rest[start..].find('>') else { break };
        let tag = &rest[start + 1..start + length];
        rest = &rest[start + length + 1..];
        let (name, attributes) = tag.trim_end_matches('/').split_once(' ').unwrap_or((tag.trim_end_matches('/'), ""));
        let end = if tag.ends_with('/') { 0 } else { content_end(rest) };
        found.push(Element { name, attributes, inner: &rest[..end] });
        if !tag.ends_with('/') {
            rest = rest[end..].find('>').map_or("", |close| &rest[end + close + 1..]);
        }
    }
    found
}

/// Where the content of the element just opened ends: at the first closing tag without a partner.
fn content_end(markup: &str) -> usize {
    let mut depth = 0_usize;
    for (at, _) in markup.match_indices('<') {
        let tag = &markup[at..];
        if tag.starts_with("</") {
            if depth == 0 {
                return at;
            }
            depth -= 1;
        } else if !tag[..tag.find('>').unwrap_or(0)].ends_with('/') {
            depth += 1;
        }
    }
    markup.len()
}

/// Cuts before every relation or sign that stands at most `depth` parentheses deep, and after every wide space; short
/// parentheses stay whole.
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

/// How wide the parentheses about a position are.
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

/// 1 for an opening parenthesis, -1 for a closing one, which may carry an exponent.
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

/// After these a sign belongs to what follows.
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

fn width(elements: &[Element]) -> f64 {
    elements.iter().map(element_width).sum()
}

/// A rough width in em: enough to tell a line from a line and a half.
fn element_width(element: &Element) -> f64 {
    let glyphs = element.inner.chars().count() as f64;
    match element.name {
        "mo" if glyphs > 1.0 && !element.inner.starts_with('&') => 0.5 * glyphs + 0.3,
        "mo" if matches!(element.inner, "(" | ")" | "[" | "]" | "," | "\u{2062}" | "\u{2061}" | "′" | "|") => 0.35,
        "mo" => 1.25,
        "mi" | "mn" | "mtext" => 0.52 * glyphs,
        "mspace" => space(element),
        name => {
            let inner = children(element.inner);
            let widths = inner.iter().map(element_width);
            match name {
                "mfrac" | "mover" | "munder" | "munderover" | "mtable" => widths.fold(0.0, f64::max),
                "msub" | "msup" | "msubsup" => {
                    let base = inner.first().map_or(0.0, element_width);
                    base + 0.7 * widths.skip(1).fold(0.0, f64::max)
                }
                "mtd" => widths.sum::<f64>() + 0.8,
                "mtr" | "mrow" | "mstyle" | "mpadded" => widths.sum(),
                _ => widths.sum::<f64>() + 0.8,
            }
        }
    }
}

/// The width of an `<mspace>` in em.
fn space(element: &Element) -> f64 {
    let value = element.attributes.split("width=\"").nth(1).unwrap_or("");
    value.split("em").next().and_then(|number| number.parse().ok()).unwrap_or(0.0)
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
    fn a_fraction_stays_whole() {
        let fraction = "<mfrac><mrow><mi>a</mi><mo>+</mo><mi>b</mi></mrow><mi>c</mi></mfrac>";
        assert_eq!(cut_all(fraction), [fraction]);
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
