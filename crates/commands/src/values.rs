//! Exact values by name, for readers: the components of a vector in one entry, names as formulas.

use symbolic::Sym;

/// Names and values as text, `$\\nu$` and `(0, 3/5, 4/5)`. Call it in the thread in which the claims of the paper were built, since this thread
/// stores the LaTeX of the letters.
pub fn compact(values: &[(String, String)]) -> Vec<(String, String)> {
    let mut out = Vec::new();
    let mut rest = values;
    while let [(name, value), ..] = rest {
        let count = components(rest);
        if count < 2 {
            out.push((format!("${}$", latex(name)), value.clone()));
            rest = &rest[1..];
            continue;
        }
        let (vector, after) = rest.split_at(count);
        let parts: Vec<&str> = vector.iter().map(|(_, value)| value.as_str()).collect();
        out.push((format!("${}$", latex(name).replacen("_1", "", 1)), format!("({})", parts.join(", "))));
        rest = after;
    }
    out
}

/// The number of leading values that are components of one vector: their names are one stem followed by 1, 2, 3, ...
fn components(values: &[(String, String)]) -> usize {
    let Some(stem) = values.first().and_then(|(name, _)| name.strip_suffix('1')) else { return 0 };
    if !latex(&format!("{stem}1")).contains("_1") {
        return 0;
    }
    let numbered = values.iter().zip(1..);
    numbered.take_while(|((name, _), k)| name.strip_suffix(&k.to_string()) == Some(stem)).count()
}

/// The LaTeX of a name; cosines and sines have names such as `cos x` or `cos(x)`.
fn latex(name: &str) -> String {
    let whole = |name: &str| Sym::symbol(name).latex();
    match name.split_once([' ', '(']) {
        Some((function @ ("cos" | "sin"), argument)) => {
            format!("\\{function} {}", whole(argument.trim_end_matches(')')))
        }
        _ => whole(name),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(values: &[(&str, &str)]) -> Vec<(String, String)> {
        compact(&values.iter().map(|(name, value)| ((*name).into(), (*value).into())).collect::<Vec<_>>())
    }

    #[test]
    fn components_of_a_vector_stand_together() {
        let values = shown(&[
            ("g", "2"),
            ("l1", "0"),
            ("l2", "3/5"),
            ("l3", "4/5"),
            ("b1", "7"),
            ("cos omega", "1"),
            ("sin(x)", "0"),
        ]);
        let circle = [("$\\cos \\omega$", "1"), ("$\\sin x$", "0")];
        let expected = [&[("$g$", "2"), ("$l$", "(0, 3/5, 4/5)"), ("$b_1$", "7")][..], &circle].concat();
        assert_eq!(
            values,
            expected.iter().map(|(name, value)| ((*name).to_owned(), (*value).to_owned())).collect::<Vec<_>>()
        );
    }
}
