//! The hash-consed expression graph of a thread: expressions with equal text share one node.

use dashu_ratio::RBig;
use field::{Elementary, Rational};
use rustc_hash::{FxBuildHasher, FxHashMap};
use std::cell::RefCell;
use std::marker::PhantomData;
use std::rc::Rc;

/// An expression: a handle into the expression graph of the current thread. `==` compares expressions literally;
/// [`decide`](crate::decide) decides whether two expressions have equal values.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Sym {
    id: u32,
    /// A handle is valid only in its own thread; the marker makes the type neither `Send` nor `Sync`.
    local: PhantomData<*const ()>,
}

/// An index into the table of names.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Name(u32);

/// An index into the table of constants.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Constant(u32);

/// A node of the graph: a leaf, or an operation on other expressions.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Node {
    Constant(Constant),
    Symbol(Name),
    Sum(Sym, Sym),
    Difference(Sym, Sym),
    Product(Sym, Sym),
    Quotient(Sym, Sym),
    Negation(Sym),
    /// A power with an integer exponent of at least two.
    Power(Sym, u32),
    Cos(Sym),
    Sin(Sym),
    /// The non-negative square root.
    Root(Sym),
    /// An elementary function. A function of one argument stores its argument twice.
    Elementary(Elementary, Sym, Sym),
    /// The derivative, of the given order, of a named smooth function of one argument. The order 0 is the function itself.
    Function(Name, u32, Sym),
}

impl Node {
    /// Returns whether the node is a leaf of rational expressions: a symbol, cosine, sine, root or function.
    pub fn is_leaf(self) -> bool {
        let function = matches!(self, Node::Root(_) | Node::Elementary(..) | Node::Function(..));
        function || matches!(self, Node::Symbol(_) | Node::Cos(_) | Node::Sin(_))
    }

    /// Returns the operands of the node.
    pub fn children(self) -> impl Iterator<Item = Sym> {
        let (first, second) = match self {
            Node::Constant(_) | Node::Symbol(_) => (None, None),
            Node::Sum(a, b)
            | Node::Difference(a, b)
            | Node::Product(a, b)
            | Node::Quotient(a, b)
            | Node::Elementary(_, a, b) => (Some(a), Some(b)),
            Node::Negation(a)
            | Node::Power(a, _)
            | Node::Cos(a)
            | Node::Sin(a)
            | Node::Root(a)
            | Node::Function(_, _, a) => (Some(a), None),
        };
        first.into_iter().chain(second)
    }
}

#[derive(Clone)]
struct Naming {
    text: Rc<str>,
    latex: Option<Rc<str>>,
}

struct Graph {
    nodes: Vec<Node>,
    known: FxHashMap<Node, Sym>,
    constants: Vec<Rational>,
    known_constants: FxHashMap<RBig, Constant>,
    names: Vec<Naming>,
    known_names: FxHashMap<Rc<str>, Name>,
    visits: RefCell<Visits>,
}

/// Marks of visited nodes. A node is visited if its mark equals the number of the current traversal.
#[derive(Default)]
struct Visits {
    walk: u32,
    marks: Vec<u32>,
}

impl Visits {
    fn begin(&mut self, nodes: usize) {
        self.walk = self.walk.wrapping_add(1);
        if self.walk == 0 {
            self.marks.fill(0);
            self.walk = 1;
        }
        self.marks.resize(nodes, 0);
    }

    /// Marks the node. Returns whether it was not yet visited.
    #[inline]
    fn meets(&mut self, node: Sym) -> bool {
        std::mem::replace(&mut self.marks[node.id as usize], self.walk) != self.walk
    }
}

/// The initial capacity, enough for a small statement: growing the tables up to this size would take longer.
const EXPECTED: usize = 896;

thread_local! {
    static GRAPH: RefCell<Graph> = RefCell::new(Graph::new());
}

impl Graph {
    /// Creates a graph with four fixed nodes: 0, 1, -1 and the undefined constant.
    fn new() -> Self {
        let mut graph = Graph {
            nodes: Vec::with_capacity(EXPECTED),
            known: FxHashMap::with_capacity_and_hasher(EXPECTED, FxBuildHasher),
            constants: vec![Rational::UNDEFINED],
            known_constants: FxHashMap::default(),
            names: Vec::new(),
            known_names: FxHashMap::default(),
            visits: RefCell::default(),
        };
        for value in [Rational::new(0, 1), Rational::new(1, 1), Rational::new(-1, 1), Rational::UNDEFINED] {
            graph.constant(value);
        }
        graph
    }

    fn intern(&mut self, node: Node) -> Sym {
        *self.known.entry(node).or_insert_with(|| {
            self.nodes.push(node);
            Sym::at(self.nodes.len() as u32 - 1)
        })
    }

    fn constant(&mut self, value: Rational) -> Sym {
        let place = match value.to_big() {
            None => Constant(0),
            Some(big) => *self.known_constants.entry(big).or_insert_with(|| {
                self.constants.push(value);
                Constant(self.constants.len() as u32 - 1)
            }),
        };
        self.intern(Node::Constant(place))
    }

    fn name(&mut self, text: &str) -> Name {
        if let Some(&known) = self.known_names.get(text) {
            return known;
        }
        let text: Rc<str> = text.into();
        self.names.push(Naming { text: text.clone(), latex: None });
        let name = Name(self.names.len() as u32 - 1);
        self.known_names.insert(text, name);
        name
    }
}

/// Runs `work` with a new expression graph, which is dropped afterwards. The results then do not depend on earlier expressions of the thread.
/// The bounds `Send` prevent expressions from being passed in or out, where they would be invalid.
pub fn apart<R: Send>(work: impl FnOnce() -> R + Send) -> R {
    /// Stores the thread's own graph, and restores it even if `work` panics.
    struct Own(Graph);

    impl Own {
        fn exchange(&mut self) {
            GRAPH.with_borrow_mut(|graph| std::mem::swap(graph, &mut self.0));
        }
    }

    impl Drop for Own {
        fn drop(&mut self) {
            self.exchange();
        }
    }

    let mut own = Own(Graph::new());
    own.exchange();
    work()
}

impl Sym {
    /// The constant 0.
    pub const ZERO: Sym = Sym::at(0);
    /// The constant 1.
    pub const ONE: Sym = Sym::at(1);
    pub(crate) const MINUS_ONE: Sym = Sym::at(2);

    /// The result of a division by the constant zero. Every operation with it is undefined.
    pub const UNDEFINED: Sym = Sym::at(3);

    const fn at(id: u32) -> Self {
        Sym { id, local: PhantomData }
    }

    /// Returns the node of the expression.
    pub fn node(self) -> Node {
        GRAPH.with_borrow(|graph| graph.nodes[self.id as usize])
    }

    /// Returns the value of a constant; `None` for other expressions.
    pub fn as_constant(self) -> Option<Rational> {
        GRAPH.with_borrow(|graph| match graph.nodes[self.id as usize] {
            Node::Constant(place) => Some(graph.constants[place.0 as usize]),
            _ => None,
        })
    }

    /// Returns the expression of a node without simplification (the arithmetic operators simplify).
    pub fn from_node(node: Node) -> Self {
        GRAPH.with_borrow_mut(|graph| graph.intern(node))
    }

    /// Returns the constant expression with this value.
    pub fn constant(value: Rational) -> Self {
        GRAPH.with_borrow_mut(|graph| graph.constant(value))
    }

    /// Returns the given expressions and all their subexpressions. Operands precede the operations on them.
    pub fn ascending(roots: &[Sym]) -> Vec<Sym> {
        Sym::reached(roots, |_, _| true)
    }

    /// Returns [`Sym::ascending`] without the arguments of leaves.
    pub(crate) fn ascending_to_leaves(roots: &[Sym]) -> Vec<Sym> {
        Sym::reached(roots, |_, node| !node.is_leaf())
    }

    /// Returns [`Sym::ascending`] without the operands of expressions for which `open_up` is false.
    pub fn reached(roots: &[Sym], open_up: impl Fn(Sym, Node) -> bool) -> Vec<Sym> {
        GRAPH.with_borrow(|graph| {
            let mut visits = graph.visits.borrow_mut();
            visits.begin(graph.nodes.len());
            let mut open = roots.to_vec();
            let mut all = Vec::new();
            while let Some(next) = open.pop() {
                if visits.meets(next) {
                    all.push(next);
                    let node = graph.nodes[next.id as usize];
                    if open_up(next, node) {
                        open.extend(node.children());
                    }
                }
            }
            // a node has a larger index than its operands
            all.sort_unstable();
            all
        })
    }
}

impl Name {
    pub(crate) fn of(text: &str) -> Self {
        GRAPH.with_borrow_mut(|graph| graph.name(text))
    }

    pub(crate) fn text(self) -> Rc<str> {
        GRAPH.with_borrow(|graph| graph.names[self.0 as usize].text.clone())
    }

    pub(crate) fn latex(self) -> Option<Rc<str>> {
        GRAPH.with_borrow(|graph| graph.names[self.0 as usize].latex.clone())
    }

    pub(crate) fn set_latex(self, latex: &str) {
        GRAPH.with_borrow_mut(|graph| graph.names[self.0 as usize].latex = Some(latex.into()));
    }
}
