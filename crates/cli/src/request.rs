//! Refuses options that would have no effect.

use clap::ArgMatches;
use clap::parser::ValueSource;
use rosto_export::{BaseColour, ExportOption, Format, Solid, Units};
use rosto_face::Triangulation;

use crate::args::{EditArguments, MeshTask, PhotoTask, SettingsArguments};
use crate::error::CliError;
use crate::output;
use crate::settings::Rule;

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

/// Refuses options of `rosto mesh` without effect.
pub fn check(task: &MeshTask, format: Format, given: &Given<'_>) -> Result<(), CliError> {
    check_format(task, format, given)?;
    check_settings(&task.edits, &task.settings, given)
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

/// Options of `rosto mesh` that only some formats support, with their ids in [`MeshTask`].
const FOR_FORMATS: [(&str, &str, ExportOption, &str); 7] = [
    ("base_colour", "--base-colour", ExportOption::BaseColour, "only .glb, .gltf, .obj, .usdz and .png support it"),
    ("texture_size", "--texture-size", ExportOption::BaseColour, "only .glb, .gltf, .obj, .usdz and .png support it"),
    ("solid", "--solid", ExportOption::Solid, "only .stl and .3mf support it"),
    ("material", "--material", ExportOption::Material, "only .glb and .gltf support it"),
    ("eyes", "--eyes", ExportOption::Eyes, "only .glb, .gltf, .obj, .ply and .usdz support it"),
    ("expression_targets", "--expressions", ExportOption::Material, "only .glb and .gltf support it"),
    ("morph_targets", "--morph-targets", ExportOption::Material, "only .glb and .gltf support it"),
];

fn check_format(task: &MeshTask, format: Format, given: &Given<'_>) -> Result<(), CliError> {
    if task.units == Units::Image && !format.supports(ExportOption::Units) {
        return Err(CliError::ImageUnits { path: task.output.clone() });
    }
    let is_unsupported = |id: &str, what| given.has(id) && !format.supports(what);
    if let Some((_, flag, _, reason)) = FOR_FORMATS.into_iter().find(|(id, _, what, _)| is_unsupported(id, *what)) {
        return no_effect(flag, reason);
    }
    let by_colours = task.base_colour == BaseColour::VertexColours;
    let is_open = task.mesh.topology == Triangulation::Tessellation;
    let has_several_photos = task.photos.len() > 1 && !output::is_pattern(&task.output);
    let rejected = [
        (by_colours && format == Format::Png, "--base-colour", "a .png has no vertex colours"),
        (by_colours && given.has("texture_size"), "--texture-size", "--base-colour colours writes no texture"),
        (task.solid == Solid::Surface && format == Format::ThreeMf, "--solid", "a .3mf needs a closed body"),
        (given.has("eyes") && task.expression_targets, "--eyes", "--expressions implies pieces"),
        (given.has("eyes") && is_open, "--eyes", "--topology tessellation has openings for eyes and mouth"),
        (
            has_several_photos && task.units == Units::Image,
            "a second photo",
            "image coordinates belong to one photo; use --units mm",
        ),
        (task.morph_targets && !is_edited(&task.edits), "--morph-targets", "no edit is given"),
    ];
    refuse_first(&rejected)
}

/// Refuses settings that no given edit uses.
fn check_settings(edits: &EditArguments, settings: &SettingsArguments, given: &Given<'_>) -> Result<(), CliError> {
    if !moves(edits)
        && let Some((_, flag)) = SETTINGS.into_iter().find(|(id, _)| given.has(id))
    {
        return no_effect(flag, "it needs --edit, --edits or --region");
    }
    let uses_anchor_rule = uses_anchor_rule(edits);
    refuse_first(&[
        (given.has("anchors") && !uses_anchor_rule, "--anchors", "each edit has explicit anchors"),
        (given.has("seed") && settings.anchors != Rule::Random, "--seed", "--anchors uses no random vertices"),
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
    edits.file.is_some() || !edits.regions.is_empty() || edits.vertices.iter().any(|edit| edit.anchors.is_none())
}

/// Refuses the first option whose condition holds.
fn refuse_first(options: &[(bool, &'static str, &'static str)]) -> Result<(), CliError> {
    let first = options.iter().find(|(is_rejected, ..)| *is_rejected);
    first.map_or(Ok(()), |(_, flag, reason)| no_effect(flag, reason))
}

fn no_effect(flag: &'static str, reason: &'static str) -> Result<(), CliError> {
    Err(CliError::NoEffect { flag, reason })
}
