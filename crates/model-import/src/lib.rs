//! The published TFLite networks to the ONNX files the app serves.
