//! Refuses layouts that would make a broken drawing.

use planform_sdk::{Boundary, ErrorKind, Layout, PluginError, Point, Polygon, Pose, Segment};

/// The largest number written, metres: at this distance a number still has tenths of a millimetre.
const LARGEST: f64 = 1e12;

type Checked = Result<(), PluginError>;

/// Checks every number of the layout, and that each room has proper rings. The outline `boundary` is drawn.
pub fn check(layout: &Layout, boundary: Boundary) -> Checked {
    for room in &layout.rooms {
        polygon(boundary.of(room), &format!("room {}", room.id))?;
    }
    for (i, wall) in layout.walls.iter().enumerate() {
        segment(&wall.line, || format!("wall {}", i + 1))?;
        numbers(&[wall.thickness, wall.weight], || format!("wall {}", i + 1))?;
    }
    for (i, opening) in layout.openings.iter().enumerate() {
        segment(&opening.segment, || format!("opening {}", i + 1))?;
    }
    for (i, frontier) in layout.frontiers.iter().enumerate() {
        segment(&frontier.segment, || format!("frontier {}", i + 1))?;
        numbers(&[frontier.area], || format!("frontier {}", i + 1))?;
    }
    for (i, text) in layout.texts.iter().enumerate() {
        placed(&text.pose, &[text.width, text.height, text.confidence], || format!("text {}", i + 1))?;
    }
    for (i, symbol) in layout.symbols.iter().enumerate() {
        let whose = || format!("symbol {}", i + 1);
        placed(&symbol.pose, &[symbol.width, symbol.height, symbol.score], whose)?;
        symbol.leaves.iter().flat_map(|l| [l.hinge, l.closed, l.open]).try_for_each(|p| point(p, whose))?;
    }
    Ok(())
}

fn polygon(polygon: &Polygon, whose: &str) -> Checked {
    for ring in polygon.rings() {
        if ring.len() < 3 {
            let message = format!("{whose} has a ring of {} points, and a ring takes 3", ring.len());
            return Err(refuse(message));
        }
        ring.iter().try_for_each(|&p| point(p, || whose.to_owned()))?;
    }
    Ok(())
}

fn segment(s: &Segment, whose: impl Fn() -> String) -> Checked {
    point(s.a, &whose)?;
    point(s.b, &whose)
}

fn placed(pose: &Pose, others: &[f64], whose: impl Fn() -> String) -> Checked {
    numbers(&[pose.x, pose.y, pose.yaw], &whose)?;
    numbers(others, &whose)
}

fn point(p: Point, whose: impl Fn() -> String) -> Checked {
    numbers(&[p.x, p.y], whose)
}

fn numbers(values: &[f64], whose: impl Fn() -> String) -> Checked {
    match values.iter().find(|v| !v.is_finite() || v.abs() > LARGEST) {
        Some(v) => Err(refuse(format!("{} has the number {v}, which a drawing cannot hold", whose()))),
        None => Ok(()),
    }
}

fn refuse(message: String) -> PluginError {
    PluginError::new(ErrorKind::BadInput, message)
        .advise("the layout is damaged; check what made it, such as the input's resolution and origin")
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_sdk::{Room, RoomState, Wall};

    fn room(points: &[[f64; 2]]) -> Layout {
        let inner = Polygon { exterior: points.iter().copied().map(Point::from).collect(), holes: vec![] };
        let centre = Polygon::default();
        let room = Room { id: 7, name: None, stated_area: None, state: RoomState::Complete, inner, centre };
        Layout { rooms: vec![room], ..Layout::default() }
    }

    fn complaint(layout: &Layout) -> String {
        check(layout, Boundary::Inner).unwrap_err().to_string()
    }

    #[test]
    fn numbers_that_are_none_are_refused() {
        for bad in [f64::NAN, f64::INFINITY, 1e13] {
            let message = complaint(&room(&[[0.0, 0.0], [1.0, bad], [1.0, 1.0]]));
            assert!(message.starts_with(&format!("room 7 has the number {bad}")), "{message}");
        }
        let line = Segment::new(Point::default(), Point::new(1.0, 0.0));
        let wall = Wall { line, thickness: f64::NAN, weight: 1.0, rooms: [None, None] };
        let layout = Layout { walls: vec![wall], ..Layout::default() };
        assert!(complaint(&layout).starts_with("wall 1 has"));
    }

    #[test]
    fn a_ring_of_two_points_is_refused() {
        assert!(complaint(&room(&[[0.0, 0.0], [1.0, 1.0]])).contains("ring of 2 points"));
    }

    #[test]
    fn a_sound_layout_passes() {
        assert!(check(&room(&[[0.0, 0.0], [1e6, 0.0], [1e6, 1e6]]), Boundary::Inner).is_ok());
    }
}
