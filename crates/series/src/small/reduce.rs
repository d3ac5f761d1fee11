//! Reduction of equations in sums and products to a small law.

use super::law::{Law, Solved, Sums};
use crate::build::{Builder, Definition};
use crate::form::{Atom, Form};
use crate::plan::Coefficients;
use symbolic::Sym;

/// The largest numbers of quantities and of products of a small law.
const MOST_QUANTITIES: usize = 24;
const MOST_PRODUCTS: usize = 24;

/// The coefficients of a sum, by index: of its constant, of quantities, of products.
type Terms = (Option<u32>, Vec<(usize, u32)>, Vec<(usize, u32)>);

/// The role of a quantity of the builder in the small law.
#[derive(Clone, Copy)]
enum Role {
    Unused,
    Moving(usize),
    /// A solved quantity, in the order of solution.
    Solved(usize),
    Product(usize),
}

/// The law under construction. Solved quantities get their final indices when all moving ones are known.
struct Making<'a> {
    builder: &'a Builder<'a>,
    /// The number of states, circle points, and time.
    symbols: usize,
    roles: Vec<Role>,
    /// The rates of all moving quantities.
    rows: Vec<Form>,
    /// The moving sums; the first one comes after the symbols.
    starts: Vec<&'a Form>,
    solved: Vec<Solved>,
    /// The sums among the solved quantities.
    sums: Vec<(usize, &'a Form)>,
    products: Vec<[Role; 2]>,
    coefficients: Coefficients,
}

impl<'a> Making<'a> {
    fn new(builder: &'a Builder<'a>) -> Self {
        let symbols = builder.equations.state.iter().chain(&builder.equations.time).chain(&builder.points).count();
        Making {
            builder,
            roles: (0..symbols).map(Role::Moving).collect(),
            symbols,
            rows: builder.rates.clone(),
            starts: Vec::new(),
            solved: Vec::new(),
            sums: Vec::new(),
            products: Vec::new(),
            coefficients: Coefficients::default(),
        }
    }

    /// The role of the next definition; `None` where a small law has none for it.
    fn role(&mut self, definition: &'a Definition) -> Option<Role> {
        match definition {
            Definition::State | Definition::Unknown => None,
            Definition::Sum(form) if form.linear.keys().all(|part| *part < self.symbols) => Some(self.moving(form)),
            Definition::Sum(form) => {
                self.sums.push((self.solved.len(), form));
                Some(self.solve(Solved::Sum { constant: None, linear: Vec::new(), products: Vec::new() }))
            }
            Definition::Product(a, b) => {
                let factors = [self.factor(*a), self.factor(*b)];
                Some(self.product(factors))
            }
            Definition::Quotient(above, below) => self.quotient(*above, *below),
            Definition::Root(of) => self.root(*of),
        }
    }

    /// Adds a moving sum: its rate is the sum of the rates of its parts. If parts decay equally, y' = l y + .., the sum
    /// has the term l s: s' = l s + .. .
    fn moving(&mut self, form: &'a Form) -> Role {
        self.starts.push(form);
        let parts = || form.linear.iter().map(|(&part, c)| (part, c.0));
        let row = parts().fold(Form::default(), |sum, (part, c)| sum.plus(&self.builder.rates[part], c));
        let own = self.roles.len();
        let alike = parts().filter_map(|(part, c)| {
            let decay = row.linear.get(&part)?.0 / c;
            let mut row = row.clone().plus(form, -decay);
            row.add_atom(own, decay);
            Some(row)
        });
        let shorter = |best: Form, other: Form| if other.terms() < best.terms() { other } else { best };
        self.rows.push(alike.fold(row.clone(), shorter));
        Role::Moving(self.rows.len() - 1)
    }

    fn solve(&mut self, solved: Solved) -> Role {
        self.solved.push(solved);
        Role::Solved(self.solved.len() - 1)
    }

    fn product(&mut self, factors: [Role; 2]) -> Role {
        self.products.push(factors);
        Role::Product(self.products.len() - 1)
    }

    /// A quantity that can be a factor; a product becomes a solved quantity.
    fn factor(&mut self, atom: Atom) -> Role {
        match self.roles[atom] {
            Role::Product(product) => {
                let one = self.coefficients.number(Sym::ONE);
                self.solve(Solved::Sum { constant: None, linear: Vec::new(), products: vec![(product, one)] })
            }
            role => role,
        }
    }

    /// Adds a quotient, with the product that it solves.
    fn quotient(&mut self, above: Option<Atom>, below: Atom) -> Option<Role> {
        let (above, below) = (above.map(|above| self.factor(above)), self.factor(below));
        let product = self.products.len();
        self.product([Role::Solved(self.solved.len()), below]);
        let above = match above {
            Some(above) => Some(Self::number(above)?),
            None => None,
        };
        Some(self.solve(Solved::Quotient { above, of: Self::number(below)?, product }))
    }

    /// Adds a square root, with the product that it solves.
    fn root(&mut self, of: Atom) -> Option<Role> {
        let (of, own, product) = (self.factor(of), Role::Solved(self.solved.len()), self.products.len());
        self.product([own, own]);
        Some(self.solve(Solved::Root { of: Self::number(of)?, product }))
    }

    /// The preliminary index of a factor: solved quantities come after the moving ones, whose number is not known yet.
    fn number(factor: Role) -> Option<usize> {
        match factor {
            Role::Moving(number) => Some(number),
            Role::Solved(number) => Some(MOST_QUANTITIES + number),
            Role::Unused | Role::Product(_) => None,
        }
    }

    /// The final index of a quantity.
    fn quantity(&self, role: Role) -> Option<usize> {
        match role {
            Role::Moving(number) => Some(number),
            Role::Solved(number) => Some(self.rows.len() + number),
            Role::Unused | Role::Product(_) => None,
        }
    }

    fn terms(&mut self, form: &Form) -> Option<Terms> {
        let constant = (form.constant.0 != Sym::ZERO).then(|| self.coefficients.number(form.constant.0));
        let (mut linear, mut products) = (Vec::new(), Vec::new());
        for (&atom, c) in &form.linear {
            let number = self.coefficients.number(c.0);
            match self.roles[atom] {
                Role::Product(product) => products.push((product, number)),
                role => linear.push((self.quantity(role)?, number)),
            }
        }
        Some((constant, linear, products))
    }

    /// The law, when all definitions have their roles.
    fn law(&mut self) -> Option<Law> {
        let moving = self.rows.len();
        let products = self.products.iter().map(|[a, b]| Some([self.quantity(*a)?, self.quantity(*b)?]));
        let mut law =
            Law { moving, sums: self.starts.len(), products: products.collect::<Option<_>>()?, ..Law::default() };
        for (row, form) in self.rows.clone().iter().enumerate() {
            law.rates.add(row, self.terms(form)?);
        }
        for (row, form) in (self.symbols..).zip(std::mem::take(&mut self.starts)) {
            law.starts.add(row, self.terms(form)?);
        }
        for (number, form) in std::mem::take(&mut self.sums) {
            let (constant, linear, products) = self.terms(form)?;
            self.solved[number] = Solved::Sum { constant, linear, products };
        }
        law.solved = std::mem::take(&mut self.solved);
        for each in &mut law.solved {
            let parts = match each {
                Solved::Sum { .. } => [None, None],
                Solved::Quotient { above, of, .. } => [above.as_mut(), Some(of)],
                Solved::Root { of, .. } => [None, Some(of)],
            };
            for part in parts.into_iter().flatten().filter(|part| **part >= MOST_QUANTITIES) {
                *part = *part - MOST_QUANTITIES + moving;
            }
        }
        law.coefficients = self.coefficients.all.len();
        Some(law)
    }
}

impl Sums {
    fn add(&mut self, row: usize, (constant, linear, products): Terms) {
        self.constants.extend(constant.map(|number| (row, number)));
        self.linear.extend(linear.into_iter().map(|(quantity, number)| (row, quantity, number)));
        self.quadratic.extend(products.into_iter().map(|(product, number)| (row, product, number)));
    }
}

impl Law {
    /// The law, with the expressions of its coefficients; `None` where there are too many quantities.
    pub fn of(builder: &Builder<'_>) -> Option<(Self, Vec<Sym>)> {
        let mut making = Making::new(builder);
        let begin = making.symbols;
        for (definition, used) in builder.definitions.iter().zip(builder.used()).skip(begin) {
            let role = if used { making.role(definition)? } else { Role::Unused };
            making.roles.push(role);
        }
        let few = making.rows.len() + making.solved.len() <= MOST_QUANTITIES && making.products.len() <= MOST_PRODUCTS;
        if !few || making.products.is_empty() {
            return None;
        }
        let law = making.law()?;
        Some((law, making.coefficients.all))
    }
}
