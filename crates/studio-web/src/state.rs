//! State for the page, as values that JavaScript can read.

use rosto_laplacian::LaplacianError;
use rosto_session::{Choice, FaceState, Range, Row, Selection, Session, Tick, Turntable};
use rosto_stage::{Background, Dots, PictureLight, Srgb, Visibility};
use rosto_studio::{EditTarget, EntryStatus, Mirror, StudioError, Switch};
use wasm_bindgen::prelude::*;

use crate::error::FacadeError;
use crate::modes::RefusalName;
use crate::readable::readable;

readable! {
    /// The state that panels show, apart from the edit in progress.
    pub struct StudioState {
        /// Number of displayed vertices.
        vertex_count as vertexCount: u32,
        /// Number of vertices that can be selected, from 0.
        selectable: u32,
        /// The selected vertex, or the central landmark of the selected region.
        selected: Option<u32>,
        /// The selected region, if any.
        selected_region as selectedRegion: Option<String>,
        /// Whether the selection is its own mirror image and the mirror is on; sideways it moves without the mirror.
        selected_in_plane as selectedInPlane: bool,
        /// Whether the edit in progress moves sideways out of the mirror plane.
        leaves_plane as leavesPlane: bool,
        /// Whether a ready-made slider or an expression is being moved, rather than the selection.
        is_sliding as isSliding: bool,
        /// Whether each vertex of the selection is pinned.
        pinned: bool,
        /// Whether the selection has a mirror image.
        can_mirror as canMirror: bool,
        /// Why the selection cannot be moved, if it cannot.
        refusal: Option<RefusalName>,
        /// Vertices that stay in place while the selection moves.
        anchors: Vec<u32>,
        /// Whether edits are mirrored to the other side of the face.
        mirror: bool,
        /// Whether edits are limited to the influence radius.
        nearby: bool,
        /// Influence radius, in mm.
        radius_mm as radiusMm: f64,
        /// Whether edges are shown.
        wireframe: bool,
        /// Whether anchors are marked.
        anchors_marked as anchorsMarked: bool,
        /// Whether the original face is shown next to the edited one.
        is_wiping as isWiping: bool,
        /// Whether the light also affects the photo.
        photo_lit as photoLit: bool,
        /// Whether all landmarks are shown as dots.
        dots: bool,
        /// Whether the face rotates automatically.
        turntable: bool,
        /// Azimuth and elevation of the directional light in degrees, its strength, and the strength of the ambient
        /// light.
        light: Vec<f64>,
        /// Colour of the directional light, sRGB.
        light_colour as lightColour: Vec<u8>,
        /// The uniform background colour, sRGB; empty for the theme's background.
        backdrop: Vec<u8>,
        /// Sum of the x offsets of the selection's entries in force, in mm.
        kept_x_mm as keptXMm: f64,
        /// Sum of the y offsets, in mm.
        kept_y_mm as keptYMm: f64,
        /// Sum of the z offsets, in mm.
        kept_z_mm as keptZMm: f64,
        /// Whether the history contains entries in force that moved the selection.
        can_reset_selection as canResetSelection: bool,
        /// Whether there is a change to undo.
        can_undo as canUndo: bool,
        /// Whether there is an undone change to redo.
        can_redo as canRedo: bool,
        /// Number of entries, without undone ones.
        entry_count as entryCount: u32,
        /// Whether the committed offset is almost parallel to the view direction and so hardly visible.
        is_along_view as isAlongView: bool,
        /// Falloff band around the face in its photo, as a share of the face's longer side.
        falloff_band as falloffBand: f64,
        /// Distance from which the photo is shown, in metres; infinite for a parallel projection.
        seen_from_m as seenFromM: f64,
        /// Whether that is the original distance.
        is_as_taken as isAsTaken: bool,
        /// Radius of the brush in CSS px, if it is in use.
        brush_px as brushPx: Option<f64>,
        /// Number of strokes that protect the photo.
        stroke_count as strokeCount: u32,
        /// Whether there is an undone stroke to redo.
        can_redo_stroke as canRedoStroke: bool,
    } hidden {
        /// Id of each setting's value, in the settings' order.
        chosen: Vec<Option<String>>,
    }
}

#[wasm_bindgen]
impl StudioState {
    /// Id of a setting's value, as `choose` takes it; undefined if it is not an available one, such as when no preset
    /// matches.
    ///
    /// # Errors
    /// `bad-choice`.
    pub fn chosen(&self, choice: &str) -> Result<Option<String>, JsValue> {
        let choice = FacadeError::require(Choice::from_id(choice))?;
        Ok(self.chosen[choice as usize].clone())
    }
}

impl StudioState {
    pub(crate) fn of(session: &Session) -> Self {
        let state = session.state();
        let (face, edit_options, view) = (state.face.as_ref(), &state.edit_options, &state.view);
        let is = |what: fn(&FaceState) -> bool| face.is_some_and(what);
        let selection = face.and_then(|face| face.selection);
        let committed_mm = face.map_or(glam::DVec3::ZERO, |face| face.committed_mm);
        let light = &state.light;
        Self {
            chosen: Choice::ALL.map(|choice| session.chosen(choice)).to_vec(),
            vertex_count: face.map_or(0, |face| face.vertex_count as u32),
            selectable: state.selectable as u32,
            selected: selection.map(Selection::centre),
            selected_region: match selection {
                Some(Selection::Region(region)) => Some(region.id().to_owned()),
                _ => None,
            },
            selected_in_plane: is(|face| face.lies_in_plane),
            leaves_plane: is(|face| face.leaves_plane),
            is_sliding: is(|face| face.is_sliding),
            pinned: is(|face| face.is_pinned),
            can_mirror: face.is_none_or(|face| face.can_mirror),
            refusal: face.and_then(|face| face.refusal.as_ref()).map(RefusalName::from),
            anchors: face.map(|face| face.anchors.clone()).unwrap_or_default(),
            mirror: edit_options.mirror == Mirror::On,
            nearby: edit_options.is_nearby,
            radius_mm: edit_options.radius_mm,
            wireframe: view.wireframe == Visibility::Shown,
            anchors_marked: view.anchors == Switch::On,
            is_wiping: session.stage().render_settings().wipe.is_some(),
            photo_lit: view.picture_light == PictureLight::Lamp,
            dots: state.dots == Dots::All,
            turntable: view.turntable == Turntable::Turns,
            light: vec![light.azimuth_deg, light.elevation_deg, light.strength, light.ambient],
            light_colour: light.colour.0.to_vec(),
            backdrop: match view.background {
                Background::Plain(Srgb(colour)) => colour.to_vec(),
                Background::Ground | Background::Transparent => Vec::new(),
            },
            kept_x_mm: committed_mm.x,
            kept_y_mm: committed_mm.y,
            kept_z_mm: committed_mm.z,
            can_reset_selection: is(|face| face.can_reset_selection),
            can_undo: is(|face| face.can_undo),
            can_redo: is(|face| face.can_redo),
            entry_count: face.map_or(0, |face| face.entry_count as u32),
            is_along_view: is(|face| face.is_along_view),
            falloff_band: view.falloff_band,
            seen_from_m: face.map_or(f64::INFINITY, |face| face.seen_from_m),
            is_as_taken: is(|face| face.is_as_taken),
            brush_px: state.brush_px,
            stroke_count: face.map_or(0, |face| face.stroke_count as u32),
            can_redo_stroke: is(|face| face.can_redo_stroke),
        }
    }
}

impl From<&StudioError> for RefusalName {
    fn from(reason: &StudioError) -> Self {
        match reason {
            StudioError::Laplacian(LaplacianError::Unanchored { .. }) => Self::Unanchored,
            _ => Self::Other,
        }
    }
}

readable! {
    /// Progress of an edit.
    pub struct StudioTick {
        /// Whether an edit is in progress.
        editing: bool,
        /// Offset along x, in mm.
        offset_x_mm as offsetXMm: f64,
        /// Offset along y, in mm.
        offset_y_mm as offsetYMm: f64,
        /// Offset along z, in mm.
        offset_z_mm as offsetZMm: f64,
        /// Value of each ready-made slider in mm: the sum of its entries in force and the edit in progress.
        sliders_mm as slidersMm: Vec<f64>,
        /// Weight of each expression, 0..1, in the order of `expressionIds`.
        weights: Vec<f64>,
        /// Share of its offset that the selected vertex reaches; 1 is all.
        share_reached as shareReached: f64,
        /// Whether the drag exceeds the range of the sliders.
        is_at_end as isAtEnd: bool,
        /// Whether the offset is almost parallel to the view direction and so hardly visible.
        is_along_view as isAlongView: bool,
    }
}

impl StudioTick {
    pub(crate) fn of(tick: Tick) -> Self {
        Self {
            editing: tick.is_editing,
            offset_x_mm: tick.offset_mm.x,
            offset_y_mm: tick.offset_mm.y,
            offset_z_mm: tick.offset_mm.z,
            sliders_mm: tick.sliders_mm.to_vec(),
            weights: tick.weights.to_vec(),
            share_reached: tick.share_reached,
            is_at_end: tick.is_at_end,
            is_along_view: tick.is_along_view,
        }
    }
}

readable! {
    /// An entry of the history.
    pub struct StudioEntry {
        /// Index in the history, from 0.
        index: u32,
        /// The object that it edits.
        target: StudioTarget,
        /// Length of its offset, or its share or weight, in `unit`.
        amount: f64,
        /// Unit of `amount`: "mm" or "%".
        unit: String,
        /// Whether it is switched on.
        enabled: bool,
        /// Density that it waits for, if that is higher than the displayed one.
        waits_for_density as waitsForDensity: Option<u32>,
        /// Whether it has no solution on the displayed mesh and is skipped.
        impossible: bool,
    }
}

impl StudioEntry {
    pub(crate) fn of(row: &Row, target: StudioTarget) -> Self {
        Self {
            index: row.index as u32,
            target,
            amount: row.amount,
            unit: row.unit.to_owned(),
            enabled: row.status != EntryStatus::Off,
            waits_for_density: match row.status {
                EntryStatus::Waits { level } => Some(level),
                _ => None,
            },
            impossible: matches!(row.status, EntryStatus::Impossible(_)),
        }
    }
}

readable! {
    /// Range of a number; the page's sliders use it.
    pub struct StudioRange {
        /// Lower end.
        min: f64,
        /// Upper end.
        max: f64,
        /// Change per key press.
        step: f64,
        /// Initial value.
        neutral: f64,
    }
}

impl From<Range> for StudioRange {
    fn from(range: Range) -> Self {
        Self { min: range.min, max: range.max, step: range.step, neutral: range.default }
    }
}

readable! {
    /// The object that an edit works on.
    pub struct StudioTarget {
        /// "landmark", "point", "region", "slider", "vertices", "symmetry" or "expression".
        kind: String,
        /// Id, such as "nose-tip", "left-brow" or "nose-width".
        id: String,
        /// Number of a landmark or point, or number of vertices; undefined for other kinds.
        number: Option<u32>,
        /// Part of the face around a point, such as "left-cheek", if its mesh has been built.
        part: Option<String>,
    }
}

impl StudioTarget {
    pub(crate) fn of(target: EditTarget, part: Option<String>) -> Self {
        let number = match target {
            EditTarget::Landmark(vertex) | EditTarget::Point { vertex, .. } => Some(vertex),
            EditTarget::Vertices(count) => Some(count as u32),
            EditTarget::Region(_) | EditTarget::Slider(_) | EditTarget::Symmetry | EditTarget::Expression(_) => None,
        };
        Self { kind: target.kind().to_owned(), id: target.to_string(), number, part }
    }
}

readable! {
    /// A ready-made slider.
    pub struct StudioSlider {
        /// Id for [`Studio::slide`](crate::Studio::slide), such as "nose-width".
        id: String,
        /// Range to either side, in mm.
        range_mm as rangeMm: f64,
    }
}

readable! {
    /// A position on the canvas, in device pixels from its top left.
    #[derive(Copy)]
    pub struct ScreenPoint {
        /// To the right.
        x: f64,
        /// Down.
        y: f64,
    }
}

readable! {
    /// A picture of the canvas as straight (not premultiplied) sRGB RGBA.
    pub struct Snapshot {
        /// Width in pixels.
        width: u32,
        /// Height in pixels.
        height: u32,
    } hidden {
        pixels: Vec<u8>,
    }
}

impl From<rosto_viewport::Snapshot> for Snapshot {
    fn from(snapshot: rosto_viewport::Snapshot) -> Self {
        Self { width: snapshot.width, height: snapshot.height, pixels: snapshot.rgba }
    }
}

#[wasm_bindgen]
impl Snapshot {
    /// Takes the pixels, row by row from the top; empty on later calls.
    #[wasm_bindgen(js_name = takePixels)]
    pub fn take_pixels(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.pixels)
    }
}
