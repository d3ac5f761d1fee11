//! Machine code compared with the tape from which it was compiled.

use dalembert_native::Code;
use field::{Analytic, Scalar};
use proptest::prelude::*;
use symbolic::{Sym, Tape};

/// Every operation of a tape, on three inputs.
fn outputs([x, y, t]: [Sym; 3], choice: u32) -> Vec<Sym> {
    let circle = (x * y + t).circle();
    let parts = [
        x + y,
        x - t,
        x * y,
        y / (t * t + Sym::ONE),
        x / Sym::int(3),
        -t,
        (x * x + y * y).sqrt(),
        circle.cos,
        circle.sin,
    ];
    let mut sums = vec![Sym::ZERO; 4];
    for (i, part) in parts.into_iter().enumerate() {
        let at = (choice as usize + i) % 4;
        sums[at] = if choice >> i & 1 == 1 { sums[at] + part } else { (sums[at] - x) * part };
    }
    sums.extend([x, t, Sym::int(2)]);
    sums
}

fn tape(choice: u32) -> Tape {
    let inputs = ["x", "y", "t"].map(Sym::symbol);
    Tape::record(&inputs, &outputs(inputs, choice)).expect("it has values")
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, ..ProptestConfig::default() })]

    #[test]
    fn machine_code_has_the_bits_of_the_tape(choice in 0_u32..512, x in -1e3..1e3, y in -9.0..9.0, t in -1.0..1.0) {
        let tape = if choice & 1 == 1 { tape(choice).arranged() } else { tape(choice) };
        let Some(code) = Code::of(&tape) else { return Ok(()) };
        let (mut own, mut all) = (vec![0.0; tape.outputs()], vec![0.0; tape.outputs()]);
        tape.over::<f64>().evaluate(&[x, y, t], &mut all);
        prop_assert_eq!(code.run(&[x, y], t, &mut own), Some(()));
        prop_assert_eq!(own.iter().map(|each| each.to_bits()).collect::<Vec<_>>(), all.iter().map(|each| each.to_bits()).collect::<Vec<_>>());
    }
}

#[test]
fn code_is_made_on_the_machines_that_we_know() {
    let known = cfg!(all(unix, any(target_arch = "x86_64", target_arch = "aarch64")));
    assert!(Code::of(&tape(0)).is_some() || !known);
    #[cfg(target_arch = "x86_64")]
    let known = std::arch::is_x86_feature_detected!("fma");
    assert!(Code::of(&tape(0).fused()).is_some() || !known);
}

#[test]
fn another_number_of_inputs_or_too_little_room_is_refused() {
    let Some(code) = Code::of(&tape(5)) else { return };
    let mut values = [7.0; 7];
    assert_eq!(code.run(&[1.0], 0.0, &mut values), None);
    assert_eq!(code.run(&[1.0, 2.0, 3.0], 0.0, &mut values), None);
    assert_eq!(code.run(&[1.0, 2.0], 0.0, &mut values[..6]), None);
    assert_eq!(values, [7.0; 7]);
}

#[test]
fn the_size_of_code_grows_with_its_operations_and_constants() {
    let [x, t] = ["x", "t"].map(Sym::symbol);
    let size =
        |output: Sym| Code::of(&Tape::record(&[x, t], &[output]).expect("it has values")).map(|code| code.size());
    let Some(one) = size(x + t) else { return };
    let shifted = size(x + t + Sym::ratio(1, 3)).expect("as the first");
    let long = size((0..100).fold(x, |y, _| y * y + t)).expect("as the first");
    // a constant takes eight bytes; two hundred operations take at least four bytes each
    assert!(shifted >= one + 8 && long >= one + 800, "{one}, {shifted}, {long} bytes");
}

#[test]
fn where_a_law_has_no_value_code_has_none() {
    let x = Sym::symbol("x");
    let tape = Tape::record(&[x, Sym::symbol("t")], &[Sym::ONE / x, x.sqrt()]).expect("it has values");
    let Some(code) = Code::of(&tape) else { return };
    let mut values = [0.0; 2];
    code.run(&[0.0], 0.0, &mut values);
    assert_eq!(values, [f64::INFINITY, 0.0]);
    code.run(&[-1.0], 0.0, &mut values);
    assert!(values[1].is_nan());
}

#[test]
fn of_many_outputs_that_rest_each_is_what_it_is_and_the_few_that_move_are_in_their_places() {
    let [x, y] = ["x", "y"].map(Sym::symbol);
    let output = |i: i64| match i % 5 {
        0 => x * y * Sym::int(i + 1) + Sym::ratio(i, 7),
        1 if i > 40 => y * Sym::int(i) - x,
        _ => Sym::ratio(2 * i + 1, 3),
    };
    let outputs: Vec<Sym> = (0..64).map(output).collect();
    let tape = Tape::record(&[x, y, Sym::symbol("t")], &outputs).expect("it has values");
    let Some(code) = Code::of(&tape) else { return };
    let (at, mut values) = ([0.3, -1.7], vec![f64::NAN; 64]);
    code.run(&at, 0.0, &mut values);
    let known = |symbol: &Sym| [x, y].iter().position(|each| each == symbol).map(|place| at[place]);
    for (number, (output, value)) in outputs.iter().zip(&values).enumerate() {
        let exact = output.evaluate_analytic(&|name: &str| known(&Sym::symbol(name))).expect("x and y have values");
        assert!((value - exact).abs() <= 1e-14 * exact.abs(), "output {number}: {value} for {exact}");
    }
}
