//! Drives that mean nothing, each with one message at its place.

use super::stored;
use scenes::ModelScene;

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
        (pair, "between = [\"wheel\", \"wheel\"]", "a drive turns one body beside another"),
        (pair, "between = [\"carriage\"]", "`between` has two places"),
        ("ratio = \"n\"", "ratio = \"L\"", "the ratio of a gear has the dimension"),
        ("inductance = \"L\"", "inductance = \"R\"", "the inductance of a winding has the dimension"),
        ("inductance = \"L\"", "inductance = \"L*(1 + motor.i/(1 A))\"", "depends on positions alone"),
        ("inductance = \"L\"\n", "", "`inductance` is missing"),
        ("resistance = \"R\"", "resistance = \"L\"", "the resistance of a winding has the dimension"),
        ("motional = \"k\"", "motional = \"R\"", "the motional voltage per speed has the dimension"),
        ("supply = \"U\"", "supply = \"k\"", "the supply of a winding has the dimension"),
        ("supply = \"U\"", "suply = \"U\"", "unknown key `suply`"),
        ("motor.i\"", "motor.j\"", "the drive `motor` has no `j`"),
        ("\"motor.i\"", "\"motor\"", "`motor` is a drive, which is no quantity"),
        ("name = \"motor\"", "name = \"motor\"\nmodel = \"brushed\"", "motors of the program are not there yet"),
        ("name = \"motor\"", "name = \"wheel\"", "`wheel` is defined twice"),
        ("[[drive.winding]]", "[[drive.winding]]\ncurrent = \"speed\"", "no name for the current"),
        ("W = \"C turned theta about z\"", "W = \"C turned theta about x\"", "drives in space are not there yet"),
        ("[run]", "[start]\n\"motor.j\" = \"1 A\"\n[run]", "motor.j"),
    ] {
        let said = said(from, to);
        assert!(said.contains(message), "{message}: {said}");
    }
}
