//! One pure function for each file format: model to bytes.
