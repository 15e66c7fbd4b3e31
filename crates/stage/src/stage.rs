mod arrival;
mod frame;
mod picture;

use glam::{DVec2, DVec3};

use crate::{Axis, Camera, Mark, PicturePlane, Pointer, RenderSettings, Scene, Visibility};

use arrival::Arrival;
pub use frame::FrameUniforms;

/// What is framed has this much room around it.
const ROOM: f64 = 1.12;
/// The longest step that the camera makes in one frame, so that a page that slept does not jump.
const LONGEST_STEP_S: f64 = 0.1;

/// What is shown and how, apart from the GPU: it outlives a lost device.
#[derive(Debug, Clone)]
pub struct Stage {
    camera: Camera,
    settings: RenderSettings,
    marks: Vec<Mark>,
    offsets_m: [DVec3; 2],
    ground_m: DVec3,
    /// How far the mesh that was framed reaches from its middle.
    framed_m: f64,
    pixel_ratio: f64,
    pointer_px: Option<DVec2>,
    hovered: Option<u32>,
    gizmo: Option<u32>,
    gizmo_axis: Option<Axis>,
    turntable_deg_per_s: f64,
    picture: Option<PicturePlane>,
    scene: Scene,
    /// How much of the picture is seen, 0..1.
    picture_share: f64,
    arrival: Arrival,
    last_ms: Option<f64>,
    changed: bool,
}

/// What [`Stage::advance`] found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Step {
    /// Something looks different now.
    pub draw: bool,
    /// Something will look different in the next frame too.
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
            framed_m: 0.0,
            pixel_ratio: 1.0,
            pointer_px: None,
            hovered: None,
            gizmo: None,
            gizmo_axis: None,
            turntable_deg_per_s: 0.0,
            picture: None,
            scene: Scene::default(),
            picture_share: 0.0,
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

    /// The camera, to be steered; asks for a frame.
    pub fn camera_mut(&mut self) -> &mut Camera {
        self.changed = true;
        &mut self.camera
    }

    /// How the mesh is shown.
    pub fn render_settings(&self) -> &RenderSettings {
        &self.settings
    }

    /// How the mesh is shown, to be changed; asks for a frame.
    pub fn render_settings_mut(&mut self) -> &mut RenderSettings {
        self.changed = true;
        &mut self.settings
    }

    /// Frames a mesh from the front, and puts the ground under it.
    pub fn frame(&mut self, positions_m: &[DVec3]) {
        let mut corners = positions_m.iter().copied().filter(|position| position.is_finite());
        let Some(first) = corners.next() else { return };
        let (low, high) = corners.fold((first, first), |(low, high), next| (low.min(next), high.max(next)));
        let centre_m = 0.5 * (low + high);
        let reach_m = reach_m(positions_m, centre_m);
        self.camera_mut().frame(centre_m, ROOM * reach_m);
        self.framed_m = reach_m;
        self.ground_m = DVec3::new(centre_m.x, low.y - 0.10 * reach_m, 0.7 * low.z + 0.3 * high.z);
    }

    /// Goes back until a mesh that has grown out of what was framed is seen whole, or comes again when it has shrunk.
    pub fn frame_again(&mut self, positions_m: &[DVec3]) {
        let radius_m = ROOM * reach_m(positions_m, self.camera.centre_m()).max(self.framed_m);
        if (radius_m / self.camera.radius_m() - 1.0).abs() > 1e-3 {
            self.camera_mut().frame_again(radius_m);
        }
    }

    /// So many px at the picture's top, right, bottom and left have something lying over them ([`Camera::set_viewport_insets`]). A mesh
    /// that is just arriving does so in what is left; any other glides there.
    pub fn set_viewport_insets(&mut self, insets_px: [f64; 4]) {
        let is_arriving = self.is_arriving();
        let camera = self.camera_mut();
        camera.set_viewport_insets(insets_px);
        if is_arriving {
            camera.settle_clear();
        }
    }

    /// Without what tells of tools: no marks, gizmo, plane, rim or glow, and what is framed in the middle.
    pub fn without_tools(&self) -> Self {
        let mut bare = self.clone();
        bare.marks.clear();
        (bare.pointer_px, bare.hovered, bare.gizmo, bare.gizmo_axis) = (None, None, None, None);
        (bare.settings.mirror_plane, bare.settings.rim, bare.settings.glow) =
            (Visibility::Hidden, Visibility::Hidden, 0.0);
        bare.settings.wipe = None;
        bare.camera.centre();
        bare
    }

    /// Offsets in metres of the two handles whose response fields the mesh follows.
    pub fn set_offsets_m(&mut self, offsets_m: [DVec3; 2]) {
        self.set(|stage| &mut stage.offsets_m, offsets_m);
    }

    /// Device pixels for each CSS pixel, which marks are measured in.
    pub fn set_pixel_ratio(&mut self, pixel_ratio: f64) {
        self.set(|stage| &mut stage.pixel_ratio, pixel_ratio);
    }

    /// Device pixels for each CSS pixel.
    pub fn pixel_ratio(&self) -> f64 {
        self.pixel_ratio
    }

    /// Where the pointer is in px, for dots near it.
    pub fn set_pointer(&mut self, pointer_px: Option<DVec2>) {
        self.set(|stage| &mut stage.pointer_px, pointer_px);
    }

    /// The vertex under the pointer.
    pub fn set_hovered(&mut self, vertex: Option<u32>) {
        self.set(|stage| &mut stage.hovered, vertex);
    }

    /// Marks on vertices.
    pub fn set_marks(&mut self, marks: Vec<Mark>) {
        self.set(|stage| &mut stage.marks, marks);
    }

    /// The vertex with arms along the axes.
    pub fn set_gizmo(&mut self, vertex: Option<u32>) {
        self.set(|stage| &mut stage.gizmo, vertex);
    }

    /// The arm that is pointed at or dragged.
    pub fn set_gizmo_axis(&mut self, axis: Option<Axis>) {
        self.set(|stage| &mut stage.gizmo_axis, axis);
    }

    /// The vertex with arms along the axes.
    pub fn gizmo(&self) -> Option<u32> {
        self.gizmo
    }

    /// The arm of the gizmo that the pointer is on; `positions_m` are where the vertices are now. None without a gizmo, or
    /// if its vertex is not among them.
    pub fn pick_axis(&self, place_px: DVec2, positions_m: &[DVec3], pointer: Pointer) -> Option<Axis> {
        let vertex_m = *positions_m.get(self.gizmo? as usize)?;
        crate::markers::axis_under(&self.camera, vertex_m, place_px, self.pixel_ratio, pointer)
    }

    /// Turns the mesh, in degrees a second; 0 stops.
    pub fn set_turntable(&mut self, degrees_per_second: f64) {
        self.set(|stage| &mut stage.turntable_deg_per_s, degrees_per_second);
    }

    /// Says that something looks different now of which the stage knows nothing: another mesh, a canvas that was lost.
    pub fn ask_for_a_frame(&mut self) {
        self.changed = true;
    }

    /// Moves everything that moves by itself on to `time_ms`, which is any steady clock's.
    pub fn advance(&mut self, time_ms: f64) -> Step {
        let seconds = self.last_ms.map_or(0.0, |last_ms| ((time_ms - last_ms) * 1e-3).clamp(0.0, LONGEST_STEP_S));
        let was_moving = self.arrival != Arrival::Over;
        self.advance_arrival(time_ms, seconds);
        let fading = self.advance_picture(seconds);
        let turning = self.turntable_deg_per_s != 0.0;
        self.camera.turn(-self.turntable_deg_per_s.to_radians() * seconds);
        let gliding = self.camera.advance(if self.last_ms.is_some() { seconds } else { 0.0 });
        self.lift(time_ms);
        let again = turning || gliding || fading || self.arrival != Arrival::Over;
        self.last_ms = again.then_some(time_ms);
        let draw = std::mem::take(&mut self.changed) || again || was_moving;
        Step { draw, again }
    }

    /// What the GPU reads for each mark: vertex and kind; kinds 4 to 6 are the letters of the axes.
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

/// The furthest of these from a place, as far as they are anywhere.
fn reach_m(positions_m: &[DVec3], from_m: DVec3) -> f64 {
    positions_m.iter().map(|position| position.distance(from_m)).filter(|away| away.is_finite()).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests;
