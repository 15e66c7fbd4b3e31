//! Picture to faces: MediaPipe's face networks, run with tract.
