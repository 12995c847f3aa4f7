//! JSON values that a plugin walks through, and the host's table, which holds the functions for it.
#![allow(unsafe_code)]

use crate::abi::guard::guard;
use crate::abi::string::{Terminated, c_bytes};
use crate::abi::{
    PLANFORM_ABI_MAJOR, PLANFORM_ABI_MINOR, PLANFORM_ARRAY, PLANFORM_FLAG, PLANFORM_LOG_WARNING,
    PLANFORM_NOTHING, PLANFORM_NUMBER, PLANFORM_OBJECT, PLANFORM_TEXT, PlanformHost, PlanformString,
    PlanformValue,
};
use std::cell::RefCell;
use std::ffi::c_char;
use std::ptr;

/// A message that a plugin logs: whether it is a warning, and what it says.
pub type Log = (bool, String);

thread_local! {
    /// What was logged on this thread since it was last asked for.
    static LOGGED: RefCell<Vec<Log>> = const { RefCell::new(Vec::new()) };
}

/// The most messages that are kept: a plugin may not fill the memory with them.
const MAX_LOGGED: usize = 1000;

/// Takes what plugins logged on this thread since this was last called.
pub fn logged() -> Vec<Log> {
    LOGGED.take()
}

/// What a plugin sees as a [`PlanformValue`].
pub enum Content {
    Nothing,
    Flag(bool),
    Number(f64),
    Text(Terminated),
    Array(Vec<Content>),
    Object(Vec<(String, Content)>),
}

impl From<serde_json::Value> for Content {
    fn from(value: serde_json::Value) -> Self {
        use serde_json::Value;
        match value {
            Value::Null => Self::Nothing,
            Value::Bool(v) => Self::Flag(v),
            Value::Number(v) => v.as_f64().map_or(Self::Nothing, Self::Number),
            Value::String(v) => Self::Text(Terminated::new(v)),
            Value::Array(v) => Self::Array(v.into_iter().map(Self::from).collect()),
            Value::Object(v) => Self::Object(v.into_iter().map(|(k, v)| (k, v.into())).collect()),
        }
    }
}

impl Content {
    /// As a plugin sees it, as long as this lives.
    pub fn as_ptr(&self) -> *const PlanformValue {
        ptr::from_ref(self).cast()
    }
}

/// # Safety
///
/// `value` is NULL, or came from [`Content::as_ptr`] of content that lives for `'a`.
unsafe fn content<'a>(value: *const PlanformValue) -> &'a Content {
    // SAFETY: as the caller promises.
    unsafe { value.cast::<Content>().as_ref() }.unwrap_or(&Content::Nothing)
}

unsafe extern "C" fn kind(value: *const PlanformValue) -> u32 {
    guard(|| {
        // SAFETY: the plugin hands back a value that it was given, during the call.
        match unsafe { content(value) } {
            Content::Nothing => PLANFORM_NOTHING,
            Content::Flag(_) => PLANFORM_FLAG,
            Content::Number(_) => PLANFORM_NUMBER,
            Content::Text(_) => PLANFORM_TEXT,
            Content::Array(_) => PLANFORM_ARRAY,
            Content::Object(_) => PLANFORM_OBJECT,
        }
    })
    .unwrap_or(PLANFORM_NOTHING)
}

unsafe extern "C" fn member(value: *const PlanformValue, name: *const c_char) -> *const PlanformValue {
    guard(|| {
        // SAFETY: as above, and `name` is a C string.
        let (content, name) = unsafe { (content(value), c_bytes(name)) };
        match (content, name) {
            (Content::Object(members), Some(name)) => members
                .iter()
                .find(|(key, _)| key.as_bytes() == name)
                .map_or(ptr::null(), |(_, content)| content.as_ptr()),
            _ => ptr::null(),
        }
    })
    .unwrap_or(ptr::null())
}

unsafe extern "C" fn element(value: *const PlanformValue, index: usize) -> *const PlanformValue {
    guard(|| {
        // SAFETY: as above.
        match unsafe { content(value) } {
            Content::Array(elements) => elements.get(index).map_or(ptr::null(), Content::as_ptr),
            _ => ptr::null(),
        }
    })
    .unwrap_or(ptr::null())
}

unsafe extern "C" fn length(value: *const PlanformValue) -> usize {
    guard(|| {
        // SAFETY: as above.
        match unsafe { content(value) } {
            Content::Array(elements) => elements.len(),
            _ => 0,
        }
    })
    .unwrap_or(0)
}

unsafe extern "C" fn number(value: *const PlanformValue, otherwise: f64) -> f64 {
    guard(|| {
        // SAFETY: as above.
        match unsafe { content(value) } {
            Content::Number(number) => *number,
            _ => otherwise,
        }
    })
    .unwrap_or(otherwise)
}

unsafe extern "C" fn flag(value: *const PlanformValue, otherwise: bool) -> bool {
    guard(|| {
        // SAFETY: as above.
        match unsafe { content(value) } {
            Content::Flag(flag) => *flag,
            _ => otherwise,
        }
    })
    .unwrap_or(otherwise)
}

unsafe extern "C" fn text(value: *const PlanformValue) -> PlanformString {
    guard(|| {
        // SAFETY: as above.
        match unsafe { content(value) } {
            Content::Text(text) => text.as_string(),
            _ => PlanformString::NULL,
        }
    })
    .unwrap_or(PlanformString::NULL)
}

/// Adds a message to those logged on this thread, such as one from another process.
pub fn note(message: Log) {
    LOGGED.with_borrow_mut(|logged| {
        if logged.len() < MAX_LOGGED {
            logged.push(message);
        }
    });
}

unsafe extern "C" fn log(level: u32, message: PlanformString) {
    // Nobody can be told that a message is lost.
    let _ = guard(|| {
        // SAFETY: the message lives until this returns.
        note((level <= PLANFORM_LOG_WARNING, unsafe { message.to_text() }));
    });
}

const VERSION: &std::ffi::CStr =
    match std::ffi::CStr::from_bytes_with_nul(concat!(env!("CARGO_PKG_VERSION"), "\0").as_bytes()) {
        Ok(version) => version,
        Err(_) => c"",
    };

/// A table that never changes.
struct Shared(PlanformHost);

// SAFETY: it is never written, and its version is a constant.
unsafe impl Sync for Shared {}

static HOST: Shared = Shared(PlanformHost {
    size: size_of::<PlanformHost>(),
    abi_major: PLANFORM_ABI_MAJOR,
    abi_minor: PLANFORM_ABI_MINOR,
    version: PlanformString { data: VERSION.as_ptr(), length: VERSION.count_bytes() },
    log,
    kind,
    member,
    element,
    length,
    number,
    flag,
    text,
});

/// What every plugin is handed.
pub fn host_table() -> &'static PlanformHost {
    &HOST.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn a_plugin_walks_through_values() {
        let document = Content::from(json!({"rooms": [{"name": "Küche", "area": 9.5, "open": true}, null]}));
        // SAFETY: all values are of `document`, which lives to the end.
        unsafe {
            let rooms = member(document.as_ptr(), c"rooms".as_ptr());
            assert_eq!(
                (kind(document.as_ptr()), kind(rooms), length(rooms)),
                (PLANFORM_OBJECT, PLANFORM_ARRAY, 2)
            );
            let room = element(rooms, 0);
            assert_eq!(text(member(room, c"name".as_ptr())).to_text(), "Küche");
            assert_eq!(number(member(room, c"area".as_ptr()), 0.0), 9.5);
            assert!(flag(member(room, c"open".as_ptr()), false));
            assert_eq!(kind(element(rooms, 1)), PLANFORM_NOTHING);
        }
    }

    #[test]
    fn what_is_not_there_is_answered_all_the_same() {
        let five = Content::from(json!(5));
        // SAFETY: NULL, or a value of `five`, which lives to the end.
        unsafe {
            for value in [ptr::null(), five.as_ptr()] {
                assert!(member(value, c"x".as_ptr()).is_null() && member(value, ptr::null()).is_null());
                assert!(element(value, 0).is_null() && text(value).data.is_null());
                assert_eq!((length(value), flag(value, true)), (0, true));
            }
            assert_eq!((number(ptr::null(), 7.0), number(five.as_ptr(), 7.0)), (7.0, 5.0));
        }
    }
}
