//! Series of solutions, compared with known ones and with other ways of computing them.

mod known;
mod linear_unknowns;
