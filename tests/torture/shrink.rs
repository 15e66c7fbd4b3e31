//! Less of what fails: Zeller and Hildebrandt's ddmin.

use std::time::Instant;

/// A part of `items` that still fails, and no longer fails when any one item more is left out; as far as it got by
/// `until`.
pub fn ddmin<T: Clone>(mut items: Vec<T>, until: Instant, fails: impl Fn(&[T]) -> bool) -> Vec<T> {
    let mut parts = 2;
    while items.len() > 1 && Instant::now() < until {
        let size = items.len().div_ceil(parts);
        let starts = (0..items.len()).step_by(size).take_while(|_| Instant::now() < until);
        let without = |start: usize| [&items[..start], &items[items.len().min(start + size)..]].concat();
        let smaller = starts.map(without).find(|rest| fails(rest));
        match smaller {
            Some(rest) => {
                items = rest;
                parts = (parts - 1).max(2);
            }
            None if size == 1 => break,
            None => parts = (2 * parts).min(items.len()),
        }
    }
    items
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::*;

    fn later() -> Instant {
        Instant::now() + Duration::from_secs(60)
    }

    #[test]
    fn what_fails_together_is_all_that_is_left() {
        let fails = |items: &[u32]| [3, 57, 58].iter().all(|item| items.contains(item));
        assert_eq!(ddmin((0..400).collect(), later(), fails), [3, 57, 58]);
        assert_eq!(ddmin((0..9).collect(), later(), |items| items.contains(&8)), [8]);
    }

    #[test]
    fn one_item_stays_even_where_none_is_needed() {
        assert_eq!(ddmin(vec![1, 2, 3], later(), |_| true).len(), 1);
    }

    #[test]
    fn it_ends_in_time_with_what_it_has() {
        let started = Instant::now();
        let slow = |items: &[u32]| {
            std::thread::sleep(Duration::from_millis(5));
            items.len() == 1_000_000
        };
        assert_eq!(ddmin((0..1_000_000).collect(), started + Duration::from_millis(50), slow).len(), 1_000_000);
        assert!(started.elapsed() < Duration::from_secs(10));
    }
}
