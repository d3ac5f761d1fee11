//! Expressions as a straight-line program: operations in order of evaluation, each with the indices of its arguments.

use crate::Sym;
use crate::graph::Node;
use rustc_hash::FxHashMap;

pub(super) struct Program {
    pub parts: Vec<Part>,
    /// The indices of the given expressions.
    pub results: Vec<usize>,
}

/// One operation of the program.
#[derive(Clone, Copy)]
pub(super) struct Part {
    pub is: Sym,
    pub node: Node,
    /// The indices of the arguments; zero for missing arguments.
    pub arguments: [usize; 2],
}

impl Program {
    pub fn of(expressions: &[Sym]) -> Self {
        let nodes = Sym::ascending(expressions);
        let places: FxHashMap<Sym, usize> = nodes.iter().enumerate().map(|(place, &each)| (each, place)).collect();
        let part = |&is: &Sym| {
            let (node, mut arguments) = (is.node(), [0, 0]);
            arguments.iter_mut().zip(node.children()).for_each(|(place, child)| *place = places[&child]);
            Part { is, node, arguments }
        };
        Program {
            parts: nodes.iter().map(part).collect(),
            results: expressions.iter().map(|each| places[each]).collect(),
        }
    }
}
