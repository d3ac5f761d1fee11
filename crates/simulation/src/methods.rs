//! The names of the integration methods in scenes and on the command line.

use integrators::{MOST_STAGES, Method, Splitting};
use units::nearest;

/// The form of a method's name: some have a number after a colon.
enum Named {
    Plain(Method),
    /// A method with a constant step; the number of steps is required.
    Steps(fn(u32) -> Method),
    /// A method with stages; their number is optional, with a default.
    Stages(u8, fn(u8) -> Method),
}

macro_rules! split {
    ($splitting:ident) => {
        Named::Steps(|steps| Method::Split { splitting: Splitting::$splitting, steps })
    };
}

const METHODS: &[(&str, Named, &str)] = &[
    ("dormand_prince_8", Named::Plain(Method::DormandPrince8), "explicit Runge-Kutta 8(5,3): the default"),
    ("dormand_prince_5", Named::Plain(Method::DormandPrince5), "explicit Runge-Kutta 5(4)"),
    ("verner_9", Named::Plain(Method::Verner9), "explicit Runge-Kutta 9(8)"),
    ("verner_6", Named::Plain(Method::Verner6), "explicit Runge-Kutta 6(5)"),
    ("gragg_bulirsch_stoer", Named::Plain(Method::GraggBulirschStoer), "extrapolation of variable order"),
    ("taylor", Named::Plain(Method::Taylor), "Taylor series from the recorded law, variable order"),
    ("radau_5", Named::Plain(Method::Radau5), "implicit, for stiff scenes"),
    ("rodas_4", Named::Plain(Method::Rodas4), "linearly implicit, for stiff scenes at moderate tolerances"),
    (
        "bader_deuflhard",
        Named::Plain(Method::BaderDeuflhard),
        "implicit extrapolation of variable order, for stiff scenes",
    ),
    ("kvaerno_5", Named::Plain(Method::Kvaerno5), "diagonally implicit 5(4), for stiff scenes"),
    (
        "radau_iia",
        Named::Stages(5, |stages| Method::RadauIIA { stages }),
        "implicit collocation, order 2s - 1, for stiff scenes",
    ),
    ("gauss", Named::Stages(4, |stages| Method::Gauss { stages }), "implicit collocation, order 2s, symmetric"),
    ("runge_kutta_4", Named::Steps(|steps| Method::RungeKutta4 { steps }), "explicit Runge-Kutta 4, STEPS equal steps"),
    ("implicit_midpoint", Named::Steps(|steps| Method::ImplicitMidpoint { steps }), "symmetric, STEPS equal steps"),
    (
        "backward_euler",
        Named::Steps(|steps| Method::BackwardEuler { steps }),
        "implicit, damps stiff parts of the law, STEPS equal steps",
    ),
    ("strang", split!(Strang), "splitting of order 2, conserves |v| and x.v to rounding, STEPS equal steps"),
    ("blanes_moan_4", split!(BlanesMoan4), "splitting of order 4, otherwise as strang"),
    ("blanes_moan_6", split!(BlanesMoan6), "splitting of order 6, otherwise as strang"),
    ("kahan_li_8", split!(KahanLi8), "splitting of order 8, otherwise as strang"),
    ("euler", Named::Steps(|steps| Method::Euler { steps }), "explicit, STEPS equal steps"),
];

/// The name and description of every method.
pub fn list() -> impl Iterator<Item = (String, &'static str)> {
    METHODS.iter().map(|(name, named, what)| {
        let written = match named {
            Named::Plain(_) => (*name).to_owned(),
            Named::Steps(_) => format!("{name}:STEPS"),
            Named::Stages(usual, _) => format!("{name}:{usual}"),
        };
        (written, *what)
    })
}

/// The name of a method, in the form that [`method`] accepts.
pub fn written(method: Method) -> String {
    let one = |(name, named, _): &(&'static str, Named, _)| match named {
        Named::Plain(known) => (*known == method).then(|| (*name).to_owned()),
        Named::Steps(make) => {
            method.steps().filter(|steps| make(*steps) == method).map(|steps| format!("{name}:{steps}"))
        }
        Named::Stages(_, make) => {
            let stages = (1..=MOST_STAGES).find(|stages| make(*stages) == method);
            stages.map(|stages| format!("{name}:{stages}"))
        }
    };
    METHODS.iter().find_map(one).unwrap_or_else(|| method.to_string())
}

/// The method with a name.
///
/// # Errors
/// The fault, and the accepted names.
pub fn method(text: &str) -> Result<Method, (String, String)> {
    let (name, number) = text.split_once(':').map_or((text, None), |(name, number)| (name, Some(number)));
    let Some((_, named, _)) = METHODS.iter().find(|(known, ..)| *known == name) else {
        let known = list().map(|(written, _)| written).collect::<Vec<_>>().join(", ");
        let accepted = match nearest(name, METHODS.iter().map(|(known, ..)| *known)) {
            Some(nearest) => format!("is `{nearest}` meant? Known: {known}"),
            None => format!("known: {known}"),
        };
        return Err((format!("unknown method `{text}`"), accepted));
    };
    let wrong = |accepted: String| Err((format!("`{text}` is no method"), accepted));
    match (named, number) {
        (Named::Plain(method), None) => Ok(*method),
        (Named::Plain(_), Some(_)) => wrong(format!("`{name}` takes no number")),
        (Named::Steps(make), Some(number)) => match number.parse() {
            Ok(steps) if steps > 0 => Ok(make(steps)),
            _ => wrong(format!("a positive whole number of steps is accepted: `{name}:20000`")),
        },
        (Named::Stages(usual, make), None) => Ok(make(*usual)),
        (Named::Stages(usual, make), Some(number)) => match number.parse() {
            Ok(stages) if (1..=MOST_STAGES).contains(&stages) => Ok(make(stages)),
            _ => wrong(format!("from 1 to {MOST_STAGES} stages are accepted: `{name}:{usual}`")),
        },
        (Named::Steps(_), None) => {
            wrong(format!("its steps are constant; the number of steps is needed: `{name}:20000`"))
        }
    }
}
