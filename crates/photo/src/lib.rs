//! Bytes to an upright, bounded sRGB picture.
