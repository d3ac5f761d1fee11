//! Names of tables that other programs and textbooks use, with the names in this language.

use reader::{Issue, Table};

const WORDS: [(&[&str], &str); 9] = [
    (
        &["circuit", "circuits"],
        "charges are [coordinates] with the unit C; inductances, capacitances and resistances stand under [energies], voltages under [[force]]",
    ),
    (
        &["machine", "motor"],
        "a machine belongs to the drive that it moves: [[drive]] with `turns` or `between`, then [drive.machine]",
    ),
    (
        &["control", "controls", "controller"],
        "[inputs] has what is controlled, as an expression of the state or free; [regulator] an optimal one",
    ),
    (
        &["potential", "kinetic", "lagrangian", "energy", "dissipation"],
        "`kinetic`, `potential` and `dissipation` stand under [energies]; bodies add their own",
    ),
    (
        &["spring", "springs", "damper", "dampers"],
        "`potential` or `dissipation` under [energies], or [[force]] with `between`",
    ),
    (
        &["joint", "joints", "hinge", "hinges"],
        "frames and points place the bodies; [[constraint]] closes a loop or rolls a wheel",
    ),
    (&["constants", "params", "data"], "[parameters]"),
    (&["initial", "initial_conditions", "ic", "state"], "[start]"),
    (&["simulation", "sim", "solver", "settings", "integrator"], "[run]"),
];

/// Reports each such table with its place in the file, unless a named system reads it.
pub(super) fn report(top: &mut Table<'_>) {
    for (words, accepted) in WORDS {
        for word in words {
            if let Some(span) = top.place_of(word).filter(|_| !top.is_known(word)) {
                top.known(&[word]);
                let issue = Issue::at(span, format!("unknown key `{word}`"), "another word stands for this");
                top.report(issue.accepted(accepted));
            }
        }
    }
}
