//! Flags that would change nothing are refused: whoever gives them expects something of them.

use clap::ArgMatches;
use clap::parser::ValueSource;
use rosto_export::{BaseColour, Choosable, Format, Solid, Units};
use rosto_face::Triangulation;

use crate::args::{EditArguments, MeshTask, PhotoTask, SettingsArguments};
use crate::error::CliError;
use crate::output;
use crate::settings::Rule;

/// The options that shape edits, by their names in [`crate::args::SettingsArguments`].
const SETTINGS: [(&str, &str); 8] = [
    ("operator", "--operator"),
    ("constraint", "--hold"),
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
        for (id, flag) in [("ring", "--ring"), ("kept", "--keep")] {
            if given.has(id) {
                return useless(flag, "nothing in the photo is moved");
            }
        }
    }
    check_settings(&task.edits, &task.settings, given)
}

fn check_format(task: &MeshTask, format: Format, given: &Given<'_>) -> Result<(), CliError> {
    check_paint(task, format, given)?;
    check_print(task, format, given)?;
    let is_gltf = format.lets_choose(Choosable::Material);
    if given.has("material") && !is_gltf {
        return useless("--material", "light falls only on .glb and .gltf");
    }
    check_eyes(task, format, given)?;
    match task.expression_targets {
        true if !is_gltf => return useless("--expressions", "only .glb and .gltf hold them"),
        true if task.edits.units != Units::Mm => return useless("--expressions", "they need --units mm"),
        _ => {}
    }
    let of_several = task.photos.len() > 1 && !output::is_pattern(&task.output);
    if of_several && format.lets_choose(Choosable::Unit) && task.edits.units == Units::Image {
        return useless("a further photo", "image coordinates are those of one; give --units mm");
    }
    match task.morph_targets {
        true if !is_gltf => useless("--morph-targets", "only .glb and .gltf hold them"),
        true if task.edits.units != Units::Mm => useless("--morph-targets", "they need --units mm"),
        true if !is_edited(&task.edits) => useless("--morph-targets", "there is no edit to make one of"),
        _ => Ok(()),
    }
}

fn check_eyes(task: &MeshTask, format: Format, given: &Given<'_>) -> Result<(), CliError> {
    let asked = given.has("eyes");
    match task.mesh.topology {
        _ if asked && !format.lets_choose(Choosable::Eyes) => {
            useless("--eyes", "it is for .glb, .gltf, .obj, .ply and .usdz")
        }
        _ if asked && task.expression_targets => useless("--eyes", "with --expressions they are pieces"),
        Triangulation::Tessellation if asked => useless("--eyes", "--topology tessellation leaves eyes and mouth open"),
        _ => Ok(()),
    }
}

fn check_paint(task: &MeshTask, format: Format, given: &Given<'_>) -> Result<(), CliError> {
    let is_painted = format.lets_choose(Choosable::BaseColour);
    let by_colours = task.base_colour == BaseColour::VertexColours;
    if given.has("base_colour") && !is_painted {
        return useless("--base-colour", "it is for .glb, .gltf, .obj, .usdz and .png");
    }
    if by_colours && format == Format::Png {
        return useless("--base-colour", "a .png is a picture");
    }
    match given.has("texture_size") {
        true if !is_painted => useless("--texture-size", "it is for .glb, .gltf, .obj, .usdz and .png"),
        true if by_colours => useless("--texture-size", "--base-colour colours leaves no picture"),
        _ => Ok(()),
    }
}

fn check_print(task: &MeshTask, format: Format, given: &Given<'_>) -> Result<(), CliError> {
    if given.has("solid") && !format.lets_choose(Choosable::Solid) {
        return useless("--solid", "it is for .stl and .3mf");
    }
    if given.has("colours") && !format.lets_choose(Choosable::Colours) {
        return useless("--colours", "it is for .3mf");
    }
    match task.solid == Solid::Surface && format == Format::ThreeMf {
        true => useless("--solid", "a .3mf is printed, and a surface alone cannot be"),
        false => Ok(()),
    }
}

/// Refuses settings of edits where there is none that they could shape.
fn check_settings(edits: &EditArguments, settings: &SettingsArguments, given: &Given<'_>) -> Result<(), CliError> {
    if !moves(edits)
        && let Some((_, flag)) = SETTINGS.into_iter().find(|(id, _)| given.has(id))
    {
        return useless(flag, "it shapes --edit, --edits and --region, and none is given");
    }
    let asks_rule = asks_rule(edits);
    if given.has("anchors") && !asks_rule {
        return useless("--anchors", "every edit names its own");
    }
    match given.has("seed") {
        true if settings.anchors != Rule::Random => useless("--seed", "--anchors leaves nothing to chance"),
        true if !asks_rule => useless("--seed", "every edit names its anchors"),
        _ => Ok(()),
    }
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

fn useless(flag: &'static str, reason: &'static str) -> Result<(), CliError> {
    Err(CliError::Useless { flag, reason })
}
