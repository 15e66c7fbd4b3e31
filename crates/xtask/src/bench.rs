//! `cargo xtask bench`: Rosto beside the paper's method and the peers, all in one run on this machine.
//!
//! Every measuring program prints one JSON object a line (see [`record`]); this module runs them one after the other
//! and sets their figures in tables.

mod machine;
mod plot;
mod record;
mod sources;
mod table;

use crate::failure::{Failure, Outcome};
use crate::{cache, progress, setup, workspace};
use record::Record;
use std::process::ExitCode;
use std::time::Instant;

const DOCUMENT: &str = "docs/benchmarks.md";
const GROWTH: &str = "docs/images/growth.svg";
const BEGIN: &str = "<!-- figures: written by `cargo xtask bench --write` -->\n";
const END: &str = "<!-- end of figures -->\n";

/// Measures and prints the tables; `--write` puts them into the document, and draws how time grows with size.
pub fn run(arguments: &[&str]) -> Outcome<ExitCode> {
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
        update_document(&tables)?;
        draw_growth(&records)?;
    }
    Ok(ExitCode::SUCCESS)
}

fn draw_growth(records: &[Record]) -> Outcome {
    let title = "Factorisation and one solve, on one thread";
    let Some(picture) = plot::growth("edit", title, records) else { return Ok(()) };
    cache::write(&workspace::root().join(GROWTH), picture)
}

fn update_document(tables: &str) -> Outcome {
    let file = workspace::root().join(DOCUMENT);
    let present = std::fs::read_to_string(&file).unwrap_or_else(|_| format!("# Benchmarks\n\n{BEGIN}{END}"));
    let figures = format!("{}\n\n{tables}\n", machine::describe());
    cache::write(&file, with_figures(&present, &figures)?)?;
    println!("{DOCUMENT} is up to date.");
    Ok(())
}

/// The document with what stands between its two marks replaced.
fn with_figures(document: &str, figures: &str) -> Outcome<String> {
    let missing = || Failure::new(format!("{DOCUMENT} has lost the marks between which the figures stand"));
    let (before, rest) = document.split_once(BEGIN).ok_or_else(missing)?;
    let (_, after) = rest.split_once(END).ok_or_else(missing)?;
    Ok(format!("{before}{BEGIN}{figures}{END}{after}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_figures_are_replaced() {
        let document = format!("# Title\nprose\n{BEGIN}old\n{END}more\n");
        let updated = with_figures(&document, "new\n").unwrap();
        assert_eq!(updated, format!("# Title\nprose\n{BEGIN}new\n{END}more\n"));
        assert!(with_figures("no marks", "new").is_err());
    }
}
