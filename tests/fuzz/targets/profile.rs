//! Fuzzes the colour profile reader.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    rosto_fuzz::Kind::Profile.check(bytes);
});
