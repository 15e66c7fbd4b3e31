//! Flags that would change nothing are refused: whoever gives them expects something of them.

use clap::ArgMatches;
use clap::parser::ValueSource;
use rosto_export::{BaseColour, ExportOption, Format, Solid, Units};
use rosto_face::Triangulation;

use crate::args::{EditArguments, MeshTask, PhotoTask, SettingsArguments};
use crate::error::CliError;
use crate::output;
use crate::settings::Rule;

/// The options that shape edits, by their names in [`crate::args::SettingsArguments`].
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

/// Which arguments somebody gave, and did not leave to their defaults.
pub struct Given<'a>(pub &'a ArgMatches);

impl Given<'_> {
    fn has(&self, id: &str) -> bool {
        self.0.value_source(id) == Some(ValueSource::CommandLine)
    }
}

/// Refuses what would change nothing in `rosto mesh`.
pub fn check(task: &MeshTask, format: Format, given: &Given<'_>) -> Result<(), CliError> {
    check_format(task, format, given)?;
    check_settings(&task.edits, &task.settings, given)
}

/// Refuses what would change nothing in `rosto photo`.
pub fn check_photo(task: &PhotoTask, given: &Given<'_>) -> Result<(), CliError> {
    if !is_edited(&task.edits) && task.seen_from_m.is_none() {
        for (id, flag) in [("falloff_band", "--falloff-band"), ("kept", "--keep")] {
            if given.has(id) {
                return useless(flag, "nothing in the photo is moved");
            }
        }
    }
    check_settings(&task.edits, &task.settings, given)
}

/// Options of `rosto mesh` that only some formats have a place for, by their names in [`MeshTask`].
const FOR_FORMATS: [(&str, &str, ExportOption, &str); 7] = [
    ("base_colour", "--base-colour", ExportOption::BaseColour, "it is for .glb, .gltf, .obj, .usdz and .png"),
    ("texture_size", "--texture-size", ExportOption::BaseColour, "it is for .glb, .gltf, .obj, .usdz and .png"),
    ("solid", "--solid", ExportOption::Solid, "it is for .stl and .3mf"),
    ("material", "--material", ExportOption::Material, "light falls only on .glb and .gltf"),
    ("eyes", "--eyes", ExportOption::Eyes, "it is for .glb, .gltf, .obj, .ply and .usdz"),
    ("expression_targets", "--expressions", ExportOption::Material, "only .glb and .gltf hold them"),
    ("morph_targets", "--morph-targets", ExportOption::Material, "only .glb and .gltf hold them"),
];

fn check_format(task: &MeshTask, format: Format, given: &Given<'_>) -> Result<(), CliError> {
    if task.units == Units::Image && !format.supports(ExportOption::Units) {
        return Err(CliError::ImageUnits { path: task.output.clone() });
    }
    let is_for_others = |id: &str, what| given.has(id) && !format.supports(what);
    if let Some((_, flag, _, reason)) = FOR_FORMATS.into_iter().find(|(id, _, what, _)| is_for_others(id, *what)) {
        return useless(flag, reason);
    }
    let by_colours = task.base_colour == BaseColour::VertexColours;
    let is_open = task.mesh.topology == Triangulation::Tessellation;
    let of_several = task.photos.len() > 1 && !output::is_pattern(&task.output);
    let useless_here = [
        (by_colours && format == Format::Png, "--base-colour", "a .png is a picture"),
        (by_colours && given.has("texture_size"), "--texture-size", "--base-colour colours leaves no picture"),
        (
            task.solid == Solid::Surface && format == Format::ThreeMf,
            "--solid",
            "a .3mf is printed, and a surface alone cannot be",
        ),
        (given.has("eyes") && task.expression_targets, "--eyes", "with --expressions they are pieces"),
        (given.has("eyes") && is_open, "--eyes", "--topology tessellation leaves eyes and mouth open"),
        (
            of_several && task.units == Units::Image,
            "a further photo",
            "image coordinates are those of one; give --units mm",
        ),
        (task.morph_targets && !is_edited(&task.edits), "--morph-targets", "there is no edit to make one of"),
    ];
    refuse_first(&useless_here)
}

/// Refuses settings of edits where there is none that they could shape.
fn check_settings(edits: &EditArguments, settings: &SettingsArguments, given: &Given<'_>) -> Result<(), CliError> {
    if !moves(edits)
        && let Some((_, flag)) = SETTINGS.into_iter().find(|(id, _)| given.has(id))
    {
        return useless(flag, "it shapes --edit, --edits and --region, and none is given");
    }
    let asks_rule = asks_rule(edits);
    refuse_first(&[
        (given.has("anchors") && !asks_rule, "--anchors", "every edit names its own"),
        (given.has("seed") && settings.anchors != Rule::Random, "--seed", "--anchors leaves nothing to chance"),
        (given.has("seed") && !asks_rule, "--seed", "every edit names its anchors"),
    ])
}

/// Whether there is an edit at all.
fn is_edited(edits: &EditArguments) -> bool {
    moves(edits) || !edits.sliders.is_empty() || !edits.expressions.is_empty() || edits.symmetrise.is_some()
}

/// Whether there is an edit that takes its settings from the command line. A file counts, whatever is in it: a script may
/// well write an empty list.
fn moves(edits: &EditArguments) -> bool {
    edits.file.is_some() || !edits.vertices.is_empty() || !edits.regions.is_empty()
}

/// Whether the rule for anchors is asked.
fn asks_rule(edits: &EditArguments) -> bool {
    edits.file.is_some() || !edits.regions.is_empty() || edits.vertices.iter().any(|edit| edit.anchors.is_none())
}

/// Refuses the first option that is useless here.
fn refuse_first(options: &[(bool, &'static str, &'static str)]) -> Result<(), CliError> {
    let first = options.iter().find(|(is_useless, ..)| *is_useless);
    first.map_or(Ok(()), |(_, flag, reason)| useless(flag, reason))
}

fn useless(flag: &'static str, reason: &'static str) -> Result<(), CliError> {
    Err(CliError::Useless { flag, reason })
}
