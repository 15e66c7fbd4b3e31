mod arrival;
mod frame;
mod picture;
mod tools;

use glam::{DVec2, DVec3};

use crate::{Axis, Camera, Mark, PicturePlane, Pointer, RenderSettings, Scene, Visibility};

use arrival::Arrival;
pub use frame::FrameUniforms;
use tools::Tools;

/// Margin factor around the framed sphere.
const MARGIN: f64 = 1.12;
/// Longest time step of the motion, so that a page that was suspended does not jump.
const MAX_STEP_S: f64 = 0.1;

/// State of the view, independent of the GPU, so that it survives a lost device.
#[derive(Debug, Clone)]
pub struct Stage {
    camera: Camera,
    settings: RenderSettings,
    marks: Vec<Mark>,
    offsets_m: [DVec3; 2],
    ground_m: DVec3,
    pixel_ratio: f64,
    pointer_px: Option<DVec2>,
    hovered: Option<u32>,
    gizmo: Option<u32>,
    gizmo_axis: Option<Axis>,
    turntable_deg_per_s: f64,
    picture: Option<PicturePlane>,
    scene: Scene,
    backdrop: Visibility,
    /// Share of the picture over the mesh, 0..1.
    picture_share: f64,
    tools: Tools,
    arrival: Arrival,
    last_ms: Option<f64>,
    changed: bool,
}

/// Result of [`Stage::advance`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Step {
    /// The frame must be drawn.
    pub draw: bool,
    /// The next frame will differ, too.
    pub again: bool,
}

impl Default for Stage {
    fn default() -> Self {
        Self {
            camera: Camera::default(),
            settings: RenderSettings::default(),
            marks: Vec::new(),
            offsets_m: [DVec3::ZERO; 2],
            ground_m: DVec3::ZERO,
            pixel_ratio: 1.0,
            pointer_px: None,
            hovered: None,
            gizmo: None,
            gizmo_axis: None,
            turntable_deg_per_s: 0.0,
            picture: None,
            scene: Scene::default(),
            backdrop: Visibility::default(),
            picture_share: 0.0,
            tools: Tools::default(),
            arrival: Arrival::Over,
            last_ms: None,
            changed: true,
        }
    }
}

impl Stage {
    /// The camera.
    pub fn camera(&self) -> &Camera {
        &self.camera
    }

    /// The camera, for changes; requests a frame.
    pub fn camera_mut(&mut self) -> &mut Camera {
        self.changed = true;
        &mut self.camera
    }

    /// The render settings.
    pub fn render_settings(&self) -> &RenderSettings {
        &self.settings
    }

    /// The render settings, for changes; requests a frame.
    pub fn render_settings_mut(&mut self) -> &mut RenderSettings {
        self.changed = true;
        &mut self.settings
    }

    /// Frames a mesh from the front and places the ground below it.
    pub fn frame(&mut self, positions_m: &[DVec3]) {
        let mut corners = positions_m.iter().copied().filter(|position| position.is_finite());
        let Some(first) = corners.next() else { return };
        let (low, high) = corners.fold((first, first), |(low, high), next| (low.min(next), high.max(next)));
        let centre_m = 0.5 * (low + high);
        let extent_m = extent_m(positions_m, centre_m);
        self.camera_mut().frame(centre_m, MARGIN * extent_m);
        self.ground_m = DVec3::new(centre_m.x, low.y - 0.10 * extent_m, 0.7 * low.z + 0.3 * high.z);
    }

    /// Sets the viewport insets ([`Camera::set_viewport_insets`]); without a glide while a mesh is arriving.
    pub fn set_viewport_insets(&mut self, insets_px: [f64; 4]) {
        let is_arriving = self.is_arriving();
        let camera = self.camera_mut();
        camera.set_viewport_insets(insets_px);
        if is_arriving {
            camera.settle_visible_area();
        }
    }

    /// A copy without marks, gizmo, plane, rim, glow and the picture behind the mesh, centred.
    pub fn without_tools(&self) -> Self {
        let mut bare = self.clone();
        if self.scene == Scene::Solid && self.backdrop == Visibility::Shown {
            bare.backdrop = Visibility::Hidden;
            bare.camera.leave_picture();
        }
        bare.marks.clear();
        (bare.pointer_px, bare.hovered, bare.gizmo, bare.gizmo_axis) = (None, None, None, None);
        (bare.settings.mirror_plane, bare.settings.rim, bare.settings.glow) =
            (Visibility::Hidden, Visibility::Hidden, 0.0);
        bare.settings.wipe = None;
        bare.camera.centre();
        bare
    }

    /// Sets the offsets in metres of the two handles whose response fields deform the mesh.
    pub fn set_offsets_m(&mut self, offsets_m: [DVec3; 2]) {
        self.set(|stage| &mut stage.offsets_m, offsets_m);
    }

    /// Sets the device-pixel ratio, by which marks are scaled.
    pub fn set_pixel_ratio(&mut self, pixel_ratio: f64) {
        self.set(|stage| &mut stage.pixel_ratio, pixel_ratio);
    }

    /// Device-pixel ratio.
    pub fn pixel_ratio(&self) -> f64 {
        self.pixel_ratio
    }

    /// Sets the pointer's position in px, for the dots near it.
    pub fn set_pointer(&mut self, pointer_px: Option<DVec2>) {
        self.set(|stage| &mut stage.pointer_px, pointer_px);
    }

    /// Sets the vertex under the pointer.
    pub fn set_hovered(&mut self, vertex: Option<u32>) {
        self.set(|stage| &mut stage.hovered, vertex);
    }

    /// Sets the marks on vertices.
    pub fn set_marks(&mut self, marks: Vec<Mark>) {
        self.set(|stage| &mut stage.marks, marks);
    }

    /// Sets the vertex with a gizmo.
    pub fn set_gizmo(&mut self, vertex: Option<u32>) {
        self.set(|stage| &mut stage.gizmo, vertex);
    }

    /// Sets the arm that is hovered or dragged.
    pub fn set_gizmo_axis(&mut self, axis: Option<Axis>) {
        self.set(|stage| &mut stage.gizmo_axis, axis);
    }

    /// The vertex with a gizmo.
    pub fn gizmo(&self) -> Option<u32> {
        self.gizmo
    }

    /// Arm of the gizmo under the pointer; `positions_m` are the current vertex positions. `None` without a
    /// visible gizmo, or if its vertex is out of range.
    pub fn pick_axis(&self, position_px: DVec2, positions_m: &[DVec3], pointer: Pointer) -> Option<Axis> {
        let gizmo = self.gizmo.filter(|_| self.tools_opacity() > 0.0)?;
        let vertex_m = *positions_m.get(gizmo as usize)?;
        crate::markers::axis_under(&self.camera, vertex_m, position_px, self.pixel_ratio, pointer)
    }

    /// Sets the turntable's speed in degrees per second; 0 stops it.
    pub fn set_turntable(&mut self, degrees_per_second: f64) {
        self.set(|stage| &mut stage.turntable_deg_per_s, degrees_per_second);
    }

    /// Requests a frame after a change outside the stage, such as another mesh or a restored canvas.
    pub fn request_frame(&mut self) {
        self.changed = true;
    }

    /// Advances animations to `time_ms`, from any monotonic clock.
    pub fn advance(&mut self, time_ms: f64) -> Step {
        let seconds = self.last_ms.map_or(0.0, |last_ms| ((time_ms - last_ms) * 1e-3).clamp(0.0, MAX_STEP_S));
        let was_moving = self.arrival != Arrival::Over;
        self.advance_arrival(time_ms);
        let (fading_tools, waiting) = self.advance_tools(time_ms);
        let fading = self.advance_picture(seconds);
        let turning = self.turntable_deg_per_s != 0.0;
        self.camera.turn(-self.turntable_deg_per_s.to_radians() * seconds);
        let gliding = self.camera.advance(if self.last_ms.is_some() { seconds } else { 0.0 });
        self.lift(time_ms);
        let moves = turning || gliding || fading || fading_tools || self.arrival != Arrival::Over;
        self.last_ms = moves.then_some(time_ms);
        let draw = std::mem::take(&mut self.changed) || moves || was_moving;
        Step { draw, again: moves || waiting }
    }

    /// Marks as the GPU reads them: vertex and kind; kinds 4 to 6 are the axes' letters.
    pub fn mark_words(&self) -> Vec<[u32; 2]> {
        crate::markers::mark_words(&self.marks, self.hovered, self.gizmo)
    }

    fn set<T: PartialEq>(&mut self, field: impl Fn(&mut Self) -> &mut T, value: T) {
        if *field(self) != value {
            *field(self) = value;
            self.changed = true;
        }
    }
}

/// Distance of the furthest finite position.
fn extent_m(positions_m: &[DVec3], from_m: DVec3) -> f64 {
    positions_m.iter().map(|position| position.distance(from_m)).filter(|away| away.is_finite()).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests;
