//! Fuzzes the picture decoder.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    rosto_fuzz::Kind::Picture.check(bytes);
});
