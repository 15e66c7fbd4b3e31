use glam::{DVec2, DVec3};
use rosto_mesh::Topology;
use rosto_photo::Photo;

use crate::{Eye, Shot, Subject, Texture, TextureError, texture};

/// Inputs of a texture without the pixels: a [`Subject`] and the viewpoints of its photos. A plan owns its data and can
/// be sent as bytes, to bake the texture in another process.
///
/// Numbers are rounded to single precision, so that differences in a mesh's last digits between machines do not change
/// the texture.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    topology: Topology,
    positions: Vec<DVec3>,
    atlas_uvs: Vec<DVec2>,
    partners: Vec<u32>,
    features: Vec<Vec<u32>>,
    /// Texture coordinates in each photo, and its viewpoint.
    shots: Vec<(Vec<DVec2>, Eye)>,
}

impl Plan {
    /// Creates a plan without photos.
    pub fn new(subject: &Subject<'_>) -> Self {
        Self {
            topology: subject.topology.clone(),
            positions: subject.positions.iter().copied().map(rounded).collect(),
            atlas_uvs: rounded_uvs(subject.atlas_uvs),
            partners: subject.partners.to_vec(),
            features: subject.features.to_vec(),
            shots: Vec::new(),
        }
    }

    /// Adds a photo: texture coordinates of each vertex in it, 0..=1 from its top left, and its viewpoint.
    pub fn add(&mut self, uvs: &[DVec2], eye: Eye) {
        let eye = match eye {
            Eye::At(position) => Eye::At(rounded(position)),
            Eye::Towards(direction) => Eye::Towards(rounded(direction)),
        };
        self.shots.push((rounded_uvs(uvs), eye));
    }

    /// Bakes the texture from the photos' upright pictures, in the order in which the photos were added.
    ///
    /// # Errors
    /// See [`texture`]. Also [`TextureError::ShotCount`] if the numbers of pictures and photos differ.
    pub fn texture(&self, pictures: &[&Photo], side_px: u32) -> Result<Texture, TextureError> {
        if pictures.len() != self.shots.len() {
            return Err(TextureError::ShotCount { found: pictures.len() });
        }
        let subject = Subject {
            topology: &self.topology,
            positions: &self.positions,
            atlas_uvs: &self.atlas_uvs,
            partners: &self.partners,
            features: &self.features,
        };
        let shots = pictures.iter().zip(&self.shots);
        let shots: Vec<Shot<'_>> = shots.map(|(picture, (uvs, eye))| Shot { picture, uvs, eye: *eye }).collect();
        texture(&subject, &shots, side_px)
    }

    /// Serialises the plan for [`Self::from_bytes`] of the same version of this crate.
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut bytes = Vec::new();
        push_indices(&mut bytes, self.topology.triangles().as_flattened());
        push_numbers(&mut bytes, self.positions.iter().flat_map(|position| position.to_array()));
        push_numbers(&mut bytes, self.atlas_uvs.iter().flat_map(|uv| uv.to_array()));
        push_indices(&mut bytes, &self.partners);
        push_count(&mut bytes, self.features.len());
        self.features.iter().for_each(|feature| push_indices(&mut bytes, feature));
        push_count(&mut bytes, self.shots.len());
        for (uvs, eye) in &self.shots {
            let (is_near, eye) = match eye {
                Eye::At(position) => (true, position),
                Eye::Towards(direction) => (false, direction),
            };
            push_count(&mut bytes, is_near.into());
            push_numbers(&mut bytes, eye.to_array());
            push_numbers(&mut bytes, uvs.iter().flat_map(|uv| uv.to_array()));
        }
        bytes
    }

    /// Reads the bytes of [`Self::to_bytes`]; `None` if they are invalid.
    pub fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let mut rest = Reader(bytes);
        let triangles = rest.indices()?.as_chunks::<3>().0.to_vec();
        let positions: Vec<DVec3> =
            rest.numbers()?.as_chunks().0.iter().map(|&position| DVec3::from_array(position)).collect();
        let atlas_uvs = rest.pairs()?;
        let partners = rest.indices()?;
        let features = (0..rest.count()?).map(|_| rest.indices()).collect::<Option<_>>()?;
        let shots = (0..rest.count()?).map(|_| rest.shot()).collect::<Option<_>>()?;
        let topology = Topology::new(positions.len(), triangles).ok()?;
        rest.0.is_empty().then_some(Self { topology, positions, atlas_uvs, partners, features, shots })
    }
}

fn rounded(position: DVec3) -> DVec3 {
    position.as_vec3().as_dvec3()
}

fn rounded_uvs(uvs: &[DVec2]) -> Vec<DVec2> {
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

/// The unread bytes.
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
            features: &[vec![1, 3]],
        };
        let mut plan = Plan::new(&subject);
        plan.add(&flat, Eye::Towards(DVec3::Z));
        plan.add(&flat.map(|uv| uv * 0.5), Eye::At(DVec3::new(0.0, 0.1, 2.0)));
        plan
    }

    #[test]
    fn plans_survive_a_round_trip() {
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
    fn truncated_and_extended_bytes_are_refused() {
        let bytes = plan().to_bytes();
        assert!((0..bytes.len()).all(|length| Plan::from_bytes(&bytes[..length]).is_none()));
        assert!(Plan::from_bytes(&[&bytes[..], &[0]].concat()).is_none());
    }
}
