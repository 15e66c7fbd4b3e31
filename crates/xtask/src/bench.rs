//! `cargo xtask bench`: Rosto beside the paper's method and the peers, all in one run on this machine.
//!
//! Every measuring program prints one JSON object a line (see [`record`]); this module runs them one after the other
//! and sets their figures in tables.

mod plot;
mod record;
mod sources;
mod table;

use crate::figures::Document;
use crate::run::announced;
use crate::{machine, places, setup};
use anyhow::{Result, bail, ensure};
use record::Record;

/// Where the figures go.
pub const DOCUMENT: Document = Document { file: "docs/benchmarks.md", task: "bench", figures: "figures" };
const GROWTH: &str = "docs/images/growth.svg";

/// Measures and prints the tables; `--write` puts them into the document, and draws how time grows with size.
pub fn run(arguments: &[&str]) -> Result<()> {
    let (options, wanted): (Vec<&str>, Vec<&str>) = arguments.iter().partition(|argument| argument.starts_with('-'));
    let write = match options.as_slice() {
        [] => false,
        ["--write"] => true,
        _ => bail!("unknown options {options:?}: the only option is --write"),
    };
    let kit = setup::for_tests()?;
    let mut records = Vec::new();
    for source in sources::chosen(&wanted)? {
        let output = announced(source.name, source.what, || (source.measure)(&kit))?;
        let measured = record::read(&output);
        ensure!(!measured.is_empty(), "{} printed no figures: {output}", source.name);
        records.extend(measured);
    }
    let tables = table::all(&records);
    println!("\n{}\n\n{tables}", machine::describe());
    if write {
        DOCUMENT.update(&tables)?;
        draw_growth(&records)?;
    }
    Ok(())
}

fn draw_growth(records: &[Record]) -> Result<()> {
    let title = "Factorisation and one solve, on one thread";
    let Some(picture) = plot::growth("edit", title, records) else { return Ok(()) };
    Ok(fs_err::write(places::root().join(GROWTH), picture)?)
}
