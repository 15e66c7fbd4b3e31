use glam::{DVec2, DVec3};
use rosto_mesh::Topology;
use rosto_stage::{Background, Dots, Glide, Light, RenderSettings, Stage};
use rosto_viewport::{MeshInput, Snapshot, Target, Viewport};
use wasm_bindgen::JsCast;
use web_sys::HtmlCanvasElement;

/// Side of the tests' pictures, in px.
pub const SIDE_PX: u32 = 240;

/// A canvas in the document.
pub fn canvas() -> HtmlCanvasElement {
    let document = web_sys::window().unwrap().document().unwrap();
    let canvas: HtmlCanvasElement = document.create_element("canvas").unwrap().unchecked_into();
    document.body().unwrap().append_child(&canvas).unwrap();
    canvas
}

/// A viewport and its stage.
pub struct Screen {
    pub viewport: Viewport,
    pub stage: Stage,
}

impl Screen {
    pub fn resize(&mut self, width_px: u32, height_px: u32) {
        let [width, height] = self.viewport.resize(width_px, height_px);
        self.stage.camera_mut().resize(width, height);
    }

    pub fn show(&mut self, input: &MeshInput<'_>) {
        self.viewport.show(input).unwrap();
        self.stage.request_frame();
    }

    /// Draws after changes; returns whether another frame is needed.
    pub fn draw(&mut self, time_ms: f64) -> bool {
        self.viewport.draw(&mut self.stage, time_ms).unwrap()
    }
}

/// A viewport on a new canvas, with a stage that frames a unit square from the front.
pub async fn screen() -> Screen {
    on(canvas()).await
}

pub async fn on(canvas: HtmlCanvasElement) -> Screen {
    let (gpu, target) = Target::canvas(canvas).await.unwrap();
    let mut screen = Screen { viewport: Viewport::new(gpu, target), stage: Stage::default() };
    screen.resize(SIDE_PX, SIDE_PX);
    screen.stage.frame(&corners());
    screen.stage.camera_mut().set_glide(Glide::Off);
    screen.stage.use_tools(true);
    screen
}

fn corners() -> [DVec3; 4] {
    [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| DVec3::new(x, y, 0.0))
}

/// A grid over (−1, −1) to (1, 1) with the given height; its texture coordinates span the picture.
pub struct Sheet {
    pub topology: Topology,
    pub positions: Vec<DVec3>,
    pub uvs: Vec<DVec2>,
}

impl Sheet {
    pub fn new(cells: u32, height: impl Fn(f64, f64) -> f64) -> Self {
        let side = cells + 1;
        let grid = (0..side * side).map(|i| DVec2::new(f64::from(i % side), f64::from(i / side)) / f64::from(cells));
        let triangles = (0..cells * cells).flat_map(|cell| {
            let at = cell / cells * side + cell % cells;
            [[at, at + 1, at + side + 1], [at, at + side + 1, at + side]]
        });
        let positions = grid.clone().map(|position| {
            let position = position * 2.0 - DVec2::ONE;
            position.extend(height(position.x, position.y))
        });
        Self {
            topology: Topology::new((side * side) as usize, triangles.collect()).unwrap(),
            positions: positions.collect(),
            uvs: grid.map(|position| DVec2::new(position.x, 1.0 - position.y)).collect(),
        }
    }

    pub fn input(&self) -> MeshInput<'_> {
        MeshInput {
            topology: &self.topology,
            positions_m: &self.positions,
            colours_srgb: &[],
            uvs: &self.uvs,
            picture: None,
        }
    }
}

/// A dome that faces the viewer.
pub fn dome() -> Sheet {
    Sheet::new(16, |x, y| 0.9 * (1.0 - 0.5 * (x * x + y * y)))
}

/// Draws with these settings and reads the picture back.
pub async fn picture(screen: &mut Screen, settings: RenderSettings) -> Snapshot {
    *screen.stage.render_settings_mut() = settings;
    screen.viewport.snapshot(&screen.stage, [SIDE_PX, SIDE_PX], settings.background).unwrap().await.unwrap()
}

/// Settings for an unshaded mesh without anything else.
pub fn plain() -> RenderSettings {
    RenderSettings {
        background: Background::Transparent,
        light: Light::FLAT,
        dots: Dots::None,
        ..RenderSettings::default()
    }
}

/// Largest difference in any channel of any pixel.
pub fn largest_difference(one: &Snapshot, other: &Snapshot) -> u8 {
    one.rgba.iter().zip(&other.rgba).map(|(one, other)| one.abs_diff(*other)).max().unwrap()
}

pub fn luminance(pixel: [u8; 4]) -> u32 {
    pixel[..3].iter().map(|&channel| u32::from(channel)).sum()
}

/// Asserts that a colour equals another, up to rounding.
#[track_caller]
pub fn assert_close(found: [u8; 4], expected: [u8; 3]) {
    let off = found.iter().zip(expected).map(|(found, expected)| found.abs_diff(expected)).max().unwrap();
    assert!(off <= 1 && found[3] == 255, "found {found:?}, expected {expected:?}");
}
