//! Export to C99: a structure of parameters, and functions that write into arrays.

use super::{Program, assigned, indented};
use std::fmt::Write;

/// Keywords, and macros of the included headers, which cannot be names of structure members.
pub(super) const WORDS: &str = "auto break case char const continue default do double else enum extern float for goto if inline int long \
    register restrict return short signed sizeof static struct switch typedef union unsigned void volatile while _Bool _Complex \
    _Imaginary asm bool true false nullptr constexpr thread_local typeof alignas alignof static_assert NULL EOF errno unix linux i386 \
    NAN INFINITY HUGE_VAL HUGE_VALF HUGE_VALL FP_NAN FP_INFINITE FP_ZERO FP_SUBNORMAL FP_NORMAL FP_ILOGB0 FP_ILOGBNAN FP_FAST_FMA \
    MATH_ERRNO MATH_ERREXCEPT math_errhandling signgam M_E M_LOG2E M_LOG10E M_LN2 M_LN10 M_PI M_PI_2 M_PI_4 M_1_PI M_2_PI M_2_SQRTPI \
    M_SQRT2 M_SQRT1_2";

/// The form of functions in a file.
#[derive(Clone, Copy)]
pub(super) struct Form {
    /// The storage class before the name of a function or constant.
    pub storage: &'static str,
    /// Whether the cases of conditions are arguments of each function, or computed in it.
    pub has_cases: bool,
}

impl Form {
    /// A complete file.
    pub const ALONE: Form = Form { storage: "", has_cases: false };
    /// A part of a file whose other functions determine the cases of conditions.
    pub const PART: Form = Form { storage: "static ", has_cases: true };

    /// Returns the declaration of the arguments of a function of the state.
    pub fn declared(self) -> &'static str {
        match self.has_cases {
            false => "double t, const double *q, const double *u, const struct parameters *p",
            true => "double t, const double *q, const double *u, const struct parameters *p, const double *s",
        }
    }

    /// Returns the arguments in a call.
    pub fn handed(self) -> &'static str {
        if self.has_cases { "t, q, u, p, s" } else { "t, q, u, p" }
    }

    /// Returns statements that mark arguments as used.
    pub fn unused(self) -> &'static str {
        if self.has_cases {
            "(void)t; (void)q; (void)u; (void)p; (void)s; (void)out;"
        } else {
            "(void)t; (void)q; (void)u; (void)p;"
        }
    }
}

pub(super) fn written(program: &Program) -> String {
    program.heading("//") + "#include <math.h>\n\n" + &functions(program, Form::ALONE)
}

/// Returns the structure of parameters, and the functions from the matrices of the equations to the rates of the state.
pub(super) fn functions(program: &Program, form: Form) -> String {
    let Program { positions, n, m, parameters, conditions, terms, zeros, position_rates, start, .. } = program;
    let (storage, declared, handed, unused) = (form.storage, form.declared(), form.handed(), form.unused());
    let mut text = "struct parameters {\n".to_owned();
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
        let _ = writeln!(text, "{storage}const struct parameters defaults = {{\n{values}\n}};\n");
    }
    if let Some(start) = start {
        let values: Vec<String> = start.iter().map(|value| format!("{value:?}")).collect();
        let _ =
            writeln!(text, "// y = (q, u) at the start\n{storage}const double start[] = {{{}}};\n", values.join(", "));
    }
    let _ = writeln!(text, "enum {{ COORDINATES = {positions}, SPEEDS = {n}, CONSTRAINTS = {m} }};\n");
    // conditions first, each in its own block
    let mut chosen = String::new();
    let conditions = if form.has_cases { &[] } else { &conditions[..] };
    if !conditions.is_empty() {
        let _ = writeln!(chosen, "    double s[{}];", conditions.len());
    }
    for (k, condition) in conditions.iter().enumerate() {
        let _ = write!(
            chosen,
            "    {{\n{}    s[{k}] = {} ? 1.0 : 0.0;\n    }}\n",
            indented(&condition.lines),
            condition.holds
        );
    }
    if !conditions.is_empty() {
        chosen += "    (void)s;\n";
    }
    let _ = writeln!(
        text,
        "// M row after row, h - Q, J row after row, c: one array\n\
         {storage}void terms({declared}, double *out)\n{{\n    \
         {unused}\n{chosen}{}{}}}\n",
        indented(&terms.lines),
        indented(&assigned("out", &terms.outputs)),
    );
    if *m > 0 || form.has_cases {
        let _ = writeln!(
            text,
            "// f, zero where the constraints hold\n\
             {storage}void constraints({declared}, double *out)\n{{\n    \
             {unused}\n{chosen}{}{}}}\n",
            indented(&zeros.lines),
            indented(&assigned("out", &zeros.outputs)),
        );
    }
    let _ = writeln!(
        text,
        "{}\n// u' and lambda; gives 0, or 1 where they are not determined\n\
         {storage}int accelerations({declared}, double *acceleration, double *lambda)\n{}\n\
         // dy/dt of y = (q, u); gives 0, or 1 where the accelerations are not determined\n\
         {storage}int rates(double t, const double *y, {}, double *dy)\n{{\n    \
         const double *q = y, *u = y + COORDINATES;\n    double lambda[CONSTRAINTS + 1];\n{}{}    \
         return accelerations({handed}, dy + COORDINATES, lambda);\n}}",
        SOLVE.replace("int solve", &format!("{storage}int solve")),
        ACCELERATIONS.replace("HANDED", handed),
        if form.has_cases { "const struct parameters *p, const double *s" } else { "const struct parameters *p" },
        indented(&position_rates.lines),
        indented(&assigned("dy", &position_rates.outputs)),
    );
    text
}

/// The body of `accelerations`: forms the right side and splits the solution.
const ACCELERATIONS: &str = "\
{
    enum { N = SPEEDS, M = CONSTRAINTS };
    double v[N * N + N + M * N + M], right[N + M], x[N + M];
    terms(HANDED, v);
    for (int i = 0; i < N; ++i) right[i] = -v[N * N + i];
    for (int k = 0; k < M; ++k) right[N + k] = -v[N * N + N + M * N + k];
    if (solve(v, right, x)) return 1;
    for (int i = 0; i < N; ++i) acceleration[i] = x[i];
    for (int k = 0; k < M; ++k) lambda[k] = x[N + k];
    return 0;
}
";

/// Gaussian elimination for [M, -J^T; J, 0] with row scaling and partial pivoting.
const SOLVE: &str = "\
// x of [M, -J^T; J, 0] x = right, M and J from the terms v; gives 0, or 1 where it is not determined
int solve(const double *v, const double *right, double *x)
{
    enum { N = SPEEDS, M = CONSTRAINTS, S = N + M };
    double a[S][S + 1], scale[S];
    const double *jacobian = v + N * N + N;
    for (int i = 0; i < S; ++i) {
        for (int j = 0; j < S; ++j) a[i][j] = 0.0;
        a[i][S] = right[i];
    }
    for (int i = 0; i < N; ++i)
        for (int j = 0; j < N; ++j) a[i][j] = v[N * i + j];
    for (int k = 0; k < M; ++k)
        for (int j = 0; j < N; ++j) {
            a[N + k][j] = jacobian[N * k + j];
            a[j][N + k] = -jacobian[N * k + j];
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
    for (int i = 0; i < S; ++i) x[i] = a[i][S];
    return 0;
}
";
