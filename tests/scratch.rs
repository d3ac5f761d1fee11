use derivations::principles::*;
use mechanics::constrained::redundant::*;
use mechanics::constrained::*;
use symbolic::*;
fn show(e: Sym) -> String {
    match normal(e, &Hypotheses::none()) {
        Ok(n) => n.to_string(),
        Err(e) => format!("ERR {e}"),
    }
}
#[test]
fn lost() {
    let k = systems::knife_edge();
    let dp = alphabet::letters(["v̇", "θ̈"]);
    let o = quasi::operator(&k.system, k.at, dp);
    for j in 0..2 {
        eprintln!("knife energy {}  lost {}", show(o.energy[j]), show(o.lost[j]));
    }
    let m = k.motion();
    let split = Split::<4, 2, 2>::new(k.dependent).unwrap();
    let r = Redundant::about(&k.system, split, m.state.time, m.state.place).unwrap();
    let o =
        quasi::operator(&r, (m.state.time, m.state.place, r.free(m.state.velocity)), alphabet::letters(["ẍ", "κ1"]));
    for j in 0..2 {
        eprintln!("knife shulgin energy {}  lost {}", show(o.energy[j]), show(o.lost[j]));
    }
    let k = systems::disc();
    let o = quasi::operator(&k.system, k.at, alphabet::letters(["ψ̈", "θ̈", "φ̈"]));
    for j in 0..3 {
        eprintln!("disc energy {}  lost {}", show(o.energy[j]), show(o.lost[j]));
    }
    let k = systems::steered_rod();
    let o = quasi::operator(&k.system, k.at, alphabet::letters(["ẍ"]));
    eprintln!("steered {} {}", show(o.energy[0]), show(o.lost[0]));
    let k = systems::swing();
    let o = quasi::operator(&k.system, k.at, alphabet::letters(["θ̈"]));
    eprintln!("swing {} {}", show(o.energy[0]), show(o.lost[0]));
    let k = systems::kept_speed();
    let o = quasi::operator(&k.system, k.at, alphabet::letters(["χ̇"]));
    eprintln!("kept {} {}", show(o.energy[0]), show(o.lost[0]));
}
