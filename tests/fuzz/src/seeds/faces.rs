use glam::DVec3;
use rosto_export::{BaseColour, GlbOptions, Material, Model, Morph, SavedEdits, Source, glb};
use rosto_face::{
    FaceModel, LANDMARK_COUNT, Observation, Photo, PhotoLens, Triangulation, canonical_positions_m, canonical_uvs,
};
use rosto_studio::{
    AnchorKind, Anchors, Command, ConstraintKind, CoordinateFrame, Details, EditSpec, Entry, Mirror, Operator,
    RegionOfInfluence, Rest, Settings, Switch, project,
};

const SIDE_PX: u32 = 40;

/// Photo edits of a project.
const PHOTO_EDIT: &str = r#"{"seen_from_m":1.5,"protected_px":[[[10.0,12.5,3.0],[11.0,12.5,3.0]],[[20.0,20.0,4.0]]]}"#;

/// Canonical face, on which histories are replayed.
pub fn canonical_rest() -> Rest {
    Rest::of_landmarks(Triangulation::Canonical.topology(), canonical_positions_m(), CoordinateFrame::Model)
}

/// Histories that cover the commands and settings.
pub fn histories() -> Vec<String> {
    let by_default = || Settings::default();
    let anchored = |kind, pins: &[u32]| Settings { anchors: Anchors { kind, pins: pins.to_vec() }, ..by_default() };
    let exact = Settings { constraint: ConstraintKind::Hard, mirror: Mirror::On, ..by_default() };
    let near = Settings {
        influence: RegionOfInfluence::Within { radius: 0.05 },
        operator: Operator::Cotangent,
        ..by_default()
    };
    let turned = Settings { details: Details::AsRigidAsPossible, ..anchored(AnchorKind::PinsOnly, &[10, 152]) };
    let far = Settings {
        constraint: ConstraintKind::Soft { weight: 0.25 },
        ..anchored(AnchorKind::Outside { radius: 0.06 }, &[10])
    };
    let nudge = DVec3::new(0.0, 0.001, 0.01);
    let lists = [
        vec![],
        vec![step("nose", &[1], by_default(), &[nudge])],
        vec![
            step("mouth", &[61, 291], exact, &[nudge, -nudge]),
            Entry { switch: Switch::Off, ..step("chin \"é\"", &[152], near, &[nudge]) },
            symmetrised(0.5),
        ],
        vec![
            step("random", &[4], anchored(AnchorKind::Random { seed: 7 }, &[]), &[nudge]),
            step("far", &[33, 263], far, &[nudge, nudge]),
            symmetrised(1.0),
        ],
        vec![step("turned", &[1], turned, &[nudge]), symmetrised(0.0)],
    ];
    lists.iter().map(|entries| project::to_json(entries)).collect()
}

fn step(label: &str, handles: &[u32], settings: Settings, offsets: &[DVec3]) -> Entry {
    let spec = EditSpec { level: 0, handles: handles.to_vec(), settings };
    let command = Command::Move { spec, offsets: offsets.to_vec() };
    Entry { label: label.to_owned(), command, switch: Switch::On }
}

fn symmetrised(share: f64) -> Entry {
    Entry { label: "symmetrise".to_owned(), command: Command::Symmetrise { share }, switch: Switch::On }
}

/// GLBs with either base colour, either triangulation, each history, with and without a morph target.
pub fn glbs() -> Vec<Vec<u8>> {
    use {BaseColour::Photo, BaseColour::VertexColours, Triangulation::Canonical, Triangulation::Tessellation};
    let displacements_m = vec![DVec3::Z * 0.001; LANDMARK_COUNT];
    let morph = Morph { name: "nose", displacements_m: &displacements_m, weight: 0.5 };
    let kinds = [
        (Canonical, Photo, Material::Lit, &[][..]),
        (Canonical, VertexColours, Material::Unlit, &[]),
        (Tessellation, Photo, Material::Unlit, &[morph]),
        (Tessellation, VertexColours, Material::Lit, &[]),
    ];
    let histories = histories();
    let written =
        kinds.into_iter().zip(&histories[1..]).map(|((triangulation, base_colour, material, morphs), history)| {
            let face = face(triangulation);
            let edits = edits(&face, history);
            let source = Some(Source { face: &face, edits: &edits });
            let options = GlbOptions { base_colour, material, morphs, source, ..GlbOptions::default() };
            glb(&Model::of_face(&face), &options).expect("invariant: the canonical face can be written")
        });
    written.collect()
}

/// Projects with each history.
pub fn projects() -> Vec<Vec<u8>> {
    let face = face(Triangulation::Tessellation);
    let project =
        |history: String| rosto_export::project::write(&Source { face: &face, edits: &edits(&face, &history) });
    let projects = histories().into_iter().map(project);
    projects.collect::<Result<_, _>>().expect("invariant: the canonical face can be written")
}

fn edits(face: &FaceModel, history: &str) -> SavedEdits {
    let [history, photo_edit] = [history, PHOTO_EDIT].map(|text| Some(text.to_owned()));
    SavedEdits { history, photo_edit, ..SavedEdits::none(face.triangulation(), 0) }
}

/// The canonical face laid flat over a small picture.
fn face(triangulation: Triangulation) -> FaceModel {
    let level = |at: u32| (at * 255 / (SIDE_PX - 1)) as u8;
    let pixels = (0..SIDE_PX).flat_map(|y| (0..SIDE_PX).flat_map(move |x| [level(x), level(y), 60])).collect();
    let picture = Photo::from_rgb(SIDE_PX, SIDE_PX, pixels).expect("invariant: three bytes a pixel");
    let depths_m = canonical_positions_m();
    let uvs = canonical_uvs();
    let places = uvs.iter().zip(&depths_m);
    let landmarks: Vec<[f32; 3]> =
        places.map(|(uv, at)| [uv.x as f32 * 0.5 + 0.2, uv.y as f32 * 0.5 + 0.2, -at.z as f32 * 3.0]).collect();
    let observation = Observation::in_photo(&picture, landmarks).with_lens(PhotoLens::Distance(0.5));
    FaceModel::new(observation, triangulation).expect("invariant: the canonical face fits itself")
}
