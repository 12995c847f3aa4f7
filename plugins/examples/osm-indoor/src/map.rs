//! An OpenStreetMap map in the making: nodes are grains, ways are lists of them.

use crate::grain::Grain;
use crate::tags::Tags;
use std::collections::BTreeMap;

/// A map in the making.
#[derive(Debug, Default)]
pub struct Map {
    /// The nodes of all ways, and those with tags.
    pub nodes: BTreeMap<Grain, Tags>,
    /// The ways, closed or not.
    pub ways: Vec<Way>,
    /// The relations, all of them multipolygons.
    pub relations: Vec<Relation>,
    /// The closed ways by their nodes, so that a room in the hole of another one shares its outline.
    rings: BTreeMap<Vec<Grain>, usize>,
}

/// A way.
#[derive(Debug)]
pub struct Way {
    /// What it is, for its identifier.
    pub corners: Vec<Grain>,
    /// Where it runs; the first one is repeated if it is closed.
    pub nodes: Vec<Grain>,
    /// Keys and values.
    pub tags: Tags,
}

/// A multipolygon.
#[derive(Debug)]
pub struct Relation {
    /// What it is, for its identifier.
    pub corners: Vec<Grain>,
    /// Indices of ways, the outer one first.
    pub members: Vec<usize>,
    /// Keys and values.
    pub tags: Tags,
}

impl Map {
    /// Puts tags on a node.
    pub fn tag_node(&mut self, node: Grain, tags: Tags) {
        self.nodes.insert(node, tags);
    }

    /// Adds an open way of at least two nodes; `corners` are what it is.
    pub fn add_line(&mut self, corners: Vec<Grain>, nodes: Vec<Grain>, tags: Tags) {
        self.add(Way { corners, nodes, tags });
    }

    /// Adds a closed way through these nodes, the first of which is not repeated; its index. An untagged one that is
    /// there already serves again, and so does any if no tags are asked for.
    pub fn add_ring(&mut self, corners: Vec<Grain>, mut nodes: Vec<Grain>, tags: Tags) -> usize {
        let ring = canonical(&nodes);
        if let Some(&index) = self.rings.get(&ring) {
            let there = &mut self.ways[index].tags;
            if tags.0.is_empty() || there.0.is_empty() {
                there.0.extend(tags.0);
                return index;
            }
        }
        nodes.extend(nodes.first().copied());
        let index = self.add(Way { corners, nodes, tags });
        self.rings.insert(ring, index);
        index
    }

    /// Adds a multipolygon of closed ways, the outer one first; `corners` are what it is.
    pub fn add_multipolygon(&mut self, corners: Vec<Grain>, members: Vec<usize>, tags: Tags) {
        let mut all = Tags::default().with("type", "multipolygon");
        all.0.extend(tags.0);
        self.relations.push(Relation { corners, members, tags: all });
    }

    fn add(&mut self, way: Way) -> usize {
        for &node in &way.nodes {
            self.nodes.entry(node).or_default();
        }
        self.ways.push(way);
        self.ways.len() - 1
    }
}

/// The ring from its least node on, towards the lesser neighbour: the same for all that run through the same nodes.
fn canonical(ring: &[Grain]) -> Vec<Grain> {
    let mut ring = ring.to_vec();
    if let Some(least) = (0..ring.len()).min_by_key(|&i| ring[i]) {
        ring.rotate_left(least);
        if ring.len() > 2 && ring[1] > ring[ring.len() - 1] {
            ring[1..].reverse();
        }
    }
    ring
}
