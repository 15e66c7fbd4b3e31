//! Fuzzes the reader of edit histories.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    rosto_fuzz::Kind::Edits.check(bytes);
});
