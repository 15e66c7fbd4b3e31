//! Fuzzes the GLB reader.

#![no_main]

use rosto_fuzz::Kind::Glb;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    Glb.check(bytes);
    Glb.check(&Glb.repaired(bytes.to_vec()));
});
