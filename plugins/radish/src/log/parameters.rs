//! What a log's `PARAM` messages say of the lasers.

/// The parameters that matter here, as far as the log states them.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Parameters {
    /// How far the front laser lies ahead of the robot's middle, metres.
    pub front_offset: Option<f64>,
    /// How far the rear laser lies ahead of the robot's middle, metres; as a rule negative.
    pub rear_offset: Option<f64>,
    /// Where the front laser's echoes end, metres.
    pub front_max_range: Option<f64>,
    /// The front laser's field of view, radians.
    pub front_view: Option<f64>,
    /// Turn from one beam of the front laser to the next, radians.
    pub front_step: Option<f64>,
}

impl Parameters {
    /// Takes note of a parameter. What is no finite number is passed over, as is every other parameter.
    pub fn take(&mut self, name: &str, value: &str) {
        let Some(value) = value.parse().ok().filter(|v: &f64| v.is_finite()) else { return };
        match name {
            "robot_frontlaser_offset" => self.front_offset = Some(value),
            "robot_rearlaser_offset" => self.rear_offset = Some(value),
            "robot_front_laser_max" | "laser_max_range" if value > 0.0 => self.front_max_range = Some(value),
            "laser_front_laser_fov" if value > 0.0 => self.front_view = Some(radians(value)),
            "laser_front_laser_resolution" if value > 0.0 => self.front_step = Some(value.to_radians()),
            _ => {}
        }
    }
}

/// Logs state the field of view in degrees or in radians, and no laser sees less than 7 degrees.
fn radians(value: f64) -> f64 {
    if value > std::f64::consts::TAU + 1e-3 { value.to_radians() } else { value }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn fields_of_view_are_in_degrees_or_in_radians() {
        let view = |value| {
            let mut parameters = Parameters::default();
            parameters.take("laser_front_laser_fov", value);
            parameters.front_view
        };
        assert_eq!(view("180"), Some(PI));
        assert_eq!(view("3.25"), Some(3.25));
        for bad in ["0", "-1", "nan", "inf", "x"] {
            assert_eq!(view(bad), None, "{bad}");
        }
    }

    #[test]
    fn other_parameters_are_passed_over() {
        let mut parameters = Parameters::default();
        parameters.take("robot_length", "0.5");
        assert_eq!(parameters, Parameters::default());
        parameters.take("robot_frontlaser_offset", "-0.25");
        assert_eq!(parameters.front_offset, Some(-0.25));
    }
}
