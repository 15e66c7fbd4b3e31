use std::path::Path;

use rosto_face::{FaceModel, Language};
use rosto_studio::{Anchors, Command, Document, Frame, Grip, Rest};

use crate::args::{EditArguments, FollowArguments, MeshTask, Units};
use crate::encode::{self, Format, MM_PER_M};
use crate::error::CliError;
use crate::{edits, files, follow, networks, portrait};

/// A command with the words that a message and the history name it by.
struct Step {
    what: String,
    label: String,
    command: Command,
}

impl Step {
    /// The page calls its entries so, too: both write the same file.
    fn new(what: impl Into<String>, command: Command) -> Self {
        Self { what: what.into(), label: command.subject().name(Language::English), command }
    }
}

/// `rosto mesh`: photo to edited mesh.
pub fn run(task: &MeshTask, networks: Option<&Path>) -> Result<(), CliError> {
    // What is wrong with the request is said before any work is done.
    let format = Format::of(&task.output)?;
    let steps = steps(&task.edits, &task.follow)?;
    let photo = portrait::open(&task.photo)?;
    let face = portrait::face(&photo, &task.photo, &networks::load(networks)?)?;
    let face = portrait::model(&photo, &face, task.topology.into(), &task.photo)?;
    let mut document = edited(&face, steps, task.edits.units)?;
    document.set_density(task.density)?;
    files::write(&task.output, &encode::encode(&face, &document, task, format)?)
}

/// All that was asked for, in the order that `--help` promises.
fn steps(asked: &EditArguments, follow: &FollowArguments) -> Result<Vec<Step>, CliError> {
    let unit = document_unit(asked.units);
    let mut steps = Vec::new();
    let mut edits = asked.file.as_deref().map(edits::read).transpose()?.unwrap_or_default();
    edits.extend(asked.vertices.iter().cloned());
    for edit in edits {
        let mut settings = follow::settings(follow, steps.len(), unit);
        if let Some(anchors) = edit.anchors {
            settings.anchors = Anchors::explicit(anchors);
        }
        let grip = Grip { level: 0, handles: vec![edit.vertex], settings };
        let command = Command::Move { grip, offsets: vec![edit.offset * unit] };
        steps.push(Step::new(format!("vertex {}", edit.vertex), command));
    }
    for edit in &asked.regions {
        let handles = edit.region.vertices();
        let offsets = vec![edit.offset * unit; handles.len()];
        let grip = Grip { level: 0, handles, settings: follow::settings(follow, steps.len(), unit) };
        steps.push(Step::new(edit.region.id(), Command::Move { grip, offsets }));
    }
    for edit in &asked.sliders {
        steps.push(Step::new(edit.slider.id(), edit.slider.command(edit.amount_mm / MM_PER_M)));
    }
    if let Some(share) = asked.symmetrise {
        steps.push(Step::new("symmetrise", Command::Symmetrise { share }));
    }
    Ok(steps)
}

/// The document's unit for one of the command line's: normalised coordinates stay, millimetres become metres.
fn document_unit(units: Units) -> f64 {
    match units {
        Units::Image => 1.0,
        Units::Mm => 1.0 / MM_PER_M,
    }
}

fn edited(face: &FaceModel, steps: Vec<Step>, units: Units) -> Result<Document, CliError> {
    let rest = match units {
        Units::Image => Rest::new(face.topology().clone(), face.positions_image().to_vec(), Frame::Other),
        Units::Mm => Rest::of_face(face),
    };
    let mut document = Document::new(rest)?;
    for (index, Step { what, label, command }) in steps.into_iter().enumerate() {
        let applied = document.apply(&label, command);
        applied.map_err(|reason| CliError::Edit { number: index + 1, what, reason })?;
    }
    Ok(document)
}
