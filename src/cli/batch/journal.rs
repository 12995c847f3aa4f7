//! The journal of a batch: what came of every document, and which files are the batch's own. It is safe on the disk
//! before a file is renamed to its place, so that whatever ends the program, the next run knows where it was.

use super::digest::{Digest, Seen, Stamp};
use super::record::Record;
use super::task::Thumbnails;
use crate::cli::Failure;
use rusqlite::{Connection, ErrorCode, OptionalExtension, Row, params};
use std::fs::{self, File, TryLockError};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// The journal's file in its folder.
const FILE: &str = "journal.sqlite";

/// `PLAN` in ASCII: marks the file as ours.
const APPLICATION: i32 = 0x504c_414e;

/// The version of the tables below.
const TABLES: i32 = 1;

const SCHEMA: &str = "
    CREATE TABLE documents (
        name TEXT PRIMARY KEY,   -- its place below the output folder
        options TEXT NOT NULL,   -- digest of all that its outputs depend on but for the document itself
        version TEXT NOT NULL,   -- of planform
        stamps TEXT,             -- lengths and times of its files
        digest TEXT,             -- of their content
        record TEXT NOT NULL,    -- what came of it
        before TEXT,             -- thumbnails
        after TEXT
    );
    CREATE TABLE files (
        path TEXT PRIMARY KEY,   -- below the output folder
        document TEXT NOT NULL,
        digest TEXT,             -- of what was written; none if nothing was yet
        intended TEXT            -- of what is about to replace it
    );
    CREATE INDEX files_of_document ON files (document);";

/// How a run treats the journal of a former one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Start {
    /// There must be none.
    New,
    /// It is carried on.
    Resume,
    /// It is emptied.
    Anew,
}

/// A journal that is this run's alone.
pub struct Journal {
    db: Connection,
    path: PathBuf,
    /// Held as long as the journal is open.
    _lock: File,
}

/// What the journal holds of a document.
#[derive(Debug, Clone, PartialEq)]
pub struct Entry {
    /// Digest of all that its outputs depend on but for the document itself.
    pub options: Digest,
    /// The version of planform that made them.
    pub version: String,
    /// The document as it was then, if it could be read.
    pub seen: Option<Seen>,
    /// What came of it.
    pub record: Record,
    /// Small pictures.
    pub thumbnails: Thumbnails,
}

/// A file of a document, as the journal has it.
#[derive(Debug, Clone, PartialEq)]
pub struct Own {
    /// Its path below the output folder.
    pub path: String,
    /// What was written.
    pub digest: Option<Digest>,
    /// What was about to be.
    pub intended: Option<Digest>,
}

impl Journal {
    /// Whether there is one in this folder.
    pub fn is_in(folder: &Path) -> bool {
        folder.join(FILE).exists()
    }

    /// Opens the journal in this folder, which is made if need be.
    pub fn open(folder: &Path, start: Start) -> Result<Self, Failure> {
        fs::create_dir_all(folder).map_err(|e| Failure::of_io(folder, e))?;
        let lock = lock(folder)?;
        let path = folder.join(FILE);
        if start == Start::New && path.exists() {
            let advice = "`--resume` carries it on, `--force` begins anew and overwrites";
            return Err(Failure::over(&path, format!("is the journal of a former run; {advice}")));
        }
        let db = Connection::open(&path).map_err(|e| told(&path, &e))?;
        let mut journal = Self { db, path, _lock: lock };
        journal.prepare(start)?;
        Ok(journal)
    }

    fn prepare(&mut self, start: Start) -> Result<(), Failure> {
        self.settings().map_err(|e| self.told(&e))?;
        let sound: Result<String, _> = self.db.query_row("PRAGMA quick_check(1)", [], |row| row.get(0));
        if sound.map_err(|e| self.told(&e))? != "ok" {
            return Err(damaged(&self.path));
        }
        match self.versions().map_err(|e| self.told(&e))? {
            (0, 0) => self.create().map_err(|e| self.told(&e))?,
            (APPLICATION, TABLES) => {}
            (APPLICATION, _) => {
                let advice = "use that planform, or another output folder";
                return Err(Failure::over(&self.path, format!("was written by another planform; {advice}")));
            }
            _ => return Err(damaged(&self.path)),
        }
        if start == Start::Anew {
            self.db.execute_batch("DELETE FROM documents; DELETE FROM files;").map_err(|e| self.told(&e))?;
        }
        Ok(())
    }

    fn settings(&self) -> rusqlite::Result<()> {
        self.db.busy_timeout(Duration::from_secs(10))?;
        self.db.pragma_update(None, "journal_mode", "WAL")
    }

    /// Whether what is noted next is to be on the disk before the work goes on. A disk needs time for that, and few
    /// documents take as long as it. What is not on the disk is there all the same if the program is killed, but not after a
    /// power cut.
    fn wait_for_disk(&self, waits: bool) -> Result<(), Failure> {
        let value = if waits { "FULL" } else { "NORMAL" };
        self.db.pragma_update(None, "synchronous", value).map_err(|e| self.told(&e))
    }

    fn versions(&self) -> rusqlite::Result<(i32, i32)> {
        let pragma = |name: &str| self.db.pragma_query_value(None, name, |row| row.get(0));
        Ok((pragma("application_id")?, pragma("user_version")?))
    }

    fn create(&mut self) -> rusqlite::Result<()> {
        let all = self.db.transaction()?;
        all.execute_batch(SCHEMA)?;
        all.pragma_update(None, "application_id", APPLICATION)?;
        all.pragma_update(None, "user_version", TABLES)?;
        all.commit()
    }

    /// What is known of the document of this name.
    pub fn entry(&self, name: &str) -> Result<Option<Entry>, Failure> {
        let sql =
            "SELECT options, version, stamps, digest, record, before, after FROM documents WHERE name = ?1";
        let found = self.db.prepare_cached(sql).and_then(|mut s| s.query_row([name], entry).optional());
        found.map_err(|e| self.told(&e))?.map(|e| e.ok_or_else(|| damaged(&self.path))).transpose()
    }

    /// The files of the document of this name.
    pub fn files(&self, name: &str) -> Result<Vec<Own>, Failure> {
        let sql = "SELECT path, digest, intended FROM files WHERE document = ?1 ORDER BY path";
        let all = self.db.prepare_cached(sql).and_then(|mut s| s.query_map([name], own)?.collect());
        all.map_err(|e| self.told(&e))
    }

    /// What is known of the file of this path.
    pub fn file(&self, path: &str) -> Result<Option<Own>, Failure> {
        let sql = "SELECT path, digest, intended FROM files WHERE path = ?1";
        let found = self.db.prepare_cached(sql).and_then(|mut s| s.query_row([path], own).optional());
        found.map_err(|e| self.told(&e))
    }

    /// Notes what is in the places of these files, and what is about to be renamed to them.
    pub fn intend(&mut self, name: &str, files: &[Own]) -> Result<(), Failure> {
        let sql = "INSERT OR REPLACE INTO files (path, document, digest, intended) VALUES (?1, ?2, ?3, ?4)";
        // A file in its place of which the journal knows nothing would be taken for somebody else's.
        self.wait_for_disk(true)?;
        let noted = self.db.transaction().and_then(|all| {
            for Own { path, digest, intended } in files {
                let [digest, intended] = [digest, intended].map(|d| d.as_ref().map(Digest::as_str));
                all.prepare_cached(sql)?.execute(params![path, name, digest, intended])?;
            }
            all.commit()
        });
        noted.map_err(|e| self.told(&e))
    }

    /// Notes what came of a document. The files that were about to be in their places are there.
    pub fn note(&mut self, entry: &Entry) -> Result<(), Failure> {
        let sql = "INSERT OR REPLACE INTO documents VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8)";
        let files = "UPDATE files SET digest = intended, intended = NULL WHERE document = ?1 AND intended IS NOT NULL";
        let Entry { options, version, seen, record, thumbnails } = entry;
        let stamps = seen.as_ref().map(|s| serde_json::json!(s.stamps).to_string());
        let digest = seen.as_ref().map(|s| s.digest.as_str());
        let text = serde_json::json!(record).to_string();
        // If this is lost, the document is done once more.
        self.wait_for_disk(false)?;
        let noted = self.db.transaction().and_then(|all| {
            let values = params![
                record.name,
                options.as_str(),
                version,
                stamps,
                digest,
                text,
                thumbnails.before,
                thumbnails.after
            ];
            all.prepare_cached(sql)?.execute(values)?;
            all.prepare_cached(files)?.execute([&record.name])?;
            all.commit()
        });
        noted.map_err(|e| self.told(&e))
    }

    fn told(&self, error: &rusqlite::Error) -> Failure {
        told(&self.path, error)
    }
}

fn entry(row: &Row<'_>) -> rusqlite::Result<Option<Entry>> {
    let stamps: Option<String> = row.get(2)?;
    let digest: Option<String> = row.get(3)?;
    let stamps = stamps.and_then(|s| serde_json::from_str::<Vec<Option<Stamp>>>(&s).ok());
    let seen = stamps.zip(digest).map(|(stamps, digest)| Seen { stamps, digest: Digest::known(digest) });
    let record: String = row.get(4)?;
    let Ok(record) = serde_json::from_str(&record) else { return Ok(None) };
    let thumbnails = Thumbnails { before: row.get(5)?, after: row.get(6)? };
    Ok(Some(Entry { options: Digest::known(row.get(0)?), version: row.get(1)?, seen, record, thumbnails }))
}

fn own(row: &Row<'_>) -> rusqlite::Result<Own> {
    let digest = |i| row.get(i).map(|d: Option<String>| d.map(Digest::known));
    Ok(Own { path: row.get(0)?, digest: digest(1)?, intended: digest(2)? })
}

/// Locks the folder for this run; the system unlocks it when the program ends, however it does.
fn lock(folder: &Path) -> Result<File, Failure> {
    let path = folder.join("lock");
    let file = File::options().create(true).truncate(false).write(true).open(&path);
    let file = file.map_err(|e| Failure::of_io(&path, e))?;
    match file.try_lock() {
        Ok(()) => Ok(file),
        Err(TryLockError::WouldBlock) => {
            let message = "another run of planform works on this batch; wait for it, or end it";
            Err(Failure::over(folder, message))
        }
        Err(TryLockError::Error(e)) => Err(Failure::of_io(&path, e)),
    }
}

fn damaged(path: &Path) -> Failure {
    let advice = "move it away and run again with `--force`, which converts everything anew, or bring a copy of it back";
    Failure::over(path, format!("is damaged; {advice}"))
}

/// What the database says, in words for people.
fn told(path: &Path, error: &rusqlite::Error) -> Failure {
    let reason = match error.sqlite_error_code() {
        Some(ErrorCode::DatabaseCorrupt | ErrorCode::NotADatabase) => return damaged(path),
        Some(ErrorCode::DiskFull) => "the disk is full; make room and run again with `--resume`",
        Some(ErrorCode::ReadOnly | ErrorCode::PermissionDenied) => "the system does not permit to write it",
        Some(ErrorCode::CannotOpen) => "cannot be opened; is the output folder still there?",
        Some(ErrorCode::SystemIoFailure) => {
            "the system refuses to read or write it; is the disk full, or gone? `--resume` carries on"
        }
        _ => return Failure::over(path, format!("cannot be used: {error}")),
    };
    Failure::over(path, reason)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::batch::record::State;

    fn document(name: &str) -> Entry {
        Entry {
            options: Digest::of(b"options"),
            version: "1".into(),
            seen: Some(Seen { stamps: vec![None], digest: Digest::of(b"content") }),
            record: Record { state: State::Converted, ..Record::open(name, name) },
            thumbnails: Thumbnails { before: Some("x".into()), after: None },
        }
    }

    #[test]
    fn what_is_noted_is_there_again() {
        let folder = tempfile::tempdir().unwrap();
        let mut journal = Journal::open(folder.path(), Start::New).unwrap();
        assert_eq!(journal.entry("a").unwrap(), None);
        let digest = Digest::of(b"out");
        let intended = Own { path: "a.svg".into(), digest: None, intended: Some(digest.clone()) };
        journal.intend("a", std::slice::from_ref(&intended)).unwrap();
        assert_eq!(journal.file("a.svg").unwrap(), Some(intended));
        journal.note(&document("a")).unwrap();
        drop(journal);
        let journal = Journal::open(folder.path(), Start::Resume).unwrap();
        assert_eq!(journal.entry("a").unwrap(), Some(document("a")));
        assert_eq!(
            journal.files("a").unwrap(),
            [Own { path: "a.svg".into(), digest: Some(digest), intended: None }]
        );
        drop(journal);
        let journal = Journal::open(folder.path(), Start::Anew).unwrap();
        assert_eq!((journal.entry("a").unwrap(), journal.files("a").unwrap()), (None, vec![]));
    }

    #[test]
    fn a_journal_is_for_one_run_at_a_time() {
        let folder = tempfile::tempdir().unwrap();
        let told = |start| match Journal::open(folder.path(), start) {
            Err(Failure::Failed(sentence)) => sentence,
            _ => String::new(),
        };
        let journal = Journal::open(folder.path(), Start::New).unwrap();
        assert!(told(Start::Resume).contains("another run of planform works on this batch"));
        drop(journal);
        assert!(told(Start::New).contains("is the journal of a former run"));
        assert_eq!(told(Start::Resume), "");
    }

    #[test]
    fn damage_is_told_and_nothing_thrown_away() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("journal.sqlite");
        let mut journal = Journal::open(folder.path(), Start::New).unwrap();
        (0..200).for_each(|n| journal.note(&document(&format!("document {n}"))).unwrap());
        drop(journal);
        let whole = fs::read(&file).unwrap();
        let mut holed = whole.clone();
        holed[4096..12_000].fill(0x55);
        for bytes in
            [b"no database at all, but long enough to be one".to_vec(), whole[..9000].to_vec(), holed]
        {
            fs::write(&file, &bytes).unwrap();
            for start in [Start::Resume, Start::Anew] {
                let Err(Failure::Failed(sentence)) = Journal::open(folder.path(), start) else {
                    panic!("opened")
                };
                assert!(sentence.contains("journal.sqlite: is damaged; move it away"), "{sentence}");
            }
            assert_eq!(fs::read(&file).unwrap(), bytes);
        }
    }
}
