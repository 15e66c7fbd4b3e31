//! `cargo xtask readers`: every file in programs that are not ours, Blender included.

use crate::run::announced;
use crate::{python, rust, setup};
use anyhow::Result;

/// Several times as large as all other readers together: not for every run of the tests.
const BLENDER: &str = "tests/readers/requirements-blender.txt";

/// Opens every file with every reader.
pub fn run(_: &[&str]) -> Result<()> {
    let kit = setup::for_tests()?;
    let blender = python::environment(&[BLENDER], "373 MB: Blender opens every file; its package is for Python 3.11")?;
    let readers = kit.npm("readers").env("ROSTO_CLI", rust::command_line()?).env("ROSTO_READERS_BLENDER", blender);
    let output = announced("readers", "every file in other programs", || readers.checked())?;
    kit.report_missing();
    print!("{output}");
    Ok(())
}
