//! Waits for documents that are dropped into a folder. The folder is looked at again and again: that works on every file
//! system, also on those of other machines, which tell nobody of changes.

use super::digest::Stamp;
use super::documents::Listed;
use super::interrupt::Interrupt;
use std::collections::HashMap;
use std::path::PathBuf;
use std::thread::sleep;
use std::time::{Duration, Instant};

/// Time between two looks.
const PERIOD: Duration = Duration::from_secs(2);

/// How often Ctrl-C is looked for meanwhile.
const LOOK: Duration = Duration::from_millis(50);

/// When the files of documents were written.
type Stamps = HashMap<PathBuf, Vec<Option<Stamp>>>;

/// The documents that were handled, and what was there at the last look.
#[derive(Default)]
pub struct Handled {
    handled: Stamps,
    last: Stamps,
}

impl Handled {
    /// Notes that these documents are handled as they are now.
    pub fn add(&mut self, documents: &[Listed]) {
        self.handled.extend(stamps(documents));
    }

    /// Those of the documents that were not handled as they are now, and were the same at the last look, so that nobody
    /// seems to be writing them any more.
    pub fn fresh(&mut self, documents: &[Listed]) -> Vec<Listed> {
        let before = std::mem::replace(&mut self.last, stamps(documents));
        let fresh = |d: &&Listed| {
            let now = self.last.get(&d.input);
            before.get(&d.input) == now && self.handled.get(&d.input) != now
        };
        documents.iter().filter(fresh).cloned().collect()
    }
}

fn stamps(documents: &[Listed]) -> Stamps {
    let of = |d: &Listed| {
        let files = std::iter::once(&d.input).chain(&d.siblings);
        (d.input.clone(), files.map(|f| Stamp::of(f).ok()).collect())
    };
    documents.iter().map(of).collect()
}

/// Waits until it is time for another look, or the user wants to stop.
pub fn wait(interrupt: &Interrupt) {
    let end = Instant::now() + PERIOD;
    while Instant::now() < end && !interrupt.is_set() {
        sleep(LOOK);
    }
}

#[cfg(test)]
mod tests {
    use super::super::documents::Row;
    use super::*;

    #[test]
    fn a_document_is_taken_once_when_nobody_writes_it_any_more() {
        let folder = tempfile::tempdir().unwrap();
        let input = folder.path().join("a.png");
        let listed = || Listed {
            place: "a.png".into(),
            input: input.clone(),
            named: false,
            siblings: vec![],
            row: Row::default(),
            trouble: None,
        };
        let mut handled = Handled::default();
        let look = |handled: &mut Handled, text: &str| {
            std::fs::write(&input, text).unwrap();
            handled.fresh(&[listed()]).len()
        };
        assert_eq!((look(&mut handled, "a"), look(&mut handled, "ab")), (0, 0));
        assert_eq!(handled.fresh(&[listed()]).len(), 1);
        handled.add(&[listed()]);
        assert_eq!(handled.fresh(&[listed()]).len(), 0);
        assert_eq!(look(&mut handled, "changed"), 0);
        assert_eq!(handled.fresh(&[listed()]).len(), 1);
        assert_eq!(handled.fresh(&[]).len(), 0);
    }
}
