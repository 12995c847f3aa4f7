//! Events for programs: one JSON object on each line of standard output.

use super::super::record::Record;
use super::Teller;
use crate::cli::failure::print;
use serde_json::{Value, json};

/// Tells in events.
pub struct Events;

/// Prints an event.
pub fn event(name: &str, value: Value) {
    let mut event = json!({ "event": name });
    if let (Some(event), Value::Object(members)) = (event.as_object_mut(), value) {
        event.extend(members);
    }
    // The work goes on if nobody listens any more.
    let _ = print(format!("{event}\n").as_bytes());
}

impl Teller for Events {
    fn start(&mut self, todo: usize) {
        event("start", json!({ "version": env!("CARGO_PKG_VERSION"), "documents": todo }));
    }

    fn settled(&mut self, record: &Record) {
        event("settled", json!(record));
    }

    fn again(&mut self, name: &str, reason: &str) {
        event("again", json!({ "name": name, "reason": reason }));
    }

    fn begin(&mut self, name: &str) {
        event("begin", json!({ "name": name }));
    }

    fn retry(&mut self, name: &str, reason: &str) {
        event("retry", json!({ "name": name, "reason": reason }));
    }

    fn done(&mut self, record: &Record) {
        event("done", json!(record));
    }

    fn tick(&mut self) {}

    fn end(&mut self) {
        event("end", json!({}));
    }
}
