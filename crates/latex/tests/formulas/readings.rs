//! Formulas with a single reading.

use crate::Plain;
use dalembert_latex::{Relation, Value, letter_name, read, value};
use symbolic::{Hypotheses, Sym, apart, decide};

const LETTERS: [(&str, &str); 8] = [
    ("m", "m"),
    ("l", "l"),
    (r"\theta", "theta"),
    ("m_1", "m1"),
    ("m_2", "m2"),
    ("x_{12}", "x12"),
    ("g", "g"),
    (r"\omega^*", "w"),
];

/// Compares each formula with the expected expression.
#[test]
fn formulas_are_read_as_people_read_them() {
    let cases = [
        (r"m g l \sin\theta", "m*g*l*sin(theta)"),
        (r"\sin\theta\cos\theta", "sin(theta)*cos(theta)"),
        (r"m\sin\theta\,\dot\theta^2", "m*sin(theta)*theta'^2"),
        (r"\cos^2 \theta - \sin^{2}\theta", "cos(theta)^2 - sin(theta)^2"),
        (r"\frac12 m \dot{\theta}^2 l^2", "(1/2)*m*theta'^2*l^2"),
        (r"-m\left(g + l\right)", "-m*(g + l)"),
        (r"m(g - l)(l + g)", "m*(g - l)*(l + g)"),
        (r"m/(2l)", "m/(2*l)"),
        (r"m_1 + m_{2} - x_{12}", "m1 + m2 - x12"),
        (r"\omega^{*} m", "w*m"),
        (r"x_{12}^{10} l^{-1}", "x12^10/l"),
        (r"\sqrt{m^2 + l^2}", "sqrt(m^2 + l^2)"),
        (r"(m + l)^{1/2}", "sqrt(m + l)"),
        (r"1.5 m \cdot 2", "1.5*m*2"),
        (r"\sum_{i=1}^{2} m_i l", "m1*l + m2*l"),
        (r"\frac{d}{dt}\theta", "theta'"),
        (r"\frac{d^2\theta}{dt^2}", "theta''"),
        (r"\frac{\partial (m l^2)}{\partial l}", "2*m*l"),
        (r"m \quad l .", "m*l"),
        (r"\tan\frac{m}{l}", "sin(m/l)/cos(m/l)"),
        (r"\begin{pmatrix} m & l \end{pmatrix} \begin{pmatrix} g \\ l \end{pmatrix}", "m*g + l^2"),
        (r"\begin{bmatrix} m \\ l \\ 0 \end{bmatrix}\cdot\begin{bmatrix} g \\ 1 \\ 0 \end{bmatrix}", "m*g + l"),
    ];
    apart(|| {
        let plain = Plain::of(&LETTERS);
        for (latex, text) in cases {
            let read = plain.side(latex).unwrap_or_else(|fault| panic!("{latex}: {fault}"));
            let expected = symbolic::parse(text, &|name| Some(Sym::symbol(name)))
                .unwrap_or_else(|fault| panic!("{text}: {fault}"));
            assert!(decide(read - expected, &Hypotheses::none()).is_zero(), "{latex} is read as {read}");
        }
    });
}

#[test]
fn one_letter_has_one_spelling() {
    for (written, spelt) in [
        ("m_p", "m_{p}"),
        ("m_{p}", "m_{p}"),
        (r"\omega^*_0", r"\omega_{0}^{*}"),
        (r"\mathbf r", r"\mathbf{r}"),
        ("x'", r"x^{\prime}"),
    ] {
        assert_eq!(letter_name(written).as_deref(), Ok(spelt));
    }
    for wrong in ["ml", "m^2", r"\dot{x}", "2", "", "m+l"] {
        assert!(letter_name(wrong).is_err(), "{wrong}");
    }
}

#[test]
fn relations_stand_between_sides() {
    let known = ["m", "l"].map(str::to_owned);
    let statement = read(r"m = l \leq 2 \iff m > 0", &known).expect("it is read");
    assert_eq!(statement.chains.len(), 2);
    assert_eq!(statement.chains[0].relations, [Relation::Equal, Relation::LessOrEqual]);
}

#[test]
fn vectors_have_products() {
    apart(|| {
        let mut plain = Plain::of(&LETTERS);
        let vector = |names: [&str; 3]| Value::Matrix(names.map(|name| vec![Sym::symbol(name)]).to_vec());
        plain.letters.push((r"\mathbf{r}".to_owned(), vector(["x", "y", "z"])));
        plain.letters.push((r"\mathbf{v}".to_owned(), vector(["u", "v", "w"])));
        let of = |text: &str| {
            let statement = read(text, &plain.spelt()).unwrap_or_else(|fault| panic!("{text}: {fault}"));
            value(&statement.chains[0].sides[0], &plain)
        };
        let told = |text: &str| of(text).unwrap().entries().iter().map(Sym::to_string).collect::<Vec<_>>().join("; ");
        assert_eq!(told(r"\mathbf{r} \times \mathbf{v}"), "y*w - z*v; z*u - x*w; x*v - y*u");
        assert_eq!(told(r"\mathbf r\cdot\mathbf v"), "x*u + y*v + z*w");
        assert_eq!(told(r"\mathbf{r}^T \mathbf{v}"), "x*u + y*v + z*w");
        assert_eq!(told(r"m \mathbf{r}"), "m*x; m*y; m*z");
        assert!(of(r"\mathbf{r} \mathbf{v}").is_err() && of(r"\mathbf{r} + m").is_err() && of(r"m^T").is_err());
    });
}

#[test]
fn a_rate_is_read_beside_a_letter_d() {
    apart(|| {
        let plain = Plain::of(&[("d", "d"), ("x", "x")]);
        for (latex, text) in [
            (r"\frac{d}{dt} x", "x'"),
            (r"\frac{d x}{d t}", "x'"),
            (r"\frac{d^2 x}{dt^2}", "x''"),
            (r"\frac{d x}{d}", "x"),
        ] {
            let read = plain.side(latex).unwrap_or_else(|fault| panic!("{latex}: {fault}"));
            let expected = Sym::symbol(text);
            assert!(decide(read - expected, &Hypotheses::none()).is_zero(), "{latex} is read as {read}");
        }
        let both = Plain::of(&[("d", "d"), ("t", "t"), ("x", "x")]);
        let fault = both.side(r"\frac{d x}{d t}").expect_err("it is a rate or a quotient");
        assert!(fault.accepted.contains(r"\mathrm{d}"), "{fault}");
        assert!(both.side(r"\frac{\mathrm{d}}{\mathrm{d}t} x").is_ok());
    });
}
