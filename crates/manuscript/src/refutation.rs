//! Exact points at which a claim fails.

use claims::{Condition, Point};
use symbolic::{Hypotheses, Node, Sym, normal};

/// An exact point at which an expression does not vanish, or has a wrong sign.
pub(crate) struct Refutation {
    /// Symbols of the model, cosines and sines of its angles, with their values.
    pub point: Vec<(Sym, Sym)>,
    /// Whether sines and cosines are taken as independent of their angles.
    pub is_formal: bool,
}

impl Refutation {
    /// The value of an expression there, where the point gives it one.
    pub fn value(&self, expression: Sym) -> Option<Sym> {
        let found = expression.substitute(&self.point);
        let form = normal(found, &Hypotheses::none()).ok()?.to_sym();
        form.symbols_of().is_empty().then_some(form)
    }

    /// Whether a condition holds there; none where the point leaves it open.
    pub fn satisfies(&self, condition: Condition) -> Option<bool> {
        condition.holds_at(&exact(&self.point))
    }
}

/// The rational values of a point, by the names under which expressions look them up.
pub(crate) fn exact(point: &[(Sym, Sym)]) -> Point {
    let name = |symbol: Sym| match symbol.node() {
        Node::Cos(angle) if angle.symbol_name().is_some() => format!("cos {angle}"),
        Node::Sin(angle) if angle.symbol_name().is_some() => format!("sin {angle}"),
        _ => symbol.to_string(),
    };
    Point::named(point.iter().filter_map(|(symbol, value)| Some((name(*symbol), value.as_constant()?))))
}
