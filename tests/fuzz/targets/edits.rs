//! Fuzzes the reader of histories of edits.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    rosto_fuzz::Kind::Edits.check(bytes);
});
