//! δ-coordinates: operators, constraints, factorisation, response fields, distortion.
