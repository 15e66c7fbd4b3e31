//! On what the figures were taken.

use crate::run::Run;

/// One line: processor, number of cores, compiler.
pub fn describe() -> String {
    let cores = std::thread::available_parallelism().map_or_else(|_| "?".to_owned(), |cores| cores.to_string());
    let compiler = Run::new("rustc").arg("--version").checked().unwrap_or_default();
    format!("Measured on {} with {cores} cores, {}.", processor(), compiler.trim())
}

fn processor() -> String {
    let linux = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = linux.lines().find_map(|line| line.strip_prefix("model name")?.split_once(": "));
    let elsewhere = || format!("a {} machine under {}", std::env::consts::ARCH, std::env::consts::OS);
    model.map_or_else(elsewhere, |(_, model)| model.trim().to_owned())
}
