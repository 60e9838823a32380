//! Storage of results: bytes under keys such as `results/<fit>/<attempt>/mesh.json`.

use super::store::StoreError;
use std::fs::{self, File};
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};
use uuid::Uuid;

/// Bytes under keys made by the service: parts of letters, digits, `-` and `.`, joined by `/`.
pub trait Blobs: Send + Sync {
    /// Stores bytes; when this returns they survive a crash. A reader sees all of them or none.
    ///
    /// # Errors
    /// If nothing could be written.
    fn put(&self, key: &str, bytes: &[u8]) -> Result<(), StoreError>;

    /// Finds bytes.
    ///
    /// # Errors
    /// If nothing could be read.
    fn get(&self, key: &str) -> Result<Option<Vec<u8>>, StoreError>;

    /// Removes everything whose key begins with `prefix` and a `/`.
    ///
    /// # Errors
    /// If something could not be removed.
    fn delete(&self, prefix: &str) -> Result<(), StoreError>;

    /// Writes bytes, makes them survive a crash, reads and removes them.
    ///
    /// # Errors
    /// If any of this fails.
    fn probe(&self) -> Result<(), StoreError>;
}

/// Bytes of a probe: a block of most file systems.
const PROBE_BYTES: usize = 4_096;

/// Bytes in files of one folder.
#[derive(Clone, Debug)]
pub struct FileBlobs {
    root: PathBuf,
}

impl FileBlobs {
    /// Opens a folder, which is made if it is not there.
    ///
    /// # Errors
    /// If the folder cannot be made.
    pub fn open(root: &Path) -> Result<Self, StoreError> {
        let doing = || format!("making the folder {}", root.display());
        fs::create_dir_all(root.join("tmp")).map_err(|cause| StoreError::new(doing(), cause))?;
        Ok(Self {
            root: root.to_owned(),
        })
    }

    fn path(&self, key: &str) -> PathBuf {
        assert!(
            key.split('/').all(is_plain_name),
            "keys are made by the service"
        );
        self.root.join(key)
    }

    fn write(&self, path: &Path, bytes: &[u8]) -> std::io::Result<()> {
        let folder = path.parent().unwrap_or(&self.root);
        let temporary = self.write_temporary(bytes)?;
        let moved = fs::create_dir_all(folder).and_then(|()| fs::rename(&temporary, path));
        if moved.is_err() {
            // The first error is the one to report; what is left in tmp harms nobody.
            let _ = fs::remove_file(&temporary);
        }
        moved?;
        // The names must survive a crash too: the file's, and those of folders just made.
        for folder in path.ancestors().skip(1).take(3) {
            File::open(folder)?.sync_all()?;
        }
        Ok(())
    }

    /// Writes bytes to a new file, whole and flushed. The root is not made anew: if it is gone, so
    /// is what was kept.
    fn write_temporary(&self, bytes: &[u8]) -> std::io::Result<PathBuf> {
        let temporary = self.root.join("tmp").join(Uuid::now_v7().to_string());
        let mut file = File::create_new(&temporary)?;
        let written = file.write_all(bytes).and_then(|()| file.sync_all());
        if written.is_err() {
            let _ = fs::remove_file(&temporary);
        }
        written.map(|()| temporary)
    }

    fn write_and_read(&self) -> std::io::Result<()> {
        let temporary = self.write_temporary(&[b'0'; PROBE_BYTES])?;
        let read = fs::read(&temporary);
        fs::remove_file(&temporary)?;
        if read?.len() == PROBE_BYTES {
            return Ok(());
        }
        Err(std::io::Error::other(
            "a file is shorter than it was written",
        ))
    }
}

/// Returns true if a part of a key is a plain file name.
fn is_plain_name(part: &str) -> bool {
    !part.is_empty()
        && !part.starts_with('.')
        && part
            .bytes()
            .all(|byte| byte.is_ascii_alphanumeric() || b"-._".contains(&byte))
}

impl Blobs for FileBlobs {
    fn put(&self, key: &str, bytes: &[u8]) -> Result<(), StoreError> {
        let path = self.path(key);
        self.write(&path, bytes)
            .map_err(|cause| StoreError::new(format!("writing {}", path.display()), cause))
    }

    fn get(&self, key: &str) -> Result<Option<Vec<u8>>, StoreError> {
        let path = self.path(key);
        match fs::read(&path) {
            Ok(bytes) => Ok(Some(bytes)),
            Err(cause) if cause.kind() == ErrorKind::NotFound => Ok(None),
            Err(cause) => Err(StoreError::new(
                format!("reading {}", path.display()),
                cause,
            )),
        }
    }

    fn delete(&self, prefix: &str) -> Result<(), StoreError> {
        let path = self.path(prefix);
        match fs::remove_dir_all(&path) {
            Err(cause) if cause.kind() != ErrorKind::NotFound => Err(StoreError::new(
                format!("removing {}", path.display()),
                cause,
            )),
            _ => Ok(()),
        }
    }

    fn probe(&self) -> Result<(), StoreError> {
        self.write_and_read().map_err(|cause| {
            StoreError::new(format!("trying to write in {}", self.root.display()), cause)
        })
    }
}
