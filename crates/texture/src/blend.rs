use std::ops::Range;

use glam::Vec3;

use crate::atlas::Atlas;
use crate::filling::filled;
use crate::layer::{Layer, Side};
use crate::map::{AREA, CELLS, distances, divided, ramp};
use crate::matching::ratios;

/// So many times as well must the other side be seen for its mirror image to be taken.
const MIRRORED: f32 = 1.0 / 3.0;
/// Powers of the cosine: what is slow is mixed from all that see it, and details come from the one that sees them best, so
/// that none is seen twice.
const SLOW_POWER: u32 = 2;
const DETAIL_POWER: u32 = 6;
/// A layer that has less of a detail than this has none of it.
const LEAST_SHARE: f32 = 0.02;

/// How a texture is made up: each texel is the sum, over the layers, of their colour times their factor, plus the rest.
///
/// The factors hold how far each layer is taken and how bright it is made; the rest, what then is missing of the slow colours.
pub(crate) struct Blend {
    /// For each layer, by cells; in the order of the layers.
    pub(crate) factors: Vec<Vec<Vec3>>,
    pub(crate) rest: Vec<Vec3>,
    /// The slow colours alone, also where there is no mesh.
    pub(crate) base: Vec<Vec3>,
    /// How far each cell is seen by any layer: 0 to 1.
    pub(crate) presence: Vec<f32>,
    /// How far each cell of the mesh, and each beside it, has to be filled: 0 to 1.
    pub(crate) missing: Vec<f32>,
    pub(crate) shares: Shares,
}

/// Shares of the mesh's area in its texture, which sum to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shares {
    /// What a photo shows.
    pub seen: f64,
    /// What no photo shows, and is the mirror image of what one does.
    pub mirrored: f64,
    /// What was filled from around it.
    pub filled: f64,
}

impl Blend {
    /// Of layers, those of the photos' own sides first. `wholes` tells for each whole how far each cell belongs to it.
    pub(crate) fn new(atlas: &Atlas, layers: &[Layer], wholes: &[Vec<f32>]) -> Self {
        let kept = kept_for_wholes(layers, wholes);
        let slow = taken(layers, &kept, SLOW_POWER);
        let ratios = matched(layers, &slow, wholes);
        let taken = taken(layers, &kept, DETAIL_POWER);
        let presence: Vec<f32> =
            (0..AREA).map(|cell| taken.iter().map(|taken| taken[cell]).sum::<f32>().min(1.0)).collect();
        let base = filled(&composed(layers, |layer| &layer.low, &ratios, &slow), &presence);
        let factors: Vec<Vec<Vec3>> = taken.iter().zip(&ratios).map(|(taken, ratios)| scaled(ratios, taken)).collect();
        let mut rest = base.clone();
        for (layer, factors) in layers.iter().zip(&factors) {
            rest.iter_mut().zip(&layer.low).zip(factors).for_each(|((rest, low), factor)| *rest -= *low * *factor);
        }
        let shares = shares(atlas, layers, &taken);
        let factors = factors.into_iter().map(|factors| beyond_the_rim(atlas, factors)).collect();
        Self { factors, rest: beyond_the_rim(atlas, rest), base, missing: missing(atlas, &presence), presence, shares }
    }
}

/// How well a cell is seen by a layer.
fn quality(layer: &Layer, cell: usize) -> f32 {
    let likeness = if layer.side == Side::Mirrored { MIRRORED } else { 1.0 };
    layer.cosine[cell].max(0.0) * likeness
}

/// How far each layer may be used in each cell: in a whole, those that see it less well are left to where the best does not.
fn kept_for_wholes(layers: &[Layer], wholes: &[Vec<f32>]) -> Vec<Vec<f32>> {
    let mut kept = vec![vec![1.0; AREA]; layers.len()];
    for whole in wholes {
        let seen = |layer: &Layer| -> f32 {
            (0..AREA).map(|cell| whole[cell] * layer.presence[cell] * quality(layer, cell)).sum()
        };
        let seen: Vec<f32> = layers.iter().map(seen).collect();
        let most = seen.iter().copied().fold(0.0, f32::max);
        let Some(best) = seen.iter().position(|seen| *seen == most) else { continue };
        let others = kept.iter_mut().enumerate().filter(|(layer, _)| *layer != best);
        for (cell, kept) in others.flat_map(|(_, kept)| kept.iter_mut().enumerate()) {
            *kept *= 1.0 - whole[cell] * layers[best].presence[cell];
        }
    }
    kept
}

/// How far each layer is taken in each cell: 0 to 1, and in all as far as the cell is seen.
///
/// Of the photos' own sides, and of the mirror images, each counts by a power of the cosine at which it is seen. Then the own
/// sides come first, but where the others are seen so much better; and those take what is left.
fn taken(layers: &[Layer], kept: &[Vec<f32>], power: u32) -> Vec<Vec<f32>> {
    let mut taken = vec![vec![0.0; AREA]; layers.len()];
    let own = layers.iter().filter(|layer| layer.side == Side::Own).count();
    for cell in 0..AREA {
        let there = |layer: usize| layers[layer].presence[cell] * kept[layer][cell];
        let cosine = |layer: usize| layers[layer].cosine[cell].max(0.0);
        let of_group = |group: Range<usize>| -> [f32; 2] {
            let sum = group.clone().map(|layer| there(layer) * cosine(layer)).sum::<f32>();
            let all = group.map(there).sum::<f32>();
            [all.min(1.0), power_of(divided(sum, all), DETAIL_POWER)]
        };
        let ([own_there, own_strength], [other_there, other_strength]) =
            (of_group(0..own), of_group(own..layers.len()));
        let rival = other_strength * power_of(MIRRORED, DETAIL_POWER) * other_there;
        let own_share = own_there * divided(own_strength, own_strength + rival);
        for (group, share) in [(0..own, own_share), (own..layers.len(), (1.0 - own_share) * other_there)] {
            let weight = |layer: usize| there(layer) * power_of(cosine(layer), power);
            let sum = group.clone().map(weight).sum::<f32>();
            for layer in group {
                taken[layer][cell] = divided(weight(layer), sum) * share;
            }
        }
        forget_little(&mut taken, cell);
    }
    taken
}

/// Products in one order, which machines agree on.
fn power_of(value: f32, power: u32) -> f32 {
    (0..power).fold(1.0, |product, _| product * value)
}

/// A layer of which next to nothing is taken costs time and gives nothing.
fn forget_little(taken: &mut [Vec<f32>], cell: usize) {
    let all: f32 = taken.iter().map(|taken| taken[cell]).sum();
    let left = |taken: f32| (taken - LEAST_SHARE * all).max(0.0);
    let kept: f32 = taken.iter().map(|taken| left(taken[cell])).sum();
    taken.iter_mut().for_each(|taken| taken[cell] = divided(left(taken[cell]), kept) * all);
}

/// For each layer the ratios that make it as bright as those before it; mirror images only follow what is seen itself.
fn matched(layers: &[Layer], weights: &[Vec<f32>], wholes: &[Vec<f32>]) -> Vec<Vec<Vec3>> {
    let mut matched: Vec<Vec<Vec3>> = Vec::with_capacity(layers.len());
    // What moves by itself is not the same in both.
    let plain = |cell: usize| wholes.iter().map(|whole| 1.0 - whole[cell]).product::<f32>();
    for (index, layer) in layers.iter().enumerate() {
        let own = layers.iter().take(index).take_while(|layer| layer.side == Side::Own).count();
        if own == 0 {
            matched.push(vec![Vec3::ONE; AREA]);
            continue;
        }
        let wanted = composed(&layers[..own], |layer| &layer.colours, &matched[..own], &weights[..own]);
        // What is seen at a slant, or not well, is of little evidence.
        let seen = |cell: usize| -> f32 {
            layers[..own].iter().zip(weights).map(|(layer, weights)| weights[cell] * layer.cosine[cell]).sum()
        };
        let overlap: Vec<f32> =
            (0..AREA).map(|cell| seen(cell) * layer.presence[cell] * layer.cosine[cell] * plain(cell)).collect();
        matched.push(ratios(&layer.colours, &wanted, &overlap));
    }
    matched
}

/// Colours of all layers together, where there is one.
fn composed(layers: &[Layer], colours: fn(&Layer) -> &[Vec3], ratios: &[Vec<Vec3>], weights: &[Vec<f32>]) -> Vec<Vec3> {
    let of_cell = |cell: usize| {
        let (mut sum, mut weight) = (Vec3::ZERO, 0.0);
        for ((layer, ratios), weights) in layers.iter().zip(ratios).zip(weights) {
            sum += colours(layer)[cell] * ratios[cell] * weights[cell];
            weight += weights[cell];
        }
        divided(sum, weight)
    };
    (0..AREA).map(of_cell).collect()
}

fn scaled(ratios: &[Vec3], shares: &[f32]) -> Vec<Vec3> {
    ratios.iter().zip(shares).map(|(ratio, share)| *ratio * *share).collect()
}

fn missing(atlas: &Atlas, presence: &[f32]) -> Vec<f32> {
    let inside: Vec<bool> = (0..AREA).map(|cell| atlas.is_inside(cell)).collect();
    let near = distances(&inside).into_iter().map(|distance| 1.0 - ramp(distance, 2.0, 6.0));
    near.zip(presence).map(|(near, presence)| near * (1.0 - presence)).collect()
}

/// Where the texels of the mesh come from.
fn shares(atlas: &Atlas, layers: &[Layer], taken: &[Vec<f32>]) -> Shares {
    let inside: Vec<usize> = (0..AREA).filter(|&cell| atlas.is_inside(cell)).collect();
    let sum = |side: Side| -> f64 {
        let of_side = layers.iter().zip(taken).filter(|(layer, _)| layer.side == side);
        of_side.flat_map(|(_, taken)| inside.iter().map(|&cell| f64::from(taken[cell]))).sum()
    };
    let [seen, mirrored] = [Side::Own, Side::Mirrored].map(|side| sum(side) / inside.len() as f64);
    Shares { seen, mirrored, filled: (1.0 - seen - mirrored).max(0.0) }
}

/// Carried on over the mesh's rim by two cells, so that what lies between cells has one on each side.
fn beyond_the_rim(atlas: &Atlas, mut map: Vec<Vec3>) -> Vec<Vec3> {
    let mut known: Vec<bool> = (0..AREA).map(|cell| atlas.is_inside(cell)).collect();
    for _ in 0..2 {
        let (old, old_known) = (map.clone(), known.clone());
        for cell in (0..AREA).filter(|&cell| !old_known[cell]) {
            let around = around(cell).filter(|&cell| old_known[cell]);
            let (sum, count) = around.fold((Vec3::ZERO, 0.0), |(sum, count), cell| (sum + old[cell], count + 1.0));
            (map[cell], known[cell]) = (divided(sum, count), count > 0.0);
        }
    }
    map
}

/// The cells around one, itself among them.
fn around(cell: usize) -> impl Iterator<Item = usize> {
    let (row, column) = (cell / CELLS, cell % CELLS);
    let rows = row.saturating_sub(1)..=(row + 1).min(CELLS - 1);
    let columns = column.saturating_sub(1)..=(column + 1).min(CELLS - 1);
    rows.flat_map(move |row| columns.clone().map(move |column| row * CELLS + column))
}
