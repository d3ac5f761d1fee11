//! Series of solutions, known ones and those beside other ways.

mod known;
mod linear_unknowns;
