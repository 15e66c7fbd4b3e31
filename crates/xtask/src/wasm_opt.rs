//! npm's `wasm-opt` with a memory: it takes minutes over a large module, and most builds change only one of two.
//!
//! Trunk calls the `wasm-opt` that it finds on PATH. A script of that name leads it here, and a module that has been
//! optimised before, with the same options by the same version, is copied from the user's cache.

use crate::failure::{Doing, Failure, Outcome};
use crate::process::Run;
use crate::{cache, workspace};
use std::path::{Path, PathBuf};

const OUTPUT: &str = "--output=";
/// So many modules are remembered; older ones are forgotten.
const REMEMBERED: usize = 16;

/// Writes the script and returns its folder. Where scripts are not programs, Trunk finds npm's own `wasm-opt`.
pub fn script_folder() -> Outcome<PathBuf> {
    let folder = workspace::target().join("xtask").join("bin");
    std::fs::create_dir_all(&folder).doing("creating a folder for scripts")?;
    if cfg!(unix) {
        let here = std::env::current_exe().doing("finding this program")?;
        let script = folder.join("wasm-opt");
        cache::write(&script, format!("#!/bin/sh\nexec '{}' wasm-opt \"$@\"\n", here.display()))?;
        cache::make_executable(&script)?;
    }
    Ok(folder)
}

/// Does what `wasm-opt ARGUMENTS` does.
pub fn run(arguments: &[&str]) -> Outcome {
    let input = arguments.iter().find(|argument| !argument.starts_with('-'));
    let output = arguments.iter().find_map(|argument| argument.strip_prefix(OUTPUT));
    let (Some(input), Some(output)) = (input, output) else {
        print!("{}", optimise(arguments)?);
        return Ok(());
    };
    let options = arguments.iter().copied().filter(|argument| argument != input && !argument.starts_with(OUTPUT));
    let module = std::fs::read(input).doing(format!("reading {input}"))?;
    let identity =
        [cache::sha256(&module), optimise(&["--version"])?, options.collect::<Vec<_>>().join(" ")].join("\n");
    let folder = cache::folder()?.join("wasm-opt");
    let remembered = folder.join(cache::sha256(identity.as_bytes())).with_extension("wasm");
    if !remembered.is_file() {
        optimise(arguments)?;
        // Moved into place whole, in case another build reads it at this moment.
        let partial = remembered.with_extension(format!("partial-{}", std::process::id()));
        cache::copy(Path::new(output), &partial)?;
        std::fs::rename(&partial, &remembered).doing("remembering an optimised module")?;
        forget_oldest(&folder);
    }
    cache::copy(&remembered, Path::new(output))
}

fn optimise(arguments: &[&str]) -> Outcome<String> {
    let program = workspace::root().join("node_modules/binaryen/bin/wasm-opt");
    let ended = Run::new("node").arg(program).args(arguments).quietly()?;
    if ended.success { Ok(ended.output) } else { Err(Failure::new(ended.describe())) }
}

/// Best effort: a cache that stays too large for once does no harm.
fn forget_oldest(folder: &Path) {
    let Ok(entries) = std::fs::read_dir(folder) else { return };
    let mut modules: Vec<_> =
        entries.flatten().filter_map(|entry| Some((entry.metadata().ok()?.modified().ok()?, entry.path()))).collect();
    modules.sort();
    for (_, module) in modules.iter().rev().skip(REMEMBERED) {
        let _ = std::fs::remove_file(module);
    }
}
