//! Elements of well-formed MathML and estimates of their widths.

/// A MathML element: name, attributes and content.
#[derive(Clone, Copy, Debug)]
pub(super) struct Element<'a> {
    pub name: &'a str,
    pub attributes: &'a str,
    pub inner: &'a str,
}

/// The top-level elements of well-formed markup; text between them is skipped.
pub(super) fn children(markup: &str) -> Vec<Element<'_>> {
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

/// The position at which the content of the element just opened ends: the first closing tag without a partner.
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

pub(super) fn width(elements: &[Element]) -> f64 {
    elements.iter().map(element_width).sum()
}

/// An estimate of the width of an element in em, good enough to tell one line from one and a half.
pub(super) fn element_width(element: &Element) -> f64 {
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
pub(super) fn space(element: &Element) -> f64 {
    let value = element.attributes.split("width=\"").nth(1).unwrap_or("");
    value.split("em").next().and_then(|number| number.parse().ok()).unwrap_or(0.0)
}
