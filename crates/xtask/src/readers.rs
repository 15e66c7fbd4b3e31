//! `cargo xtask readers`: what each program that opens our files sees, Blender too.

use crate::figures::Document;
use crate::places::target;
use crate::run::announced;
use crate::{python, setup, steps};
use anyhow::{Result, bail, ensure};

/// Where the tables go.
pub const DOCUMENT: Document = Document { file: "docs/opens-elsewhere.md", task: "readers", figures: "figures" };
/// Several times as large as all the others together: not for every run of the tests.
const BLENDER: &str = "tests/readers/requirements-blender.txt";

/// Prints what all readers see; `--write` puts it into the document.
pub fn run(arguments: &[&str]) -> Result<()> {
    let write = match arguments {
        [] => false,
        ["--write"] => true,
        _ => bail!("unknown options {arguments:?}: the only option is --write"),
    };
    let kit = setup::for_tests()?;
    let blender = python::environment(&[BLENDER], "373 MB: Blender opens every file; its package is for Python 3.11")?;
    let readers = kit.npm("readers").env("ROSTO_CLI", steps::command_line()?).env("ROSTO_READERS_BLENDER", blender);
    let ended = announced("readers", "every file in other programs", || readers.run())?;
    let tables = fs_err::read_to_string(target().join("readers/tables.md"))?;
    println!("{}\n{tables}", ended.output);
    if write {
        DOCUMENT.update(tables.trim_end())?;
    }
    ensure!(ended.success, "a program does not open one of our files: see above");
    Ok(())
}
