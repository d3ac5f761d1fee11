pub mod family;
