//! What a layout's things are in OpenStreetMap.

use crate::corridor::is_corridor;
use crate::fit::Outlines;
use crate::grain::{self, Grain};
use crate::identity;
use crate::map::Map;
use crate::tags::Tags;
use crate::thread::Nodes;
use planform_sdk::{
    Boundary, ErrorKind, Layout, Opening, OpeningKind, Options, PluginError, Point, Room, RoomState, Wall,
};

/// The map of a layout.
pub fn of_layout(layout: &Layout, options: &Options, level: &str) -> Result<Map, PluginError> {
    let boundary = Boundary::chosen(options);
    let outlines = outlines(layout, boundary)?;
    let rooms = layout.rooms.iter().map(|room| room.id).zip(outlines.iter().map(Vec::as_slice));
    // Along the inner faces, no outline is a place for a wall.
    let fit = Outlines::new(rooms.filter(|_| boundary == Boundary::Centre));
    let walls = walls(layout, &fit)?;
    let doors = doors(layout, &fit)?;
    let corners = outlines.iter().flatten().flatten().chain(walls.iter().flatten());
    let nodes = Nodes::new(corners.chain(&doors).copied());

    let mut map = Map::default();
    for (room, rings) in layout.rooms.iter().zip(&outlines) {
        add_room(&mut map, room_tags(room, layout, level), rings, &nodes)
            .map_err(|e| inside("room", room.id, e))?;
    }
    for (wall, &ends) in layout.walls.iter().zip(&walls) {
        add_wall(&mut map, wall_tags(wall, level), ends, &nodes);
    }
    for (opening, &node) in layout.openings.iter().zip(&doors) {
        map.tag_node(node, opening_tags(opening, level));
    }
    Ok(map)
}

/// The rings of each room, its exterior first.
fn outlines(layout: &Layout, boundary: Boundary) -> Result<Vec<Vec<Vec<Grain>>>, PluginError> {
    let ring = |ring: &[Point]| ring.iter().map(|&p| Grain::of(p)).collect::<Result<Vec<_>, _>>();
    let rings = |room: &Room| boundary.of(room).rings().map(ring).collect::<Result<Vec<_>, _>>();
    layout.rooms.iter().map(|room| rings(room).map_err(|e| inside("room", room.id, e))).collect()
}

/// The ends of each wall.
fn walls(layout: &Layout, fit: &Outlines<'_>) -> Result<Vec<[Grain; 2]>, PluginError> {
    let place = |(n, wall): (u32, &Wall)| match grain::ends(&wall.line) {
        Ok(ends) => Ok(fit.wall(ends, wall.rooms)),
        Err(e) => Err(inside("wall", n, e)),
    };
    (1..).zip(&layout.walls).map(place).collect()
}

/// The node of each opening.
fn doors(layout: &Layout, fit: &Outlines<'_>) -> Result<Vec<Grain>, PluginError> {
    let place = |(n, opening): (u32, &Opening)| match grain::ends(&opening.segment) {
        Ok(jambs) => Ok(fit.door(jambs, opening.rooms)),
        Err(e) => Err(inside("opening", n, e)),
    };
    (1..).zip(&layout.openings).map(place).collect()
}

fn add_room(map: &mut Map, tags: Tags, rings: &[Vec<Grain>], nodes: &Nodes) -> Result<(), PluginError> {
    let threaded = rings.iter().map(|ring| closed(nodes.ring(ring))).collect::<Result<Vec<_>, _>>()?;
    let corners: Vec<Vec<Grain>> = rings.iter().map(|ring| identity::of_ring(ring)).collect();
    if let ([corners], [nodes]) = (corners.as_slice(), threaded.as_slice()) {
        map.add_ring(corners.clone(), nodes.clone(), tags);
        return Ok(());
    }
    let all = corners.concat();
    let ways = corners.into_iter().zip(threaded);
    let members = ways.map(|(corners, nodes)| map.add_ring(corners, nodes, Tags::default())).collect();
    map.add_multipolygon(all, members, tags);
    Ok(())
}

fn closed(ring: Vec<Grain>) -> Result<Vec<Grain>, PluginError> {
    if ring.len() >= 3 {
        return Ok(ring);
    }
    let message = format!("a ring has {} distinct corners at 1 mm, and it needs 3", ring.len());
    Err(PluginError::new(ErrorKind::BadInput, message)
        .advise("correct the layout, or try the option boundary with its other value"))
}

fn add_wall(map: &mut Map, tags: Tags, ends: [Grain; 2], nodes: &Nodes) {
    let line = nodes.line(ends);
    // A wall shorter than a grain is not there.
    if line.len() >= 2 {
        map.add_line(identity::of_line(ends), line, tags);
    }
}

fn room_tags(room: &Room, layout: &Layout, level: &str) -> Tags {
    let kind = if is_corridor(room, layout) { "corridor" } else { "room" };
    let tags = Tags::indoor(kind, level).with_name(room.name.as_deref().unwrap_or_default());
    match room.state {
        RoomState::Complete => tags,
        RoomState::Partial => tags.with("note", "seen in part only, the rest of the outline is an estimate"),
    }
}

fn wall_tags(wall: &Wall, level: &str) -> Tags {
    Tags::indoor("wall", level).with_width(wall.thickness)
}

fn opening_tags(opening: &Opening, level: &str) -> Tags {
    let door = match opening.kind {
        OpeningKind::Door => "yes",
        OpeningKind::Passage => "no",
    };
    Tags::indoor("door", level).with("door", door).with_width(opening.width())
}

/// The error with the thing that it befell.
fn inside(kind: &str, number: u32, e: PluginError) -> PluginError {
    PluginError { message: format!("{kind} {number}: {}", e.message), ..e }
}
