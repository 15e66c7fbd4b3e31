//! Each value of a setting can be chosen, is then reported as chosen, and has words in each language.

use std::collections::{BTreeMap, BTreeSet};

use rosto_export::{BaseColour, TextureSize};
use rosto_face::{LANDMARK_COUNT, Region, landmark_id, part_id};
use rosto_session::{Choice, Intent, Session};
use rosto_studio::{Expression, FaceSlider};

use crate::faces::session;

type Words = BTreeMap<String, String>;

#[test]
fn each_value_can_be_chosen() {
    for choice in Choice::ALL {
        let mut session = session();
        let values = choice.values();
        assert!(values.len() > 1 && values.iter().collect::<BTreeSet<_>>().len() == values.len(), "{choice:?}");
        for id in values.iter().chain(values.iter().rev()) {
            session.apply(chosen(choice, id).unwrap()).unwrap();
            assert_eq!(session.chosen(choice).as_deref(), Some(id.as_str()), "{choice:?}");
        }
        assert!(chosen(choice, "of-nothing").is_err());
        assert_eq!(Choice::from_id(choice.id()), Some(choice));
    }
}

#[test]
fn preferences_restore_settings() {
    for choice in Choice::ALL.into_iter().filter(|choice| *choice != Choice::Preset) {
        for id in choice.values() {
            let mut before = session();
            before.apply(chosen(choice, &id).unwrap()).unwrap();
            let mut after = Session::new(1);
            after.apply(Intent::RestorePreferences(before.preferences())).unwrap();
            assert_eq!(after.chosen(choice), Some(id), "{choice:?}");
        }
    }
}

#[test]
fn ids_have_words_in_each_language() {
    for (language, words) in languages() {
        let missing: Vec<String> = named().into_iter().filter(|key| !words.contains_key(key)).collect();
        assert!(missing.is_empty(), "web/words/{language}.json has no words for {missing:?}");
    }
}

#[test]
fn names_are_distinct_within_a_kind() {
    for (language, words) in languages() {
        for kind in ["landmark", "part", "region", "slider"] {
            let of_kind =
                words.iter().filter(|(key, _)| key.starts_with(&format!("{kind}.")) && !key.ends_with(".long"));
            let names: Vec<&String> = of_kind.map(|(_, name)| name).collect();
            let different: BTreeSet<&&String> = names.iter().collect();
            assert_eq!(different.len(), names.len(), "{kind} in {language}");
        }
    }
}

/// The intent that selects a setting's value.
fn chosen(choice: Choice, id: &str) -> serde_json::Result<Intent> {
    serde_json::from_value(serde_json::json!({ choice.id(): id }))
}

/// Keys of the words that the ids need.
fn named() -> Vec<String> {
    let chosen = Choice::ALL.into_iter().flat_map(|choice| {
        let values = choice.values().into_iter().map(move |id| format!("{}.{id}", choice.id()));
        values.chain([choice.id().to_owned()]).filter(|key| key != "preset")
    });
    let landmarks = (0..LANDMARK_COUNT as u32).map(|landmark| match landmark_id(landmark) {
        id if id.ends_with(&format!("-{landmark}")) => format!("part.{}", part_id(landmark)),
        id => format!("landmark.{id}"),
    });
    let near = (0..LANDMARK_COUNT as u32).map(|landmark| format!("near.{}", part_id(landmark)));
    let regions = Region::ALL.into_iter().map(|region| format!("region.{}", region.id()));
    let expressions = Expression::ALL.into_iter().map(|expression| format!("expression.{}", expression.id()));
    let sliders = FaceSlider::ALL.into_iter().map(|slider| format!("slider.{}", slider.id()));
    let of_files = [
        BaseColour::ALL.map(|one| format!("base-colour.{}", one.id())).to_vec(),
        TextureSize::ALL.map(|one| format!("texture-size.{}", one.id())).to_vec(),
        ["thickness", "flat", "surface"].map(|id| format!("solid.{id}")).to_vec(),
        ["40", "80", "life"].map(|id| format!("print.height.{id}")).to_vec(),
    ]
    .concat();
    let of_face = landmarks.chain(near).chain(regions).chain(sliders).chain(expressions);
    chosen.chain(of_face).chain(of_files).collect()
}

/// The page's languages, with their words.
fn languages() -> Vec<(String, Words)> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../web/words");
    let read = |name: &str| std::fs::read_to_string(format!("{folder}/{name}.json")).unwrap();
    let listed: Vec<serde_json::Value> = serde_json::from_str(&read("languages")).unwrap();
    let ids = listed.iter().map(|language| language["id"].as_str().unwrap().to_owned());
    let all: Vec<(String, Words)> = ids.map(|id| (id.clone(), serde_json::from_str(&read(&id)).unwrap())).collect();
    assert!(all.len() > 1);
    all
}
