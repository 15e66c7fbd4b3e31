use glam::{DVec2, DVec3};
use rosto_mesh::Topology;
use rosto_photo::Photo;

use crate::{Eye, Shot, Subject, Texture, TextureError, texture};

/// All that a texture is made of but for the pixels: a [`Subject`], and where its photos were taken from. It owns what it
/// holds and can be handed on as bytes, so that a texture can be made elsewhere than where the mesh is.
///
/// Numbers are cut to single precision: what machines round differently in the last place of a mesh is to make no other
/// texture.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    topology: Topology,
    positions: Vec<DVec3>,
    atlas_uvs: Vec<DVec2>,
    partners: Vec<u32>,
    wholes: Vec<Vec<u32>>,
    /// Where each vertex is seen in each photo, and where it was taken from.
    shots: Vec<(Vec<DVec2>, Eye)>,
}

impl Plan {
    /// A plan for a mesh that no photo has been given of yet.
    pub fn new(subject: &Subject<'_>) -> Self {
        Self {
            topology: subject.topology.clone(),
            positions: subject.positions.iter().copied().map(cut).collect(),
            atlas_uvs: cut_uvs(subject.atlas_uvs),
            partners: subject.partners.to_vec(),
            wholes: subject.wholes.to_vec(),
            shots: Vec::new(),
        }
    }

    /// Adds a photo by where each vertex is seen in it, 0..=1 from its top left, and by where it was taken from.
    pub fn add(&mut self, uvs: &[DVec2], eye: Eye) {
        let eye = match eye {
            Eye::At(place) => Eye::At(cut(place)),
            Eye::Towards(direction) => Eye::Towards(cut(direction)),
        };
        self.shots.push((cut_uvs(uvs), eye));
    }

    /// Makes the texture of the photos' upright pictures, in the order in which they were added.
    ///
    /// # Errors
    /// As [`texture`]; [`TextureError::ShotCount`] as well if there is not one picture for each photo.
    pub fn texture(&self, pictures: &[&Photo], side_px: u32) -> Result<Texture, TextureError> {
        if pictures.len() != self.shots.len() {
            return Err(TextureError::ShotCount { found: pictures.len() });
        }
        let subject = Subject {
            topology: &self.topology,
            positions: &self.positions,
            atlas_uvs: &self.atlas_uvs,
            partners: &self.partners,
            wholes: &self.wholes,
        };
        let shots = pictures.iter().zip(&self.shots);
        let shots: Vec<Shot<'_>> = shots.map(|(picture, (uvs, eye))| Shot { picture, uvs, eye: *eye }).collect();
        texture(&subject, &shots, side_px)
    }

    /// The plan as bytes, for [`Self::from_bytes`] of the same version of this crate.
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut bytes = Vec::new();
        push_indices(&mut bytes, self.topology.triangles().as_flattened());
        push_numbers(&mut bytes, self.positions.iter().flat_map(|place| place.to_array()));
        push_numbers(&mut bytes, self.atlas_uvs.iter().flat_map(|uv| uv.to_array()));
        push_indices(&mut bytes, &self.partners);
        push_count(&mut bytes, self.wholes.len());
        self.wholes.iter().for_each(|whole| push_indices(&mut bytes, whole));
        push_count(&mut bytes, self.shots.len());
        for (uvs, eye) in &self.shots {
            let (is_near, eye) = match eye {
                Eye::At(place) => (true, place),
                Eye::Towards(direction) => (false, direction),
            };
            push_count(&mut bytes, is_near.into());
            push_numbers(&mut bytes, eye.to_array());
            push_numbers(&mut bytes, uvs.iter().flat_map(|uv| uv.to_array()));
        }
        bytes
    }

    /// Reads what [`Self::to_bytes`] wrote; none for anything else.
    pub fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let mut rest = Reader(bytes);
        let triangles = rest.indices()?.as_chunks::<3>().0.to_vec();
        let positions: Vec<DVec3> =
            rest.numbers()?.as_chunks().0.iter().map(|&place| DVec3::from_array(place)).collect();
        let atlas_uvs = rest.pairs()?;
        let partners = rest.indices()?;
        let wholes = (0..rest.count()?).map(|_| rest.indices()).collect::<Option<_>>()?;
        let shots = (0..rest.count()?).map(|_| rest.shot()).collect::<Option<_>>()?;
        let topology = Topology::new(positions.len(), triangles).ok()?;
        rest.0.is_empty().then_some(Self { topology, positions, atlas_uvs, partners, wholes, shots })
    }
}

fn cut(place: DVec3) -> DVec3 {
    place.as_vec3().as_dvec3()
}

fn cut_uvs(uvs: &[DVec2]) -> Vec<DVec2> {
    uvs.iter().map(|uv| uv.as_vec2().as_dvec2()).collect()
}

fn push_count(bytes: &mut Vec<u8>, count: usize) {
    bytes.extend((count as u32).to_le_bytes());
}

fn push_indices(bytes: &mut Vec<u8>, indices: &[u32]) {
    push_count(bytes, indices.len());
    bytes.extend(indices.iter().flat_map(|index| index.to_le_bytes()));
}

fn push_numbers(bytes: &mut Vec<u8>, numbers: impl IntoIterator<Item = f64>) {
    let numbers: Vec<u8> = numbers.into_iter().flat_map(|number| (number as f32).to_le_bytes()).collect();
    push_count(bytes, numbers.len() / size_of::<f32>());
    bytes.extend(numbers);
}

/// What is left to be read.
struct Reader<'a>(&'a [u8]);

impl<'a> Reader<'a> {
    fn count(&mut self) -> Option<usize> {
        let (count, rest) = self.0.split_first_chunk()?;
        self.0 = rest;
        usize::try_from(u32::from_le_bytes(*count)).ok()
    }

    fn words(&mut self) -> Option<&'a [[u8; 4]]> {
        let count = self.count()?;
        let (words, rest) = self.0.split_at_checked(count.checked_mul(4)?)?;
        self.0 = rest;
        Some(words.as_chunks().0)
    }

    fn indices(&mut self) -> Option<Vec<u32>> {
        Some(self.words()?.iter().map(|&word| u32::from_le_bytes(word)).collect())
    }

    fn numbers(&mut self) -> Option<Vec<f64>> {
        Some(self.words()?.iter().map(|&word| f32::from_le_bytes(word).into()).collect())
    }

    fn pairs(&mut self) -> Option<Vec<DVec2>> {
        Some(self.numbers()?.as_chunks().0.iter().map(|&pair| DVec2::from_array(pair)).collect())
    }

    fn shot(&mut self) -> Option<(Vec<DVec2>, Eye)> {
        let is_near = self.count()? != 0;
        let eye = DVec3::from_array(*self.numbers()?.first_chunk()?);
        Some((self.pairs()?, if is_near { Eye::At(eye) } else { Eye::Towards(eye) }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plan() -> Plan {
        let topology = Topology::new(4, vec![[0, 2, 1], [2, 3, 1]]).unwrap();
        let flat = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]].map(DVec2::from);
        let positions = flat.map(|uv| DVec3::new(uv.x, -uv.y, 0.1));
        let subject = Subject {
            topology: &topology,
            positions: &positions,
            atlas_uvs: &flat,
            partners: &[0, 1, 2, 3],
            wholes: &[vec![1, 3]],
        };
        let mut plan = Plan::new(&subject);
        plan.add(&flat, Eye::Towards(DVec3::Z));
        plan.add(&flat.map(|uv| uv * 0.5), Eye::At(DVec3::new(0.0, 0.1, 2.0)));
        plan
    }

    #[test]
    fn there_and_back_it_is_the_same_and_makes_the_same() {
        let (plan, bytes) = (plan(), plan().to_bytes());
        let read = Plan::from_bytes(&bytes).unwrap();
        assert_eq!(read, plan);
        let pixels = (0..64 * 64 * 3).map(|at| (at * 7 % 251) as u8).collect();
        let picture = Photo::from_rgb(64, 64, pixels).unwrap();
        let made = plan.texture(&[&picture, &picture], 256).unwrap();
        assert_eq!(read.texture(&[&picture, &picture], 256).unwrap(), made);
        assert_eq!(plan.texture(&[&picture], 256), Err(TextureError::ShotCount { found: 1 }));
    }

    #[test]
    fn what_is_cut_short_or_too_long_is_none() {
        let bytes = plan().to_bytes();
        assert!((0..bytes.len()).all(|length| Plan::from_bytes(&bytes[..length]).is_none()));
        assert!(Plan::from_bytes(&[&bytes[..], &[0]].concat()).is_none());
    }
}
