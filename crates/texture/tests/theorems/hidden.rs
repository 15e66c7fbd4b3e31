use glam::{DVec2, DVec3};
use rosto_mesh::Topology;
use rosto_photo::Photo;

use crate::scenes::*;

/// Half width of the occluding plate; the sheet is 2 wide.
const PLATE: f64 = 0.25;

/// A flat sheet behind a plate, which has a separate corner of the texture.
fn sheet_behind_plate() -> Sheet {
    let mut sheet = Sheet::bent(0.0);
    let first = sheet.positions.len() as u32;
    let corners = [[-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0], [1.0, 1.0]];
    sheet.positions.extend(corners.map(|[x, y]| DVec3::new(PLATE * x, PLATE * y, 0.4)));
    sheet.atlas_uvs.iter_mut().for_each(|uv| *uv = DVec2::new(uv.x * 0.7, uv.y * 0.7));
    sheet.atlas_uvs.extend(corners.map(|[x, y]| DVec2::new(0.85 + 0.08 * x, 0.85 - 0.08 * y)));
    sheet.partners.extend([first + 3, first + 2, first + 1, first]);
    let plate = [[first, first + 1, first + 2], [first, first + 2, first + 3]];
    let triangles = sheet.topology.triangles().iter().copied().chain(plate).collect();
    sheet.topology = Topology::new(sheet.positions.len(), triangles).unwrap();
    sheet
}

/// The plate in one colour, the rest in waves.
fn photo(colour: [f64; 3]) -> Photo {
    painted(|at| if (at - 0.5).abs().max_element() < 0.36 * PLATE + 0.004 { colour } else { waves(at) })
}

/// Excludes the plate and its rim, which is filled from the surroundings.
fn is_of_the_sheet(uv: DVec2) -> bool {
    uv.max_element() < 0.62
}

#[test]
fn occluders_do_not_colour_hidden_areas() {
    let sheet = sheet_behind_plate();
    let view = sheet.seen(0.0);
    let [red, blue] = [[250.0, 10.0, 10.0], [10.0, 10.0, 250.0]].map(|colour| sheet.baked(&[(&view, &photo(colour))]));
    assert!(red.shares.filled > 0.04, "{:?}", red.shares);
    for ((uv, red), (_, blue)) in texels(&red).zip(texels(&blue)).filter(|((uv, _), _)| is_of_the_sheet(*uv)) {
        // Filling may transfer less than one of 240 levels.
        assert!(apart(red, blue) <= 1, "{red:?} and {blue:?} at {uv}");
    }
}

#[test]
fn a_second_photo_shows_hidden_areas() {
    let sheet = sheet_behind_plate();
    let (front, side) = (sheet.seen(0.0), sheet.seen(50.0));
    let texture = sheet.baked(&[(&front, &painted(|_| [150.0; 3])), (&side, &painted(|_| [100.0; 3]))]);
    assert!(texels(&texture).all(|(_, colour)| apart(colour, [150; 3]) <= 1));
    let alone = sheet.baked(&[(&front, &painted(|_| [150.0; 3]))]);
    assert!(texture.shares.filled < alone.shares.filled - 0.02, "{:?} and {:?}", texture.shares, alone.shares);
}

#[test]
fn background_at_the_rim_is_not_used() {
    let sheet = Sheet::bent(2.0);
    let view = sheet.seen(0.0);
    // A white background over the steep rim, as if the outline had been detected slightly too far outside.
    let photo = painted(|at| if (at.x - 0.5).abs() > 0.325 { [250.0, 252.0, 255.0] } else { [190.0, 140.0, 110.0] });
    let texture = sheet.baked(&[(&view, &photo)]);
    let most = texels(&texture).map(|(_, colour)| apart(colour, [190, 140, 110])).max().unwrap();
    assert!(most <= 6, "{most} levels towards white");
}
