//! Bytes to an upright, bounded sRGB picture.
//!
//! [`decode`] tells JPEG, PNG and WebP apart by their first bytes, refuses what is too large before it allocates the
//! pixels, applies the EXIF orientation exactly once, converts colours to sRGB that the file describes otherwise (a
//! profile such as Display P3; in PNG code points, PQ and HLG among them, or a gamma), and lays transparent pixels over
//! white. Of a JPEG, up to a twentieth of the rows may be lost, or the last refinements of a progressive one. What comes
//! out is a [`Photo`]: 8-bit RGB, row-major, upright, not mirrored; with the focal length that EXIF tells.

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
mod webp;

pub use decode::decode;
pub use error::PhotoError;
pub use limits::Limits;
pub use photo::Photo;
pub use sampler::Sampler;

/// The examples of the README are tested with those of the code.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
