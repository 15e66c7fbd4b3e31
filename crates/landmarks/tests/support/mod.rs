//! What the tests of this crate share: the networks, the portrait, and pictures made of it.

pub mod assets;
pub mod pictures;
