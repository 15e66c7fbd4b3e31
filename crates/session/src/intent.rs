use glam::{DVec2, DVec3};
use rosto_export::TextureSize;
use rosto_face::{PhotoLens, Triangulation};
use rosto_stage::{
    Axis, Background, Dots, Lens, Light, NamedView, PictureLight, Pointer, Scene, ShadingMode, Theme, Visibility,
};
use rosto_studio::{ConstraintKind, Details, Expression, FaceSlider, Mirror, Operator, Switch};

use crate::drag::Pace;
use crate::{AnchorChoice, FurtherPhoto, Incoming, Motion, Preset, Selection, SelectionMode, TextureSource, Turntable};

/// Everything that a visitor can want. Places are device pixels from the canvas' top left.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Intent {
    /// Opens a face in place of the one that is open.
    Open(Box<Incoming>),
    /// Shows the empty state: the average face as a slowly turning wireframe.
    Close,
    /// Puts choices and view as an earlier [`Session::preferences`](crate::Session::preferences) tells.
    Prefer(String),

    /// What a click or a drag selects from now on. What is selected follows: the region around the landmark, the landmark
    /// in the middle of the region, or the point at its place.
    Mode(SelectionMode),
    /// Selects something, or nothing. Random anchors are drawn anew.
    Select(Option<Selection>),
    /// Selects what is at a vertex: it alone, or the smallest region around it and, asked again, the next larger one.
    SelectAt(u32),
    /// Selects what is at a place, or nothing where there is no face.
    SelectUnder(DVec2),
    /// Pins what is selected, so that it stays while others move, or frees it.
    Pin(Switch),
    /// Pins the vertex at a place, or frees it; nothing where there is no face.
    PinUnder(DVec2),

    /// Makes all choices of a preset, and shows the mesh that it is for.
    Preset(Preset),
    /// How the surface's details are described.
    Operator(Operator),
    /// How firmly handles and anchors are held.
    Constraint(ConstraintKind),
    /// Whether details turn with the surface.
    Details(Details),
    /// Which vertices stay beside those pinned by hand.
    Anchors(AnchorChoice),
    /// Whether the other side of the face follows.
    Mirror(Mirror),
    /// Whether an edit reaches no further than the radius.
    Nearby(Switch),
    /// How far an edit reaches, in mm; it then reaches no further. A drag goes on.
    Radius(f64),
    /// Makes that so many times as far, within its limits.
    Widen(f64),

    /// One tick of the sliders of what is selected: its offset in mm from where the last commit left it.
    Preview(DVec3),
    /// One tick of a ready-made slider: where it is to stand in mm, its earlier entries counted.
    Slide(FaceSlider, f64),
    /// One tick of an expression: how much of it the face is to show, 0..=1, its earlier entries counted. With the mirror, its
    /// partner of the other side shows as much.
    Express(Expression, f64),
    /// Keeps the edit in progress as one entry of the history; nothing moved is no entry.
    Commit,
    /// Drops the edit in progress. A drag is over, even if the pointer stays pressed.
    Cancel,

    /// The pointer is at a place, or has left.
    Hover(Option<DVec2>),
    /// A landmark is pointed at elsewhere, such as on the photo.
    PointAt(Option<u32>),
    /// The pointer is pressed: what lies under it may be dragged.
    Press(DVec2, Pointer),
    /// The pressed pointer goes to a place, and what it has grabbed follows.
    Drag(DVec2, Pace),
    /// What is dragged follows along one axis only; the same axis again frees it.
    Along(Axis),
    /// The pointer is let go: what was dragged is kept.
    Release,

    /// Takes the last change of the history back. An edit in progress is kept first, and is what is taken back.
    Undo,
    /// Brings the last undone change back.
    Redo,
    /// Takes all entries away, as one change.
    Reset,
    /// Switches every entry off that moved what is selected, as one change.
    ResetSelected,
    /// Switches every expression off, as one change: the face is at rest.
    ComeToRest,
    /// Lets an entry of the history take part in the shape, or not.
    Switch(usize, Switch),
    /// Brings the two sides of the face closer to each other: a share of 1 leaves mirror images.
    Symmetrise(f64),

    /// How often the mesh that is shown and exported is subdivided: 0 is the 468 landmarks.
    Density(u32),
    /// Through which lens the photo was taken, and so from how far away; the model is taken out of it anew, and the edits are
    /// carried out again.
    PhotoLens(PhotoLens),
    /// A further photo of the same face: the model is made of all of them, and the edits are carried out again.
    AddPhoto(Box<FurtherPhoto>),
    /// Takes one of them away again, by its place in the order that they were given in.
    RemovePhoto(usize),
    /// How the landmarks are joined; the edits are carried out again. Points that were pinned are free again.
    Triangulation(Triangulation),

    /// Puts the photo on the stage, or the face in the round. Who turns the photo turns the face out of it.
    Scene(Scene),
    /// How far around the face its photo gives way, as a share of the face's longer side within `rosto_studio::FALLOFF_BAND_SHARES`.
    FalloffBand(f64),
    /// Shows the face in its photo as a camera sees it from so many metres; none as it was taken.
    SeenFrom(Option<f64>),
    /// Takes a brush of that radius in CSS px in hand, or none: pressed on the photo, which comes onto the stage, it paints
    /// what is kept as it is. Undo and redo are for its strokes then.
    Brush(Option<f64>),
    /// Takes all strokes away.
    KeepNothing,
    /// Turns the face to where an edit in depth is seen, out of the photo if need be.
    ShowDepth,

    /// How the surface is coloured.
    Shading(ShadingMode),
    /// Which picture is laid on it.
    TextureSource(TextureSource),
    /// How large its texture is to be.
    TextureSize(TextureSize),
    /// Whether edges are drawn over it.
    Wireframe(Visibility),
    /// Which landmarks show as dots.
    Dots(Dots),
    /// What lies behind the face.
    Background(Background),
    /// The light.
    Light(Light),
    /// Whether the light falls on the photo, too, which has its own.
    PictureLight(PictureLight),
    /// Whether the vertices that stay in place are marked.
    MarkAnchors(Switch),
    /// Light or dark surroundings.
    Theme(Theme),
    /// 0 shows the face as edited, 1 as it was found.
    Before(f64),
    /// The face as it was found up to this share of the canvas' width, 0..1 from the left, and as edited beyond; none ends it.
    Wipe(Option<f64>),
    /// Whether the face turns by itself.
    Turntable(Turntable),
    /// Whether things move by themselves.
    Motion(Motion),
    /// From how far away the face is seen; as its photo was taken, it goes to where the photo's camera stood.
    Lens(Lens),
    /// Turns the face as if the pointer held it, by so many px.
    Orbit(DVec2),
    /// Moves the face with the pointer, by so many px.
    Pan(DVec2),
    /// Shows the face larger by a factor above 1, smaller by one below.
    Zoom(f64),
    /// Goes to a named view.
    GoTo(NamedView),
    /// The canvas has another size in px, and so many px make a CSS px.
    Resize([u32; 2], f64),
    /// So many px at the canvas' top, right, bottom and left lie under something else: the face is framed in the rest.
    ViewportInsets([f64; 4]),
}

impl Intent {
    /// Whether it takes the face in hand, so that it is not to turn by itself any more as it does when it has arrived.
    pub(crate) fn takes_in_hand(&self) -> bool {
        matches!(
            self,
            Self::Press(..)
                | Self::Orbit(_)
                | Self::Pan(_)
                | Self::Zoom(_)
                | Self::GoTo(_)
                | Self::Lens(_)
                | Self::Scene(_)
                | Self::Brush(_)
                | Self::ShowDepth
                | Self::Preview(_)
                | Self::Slide(..)
                | Self::Express(..)
                | Self::Turntable(_)
        )
    }
}
