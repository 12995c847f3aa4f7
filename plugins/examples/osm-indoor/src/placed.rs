//! A map as it is written: laid on the Earth, every object with its identifier.

use crate::earth::{Earth, Place};
use crate::grain::Grain;
use crate::identity;
use crate::map::{Map, Relation, Way};
use crate::tags::Tags;
use planform_sdk::{ErrorKind, PluginError};
use std::cmp::Reverse;
use std::collections::BTreeMap;

/// An object with its identifier.
#[derive(Debug)]
pub struct Placed<T> {
    /// Below 0.
    pub id: i64,
    /// What it is made of: a node's place, the nodes of a way, the ways of a relation, the outer one first.
    pub body: T,
    /// Keys and values.
    pub tags: Tags,
}

/// A map on the Earth. All objects are in the order of their identifiers, from -1 down.
#[derive(Debug)]
pub struct PlacedMap {
    /// The nodes.
    pub nodes: Vec<Placed<Place>>,
    /// The ways.
    pub ways: Vec<Placed<Vec<i64>>>,
    /// The relations, all of them multipolygons.
    pub relations: Vec<Placed<Vec<i64>>>,
}

impl PlacedMap {
    /// The map on the Earth, its identifiers those of this level.
    pub fn new(map: Map, earth: &Earth, level: &str) -> Result<Self, PluginError> {
        let ids = Ids::of(&map, level);
        let places = map.nodes.keys().map(|&node| Ok((node, earth.place(node.point())?)));
        let places = places.collect::<Result<BTreeMap<_, _>, PluginError>>()?;
        map.ways.iter().try_for_each(|way| check_antimeridian(way, &places))?;
        let nodes = map.nodes.into_iter().map(|(node, tags)| {
            let (id, body) = (ids.nodes[&node], places[&node]);
            Placed { id, body, tags }
        });
        let ways = ids.ways.iter().zip(map.ways).map(|(&id, Way { nodes, tags, .. })| {
            let body = nodes.iter().map(|node| ids.nodes[node]).collect();
            Placed { id, body, tags }
        });
        let relations = ids.relations.iter().zip(map.relations);
        let relations = relations.map(|(&id, Relation { members, tags, .. })| {
            let body = members.into_iter().map(|way| ids.ways[way]).collect();
            Placed { id, body, tags }
        });
        Ok(Self { nodes: sorted(nodes), ways: sorted(ways), relations: sorted(relations) })
    }
}

/// The identifiers of all objects of a map.
struct Ids {
    nodes: BTreeMap<Grain, i64>,
    ways: Vec<i64>,
    relations: Vec<i64>,
}

impl Ids {
    fn of(map: &Map, level: &str) -> Self {
        let assign = |kind: &str, objects: Vec<&[Grain]>| {
            let kind = format!("{kind} {level}");
            let keys: Vec<_> = objects.into_iter().map(|corners| (kind.clone(), corners.to_vec())).collect();
            identity::assign(&keys)
        };
        let nodes = assign("node", map.nodes.keys().map(std::slice::from_ref).collect());
        Self {
            nodes: map.nodes.keys().copied().zip(nodes).collect(),
            ways: assign("way", map.ways.iter().map(|w| w.corners.as_slice()).collect()),
            relations: assign("relation", map.relations.iter().map(|r| r.corners.as_slice()).collect()),
        }
    }
}

fn sorted<T>(objects: impl IntoIterator<Item = Placed<T>>) -> Vec<Placed<T>> {
    let mut objects: Vec<_> = objects.into_iter().collect();
    objects.sort_by_key(|o| Reverse(o.id));
    objects
}

/// OpenStreetMap's longitudes end at 180 degrees: a way across, or on it, would run around the whole Earth.
fn check_antimeridian(way: &Way, places: &BTreeMap<Grain, Place>) -> Result<(), PluginError> {
    let longitudes: Vec<f64> = way.nodes.iter().map(|node| places[node].longitude).collect();
    if longitudes.windows(2).all(|l| (l[0] - l[1]).abs() <= 180.0) {
        return Ok(());
    }
    let message = "the layout lies across the 180th meridian, where OpenStreetMap's longitudes end";
    Err(PluginError::new(ErrorKind::Unsupported, message)
        .advise("check the anchor, or write GeoJSON, which can hold it"))
}
