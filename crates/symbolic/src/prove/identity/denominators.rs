//! Common denominators as products of powers of divisors.
//!
//! Sums of quotients with the same divisors keep these divisors once. Without that, the bound of a degree doubles with every sum, and an
//! elimination of a few unknowns has a degree beyond any field.

use super::bounds::Polynomial;
use rustc_hash::FxHashMap;

/// A product of powers of divisors, by its place among those that are known.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(super) struct Denominator(u32);

/// All denominators of a program.
pub(super) struct Denominators {
    divisors: Vec<Polynomial>,
    products: Vec<Vec<Factor>>,
    places: FxHashMap<Vec<(u32, u64)>, Denominator>,
    joined: FxHashMap<(Operation, Denominator, Denominator), Denominator>,
}

/// A power of a divisor; exponents of towers of powers are beyond integers.
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
    /// The denominator 1 alone.
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

    /// A new divisor.
    pub fn divisor(&mut self, bound: Polynomial) -> Denominator {
        let divisor = self.divisors.len() as u32;
        self.divisors.push(bound);
        self.placed(vec![Factor { divisor, exponent: 1.0 }])
    }

    /// The least common multiple of two denominators.
    pub fn multiple(&mut self, a: Denominator, b: Denominator) -> Denominator {
        self.join(Operation::Multiple, a, b)
    }

    pub fn product(&mut self, a: Denominator, b: Denominator) -> Denominator {
        self.join(Operation::Product, a, b)
    }

    /// The factors of the first that the second has not.
    pub fn excess(&mut self, a: Denominator, b: Denominator) -> Denominator {
        self.join(Operation::Excess, a, b)
    }

    pub fn power(&mut self, a: Denominator, n: u32) -> Denominator {
        let raised = |factor: &Factor| Factor { exponent: factor.exponent * f64::from(n), ..*factor };
        let factors = self.products[a.0 as usize].iter().filter(|_| n > 0).map(raised).collect();
        self.placed(factors)
    }

    /// The product written out.
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
