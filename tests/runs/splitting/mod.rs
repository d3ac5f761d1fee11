//! The splitting methods on the gyrostat: consistency of the sub-flows, preserved quantities, orders, dissipation.

mod heat;
mod kept;
mod long;
mod orders;
mod pieces;
mod runs;
mod stiff;
