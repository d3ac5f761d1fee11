//! The letters of a recorded equation in printed form.

use super::lost::SOUGHT;
use latex::letter_name;
use symbolic::Sym;

/// A letter of the printed formula (order 0) or a rate of it.
pub(super) struct Letter {
    pub name: String,
    pub order: u32,
    pub latex: String,
    pub symbol: Sym,
    /// Whether the page contains it; otherwise it is the rate between a letter and its second rate.
    pub is_recorded: bool,
}

/// The name for the left side of an equation that is a single name; it denotes the derived expression.
pub(super) const DERIVED: &str = r"\aleph_{0}";

/// The letters for some symbols. A symbol whose LaTeX is that of a letter or of its rate is this letter; any other one gets a new name.
pub(super) fn letters(symbols: &[Sym]) -> Vec<Letter> {
    let mut all: Vec<Letter> = Vec::new();
    for (place, &symbol) in symbols.iter().enumerate() {
        let latex = symbol.latex();
        let (order, below) = [(2, r"\ddot"), (1, r"\dot")]
            .into_iter()
            .find_map(|(order, dots)| Some((order, latex.strip_prefix(dots)?)))
            .map_or((0, latex.clone()), |(order, rest)| (order, rest.trim_start().to_owned()));
        // `\dot{x}_1` is the rate of `x_1`
        let below = match below.strip_prefix('{').and_then(|rest| rest.split_once('}')) {
            Some((held, behind)) if order > 0 => format!("{held}{behind}"),
            _ => below,
        };
        let name = letter_name(&below).ok().filter(|name| name != SOUGHT && name != DERIVED && name != r"\pi");
        let is_taken = |name: &str, order: u32| all.iter().any(|other| other.name == name && other.order == order);
        let (name, order) = match name {
            Some(name) if !is_taken(&name, order) => (name, order),
            _ => (format!("z_{{{place}}}"), 0),
        };
        let dots = ["", r"\dot", r"\ddot"][order as usize];
        let latex = if order == 0 { name.clone() } else { format!("{dots}{{{name}}}") };
        all.push(Letter { name, order, latex, symbol, is_recorded: true });
    }
    let highest: Vec<(String, u32)> = all.iter().map(|letter| (letter.name.clone(), letter.order)).collect();
    for (name, order) in highest.iter().flat_map(|(name, order)| (0..*order).map(move |below| (name, below))) {
        if all.iter().all(|letter| letter.name != *name || letter.order != order) {
            let symbol = Sym::symbol(&format!("letter {name} {order}"));
            all.push(Letter { name: name.clone(), order, latex: String::new(), symbol, is_recorded: false });
        }
    }
    all
}

/// Pairs of each symbol of the page and a symbol with its printed LaTeX.
pub(super) fn in_print(letters: &[Letter]) -> Vec<(Sym, Sym)> {
    let recorded = letters.iter().filter(|letter| letter.is_recorded);
    recorded.map(|letter| (letter.symbol, Sym::named(&format!("·{}", letter.symbol), &letter.latex))).collect()
}
