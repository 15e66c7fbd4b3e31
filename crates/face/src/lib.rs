//! The canonical face, and landmarks to a metric, coloured, textured model.
