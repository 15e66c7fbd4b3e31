//! Formats with several files: 3MF, USDZ, and OBJ with its sidecar files.

use std::collections::HashMap;

use crate::archive::entries;
use crate::common::{face, model};
use glam::{DVec2, DVec3};
use rosto_export::*;
use rosto_face::{FaceModel, Triangulation};

fn write(face: &FaceModel, format: Format, base_colour: BaseColour, solid: Solid) -> Result<ExportedFile, ExportError> {
    let print = Print { solid, ..Print::default() };
    let (model, rest_m) = (model(face), face.positions_m());
    let gltf = GlbOptions { base_colour, ..GlbOptions::default() };
    format.write(&Content { model, rest_m, gltf, print, name: "my face", positions_image: None })
}

fn print(solid: Solid) -> ExportedFile {
    write(&face(Triangulation::Canonical), Format::ThreeMf, BaseColour::Photo, solid).unwrap()
}

const SOLIDS: [Solid; 2] = [Solid::Thickness { mm: 2.0 }, Solid::FlatBack { depth_mm: Some(60.0) }];

/// Values of an attribute, from all elements with a name.
fn attributes<'a>(xml: &'a str, element: &str, attribute: &str) -> Vec<&'a str> {
    let start = format!("<{element} ");
    let rows = xml.lines().filter(|line| line.starts_with(&start));
    let value = |line: &'a str| line.split(&format!(" {attribute}=\"")).nth(1)?.split('"').next();
    rows.map(|line| value(line).unwrap_or_default()).collect()
}

fn numbers<T: std::str::FromStr>(texts: Vec<&str>) -> Vec<T> {
    texts.into_iter().map(|text| text.parse().ok().unwrap()).collect()
}

#[test]
fn a_3mf_contains_a_closed_body_in_millimetres_on_the_plate() {
    for solid in SOLIDS {
        let file = print(solid);
        let parts = entries(&file.bytes);
        let names: Vec<&str> = parts.iter().map(|part| part.name.as_str()).collect();
        assert_eq!(names, ["[Content_Types].xml", "_rels/.rels", "3D/3dmodel.model"]);
        let xml = parts[2].text();
        assert!(xml.contains("unit=\"millimeter\""));
        let [x, y, z] = ["x", "y", "z"].map(|axis| numbers::<f64>(attributes(xml, "vertex", axis)));
        let [v1, v2, v3] = ["v1", "v2", "v3"].map(|corner| numbers::<usize>(attributes(xml, "triangle", corner)));
        let position = |at: usize| DVec3::new(x[at], y[at], z[at]);
        let mut sides = HashMap::new();
        let mut volume_mm3 = 0.0;
        for ((a, b), c) in v1.into_iter().zip(v2).zip(v3) {
            [[a, b], [b, c], [c, a]].into_iter().for_each(|side| *sides.entry(side).or_insert(0) += 1);
            volume_mm3 += position(a).dot(position(b).cross(position(c))) / 6.0;
        }
        assert!(sides.iter().all(|(&[from, to], &uses)| uses == 1 && sides.get(&[to, from]) == Some(&1)), "{solid}");
        let facts = file.solid.unwrap();
        assert!((volume_mm3 / 1000.0 / facts.volume_cm3 - 1.0).abs() < 1e-5);
        let low = (0..x.len()).map(position).reduce(DVec3::min).unwrap();
        let high = (0..x.len()).map(position).reduce(DVec3::max).unwrap();
        assert_eq!(low, DVec3::ZERO);
        assert!(high.distance(facts.size_mm) < 1e-4);
    }
}

#[test]
fn a_3mf_has_vertex_colours_and_a_neutral_back() {
    let face = face(Triangulation::Canonical);
    let file = print(SOLIDS[0]);
    let xml = entries(&file.bytes).remove(2);
    let palette = attributes(xml.text(), "m:color", "color");
    for (at, corners) in face.topology().triangles().iter().enumerate() {
        let [p1, p2, p3] = ["p1", "p2", "p3"].map(|corner| attributes(xml.text(), "triangle", corner)[at]);
        // Omitted indices equal that of the first corner.
        let [p2, p3] = [p2, p3].map(|index| if index.is_empty() { p1 } else { index });
        for (index, &corner) in [p1, p2, p3].iter().zip(corners) {
            let [r, g, b] = face.colours_srgb()[corner as usize];
            assert_eq!(palette[index.parse::<usize>().unwrap()], format!("#{r:02X}{g:02X}{b:02X}"));
        }
        if at > 40 {
            break;
        }
    }
    let indices = attributes(xml.text(), "triangle", "p1");
    assert!(indices[898..].iter().all(|index| *index == "0"));
    assert_eq!(palette[0], "#C8C8C8");
}

#[test]
fn an_stl_is_closed_unless_the_surface_is_requested() {
    let face = face(Triangulation::Tessellation);
    let count = |file: &ExportedFile| u32::from_le_bytes(file.bytes[80..84].try_into().unwrap()) as usize;
    let write = |solid| write(&face, Format::Stl, BaseColour::Photo, solid).unwrap();
    let sheet = write(Solid::Surface);
    assert_eq!((count(&sheet), &sheet.solid), (852, &None));
    assert_eq!(sheet.bytes, stl(&Model::of_face(&face)).unwrap());
    // The eye and mouth openings are filled, and each of the 36 rim edges adds two triangles.
    let filled = Triangulation::Canonical.triangles().len();
    let mask = write(Solid::Thickness { mm: 2.0 });
    assert_eq!(count(&mask), 2 * filled + 2 * 36);
    assert!(mask.solid.unwrap().volume_cm3 > 20.0);
}

#[test]
fn unprintable_models_are_refused() {
    let face = face(Triangulation::Canonical);
    let print = |solid| write(&face, Format::ThreeMf, BaseColour::Photo, solid).unwrap_err();
    assert_eq!(print(Solid::Surface), ExportError::NoBody);
    assert_eq!(print(Solid::Thickness { mm: -1.0 }), SolidError::Thickness { thickness_m: -0.001 }.into());
    let none = write(&face, Format::Png, BaseColour::VertexColours, SOLIDS[0]);
    assert_eq!(none.unwrap_err(), ExportError::NoPicture);
}

#[test]
fn solids_round_trip_as_text() {
    for solid in [
        Solid::Thickness { mm: 0.4 },
        Solid::FlatBack { depth_mm: Some(12.5) },
        Solid::FlatBack { depth_mm: None },
        Solid::Surface,
    ] {
        assert_eq!(solid.to_string().parse(), Ok(solid));
    }
    for text in [
        "",
        "flat:",
        "flat:3",
        "thickness:",
        "thickness:0",
        "flat:-1",
        "thickness:nan",
        "thickness:51",
        "surface:1",
        "cube",
    ] {
        assert_eq!(text.parse::<Solid>(), Err(ParseSolidError { text: text.to_owned() }));
    }
}

#[test]
fn heights_round_trip_as_text() {
    for height in [PrintHeight::Life, PrintHeight::Mm(10.0), PrintHeight::Mm(80.5)] {
        assert_eq!(height.to_string().parse(), Ok(height));
    }
    for text in ["", "life:1", "9.9", "501", "-80", "nan", "80 mm"] {
        assert_eq!(text.parse::<PrintHeight>(), Err(ParseHeightError { text: text.to_owned() }));
    }
}

/// Grid to which the surface of a print is rounded.
const ROUNDED_M: f64 = 1e-7;

/// The body of a print, and its measures.
fn printed(face: &FaceModel, solid: Solid, height: PrintHeight) -> (rosto_solid::Body, SolidFacts) {
    let PrintedBody { body, .. } = Print { solid, height }.body(&model(face)).unwrap().unwrap();
    let facts = SolidFacts::of(&body, solid);
    (body, facts)
}

#[test]
fn a_print_has_its_height_and_the_thickness_of_the_print() {
    let face = face(Triangulation::Canonical);
    let solid = Solid::Thickness { mm: 1.2 };
    let life = printed(&face, solid, PrintHeight::Life).1;
    let face_mm = PrintHeight::Life.mm(face.positions_m());
    for mm in [40.0, 80.0, face_mm] {
        let (body, facts) = printed(&face, solid, PrintHeight::Mm(mm));
        assert!((facts.size_mm.y / mm - 1.0).abs() < 0.02, "{mm}: {}", facts.size_mm);
        let front = body.positions_m()[..body.front_vertices()].iter().zip(face.positions_m());
        if facts.moved_mm == 0.0 {
            let stray = front.map(|(own, face)| own.distance(*face * (mm / face_mm))).fold(0.0, f64::max);
            assert!(stray < ROUNDED_M, "{mm}: the face is only scaled, and rounded");
        }
        let thick = body.thickness_m().iter().filter(|&&m| (0.00119..=0.00121).contains(&m)).count();
        assert!(2 * thick > body.thickness_m().len(), "{mm}: most of the wall is 1.2 mm of the print");
        // The wall keeps its thickness while the area shrinks with the square of the size.
        let share = facts.volume_cm3 / life.volume_cm3 / (mm / face_mm).powi(2);
        assert!((0.8..1.2).contains(&share), "{mm}: {share}");
    }
}

#[test]
fn a_print_does_not_depend_on_the_last_bits_of_its_face() {
    let face = face(Triangulation::Canonical);
    let print = |positions_m: &[DVec3]| {
        let print = Print { solid: Solid::Thickness { mm: 2.0 }, height: PrintHeight::Mm(80.0) };
        print.body(&Model { positions_m, ..model(&face) }).unwrap().unwrap().body.positions_m().to_vec()
    };
    let elsewhere: Vec<DVec3> =
        face.positions_m().iter().map(|position_m| *position_m * (1.0 + f64::EPSILON)).collect();
    assert_ne!(elsewhere, face.positions_m());
    assert!(print(&elsewhere) == print(face.positions_m()), "a body differs by more than its face");
}

#[test]
fn a_relief_is_as_deep_as_requested_and_never_stretched() {
    let face = face(Triangulation::Canonical);
    let along = |axis: usize| {
        let lengths = face.positions_m().iter().map(move |position| position[axis]);
        let [low, high] = [f64::min, f64::max].map(|end| lengths.clone().reduce(end).unwrap());
        1000.0 * (high - low)
    };
    for height in [PrintHeight::Mm(40.0), PrintHeight::Mm(80.0), PrintHeight::Life] {
        let height_mm = height.mm(face.positions_m());
        let natural_mm = along(2) * height_mm / along(1);
        for depth_mm in [4.0, 12.0, 30.0, 60.0, 150.0] {
            let (body, facts) = printed(&face, Solid::FlatBack { depth_mm: Some(depth_mm) }, height);
            let asked_mm = (natural_mm + 2.0).min(depth_mm);
            assert!((facts.size_mm.z - asked_mm).abs() < 1000.0 * ROUNDED_M, "{height}, {depth_mm}");
            assert!((facts.thinnest_mm - 2.0).abs() < 1e-9 && facts.thin_share == 0.0, "2 mm behind the deepest point");
            assert_eq!((facts.pose, facts.overhang_cm2), (PrintPose::Lying, 0.0), "{height}, {depth_mm}");
            let front = body.positions_m()[..468].iter().zip(face.positions_m());
            let scale = height_mm / along(1);
            assert!(front.into_iter().all(|(own, face)| (*own - *face * scale).truncate().length() < ROUNDED_M));
        }
        let usual = printed(&face, Solid::FlatBack { depth_mm: None }, height).1;
        assert!(
            (usual.size_mm.z - height_mm / 3.0).abs() < 1000.0 * ROUNDED_M || usual.size_mm.z < height_mm / 3.0,
            "{height}"
        );
    }
}

#[test]
fn a_thin_wall_and_the_supports_of_a_mask_are_reported() {
    let face = face(Triangulation::Canonical);
    let small = printed(&face, Solid::Thickness { mm: 2.0 }, PrintHeight::Mm(40.0)).1;
    assert_eq!(small.asked_mm, 2.0);
    assert_eq!(small.thin_share > 0.0, small.thinnest_mm < 1.9, "{small:?}");
    assert!((0.0..1.0).contains(&small.thin_share), "{small:?}");
    let mask = printed(&face, Solid::Thickness { mm: 2.0 }, PrintHeight::Life).1;
    assert!(mask.overhang_cm2 > 1.0, "a hollow needs supports: {mask:?}");
    assert!((mask.pla_g - 1.24 * mask.volume_cm3).abs() < 1e-9, "two shells of 1.2 mm fill a wall of 2 mm");
    let relief = printed(&face, Solid::FlatBack { depth_mm: None }, PrintHeight::Life).1;
    assert!(relief.pla_g < 0.5 * 1.24 * relief.volume_cm3, "mostly infill: {relief:?}");
}

#[test]
fn a_usdz_is_aligned_and_refers_to_its_picture() {
    let face = face(Triangulation::Canonical);
    for (base_colour, names) in [
        (BaseColour::Whole, &["face.usda", "face.jpg"][..]),
        (BaseColour::Photo, &["face.usda", "face.jpg"]),
        (BaseColour::VertexColours, &["face.usda"]),
    ] {
        let file = write(&face, Format::Usdz, base_colour, SOLIDS[0]).unwrap();
        let parts = entries(&file.bytes);
        assert_eq!(parts.iter().map(|part| part.name.as_str()).collect::<Vec<_>>(), names);
        assert!(parts.iter().all(|part| part.start.is_multiple_of(64)));
        let scene = parts[0].text();
        assert!(scene.starts_with("#usda 1.0\n"));
        for expected in
            ["metersPerUnit = 1\n", "upAxis = \"Y\"", "subdivisionScheme = \"none\"", "defaultPrim = \"face\""]
        {
            assert!(scene.contains(expected), "{expected}");
        }
        assert_eq!(scene.contains("@face.jpg@"), names.len() == 2);
        if let Some(picture) = parts.get(1) {
            assert!(rosto_photo::decode(&picture.bytes, &rosto_photo::Limits::default()).is_ok());
        }
        let list = |name: &str| {
            let start = scene.find(&format!(" {name} = [")).unwrap() + name.len() + 5;
            let text = scene[start..start + scene[start..].find(']').unwrap()].replace(['(', ')'], "");
            numbers::<f64>(text.split(", ").collect())
        };
        let points = list("points");
        let expected = face.positions_m().iter().flat_map(|p| p.as_vec3().to_array()).map(f64::from);
        assert!(points.iter().zip(expected).all(|(found, expected)| (found - expected).abs() < 1e-8));
        let indices: Vec<f64> = face.topology().triangles().concat().into_iter().map(f64::from).collect();
        assert_eq!((points.len(), list("faceVertexIndices")), (3 * 468, indices));
        assert_eq!(list("faceVertexCounts"), [3.0; 898]);
    }
}

#[test]
fn a_textured_obj_refers_to_its_material_and_picture() {
    let face = face(Triangulation::Canonical);
    let whole = model(&face).whole.unwrap();
    let file = write(&face, Format::Obj, BaseColour::Whole, SOLIDS[0]).unwrap();
    let text = String::from_utf8(file.bytes.clone()).unwrap();
    let [material, picture] = &file.sidecars[..] else { panic!("two sidecar files") };
    assert_eq!([&material.name, &picture.name], ["my_face.mtl", "my_face.png"]);
    assert_eq!(Format::Obj.sidecar_names(BaseColour::Whole, "my face"), ["my_face.mtl", "my_face.png"]);
    assert!(text.contains("\nmtllib my_face.mtl\n") && text.contains("\nusemtl skin\n"));
    let text_of_material = std::str::from_utf8(&material.bytes).unwrap();
    assert!(text_of_material.contains("\nnewmtl skin\n") && text_of_material.contains("\nmap_Kd my_face.png\n"));
    let picture = rosto_photo::decode(&picture.bytes, &rosto_photo::Limits::default()).unwrap();
    assert_eq!(picture.pixels(), whole.pixels.pixels(), "lossless");
    let rows = |key: &str| text.lines().filter_map(|line| line.strip_prefix(key)).collect::<Vec<_>>();
    let uvs = rows("vt ");
    assert_eq!((rows("v ").len(), uvs.len(), rows("vn ").len()), (468, 468, 468));
    for (row, uv) in uvs.iter().zip(whole.uvs) {
        let [u, v]: [f64; 2] = numbers(row.split(' ').collect()).try_into().unwrap();
        assert!(DVec2::new(u, 1.0 - v).distance(*uv) < 1e-6);
    }
    let corner = |corner: u32| format!("{0}/{0}/{0}", corner + 1);
    let faces = face.topology().triangles().iter().map(|corners| corners.map(corner).join(" "));
    assert!(faces.eq(rows("f ")));

    let plain = write(&face, Format::Obj, BaseColour::VertexColours, SOLIDS[0]).unwrap();
    assert_eq!(plain, obj(&Model::of_face(&face)).unwrap().into());
    assert_eq!(Format::Obj.bundle_extension(BaseColour::VertexColours), "obj");
}

#[test]
fn a_bundle_contains_the_same_files() {
    let face = face(Triangulation::Canonical);
    let file = write(&face, Format::Obj, BaseColour::Photo, SOLIDS[0]).unwrap();
    let parts = entries(&file.clone().bundled("face", Format::Obj));
    assert_eq!(Format::Obj.bundle_extension(BaseColour::Photo), "zip");
    let names: Vec<&str> = parts.iter().map(|part| part.name.as_str()).collect();
    assert_eq!(names, ["face.obj", "my_face.mtl", "my_face.png"]);
    let sidecars = file.sidecars.iter().map(|file| &file.bytes);
    assert!([&file.bytes].into_iter().chain(sidecars).eq(parts.iter().map(|part| &part.bytes)));
    let alone = write(&face, Format::Glb, BaseColour::Photo, SOLIDS[0]).unwrap();
    assert_eq!(alone.clone().bundled("face", Format::Glb), alone.bytes);
}

#[test]
fn a_png_equals_the_picture_of_an_obj() {
    let face = face(Triangulation::Canonical);
    for base_colour in [BaseColour::Whole, BaseColour::Photo] {
        let png = write(&face, Format::Png, base_colour, SOLIDS[0]).unwrap().bytes;
        let sidecars = write(&face, Format::Obj, base_colour, SOLIDS[0]).unwrap().sidecars;
        assert_eq!(png, sidecars[1].bytes);
    }
}

#[test]
fn exports_are_deterministic() {
    let face = face(Triangulation::Canonical);
    for format in Format::ALL {
        let write = || write(&face, format, BaseColour::Whole, SOLIDS[0]).unwrap();
        assert_eq!(write(), write(), "{format:?}");
    }
}
