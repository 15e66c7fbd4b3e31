use crate::areas::Area;
use crate::mirror_of;

mod table;

/// A language that names are told in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Language {
    /// English.
    #[default]
    English,
    /// Portuguese.
    Portuguese,
}

/// The landmark's name: anatomical where it has one, as in "left mouth corner", else its part of the face and its
/// number, as in "left cheek 425". No two landmarks share a name; sides are the subject's.
///
/// # Panics
/// If `landmark` is not below [`LANDMARK_COUNT`](crate::LANDMARK_COUNT).
pub fn landmark_name(landmark: u32, language: Language) -> String {
    let right = landmark.min(mirror_of(landmark));
    let anatomical = table::ANATOMICAL.iter().find(|entry| u32::from(entry.right) == right);
    let noun = anatomical.map_or_else(|| table::area_noun(Area::of(landmark)), |entry| entry.noun);
    let mut name = noun.beside(landmark, language);
    if anatomical.is_none() {
        name.push(' ');
        name.push_str(&landmark.to_string());
    }
    name
}

/// Whether the landmark has an anatomical name, so that [`landmark_name`] needs no number.
///
/// # Panics
/// If `landmark` is not below [`LANDMARK_COUNT`](crate::LANDMARK_COUNT).
pub fn has_anatomical_name(landmark: u32) -> bool {
    let right = landmark.min(mirror_of(landmark));
    table::ANATOMICAL.iter().any(|entry| u32::from(entry.right) == right)
}

/// Where something is that lies beside a landmark, by the landmark's part of the face: "near the left cheek".
///
/// # Panics
/// If `landmark` is not below [`LANDMARK_COUNT`](crate::LANDMARK_COUNT).
pub fn place_near(landmark: u32, language: Language) -> String {
    let noun = table::area_noun(Area::of(landmark));
    let near = match (language, noun.gender) {
        (Language::English, _) => "near the ",
        (Language::Portuguese, Gender::Feminine) => "perto da ",
        (Language::Portuguese, Gender::Masculine) => "perto do ",
    };
    [near, &noun.beside(landmark, language)].concat()
}

/// What a landmark or a part is called without its side.
#[derive(Debug, Clone, Copy)]
struct Noun {
    english: &'static str,
    portuguese: &'static str,
    gender: Gender,
}

/// The gender that "direito" or "direita" agrees with.
#[derive(Debug, Clone, Copy)]
enum Gender {
    Feminine,
    Masculine,
}

impl Noun {
    /// With the side that a landmark is on; none on the midline.
    fn beside(self, landmark: u32, language: Language) -> String {
        match landmark.cmp(&mirror_of(landmark)) {
            std::cmp::Ordering::Equal => self.in_language(language).to_owned(),
            std::cmp::Ordering::Less => self.on_the_right(language),
            std::cmp::Ordering::Greater => self.on_the_left(language),
        }
    }

    fn in_language(self, language: Language) -> &'static str {
        match language {
            Language::English => self.english,
            Language::Portuguese => self.portuguese,
        }
    }

    fn on_the_right(self, language: Language) -> String {
        self.with_side(language, "right ", [" direita", " direito"])
    }

    fn on_the_left(self, language: Language) -> String {
        self.with_side(language, "left ", [" esquerda", " esquerdo"])
    }

    fn with_side(self, language: Language, english: &str, [feminine, masculine]: [&str; 2]) -> String {
        match (language, self.gender) {
            (Language::English, _) => [english, self.english].concat(),
            (Language::Portuguese, Gender::Feminine) => [self.portuguese, feminine].concat(),
            (Language::Portuguese, Gender::Masculine) => [self.portuguese, masculine].concat(),
        }
    }
}
