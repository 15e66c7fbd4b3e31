//! Fuzzes the reader of colour profiles.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    rosto_fuzz::Kind::Profile.check(bytes);
});
