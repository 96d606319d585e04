//! Lengths, distances and limits as words: `0.001`, `0.01%`, `boundary:1%`, `edges:12,area:5%`, `faces:12`.

use std::str::FromStr;

use crate::{Distance, FillLimits, FillLoops, PlanError, Reach, SmallComponents};

impl FromStr for Reach {
    type Err = PlanError;

    /// A length such as `0.001`, or a percentage such as `0.01%`.
    fn from_str(word: &str) -> Result<Self, PlanError> {
        let number = word.strip_suffix('%').unwrap_or(word).trim().parse::<f64>();
        match (number.ok().filter(|number| number.is_finite() && *number >= 0.0), word.ends_with('%')) {
            (None, _) => Err(expected("a length such as 0.001, or a percentage such as 0.01%")),
            (Some(length), false) => Ok(Reach::Absolute(length)),
            (Some(percentage), true) => Ok(Reach::Relative(percentage / 100.0)),
        }
    }
}

impl FromStr for Distance {
    type Err = PlanError;

    /// `exact`, `single`, `auto`, a length, or a percentage of the bounding box's diagonal; the last two also behind `boundary:`.
    fn from_str(word: &str) -> Result<Self, PlanError> {
        match word {
            "exact" => return Ok(Distance::Exact),
            "single" => return Ok(Distance::Single),
            "auto" => return Ok(Distance::Auto),
            _ => {}
        }
        let (length, is_boundary) = match word.strip_prefix("boundary:") {
            Some(length) => (length, true),
            None => (word, false),
        };
        let distance = "none, exact, single, auto, a length such as 0.001, a percentage such as 0.01%, or boundary: with \
                        either of these";
        Ok(match (length.parse().map_err(|_: PlanError| expected(distance))?, is_boundary) {
            (Reach::Absolute(length), false) => Distance::Absolute(length),
            (Reach::Relative(part), false) => Distance::Relative(part),
            (Reach::Absolute(length), true) => Distance::Boundary(length),
            (Reach::Relative(part), true) => Distance::BoundaryRelative(part),
        })
    }
}

impl FromStr for FillLoops {
    type Err = PlanError;

    /// `all`, or limits such as `edges:12,length:5%,area:0.5`.
    fn from_str(word: &str) -> Result<Self, PlanError> {
        let no_limit = || expected("all, off, or limits such as edges:12,length:5%,area:0.5");
        if word == "all" {
            return Ok(FillLoops::All);
        }
        let mut limits = FillLimits::default();
        let mut named: Vec<&str> = Vec::new();
        for limit in word.split(',') {
            let (name, size) = limit.split_once(':').ok_or_else(no_limit)?;
            if named.contains(&name) {
                return Err(PlanError::new(format!("{name} is limited twice")));
            }
            named.push(name);
            match name {
                "edges" => limits.edges = Some(size.parse().map_err(|_| no_limit())?),
                "length" => limits.length = Some(size.parse().map_err(|_| no_limit())?),
                "area" => limits.area = Some(size.parse().map_err(|_| no_limit())?),
                _ => return Err(no_limit()),
            }
        }
        Ok(FillLoops::Within(limits))
    }
}

impl FromStr for SmallComponents {
    type Err = PlanError;

    /// `faces:12`, `area:0.5` or `volume:0.1`.
    fn from_str(word: &str) -> Result<Self, PlanError> {
        let expected = || expected("a limit such as faces:12, area:0.5 or volume:0.1");
        let (name, limit) = word.split_once(':').ok_or_else(expected)?;
        let number = || match limit.parse::<f64>() {
            Ok(number) if number.is_finite() && number >= 0.0 => Ok(number),
            _ => Err(expected()),
        };
        match name {
            "faces" => limit.parse().map(SmallComponents::Faces).map_err(|_| expected()),
            "area" => number().map(SmallComponents::Area),
            "volume" => number().map(SmallComponents::Volume),
            _ => Err(expected()),
        }
    }
}

fn expected(what: &str) -> PlanError {
    PlanError::new(format!("expected {what}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_of_holes_are_a_list() {
        assert_eq!("all".parse(), Ok(FillLoops::All));
        let limits = FillLimits {
            edges: Some(12),
            length: Some(Reach::Relative(0.5)),
            area: Some(Reach::Absolute(0.25)),
        };
        assert_eq!("edges:12,length:50%,area:0.25".parse(), Ok(FillLoops::Within(limits)));
        for wrong in
            ["", "edges", "edges:-1", "edges:1%", "length:nan", "area:-2", "depth:1", "edges:1,edges:2"]
        {
            assert!(wrong.parse::<FillLoops>().is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_component_is_too_small_by_one_figure() {
        assert_eq!("faces:12".parse(), Ok(SmallComponents::Faces(12)));
        assert_eq!("area:0.5".parse(), Ok(SmallComponents::Area(0.5)));
        assert_eq!("volume:1e-3".parse(), Ok(SmallComponents::Volume(1e-3)));
        for wrong in ["", "faces", "faces:-1", "faces:0.5", "area:nan", "volume:-1", "length:1", "area:5%"] {
            assert!(wrong.parse::<SmallComponents>().is_err(), "{wrong}");
        }
    }

    #[test]
    fn lengths_are_numbers_or_percentages() {
        assert_eq!("0".parse(), Ok(Reach::Absolute(0.0)));
        assert_eq!("0.5%".parse(), Ok(Reach::Relative(0.005)));
        for wrong in ["", "%", "-1", "nan", "inf", "1 mm"] {
            assert!(wrong.parse::<Reach>().is_err(), "{wrong}");
        }
    }
}
