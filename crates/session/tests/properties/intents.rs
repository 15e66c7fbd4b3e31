//! Strategies for intents, valid and invalid.

use glam::{DVec2, DVec3};
use proptest::prelude::*;
use rosto_face::{PhotoLens, Region, Triangulation};
use rosto_session::{AnchorChoice, Intent, Look, Pace, Preset, Selection, SelectionMode, ShapePart, Turntable};
use rosto_stage::{
    Axis, Background, Dots, Lens, Light, NamedView, PictureLight, Pointer, Scene, ShadingMode, Srgb, Theme, Visibility,
};
use rosto_studio::{ConstraintKind, Details, Expression, FaceSlider, Mirror, Operator, Switch};

use crate::faces::{SIZE_PX, detected, found, with_history};

/// An intent of any kind.
pub fn anything() -> impl Strategy<Value = Intent> {
    prop_oneof![
        8 => selecting(),
        8 => choosing(),
        12 => moving(),
        12 => pointing(),
        8 => history(),
        4 => mesh(),
        3 => seeing(),
        3 => in_photo(),
        1 => opening(),
    ]
}

/// An intent that edits the face or changes the edit settings.
pub fn editing() -> impl Strategy<Value = Intent> {
    prop_oneof![2 => selecting(), 2 => choosing(), 4 => moving(), 3 => history()]
}

/// An intent of the pointer or the view, mixed with edits.
pub fn looking() -> impl Strategy<Value = Intent> {
    prop_oneof![6 => pointing(), 1 => selecting(), 1 => moving(), 1 => history(), 3 => seeing(), 1 => in_photo()]
}

/// An intent that replaces the mesh or the face, mixed with edits.
pub fn meshing() -> impl Strategy<Value = Intent> {
    prop_oneof![4 => mesh(), 1 => opening(), 2 => selecting(), 3 => moving(), 3 => history()]
}

fn selecting() -> impl Strategy<Value = Intent> {
    prop_oneof![
        mode().prop_map(Intent::Mode),
        vertex().prop_map(|vertex| Intent::Select(Some(Selection::Landmark(vertex)))),
        (0..5u32, vertex()).prop_map(|(level, vertex)| Intent::Select(Some(Selection::Point { level, vertex }))),
        region().prop_map(|region| Intent::Select(Some(Selection::Region(region)))),
        Just(Intent::Select(None)),
        vertex().prop_map(Intent::SelectAt),
        position().prop_map(Intent::SelectUnder),
        position().prop_map(Intent::PinUnder),
        switch().prop_map(Intent::Pin),
    ]
}

fn choosing() -> impl Strategy<Value = Intent> {
    prop_oneof![
        any_of(&Preset::ALL).prop_map(Intent::Preset),
        any_of(&Operator::ALL).prop_map(Intent::Operator),
        any_of(&[ConstraintKind::Hard, ConstraintKind::Soft { weight: 1.0 }]).prop_map(Intent::Constraint),
        prop_oneof![9 => Just(Details::Kept), 1 => Just(Details::AsRigidAsPossible)].prop_map(Intent::Details),
        any_of(&[AnchorChoice::Random, AnchorChoice::Oval, AnchorChoice::PinsOnly]).prop_map(Intent::Anchors),
        any_of(&[Mirror::On, Mirror::Off]).prop_map(Intent::Mirror),
        switch().prop_map(Intent::Nearby),
        prop_oneof![5.0..120.0, number()].prop_map(Intent::Radius),
    ]
}

fn moving() -> impl Strategy<Value = Intent> {
    prop_oneof![
        4 => [-40.0..40.0, -40.0..40.0, -40.0..40.0].prop_map(|offset| Intent::Offset(DVec3::from(offset))),
        1 => [number(), number(), number()].prop_map(|offset| Intent::Offset(DVec3::from(offset))),
        3 => (any_of(&FaceSlider::ALL), -1.0..1.0).prop_map(|(slider, share)| {
            Intent::Slide(slider, share * slider.range_m() * 1000.0)
        }),
        1 => (any_of(&FaceSlider::ALL), number()).prop_map(|(slider, to_mm)| Intent::Slide(slider, to_mm)),
        3 => (any_of(&Expression::ALL), 0.0..1.0).prop_map(|(expression, to)| Intent::Express(expression, to)),
        1 => (any_of(&Expression::ALL), number()).prop_map(|(expression, to)| Intent::Express(expression, to)),
        1 => prop::option::of(any_of(&Look::ALL)).prop_map(Intent::Look),
        3 => Just(Intent::Commit),
        1 => Just(Intent::Cancel),
    ]
}

fn pointing() -> impl Strategy<Value = Intent> {
    let pointer = || any_of(&[Pointer::Fine, Pointer::Coarse]);
    prop_oneof![
        2 => position().prop_map(|position| Intent::Hover(Some(position))),
        1 => Just(Intent::Hover(None)),
        1 => prop::option::of(vertex()).prop_map(Intent::PointAt),
        3 => (position(), pointer()).prop_map(|(position, pointer)| Intent::Press(position, pointer)),
        6 => (position(), any_of(&[Pace::Usual, Pace::Fine])).prop_map(|(position, pace)| Intent::Drag(position, pace)),
        1 => prop::option::of(any_of(&Axis::ALL)).prop_map(Intent::Along),
        2 => Just(Intent::Release),
    ]
}

fn history() -> impl Strategy<Value = Intent> {
    prop_oneof![
        3 => Just(Intent::Undo),
        2 => Just(Intent::Redo),
        1 => Just(Intent::Reset),
        1 => Just(Intent::ResetSelected),
        1 => Just(Intent::ResetExpressions),
        2 => (0..12usize, switch()).prop_map(|(index, switch)| Intent::Switch(index, switch)),
        1 => prop_oneof![0.0..=1.0, number()].prop_map(Intent::Symmetrise),
    ]
}

fn mesh() -> impl Strategy<Value = Intent> {
    prop_oneof![
        8 => prop_oneof![3 => Just(0), 1 => Just(1)].prop_map(Intent::Density),
        1 => Just(Intent::Density(2)),
        1 => (4..1_000u32).prop_map(Intent::Density),
        2 => any_of(&Triangulation::ALL).prop_map(Intent::Triangulation),
        1 => photo_lens().prop_map(Intent::PhotoLens),
    ]
}

fn photo_lens() -> impl Strategy<Value = PhotoLens> {
    prop_oneof![
        Just(PhotoLens::Estimated),
        Just(PhotoLens::Parallel),
        (0.2..3.0).prop_map(PhotoLens::Distance),
        (20.0..100.0).prop_map(PhotoLens::Given),
        number().prop_map(PhotoLens::Distance),
    ]
}

fn seeing() -> impl Strategy<Value = Intent> {
    let by_px = || (number(), number()).prop_map(|(x, y)| DVec2::new(x, y));
    prop_oneof![
        any_of(&ShadingMode::ALL).prop_map(Intent::Shading),
        any_of(&Lens::ALL).prop_map(Intent::Lens),
        any_of(&[Visibility::Shown, Visibility::Hidden]).prop_map(Intent::Wireframe),
        any_of(&PictureLight::ALL).prop_map(Intent::PictureLight),
        any_of(&[Switch::On, Switch::Off]).prop_map(Intent::MarkAnchors),
        proptest::option::of(number()).prop_map(Intent::Wipe),
        [number(), number(), number(), number()].prop_map(Intent::ViewportInsets),
        any_of(&Dots::ALL).prop_map(Intent::Dots),
        any_of(&[Background::Ground, Background::Plain(Srgb([1, 2, 3]))]).prop_map(Intent::Background),
        any_of(&[Theme::Light, Theme::Dark]).prop_map(Intent::Theme),
        any_of(&[Turntable::Still, Turntable::Turns]).prop_map(Intent::Turntable),
        number().prop_map(|strength| Intent::Light(Light { strength, ..Light::default() })),
        number().prop_map(Intent::Before),
        by_px().prop_map(Intent::Orbit),
        by_px().prop_map(Intent::Pan),
        number().prop_map(Intent::Zoom),
        (number(), by_px()).prop_map(|(factor, at_px)| Intent::ZoomAt(factor, at_px)),
        any_of(&[Visibility::Shown, Visibility::Hidden]).prop_map(Intent::Backdrop),
        any_of(&ShapePart::ALL).prop_map(Intent::Part),
        any_of(&[NamedView::Front, NamedView::Left, NamedView::Top, NamedView::Reset]).prop_map(Intent::GoTo),
        (0..3_000u32, 0..3_000u32, number()).prop_map(|(width, height, ratio)| Intent::Resize([width, height], ratio)),
        Just(Intent::Resize(SIZE_PX, 1.0)),
    ]
}

fn in_photo() -> impl Strategy<Value = Intent> {
    prop_oneof![
        3 => any_of(&Scene::ALL).prop_map(Intent::Scene),
        1 => prop_oneof![0.1..0.8, number()].prop_map(Intent::FalloffBand),
        2 => proptest::option::of(prop_oneof![0.2..3.0, number()]).prop_map(Intent::SeenFrom),
        2 => proptest::option::of(prop_oneof![4.0..120.0, number()]).prop_map(Intent::Brush),
        1 => Just(Intent::ClearStrokes),
        1 => Just(Intent::ShowDepth),
    ]
}

fn opening() -> impl Strategy<Value = Intent> {
    let slid =
        r#"{"rosto":"history","version":1,"entries":[{"label":"symmetry","switch":"on","symmetrise":{"share":0.5}}]}"#;
    let newer = r#"{"rosto":"history","version":99,"entries":[]}"#;
    let mut nowhere = detected();
    nowhere.landmarks.fill([0.5; 3]);
    let faces = vec![
        found(detected()),
        with_history(slid, Triangulation::Tessellation, 1),
        with_history(newer, Triangulation::Canonical, 0),
        with_history(slid, Triangulation::Canonical, 9),
        found(nowhere),
    ];
    prop_oneof![
        6 => any_of(&faces).prop_map(|face| Intent::Open(Box::new(face))),
        1 => Just(Intent::Close),
        1 => Just(Intent::RestorePreferences("{}".to_owned())),
    ]
}

fn mode() -> impl Strategy<Value = SelectionMode> {
    any_of(&[SelectionMode::Landmark, SelectionMode::Region, SelectionMode::Point])
}

fn region() -> impl Strategy<Value = Region> {
    any_of(&Region::ALL)
}

fn switch() -> impl Strategy<Value = Switch> {
    any_of(&[Switch::On, Switch::Off])
}

/// Mostly landmarks, with some vertices of denser meshes and some that do not exist.
fn vertex() -> impl Strategy<Value = u32> {
    prop_oneof![6 => 0..468u32, 2 => 0..7_257u32, 1 => any::<u32>()]
}

/// Mostly positions on the face.
fn position() -> impl Strategy<Value = DVec2> {
    let near = (250.0..550.0, 120.0..480.0);
    prop_oneof![
        8 => near.prop_map(|(x, y)| DVec2::new(x, y)),
        1 => (number(), number()).prop_map(|(x, y)| DVec2::new(x, y)),
    ]
}

/// Typical, boundary and invalid numbers.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => -2.0..2.0,
        2 => -1e3..1e3,
        1 => any_of(&[0.0, -0.0, 1e-308, 1e30, 1e308, -1e308, f64::NAN, f64::INFINITY, f64::NEG_INFINITY]),
    ]
}

fn any_of<T: Clone + std::fmt::Debug + 'static>(values: &[T]) -> impl Strategy<Value = T> + use<T> {
    prop::sample::select(values.to_vec())
}
