//! C99: a structure of parameters, and functions that write into arrays.

use super::{Program, assigned, indented};
use std::fmt::Write;

pub(super) const WORDS: &str = "auto break case char const continue default do double else enum extern float for goto if inline int long \
    register restrict return short signed sizeof static struct switch typedef union unsigned void volatile while _Bool _Complex \
    _Imaginary asm bool true false nullptr constexpr thread_local typeof alignas alignof static_assert";

pub(super) fn written(program: &Program) -> String {
    let Program { positions, n, m, parameters, conditions, terms, zeros, position_rates, .. } = program;
    let mut text = program.heading("//");
    text += "#include <math.h>\n\nstruct parameters {\n";
    for named in parameters {
        let _ = writeln!(text, "    double {}; // {}", named.name, named.unit);
    }
    if parameters.is_empty() {
        text += "    char none;\n";
    }
    text += "};\n\n";
    if program.has_values() {
        let values: Vec<String> = parameters
            .iter()
            .map(|named| format!("    {:?}, // {}", named.value.unwrap_or_default(), named.name))
            .collect();
        let values = if values.is_empty() { "    0,".to_owned() } else { values.join("\n") };
        let _ = writeln!(text, "const struct parameters defaults = {{\n{values}\n}};\n");
    }
    let _ = writeln!(text, "enum {{ COORDINATES = {positions}, SPEEDS = {n}, CONSTRAINTS = {m} }};\n");
    // conditions first, each in a block of its own
    let mut chosen = String::new();
    if !conditions.is_empty() {
        let _ = writeln!(chosen, "    double s[{}];", conditions.len());
    }
    for (k, condition) in conditions.iter().enumerate() {
        let _ = write!(
            chosen,
            "    {{\n{}    s[{k}] = {} > 0.0 ? 1.0 : 0.0;\n    }}\n",
            indented(&condition.lines),
            condition.outputs[0]
        );
    }
    if !conditions.is_empty() {
        chosen += "    (void)s;\n";
    }
    let _ = writeln!(
        text,
        "// M row after row, h - Q, J row after row, c: one array\n\
         void terms(double t, const double *q, const double *u, const struct parameters *p, double *out)\n{{\n    \
         (void)t; (void)q; (void)u; (void)p;\n{chosen}{}{}}}\n",
        indented(&terms.lines),
        indented(&assigned("out", &terms.outputs)),
    );
    if *m > 0 {
        let _ = writeln!(
            text,
            "// f, zero where the constraints hold\n\
             void constraints(double t, const double *q, const double *u, const struct parameters *p, double *out)\n{{\n    \
             (void)t; (void)q; (void)u; (void)p;\n{chosen}{}{}}}\n",
            indented(&zeros.lines),
            indented(&assigned("out", &zeros.outputs)),
        );
    }
    let _ = writeln!(
        text,
        "{SOLVE}\n// dy/dt of y = (q, u); gives 0, or 1 where the accelerations are not determined\n\
         int rates(double t, const double *y, const struct parameters *p, double *dy)\n{{\n    \
         const double *q = y, *u = y + COORDINATES;\n    double lambda[CONSTRAINTS + 1];\n{}{}    \
         return accelerations(t, q, u, p, dy + COORDINATES, lambda);\n}}",
        indented(&position_rates.lines),
        indented(&assigned("dy", &position_rates.outputs)),
    );
    text
}

/// Gaussian elimination with row pivots of [M, -J^T; J, 0], rows scaled.
const SOLVE: &str = "\
// u' and lambda; gives 0, or 1 where they are not determined
int accelerations(double t, const double *q, const double *u, const struct parameters *p, double *acceleration, double *lambda)
{
    enum { N = SPEEDS, M = CONSTRAINTS, S = N + M };
    double v[N * N + N + M * N + M], a[S][S + 1], scale[S];
    terms(t, q, u, p, v);
    const double *load = v + N * N, *jacobian = load + N, *bias = jacobian + M * N;
    for (int i = 0; i < S; ++i)
        for (int j = 0; j <= S; ++j) a[i][j] = 0.0;
    for (int i = 0; i < N; ++i) {
        for (int j = 0; j < N; ++j) a[i][j] = v[N * i + j];
        a[i][S] = -load[i];
    }
    for (int k = 0; k < M; ++k) {
        for (int j = 0; j < N; ++j) {
            a[N + k][j] = jacobian[N * k + j];
            a[j][N + k] = -jacobian[N * k + j];
        }
        a[N + k][S] = -bias[k];
    }
    for (int i = 0; i < S; ++i) {
        scale[i] = 0.0;
        for (int j = 0; j < S; ++j) scale[i] = fmax(scale[i], fabs(a[i][j]));
        if (!(scale[i] > 0.0)) return 1;
    }
    for (int k = 0; k < S; ++k) {
        int pivot = k;
        for (int i = k + 1; i < S; ++i)
            if (fabs(a[i][k]) * scale[pivot] > fabs(a[pivot][k]) * scale[i]) pivot = i;
        if (!(fabs(a[pivot][k]) > 1e-14 * scale[pivot])) return 1;
        for (int j = 0; j <= S; ++j) {
            const double kept = a[k][j];
            a[k][j] = a[pivot][j];
            a[pivot][j] = kept;
        }
        scale[pivot] = scale[k];
        for (int i = k + 1; i < S; ++i) {
            const double factor = a[i][k] / a[k][k];
            for (int j = k; j <= S; ++j) a[i][j] -= factor * a[k][j];
        }
    }
    for (int i = S - 1; i >= 0; --i) {
        for (int j = i + 1; j < S; ++j) a[i][S] -= a[i][j] * a[j][S];
        a[i][S] /= a[i][i];
    }
    for (int i = 0; i < N; ++i) acceleration[i] = a[i][S];
    for (int k = 0; k < M; ++k) lambda[k] = a[N + k][S];
    return 0;
}
";
