//! Refuses options that would have no effect.

use clap::ArgMatches;
use clap::parser::ValueSource;
use rosto::{Error, ExportOption, FileOptions, Format, MeshRequest, Units};
use rosto_studio::{AnchorKind, Anchors, Command};

use crate::args::{EditArguments, MeshTask, PhotoTask, SettingsArguments};
use crate::error::CliError;
use crate::output;

/// Options that affect edits, with their ids in [`crate::args::SettingsArguments`].
const SETTINGS: [(&str, &str); 8] = [
    ("operator", "--operator"),
    ("constraint", "--constraint"),
    ("anchors", "--anchors"),
    ("seed", "--seed"),
    ("pins", "--pin"),
    ("radius", "--radius"),
    ("mirror", "--mirror"),
    ("turn_details", "--turn-details"),
];

/// Arguments given on the command line, rather than defaults.
pub struct Given<'a>(pub &'a ArgMatches);

impl Given<'_> {
    fn has(&self, id: &str) -> bool {
        self.0.value_source(id) == Some(ValueSource::CommandLine)
    }
}

/// Refuses options of `rosto photo` without effect.
pub fn check_photo(task: &PhotoTask, given: &Given<'_>) -> Result<(), CliError> {
    if !is_edited(&task.edits) && task.seen_from_m.is_none() {
        for (id, flag) in [("falloff_band", "--falloff-band"), ("protected", "--keep")] {
            if given.has(id) {
                return no_effect(flag, "the photo is not edited");
            }
        }
    }
    check_settings(&task.edits, &task.settings, given)
}

/// Refuses options of the file without effect.
pub fn check_file(
    task: &MeshTask,
    request: &MeshRequest,
    format: Format,
    file: &FileOptions,
    given: &Given<'_>,
) -> Result<(), CliError> {
    let options: Vec<ExportOption> =
        ExportOption::ALL.into_iter().filter(|option| given.has(&argument_of(*option))).collect();
    request.check_file(format, file, &options).map_err(|reason| match reason {
        Error::NoEffect { option, reason } => CliError::NoEffect { flag: flag_of(option), reason },
        Error::ImageUnits => CliError::ImageUnits { path: task.output.clone() },
        reason => CliError::in_photos(reason, &[]),
    })?;
    if task.camera.card_px.is_some() && (task.photos.len() > 1 || output::is_pattern(&task.output)) {
        return no_effect("--card-px", "a card is in one photo; give only this photo");
    }
    if task.photos.len() > 1 && !output::is_pattern(&task.output) && task.units == Units::Image {
        return no_effect("a second photo", "image coordinates belong to one photo; use --units mm");
    }
    Ok(())
}

/// Id of an option's argument in [`crate::args::FileArguments`].
fn argument_of(option: ExportOption) -> String {
    match option {
        ExportOption::Edits => "morph_targets".to_owned(),
        ExportOption::Expressions => "expression_targets".to_owned(),
        other => other.id().replace('-', "_"),
    }
}

fn flag_of(option: ExportOption) -> String {
    match option {
        ExportOption::Edits => "--morph-targets".to_owned(),
        other => format!("--{}", other.id()),
    }
}

/// Refuses settings that no given edit uses.
pub fn check_settings(edits: &EditArguments, settings: &SettingsArguments, given: &Given<'_>) -> Result<(), CliError> {
    if !moves(edits)
        && let Some((_, flag)) = SETTINGS.into_iter().find(|(id, _)| given.has(id))
    {
        return no_effect(flag, "it needs --edit, --edits or --region");
    }
    let uses_anchor_rule = uses_anchor_rule(edits);
    refuse_first(&[
        (given.has("anchors") && !uses_anchor_rule, "--anchors", "each edit has explicit anchors"),
        (
            given.has("seed") && !matches!(settings.anchors, AnchorKind::Random { .. }),
            "--seed",
            "--anchors uses no random vertices",
        ),
        (given.has("seed") && !uses_anchor_rule, "--seed", "each edit has explicit anchors"),
    ])
}

/// Whether any edit is given.
fn is_edited(edits: &EditArguments) -> bool {
    moves(edits) || !edits.sliders.is_empty() || !edits.expressions.is_empty() || edits.symmetrise.is_some()
}

/// Whether an edit uses the command line's settings. A file counts even if its list is empty, as scripts may write one.
fn moves(edits: &EditArguments) -> bool {
    edits.file.is_some() || !edits.vertices.is_empty() || !edits.regions.is_empty()
}

/// Whether an edit takes its anchors from `--anchors`.
fn uses_anchor_rule(edits: &EditArguments) -> bool {
    edits.file.is_some() || !edits.regions.is_empty() || edits.vertices.iter().any(has_no_anchors)
}

/// Whether a move is without explicit anchors.
fn has_no_anchors(command: &Command) -> bool {
    matches!(command, Command::Move { spec, .. } if spec.settings.anchors == Anchors::default())
}

/// Refuses the first option whose condition holds.
fn refuse_first(options: &[(bool, &'static str, &'static str)]) -> Result<(), CliError> {
    let first = options.iter().find(|(is_rejected, ..)| *is_rejected);
    first.map_or(Ok(()), |(_, flag, reason)| no_effect(flag, reason))
}

fn no_effect(flag: &str, reason: &str) -> Result<(), CliError> {
    Err(CliError::NoEffect { flag: flag.to_owned(), reason: reason.to_owned() })
}
