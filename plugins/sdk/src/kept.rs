//! What a look at a document leaves for those who look or read after it.

use std::any::Any;

/// Something that was costly to make of a document, such as its decoded picture, so that it is made once however many
/// adapters look at the document and then read it. It belongs to that document alone.
#[derive(Default)]
pub struct Kept(Option<Box<dyn Any + Send>>);

impl Kept {
    /// Keeps this in place of what was kept before.
    pub fn put<T: Any + Send>(&mut self, value: T) {
        self.0 = Some(Box::new(value));
    }

    /// What is kept, if it is a `T`.
    pub fn get<T: Any>(&self) -> Option<&T> {
        self.0.as_ref()?.downcast_ref()
    }

    /// Gives out what is kept, if it is a `T`; otherwise it is dropped.
    pub fn take<T: Any>(self) -> Option<T> {
        self.0?.downcast().ok().map(|value| *value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_is_kept_under_its_type() {
        let mut kept = Kept::default();
        assert_eq!(kept.get::<u8>(), None);
        kept.put(1_u8);
        kept.put("two".to_owned());
        assert_eq!(kept.get::<u8>(), None);
        assert_eq!(kept.get::<String>().map(String::as_str), Some("two"));
        assert_eq!(kept.take::<String>().as_deref(), Some("two"));
        assert_eq!(Kept::default().take::<String>(), None);
    }
}
