use glam::{DVec2, DVec3};
use rosto::{FileOptions, SavedFace};
use rosto_export::TextureSize;
use rosto_face::{Observation, PhotoLens, Triangulation};
use rosto_stage::{
    Axis, Background, Dots, Lens, Light, NamedView, PictureLight, Pointer, Scene, ShadingMode, Theme, Visibility,
};
use rosto_studio::{ConstraintKind, Details, Expression, FaceSlider, Mirror, Operator, Switch};
use serde::Deserialize;
use tsify::Tsify;

use crate::drag::Pace;
use crate::files::Report;
use crate::message::value::{self, Value};
use crate::{AnchorChoice, Look, Motion, Preset, Selection, SelectionMode, ShapePart, TextureSource, Turntable};

/// A user action, and the message of the page for it. Positions are in device pixels from the top left of the canvas.
/// Values are absolute, so that a repeated intent changes nothing; only pointer movements are relative.
#[derive(Debug, Clone, PartialEq, Deserialize, Tsify)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Intent {
    /// Opens a face in place of the current one.
    #[serde(skip)]
    Open(Box<SavedFace>),
    /// Shows the empty state: the average face as a slowly rotating wireframe.
    Close,
    /// Restores settings and view from [`Session::preferences`](crate::Session::preferences).
    RestorePreferences(String),

    /// Sets the value of a widget in a panel.
    Set(String, Value),
    /// Presses a button in a panel.
    Push(String),
    /// Shows the expert settings, and the numbers of points in names.
    Expert(bool),

    /// Sets what a click or a drag selects. The selection is converted: to the region around the landmark, the central
    /// landmark of the region, or the point at its position.
    #[serde(rename = "selection")]
    Mode(
        #[serde(deserialize_with = "value::id")]
        #[tsify(type = "string")]
        SelectionMode,
    ),
    /// Sets the selection. Random anchors are drawn again.
    Select(
        #[serde(deserialize_with = "value::selection")]
        #[tsify(type = "Selected | undefined")]
        Option<Selection>,
    ),
    /// Selects the vertex, or the smallest region around it; repeating selects the next larger region.
    SelectAt(u32),
    /// Selects at a position, like `SelectAt`; clears the selection outside the face.
    SelectUnder(
        #[serde(deserialize_with = "value::point")]
        #[tsify(type = "[number, number]")]
        DVec2,
    ),
    /// Pins or unpins the selection. Pins stay in place while other vertices move.
    Pin(
        #[serde(deserialize_with = "value::flag")]
        #[tsify(type = "boolean")]
        Switch,
    ),
    /// Pins or unpins the vertex at a position; no-op outside the face.
    PinUnder(
        #[serde(deserialize_with = "value::point")]
        #[tsify(type = "[number, number]")]
        DVec2,
    ),

    /// Applies a preset and shows the mesh density for it.
    Preset(
        #[serde(deserialize_with = "value::id")]
        #[tsify(type = "string")]
        Preset,
    ),
    /// Sets the operator of the δ-coordinates.
    Operator(
        #[serde(deserialize_with = "value::id")]
        #[tsify(type = "string")]
        Operator,
    ),
    /// Sets how firmly handles and anchors are held.
    Constraint(
        #[serde(deserialize_with = "value::constraint")]
        #[tsify(type = "string")]
        ConstraintKind,
    ),
    /// Sets whether details rotate with the surface.
    Details(
        #[serde(deserialize_with = "value::id")]
        #[tsify(type = "string")]
        Details,
    ),
    /// Sets the anchors in addition to the pins.
    Anchors(
        #[serde(deserialize_with = "value::id")]
        #[tsify(type = "string")]
        AnchorChoice,
    ),
    /// Sets whether edits are mirrored to the other side.
    Mirror(
        #[serde(deserialize_with = "value::flag")]
        #[tsify(type = "boolean")]
        Mirror,
    ),
    /// Sets whether edits are limited to the influence radius.
    Nearby(
        #[serde(deserialize_with = "value::flag")]
        #[tsify(type = "boolean")]
        Switch,
    ),
    /// Sets the influence radius in mm and limits edits to it. A drag continues.
    Radius(f64),

    /// Tick of the selection's sliders: its offset in mm, including earlier entries.
    Offset(
        #[serde(deserialize_with = "value::vector")]
        #[tsify(type = "[number, number, number]")]
        DVec3,
    ),
    /// Tick of a ready-made slider: its value in mm, including earlier entries.
    Slide(
        #[serde(deserialize_with = "value::id")]
        #[tsify(type = "string")]
        FaceSlider,
        f64,
    ),
    /// Tick of an expression: its weight, 0..=1, including earlier entries. With the mirror, its partner on the other
    /// side gets the same weight.
    Express(
        #[serde(deserialize_with = "value::id")]
        #[tsify(type = "string")]
        Expression,
        f64,
    ),
    /// Commits the edit in progress as one entry of the history; no entry if nothing moved.
    Commit,
    /// Discards the edit in progress. Ends a drag even if the pointer stays pressed.
    Cancel,

    /// Pointer movement without a press; `None` when it leaves the canvas.
    Hover(
        #[serde(deserialize_with = "value::maybe_point")]
        #[tsify(type = "[number, number] | undefined")]
        Option<DVec2>,
    ),
    /// Highlights a landmark that is hovered elsewhere, such as on the photo.
    PointAt(Option<u32>),
    /// Pointer press; the vertex under it can be dragged. `true` for touch, which is less exact than a mouse or a pen.
    Press(
        #[serde(deserialize_with = "value::point")]
        #[tsify(type = "[number, number]")]
        DVec2,
        #[serde(deserialize_with = "value::flag")]
        #[tsify(type = "boolean")]
        Pointer,
    ),
    /// Movement of the pressed pointer; the grabbed vertex follows. `true` for a tenth of the movement.
    Drag(
        #[serde(deserialize_with = "value::point")]
        #[tsify(type = "[number, number]")]
        DVec2,
        #[serde(deserialize_with = "value::flag")]
        #[tsify(type = "boolean")]
        Pace,
    ),
    /// Constrains the drag to one axis, or to none.
    Along(
        #[serde(deserialize_with = "value::maybe_id")]
        #[tsify(type = "string | undefined")]
        Option<Axis>,
    ),
    /// Pointer release; commits the drag.
    Release,

    /// Undoes the last change of the history. An edit in progress is committed first and then undone.
    Undo,
    /// Redoes the last undone change.
    Redo,
    /// Removes all entries, as one change.
    Reset,
    /// Switches off each entry that moved the selection, as one change.
    ResetSelected,
    /// Switches off each expression, as one change.
    ResetExpressions,
    /// Switches an entry of the history on or off.
    Switch(
        usize,
        #[serde(deserialize_with = "value::flag")]
        #[tsify(type = "boolean")]
        Switch,
    ),
    /// Sets the options of exported files.
    #[serde(skip)]
    FileOptions(FileOptions),
    /// Sets whether pictures have a transparent background.
    Transparent(bool),
    /// The page reports about its files.
    Report(Report),
    /// Sets the share that the panel offers for `Symmetrise`.
    SymmetryShare(f64),
    /// Shows the controls of a part of the face.
    Part(
        #[serde(deserialize_with = "value::id")]
        #[tsify(type = "string")]
        ShapePart,
    ),
    /// Sets all expressions to those of a look, or to none, as one change.
    Look(
        #[serde(deserialize_with = "value::maybe_id")]
        #[tsify(type = "string | undefined")]
        Option<Look>,
    ),
    /// Starts the measuring tape at the selection.
    StartTape,
    /// Moves both sides towards symmetry; a share of 1 makes them mirror images.
    Symmetrise(f64),

    /// Sets the density of the displayed and exported mesh; 0 is the 468 landmarks.
    Density(
        #[serde(deserialize_with = "value::density")]
        #[tsify(type = "string")]
        u32,
    ),
    /// Sets the lens of the photo, and so its distance: `estimated`, `exif:MM`, `given:MM` or `distance:M`. Rebuilds
    /// the model and reapplies the edits.
    PhotoLens(
        #[serde(deserialize_with = "value::lens")]
        #[tsify(type = "string")]
        PhotoLens,
    ),
    /// Shows the photo, in which the next four presses mark the corners of a bank card that measures the face.
    MarkCard,
    /// Measures the face without a card.
    ForgetCard,
    /// Adds a photo of the same face; rebuilds the model from all of them and reapplies the edits.
    #[serde(skip)]
    AddPhoto(Box<Observation>),
    /// Removes a photo, by its index in the order in which they were added.
    RemovePhoto(usize),
    /// Sets the triangulation and reapplies the edits. Pinned points other than landmarks are unpinned.
    Triangulation(
        #[serde(deserialize_with = "value::id")]
        #[tsify(type = "string")]
        Triangulation,
    ),

    /// Shows the photo or the 3D face.
    Scene(
        #[serde(deserialize_with = "value::id")]
        #[tsify(type = "string")]
        Scene,
    ),
    /// Sets the falloff band around the face, as a share of the face's longer side within
    /// `rosto_studio::FALLOFF_BAND_SHARES`.
    FalloffBand(f64),
    /// Shows the face in its photo as from a distance in metres; `None` is the original distance.
    SeenFrom(Option<f64>),
    /// Sets the brush, by its radius in CSS px, or removes it. The brush shows the photo and paints the parts to
    /// protect. Undo and redo then act on its strokes.
    Brush(Option<f64>),
    /// Removes all strokes.
    ClearStrokes,
    /// Rotates the view so that edits in depth are visible; leaves the photo if necessary.
    ShowDepth,

    /// Sets the colouring of the surface.
    Shading(
        #[serde(deserialize_with = "value::id")]
        #[tsify(type = "string")]
        ShadingMode,
    ),
    /// Sets the source of the texture.
    TextureSource(
        #[serde(deserialize_with = "value::id")]
        #[tsify(type = "string")]
        TextureSource,
    ),
    /// Sets the size of the texture.
    TextureSize(
        #[serde(deserialize_with = "value::id")]
        #[tsify(type = "string")]
        TextureSize,
    ),
    /// Shows or hides the edges.
    Wireframe(
        #[serde(deserialize_with = "value::flag")]
        #[tsify(type = "boolean")]
        Visibility,
    ),
    /// Sets which landmarks are shown as dots.
    Dots(
        #[serde(deserialize_with = "value::flag")]
        #[tsify(type = "boolean")]
        Dots,
    ),
    /// Sets the background: a uniform sRGB colour, or none for the theme's background with a shadow below the face.
    Background(
        #[serde(deserialize_with = "value::background")]
        #[tsify(type = "[number, number, number] | undefined")]
        Background,
    ),
    /// Sets the light.
    Light(
        #[serde(deserialize_with = "value::light")]
        #[tsify(type = "LightSettings")]
        Light,
    ),
    /// Sets whether the light also affects the photo, which contains its own lighting.
    PictureLight(
        #[serde(deserialize_with = "value::flag")]
        #[tsify(type = "boolean")]
        PictureLight,
    ),
    /// Shows or hides markers at the anchors.
    MarkAnchors(
        #[serde(deserialize_with = "value::flag")]
        #[tsify(type = "boolean")]
        Switch,
    ),
    /// Sets the light or dark theme.
    Theme(
        #[serde(deserialize_with = "value::id")]
        #[tsify(type = "string")]
        Theme,
    ),
    /// Blends the edited face (0) with the original (1).
    Before(f64),
    /// Shows the original face left of this share of the canvas' width, 0..=1, and the edited one right of it; `None`
    /// ends the comparison.
    Wipe(Option<f64>),
    /// Turns auto-rotation on or off.
    Turntable(
        #[serde(deserialize_with = "value::flag")]
        #[tsify(type = "boolean")]
        Turntable,
    ),
    /// Sets reduced motion: no gliding camera, no arrival movement, no rotating empty state.
    #[serde(rename = "reduced-motion")]
    Motion(
        #[serde(deserialize_with = "value::flag")]
        #[tsify(type = "boolean")]
        Motion,
    ),
    /// Sets the lens of the view; the photo's own lens also moves the view to the photo's camera.
    Lens(
        #[serde(deserialize_with = "value::id")]
        #[tsify(type = "string")]
        Lens,
    ),
    /// Orbits the 3D face, or pans the photo, by a pointer movement in px.
    Orbit(
        #[serde(deserialize_with = "value::point")]
        #[tsify(type = "[number, number]")]
        DVec2,
    ),
    /// Pans the view by a pointer movement in px.
    Pan(
        #[serde(deserialize_with = "value::point")]
        #[tsify(type = "[number, number]")]
        DVec2,
    ),
    /// Zooms by a factor; above 1 enlarges.
    Zoom(f64),
    /// Zooms by a factor at a position: the photo about it, the 3D face about its centre.
    ZoomAt(
        f64,
        #[serde(deserialize_with = "value::point")]
        #[tsify(type = "[number, number]")]
        DVec2,
    ),
    /// Goes to a named view.
    GoTo(
        #[serde(deserialize_with = "value::id")]
        #[tsify(type = "string")]
        NamedView,
    ),
    /// Resizes the canvas to a width and height in px, at a device-pixel ratio.
    Resize([u32; 2], f64),
    /// Sets the viewport insets in px: top, right, bottom, left. The face is framed in the remaining area.
    ViewportInsets([f64; 4]),
    /// Shows the photo, dimmed, behind the 3D face until the face turns.
    Backdrop(
        #[serde(deserialize_with = "value::flag")]
        #[tsify(type = "boolean")]
        Visibility,
    ),
}
