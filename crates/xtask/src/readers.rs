//! `cargo xtask readers`: opens exported files in other programs, including Blender.

use crate::run::announced;
use crate::{python, rust, setup};
use anyhow::Result;

/// Separate, because it is several times as large as the other readers together.
const BLENDER: &str = "tests/readers/requirements-blender.txt";

/// Opens each file with each reader.
pub fn run(_: &[&str]) -> Result<()> {
    let kit = setup::for_tests()?;
    let blender = python::environment(&[BLENDER], "373 MB: Blender; needs Python 3.11")?;
    let readers = kit.npm("readers").env("ROSTO_CLI", rust::command_line()?).env("ROSTO_READERS_BLENDER", blender);
    let output = announced("readers", "opens exported files in other programs", || readers.checked())?;
    kit.report_missing();
    print!("{output}");
    Ok(())
}
