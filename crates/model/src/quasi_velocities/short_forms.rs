//! Short forms of the derivatives of speeds: direction cosines are symbols, and cancel where R R^T = 1.

use super::inverse::Reading;
use crate::Trace;
use crate::presentation::{FreeTurn, short_form};
use rustc_hash::FxHashMap;
use symbolic::{Node, Sym};

/// Cached short forms of functions of coordinates, parameters and the time.
pub(super) struct ShortForms<'t, 'm> {
    trace: &'t Trace<'m>,
    turns: Vec<FreeTurn>,
    known: FxHashMap<Sym, Sym>,
}

impl<'t, 'm> ShortForms<'t, 'm> {
    pub fn of(trace: &'t Trace<'m>) -> Self {
        ShortForms { trace, turns: trace.turns().collect(), known: FxHashMap::default() }
    }

    /// Returns the number of operations of an expression, in which direction cosines count as one.
    pub fn size(&self, expression: Sym) -> usize {
        let cosines = self.turns.iter().flat_map(|(_, cosines)| cosines.iter().flatten());
        let letter = |(k, &cosine): (usize, &Sym)| (cosine, Sym::symbol(&format!("cosine {k}")));
        let letters: Vec<(Sym, Sym)> = cosines.enumerate().map(letter).collect();
        let parts = expression.substitute(&letters);
        Sym::operations_of(&[parts])
    }

    /// Returns the first of `letters` for which no numbered symbol is a symbol of the system; the last one if there is none.
    pub fn free_name<'a>(&self, letters: &[&'a str]) -> &'a str {
        let model = self.trace.model;
        let speeds = model.quasi_velocities.iter().map(|speed| speed.name.clone());
        let own = [&self.trace.parameters, &self.trace.coordinates].into_iter().flatten().map(Sym::to_string);
        let inputs = model.inputs.iter().map(|input| input.name.clone());
        let own: Vec<String> = own.chain(speeds).chain(inputs).collect();
        let numbered = |letter: &str, name: &String| {
            name.strip_prefix(letter).is_some_and(|rest| rest.chars().all(|sign| sign.is_ascii_digit()))
        };
        let is_free = |letter: &&&str| !own.iter().any(|name| numbered(letter, name));
        letters.iter().find(is_free).or(letters.last()).copied().unwrap_or_default()
    }

    /// Returns whether an expression is a nonzero constant, formed from numbers and parameters with nonzero values.
    fn is_constant_factor(&self, expression: Sym) -> bool {
        let mut open = vec![expression];
        while let Some(each) = open.pop() {
            match each.node() {
                Node::Constant(_) => {}
                Node::Product(a, b) | Node::Quotient(a, b) => open.extend([a, b]),
                Node::Negation(a) | Node::Power(a, _) => open.push(a),
                Node::Symbol(_) => {
                    let parameters = self.trace.parameters.iter().zip(&self.trace.model.parameters);
                    let mut values =
                        parameters.filter(|(letter, _)| **letter == each).map(|(_, parameter)| parameter.value);
                    if !matches!(values.next(), Some(Some(value)) if value != 0.0) && each != self.trace.pi {
                        return false;
                    }
                }
                _ => return false,
            }
        }
        expression != Sym::ZERO && expression != Sym::UNDEFINED
    }
}

impl Reading for ShortForms<'_, '_> {
    fn read(&mut self, expression: Sym) -> Sym {
        if expression.node().is_leaf() {
            return expression;
        }
        if let Some(&known) = self.known.get(&expression) {
            return known;
        }
        let form = short_form(expression, &self.turns);
        let operations = |each: Sym| Sym::operations_of(&[each]);
        let form = if operations(form) <= operations(expression) { form } else { expression };
        self.known.extend([(expression, form), (form, form)]);
        form
    }

    fn is_constant(&self, expression: Sym) -> bool {
        self.is_constant_factor(expression)
    }
}
