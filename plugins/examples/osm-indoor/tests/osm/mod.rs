//! An OpenStreetMap file as its readers see it.

use planform_sdk::{Point, ring_signed_area};
use roxmltree::{Document, Node as Element};
use std::collections::BTreeMap;

pub type Tags = BTreeMap<String, String>;

#[derive(Debug)]
pub struct Node {
    pub lat: String,
    pub lon: String,
    pub tags: Tags,
}

#[derive(Debug)]
pub struct Way {
    pub nodes: Vec<String>,
    pub tags: Tags,
}

#[derive(Debug)]
pub struct Relation {
    /// Way and role.
    pub members: Vec<(String, String)>,
    pub tags: Tags,
}

/// A file; objects by their identifiers.
pub struct Osm {
    pub nodes: BTreeMap<String, Node>,
    pub ways: BTreeMap<String, Way>,
    pub relations: BTreeMap<String, Relation>,
}

impl Node {
    fn read(element: Element<'_, '_>) -> Self {
        Self { lat: attribute(element, "lat"), lon: attribute(element, "lon"), tags: tags(element) }
    }
}

impl Relation {
    fn read(element: Element<'_, '_>) -> Self {
        let member = |m: Element<'_, '_>| {
            assert_eq!(attribute(m, "type"), "way");
            (attribute(m, "ref"), attribute(m, "role"))
        };
        Self { members: children(element, "member").map(member).collect(), tags: tags(element) }
    }
}

impl Way {
    fn read(element: Element<'_, '_>) -> Self {
        Self { nodes: children(element, "nd").map(|n| attribute(n, "ref")).collect(), tags: tags(element) }
    }

    pub fn is_closed(&self) -> bool {
        self.nodes.len() > 3 && self.nodes.first() == self.nodes.last()
    }
}

fn attribute(element: Element<'_, '_>, name: &str) -> String {
    element.attribute(name).unwrap().to_owned()
}

fn children<'a>(element: Element<'a, 'a>, name: &str) -> impl Iterator<Item = Element<'a, 'a>> {
    element.children().filter(move |c| c.has_tag_name(name))
}

fn tags(element: Element<'_, '_>) -> Tags {
    let all: Vec<_> = children(element, "tag").map(|t| (attribute(t, "k"), attribute(t, "v"))).collect();
    let tags: Tags = all.iter().cloned().collect();
    assert_eq!(tags.len(), all.len(), "a key is there twice: {all:?}");
    tags
}

/// The objects of this kind, no identifier being there twice and each below 0.
fn objects<T>(osm: Element<'_, '_>, kind: &str, of: impl Fn(Element<'_, '_>) -> T) -> BTreeMap<String, T> {
    let all: Vec<_> = children(osm, kind).map(|e| (attribute(e, "id"), of(e))).collect();
    assert!(all.iter().all(|(id, _)| id.parse::<i64>().unwrap() < 0));
    let count = all.len();
    let objects: BTreeMap<_, _> = all.into_iter().collect();
    assert_eq!(objects.len(), count, "an identifier is there twice");
    objects
}

impl Osm {
    pub fn read(text: &str) -> Self {
        let document = Document::parse(text).unwrap();
        let osm = document.root_element();
        assert_eq!((osm.tag_name().name(), osm.attribute("version")), ("osm", Some("0.6")));
        Self {
            nodes: objects(osm, "node", Node::read),
            ways: objects(osm, "way", Way::read),
            relations: objects(osm, "relation", Relation::read),
        }
    }

    /// References resolve, ways have at least two nodes and none twice in a row, areas are closed.
    pub fn check(&self) {
        for way in self.ways.values() {
            assert!(way.nodes.iter().all(|n| self.nodes.contains_key(n)));
            assert!(way.nodes.len() >= 2 && way.nodes.windows(2).all(|n| n[0] != n[1]), "{way:?}");
            let is_wall = way.tags.get("indoor").is_some_and(|v| v == "wall");
            assert!(way.is_closed() || is_wall, "{way:?}");
        }
        let members = || self.relations.values().flat_map(|r| &r.members);
        assert!(members().all(|m| self.ways[&m.0].is_closed()));
        let in_a_relation = |id: &String| members().any(|m| m.0 == *id);
        assert!(self.ways.iter().all(|(id, way)| !way.tags.is_empty() || in_a_relation(id)));
        let used = |id| self.ways.values().any(|w| w.nodes.contains(id));
        assert!(self.nodes.iter().all(|(id, node)| used(id) || node.tags.contains_key("door")));
    }

    pub fn all_tags(&self) -> impl Iterator<Item = &Tags> {
        let nodes = self.nodes.values().map(|n| &n.tags);
        let ways = self.ways.values().map(|w| &w.tags);
        nodes.chain(ways).chain(self.relations.values().map(|r| &r.tags))
    }

    /// The tags of all objects with this one.
    pub fn tagged(&self, key: &str, value: &str) -> impl Iterator<Item = &Tags> {
        self.all_tags().filter(move |t| t.get(key).is_some_and(|v| v == value))
    }

    /// The areas of all rooms and corridors, square metres on the ground.
    pub fn room_areas(&self) -> Vec<f64> {
        let is_room = |t: &Tags| t.get("indoor").is_some_and(|v| v == "room" || v == "corridor");
        let simple = self.ways.values().filter(|w| is_room(&w.tags)).map(|w| self.area(w));
        let outer = |role: &str| if role == "outer" { 1.0 } else { -1.0 };
        let whole = |r: &Relation| r.members.iter().map(|m| outer(&m.1) * self.area(&self.ways[&m.0])).sum();
        let holed = self.relations.values().filter(|r| is_room(&r.tags)).map(whole);
        simple.chain(holed).collect()
    }

    /// The area of a closed way, by WGS 84's radii of curvature at its first node.
    fn area(&self, way: &Way) -> f64 {
        let degrees = |id: &String| {
            let node = &self.nodes[id];
            (node.lon.parse::<f64>().unwrap(), node.lat.parse::<f64>().unwrap())
        };
        let origin = degrees(&way.nodes[0]);
        let (a, e2) = (6_378_137.0, 0.006_694_379_990_14);
        let sin = origin.1.to_radians().sin();
        let w = (1.0 - e2 * sin * sin).sqrt();
        let (east, north) = (a / w * origin.1.to_radians().cos(), a * (1.0 - e2) / w.powi(3));
        let metres = |id| {
            let (lon, lat) = degrees(id);
            Point::new((lon - origin.0).to_radians() * east, (lat - origin.1).to_radians() * north)
        };
        ring_signed_area(&way.nodes[1..].iter().map(metres).collect::<Vec<_>>()).abs()
    }
}
