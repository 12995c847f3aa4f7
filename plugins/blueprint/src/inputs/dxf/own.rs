//! What planform's own drawings say of their entities beyond what is seen: their extended data.

use super::drawing::Entity;

/// The application that extended data of planform's drawings belong to.
const APPLICATION: &str = "PLANFORM";

/// Codes of extended data: an application's name, and a text.
const NAME: i32 = 1001;
const TEXT: i32 = 1000;

/// The value of a key, if the entity has it: keys and values follow each other.
pub fn value<'a>(entity: &Entity<'a>, key: &str) -> Option<&'a str> {
    let start = entity.pairs.iter().position(|p| p.code == NAME && p.value == APPLICATION)? + 1;
    let data = &entity.pairs[start..];
    let end = data.iter().position(|p| p.code == NAME).unwrap_or(data.len());
    data[..end]
        .chunks_exact(2)
        .find(|pair| pair[0].code == TEXT && pair[0].value == key)
        .map(|pair| pair[1].value)
}

/// Whether a line is that of a door, from jamb to jamb.
pub fn is_door(entity: &Entity<'_>) -> bool {
    match value(entity, "kind") {
        Some("door") => true,
        Some("symbol") => value(entity, "content").is_some_and(|c| planform_sdk::DOOR_KINDS.contains(&c)),
        _ => false,
    }
}

/// Whether a text is the number by which a drawing calls a room that has no name.
pub fn is_number(entity: &Entity<'_>) -> bool {
    let called = |number: &str| entity.text(1).is_some_and(|t| t.strip_prefix("Room ") == Some(number));
    value(entity, "kind") == Some("label") && value(entity, "room").is_some_and(called)
}

#[cfg(test)]
mod tests {
    use super::super::pairs::Pair;
    use super::*;

    fn entity<'a>(kind: &'a str, pairs: &'a [Pair<'a>]) -> Entity<'a> {
        Entity { kind, pairs, parts: &[] }
    }

    fn pairs<'a>(pairs: &[(i32, &'a str)]) -> Vec<Pair<'a>> {
        pairs.iter().map(|&(code, value)| Pair { code, value }).collect()
    }

    #[test]
    fn values_are_those_of_our_own_data() {
        let other = [(1001, "ACAD"), (1000, "kind"), (1000, "door")];
        let own = [(1001, "PLANFORM"), (1000, "room"), (1071, "3"), (1000, "kind"), (1000, "label")];
        let both = pairs(&[&[(1, "Room 3")][..], &other, &own, &other].concat());
        let label = entity("TEXT", &both);
        assert_eq!((value(&label, "kind"), value(&label, "room")), (Some("label"), Some("3")));
        assert_eq!(value(&label, "3"), None);
        assert!(is_number(&label) && !is_door(&label));
        let named = pairs(&[&[(1, "Room 4")][..], &own].concat());
        assert!(!is_number(&entity("TEXT", &named)));
        assert!(!is_door(&entity("LINE", &pairs(&other))));
    }
}
