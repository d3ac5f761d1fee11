//! Common denominators as products of powers of divisors.
//!
//! A sum of quotients with common divisors contains each divisor only once. Without this, every sum would double the bound of the degree, and the
//! elimination of a few unknowns would exceed the degree that any field can test.

use super::bounds::Polynomial;
use rustc_hash::FxHashMap;

/// A product of powers of divisors, given by its index in [`Denominators`].
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(super) struct Denominator(u32);

/// All denominators of a program.
pub(super) struct Denominators {
    divisors: Vec<Polynomial>,
    products: Vec<Vec<Factor>>,
    places: FxHashMap<Vec<(u32, u64)>, Denominator>,
    joined: FxHashMap<(Operation, Denominator, Denominator), Denominator>,
}

/// A power of a divisor. The exponent is a floating-point number because powers of powers exceed integers.
#[derive(Clone, Copy)]
struct Factor {
    divisor: u32,
    exponent: f64,
}

#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Operation {
    Multiple,
    Product,
    Excess,
}

impl Denominators {
    /// Returns an empty list of divisors, and the denominator 1.
    pub fn new() -> (Self, Denominator) {
        let mut all = Denominators {
            divisors: Vec::new(),
            products: Vec::new(),
            places: FxHashMap::default(),
            joined: FxHashMap::default(),
        };
        let one = all.placed(Vec::new());
        (all, one)
    }

    /// Adds a divisor with the given bound.
    pub fn divisor(&mut self, bound: Polynomial) -> Denominator {
        let divisor = self.divisors.len() as u32;
        self.divisors.push(bound);
        self.placed(vec![Factor { divisor, exponent: 1.0 }])
    }

    /// Returns the least common multiple of two denominators.
    pub fn multiple(&mut self, a: Denominator, b: Denominator) -> Denominator {
        self.join(Operation::Multiple, a, b)
    }

    pub fn product(&mut self, a: Denominator, b: Denominator) -> Denominator {
        self.join(Operation::Product, a, b)
    }

    /// Returns a / gcd(a, b): the factors of `a` that `b` lacks.
    pub fn excess(&mut self, a: Denominator, b: Denominator) -> Denominator {
        self.join(Operation::Excess, a, b)
    }

    pub fn power(&mut self, a: Denominator, n: u32) -> Denominator {
        let raised = |factor: &Factor| Factor { exponent: factor.exponent * f64::from(n), ..*factor };
        let factors = self.products[a.0 as usize].iter().filter(|_| n > 0).map(raised).collect();
        self.placed(factors)
    }

    /// Returns the bound of the expanded product.
    pub fn bound(&self, a: Denominator) -> Polynomial {
        let one = Polynomial { degree: 0.0, bits: 0.0 };
        self.products[a.0 as usize].iter().fold(one, |product, &Factor { divisor, exponent }| {
            let Polynomial { degree, bits } = self.divisors[divisor as usize];
            product.times(Polynomial { degree: degree * exponent, bits: bits * exponent })
        })
    }

    fn join(&mut self, operation: Operation, a: Denominator, b: Denominator) -> Denominator {
        if let Some(&known) = self.joined.get(&(operation, a, b)) {
            return known;
        }
        let exponent = |a: f64, b: f64| match operation {
            Operation::Multiple => a.max(b),
            Operation::Product => a + b,
            Operation::Excess => (a - b).max(0.0),
        };
        let (mut left, mut right) =
            (self.products[a.0 as usize].iter().peekable(), self.products[b.0 as usize].iter().peekable());
        let mut factors = Vec::new();
        loop {
            let (first, second) = (left.peek().map(|factor| factor.divisor), right.peek().map(|factor| factor.divisor));
            let Some(divisor) = first.into_iter().chain(second).min() else { break };
            let of_left = left.next_if(|factor| factor.divisor == divisor).map_or(0.0, |factor| factor.exponent);
            let of_right = right.next_if(|factor| factor.divisor == divisor).map_or(0.0, |factor| factor.exponent);
            let exponent = exponent(of_left, of_right);
            if exponent > 0.0 {
                factors.push(Factor { divisor, exponent });
            }
        }
        let found = self.placed(factors);
        self.joined.insert((operation, a, b), found);
        found
    }

    fn placed(&mut self, factors: Vec<Factor>) -> Denominator {
        let key = factors.iter().map(|factor| (factor.divisor, factor.exponent.to_bits())).collect();
        let next = Denominator(self.products.len() as u32);
        let place = *self.places.entry(key).or_insert(next);
        if place == next {
            self.products.push(factors);
        }
        place
    }
}
