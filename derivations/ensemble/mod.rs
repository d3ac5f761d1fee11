pub mod draw;
pub mod kind;
pub mod vary;
