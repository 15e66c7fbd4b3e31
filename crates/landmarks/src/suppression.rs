//! Non-maximum suppression of duplicate detections.

use crate::detection::Detection;

/// Intersection over union above which two boxes belong to one face.
const MAX_OVERLAP: f32 = 0.3;

/// Merges the boxes of each face into their mean, weighted by score, with the highest score. Sorted by score.
pub(crate) fn weighted(mut rest: Vec<Detection>) -> Vec<Detection> {
    sort_by_score(&mut rest);
    let mut merged = Vec::new();
    while let Some(&best) = rest.first() {
        let (same, others): (Vec<_>, Vec<_>) = rest.iter().partition(|other| overlap(&best, other) > MAX_OVERLAP);
        // A box without area does not overlap itself.
        if same.is_empty() {
            break;
        }
        merged.push(mean(&same, best.score));
        rest = others;
    }
    merged
}

/// Retains the detection with the highest score for each face. Sorted by score.
pub(crate) fn best_only(mut rest: Vec<Detection>) -> Vec<Detection> {
    sort_by_score(&mut rest);
    let mut retained: Vec<Detection> = Vec::new();
    for detection in rest {
        if retained.iter().all(|better| overlap(better, &detection) <= MAX_OVERLAP) {
            retained.push(detection);
        }
    }
    retained
}

fn sort_by_score(detections: &mut [Detection]) {
    detections.sort_by(|a, b| b.score.total_cmp(&a.score));
}

fn mean(detections: &[Detection], score: f32) -> Detection {
    let total: f32 = detections.iter().map(|detection| detection.score).sum();
    let mean_of = |value: &dyn Fn(&Detection) -> f32| {
        detections.iter().map(|detection| value(detection) * detection.score).sum::<f32>() / total
    };
    Detection {
        score,
        min: std::array::from_fn(|axis| mean_of(&|d| d.min[axis])),
        max: std::array::from_fn(|axis| mean_of(&|d| d.max[axis])),
        keypoints: std::array::from_fn(|k| std::array::from_fn(|axis| mean_of(&|d| d.keypoints[k][axis]))),
    }
}

fn overlap(a: &Detection, b: &Detection) -> f32 {
    a.outline().overlap(&b.outline())
}
