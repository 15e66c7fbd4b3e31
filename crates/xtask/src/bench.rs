//! `cargo xtask bench`: Rosto beside the paper's method and the peers, all in one run on this machine.
//!
//! Every measuring program prints one JSON object a line (see [`record`]); this module runs them one after the other
//! and sets their figures in tables.

mod plot;
mod record;
mod sources;
mod table;

use crate::failure::{Failure, Result};
use crate::figures::Document;
use crate::{cache, machine, progress, setup, workspace};
use record::Record;
use std::process::ExitCode;
use std::time::Instant;

/// Where the figures go.
pub const DOCUMENT: Document = Document { file: "docs/benchmarks.md", task: "bench", figures: "figures" };
const GROWTH: &str = "docs/images/growth.svg";

/// Measures and prints the tables; `--write` puts them into the document, and draws how time grows with size.
pub fn run(arguments: &[&str]) -> Result<ExitCode> {
    let (options, wanted): (Vec<&str>, Vec<&str>) = arguments.iter().partition(|argument| argument.starts_with('-'));
    let write = match options.as_slice() {
        [] => false,
        ["--write"] => true,
        _ => return Err(Failure::new(format!("unknown options {options:?}")).advice("the only option is --write")),
    };
    let kit = setup::for_tests()?;
    let mut records = Vec::new();
    for source in sources::chosen(&wanted)? {
        progress::announce(source.name, source.what);
        let started = Instant::now();
        let output = (source.measure)(&kit)?;
        let measured = record::read(&output);
        if measured.is_empty() {
            return Err(Failure::new(format!("{} printed no figures", source.name)).tried(output));
        }
        records.extend(measured);
        progress::done(source.name, started);
    }
    let tables = table::all(&records);
    println!("\n{}\n\n{tables}", machine::describe());
    if write {
        DOCUMENT.update(&tables)?;
        draw_growth(&records)?;
    }
    Ok(ExitCode::SUCCESS)
}

fn draw_growth(records: &[Record]) -> Result {
    let title = "Factorisation and one solve, on one thread";
    let Some(picture) = plot::growth("edit", title, records) else { return Ok(()) };
    cache::write(&workspace::root().join(GROWTH), picture)
}
