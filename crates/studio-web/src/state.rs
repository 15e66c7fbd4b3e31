//! What the page shows, as values it can read.

use rosto_laplacian::LaplacianError;
use rosto_session::{Choice, FaceState, Range, Row, Selection, Session, Tick, Turntable};
use rosto_stage::{Background, Dots, PictureLight, Srgb, Visibility};
use rosto_studio::{EditTarget, EntryStatus, Mirror, StudioError, Switch};
use wasm_bindgen::prelude::*;

use crate::error::FacadeError;
use crate::modes::RefusalName;
use crate::readable::readable;

readable! {
    /// Everything the panels show about the session, apart from the edit in progress.
    pub struct StudioState {
        /// Number of vertices shown.
        vertex_count as vertexCount: u32,
        /// How many vertices it can select, from 0.
        selectable: u32,
        /// The selected vertex, if any; of a selected region, the landmark in its middle.
        selected: Option<u32>,
        /// The selected region, if any.
        selected_region as selectedRegion: Option<String>,
        /// Whether what is selected is its own mirror image and the mirror is on: sideways it moves alone.
        selected_in_plane as selectedInPlane: bool,
        /// Whether it does so now.
        leaves_plane as leavesPlane: bool,
        /// Whether a ready-made slider is in hand, and not what is selected.
        is_sliding as isSliding: bool,
        /// Whether all that is selected is pinned.
        pinned: bool,
        /// Whether the other side of the face can follow what is selected.
        can_mirror as canMirror: bool,
        /// Why what is selected cannot be moved, if it cannot.
        refusal: Option<RefusalName>,
        /// The vertices that stay while what is selected moves.
        anchors: Vec<u32>,
        /// Whether the other side of the face follows.
        mirror: bool,
        /// Whether an edit reaches no further than the radius.
        nearby: bool,
        /// That radius, in mm.
        radius_mm as radiusMm: f64,
        /// Whether edges are drawn over it.
        wireframe: bool,
        /// Whether what stays in place is marked.
        anchors_marked as anchorsMarked: bool,
        /// Whether the face as it was found is seen beside the face as edited.
        is_wiping as isWiping: bool,
        /// Whether the light falls on the photo, too.
        photo_lit as photoLit: bool,
        /// Whether every landmark shows as a dot.
        dots: bool,
        /// Whether the face turns by itself.
        turntable: bool,
        /// Azimuth and elevation of the directional light in degrees, its strength, and that of the light from everywhere.
        light: Vec<f64>,
        /// Its colour, sRGB.
        light_colour as lightColour: Vec<u8>,
        /// The one colour behind the face, sRGB; empty for the usual ground.
        backdrop: Vec<u8>,
        /// Sum of the offsets along x that the history holds for what is selected, as far as they are in force, in mm.
        kept_x_mm as keptXMm: f64,
        /// The same along y.
        kept_y_mm as keptYMm: f64,
        /// The same along z.
        kept_z_mm as keptZMm: f64,
        /// Whether the history holds edits in force of what is selected.
        can_reset_selection as canResetSelection: bool,
        /// Whether there is something to undo.
        can_undo as canUndo: bool,
        /// Whether there is something to redo.
        can_redo as canRedo: bool,
        /// How many entries the history has, without what was undone.
        entry_count as entryCount: u32,
        /// Whether the offsets kept go so nearly along the view that they hardly show from here.
        is_along_view as isAlongView: bool,
        /// How far around the face its photo gives way, as a share of the face's longer side.
        falloff_band as falloffBand: f64,
        /// From how far away the face is shown in its photo, in metres; infinite where its camera is taken to be very far.
        seen_from_m as seenFromM: f64,
        /// Whether that is as it was taken.
        is_as_taken as isAsTaken: bool,
        /// The brush in hand: its radius in CSS px.
        brush_px as brushPx: Option<f64>,
        /// How many strokes keep something of the photo.
        stroke_count as strokeCount: u32,
        /// Whether one can be brought back.
        can_redo_stroke as canRedoStroke: bool,
    } hidden {
        /// What is chosen of each choice, in their order.
        chosen: Vec<Option<String>>,
    }
}

#[wasm_bindgen]
impl StudioState {
    /// The id of what is chosen, as `choose` takes it; undefined where it is nothing that is offered, such as no preset.
    ///
    /// # Errors
    /// `bad-choice`.
    pub fn chosen(&self, choice: &str) -> Result<Option<String>, JsValue> {
        let choice = FacadeError::unless(Choice::from_id(choice))?;
        Ok(self.chosen[choice as usize].clone())
    }
}

impl StudioState {
    pub(crate) fn of(session: &Session) -> Self {
        let state = session.state();
        let (face, choices, view) = (state.face.as_ref(), &state.choices, &state.view);
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
            mirror: choices.mirror == Mirror::On,
            nearby: choices.is_nearby,
            radius_mm: choices.radius_mm,
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
    /// How far the edit in progress has gone.
    pub struct StudioTick {
        /// Whether an edit is in progress that `commit` would keep.
        editing: bool,
        /// Its offset along x, in mm.
        offset_x_mm as offsetXMm: f64,
        /// Its offset along y, in mm.
        offset_y_mm as offsetYMm: f64,
        /// Its offset along z, in mm.
        offset_z_mm as offsetZMm: f64,
        /// Where each ready-made slider stands, in mm: the sum of its entries that are in force, and the edit in progress.
        sliders_mm as slidersMm: Vec<f64>,
        /// How much of each expression the face shows, 0..1, in the order of `expressionIds`.
        weights: Vec<f64>,
        /// Share of its offset that what is selected reaches: 1 is all of it.
        share_reached as shareReached: f64,
        /// Whether the pointer drags it further than its sliders go.
        is_at_end as isAtEnd: bool,
        /// Whether it goes so nearly along the view that it hardly shows from here.
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
    /// One entry of the history.
    pub struct StudioEntry {
        /// Place in the history, from 0.
        index: u32,
        /// What it works on.
        target: StudioTarget,
        /// How far it moves what it moves, or how much it does.
        amount: f64,
        /// What `amount` counts: "mm" or "%".
        unit: String,
        /// Whether it is switched on.
        enabled: bool,
        /// How often the mesh must be subdivided before it takes part, if that is more often than the one that is shown.
        waits_for_density as waitsForDensity: Option<u32>,
        /// Whether it has no answer on the mesh that is shown, and is passed over.
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
    /// What the numbers of the panels go through; the page's sliders are made after it.
    pub struct StudioRange {
        /// Lower end.
        min: f64,
        /// Upper end.
        max: f64,
        /// What one key press changes.
        step: f64,
        /// Where it stands at first.
        neutral: f64,
    }
}

impl From<Range> for StudioRange {
    fn from(range: Range) -> Self {
        Self { min: range.min, max: range.max, step: range.step, neutral: range.default }
    }
}

readable! {
    /// What an edit works on.
    pub struct StudioTarget {
        /// "landmark", "point", "region", "slider", "vertices", "symmetry" or "expression".
        kind: String,
        /// Its id, such as "nose-tip", "left-brow" or "nose-width".
        id: String,
        /// The number of a landmark or point, or how many vertices; undefined for others.
        number: Option<u32>,
        /// The part of the face that a point lies in, such as "left-cheek", once its mesh was shown.
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
        /// Its id, for [`Studio::slide`](crate::Studio::slide), such as "nose-width".
        id: String,
        /// How far it goes to either side, in mm.
        range_mm as rangeMm: f64,
    }
}

readable! {
    /// A place on the canvas, in device pixels from its top left.
    #[derive(Copy)]
    pub struct ScreenPoint {
        /// To the right.
        x: f64,
        /// Down.
        y: f64,
    }
}

readable! {
    /// A picture of the canvas: straight (not premultiplied) sRGB RGBA.
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
    /// Takes the pixels out, row by row from the top; empty the second time.
    #[wasm_bindgen(js_name = takePixels)]
    pub fn take_pixels(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.pixels)
    }
}
