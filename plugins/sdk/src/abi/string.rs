//! Texts that cross.
#![allow(unsafe_code)]

use super::PlanformString;
use std::ffi::CStr;
use std::path::PathBuf;
use std::slice;

impl PlanformString {
    /// No text.
    pub const NULL: Self = Self { data: std::ptr::null(), length: 0 };

    /// These bytes, to be read as long as they live.
    pub fn of(bytes: &[u8]) -> Self {
        Self { data: bytes.as_ptr().cast(), length: bytes.len() }
    }

    /// The text of a C string, without its zero byte.
    pub fn of_c_str(text: &CStr) -> Self {
        Self { data: text.as_ptr(), length: text.count_bytes() }
    }

    /// The bytes.
    ///
    /// # Safety
    ///
    /// `data` is NULL, or points to `length` bytes that live and stay as they are for `'a`.
    pub unsafe fn bytes<'a>(self) -> &'a [u8] {
        if self.data.is_null() || self.length == 0 {
            return &[];
        }
        // SAFETY: as the caller promises; not NULL, and c_char is a byte.
        unsafe { slice::from_raw_parts(self.data.cast(), self.length) }
    }

    /// The text; what is not UTF-8 in it is replaced.
    ///
    /// # Safety
    ///
    /// As for [`bytes`](Self::bytes), during this call.
    pub unsafe fn to_text(self) -> String {
        // SAFETY: as the caller promises.
        String::from_utf8_lossy(unsafe { self.bytes() }).into_owned()
    }

    /// The path.
    ///
    /// # Safety
    ///
    /// As for [`bytes`](Self::bytes), during this call.
    pub unsafe fn to_path(self) -> PathBuf {
        // SAFETY: as the caller promises.
        path_of(unsafe { self.bytes() })
    }
}

#[cfg(unix)]
fn path_of(bytes: &[u8]) -> PathBuf {
    use std::os::unix::ffi::OsStrExt;
    PathBuf::from(std::ffi::OsStr::from_bytes(bytes))
}

#[cfg(not(unix))]
fn path_of(bytes: &[u8]) -> PathBuf {
    PathBuf::from(String::from_utf8_lossy(bytes).into_owned())
}

#[cfg(feature = "host")]
/// The bytes of a C string.
///
/// # Safety
///
/// `text` is NULL, or points to bytes up to a zero byte that live and stay as they are for `'a`.
pub unsafe fn c_bytes<'a>(text: *const std::ffi::c_char) -> Option<&'a [u8]> {
    // SAFETY: not NULL, and as the caller promises.
    (!text.is_null()).then(|| unsafe { CStr::from_ptr(text) }.to_bytes())
}

/// Bytes followed by a zero byte, as planform hands them out.
#[cfg(feature = "host")]
pub struct Terminated(Vec<u8>);

#[cfg(feature = "host")]
impl Terminated {
    /// These bytes with a zero byte.
    pub fn new(bytes: impl Into<Vec<u8>>) -> Self {
        let mut bytes = bytes.into();
        bytes.push(0);
        Self(bytes)
    }

    /// The path's bytes as the system has them.
    pub fn of_path(path: &std::path::Path) -> Self {
        Self::new(path.as_os_str().as_encoded_bytes())
    }

    /// To be read as long as this lives.
    pub fn as_string(&self) -> PlanformString {
        PlanformString { data: self.0.as_ptr().cast(), length: self.0.len() - 1 }
    }
}
