//! The scenes, by family. `tests/reference/mediapipe_robustness.py` stores MediaPipe's results for them; rerun it after
//! a change to a rule.

use super::canvas::Ground;
use super::filters::Filter;
use super::{Part, Placement, Scene};
use crate::support::seeded::Seeded;

/// All scenes, in the order of the table.
pub fn all() -> Vec<Scene> {
    [rotations(), sizes(), borders(), tones(), blurs(), noises(), jpegs(), groups(), mixed(), empty()]
        .into_iter()
        .flatten()
        .collect()
}

/// The unchanged portrait, as a base for other scenes.
fn portrait(family: &'static str, name: String) -> Scene {
    Scene {
        family,
        name,
        size_px: [512, 512],
        ground: Ground::Black,
        seed: 1,
        part: Part::Whole,
        faces: vec![Placement::upright([224.0, 124.0], 1.0)],
        filter: Filter::None,
    }
}

/// Rotations by multiples of 15°, for a large and a small face, one of them mirrored.
fn rotations() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for step in 0..24 {
        let degrees = f64::from(step * 15);
        for (size, scale, mirrored) in [("near", 2.0, false), ("far", 1.0, true)] {
            let mut scene = portrait("rotation", format!("turned_{}_{size}", step * 15));
            scene.size_px = [640, 640];
            scene.ground = Ground::Clouds;
            scene.part = Part::Head;
            scene.faces = vec![Placement { at_px: [320.0, 320.0], scale, degrees, mirrored }];
            scenes.push(scene);
        }
    }
    scenes
}

/// Face sizes in 12 megapixels, from 24 to 720 px between the eyes, and the portrait at several sizes.
fn sizes() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for (index, eyes_px) in [24.0, 32.0, 45.0, 64.0, 90.0, 128.0, 180.0, 360.0, 720.0].into_iter().enumerate() {
        for (place, at) in [("middle", [0.5, 0.5]), ("corner", [0.83, 0.19])] {
            let mut scene = portrait("size", format!("12mp_eyes_{eyes_px}_{place}"));
            scene.size_px = [4000, 3000];
            scene.ground = [Ground::Clouds, Ground::Gradient, Ground::Cloth][index % 3];
            scene.part = Part::Head;
            let scale = eyes_px / super::EYE_DISTANCE_PX;
            scene.faces = vec![Placement::upright([4000.0 * at[0], 3000.0 * at[1]], scale)];
            scenes.push(scene);
        }
    }
    for side in [64, 96, 130, 200, 300, 420, 700, 1000, 1500] {
        let mut scene = portrait("size", format!("portrait_{side}"));
        let scale = f64::from(side) / 512.0;
        scene.size_px = [side, side];
        scene.faces = vec![Placement::upright([224.0 * scale, 124.0 * scale], scale)];
        scenes.push(scene);
    }
    scenes
}

/// Faces cut by each border, up to half, and faces in wide margins.
fn borders() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for (border, [x, y]) in [("left", [0.0, 0.5]), ("right", [1.0, 0.5]), ("top", [0.5, 0.0]), ("bottom", [0.5, 1.0])] {
        for cut_percent in [0, 10, 20, 30, 40, 50] {
            let mut scene = portrait("border", format!("cut_{border}_{cut_percent}"));
            scene.size_px = [480, 480];
            scene.ground = Ground::Clouds;
            scene.part = Part::Head;
            // The face measures 94 × 104 px at scale 1, and is drawn at scale 2.
            let inset = |share: f64, extent: f64| {
                let half = extent * (1.0 - 2.0 * f64::from(cut_percent) / 100.0);
                if share == 0.5 { 240.0 } else { 480.0 * share + half * (1.0 - 2.0 * share) }
            };
            scene.faces = vec![Placement::upright([inset(x, 94.0), inset(y, 104.0)], 2.0)];
            scenes.push(scene);
        }
    }
    for (width, height, x, y) in [(1600, 900, 900.0, 300.0), (900, 1600, 300.0, 1200.0), (2400, 500, 400.0, 200.0)] {
        let mut scene = portrait("border", format!("padded_{width}x{height}"));
        scene.size_px = [width, height];
        scene.ground = Ground::Grey;
        scene.faces = vec![Placement::upright([x, y], 1.0)];
        scenes.push(scene);
    }
    scenes
}

fn filtered(family: &'static str, filters: &[(&str, Filter)]) -> Vec<Scene> {
    let mut scenes = Vec::new();
    for &(name, filter) in filters {
        for (size, size_px, scale) in [("near", [420, 420], 2.0), ("far", [512, 512], 1.0)] {
            let mut scene = portrait(family, format!("{name}_{size}"));
            scene.size_px = size_px;
            scene.filter = filter;
            if scale > 1.0 {
                scene.part = Part::Head;
                scene.ground = Ground::Gradient;
                scene.faces = vec![Placement::upright([210.0, 240.0], scale)];
            }
            scenes.push(scene);
        }
    }
    scenes
}

fn tones() -> Vec<Scene> {
    let filters = [
        ("gamma_0.3", Filter::Gamma(0.3)),
        ("gamma_0.5", Filter::Gamma(0.5)),
        ("gamma_2", Filter::Gamma(2.0)),
        ("gamma_3", Filter::Gamma(3.0)),
        ("gamma_4.5", Filter::Gamma(4.5)),
        ("contrast_40", Filter::Contrast(0.4)),
        ("contrast_20", Filter::Contrast(0.2)),
        ("contrast_10", Filter::Contrast(0.1)),
        ("blue", Filter::Tint([0.5, 0.6, 1.0])),
        ("red", Filter::Tint([1.0, 0.35, 0.3])),
        ("grey", Filter::Grey),
        ("side_light_20", Filter::SideLight(0.2)),
        ("side_light_0", Filter::SideLight(0.0)),
    ];
    filtered("tone", &filters)
}

fn blurs() -> Vec<Scene> {
    filtered("blur", &[1, 2, 3, 4, 5, 6, 8].map(|radius| (BLURS[radius as usize], Filter::Blur(radius))))
}

const BLURS: [&str; 9] = ["blur_0", "blur_1", "blur_2", "blur_3", "blur_4", "blur_5", "blur_6", "blur_7", "blur_8"];

fn noises() -> Vec<Scene> {
    let filters = [
        ("noise_10", Filter::Noise(10.0)),
        ("noise_25", Filter::Noise(25.0)),
        ("noise_50", Filter::Noise(50.0)),
        ("noise_80", Filter::Noise(80.0)),
        ("noise_120", Filter::Noise(120.0)),
    ];
    filtered("noise", &filters)
}

fn jpegs() -> Vec<Scene> {
    let filters = [
        ("jpeg_95", Filter::Jpeg(95)),
        ("jpeg_80", Filter::Jpeg(80)),
        ("jpeg_60", Filter::Jpeg(60)),
        ("jpeg_40", Filter::Jpeg(40)),
        ("jpeg_20", Filter::Jpeg(20)),
        ("jpeg_10", Filter::Jpeg(10)),
        ("jpeg_5", Filter::Jpeg(5)),
    ];
    filtered("jpeg", &filters)
}

/// Up to 24 heads in rows, each slightly rotated and scaled.
fn groups() -> Vec<Scene> {
    let group = |count: u32, columns: u32, cell_px: f64, tilt: f64, seed: u64| {
        let mut seeded = Seeded::new(seed);
        let rows = count.div_ceil(columns);
        let at = |i: u32, n: u32| (f64::from(i % n) + 0.5) * cell_px;
        let faces = (0..count).map(|i| {
            let shake = |seeded: &mut Seeded| 0.08 * cell_px * seeded.signed();
            let at_px =
                [at(i, columns) + shake(&mut seeded), (f64::from(i / columns) + 0.5) * cell_px + shake(&mut seeded)];
            let scale = cell_px / 290.0 * (1.0 + 0.25 * seeded.signed());
            Placement { at_px, scale, degrees: tilt * seeded.signed(), mirrored: seeded.below(2) == 0 }
        });
        let mut scene = portrait("group", format!("group_{count}_cells_{cell_px}_tilt_{tilt}"));
        scene.faces = faces.collect();
        scene.size_px = [(f64::from(columns) * cell_px) as u32, (f64::from(rows) * cell_px) as u32];
        scene.ground = if seed.is_multiple_of(2) { Ground::Clouds } else { Ground::Cloth };
        scene.part = Part::Head;
        scene.seed = seed;
        scene
    };
    vec![
        group(2, 2, 400.0, 10.0, 1),
        group(3, 3, 300.0, 20.0, 2),
        group(4, 2, 320.0, 15.0, 3),
        group(5, 3, 280.0, 20.0, 4),
        group(6, 3, 420.0, 30.0, 5),
        group(8, 4, 240.0, 20.0, 6),
        group(10, 5, 300.0, 15.0, 7),
        group(12, 4, 260.0, 45.0, 8),
        group(12, 6, 600.0, 20.0, 9),
        group(15, 5, 240.0, 15.0, 10),
        group(20, 5, 250.0, 20.0, 11),
        group(20, 5, 250.0, 180.0, 12),
        group(24, 6, 240.0, 15.0, 13),
    ]
}

/// Random combinations of sizes, rotations, backgrounds and filters.
fn mixed() -> Vec<Scene> {
    let mut seeded = Seeded::new(2026);
    let scene = |index: usize| {
        let mut scene = portrait("mixed", format!("mixed_{index}"));
        let pick =
            |seeded: &mut Seeded, range: [f64; 2]| range[0] + (range[1] - range[0]) * (0.5 + 0.5 * seeded.signed());
        let (width, height) = (pick(&mut seeded, [300.0, 1400.0]).round(), pick(&mut seeded, [300.0, 1400.0]).round());
        let scale = width.min(height) / 110.0 * pick(&mut seeded, [0.12, 0.75]);
        let at_px = [pick(&mut seeded, [0.25, 0.75]) * width, pick(&mut seeded, [0.25, 0.75]) * height];
        let degrees = match seeded.below(3) {
            0 => pick(&mut seeded, [-180.0, 180.0]),
            _ => pick(&mut seeded, [-25.0, 25.0]),
        };
        scene.faces = vec![Placement { at_px, scale, degrees, mirrored: seeded.below(2) == 0 }];
        scene.size_px = [width as u32, height as u32];
        scene.ground = Ground::ALL[seeded.below(Ground::ALL.len())];
        scene.part = Part::Head;
        scene.seed = seeded.bits();
        scene.filter = match seeded.below(8) {
            0 => Filter::Gamma(pick(&mut seeded, [0.5, 2.5])),
            1 => Filter::Contrast(pick(&mut seeded, [0.3, 0.9])),
            2 => Filter::Blur(1 + seeded.below(2) as u32),
            3 => Filter::Noise(pick(&mut seeded, [5.0, 50.0])),
            4 => Filter::Jpeg(15 + seeded.below(80) as u8),
            5 => Filter::SideLight(pick(&mut seeded, [0.2, 0.8])),
            6 => Filter::Grey,
            _ => Filter::None,
        };
        scene
    };
    (0..60).map(scene).collect()
}

/// Variants of one face: JPEG qualities, shifts by 1 px, scales by 2 %, rotations by up to 3°. Not part of the table of
/// families.
pub fn variants() -> Vec<Scene> {
    let place = |x: f64, y: f64, scale: f64, degrees: f64| Placement {
        at_px: [224.0 + x, 124.0 + y],
        scale,
        degrees,
        mirrored: false,
    };
    let same = place(0.0, 0.0, 1.0, 0.0);
    [
        (same, Filter::Jpeg(95)),
        (same, Filter::Jpeg(85)),
        (same, Filter::Jpeg(70)),
        (same, Filter::Jpeg(50)),
        (place(1.0, 0.0, 1.0, 0.0), Filter::None),
        (place(-1.0, 0.0, 1.0, 0.0), Filter::None),
        (place(0.0, 1.0, 1.0, 0.0), Filter::None),
        (place(0.0, -1.0, 1.0, 0.0), Filter::None),
        (place(0.0, 0.0, 1.02, 0.0), Filter::None),
        (place(0.0, 0.0, 0.98, 0.0), Filter::None),
        (place(0.0, 0.0, 1.0, 3.0), Filter::None),
        (place(0.0, 0.0, 1.0, -3.0), Filter::None),
        (place(0.0, 0.0, 1.0, 1.5), Filter::Jpeg(80)),
        (place(1.0, 1.0, 1.01, -1.5), Filter::Jpeg(80)),
    ]
    .into_iter()
    .map(|(placed, filter)| Scene { faces: vec![placed], filter, ..portrait("variant", String::new()) })
    .collect()
}

/// Backgrounds without faces.
fn empty() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for (index, ground) in Ground::ALL.into_iter().enumerate() {
        for (size_px, seed) in [([512, 512], 1), ([1400, 900], 2), ([700, 1600], 3), ([4000, 3000], 4)] {
            let mut scene = portrait("empty", format!("empty_{index}_{}x{}", size_px[0], size_px[1]));
            scene.faces.clear();
            scene.size_px = size_px;
            scene.ground = ground;
            scene.seed = seed;
            scenes.push(scene);
        }
    }
    scenes
}
