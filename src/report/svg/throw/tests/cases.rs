//! Answers to draw: the triangle of the paper with a pattern like its own, and regular polygons with many edges.

use super::super::super::super::Toss;
use crate::answer::{
    BestSetting, Certificate, CommonGrasp, Component, Design, EdgeReach, GraspEdge, Hybrid, LimitSet, LimitSets, Reach,
    Sensor, SensorWindow, Setting, SettingKind, Throw,
};
use crate::exact::{Q, Surd, ratio, to_f64};
use crate::geometry::{Polygon, cross, difference, dot};
use crate::model::{LengthUnit, Part, Shape, Thrower};
use num_traits::Zero as _;
use std::collections::BTreeMap;

/// What there is to draw, with what it is about.
pub(in super::super) struct Drawn {
    pub(in super::super) name: String,
    pub(in super::super) part: Part,
    pub(in super::super) thrower: Thrower,
    pub(in super::super) answer: Throw,
}

impl Drawn {
    pub(in super::super) fn svg(&self) -> String {
        let Self { name, part, thrower, answer } = self;
        super::super::throw(&Toss { name, part, thrower, warnings: &[], settles_first: false }, answer)
    }
}

/// The 6-8-10 triangle; `scale` makes its unit smaller or larger.
pub(in super::super) fn triangle(scale: &Q) -> Drawn {
    let point = |x: i64, y: i64| [ratio(x, 1) * scale, ratio(y, 1) * scale];
    let per = to_f64(scale);
    let (mut orbit, mut at) = (Vec::new(), (1, 9.0));
    while orbit.len() < 200 {
        orbit.push((at.0, at.1 * per));
        at = match at {
            (1, radius) if radius < 22.2 => (1, radius * 1.13 + 0.03 * (radius * 7.0).sin()),
            (1, radius) => (0, radius - 6.0),
            (0, radius) => (2, radius - 4.0),
            (_, radius) => (1, radius - 5.0),
        };
    }
    let com = [ratio(4, 1) * scale, ratio(8, 3) * scale];
    let mut drawn = with_pattern("triangle", vec![point(6, 0), point(6, 8), point(0, 0)], com, orbit, per);
    drawn.answer.limit.sets[0].pattern = vec![1, 0, 2];
    drawn.thrower.offset = ratio(-1, 2) * scale;
    drawn
}

/// A regular polygon, with orbits that visit every edge.
pub(in super::super) fn regular(corners: usize) -> Drawn {
    let corner = |k: usize| {
        let angle = (k as f64 + 0.5) / corners as f64 * std::f64::consts::TAU;
        [angle.sin(), -angle.cos()].map(|part| ratio((part * 5e5) as i64, 100_000))
    };
    let orbit = (0..300).map(|k| ((2 * corners - k % corners) % corners, 20.0 + (k as f64 * 1.7).sin())).collect();
    with_pattern("regular", (0..corners).map(corner).collect(), [Q::zero(), Q::zero()], orbit, 1.0)
}

/// Settings of three offsets and four release speeds, or of fewer.
pub(in super::super) fn design(offsets: usize, releases: usize) -> Design {
    let kinds = [SettingKind::Feeder, SettingKind::Blind, SettingKind::Several, SettingKind::Lost, SettingKind::Open];
    let setting = |place: usize| Setting {
        kind: if place.is_multiple_of(3) { SettingKind::Feeder } else { kinds[place % 5] },
        parts_per_throw: 0.1 + 0.01 * place as f64,
        seconds_per_throw: 0.4,
        edge: Some(1),
        window: Some([25.0, 30.0]),
        grasp_margin: 1.2,
        friction: 0.3,
    };
    Design {
        offsets: (0..offsets).map(|k| -0.75 + 0.25 * k as f64).collect(),
        releases: (0..releases).map(|k| 300.0 + 10.0 * k as f64).collect(),
        settings: (0..offsets * releases).map(setting).collect(),
        margin: 0.05,
        best: Some(BestSetting { place: 0, window: [26.0, 29.0], is_proved: true }),
        why_none: None,
    }
}

fn with_pattern(name: &str, hull: Vec<[Q; 2]>, com: [Q; 2], orbit: Vec<(usize, f64)>, per: f64) -> Drawn {
    let stable: Vec<usize> = (0..hull.len()).collect();
    let edges: Vec<GraspEdge> = stable.iter().map(|edge| edge_of(&hull, &com, *edge)).collect();
    let mut bands: BTreeMap<usize, [f64; 2]> = BTreeMap::new();
    for (edge, radius) in &orbit {
        let band = bands.entry(*edge).or_insert([*radius, *radius]);
        *band = [band[0].min(*radius), band[1].max(*radius)];
    }
    let reach = |edge: usize| EdgeReach {
        edge,
        r_low: 6.0 * per,
        r_flip: Some(22.0 * per),
        r_max: 27.0 * per,
        lowest_image: None,
        pieces: Vec::new(),
    };
    let ends = |edge: usize| [edges[edge].u_left.to_f64(), edges[edge].u_right.to_f64()];
    let footprint = |(edge, band): (&usize, &[f64; 2])| (*edge, [band[0] + ends(*edge)[0], band[1] + ends(*edge)[1]]);
    let window = SensorWindow {
        edges: vec![1],
        range: [25.0 * per, 29.0 * per],
        proved: Some([25.5 * per, 28.5 * per]),
        at: 27.0 * per,
        throws_per_part: 12.0,
        throws_from_start: 9.0,
        settle_throws: 4,
    };
    let component = Component {
        cells: 100,
        is_terminal: true,
        bands: bands.iter().map(|(edge, [low, high])| (*edge, vec![[low - 0.1 * per, high + 0.1 * per]])).collect(),
    };
    let answer = Throw {
        stable: stable.clone(),
        classes: stable.iter().map(|edge| vec![*edge]).collect(),
        grasp: CommonGrasp { r_common: (0, Q::zero().into()), mu_common: None, mu_edgewise: None },
        lambda: 31.0 * per,
        part_radius: 6.0 * per,
        concave: true,
        reach: Reach {
            scan_to: 49.0 * per,
            edges: stable.iter().map(|edge| reach(*edge)).collect(),
            is_invariant: true,
            proposition: true,
            problems: Vec::new(),
        },
        hybrid: Hybrid { slides: Vec::new(), cycles: Vec::new() },
        sensors: vec![Sensor {
            set: 0,
            footprints: bands.iter().map(footprint).collect(),
            windows: vec![window],
            beyond: None,
        }],
        certificate: Certificate {
            z: stable.iter().map(|edge| (*edge, [6.5 * per, 26.9 * per])).collect(),
            is_invariant: true,
            components: vec![component],
            is_unique: true,
            ..Certificate::default()
        },
        limit: limit(orbit, bands),
        hull: hull.clone(),
        edges,
        throws: Vec::new(),
        carries: Vec::new(),
        replay: Vec::new(),
        design: None,
        is_stopped: false,
    };
    let part = Part {
        unit: LengthUnit::Centimetre,
        shape: Shape::Polygon(Polygon::new(hull).expect("a polygon")),
        center_of_mass: com,
        center_of_mass_tolerance: Q::zero(),
        mass: ratio(1, 1),
        inertia: ratio(1, 1),
    };
    let thrower =
        Thrower { offset: ratio(-1, 2), release_deg_per_s: ratio(320, 1), gravity: ratio(966, 1), friction: None };
    Drawn { name: name.to_owned(), part, thrower, answer }
}

fn limit(orbit: Vec<(usize, f64)>, bands: BTreeMap<usize, [f64; 2]>) -> LimitSets {
    let orbits = (0..60).map(|k| orbit[k..k + 60].to_vec()).collect();
    let set = LimitSet {
        period: None,
        lyapunov: 0.2,
        bands,
        share: BTreeMap::new(),
        transitions: Vec::new(),
        jogs: BTreeMap::new(),
        main_edge: 1,
        throws_per_cycle: 12.0,
        pattern: Vec::new(),
        seconds_per_throw: 0.4,
        throws: 400,
        transient: 4,
        starts: Vec::new(),
        orbit,
    };
    LimitSets { sets: vec![set], ended: Vec::new(), is_unique: true, is_unique_in_reach: true, orbits }
}

fn edge_of(hull: &[[Q; 2]], com: &[Q; 2], edge: usize) -> GraspEdge {
    let [start, end] = [edge, (edge + 1) % hull.len()].map(|k| difference(com, &hull[k]));
    let along = difference(&start, &end);
    let length2 = dot(&along, &along);
    let over_root = |product: Q| Surd::new(Q::zero(), product / &length2, length2.clone());
    GraspEdge {
        edge,
        is_stable: true,
        u_left: over_root(dot(&start, &along)),
        u_right: over_root(dot(&end, &along)),
        d: over_root(cross(&start, &along)),
        energy_kept: Q::zero(),
        grasp: None,
        length2,
    }
}
