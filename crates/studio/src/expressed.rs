//! What expressions displace the levels of a document by.

use glam::DVec3;

use crate::level::Level;
use crate::{Expression, Expressions, StudioError};

/// Works out what an expression displaces every level up to a density by, unless it is known. Denser levels part at lids and
/// lips, so that what moves one of them leaves the other.
pub(crate) fn prepare(levels: &mut [Level], density: u32, expression: Expression) -> Result<(), StudioError> {
    for place in 0..=density as usize {
        if levels[place].expressed().ways(expression).is_some() {
            continue;
        }
        let ways = match levels[..=place].split_at_mut(place) {
            ([], [cage, ..]) => of_cage(cage, expression)?,
            ([.., coarser], _) => {
                let ways = coarser.expressed().ways(expression).expect("invariant: coarser levels come first");
                moving(coarser.finer().interpolate(ways))
            }
            _ => return Ok(()),
        };
        levels[place].expressed_mut().expressions.push((expression, ways));
    }
    Ok(())
}

/// What is left where nothing moves, between the points of a coarser mesh, is nothing: files then hold only what moves.
fn moving(mut ways: Vec<DVec3>) -> Vec<DVec3> {
    const LEAST_M: f64 = 1e-5;
    ways.iter_mut().filter(|way| way.length() < LEAST_M).for_each(|way| *way = DVec3::ZERO);
    ways
}

fn of_cage(cage: &mut Level, expression: Expression) -> Result<Vec<DVec3>, StudioError> {
    if cage.mirror().is_err() {
        return Err(StudioError::NoExpressions { vertex_count: cage.rest().len() });
    }
    let mut solver = match cage.expressed_mut().solver.take() {
        Some(solver) => solver,
        None => Expressions::new(cage.rest())?,
    };
    let ways = solver.displacement(expression).map(<[DVec3]>::to_vec);
    cage.expressed_mut().solver = Some(solver);
    ways
}
