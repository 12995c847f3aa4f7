//! The fields of a line, which are separated by blanks.

use super::Pose;

/// The farthest that a pose may lie from the origin, metres.
const FARTHEST: f64 = 1e6;
/// The most readings of one message.
const MOST_READINGS: usize = 20_000;

/// What is wrong with a line, in words.
pub type Damage = String;

/// The fields of a line that are still to be read.
#[derive(Clone)]
pub struct Fields<'a>(std::str::SplitAsciiWhitespace<'a>);

impl<'a> Fields<'a> {
    /// The fields of this line.
    pub fn of(line: &'a str) -> Self {
        Self(line.split_ascii_whitespace())
    }

    /// The next field.
    pub fn text(&mut self) -> Option<&'a str> {
        self.0.next()
    }

    /// How many fields there still are.
    pub fn left(&self) -> usize {
        self.0.clone().count()
    }

    /// Passes over all but the last `count` fields.
    pub fn skip_to_last(&mut self, count: usize) {
        if let Some(passed) = self.left().checked_sub(count + 1) {
            self.0.nth(passed);
        }
    }

    /// The next field, which must be a number, and `what` says what it means; it may be infinite or NaN.
    pub fn number(&mut self, what: &str) -> Result<f64, Damage> {
        let field = self.text().ok_or_else(|| format!("it ends before {what}"))?;
        field.parse().map_err(|_| format!("`{}` is no number for {what}", shortened(field)))
    }

    /// The next field, which must be a number that is finite.
    pub fn finite(&mut self, what: &str) -> Result<f64, Damage> {
        let number = self.number(what)?;
        if number.is_finite() { Ok(number) } else { Err(format!("{what} is {number}")) }
    }

    /// How many readings follow, and these.
    pub fn readings(&mut self, what: &str) -> Result<Vec<f32>, Damage> {
        let count = self.number(&format!("the number of {what}"))?;
        if !(count >= 0.0 && count <= MOST_READINGS as f64 && count.fract() == 0.0) {
            return Err(format!("it claims {count} {what}, of which it can have 0 to {MOST_READINGS}"));
        }
        let count = count as usize;
        if count > self.left() {
            return Err(format!("it claims {count} {what} and has fewer"));
        }
        (0..count).map(|_| self.number(what).map(|v| v as f32)).collect()
    }

    /// The next three fields as a pose.
    pub fn pose(&mut self, whose: &str) -> Result<Pose, Damage> {
        let [x, y, theta] = ["x", "y", "heading"].map(|name| self.finite(&format!("the {whose}'s {name}")));
        let pose = Pose { x: x?, y: y?, theta: theta? };
        if pose.x.abs() > FARTHEST || pose.y.abs() > FARTHEST || pose.theta.abs() > FARTHEST {
            return Err(format!("the {whose} is more than 1000 km or a million radians from the origin"));
        }
        Ok(pose)
    }
}

/// The beginning of a field, for messages, without what would confuse a terminal.
pub fn shortened(field: &str) -> String {
    field.chars().filter(|c| !c.is_control()).take(20).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn readings_are_counted_before_they_are_read() {
        let readings = |line| Fields::of(line).readings("readings");
        assert_eq!(readings("3 1 2.5 nan").unwrap()[..2], [1.0, 2.5]);
        for bad in ["3 1 2", "-1", "1e9 1", "nan", "1.5 1 2", "", "x", "1 x"] {
            assert!(readings(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn poses_are_finite_and_near() {
        let pose = |line| Fields::of(line).pose("laser");
        assert_eq!(pose("1 -2 1e1 rest").unwrap(), Pose { x: 1.0, y: -2.0, theta: 10.0 });
        for bad in ["1 2", "1 2 nan", "inf 2 3", "1e300 2 3", "1 -2e6 3", "1 2 x"] {
            assert!(pose(bad).is_err(), "{bad}");
        }
    }
}
