/// Returns two distinct random vertices that are not in `excluded`, as the paper chooses its anchors.
///
/// The same seed gives the same pair on every platform. Uses SplitMix64; the modulo bias is negligible below 2⁴⁰
/// vertices.
///
/// # Panics
/// If fewer than two vertices remain.
pub fn random_anchors(vertex_count: usize, excluded: &[u32], seed: u64) -> [u32; 2] {
    let mut free: Vec<u32> = (0..vertex_count as u32).filter(|vertex| !excluded.contains(vertex)).collect();
    assert!(free.len() >= 2, "two anchors need two free vertices; {} remain", free.len());
    let mut state = seed;
    [(); 2].map(|()| free.swap_remove(below(free.len(), &mut state)))
}

/// A number in `0..limit`: the high half of a 128-bit product, in integer arithmetic for portability.
fn below(limit: usize, state: &mut u64) -> usize {
    ((u128::from(split_mix(state)) * limit as u128) >> 64) as usize
}

/// Steele, Lea and Flood, "Fast splittable pseudorandom number generators", 2014.
fn split_mix(state: &mut u64) -> u64 {
    *state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
    let mut bits = *state;
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    bits ^ (bits >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn generator_matches_the_published_values() {
        let mut state = 1_234_567;
        let first = [(); 3].map(|()| split_mix(&mut state));
        assert_eq!(first, [6_457_827_717_110_365_317, 3_203_168_211_198_807_973, 9_817_491_932_198_370_423]);
    }

    #[test]
    fn anchors_are_distinct_free_and_repeatable() {
        for seed in 0..2000 {
            let [a, b] = random_anchors(6, &[1, 4], seed);
            assert!(a != b && ![1, 4].contains(&a) && ![1, 4].contains(&b) && a < 6 && b < 6);
            assert_eq!(random_anchors(6, &[1, 4], seed), [a, b]);
        }
    }

    #[test]
    fn pairs_are_uniformly_distributed() {
        let mut count = [[0; 5]; 5];
        for seed in 0..20_000 {
            let [a, b] = random_anchors(5, &[], seed);
            count[a as usize][b as usize] += 1;
        }
        for (a, row) in count.iter().enumerate() {
            for (b, &times) in row.iter().enumerate() {
                assert!(if a == b { times == 0 } else { (850..1150).contains(&times) }, "{a}, {b}: {times}");
            }
        }
    }
}
