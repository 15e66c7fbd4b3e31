//! Fuzzes the project reader.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    rosto_fuzz::Kind::Project.check(bytes);
});
