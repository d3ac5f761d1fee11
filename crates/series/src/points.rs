//! Circle points as states, c' = -a' s, s' = a' c, and elementary functions, whose derivatives are functions of their
//! values and arguments.

use super::build::{Builder, Definition};
use super::form::Form;
use symbolic::{Node, Sym};

impl Builder<'_> {
    /// Introduces states for all circle points and elementary functions in the rates, in the linear equations, and in
    /// the rates of these states.
    pub fn admit_points(&mut self, rates: &mut Vec<Sym>, solved: &[Sym]) {
        let mut fresh = [&rates[..], solved].concat();
        while !fresh.is_empty() {
            let inside = Sym::reached(&fresh, |each, _| !self.forms.contains_key(&each));
            let known = rates.len();
            for each in inside {
                let is_point = matches!(each.node(), Node::Cos(_) | Node::Sin(_) | Node::Elementary(..));
                if !is_point || self.forms.contains_key(&each) || !self.moves(each) {
                    continue;
                }
                match each.node() {
                    Node::Cos(angle) | Node::Sin(angle) => {
                        let [cos, sin] = [Node::Cos(angle), Node::Sin(angle)].map(Sym::from_node);
                        let rate = self.rate(angle);
                        self.circles.push(self.definitions.len());
                        self.admit(cos, -(sin * rate), rates);
                        self.admit(sin, cos * rate, rates);
                    }
                    Node::Elementary(function, a, b) => {
                        let slopes = function.slopes(a, b, each).into_iter().zip([a, b]);
                        let moving = slopes.filter(|(slope, _)| *slope != Sym::ZERO);
                        let rate = moving.fold(Sym::ZERO, |sum, (slope, argument)| sum + slope * self.rate(argument));
                        self.admit(each, rate, rates);
                    }
                    _ => {}
                }
            }
            fresh = rates[known..].to_vec();
        }
    }

    /// Introduces a state for an expression.
    fn admit(&mut self, point: Sym, rate: Sym, rates: &mut Vec<Sym>) {
        self.forms.insert(point, Form::atom(self.definitions.len()));
        self.definitions.push(Definition::State);
        self.points.push(point);
        rates.push(rate);
    }

    fn moves(&self, expression: Sym) -> bool {
        let moving = |each: &Sym| self.equations.state.contains(each) || self.equations.time == Some(*each);
        Sym::ascending(&[expression]).iter().any(moving)
    }

    /// The rate of an expression along the solution, by the chain rule.
    fn rate(&self, expression: Sym) -> Sym {
        let by_time = self.equations.time.map_or(Sym::ZERO, |time| expression.diff(time));
        let states = self.equations.state.iter().zip(self.equations.rates);
        states.fold(by_time, |sum, (&state, &rate)| sum + expression.diff(state) * rate)
    }
}
