use glam::DVec2;
use rosto_warp::WarpMesh;

use crate::scenes::*;
use crate::seeded::Seeded;

#[test]
fn triangles_do_not_fold() {
    for seed in 0..24 {
        let mut seeded = Seeded::new(seed);
        let points = oval(&mut seeded);
        let most_px = [3.0, 30.0, 300.0, 3e5][seed as usize % 4];
        // As smooth bumps, and independently of each other.
        let smooth = edited(&points, most_px, &mut seeded);
        let independent: Vec<DVec2> = points.iter().map(|&point| point + plane(&mut seeded) * most_px).collect();
        for targets in [smooth, independent] {
            let warp = moved(&points, &targets);
            assert_bijective(warp.warp_mesh());
            assert!(warp.limited_px() < 2.0 * most_px * 2_f64.sqrt() && warp.limited_px() >= 0.0);
        }
    }
}

#[test]
fn crossing_lines_are_limited_and_reported() {
    // Two lips 3 px apart; the upper one is moved to 12 px below the lower one.
    let line = |y: f64| (0..12).map(move |i| DVec2::new(60.0 + 7.0 * f64::from(i), y));
    let points: Vec<DVec2> = line(80.0).chain(line(100.0)).chain(line(103.0)).chain(line(123.0)).collect();
    let lower = |share: f64| {
        points.iter().enumerate().map(move |(i, point)| match i / 12 {
            1 => *point + DVec2::Y * 15.0 * share,
            _ => *point,
        })
    };
    let warp = |share: f64| moved(&points, &lower(share).collect::<Vec<_>>());
    assert_eq!(warp(0.1).limited_px(), 0.0, "at half the distance they do not touch");
    for share in [0.5, 1.0] {
        let warp = warp(share);
        assert_bijective(warp.warp_mesh());
        assert!(warp.limited_px() > 1.0, "{}", warp.limited_px());
        let moved = warp.warp_mesh().from_px.iter().zip(&warp.warp_mesh().to_px).map(|(from, to)| from.distance(*to));
        assert!(moved.fold(0.0, f64::max) > 2.0, "most of the displacement remains");
    }
}

#[test]
fn fold_removal_is_local() {
    let points: Vec<DVec2> =
        (0..150).map(|i| DVec2::new(50.0 + 7.0 * f64::from(i % 15), 60.0 + 8.0 * f64::from(i / 15))).collect();
    let mut targets = points.clone();
    // One point crosses its neighbours; a smooth bump lies far from it.
    targets[32].x += 30.0;
    let bump = points[117];
    let offset = |point: DVec2| DVec2::new(5.0, -3.0) * (-(point - bump).length_squared() / 300.0).exp();
    targets
        .iter_mut()
        .zip(&points)
        .filter(|(_, point)| point.y > 95.0)
        .for_each(|(target, point)| *target += offset(*point));
    let warp = moved(&points, &targets);
    assert_bijective(warp.warp_mesh());
    assert!(warp.limited_px() > 5.0, "{}", warp.limited_px());
    for (point, target) in points.iter().zip(&targets).filter(|(point, _)| point.y > 115.0) {
        let at = warp.warp_mesh().from_px.iter().position(|from| from == point).unwrap();
        assert!(warp.warp_mesh().to_px[at].distance(*target) < 1e-9, "{point}");
    }
}

/// A narrow bump, as of a long nose pulled to the side over the cheek.
#[test]
fn the_limited_displacement_depends_little_on_the_density() {
    let moved_px = |apart_px: f64| {
        let along = (96.0 / apart_px) as u32 + 1;
        let at = |i: u32| 52.0 + apart_px * f64::from(i);
        let points: Vec<DVec2> = (0..along * along).map(|i| DVec2::new(at(i % along), at(i / along))).collect();
        let offset = |point: DVec2| DVec2::X * 30.0 * (-(point - DVec2::splat(100.0)).length_squared() / 150.0).exp();
        let targets: Vec<DVec2> = points.iter().map(|&point| point + offset(point)).collect();
        let warp = moved(&points, &targets);
        assert_bijective(warp.warp_mesh());
        assert!(warp.limited_px() > 1.0, "{} px", warp.limited_px());
        let WarpMesh { from_px, to_px, .. } = warp.warp_mesh();
        from_px.iter().zip(to_px).map(|(from, to)| from.distance(*to)).fold(0.0, f64::max)
    };
    let [coarse, fine, finest] = [8.0, 2.0, 0.75].map(moved_px);
    assert!(coarse > 19.0 && fine > 0.8 * coarse && finest > 0.8 * coarse, "{coarse}, {fine} and {finest} px of 30");
}

#[test]
fn limited_px_is_the_largest_distance_from_a_target() {
    let mut seeded = Seeded::new(4);
    let points = oval(&mut seeded);
    let targets: Vec<DVec2> = points.iter().map(|&point| point + plane(&mut seeded) * 8.0).collect();
    let warp = moved(&points, &targets);
    let shortfall = |(point, target): (&DVec2, &DVec2)| {
        let at = warp.warp_mesh().from_px.iter().position(|from| from == point)?;
        Some(warp.warp_mesh().to_px[at].distance(*target))
    };
    let longest = points.iter().zip(&targets).filter_map(shortfall).fold(0.0, f64::max);
    assert!((longest - warp.limited_px()).abs() < 1e-9, "{longest} and {}", warp.limited_px());
}

#[test]
fn results_do_not_depend_on_earlier_calls() {
    let mut seeded = Seeded::new(5);
    let points = oval(&mut seeded);
    let ticks: Vec<Vec<DVec2>> = (0..4).map(|_| edited(&points, 40.0, &mut seeded)).collect();
    let mut reused = warp(&points, &[]);
    for targets in &ticks {
        reused.follow(&points, targets);
        assert_eq!(reused.warp_mesh(), moved(&points, targets).warp_mesh(), "no state remains");
    }
}
