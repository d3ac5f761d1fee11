//! Formulas with more than one reading, or none, are rejected at the right position.

use crate::Plain;
use symbolic::apart;

const LETTERS: [(&str, &str); 7] =
    [("x", "x"), ("y", "y"), ("f", "f"), ("m", "m"), (r"\theta", "theta"), ("a", "a"), ("b", "b")];

/// Cases: (formula, the marked part, words of the message or of the accepted notation).
#[test]
fn what_has_two_readings_is_asked_for_at_its_place() {
    let cases = [
        (r"\sin x y", r"\sin x y", "where the argument"),
        (r"\sin x^2", "x^2", "a power behind the argument"),
        (r"\sin(x)^2", "^", "a power behind the argument"),
        (r"\sin^{-1} x", "^", "inverse"),
        (r"\sin{x} y", r"\sin{x} y", "where the argument"),
        (r"\sin\theta(x + y)", r"\sin\theta(", "where the argument"),
        (r"\cos x/2", r"\cos x/", "where the argument"),
        ("f(x)", "f(x)", "a function"),
        ("f(x, y)", "f(x, y)", "a function"),
        (r"m f\left(\dot{x}\right)", r"m f\left(\dot{x}\right)", "a function"),
        ("1/2 m", "/", "divided by what"),
        (r"3\frac12", r"\frac12", "before a fraction of numbers"),
        ("a/b/m", "/", "divided by what"),
        ("x^10", "0", "one digit alone"),
        ("x_12", "2", "one digit alone"),
        ("{a + b} x", "{", "braces are not printed"),
        ("{a b}^2", "{", "braces are not printed"),
        ("sin(x)", "sin", r"\sin"),
        ("x_1", "x_1", "is `x` meant"),
        ("z", "z", "declared letters: x, y"),
        ("x'", "x'", r"\dot{x}"),
        ("2 3", "3", "two numbers"),
        ("1,5 x", ",", "comma"),
        ("a -- b", "-", "two signs"),
        (r"a \pm b", r"\pm", "two formulas"),
        ("(a + b", "(", "is missing"),
        ("a + b)", ")", "closes nothing"),
        (r"\frac{a}{b", "{", "is missing"),
        ("(a + b]", "]", "closes what"),
        ("a +", "+", "ends where"),
        (r"a \approx b", r"\approx", "nothing exact"),
        (r"\int x", r"\int", "is not read"),
        (r"\dot{x y}", r"\dot", "above one letter"),
        ("a = b, x = y", ",", "one formula"),
        ("$a$", "$", "without dollar"),
        (r"\sqrt[3]{x}", "[", "square roots"),
        (r"\sum_i x", r"\sum", "limits"),
        ("x^{n}", "n", "no exponent"),
        ("|x|", "|", "no meaning"),
        (r"\frac{d}{dt} x y", r"\frac", "operand"),
        (r"\begin{pmatrix} a & b \\ x \end{pmatrix}", "x", "entries"),
        (r"\begin{align} a \end{align}", r"\begin", "not read"),
    ];
    apart(|| {
        let plain = Plain::of(&LETTERS);
        for (formula, marked, words) in cases {
            let fault = match plain.side(formula) {
                Ok(read) => panic!("{formula} is read as {read}"),
                Err(fault) => fault,
            };
            let told = format!("{}: {}; {}", fault.title, fault.label, fault.accepted);
            assert!(told.contains(words), "{formula}: {told}");
            let found = formula.get(fault.span.clone());
            assert_eq!(found, Some(marked), "{formula}: {told}");
        }
    });
}

#[test]
fn nothing_panics_and_nothing_is_read_twice_as_deep() {
    apart(|| {
        let plain = Plain::of(&LETTERS);
        let deep = format!("{}x{}", "(".repeat(500), ")".repeat(500));
        assert!(plain.side(&deep).is_err());
        assert!(plain.side(&"x".repeat(30_000)).is_err());
        let signs = [
            "",
            " ",
            "{",
            "}",
            r"\",
            r"\,",
            "^",
            "_",
            "^^",
            "x^",
            "x_",
            "()",
            "{}",
            r"\frac",
            r"\frac1",
            r"\dot",
            r"\ddot{}",
            r"\sum_{i=1}^{3}",
            r"\sin",
            r"\sin{}",
            r"\begin{pmatrix}",
            r"\end{pmatrix}",
            r"\left(",
            r"\left. x \right)",
            "=",
            "x =",
            "&",
            r"\mathbf",
            r"\mathbf{}",
            r"\frac{}{}",
            "é",
            "x²",
            "x^{}",
        ];
        for text in signs {
            assert!(plain.side(text).is_err(), "{text}");
        }
    });
}
