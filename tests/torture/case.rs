//! Inputs by number: the same seed, kind and number give the same bytes everywhere.

use std::time::Instant;

use crate::anatomy::{Format, png_in};
use crate::kinds::Kind;
use crate::mutations::Mutation;
use crate::seeded::Seeded;
use crate::seeds::{Seeds, with_checksums};
use crate::shrink::ddmin;

/// One input: a seed and what is done to it.
#[derive(Debug, Clone)]
pub struct Case {
    pub kind: Kind,
    pub number: u64,
    seed: usize,
    mutations: Vec<Mutation>,
    /// Whether checksums are put right afterwards.
    repaired: bool,
}

impl Case {
    /// The kind's input of that number.
    pub fn new(run: u64, kind: Kind, number: u64, seeds: &Seeds) -> Self {
        let stream = run ^ number.wrapping_mul(0xD134_2543_DE82_EF95) ^ (kind as u64) << 56;
        let mut random = Seeded::new(stream);
        let seed = random.below(kind.seeds(seeds).len().max(1));
        // Few changes go deep, many go wide.
        let most = 1 + random.below(kind.most_mutations());
        let count = 1 + random.below(most);
        // What is in a network is mostly weights, which are only seen in one that can still be read.
        let in_place = kind.format() == Format::Plain && random.below(2) == 0;
        let mutation = |random: &mut Seeded| {
            if in_place { Mutation::of_a_byte(random) } else { Mutation::random(random, kind.format()) }
        };
        let mutations = (0..count).map(|_| mutation(&mut random)).collect();
        Self { kind, number, seed, mutations, repaired: random.below(4) != 0 }
    }

    pub fn bytes(&self, seeds: &Seeds) -> Vec<u8> {
        let all = self.kind.seeds(seeds);
        let mut bytes = all[self.seed].clone();
        for mutation in &self.mutations {
            mutation.apply(&mut bytes, self.kind.format(), all);
        }
        if let Some(start) = png_in(self.kind.format(), &bytes).filter(|_| self.repaired) {
            with_checksums(&mut bytes[start..]);
        }
        bytes
    }

    /// The same with as few mutations as still fail.
    pub fn shrunk(&self, until: Instant, fails: impl Fn(&Self) -> bool) -> Self {
        let with = |mutations: Vec<Mutation>| Self { mutations, ..self.clone() };
        with(ddmin(self.mutations.clone(), until, |mutations| fails(&with(mutations.to_vec()))))
    }

    /// For the reader of a report.
    pub fn describe(&self) -> String {
        let lines: String = self.mutations.iter().map(|mutation| format!("  {mutation:?}\n")).collect();
        let repaired = if self.repaired { "  checksums put right\n" } else { "" };
        format!("{} {} from seed {}\n{lines}{repaired}", self.kind.name(), self.number, self.seed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::findings::Failure;
    use crate::kinds::Verdict;
    use crate::watch::observe;

    fn seeds() -> Seeds {
        Seeds::new(std::path::Path::new(""))
    }

    fn readable() -> impl Iterator<Item = Kind> {
        Kind::ALL.into_iter().filter(|kind| !matches!(kind, Kind::Detector | Kind::Landmarks))
    }

    #[test]
    fn every_seed_is_accepted_by_its_reader() {
        let seeds = seeds();
        for kind in readable() {
            assert!(!kind.seeds(&seeds).is_empty());
            for (which, seed) in kind.seeds(&seeds).iter().enumerate() {
                assert_eq!(kind.read(seed, &seeds), Verdict::Accepted, "{} {which}", kind.name());
            }
        }
    }

    #[test]
    fn what_was_once_found_is_found_no_more() {
        let seeds = seeds();
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/torture/found");
        let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
        let inputs = files.filter(|path| path.extension().is_none_or(|extension| extension != "md"));
        let mut found = Vec::new();
        for path in inputs {
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            let kind = Kind::ALL.into_iter().find(|kind| name.split('-').next() == Some(kind.name())).unwrap();
            let bytes = std::fs::read(&path).unwrap();
            let seen = observe(|| kind.read(&bytes, &seeds));
            found.extend(Failure::of(kind, &bytes, &seeds, &seen).map(|failure| format!("{name}: {}", failure.cause)));
        }
        assert!(found.is_empty(), "{found:#?}");
    }

    #[test]
    fn the_same_number_gives_the_same_bytes_and_another_number_others() {
        let seeds = seeds();
        let bytes = |run, kind, number| Case::new(run, kind, number, &seeds).bytes(&seeds);
        for kind in readable() {
            assert_eq!(bytes(3, kind, 17), bytes(3, kind, 17));
            let different: std::collections::HashSet<_> = (0..64).map(|number| bytes(3, kind, number)).collect();
            assert!(different.len() > 50, "{}: {}", kind.name(), different.len());
            assert!((0..8).any(|number| bytes(4, kind, number) != bytes(3, kind, number)));
        }
    }

    #[test]
    fn some_inputs_are_accepted_and_some_refused_and_none_breaks_a_promise() {
        let seeds = seeds();
        for kind in readable() {
            let read = |number| kind.read(&Case::new(1, kind, number, &seeds).bytes(&seeds), &seeds);
            let verdicts: Vec<Verdict> = (0..300).map(read).collect();
            assert!(verdicts.contains(&Verdict::Accepted), "{}", kind.name());
            assert!(kind == Kind::Icc || verdicts.contains(&Verdict::Refused), "{}", kind.name());
            let broken = verdicts.iter().find(|verdict| matches!(verdict, Verdict::Broken(_)));
            assert_eq!(broken, None, "{}", kind.name());
        }
    }
}
