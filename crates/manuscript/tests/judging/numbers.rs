//! Printed numbers: powers of ten, many digits, and quantities without a value.

use crate::cases::BLOCK;
use crate::{on, verdict};

#[test]
fn a_power_of_ten_stands_beside_the_digits() {
    for (formula, given, expected) in [
        (r"k = 3.0\cdot 10^{-3}", "'k = 0.003'", "enclosed"),
        (r"k = 3.0\times 10^{-3}", "'k = 0.00304'", "enclosed"),
        (r"k = 3.0\cdot 10^{-3}", "'k = 0.0031'", "refuted"),
        (r"k = -1.25\cdot 10^2", "'k = -125.4'", "enclosed"),
        (r"k = 3.14159265358979323846264338327950288", "'k = 3.14159265358979323846264338327950288'", "enclosed"),
        (r"k = 3.14159265358979323846264338327950288", "'k = 3.14159265358979323846264338327950289'", "refuted"),
    ] {
        let found = on(BLOCK, "number", formula, &format!("given = [{given}]"));
        assert_eq!(verdict(&found), expected, "{formula}: {}", found.text());
    }
    let found = on(BLOCK, "number", r"k = -3.0\cdot 10^{-3}", "given = ['k = -0.0031']");
    assert_eq!(found.corrections[0].formula, r"k = -3.1\cdot 10^{-3}", "{}", found.text());
    for (formula, right) in [
        (r"k = 3.0 \cdot 10^{-2}", r"k = 3.0 \cdot 10^{-3}"),
        (r"k = -3.0 \cdot 10^{4}", r"k = -3.0 \cdot 10^{-3}"),
        (r"k = 3.0 \cdot 10", r"k = 3.0 \cdot 10^{-3}"),
    ] {
        let value = if formula.contains("-3.0") { "-0.003" } else { "0.003" };
        let found = on(BLOCK, "number", formula, &format!("given = ['k = {value}']"));
        assert_eq!(found.corrections[0].formula, right, "{}", found.text());
    }
    let found = on(BLOCK, "number", r"k = 3.0 \cdot 10^{-2}", "given = ['k = -0.003']");
    assert_eq!(found.corrections[0].formula, r"k = -3.0 \cdot 10^{-3}", "{}", found.text());
}

#[test]
fn a_value_that_is_no_number_is_told_in_words() {
    for (formula, given, expected, says) in [
        (r"\frac{1}{k} = 1.5", "'k = 0'", "undefined", "it divides by zero"),
        (r"\ln k = 1.5", "'k = 0'", "undefined", "logarithm of k"),
        (r"\exp(k) = 5", "'k = 100000'", "refuted", "beyond the numbers of double precision"),
        (r"\exp(k) = 0.00", "'k = -100'", "undecided", "neither confirms nor refutes"),
    ] {
        let found = on(BLOCK, "number", formula, &format!("given = [{given}]"));
        assert_eq!(verdict(&found), expected, "{}", found.text());
        assert!(found.judged.evidence.contains(says) && !found.text().contains("inf "), "{}", found.text());
        assert!(found.judged.difference.is_none(), "{}", found.text());
    }
}
