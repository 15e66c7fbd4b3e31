use std::collections::VecDeque;

use rosto::{Observation, Photo};

use crate::error::{self, Result};

/// Number of files whose pictures are kept.
const MAX_FILES: usize = 6;

/// Pictures of the files used last.
#[derive(Default)]
pub(crate) struct Pictures {
    /// Keys and pictures of files, in the order of their last use.
    files: VecDeque<(String, Vec<Photo>)>,
}

impl Pictures {
    /// Keeps the pictures of a file, and drops those of the file used longest ago. Returns the pictures' names:
    /// `KEY/0`, `KEY/1`, …
    pub fn keep(&mut self, key: &str, pictures: Vec<Photo>) -> Vec<String> {
        let names = (0..pictures.len()).map(|index| format!("{key}/{index}")).collect();
        self.files.retain(|(other, _)| other != key);
        self.files.push_back((key.to_owned(), pictures));
        if self.files.len() > MAX_FILES {
            self.files.pop_front();
        }
        names
    }

    /// Whether a picture is kept.
    pub fn has(&self, name: &str) -> bool {
        self.place(name).is_some()
    }

    /// A picture, by its name.
    ///
    /// # Errors
    /// Throws `internal` if it is not kept.
    pub fn get(&mut self, name: &str) -> Result<Photo> {
        let place = self.place(name).and_then(|(file, index)| Some((self.files.remove(file)?, index)));
        let (file, index) = place.ok_or_else(|| error::internal(&format!("no picture {name}")))?;
        let picture = file.1[index].clone();
        self.files.push_back(file);
        Ok(picture)
    }

    /// Gives photos their pictures, in order.
    ///
    /// # Errors
    /// Throws `internal` if a picture is not kept or the numbers differ.
    pub fn give(&mut self, names: &[String], photos: &mut [Observation]) -> Result<()> {
        if names.len() != photos.len() {
            return Err(error::internal(&format!("{} pictures for {} photos", names.len(), photos.len())));
        }
        for (name, photo) in names.iter().zip(photos) {
            photo.picture = Some(self.get(name)?);
        }
        Ok(())
    }

    /// File and index of a picture.
    fn place(&self, name: &str) -> Option<(usize, usize)> {
        let (key, index) = name.rsplit_once('/')?;
        let index = index.parse().ok()?;
        let file = self.files.iter().position(|(other, pictures)| other == key && index < pictures.len())?;
        Some((file, index))
    }
}
