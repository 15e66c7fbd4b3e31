use rosto_laplacian::ConstraintKind;

use crate::{AnchorKind, EditSpec, RegionOfInfluence};

/// A spec as a key of hash tables: its numbers bit by bit.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(crate) struct SpecKey(Vec<u64>);

impl SpecKey {
    pub(crate) fn of(spec: &EditSpec) -> Self {
        let settings = &spec.settings;
        let constraint = match settings.constraint {
            ConstraintKind::Hard => [0, 0],
            ConstraintKind::Soft { weight } => [1, weight.to_bits()],
        };
        let anchors = match settings.anchors.kind {
            AnchorKind::PinsOnly => [0, 0],
            AnchorKind::Oval => [1, 0],
            AnchorKind::Random { seed } => [2, seed],
            AnchorKind::Outside { radius } => [3, radius.to_bits()],
        };
        let influence = match settings.influence {
            RegionOfInfluence::Whole => [0, 0],
            RegionOfInfluence::Within { radius } => [1, radius.to_bits()],
        };
        let named = [settings.operator as u64, settings.mirror as u64, settings.details as u64];
        let lengths = [u64::from(spec.level), spec.handles.len() as u64];
        let vertices = spec.handles.iter().chain(&settings.anchors.pins).map(|&vertex| u64::from(vertex));
        Self([constraint, anchors, influence, lengths].concat().into_iter().chain(named).chain(vertices).collect())
    }
}
