//! Series of solutions, against known ones and against other ways of computing them.

mod known;
mod linear_unknowns;
