use glam::DVec2;
use rosto::MAX_DABS;
use rosto_warp::Dab;

/// Minimum distance between dabs, as a share of their radius.
const MIN_SPACING: f64 = 0.3;

/// Brush strokes; each is undone as a whole.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Strokes {
    done: Vec<Vec<Dab>>,
    undone: Vec<Vec<Dab>>,
}

impl Strokes {
    pub(crate) fn new(done: Vec<Vec<Dab>>) -> Self {
        Self { done, undone: Vec::new() }
    }

    /// The strokes, each as dabs in painting order.
    pub(crate) fn done(&self) -> &[Vec<Dab>] {
        &self.done
    }

    /// The dabs, in painting order.
    pub fn dabs(&self) -> impl Iterator<Item = &Dab> {
        self.done.iter().flatten()
    }

    /// Number of strokes.
    pub fn count(&self) -> usize {
        self.done.len()
    }

    /// Whether there is an undone stroke to redo.
    pub fn can_redo(&self) -> bool {
        !self.undone.is_empty()
    }

    pub(crate) fn begin(&mut self, dab: Dab) {
        self.undone.clear();
        self.done.push(vec![dab]);
    }

    /// Continues the last stroke with evenly spaced dabs.
    pub(crate) fn extend(&mut self, to_px: DVec2) {
        let is_full = self.dabs().count() >= MAX_DABS;
        let Some(stroke) = self.done.last_mut().filter(|_| !is_full) else { return };
        let Some(&last) = stroke.last() else { return };
        let delta_px = to_px - last.centre_px;
        let steps = (delta_px.length() / (MIN_SPACING * last.radius_px)).floor().min(100.0) as u32;
        stroke.extend((1..=steps).map(|step| {
            let centre_px = last.centre_px + delta_px * (f64::from(step) / f64::from(steps));
            Dab { centre_px, ..last }
        }));
    }

    pub(crate) fn undo(&mut self) {
        self.undone.extend(self.done.pop());
    }

    pub(crate) fn redo(&mut self) {
        self.done.extend(self.undone.pop());
    }

    /// Removes all strokes; redo restores them one by one.
    pub(crate) fn clear(&mut self) {
        self.undone.extend(self.done.drain(..).rev());
    }
}
