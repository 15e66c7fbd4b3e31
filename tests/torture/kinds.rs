//! What is tortured: for every kind of input its seeds, its share of all inputs, and its real reader.

use crate::anatomy::Format;
use crate::readers;
use crate::seeds::Seeds;

/// A kind of input.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    Jpeg,
    Png,
    WebP,
    Icc,
    Glb,
    Project,
    Edits,
    Detector,
    Landmarks,
}

/// What a reader made of an input.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Verdict {
    Accepted,
    Refused,
    /// It was read, but what came out is not what its documentation promises.
    Broken(String),
}

impl Kind {
    pub const ALL: [Self; 9] = [
        Self::Jpeg,
        Self::Png,
        Self::WebP,
        Self::Icc,
        Self::Glb,
        Self::Project,
        Self::Edits,
        Self::Detector,
        Self::Landmarks,
    ];

    pub fn name(self) -> &'static str {
        match self {
            Self::Jpeg => "jpeg",
            Self::Png => "png",
            Self::WebP => "webp",
            Self::Icc => "icc",
            Self::Glb => "glb",
            Self::Project => "project",
            Self::Edits => "edits",
            Self::Detector => "detector",
            Self::Landmarks => "landmarks",
        }
    }

    /// Its share of a hundred thousand inputs: the slower the reader, the smaller.
    pub fn share(self) -> u64 {
        match self {
            Self::Jpeg => 25_000,
            Self::Png => 30_000,
            Self::WebP => 23_000,
            Self::Icc => 12_000,
            Self::Glb => 2_496,
            Self::Project => 2_500,
            Self::Edits => 5_000,
            Self::Detector | Self::Landmarks => 2,
        }
    }

    pub fn format(self) -> Format {
        match self {
            Self::Jpeg => Format::Jpeg,
            Self::Png => Format::Png,
            Self::WebP => Format::WebP,
            Self::Icc => Format::Icc,
            Self::Glb => Format::Glb,
            Self::Project => Format::Project,
            Self::Edits => Format::Json,
            Self::Detector | Self::Landmarks => Format::Plain,
        }
    }

    /// Valid inputs; none for networks that are not there.
    pub fn seeds(self, seeds: &Seeds) -> &[Vec<u8>] {
        let networks = seeds.networks.as_ref();
        match self {
            Self::Jpeg => &seeds.jpegs,
            Self::Png => &seeds.pngs,
            Self::WebP => &seeds.webps,
            Self::Icc => &seeds.profiles,
            Self::Glb => &seeds.glbs,
            Self::Project => &seeds.projects,
            Self::Edits => &seeds.histories,
            Self::Detector => networks.map_or(&[], |networks| std::slice::from_ref(&networks.detector)),
            Self::Landmarks => networks.map_or(&[], |networks| std::slice::from_ref(&networks.landmarks)),
        }
    }

    /// How many mutations an input gets, at most.
    pub fn most_mutations(self) -> usize {
        match self {
            // A network is large, and its reader looks at little of it.
            Self::Detector | Self::Landmarks => 400,
            _ => 8,
        }
    }

    /// Gives the input to whatever reads it in the program.
    pub fn read(self, bytes: &[u8], seeds: &Seeds) -> Verdict {
        match (self, &seeds.networks) {
            (Self::Jpeg | Self::Png | Self::WebP, _) => readers::picture(bytes),
            (Self::Icc, _) => readers::profile(bytes, seeds),
            (Self::Glb, _) => readers::glb(bytes),
            (Self::Project, _) => readers::project(bytes),
            (Self::Edits, _) => readers::edits(bytes),
            (Self::Detector, Some(networks)) => readers::networks(bytes, &networks.landmarks, &networks.portrait),
            (Self::Landmarks, Some(networks)) => readers::networks(&networks.detector, bytes, &networks.portrait),
            (Self::Detector | Self::Landmarks, None) => Verdict::Refused,
        }
    }
}
