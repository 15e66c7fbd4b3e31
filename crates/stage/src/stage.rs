use std::f64::consts::TAU;

use glam::{DVec2, DVec3};

use crate::frame::{FrameInputs, FrameUniforms};
use crate::{Axis, Camera, Lens, Mark, MirrorPlane, PicturePlane, Pinhole, Pointer, RenderSettings, Rim, Scene};

/// How long a picture is seen before what is in it rises, and how long that takes.
const HOLD_MS: f64 = 250.0;
const ARRIVAL_MS: f64 = 500.0;
/// How long the picture takes to come or go.
const FADE_MS: f64 = 300.0;
/// How long it then takes to show a side and to come back, and how far it turns, in radians.
const SWING_MS: f64 = 1600.0;
const SWING: f64 = 0.34;
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

/// A mesh's way out of the picture that was taken of it.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Arrival {
    Over,
    Asked,
    Since(f64),
    /// It is there, and turns a little and back.
    Swings(f64),
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

    /// From how far away it is seen ([`Camera::set_lens`]).
    pub fn set_lens(&mut self, lens: Lens) {
        self.camera_mut().set_lens(lens);
    }

    /// The camera that took the picture on the mesh, if it is known: for a mesh that is about to be framed, or that is
    /// seen ([`Camera::set_pinhole`]).
    pub fn set_pinhole(&mut self, pinhole: Option<Pinhole>) {
        self.camera_mut().set_pinhole(pinhole);
    }

    /// The picture that was taken of the mesh, and where it lies; none takes it off the stage.
    pub fn set_picture(&mut self, picture: Option<PicturePlane>) {
        if self.picture != picture {
            self.picture = picture;
            self.changed = true;
            match picture {
                Some(plane) if self.scene == Scene::Picture => self.camera.frame_picture(plane),
                _ => self.show(Scene::Solid, true),
            }
        }
    }

    /// What is on the stage.
    pub fn scene(&self) -> Scene {
        self.scene
    }

    /// Puts the picture on the stage or takes it off: the camera glides there, and the picture comes or goes. What leaves it
    /// stays as it faces the viewer, or, `home`, is seen as at first. Nothing without a picture.
    pub fn show(&mut self, scene: Scene, home: bool) {
        let Some(picture) = self.picture.filter(|_| scene == Scene::Picture) else {
            self.scene = Scene::Solid;
            return self.camera_mut().leave_picture(home);
        };
        self.scene = scene;
        self.camera_mut().frame_picture(picture);
    }

    /// How much of the picture is seen, 0..1.
    pub fn picture_share(&self) -> f64 {
        self.picture_share
    }

    /// The place in the picture, in its px, that is seen at a place on the canvas; none beside it.
    pub fn picture_px(&self, place_px: DVec2) -> Option<DVec2> {
        let picture = self.picture?;
        let place = picture.px_under(&self.camera.ray(place_px))?;
        (place.cmpge(DVec2::ZERO).all() && place.cmple(picture.size_px).all()).then_some(place)
    }

    /// Where a place in the picture is seen, in px of the canvas.
    pub fn place_of(&self, picture_px: DVec2) -> Option<DVec2> {
        self.camera.project(self.picture?.at(picture_px))
    }

    /// Is where it is going at once: the picture is there, or gone.
    pub fn settle_picture(&mut self) {
        self.picture_share = f64::from(u8::from(self.scene == Scene::Picture));
        self.changed = true;
    }

    /// So many px at the picture's top, right, bottom and left have something lying over them ([`Camera::set_covered`]). A mesh
    /// that is just arriving does so in what is left; any other glides there.
    pub fn set_covered(&mut self, covered_px: [f64; 4]) {
        let is_arriving = self.is_arriving();
        let camera = self.camera_mut();
        camera.set_covered(covered_px);
        if is_arriving {
            camera.settle_clear();
        }
    }

    /// Without what tells of tools: no marks, gizmo, plane, rim or glow, and what is framed in the middle.
    pub fn without_tools(&self) -> Self {
        let mut bare = self.clone();
        bare.marks.clear();
        (bare.pointer_px, bare.hovered, bare.gizmo, bare.gizmo_axis) = (None, None, None, None);
        (bare.settings.mirror_plane, bare.settings.rim, bare.settings.glow) = (MirrorPlane::Hidden, Rim::Hidden, 0.0);
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

    /// Shows the picture from the next frame on, and lets the mesh rise out of it in half a second; then it turns a little and
    /// back. Nothing without a picture.
    pub fn start_arrival(&mut self) {
        if self.picture.is_some() {
            self.set(|stage| &mut stage.arrival, Arrival::Asked);
            self.picture_share = 1.0;
        }
    }

    /// Lets a mesh that has arrived stand still, as somebody takes it in hand: what it is turned by it glides back.
    pub fn end_swing(&mut self) {
        if let Arrival::Swings(_) = self.arrival {
            self.arrival = Arrival::Over;
            self.camera_mut().end_sway();
        }
    }

    /// Says that something looks different now of which the stage knows nothing: another mesh, a canvas that was lost.
    pub fn ask_for_a_frame(&mut self) {
        self.changed = true;
    }

    /// Moves everything that moves by itself on to `time_ms`, which is any steady clock's.
    pub fn advance(&mut self, time_ms: f64) -> Step {
        let seconds = self.last_ms.map_or(0.0, |last_ms| ((time_ms - last_ms) * 1e-3).clamp(0.0, LONGEST_STEP_S));
        let was_moving = self.arrival != Arrival::Over;
        self.advance_arrival(time_ms);
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

    /// What shaders read for this frame.
    pub fn uniforms(&self) -> FrameUniforms {
        self.uniforms_at(self.settings.before)
    }

    /// The same for the part of it that shows the shape before ([`RenderSettings::wipe`]).
    pub fn uniforms_before(&self) -> FrameUniforms {
        self.uniforms_at(1.0)
    }

    fn uniforms_at(&self, before: f64) -> FrameUniforms {
        let inputs = FrameInputs {
            pixel_ratio: self.pixel_ratio,
            offsets_m: self.offsets_m,
            before,
            ground_m: self.ground_m,
            pointer_px: self.pointer_px,
            hovered: self.hovered,
            gizmo: self.gizmo,
            gizmo_axis: self.gizmo_axis,
            picture: self.picture,
            picture_share: self.picture_share,
        };
        FrameUniforms::new(&self.camera, &self.settings, &inputs)
    }

    /// What the GPU reads for each mark: vertex and kind; kinds 4 to 6 are the letters of the axes.
    pub fn mark_words(&self) -> Vec<[u32; 2]> {
        crate::markers::mark_words(&self.marks, self.hovered, self.gizmo)
    }

    fn advance_arrival(&mut self, time_ms: f64) {
        self.arrival = match self.arrival {
            Arrival::Asked => Arrival::Since(time_ms),
            Arrival::Since(start_ms) if time_ms - start_ms >= HOLD_MS + ARRIVAL_MS => Arrival::Swings(time_ms),
            Arrival::Swings(start_ms) => {
                let share = ((time_ms - start_ms) / SWING_MS).clamp(0.0, 1.0);
                self.camera.sway(if share < 1.0 { SWING * (0.5 - 0.5 * (TAU * share).cos()) } else { 0.0 });
                if share < 1.0 { self.arrival } else { Arrival::Over }
            }
            other => other,
        };
    }

    fn is_arriving(&self) -> bool {
        matches!(self.arrival, Arrival::Asked | Arrival::Since(_))
    }

    /// How far it has risen out of the picture.
    fn risen(&self, time_ms: f64) -> f64 {
        match self.arrival {
            Arrival::Since(start_ms) => {
                let share = ((time_ms - start_ms - HOLD_MS) / ARRIVAL_MS).clamp(0.0, 1.0);
                share * share * (3.0 - 2.0 * share)
            }
            Arrival::Asked => 0.0,
            Arrival::Over | Arrival::Swings(_) => 1.0,
        }
    }

    fn lift(&mut self, time_ms: f64) {
        if let (true, Some(picture)) = (self.is_arriving(), self.picture) {
            let risen = self.risen(time_ms);
            self.camera.lift(picture, risen);
            self.picture_share = 1.0 - risen;
        }
    }

    /// The picture comes or goes, and is drawn while it does.
    fn advance_picture(&mut self, seconds: f64) -> bool {
        let goal = f64::from(u8::from(self.scene == Scene::Picture));
        if self.is_arriving() || self.picture_share == goal {
            return false;
        }
        let step = if self.camera.glides() { 1e3 * seconds / FADE_MS } else { 1.0 };
        self.picture_share += (goal - self.picture_share).clamp(-step, step);
        true
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
mod tests {
    use super::*;
    use crate::{Glide, MarkKind, NamedView, PicturePlane, Pinhole, Scene};

    fn settled() -> Stage {
        let mut stage = Stage::default();
        assert!(stage.advance(0.0).draw);
        stage
    }

    #[test]
    fn nothing_is_drawn_unless_something_changed() {
        let mut stage = settled();
        assert_eq!(stage.advance(16.0), Step { draw: false, again: false });
        stage.set_hovered(None);
        stage.set_offsets_m([DVec3::ZERO; 2]);
        assert!(!stage.advance(32.0).draw);
        stage.set_hovered(Some(4));
        assert_eq!(stage.advance(48.0), Step { draw: true, again: false });
        stage.set_marks(vec![Mark { vertex: 4, kind: MarkKind::Ring }]);
        assert!(stage.advance(64.0).draw);
        assert!(!stage.advance(80.0).draw);
    }

    #[test]
    fn a_glide_asks_for_frames_until_it_rests() {
        let mut stage = settled();
        stage.camera_mut().look(NamedView::Left);
        let frames = (1..500).take_while(|&frame| stage.advance(f64::from(frame) * 16.0).again).count();
        assert!((10..200).contains(&frames), "{frames}");
        assert!(stage.camera().back().distance(DVec3::X) < 1e-9);
    }

    #[test]
    fn without_glide_the_camera_is_there_in_the_first_frame() {
        let mut stage = settled();
        stage.camera_mut().set_glide(Glide::Off);
        stage.camera_mut().look(NamedView::Left);
        assert!(stage.advance(5.0).draw);
        assert!(stage.camera().back().distance(DVec3::X) < 1e-9);
        assert!(!stage.advance(21.0).again);
    }

    /// A stage with a picture 200 px wide of what reaches from −1 to 1, taken from 10 m away.
    fn with_picture() -> Stage {
        let mut stage = settled();
        stage.camera_mut().resize(600, 400);
        let camera_from_model = glam::DAffine3::from_translation(DVec3::new(0.0, 0.0, -10.0));
        stage.set_pinhole(Some(Pinhole { camera_from_model }));
        stage.frame(&[DVec3::NEG_ONE, DVec3::ONE]);
        stage.set_picture(Some(PicturePlane {
            origin_m: DVec3::new(-2.0, 2.0, 0.0),
            right_m: DVec3::new(0.02, 0.0, 0.0),
            down_m: DVec3::new(0.0, -0.02, 0.0),
            size_px: DVec2::new(200.0, 200.0),
        }));
        stage
    }

    fn run(stage: &mut Stage, frames: std::ops::Range<u32>) -> Vec<Step> {
        frames.map(|frame| stage.advance(1000.0 + f64::from(frame) * 16.0)).collect()
    }

    #[test]
    fn a_mesh_rises_out_of_its_picture_in_half_a_second_and_once() {
        let mut stage = with_picture();
        stage.start_arrival();
        run(&mut stage, 0..15);
        assert_eq!(stage.picture_share(), 1.0, "the picture is seen first");
        run(&mut stage, 15..32);
        assert!((0.2..0.8).contains(&stage.picture_share()), "{}", stage.picture_share());
        run(&mut stage, 32..50);
        assert_eq!(stage.picture_share(), 0.0);
    }

    #[test]
    fn the_picture_fills_the_stage_and_lies_where_its_pinhole_saw_it() {
        let mut stage = with_picture();
        stage.show(Scene::Picture, true);
        run(&mut stage, 0..200);
        assert_eq!((stage.scene(), stage.picture_share()), (Scene::Picture, 1.0));
        let corner = |x: f64, y: f64| stage.camera().project(DVec3::new(x, y, 0.0)).unwrap();
        assert!(corner(-2.0, 2.0).distance(DVec2::new(100.0, 0.0)) < 1e-2, "{}", corner(-2.0, 2.0));
        assert!(corner(2.0, -2.0).distance(DVec2::new(500.0, 400.0)) < 1e-2, "{}", corner(2.0, -2.0));
    }

    #[test]
    fn the_picture_fits_into_what_is_clear_whatever_size_that_has() {
        let mut stage = with_picture();
        stage.show(Scene::Picture, true);
        stage.camera_mut().resize(300, 500);
        stage.set_covered([0.0, 0.0, 100.0, 0.0]);
        run(&mut stage, 0..200);
        let corner = stage.camera().project(DVec3::new(-2.0, 2.0, 0.0)).unwrap();
        assert!(corner.distance(DVec2::new(0.0, 50.0)) < 1e-2, "{corner}");
    }

    #[test]
    fn what_is_small_in_its_picture_fills_half_the_room_and_the_picture_the_rest() {
        let mut stage = with_picture();
        let large = PicturePlane {
            origin_m: DVec3::new(-3.0, 19.0, 0.0),
            right_m: DVec3::new(0.1, 0.0, 0.0),
            down_m: DVec3::new(0.0, -0.1, 0.0),
            size_px: DVec2::splat(200.0),
        };
        stage.set_picture(Some(large));
        stage.show(Scene::Picture, true);
        run(&mut stage, 0..300);
        let at = |x: f64, y: f64| stage.camera().project(DVec3::new(x, y, 0.0)).unwrap();
        let height_px = at(0.0, -1.0).y - at(0.0, 1.0).y;
        assert!((80.0..140.0).contains(&height_px), "{height_px} of 400 px");
        let corners = (large.at(DVec2::ZERO), large.at(large.size_px));
        let (low, high) = (at(corners.0.x, corners.0.y), at(corners.1.x, corners.1.y));
        assert!(low.x <= 0.1 && low.y <= 0.1 && high.x >= 599.9 && high.y >= 399.9, "{low} to {high}");
    }

    #[test]
    fn who_turns_out_of_the_picture_sees_the_mesh_from_there() {
        let mut stage = with_picture();
        stage.show(Scene::Picture, true);
        run(&mut stage, 0..200);
        stage.show(Scene::Solid, false);
        stage.camera_mut().orbit(100.0, 0.0);
        let steps = run(&mut stage, 200..400);
        assert!(steps[0].draw && !steps[199].again);
        assert_eq!(stage.picture_share(), 0.0);
        let facing = stage.camera().back();
        assert!(facing.x < -0.5, "{facing}");
        stage.show(Scene::Picture, true);
        stage.set_picture(None);
        assert_eq!(stage.scene(), Scene::Solid, "without a picture there is none to show");
    }

    #[test]
    fn a_face_that_has_arrived_turns_a_little_and_back_unless_it_is_taken_in_hand() {
        let arrive = |frames: std::ops::Range<u32>, stage: &mut Stage| {
            frames.map(|frame| (stage.advance(1000.0 + f64::from(frame) * 16.0).again, stage.camera().back().x)).last()
        };
        let mut left_alone = with_picture();
        left_alone.start_arrival();
        let (_, turned) = arrive(0..96, &mut left_alone).unwrap();
        assert!(turned.abs() > 0.2, "{turned}");
        let (again, turned) = arrive(96..170, &mut left_alone).unwrap();
        assert!(!again && turned.abs() < 1e-9, "{turned}");
        let mut taken = with_picture();
        taken.start_arrival();
        arrive(0..96, &mut taken);
        taken.end_swing();
        let (again, turned) = arrive(96..128, &mut taken).unwrap();
        assert!(turned.abs() < 1e-2 && again, "it glides back at once: {turned}");
    }

    #[test]
    fn who_is_sent_somewhere_while_it_turns_by_itself_gets_there() {
        let mut stage = with_picture();
        stage.start_arrival();
        for frame in 0..96 {
            stage.advance(1000.0 + f64::from(frame) * 16.0);
        }
        stage.camera_mut().look(NamedView::Left);
        stage.end_swing();
        while stage.advance(stage.last_ms.unwrap_or_default() + 16.0).again {}
        assert!(stage.camera().back().distance(DVec3::X) < 1e-9, "{}", stage.camera().back());
    }

    #[test]
    fn what_has_grown_is_seen_whole_and_what_has_shrunk_as_before() {
        let mut stage = settled();
        let square = |side: f64| [DVec3::splat(-side), DVec3::splat(side)];
        stage.frame(&square(1.0));
        let usual_m = stage.camera().radius_m();
        stage.frame_again(&square(1.3));
        assert!((stage.camera().radius_m() / usual_m - 1.3).abs() < 1e-12);
        for side in [1.0, 0.5] {
            stage.frame_again(&square(side));
            assert!((stage.camera().radius_m() / usual_m - 1.0).abs() < 1e-12);
        }
        stage.frame_again(&[DVec3::NAN]);
        assert!(stage.camera().radius_m().is_finite());
    }

    #[test]
    fn a_picture_without_tools_shows_none() {
        let mut stage = settled();
        stage.set_marks(vec![Mark { vertex: 4, kind: MarkKind::Ring }]);
        stage.set_gizmo(Some(4));
        stage.set_hovered(Some(5));
        let settings = stage.render_settings_mut();
        (settings.mirror_plane, settings.rim, settings.glow, settings.wipe) =
            (MirrorPlane::Shown, Rim::Shown, 0.5, Some(0.5));
        let bare = stage.without_tools();
        assert_eq!((bare.mark_words(), bare.gizmo()), (Vec::new(), None));
        let RenderSettings { mirror_plane, rim, glow, wipe, .. } = *bare.render_settings();
        assert_eq!((mirror_plane, rim, glow, wipe), (MirrorPlane::Hidden, Rim::Hidden, 0.0, None));
    }

    #[test]
    fn the_gizmo_is_picked_where_its_vertex_is_and_only_while_there_is_one() {
        let mut stage = settled();
        let positions_m = [DVec3::splat(-1.0), DVec3::ZERO];
        stage.frame(&[DVec3::NEG_ONE, DVec3::ONE]);
        stage.camera_mut().resize(600, 600);
        let right_of_middle = DVec2::new(340.0, 302.0);
        let pick = |stage: &Stage| stage.pick_axis(right_of_middle, &positions_m, Pointer::Fine);
        assert_eq!(pick(&stage), None, "no gizmo yet");
        stage.set_gizmo(Some(1));
        assert_eq!(pick(&stage), Some(Axis::X));
        stage.set_gizmo(Some(2));
        assert_eq!(pick(&stage), None, "a vertex that this mesh does not have");
    }

    #[test]
    fn the_turntable_turns_at_its_speed_even_after_a_pause() {
        let mut stage = settled();
        stage.set_turntable(90.0);
        for frame in 0..=100 {
            assert!(stage.advance(f64::from(frame) * 10.0).again);
        }
        assert!(stage.camera().back().distance(DVec3::NEG_X) < 1e-9, "{}", stage.camera().back());
        stage.set_turntable(0.0);
        stage.advance(1010.0);
        assert!(!stage.advance(90_000.0).again);
    }
}
