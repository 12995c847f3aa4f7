//! Tesseract's C library, found when it is first needed. Without it everything else works.
//!
//! The declarations are those of `tesseract/capi.h`, the same in the versions 4 and 5.
#![allow(unsafe_code)]

use super::{Segmentation, install_advice, no_data};
use crate::words::engine::{OcrEngine, OcrError, OcrWord};
use image::GrayImage;
use libloading::Library;
use std::ffi::{CStr, CString, OsString, c_char, c_float, c_int, c_uchar, c_void};
use std::path::Path;
use std::sync::{Arc, OnceLock};

/// Names the library's file instead of the usual names; what is not there hides Tesseract.
const LIBRARY_VARIABLE: &str = "PLANFORM_TESSERACT";

/// The neural network alone, without the engine of Tesseract 3 that few installations have the data for.
const OEM_LSTM_ONLY: c_int = 1;
/// Results word by word.
const RIL_WORD: c_int = 3;
/// What the pictures are said to have, dots per inch. Lines come enlarged to letters of the height that 12 points have
/// at this density.
const DPI: c_int = 300;

#[cfg(windows)]
const NOWHERE: &CStr = c"NUL";
#[cfg(not(windows))]
const NOWHERE: &CStr = c"/dev/null";

#[cfg(windows)]
const NAMES: &[&str] =
    &["libtesseract-5.dll", "tesseract53.dll", "tesseract55.dll", "libtesseract-4.dll", "tesseract.dll"];
#[cfg(target_os = "macos")]
const NAMES: &[&str] = &[
    "libtesseract.5.dylib",
    "libtesseract.4.dylib",
    "libtesseract.dylib",
    "/opt/homebrew/lib/libtesseract.dylib",
    "/usr/local/lib/libtesseract.dylib",
    "/opt/local/lib/libtesseract.dylib",
];
#[cfg(not(any(windows, target_os = "macos")))]
const NAMES: &[&str] = &["libtesseract.so.5", "libtesseract.so.4", "libtesseract.so"];

/// An object of the library.
type Handle = *mut c_void;

/// The functions of the library that are used.
struct Api {
    create: unsafe extern "C" fn() -> Handle,
    delete: unsafe extern "C" fn(Handle),
    set_variable: unsafe extern "C" fn(Handle, *const c_char, *const c_char) -> c_int,
    init: unsafe extern "C" fn(Handle, *const c_char, *const c_char, c_int) -> c_int,
    set_mode: unsafe extern "C" fn(Handle, c_int),
    set_image: unsafe extern "C" fn(Handle, *const c_uchar, c_int, c_int, c_int, c_int),
    set_resolution: unsafe extern "C" fn(Handle, c_int),
    recognize: unsafe extern "C" fn(Handle, *mut c_void) -> c_int,
    iterator: unsafe extern "C" fn(Handle) -> Handle,
    next: unsafe extern "C" fn(Handle, c_int) -> c_int,
    text: unsafe extern "C" fn(Handle, c_int) -> *mut c_char,
    confidence: unsafe extern "C" fn(Handle, c_int) -> c_float,
    page_iterator: unsafe extern "C" fn(Handle) -> Handle,
    bounds: unsafe extern "C" fn(Handle, c_int, *mut c_int, *mut c_int, *mut c_int, *mut c_int) -> c_int,
    delete_iterator: unsafe extern "C" fn(Handle),
    delete_text: unsafe extern "C" fn(*mut c_char),
    /// Of the library's OpenMP, if it has one: how many levels of threads may be nested.
    set_levels: Option<unsafe extern "C" fn(c_int)>,
    /// Last, so that it is unloaded last.
    _library: Library,
}

impl Api {
    fn load() -> Option<Self> {
        let named = std::env::var_os(LIBRARY_VARIABLE).map(|n| vec![n]);
        let names = named.unwrap_or_else(|| NAMES.iter().map(OsString::from).collect());
        names.iter().find_map(Self::of)
    }

    /// The functions of the library of this name, if it is there and has them all.
    fn of(name: &OsString) -> Option<Self> {
        // SAFETY: loading Tesseract and what it needs runs their initialisers, which are those of ordinary C++ libraries.
        // The names are Tesseract's own, looked up where the system keeps its libraries, or the user gave the name.
        let library = unsafe { Library::new(name) }.ok()?;
        macro_rules! function {
            ($name:literal) => {
                // SAFETY: the field it is put into has the type that capi.h declares for this name.
                *unsafe { library.get($name) }.ok()?
            };
        }
        Some(Self {
            create: function!(b"TessBaseAPICreate"),
            delete: function!(b"TessBaseAPIDelete"),
            set_variable: function!(b"TessBaseAPISetVariable"),
            init: function!(b"TessBaseAPIInit2"),
            set_mode: function!(b"TessBaseAPISetPageSegMode"),
            set_image: function!(b"TessBaseAPISetImage"),
            set_resolution: function!(b"TessBaseAPISetSourceResolution"),
            recognize: function!(b"TessBaseAPIRecognize"),
            iterator: function!(b"TessBaseAPIGetIterator"),
            next: function!(b"TessResultIteratorNext"),
            text: function!(b"TessResultIteratorGetUTF8Text"),
            confidence: function!(b"TessResultIteratorConfidence"),
            page_iterator: function!(b"TessResultIteratorGetPageIterator"),
            bounds: function!(b"TessPageIteratorBoundingBox"),
            delete_iterator: function!(b"TessResultIteratorDelete"),
            delete_text: function!(b"TessDeleteText"),
            // SAFETY: OpenMP declares this function so, in every implementation of it.
            set_levels: unsafe { library.get(b"omp_set_max_active_levels") }.ok().map(|f| *f),
            _library: library,
        })
    }
}

/// The library, loaded once, if there is one.
fn api() -> Option<Arc<Api>> {
    static API: OnceLock<Option<Arc<Api>>> = OnceLock::new();
    API.get_or_init(|| Api::load().map(Arc::new)).clone()
}

/// One engine of Tesseract. It stays in the thread that made it, as its handle must not be shared.
pub struct Tesseract {
    api: Arc<Api>,
    handle: Handle,
}

impl Tesseract {
    /// An engine for these languages (`eng+deu`), with data from this folder or from where Tesseract itself looks.
    pub fn open(languages: &str, data: Option<&Path>) -> Result<Self, OcrError> {
        let api = api().ok_or_else(|| OcrError::NotInstalled(install_advice()))?;
        // SAFETY: without arguments; a null is refused below.
        let handle = unsafe { (api.create)() };
        if handle.is_null() {
            return Err(OcrError::Failed("started"));
        }
        let engine = Self { api, handle };
        engine.set_up();
        engine.load(languages, data)?;
        Ok(engine)
    }

    fn set_up(&self) {
        // SAFETY: the handle is alive, and both texts end in a null.
        unsafe { (self.api.set_variable)(self.handle, c"debug_file".as_ptr(), NOWHERE.as_ptr()) };
        if let Some(set_levels) = self.api.set_levels {
            // SAFETY: OpenMP takes any number. With no level of threads, each engine works in the one thread that calls
            // it; its own would only wait for one another.
            unsafe { set_levels(0) };
        }
    }

    fn load(&self, languages: &str, data: Option<&Path>) -> Result<(), OcrError> {
        let missing = || no_data(languages, data);
        let c_languages = CString::new(languages).map_err(|_| missing())?;
        let c_data = data.map(|d| CString::new(d.to_string_lossy().as_bytes())).transpose();
        let c_data = c_data.map_err(|_| missing())?;
        let c_data = c_data.as_ref().map_or(std::ptr::null(), |d| d.as_ptr());
        // SAFETY: the handle is alive; the texts end in a null and live until the call returns; the folder may be null.
        let failed = unsafe { (self.api.init)(self.handle, c_data, c_languages.as_ptr(), OEM_LSTM_ONLY) };
        if failed != 0 {
            return Err(missing());
        }
        Ok(())
    }

    /// Hands the picture over and reads it.
    fn recognize(&self, line: &GrayImage) -> Result<(), OcrError> {
        let failure = OcrError::Failed("read a line");
        let side = |s: u32| c_int::try_from(s).ok().filter(|&s| s > 0);
        let (Some(width), Some(height)) = (side(line.width()), side(line.height())) else {
            return Err(failure);
        };
        // SAFETY: the handle is alive and initialised; the picture has `height` rows of `width` bytes, and Tesseract copies
        // it before it returns.
        let failed = unsafe {
            (self.api.set_mode)(self.handle, Segmentation::of(line) as c_int);
            (self.api.set_image)(self.handle, line.as_raw().as_ptr(), width, height, 1, width);
            (self.api.set_resolution)(self.handle, DPI);
            (self.api.recognize)(self.handle, std::ptr::null_mut())
        };
        if failed == 0 { Ok(()) } else { Err(failure) }
    }

    /// The word that the iterator stands at.
    fn word(&self, iterator: Handle) -> Option<OcrWord> {
        // SAFETY: the iterator is alive; the text is owned by us, ends in a null, and is given back after it was copied.
        let text = unsafe {
            let text = (self.api.text)(iterator, RIL_WORD);
            if text.is_null() {
                return None;
            }
            let copy = CStr::from_ptr(text).to_string_lossy().trim().to_owned();
            (self.api.delete_text)(text);
            copy
        };
        // SAFETY: the iterator is alive.
        let percent = unsafe { (self.api.confidence)(iterator, RIL_WORD) };
        let confidence = (f64::from(percent) / 100.0).clamp(0.0, 1.0);
        Some(OcrWord { text, bounds: self.bounds(iterator), confidence })
    }

    /// The box of the word that the iterator stands at; empty if there is none.
    fn bounds(&self, iterator: Handle) -> [i32; 4] {
        let [mut l, mut t, mut r, mut b] = [0; 4];
        // SAFETY: the iterator is alive, a page iterator is a view of it, and the numbers are written before this returns.
        let found = unsafe {
            let page = (self.api.page_iterator)(iterator);
            (self.api.bounds)(page, RIL_WORD, &mut l, &mut t, &mut r, &mut b)
        };
        if found == 0 { [0; 4] } else { [l, t, r, b] }
    }
}

impl OcrEngine for Tesseract {
    fn read(&mut self, line: &GrayImage) -> Result<Vec<OcrWord>, OcrError> {
        self.recognize(line)?;
        // SAFETY: the handle is alive and has just recognised; a null means that nothing was found.
        let iterator = unsafe { (self.api.iterator)(self.handle) };
        if iterator.is_null() {
            return Ok(Vec::new());
        }
        let mut words = Vec::new();
        loop {
            words.extend(self.word(iterator).filter(|w| !w.text.is_empty()));
            // SAFETY: the iterator is alive.
            if unsafe { (self.api.next)(iterator, RIL_WORD) } == 0 {
                break;
            }
        }
        // SAFETY: the iterator is ours, and not used again.
        unsafe { (self.api.delete_iterator)(iterator) };
        Ok(words)
    }
}

impl Drop for Tesseract {
    fn drop(&mut self) {
        // SAFETY: the handle is ours, and not used again.
        unsafe { (self.api.delete)(self.handle) };
    }
}
