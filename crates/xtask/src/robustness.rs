//! `cargo xtask robustness`: which faces are found in pictures of which it is known where the faces are, beside MediaPipe.

use crate::figures::Document;
use crate::run::{Run, announced};
use crate::setup;
use anyhow::{Result, bail};

/// Where the tables go.
pub const DOCUMENT: Document = Document { file: "docs/robustness.md", task: "robustness", figures: "figures" };

/// Prints the tables; `--write` puts them into the document.
pub fn run(arguments: &[&str]) -> Result<()> {
    let write = match arguments {
        [] => false,
        ["--write"] => true,
        _ => bail!("unknown options {arguments:?}: the only option is --write"),
    };
    setup::for_tests()?;
    let example =
        Run::new("cargo").words("run --quiet --release --locked --package rosto-landmarks --example robustness");
    let tables =
        announced("robustness", "faces turned, small, cut, dark, blurred and in groups", || example.checked())?;
    println!("\n{tables}");
    if write {
        DOCUMENT.update(tables.trim_end())?;
    }
    Ok(())
}
