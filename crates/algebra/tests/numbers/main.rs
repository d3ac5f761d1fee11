//! Numbers: roots, enclosures, linear equations.

mod balls;
mod linear;
mod real;
