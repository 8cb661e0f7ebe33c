//! Reports of runs: text, JSON, trajectories, pictures, pages.

mod made;
mod pages;
mod pictures;
mod tables;
mod words;

use made::{dropped, planar, spatial, thrown};
use partplan::answer::Simulation;
use partplan::model::{Planar, Spatial, World};

/// The peg of the case folder, dropped.
fn peg() -> (World<Planar>, Simulation<Planar>) {
    let world = planar(include_str!("../../cases/peg_drop.json"));
    let answer = dropped(&world);
    (world, answer)
}

/// The sphere of the case folder, thrown.
fn sphere() -> (World<Spatial>, Simulation<Spatial>) {
    let world = spatial(include_str!("../../cases/sphere.json"));
    let answer = thrown(&world);
    (world, answer)
}

/// Names that would break a page, a drawing or a table.
const AWKWARD: &str = "a\"b'<i>&amp;</script><!--,\\\n\u{1b}[31m";

/// Two bodies, the first with an awkward name.
fn two() -> (World<Planar>, Simulation<Planar>) {
    let body = |x: f64| {
        format!(
            r#"{{"shape": {{"polygon": [[-0.05, -0.02], [0.05, -0.02], [0.05, 0.02], [-0.05, 0.02]]}},
                "mass": 0.2, "pose": [{x}, 0.2, 0.4], "velocity": [0.1, 0.5, 3]}}"#
        )
    };
    let floor = r#"{"name": "floor", "shape": {"half_plane": {"point": [0, 0], "normal": [0, 1]}}}"#;
    let text = format!(
        r#"{{"scene": {{"duration": 0.5, "friction": 0.3, "bodies": [{}, {}], "fixed": [{floor}]}}}}"#,
        body(-0.2),
        body(0.2)
    );
    let mut world = planar(&text);
    AWKWARD.clone_into(&mut world.bodies[0].name);
    let answer = dropped(&world);
    (world, answer)
}
