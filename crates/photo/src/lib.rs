//! Decodes photos to upright, bounded sRGB pictures.
//!
//! [`decode`] detects JPEG, PNG and WebP by their first bytes and checks the size before it allocates the pixels. It
//! applies the EXIF orientation once, converts the colours to sRGB, and blends transparent pixels over white. The colour
//! encoding comes from an ICC profile such as Display P3 or, in PNG, from code points or a gamma.
//!
//! A JPEG may lack up to a twentieth of its rows, or the last refinement bits if it is progressive. The result is a
//! [`Photo`]: 8-bit RGB, row-major, upright, not mirrored, with the focal length from EXIF.

mod code_points;
mod colour;
mod decode;
mod error;
mod exif;
mod format;
mod icc;
mod jpeg;
mod limits;
mod photo;
mod pixels;
mod png;
mod primaries;
mod resize;
mod sampler;
mod stored;
mod vectors;
mod webp;

pub use decode::decode;
pub use error::PhotoError;
pub use limits::Limits;
pub use photo::Photo;
pub use sampler::Sampler;
pub use vectors::widest;

/// Runs the README's examples as doc-tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
