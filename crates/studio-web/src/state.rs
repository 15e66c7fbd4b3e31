//! What the page shows, as values it can read.

use rosto_studio::{Amount, Command, Entry, Subject, Switch};
use wasm_bindgen::prelude::*;

/// Everything the panel shows about the document and the edit in progress.
#[wasm_bindgen(getter_with_clone, inspectable)]
#[derive(Debug, Clone, Default, PartialEq)]
pub struct StudioState {
    /// Whether a face is open.
    #[wasm_bindgen(readonly, js_name = hasFace)]
    pub has_face: bool,
    /// Number of vertices shown.
    #[wasm_bindgen(readonly, js_name = vertexCount)]
    pub vertex_count: u32,
    /// Number of edges shown.
    #[wasm_bindgen(readonly, js_name = edgeCount)]
    pub edge_count: u32,
    /// Number of triangles shown.
    #[wasm_bindgen(readonly, js_name = triangleCount)]
    pub triangle_count: u32,
    /// The selected vertex, if any; of a selected region, the landmark in its middle.
    #[wasm_bindgen(readonly)]
    pub selected: Option<u32>,
    /// The selected region, if any.
    #[wasm_bindgen(readonly, js_name = selectedRegion)]
    pub selected_region: Option<String>,
    /// Whether the other side of the face can follow what is selected.
    #[wasm_bindgen(readonly, js_name = canMirror)]
    pub can_mirror: bool,
    /// Number of neighbours of the selected vertex.
    #[wasm_bindgen(readonly, js_name = selectedDegree)]
    pub selected_degree: u32,
    /// Whether what is selected is its own mirror image and the mirror is on, so that it cannot move along x.
    #[wasm_bindgen(readonly, js_name = selectedInPlane)]
    pub selected_in_plane: bool,
    /// Offset of the edit in progress along x, in mm.
    #[wasm_bindgen(readonly, js_name = offsetXMm)]
    pub offset_x_mm: f64,
    /// Offset of the edit in progress along y, in mm.
    #[wasm_bindgen(readonly, js_name = offsetYMm)]
    pub offset_y_mm: f64,
    /// Offset of the edit in progress along z, in mm.
    #[wasm_bindgen(readonly, js_name = offsetZMm)]
    pub offset_z_mm: f64,
    /// Sum of the offsets along x that the history holds for what is selected, as far as they are in force, in mm.
    #[wasm_bindgen(readonly, js_name = keptXMm)]
    pub kept_x_mm: f64,
    /// The same along y.
    #[wasm_bindgen(readonly, js_name = keptYMm)]
    pub kept_y_mm: f64,
    /// The same along z.
    #[wasm_bindgen(readonly, js_name = keptZMm)]
    pub kept_z_mm: f64,
    /// Where each ready-made slider stands, in mm: the sum of its entries that are in force, and the edit in progress.
    #[wasm_bindgen(readonly, js_name = slidersMm)]
    pub sliders_mm: Vec<f64>,
    /// Share of its offset that the selected landmark reaches, 0..1.
    #[wasm_bindgen(readonly)]
    pub reach: f64,
    /// Whether an edit is in progress that `commit` would keep.
    #[wasm_bindgen(readonly)]
    pub editing: bool,
    /// Whether the history holds edits in force of what is selected.
    #[wasm_bindgen(readonly, js_name = canResetSelection)]
    pub can_reset_selection: bool,
    /// Whether there is something to undo.
    #[wasm_bindgen(readonly, js_name = canUndo)]
    pub can_undo: bool,
    /// Whether there is something to redo.
    #[wasm_bindgen(readonly, js_name = canRedo)]
    pub can_redo: bool,
    /// The history, oldest first, without what was undone.
    #[wasm_bindgen(readonly)]
    pub entries: Vec<StudioEntry>,
}

/// One entry of the history.
#[wasm_bindgen(getter_with_clone, inspectable)]
#[derive(Debug, Clone, PartialEq)]
pub struct StudioEntry {
    /// Place in the history, from 0.
    #[wasm_bindgen(readonly)]
    pub index: u32,
    /// What the file calls it, such as "nose tip".
    #[wasm_bindgen(readonly)]
    pub label: String,
    /// How far it moves what it moves, or how much it does.
    #[wasm_bindgen(readonly)]
    pub amount: f64,
    /// What `amount` counts: "mm" or "%".
    #[wasm_bindgen(readonly)]
    pub unit: String,
    /// Whether it takes part in the shape.
    #[wasm_bindgen(readonly)]
    pub enabled: bool,
    /// How often the mesh must be subdivided before it takes part, if that is more often than the one that is shown.
    #[wasm_bindgen(readonly, js_name = waitsForDensity)]
    pub waits_for_density: Option<u32>,
    pub(crate) subject: Subject,
}

impl StudioEntry {
    /// `density` is that of the mesh that is shown.
    pub(crate) fn new(index: usize, entry: &Entry, density: u32) -> Self {
        let level = match &entry.command {
            Command::Move { grip, .. } => grip.level,
            Command::Symmetrise { .. } => 0,
        };
        let (amount, unit) = match entry.command.amount() {
            Amount::Distance(distance_m) => (distance_m * 1000.0, "mm"),
            Amount::Share(share) => (share * 100.0, "%"),
        };
        Self {
            index: index as u32,
            label: entry.label.clone(),
            amount,
            unit: unit.to_owned(),
            enabled: entry.switch == Switch::On,
            waits_for_density: (level > density).then_some(level),
            subject: entry.command.subject(),
        }
    }
}

/// A ready-made slider.
#[wasm_bindgen(getter_with_clone, inspectable)]
#[derive(Debug, Clone, PartialEq)]
pub struct NamedSlider {
    /// Its name in files and for [`Studio::slide`](crate::Studio::slide), such as "nose-width".
    #[wasm_bindgen(readonly)]
    pub id: String,
    /// Its name for people.
    #[wasm_bindgen(readonly)]
    pub label: String,
    /// How far it goes to either side, in mm.
    #[wasm_bindgen(readonly, js_name = rangeMm)]
    pub range_mm: f64,
}

/// A part of the face that can be moved as one.
#[wasm_bindgen(getter_with_clone, inspectable)]
#[derive(Debug, Clone, PartialEq)]
pub struct NamedRegion {
    /// Its name for [`Studio::select_region`](crate::Studio::select_region), such as "left-brow".
    #[wasm_bindgen(readonly)]
    pub id: String,
    /// Its name for people.
    #[wasm_bindgen(readonly)]
    pub label: String,
}

/// A place on the canvas, in device pixels from its top left.
#[wasm_bindgen(inspectable)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ScreenPoint {
    /// To the right.
    #[wasm_bindgen(readonly)]
    pub x: f64,
    /// Down.
    #[wasm_bindgen(readonly)]
    pub y: f64,
}

/// A picture of the canvas: straight (not premultiplied) sRGB RGBA.
#[wasm_bindgen(inspectable)]
#[derive(Debug, Clone, PartialEq)]
pub struct Snapshot {
    /// Width in pixels.
    #[wasm_bindgen(readonly)]
    pub width: u32,
    /// Height in pixels.
    #[wasm_bindgen(readonly)]
    pub height: u32,
    pixels: Vec<u8>,
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
