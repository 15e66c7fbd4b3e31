//! Displacements of a document's levels by expressions.

use glam::DVec3;

use crate::level::Level;
use crate::{Expression, Expressions, StudioError};

/// Computes the displacement of each level up to `density` by an expression, unless it is cached. Denser levels are
/// split at lids and lips, so that moving one of them does not move the other.
pub(crate) fn prepare(levels: &mut [Level], density: u32, expression: Expression) -> Result<(), StudioError> {
    for index in 0..=density as usize {
        if levels[index].expression_cache().displacements(expression).is_some() {
            continue;
        }
        let displacements = match levels[..=index].split_at_mut(index) {
            ([], [cage, ..]) => of_cage(cage, expression)?,
            ([.., coarser], _) => {
                let displacements =
                    coarser.expression_cache().displacements(expression).expect("invariant: coarser levels come first");
                without_residue(coarser.finer().interpolate(displacements))
            }
            _ => return Ok(()),
        };
        levels[index].expression_cache_mut().expressions.push((expression, displacements));
    }
    Ok(())
}

/// Sets displacements that interpolation leaves near zero to zero, so that files contain only the vertices that move.
fn without_residue(mut displacements: Vec<DVec3>) -> Vec<DVec3> {
    const MIN_M: f64 = 1e-5;
    displacements
        .iter_mut()
        .filter(|displacement| displacement.length() < MIN_M)
        .for_each(|displacement| *displacement = DVec3::ZERO);
    displacements
}

fn of_cage(cage: &mut Level, expression: Expression) -> Result<Vec<DVec3>, StudioError> {
    if cage.mirror().is_err() {
        return Err(StudioError::NoExpressions { vertex_count: cage.rest().len() });
    }
    let mut solver = match cage.expression_cache_mut().solver.take() {
        Some(solver) => solver,
        None => Expressions::new(cage.rest())?,
    };
    let displacements = solver.displacement(expression).map(<[DVec3]>::to_vec);
    cage.expression_cache_mut().solver = Some(solver);
    displacements
}
