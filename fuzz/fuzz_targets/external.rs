#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| meshmend_fuzz::external(data));
