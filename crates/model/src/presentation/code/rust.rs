//! Export to Rust: a structure of parameters, and functions over arrays.

use super::{Program, assigned, indented};
use std::fmt::Write;

pub(super) const WORDS: &str = "as break const continue crate dyn else enum extern false fn for if impl in let loop match mod move mut pub \
    ref return self Self static struct super trait true type unsafe use where while async await abstract become box do final macro \
    override priv typeof unsized virtual yield try gen _";

pub(super) fn written(program: &Program) -> String {
    let Program { positions, n, m, parameters, conditions, terms, zeros, position_rates, start, .. } = program;
    let mut text = program.heading("//");
    let _ = writeln!(
        text,
        "\npub const COORDINATES: usize = {positions};\npub const SPEEDS: usize = {n};\npub const CONSTRAINTS: usize = {m};\n\n#[allow(non_snake_case)]\n#[derive(Clone, Debug)]\npub struct Parameters {{"
    );
    for named in parameters {
        let _ = writeln!(text, "    /// {}\n    pub {}: f64,", named.unit, named.name);
    }
    text += "}\n";
    if program.has_values() {
        text += "\nimpl Default for Parameters {\n    fn default() -> Self {\n        Parameters {\n";
        for named in parameters {
            let _ = writeln!(text, "            {}: {:?},", named.name, named.value.unwrap_or_default());
        }
        text += "        }\n    }\n}\n";
    }
    if let Some(start) = start {
        let _ =
            writeln!(text, "\n/// y = (q, u) at the start.\npub const START: [f64; COORDINATES + SPEEDS] = {start:?};");
    }
    // conditions first, each in its own block
    let mut chosen = String::new();
    if !conditions.is_empty() {
        let _ = writeln!(chosen, "    let mut s = [0.0; {}];", conditions.len());
    }
    for (k, condition) in conditions.iter().enumerate() {
        let _ = write!(
            chosen,
            "    {{\n{}    s[{k}] = if {} {{ 1.0 }} else {{ 0.0 }};\n    }}\n",
            indented(&condition.lines),
            condition.holds
        );
    }
    if !conditions.is_empty() {
        chosen += "    let _ = s;\n";
    }
    let size = terms.outputs.len();
    let function = |name: &str, said: &str, size: usize, lines: String, outputs: String| {
        format!(
            "\n/// {said}\n#[allow(unused_parens)]\npub fn {name}(t: f64, q: &[f64; COORDINATES], u: &[f64; SPEEDS], p: &Parameters) -> [f64; {size}] {{\n    \
             let _ = (t, q, u, p);\n{chosen}{lines}    #[allow(unused_mut)]\n    let mut out = [0.0; {size}];\n{outputs}    out\n}}\n"
        )
    };
    text += &function(
        "terms",
        "M row after row, h - Q, J row after row, c.",
        size,
        indented(&terms.lines),
        indented(&assigned("out", &terms.outputs)),
    );
    text += &function(
        "constraints",
        "f, zero where the constraints hold.",
        *m,
        indented(&zeros.lines),
        indented(&assigned("out", &zeros.outputs)),
    );
    let _ = write!(
        text,
        "{SOLVE}\n/// dy/dt of y = (q, u); none where the accelerations are not determined.\n#[allow(unused_parens)]\n\
         pub fn rates(t: f64, y: &[f64; COORDINATES + SPEEDS], p: &Parameters) -> Option<[f64; COORDINATES + SPEEDS]> {{\n    \
         let q: &[f64; COORDINATES] = y.first_chunk()?;\n    let u: &[f64; SPEEDS] = y.last_chunk()?;\n    \
         let mut out = [0.0; COORDINATES + SPEEDS];\n{}{}    \
         out[COORDINATES..].copy_from_slice(&accelerations(t, q, u, p)?.0);\n    Some(out)\n}}\n",
        indented(&position_rates.lines),
        indented(&assigned("out", &position_rates.outputs)),
    );
    text
}

/// Gaussian elimination for [M, -J^T; J, 0] with row scaling and partial pivoting.
const SOLVE: &str = "
/// u' and lambda; none where they are not determined.
pub fn accelerations(
    t: f64,
    q: &[f64; COORDINATES],
    u: &[f64; SPEEDS],
    p: &Parameters,
) -> Option<([f64; SPEEDS], [f64; CONSTRAINTS])> {
    const N: usize = SPEEDS;
    const S: usize = SPEEDS + CONSTRAINTS;
    let v = terms(t, q, u, p);
    let (load, jacobian) = (&v[N * N..], &v[N * N + N..]);
    let bias = &jacobian[CONSTRAINTS * N..];
    let mut a = [[0.0; S + 1]; S];
    for i in 0..N {
        a[i][..N].copy_from_slice(&v[N * i..N * i + N]);
        a[i][S] = -load[i];
    }
    for k in 0..CONSTRAINTS {
        for j in 0..N {
            a[N + k][j] = jacobian[N * k + j];
            a[j][N + k] = -jacobian[N * k + j];
        }
        a[N + k][S] = -bias[k];
    }
    let size = |row: &[f64; S + 1]| row[..S].iter().fold(0.0_f64, |most, entry| most.max(entry.abs()));
    let mut scale = a.each_ref().map(size);
    for k in 0..S {
        let relative = |i: usize| a[i][k].abs() / scale[i];
        let pivot = (k..S).max_by(|&i, &j| relative(i).total_cmp(&relative(j)))?;
        // not greater: zero, or no number
        if relative(pivot).partial_cmp(&1e-14) != Some(std::cmp::Ordering::Greater) {
            return None;
        }
        a.swap(k, pivot);
        scale.swap(k, pivot);
        let row = a[k];
        for below in &mut a[k + 1..] {
            let factor = below[k] / row[k];
            for j in k..=S {
                below[j] -= factor * row[j];
            }
        }
    }
    for i in (0..S).rev() {
        let known: f64 = (i + 1..S).map(|j| a[i][j] * a[j][S]).sum();
        a[i][S] = (a[i][S] - known) / a[i][i];
    }
    Some((std::array::from_fn(|i| a[i][S]), std::array::from_fn(|k| a[N + k][S])))
}
";
