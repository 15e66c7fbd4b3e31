use std::ops::Range;

use glam::Vec3;

use crate::atlas::Atlas;
use crate::filling::filled;
use crate::layer::{Layer, Side};
use crate::map::{AREA, CELLS, distances, divided, ramp};
use crate::matching::ratios;

/// Weight of mirrored layers: they win only where they are seen three times as well.
const MIRRORED: f32 = 1.0 / 3.0;
/// Powers of the cosine. Low frequencies are averaged over the layers; details come mostly from the best one, to avoid
/// ghosting.
const SLOW_POWER: u32 = 2;
const DETAIL_POWER: u32 = 6;
/// Layers with a smaller share of a texel's detail are dropped.
const MIN_SHARE: f32 = 0.02;

/// Composition of a texture: a texel is the sum of each layer's colour times its factor, plus the rest.
///
/// The factors combine weight and exposure; the rest supplies the missing low frequencies.
pub(crate) struct Blend {
    /// One map per layer, in the order of the layers.
    pub(crate) factors: Vec<Vec<Vec3>>,
    pub(crate) rest: Vec<Vec3>,
    /// Low frequencies alone, also outside the mesh.
    pub(crate) base: Vec<Vec3>,
    /// Combined weight of the layers in each cell, 0 to 1.
    pub(crate) presence: Vec<f32>,
    /// Share of each cell that must be filled, 0 to 1; only on and near the mesh.
    pub(crate) missing: Vec<f32>,
    pub(crate) shares: Shares,
}

/// Shares of the mesh's area in the texture, with sum 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shares {
    /// Shown by a photo.
    pub seen: f64,
    /// Not shown, and mirrored from the other side.
    pub mirrored: f64,
    /// Filled from the surroundings.
    pub filled: f64,
}

impl Blend {
    /// Composes the layers, of which the photos' own sides come first. `features` says how far each cell belongs to
    /// each feature.
    pub(crate) fn new(atlas: &Atlas, layers: &[Layer], features: &[Vec<f32>]) -> Self {
        let allowed = allowed_in_features(layers, features);
        let slow = layer_weights(layers, &allowed, SLOW_POWER);
        let ratios = matched(layers, &slow, features);
        let weights = layer_weights(layers, &allowed, DETAIL_POWER);
        let presence: Vec<f32> =
            (0..AREA).map(|cell| weights.iter().map(|weights| weights[cell]).sum::<f32>().min(1.0)).collect();
        let base = filled(&composed(layers, |layer| &layer.low, &ratios, &slow), &presence);
        let factors: Vec<Vec<Vec3>> =
            weights.iter().zip(&ratios).map(|(weights, ratios)| scaled(ratios, weights)).collect();
        let mut rest = base.clone();
        for (layer, factors) in layers.iter().zip(&factors) {
            rest.iter_mut().zip(&layer.low).zip(factors).for_each(|((rest, low), factor)| *rest -= *low * *factor);
        }
        let shares = shares(atlas, layers, &weights);
        let factors = factors.into_iter().map(|factors| extended(atlas, factors)).collect();
        Self { factors, rest: extended(atlas, rest), base, missing: missing(atlas, &presence), presence, shares }
    }
}

/// Quality of a layer in a cell.
fn quality(layer: &Layer, cell: usize) -> f32 {
    let likeness = if layer.side == Side::Mirrored { MIRRORED } else { 1.0 };
    layer.cosine[cell].max(0.0) * likeness
}

/// Limit of each layer's weight in each cell: in a feature, the layer that shows it best excludes the others.
fn allowed_in_features(layers: &[Layer], features: &[Vec<f32>]) -> Vec<Vec<f32>> {
    let mut allowed = vec![vec![1.0; AREA]; layers.len()];
    for feature in features {
        let seen = |layer: &Layer| -> f32 {
            (0..AREA).map(|cell| feature[cell] * layer.presence[cell] * quality(layer, cell)).sum()
        };
        let seen: Vec<f32> = layers.iter().map(seen).collect();
        let most = seen.iter().copied().fold(0.0, f32::max);
        let Some(best) = seen.iter().position(|seen| *seen == most) else { continue };
        let others = allowed.iter_mut().enumerate().filter(|(layer, _)| *layer != best);
        for (cell, allowed) in others.flat_map(|(_, allowed)| allowed.iter_mut().enumerate()) {
            *allowed *= 1.0 - feature[cell] * layers[best].presence[cell];
        }
    }
    allowed
}

/// Weight of each layer in each cell, 0 to 1; the sum is the cell's presence.
///
/// Within the photos' own sides, and within the mirrored ones, weights follow a power of the cosine. The own sides come
/// first, unless the mirrored ones are seen much better; the mirrored ones take the remainder.
fn layer_weights(layers: &[Layer], allowed: &[Vec<f32>], power: u32) -> Vec<Vec<f32>> {
    let mut weights = vec![vec![0.0; AREA]; layers.len()];
    let own = layers.iter().filter(|layer| layer.side == Side::Own).count();
    for cell in 0..AREA {
        let there = |layer: usize| layers[layer].presence[cell] * allowed[layer][cell];
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
            let raw_weight = |layer: usize| there(layer) * power_of(cosine(layer), power);
            let sum = group.clone().map(raw_weight).sum::<f32>();
            for layer in group {
                weights[layer][cell] = divided(raw_weight(layer), sum) * share;
            }
        }
        drop_small_weights(&mut weights, cell);
    }
    weights
}

/// Multiplies in a fixed order, so that all machines agree.
fn power_of(value: f32, power: u32) -> f32 {
    (0..power).fold(1.0, |product, _| product * value)
}

/// Drops layers whose small weights cost time without a visible effect, and rescales the others.
fn drop_small_weights(weights: &mut [Vec<f32>], cell: usize) {
    let all: f32 = weights.iter().map(|weights| weights[cell]).sum();
    let reduced = |weight: f32| (weight - MIN_SHARE * all).max(0.0);
    let sum: f32 = weights.iter().map(|weights| reduced(weights[cell])).sum();
    weights.iter_mut().for_each(|weights| weights[cell] = divided(reduced(weights[cell]), sum) * all);
}

/// Exposure ratios that match each layer to the ones before it; mirrored layers are matched only to the own sides.
fn matched(layers: &[Layer], weights: &[Vec<f32>], features: &[Vec<f32>]) -> Vec<Vec<Vec3>> {
    let mut matched: Vec<Vec<Vec3>> = Vec::with_capacity(layers.len());
    // Moving features differ between photos.
    let plain = |cell: usize| features.iter().map(|feature| 1.0 - feature[cell]).product::<f32>();
    for (index, layer) in layers.iter().enumerate() {
        let own = layers.iter().take(index).take_while(|layer| layer.side == Side::Own).count();
        if own == 0 {
            matched.push(vec![Vec3::ONE; AREA]);
            continue;
        }
        let reference = composed(&layers[..own], |layer| &layer.colours, &matched[..own], &weights[..own]);
        // Slanted and uncertain views count less.
        let seen = |cell: usize| -> f32 {
            layers[..own].iter().zip(weights).map(|(layer, weights)| weights[cell] * layer.cosine[cell]).sum()
        };
        let overlap: Vec<f32> =
            (0..AREA).map(|cell| seen(cell) * layer.presence[cell] * layer.cosine[cell] * plain(cell)).collect();
        matched.push(ratios(&layer.colours, &reference, &overlap));
    }
    matched
}

/// Weighted mean of the layers' colours.
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

/// Shares of the mesh's area by source.
fn shares(atlas: &Atlas, layers: &[Layer], weights: &[Vec<f32>]) -> Shares {
    let inside: Vec<usize> = (0..AREA).filter(|&cell| atlas.is_inside(cell)).collect();
    let sum = |side: Side| -> f64 {
        let of_side = layers.iter().zip(weights).filter(|(layer, _)| layer.side == side);
        of_side.flat_map(|(_, weights)| inside.iter().map(|&cell| f64::from(weights[cell]))).sum()
    };
    let [seen, mirrored] = [Side::Own, Side::Mirrored].map(|side| sum(side) / inside.len() as f64);
    Shares { seen, mirrored, filled: (1.0 - seen - mirrored).max(0.0) }
}

/// Extends a map beyond the mesh's rim by two cells, so that interpolation at the rim has valid neighbours.
fn extended(atlas: &Atlas, mut map: Vec<Vec3>) -> Vec<Vec3> {
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

/// The 3 × 3 cells around one.
fn around(cell: usize) -> impl Iterator<Item = usize> {
    let (row, column) = (cell / CELLS, cell % CELLS);
    let rows = row.saturating_sub(1)..=(row + 1).min(CELLS - 1);
    let columns = column.saturating_sub(1)..=(column + 1).min(CELLS - 1);
    rows.flat_map(move |row| columns.clone().map(move |column| row * CELLS + column))
}
