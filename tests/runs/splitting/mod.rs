//! The splitting methods on the gyrostat: pieces that are the law, what they keep, their orders, their dissipation.

mod heat;
mod kept;
mod long;
mod orders;
mod pieces;
mod runs;
mod stiff;
