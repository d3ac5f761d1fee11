//! Faults of drives: one message each, with its place.

use super::stored;
use dalembert_scenes::ModelScene;

fn said(from: &str, to: &str) -> String {
    let text = stored("geared_motor");
    assert!(text.contains(from), "{from}");
    let changed = text.replacen(from, to, 1);
    ModelScene::parse("scene.toml", &changed).map_or_else(|error| error.to_string(), |_| panic!("it is read: {to}"))
}

#[test]
fn a_drive_that_means_nothing_is_refused_at_its_place() {
    let pair = "between = [\"carriage\", \"wheel\"]";
    for (from, to, message) in [
        (pair, "", "a drive has one of `turns` and `between`"),
        (pair, "between = [\"wheel\", \"wheel\"]", "both bodies of a drive are fixed in one frame"),
        (pair, "between = [\"carriage\"]", "`between` has two places"),
        ("ratio = \"n\"", "ratio = \"L\"", "the ratio of a gear must have the dimension"),
        ("inductance = \"L\"", "inductance = \"R\"", "the inductance of a winding must have the dimension"),
        ("inductance = \"L\"", "inductance = \"L*(1 + motor.i/(1 A))\"", "depends on positions alone"),
        ("inductance = \"L\"\n", "", "`inductance` is missing"),
        ("L = \"2 mH\"", "L = \"0 H\"", "`L` is zero, and no other inertia moves with it"),
        ("resistance = \"R\"", "resistance = \"L\"", "the resistance of a winding must have the dimension"),
        ("motional = \"k\"", "motional = \"R\"", "the motional voltage per speed must have the dimension"),
        ("supply = \"U\"", "supply = \"k\"", "the supply of a winding must have the dimension"),
        ("supply = \"U\"", "suply = \"U\"", "unknown key `suply`"),
        ("motor.i\"", "motor.j\"", "the drive `motor` has no `j`"),
        ("\"motor.i\"", "\"motor\"", "`motor` is a drive, which is no quantity"),
        ("name = \"motor\"", "name = \"motor\"\nmodel = \"brushed\"", "the model of a motor stands in [drive.machine]"),
        ("name = \"motor\"", "name = \"wheel\"", "`wheel` is defined twice"),
        ("[[drive.winding]]", "[[drive.winding]]\ncurrent = \"speed\"", "no name for the current"),
        (
            "W = \"C turned theta about z\"",
            "V = \"C turned theta about x\"\nW = \"V turned theta about z\"",
            "the shaft of this drive has no axis",
        ),
        ("[run]", "[start]\n\"motor.j\" = \"1 A\"\n[run]", "motor.j"),
    ] {
        let said = said(from, to);
        assert!(said.contains(message), "{message}: {said}");
    }
}

/// Impossible inductances: negative ones, mutual ones above sqrt(L1 L2), and an indefinite matrix of three windings.
#[test]
fn inductances_that_nothing_has_are_refused() {
    let text = |coenergy: &str| {
        format!(
            "title = \"coils\"\n[parameters]\nL = \"10 mH\"\nU = \"60 V\"\n[coordinates]\na = \"C\"\nb = \"C\"\nc = \"C\"\n\
             [energies]\ncoenergy = \"{coenergy}\"\n[[force]]\nalong = \"a\"\nis = \"U\"\n[run]\nspan = \"1 ms\"\n"
        )
    };
    let said = |coenergy: &str| ModelScene::parse("scene.toml", &text(coenergy)).map_err(|error| error.to_string());
    let own = "L/2*(a'^2 + b'^2 + c'^2)";
    assert!(said(&format!("{own} + 0.9*L*a'*b'")).is_ok());
    for (coenergy, message) in [
        ("L/2*(a'^2 + b'^2 - c'^2)".to_owned(), "the inductance of the current c' is negative"),
        (format!("{own} + 1.2*L*a'*b'"), "the mutual inductance of the currents a' and b' is larger"),
        (format!("{own} - 0.6*L*(a'*b' + b'*c' + c'*a')"), "the currents a', b', c' together have a negative energy"),
        ("L/2*(a' + b')^2 + L/2*c'^2".to_owned(), "resists the speeds a' = 1 A, b' = -1 A together"),
    ] {
        let why = said(&coenergy).expect_err(message);
        assert!(why.contains(message), "{message}: {why}");
    }
}
