//! Papers, each a page of claims in the paper's own order and letters.

pub mod konosevich2022;
pub mod manglieva2022;
pub mod mukharlyamov2007;
