//! What reading one input costs, and how it goes wrong: time, memory, a panic and where it came from.

use std::alloc::{GlobalAlloc, Layout, System};
use std::backtrace::Backtrace;
use std::cell::{Cell, RefCell};
use std::collections::HashSet;
use std::panic::{self, AssertUnwindSafe, PanicHookInfo};
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// What came of running something.
pub struct Observed<T> {
    pub outcome: Result<T, Panic>,
    pub took: Duration,
    /// The most memory that it held at a time, in bytes.
    pub peak_bytes: usize,
}

/// A panic that was caught.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Panic {
    pub message: String,
    pub place: String,
    /// Only of the first few at a place: it takes long to find.
    pub stack: String,
}

/// Runs something on this thread.
pub fn observe<T>(action: impl FnOnce() -> T) -> Observed<T> {
    let before = HELD.get();
    MOST_HELD.set(before);
    let started = Instant::now();
    let outcome = panic::catch_unwind(AssertUnwindSafe(action)).map_err(|_| LAST_PANIC.take().unwrap_or(UNKNOWN));
    Observed { outcome, took: started.elapsed(), peak_bytes: (MOST_HELD.get() - before).max(0) as usize }
}

/// From now on, panics are kept for [`observe`] in place of being printed.
pub fn keep_panics() {
    panic::set_hook(Box::new(|info| LAST_PANIC.set(Some(Panic::of(info)))));
}

const UNKNOWN: Panic = Panic { message: String::new(), place: String::new(), stack: String::new() };

thread_local! {
    static HELD: Cell<isize> = const { Cell::new(0) };
    static MOST_HELD: Cell<isize> = const { Cell::new(0) };
    static LAST_PANIC: RefCell<Option<Panic>> = const { RefCell::new(None) };
}

static PLACES_WITH_STACK: Mutex<Option<HashSet<String>>> = Mutex::new(None);

impl Panic {
    fn of(info: &PanicHookInfo<'_>) -> Self {
        let place = info.location().map_or_else(String::new, ToString::to_string);
        let message = info.payload_as_str().unwrap_or("a panic without words").to_owned();
        let is_new =
            PLACES_WITH_STACK.lock().is_ok_and(|mut places| places.get_or_insert_default().insert(place.clone()));
        let stack = if is_new { Backtrace::force_capture().to_string() } else { String::new() };
        Self { message, place, stack }
    }
}

struct Counting;

#[global_allocator]
static ALLOCATOR: Counting = Counting;

fn count(more: isize) {
    let held = HELD.get() + more;
    HELD.set(held);
    MOST_HELD.set(MOST_HELD.get().max(held));
}

// SAFETY: every call is handed on to the system's allocator as it came.
#[expect(unsafe_code, reason = "an allocator that counts has to be an allocator")]
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count(layout.size() as isize);
        unsafe { System.alloc(layout) }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        count(layout.size() as isize);
        unsafe { System.alloc_zeroed(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        count(-(layout.size() as isize));
        unsafe { System.dealloc(pointer, layout) }
    }

    unsafe fn realloc(&self, pointer: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        count(size as isize - layout.size() as isize);
        unsafe { System.realloc(pointer, layout, size) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn memory_that_was_given_back_counts_too() {
        let seen = observe(|| drop(std::hint::black_box(vec![0_u8; 5_000_000])));
        assert!((5_000_000..5_100_000).contains(&seen.peak_bytes), "{}", seen.peak_bytes);
        assert!(observe(|| 1 + 1).peak_bytes < 1000);
    }

    #[test]
    fn a_panic_is_caught_with_its_place() {
        keep_panics();
        let seen = observe(|| -> u8 { panic!("no {}", "way") });
        let panic = seen.outcome.unwrap_err();
        assert_eq!(panic.message, "no way");
        assert!(panic.place.contains("watch.rs:") && panic.stack.contains("watch"), "{}", panic.place);
    }
}
