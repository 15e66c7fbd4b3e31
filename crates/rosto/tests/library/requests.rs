//! Requests: settings of moves, refusals with their reasons, and edited photos.

use crate::common::*;
use glam::DVec3;
use rosto::*;

const NUDGE: DVec3 = DVec3::new(0.0, 0.0, 0.002);

fn anchors(request: &MeshRequest) -> Vec<Anchors> {
    let of = |command: &Command| match command {
        Command::Move { spec, .. } => spec.settings.anchors.clone(),
        other => panic!("{other:?} is not a move"),
    };
    request.edits.iter().map(of).collect()
}

#[test]
fn random_anchors_differ_by_move_and_pins_join_explicit_anchors() {
    let mut request = unedited();
    let mut own = Command::move_vertex(0, 4, NUDGE);
    if let Command::Move { spec, .. } = &mut own {
        spec.settings.anchors = Anchors::explicit(vec![10, 152]);
    }
    let settings = Settings {
        anchors: Anchors { kind: AnchorKind::Random { seed: 7 }, pins: vec![5, 10] },
        mirror: Mirror::On,
        ..Settings::default()
    };
    let moves = [Command::move_vertex(0, 1, NUDGE), own, Command::move_region(Region::Nose, NUDGE)];
    request.add_moves(moves, &settings);
    let random = |seed| Anchors { kind: AnchorKind::Random { seed }, pins: vec![5, 10] };
    assert_eq!(anchors(&request), [random(7), Anchors::explicit(vec![10, 152, 5]), random(9)]);
}

#[test]
fn an_impossible_edit_is_named_with_a_hint() {
    let failed = |command: Command| {
        let request = MeshRequest { edits: vec![command], ..unedited() };
        let error = request.open().err().unwrap();
        (error.to_string(), error.hint().unwrap())
    };
    let (error, hint) = failed(Command::move_vertex(0, 9999, NUDGE));
    assert!(error.starts_with("edit 1 (vertex 9999): ") && hint.contains("0 to 467"), "{error} {hint}");
    let (error, hint) = failed(Command::move_vertex(3, 20_000, NUDGE));
    assert!(error.starts_with("edit 1 (vertex 20000@3): ") && hint.contains("Raise the density"), "{error} {hint}");
}

#[test]
fn faces_that_cannot_be_made_are_refused() {
    let two = MeshRequest { photos: vec![observation(), observation()], ..unedited() };
    assert!(two.clone().open().is_ok());
    assert_eq!(MeshRequest { units: Units::Image, ..two }.open().err(), Some(Error::SeveralPhotos));
    assert!(matches!(
        MeshRequest::of(Vec::new()).open().err(),
        Some(Error::Face(FaceError::PhotoCount { found: 0, .. }))
    ));
    assert!(MeshRequest { density: 5, ..unedited() }.open().is_err());
}

#[test]
fn options_are_set_by_their_ids() {
    let mut options = FileOptions::default();
    let choices = [
        (ExportOption::BaseColour, "photo"),
        (ExportOption::TextureSize, "4096"),
        (ExportOption::Material, "unlit"),
        (ExportOption::Edits, "morph-targets"),
        (ExportOption::Expressions, "morph-targets"),
        (ExportOption::Eyes, "pieces"),
        (ExportOption::Units, "image"),
        (ExportOption::Solid, "flat:30"),
        (ExportOption::Height, "80"),
    ];
    assert_eq!(choices.map(|(option, _)| option), ExportOption::ALL);
    choices.into_iter().for_each(|(option, choice)| options.set(option, choice).unwrap());
    let expected = FileOptions {
        base_colour: BaseColour::Photo,
        texture_size: TextureSize::Px4096,
        material: Material::Unlit,
        edits: EditsAs::MorphTargets,
        expressions: ExpressionsAs::MorphTargets,
        eyes: Eyes::Pieces,
        units: Units::Image,
        print: Print { solid: Solid::FlatBack { depth_mm: Some(30.0) }, height: PrintHeight::Mm(80.0) },
    };
    assert_eq!(options, expected);
    let unknown = options.set(ExportOption::Material, "shiny").unwrap_err().to_string();
    assert_eq!(unknown, "unknown material \"shiny\"; use one of lit, unlit");
    assert!(options.set(ExportOption::Solid, "cube:3").is_err());
    assert_eq!(options, expected, "a refused choice changes nothing");
}

#[test]
fn options_without_effect_are_refused() {
    let check = |request: &MeshRequest, format, options: FileOptions, given: &[ExportOption]| {
        request.check_file(format, &options, given).err().map(|error| error.to_string())
    };
    let by_default = FileOptions::default();
    let refused = check(&unedited(), Format::Stl, by_default, &[ExportOption::Eyes]);
    assert_eq!(refused.unwrap(), "eyes has no effect: only .glb, .gltf, .obj, .ply and .usdz support it");
    assert_eq!(check(&unedited(), Format::Glb, by_default, &[ExportOption::Eyes]), None);
    let targets = FileOptions { edits: EditsAs::MorphTargets, ..by_default };
    assert!(check(&unedited(), Format::Glb, targets, &[ExportOption::Edits]).unwrap().contains("no edit"));
    assert_eq!(check(&edited(), Format::Glb, targets, &[ExportOption::Edits]), None);
    let image = FileOptions { units: Units::Image, ..by_default };
    assert_eq!(unedited().check_file(Format::Glb, &image, &[]), Err(Error::ImageUnits));
    assert_eq!(unedited().check_file(Format::Json, &image, &[ExportOption::Units]), Ok(()));
}

#[test]
fn a_face_edited_in_image_coordinates_is_written_as_json_only() {
    let mut face = MeshRequest { units: Units::Image, ..unedited() }.open().unwrap();
    for format in Format::ALL {
        let written = face.write(format, &FileOptions::default(), "face").err();
        assert_eq!(written, (format != Format::Json).then_some(Error::ImageUnits), "{format:?}");
    }
    assert_eq!(face.write_project().err(), Some(Error::ImageUnits));
}

fn drawn(request: MeshRequest, photo: &Photo, edit: PhotoEdit) -> Result<EditedPhoto, Error> {
    PhotoRequest { photo, mesh: &request.open().unwrap(), falloff_band: 0.35, edit }.image()
}

#[test]
fn a_photo_is_drawn_in_its_own_size() {
    let photo = photo();
    let unchanged = drawn(unedited(), &photo, PhotoEdit::default()).unwrap().photo;
    assert_eq!(unchanged.pixels(), photo.pixels());
    let changed = drawn(edited(), &photo, PhotoEdit::default()).unwrap().photo;
    assert_ne!(changed.pixels(), photo.pixels());
    let from_afar = PhotoEdit { seen_from_m: Some(1.5), ..PhotoEdit::default() };
    assert_ne!(drawn(unedited(), &photo, from_afar).unwrap().photo.pixels(), photo.pixels());
    let small = photo.scaled_down(photo.width() / 2);
    assert_eq!(drawn(edited(), &small, PhotoEdit::default()).unwrap().photo.width(), small.width());
    let other = Photo::from_rgb(40, 60, vec![0; 40 * 60 * 3]).unwrap();
    let error = drawn(edited(), &other, PhotoEdit::default()).err();
    assert_eq!(error, Some(Error::OtherPhoto { found_px: [40, 60], face_px: [512, 512] }));
}

#[test]
fn photo_edits_read_back_and_invalid_ones_are_named() {
    let text = r#"{"protected_px":[[[1.0,2.5,3.0]],[]],"seen_from_m":1.5}"#;
    let edit = PhotoEdit::from_json(text).unwrap();
    assert_eq!((edit.seen_from_m, edit.strokes.len(), edit.strokes[0][0].radius_px), (Some(1.5), 2, 3.0));
    assert_eq!(edit.to_json(), text);
    let field = |text| match PhotoEdit::from_json(text).unwrap_err() {
        Error::PhotoEdit { field } => field,
        other => panic!("{other}"),
    };
    assert_eq!(field("{"), "JSON");
    assert_eq!(field(r#"{"protected_px":[],"seen_from_m":0.01}"#), "seen_from_m");
    assert_eq!(field(r#"{"protected_px":[],"seen_from_m":"far"}"#), "seen_from_m");
    assert_eq!(field(r#"{"seen_from_m":null}"#), "protected_px");
    assert_eq!(field(r#"{"protected_px":[[[1,2,0]]],"seen_from_m":null}"#), "protected_px");
    assert_eq!(field(r#"{"protected_px":[[[1,2]]],"seen_from_m":null}"#), "protected_px");
}

#[test]
fn a_photo_edit_with_too_many_dabs_is_refused() {
    let with = |stroke: &str, count| format!(r#"{{"protected_px":[{}]}}"#, vec![stroke; count].join(","));
    assert_eq!(PhotoEdit::from_json(&with("[[1,2,3]]", MAX_DABS)).unwrap().strokes.len(), MAX_DABS);
    for stroke in ["[[1,2,3]]", "[]"] {
        let refused = PhotoEdit::from_json(&with(stroke, MAX_DABS + 1)).unwrap_err();
        assert!(matches!(refused, Error::TooManyDabs { found, max: MAX_DABS } if found == MAX_DABS + 1), "{refused}");
    }
}
