//! Edits made in image coordinates, as a history over the model's frame that gives the same shape.

use glam::{DMat3, DVec3};
use rosto_face::FaceModel;
use rosto_studio::{
    AnchorKind, Anchors, Command, ConstraintKind, CoordinateFrame, Details, Document, EditSpec, Entry, Mirror,
    RegionOfInfluence, Rest, Settings, StudioError,
};

/// What a file holds of edits that were made in image coordinates.
pub struct ModelHistory {
    pub entries: Vec<Entry>,
    /// The labels of edits that no entry over the model can express.
    pub left_out: Vec<String>,
}

/// The landmarks as the picture has them.
pub fn image_rest(face: &FaceModel) -> Rest {
    Rest::new(face.topology().clone(), face.positions_image().to_vec(), CoordinateFrame::Other)
}

/// The history of a document over [`image_rest`].
///
/// Ways in one frame become ways in the other by a linear map. An edit whose weights know only the mesh's topology commutes with it, so that the
/// same spec with its offsets carried over does the same. Any other becomes the way that each landmark went.
pub fn model_history(face: &FaceModel, document: &Document) -> Result<ModelHistory, StudioError> {
    let model_from_image = face.image_from_model().inverse();
    let image_entries = document.history().entries();
    // Over the cage alone; what waits for a denser mesh leaves it as it is.
    let mut cage = Document::replay(image_rest(face), image_entries.to_vec())?;
    let mut history = ModelHistory { entries: Vec::new(), left_out: Vec::new() };
    for (entry, way) in image_entries.iter().zip(cage.displacements()) {
        match &entry.command {
            Command::Move { spec, offsets } if knows_topology_alone(&spec.settings) => {
                let offsets = carried(offsets, model_from_image);
                history.entries.push(with(entry, Command::Move { spec: spec.clone(), offsets }));
            }
            Command::Move { spec, .. } if spec.level > 0 => history.left_out.push(entry.label.clone()),
            _ => {
                let placed = placed(&carried(&way, model_from_image));
                history.entries.extend(placed.into_iter().map(|command| with(entry, command)));
            }
        }
    }
    Ok(history)
}

fn knows_topology_alone(settings: &Settings) -> bool {
    let operator = settings.operator.knows_only_topology();
    let anchors = !matches!(settings.anchors.kind, AnchorKind::Outside { .. });
    let reach = settings.reach == RegionOfInfluence::Whole && settings.details == Details::Kept;
    operator && anchors && reach && settings.mirror == Mirror::Off
}

fn carried(offsets: &[DVec3], model_from_image: DMat3) -> Vec<DVec3> {
    offsets.iter().map(|&offset| model_from_image * offset).collect()
}

fn with(entry: &Entry, command: Command) -> Entry {
    Entry { label: entry.label.clone(), command, switch: entry.switch }
}

/// Commands that move each landmark by just this.
///
/// Every piece of the mesh wants an anchor. Where nothing stays, all but one go first, and that one follows.
fn placed(way: &[DVec3]) -> Vec<Command> {
    let all = || 0..way.len() as u32;
    let (moved, still): (Vec<u32>, Vec<u32>) = all().partition(|&vertex| way[vertex as usize] != DVec3::ZERO);
    if moved.is_empty() {
        return Vec::new();
    }
    let groups = match (still.is_empty(), moved.split_first()) {
        (true, Some((first, others))) => vec![others.to_vec(), vec![*first]],
        _ => vec![moved],
    };
    let command = |handles: Vec<u32>| {
        let pins = all().filter(|vertex| handles.binary_search(vertex).is_err()).collect();
        let offsets = handles.iter().map(|&handle| way[handle as usize]).collect();
        let settings =
            Settings { constraint: ConstraintKind::Hard, anchors: Anchors::explicit(pins), ..Settings::default() };
        Command::Move { spec: EditSpec { level: 0, handles, settings }, offsets }
    };
    groups.into_iter().map(command).collect()
}
