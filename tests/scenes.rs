//! Scene files: what every key means, and what is assumed where it is missing.

use partplan::case::{Limits, SceneCase, read_scene};
use partplan::model::{
    Body, Compliance, Finger, Obstacle, Planar, PlanarShape, Restitution, Scene, Spatial, SpatialShape, Timed, World,
};
use proptest::prelude::*;

fn case(text: &str) -> SceneCase {
    read_scene(text.as_bytes(), &Limits::default()).unwrap_or_else(|faults| panic!("{faults:?} in {text}"))
}

fn planar(text: &str) -> World<Planar> {
    match case(text).scene {
        Scene::Planar(world) => world,
        Scene::Spatial(_) => panic!("planar"),
    }
}

fn spatial(text: &str) -> World<Spatial> {
    match case(text).scene {
        Scene::Spatial(world) => world,
        Scene::Planar(_) => panic!("spatial"),
    }
}

/// A scene of a disc and a floor with these keys besides.
fn with(scene: &str, body: &str, floor: &str) -> String {
    format!(
        r#"{{"scene": {{"duration": 1, {scene} "bodies": [{{"name": "disc", "mass": 2, "pose": [0, 1, 0], {body}
           "shape": {{"circle": {{"radius": 0.1}}}}}}],
           "fixed": [{{"name": "floor", {floor} "shape": {{"half_plane": {{"point": [0, 0], "normal": [0, 3]}}}}}}]}}}}"#
    )
}

/// A finger presses on an edge of a polygon, or on a disc; its guide is told by a point and any vector.
#[test]
fn fingers_are_read_and_refused_where_they_cannot_press() {
    let body = |shape: &str, finger: &str| {
        format!(
            r#"{{"scene": {{"duration": 1, "friction": 0.2, "bodies": [{{"name": "peg", "mass": 1, "inertia": 1, "pose": [0, 0, 0],
                 "shape": {shape}, "finger": {finger}}}]}}}}"#
        )
    };
    let square = r#"{"polygon": [[-1, -1], [1, -1], [1, 1], [-1, 1]]}"#;
    let disc = r#"{"circle": {"radius": 1}}"#;
    let on_edge = r#"{"edge": 2, "at": [0.5, 3], "direction": [0, -2], "force": 4}"#;
    let finger = planar(&body(square, on_edge)).bodies[0].finger;
    assert_eq!(finger, Some(Finger { edge: Some(2), at: [0.5, 3.0], direction: [0.0, -1.0], force: 4.0 }));
    let on_disc = r#"{"at": [0, 3], "direction": [0, -1], "force": 4}"#;
    assert_eq!(planar(&body(disc, on_disc)).bodies[0].finger.map(|finger| finger.edge), Some(None));
    let codes = |text: &str| -> Vec<&'static str> {
        read_scene(text.as_bytes(), &Limits::default()).unwrap_err().iter().map(|fault| fault.code()).collect()
    };
    assert_eq!(codes(&body(square, on_disc)), ["C014"]);
    assert_eq!(codes(&body(disc, on_edge)), ["C054"]);
    assert_eq!(codes(&body(square, &on_edge.replace("2,", "4,"))), ["C053"]);
    assert_eq!(codes(&body(square, &on_edge.replace("[0, -2]", "[0, 0]"))), ["C056"]);
    assert_eq!(codes(&body(r#"{"compound": [{"circle": {"radius": 1}}]}"#, on_disc)), ["C081"]);
}

#[test]
fn every_key_of_a_planar_scene_is_read() {
    let text = r#"{"name": "all", "length_unit": "m", "part": {"any": "thing"}, "scene": {
        "dimension": 2, "gravity": [1, "-1/2"], "duration": "3/2", "step": 1e-3, "margin": 0, "directions": 2,
        "bodies": [
            {"name": "peg", "shape": {"polygon": [[-1, -1], [-1, 1], [1, 1], [1, -1]]}, "mass": 0.2, "inertia": 2e-4,
             "pose": [0, 0.2, "1/3"], "velocity": [1, 2, 3], "wrench": [0, -1, 0.5]},
            {"name": "pusher", "shape": {"circle": {"center": [0.1, 0], "radius": 0.5}}, "pose": [5, 0, 0],
             "kinematic": true, "motion": [{"from": 0, "velocity": [-1, 0, 0]}, {"from": 0.5, "velocity": [0, 0, 0]}]},
            {"shape": {"compound": [{"circle": {"radius": 1}}, {"polygon": [[0, 0], [1, 0], [0, 1]]}]}, "mass": 1,
             "inertia": 1, "pose": [9, 9, 0], "wrench": [{"from": 0.25, "wrench": [1, 0, 0]}]}
        ],
        "fixed": [{"name": "floor", "shape": {"half_plane": {"point": [0, -1], "normal": [3, 4]}}, "surface_velocity": 0.1},
                  {"shape": {"point": [7, 8]}}],
        "friction": 0.2, "restitution": 0.5, "contact": {"stiffness": [5e4, 1e4], "damping": 14}}}"#;
    let SceneCase { name, scene: Scene::Planar(world), warnings } = case(text) else { panic!("planar") };
    assert_eq!((name.as_deref(), warnings), (Some("all"), vec![]));
    let World { gravity, duration, step, margin, directions, bodies, fixed, materials } = world;
    assert_eq!((gravity, duration, step, margin, directions), ([1.0, -0.5], 1.5, Some(1e-3), Some(0.0), 2));
    let peg = Body {
        name: "peg".into(),
        // given clockwise: reversed, vertex 0 first
        shape: PlanarShape::Polygon(vec![[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]),
        mass: 0.2,
        inertia: [2e-4],
        pose: [0.0, 0.2, 1.0 / 3.0],
        velocity: [1.0, 2.0, 3.0],
        is_kinematic: false,
        schedule: vec![Timed { time: 0.0, value: [0.0, -1.0, 0.5] }],
        finger: None,
    };
    assert_eq!(bodies[0], peg);
    let pusher = &bodies[1];
    assert!(pusher.is_kinematic && pusher.mass > 0.0 && pusher.inertia[0] > 0.0);
    assert_eq!(pusher.velocity, [-1.0, 0.0, 0.0]);
    assert_eq!(pusher.schedule[1], Timed { time: 0.5, value: [0.0; 3] });
    assert_eq!(bodies[2].name, "body 2");
    assert!(matches!(&bodies[2].shape, PlanarShape::Compound(pieces) if pieces.len() == 2));
    assert_eq!(bodies[2].schedule, [Timed { time: 0.25, value: [1.0, 0.0, 0.0] }]);
    let floor = Obstacle {
        name: "floor".into(),
        shape: PlanarShape::HalfPlane { point: [0.0, -1.0], normal: [0.6, 0.8] },
        surface_velocity: [0.1, 0.0],
    };
    assert_eq!(fixed[0], floor);
    assert_eq!(
        (fixed[1].name.as_str(), &fixed[1].shape),
        ("fixed 1", &PlanarShape::Circle { center: [7.0, 8.0], radius: 0.0 })
    );
    assert_eq!(materials.len(), 3 * 5);
    let contact = Compliance { stiffness: [5e4, 1e4], damping: [14.0; 2], gamma: 1e-8 };
    let material = materials[3];
    assert_eq!((material.friction, material.restitution), (0.2, Restitution::Newton(0.5)));
    assert_eq!(material.compliance, Some(contact));
}

#[test]
fn what_is_left_out_has_its_default() {
    let world = planar(&with(r#""friction": 0,"#, "", ""));
    assert_eq!((world.gravity, world.step, world.margin), ([0.0, -9.81], None, None));
    let body = &world.bodies[0];
    assert_eq!((body.velocity, body.is_kinematic, body.schedule.len()), ([0.0; 3], false, 0));
    // the uniform disc: m r² / 2
    assert!((body.inertia[0] - 0.01).abs() < 1e-17);
    assert_eq!(world.fixed[0].surface_velocity, [0.0; 2]);
    let material = world.material(0, 1);
    assert_eq!((material.restitution, material.compliance), (Restitution::Newton(0.0), None));
}

#[test]
fn every_key_of_a_spatial_scene_is_read() {
    let text = r#"{"scene": {"dimension": 3, "duration": 1, "directions": 8, "friction": {"angle_deg": 45},
        "restitution": {"poisson": "1/4"}, "bodies": [
        {"name": "ball", "shape": {"sphere": {"radius": 0.5}}, "mass": 10, "pose": [1, 2, 3, 0, 2, 0, 0],
         "velocity": [1, 2, 3, 4, 5, 6], "wrench": [1, 0, 0, 0, 0, 1]},
        {"name": "brick", "shape": {"box": {"size": [2, 4, 6]}}, "mass": 12, "pose": [0, 0, 9, 1, 0, 0, 0]},
        {"name": "rotor", "shape": {"box": {"half": [1, 2, 3]}}, "mass": 1, "inertia": [1, 2, 3],
         "pose": [0, 9, 9, 1, 0, 0, 0]}],
        "fixed": [{"name": "belt", "shape": {"half_space": {"point": [0, 0, 0], "normal": [0, 0, 2]}},
                   "surface_velocity": [0.5, 0]}]}}"#;
    let SceneCase { scene: Scene::Spatial(world), warnings, .. } = case(text) else { panic!("spatial") };
    assert_eq!((world.gravity, world.directions), ([0.0, 0.0, -9.81], 8));
    let [ball, brick, rotor] = &world.bodies[..] else { panic!("three bodies") };
    assert_eq!(ball.inertia, [1.0; 3]);
    assert_eq!(ball.pose, [1.0, 2.0, 3.0, 0.0, 1.0, 0.0, 0.0]);
    assert!(warnings.len() == 1 && warnings[0].starts_with("scene.bodies[0].pose: the Euler parameters have length 2"));
    assert_eq!(brick.shape, SpatialShape::Box { half: [1.0, 2.0, 3.0] });
    // m (b² + c²) / 12 of the sides
    assert_eq!(brick.inertia, [52.0, 40.0, 20.0]);
    assert_eq!(rotor.inertia, [1.0, 2.0, 3.0]);
    assert_eq!(world.fixed[0].surface_velocity, [0.5, 0.0]);
    assert_eq!(world.material(0, 3).friction, 1.0);
    assert_eq!(world.material(1, 3).restitution, Restitution::Poisson(0.25));
}

/// Inertia of a lamina about an origin that is not its centroid: J + m d².
#[test]
fn an_inertia_about_another_point_is_said() {
    let text = r#"{"scene": {"duration": 1, "friction": 0, "bodies": [{"name": "a", "mass": 3, "pose": [0, 0, 0],
        "shape": {"polygon": [[0, -1], [2, -1], [2, 1], [0, 1]]}}]}}"#;
    let SceneCase { scene: Scene::Planar(world), warnings, .. } = case(text) else { panic!("planar") };
    // 3 · (4 + 4)/12 + 3 · 1²
    assert!((world.bodies[0].inertia[0] - 5.0).abs() < 1e-14);
    assert_eq!(warnings.len(), 2, "{warnings:?}");
    assert!(warnings[0].contains("outside of the convex hull") && warnings[1].contains("[1, 0]"), "{warnings:?}");
}

#[test]
fn a_pair_comes_before_a_body_and_a_body_before_the_scene() {
    let pair = r#""friction": 0.1, "pairs": [{"between": ["floor", "disc"], "friction": 0.4}],"#;
    let friction = |text: &str| planar(text).material(0, 1).friction;
    assert_eq!(friction(&with(pair, r#""friction": 0.2,"#, r#""friction": 0.3,"#)), 0.4);
    assert_eq!(friction(&with(r#""friction": 0.1,"#, r#""friction": 0.2,"#, "")), 0.2);
    assert_eq!(friction(&with(r#""friction": 0.1,"#, "", r#""friction": 0.3,"#)), 0.3);
    assert_eq!(friction(&with("", r#""friction": 0.3,"#, r#""friction": 0.3,"#)), 0.3);
    assert_eq!(friction(&with(r#""friction": 0.1,"#, "", "")), 0.1);
    // a pair that says nothing of friction leaves it to the others
    let other = r#""friction": 0.1, "pairs": [{"between": ["disc", "floor"], "restitution": 1}],"#;
    let world = planar(&with(other, "", ""));
    assert_eq!((world.material(0, 1).friction, world.material(0, 1).restitution), (0.1, Restitution::Newton(1.0)));
}

#[test]
fn the_materials_of_two_bodies_do_not_depend_on_their_order() {
    let text = r#"{"scene": {"duration": 1, "friction": 0, "bodies": [
        {"name": "a", "shape": {"circle": {"radius": 1}}, "mass": 1, "pose": [0, 0, 0]},
        {"name": "b", "shape": {"circle": {"radius": 1}}, "mass": 1, "pose": [5, 0, 0], "friction": 0.5}]}}"#;
    let world = planar(text);
    assert_eq!((world.material(0, 1), world.material(0, 1).friction), (world.material(1, 0), 0.5));
}

#[test]
fn the_cases_in_the_folder_are_scenes() {
    let peg = planar(include_str!("../cases/peg_drop.json"));
    assert_eq!((peg.bodies[0].mass, peg.bodies[0].inertia), (0.2, [2e-4]));
    assert_eq!(peg.material(0, 1).compliance.unwrap().damping, [14.142_135_623_730_951; 2]);
    let sphere = spatial(include_str!("../cases/sphere.json"));
    assert!((sphere.bodies[0].inertia[0] - 0.4 * 0.2 * 0.05 * 0.05).abs() < 1e-18);
    let chute = case(include_str!("../cases/chute.json"));
    assert!(matches!(&chute.scene, Scene::Planar(world) if world.fixed.len() == 7));
    assert_eq!(chute.warnings, Vec::<String>::new());
}

proptest! {
    /// What is read is the double that Rust's own parser reads, which rounds correctly.
    #[test]
    fn numbers_are_rounded_once(digits in "-?[1-9][0-9]{0,30}", places in 0..40_usize) {
        let text = format!("{digits}e-{places}");
        let world = planar(&with(&format!("\"friction\": 0, \"gravity\": [{text}, 0],"), "", ""));
        prop_assert_eq!(world.gravity[0].to_bits(), text.parse::<f64>().unwrap().to_bits());
    }
}

/// A scene that is written is read back to the last digit.
#[test]
fn scenes_are_written_as_they_are_read() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("cases");
    let mut written = 0;
    for folder in [folder.join("stability"), folder] {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let text = if path.is_file() { std::fs::read_to_string(&path).unwrap() } else { String::new() };
            let Ok(SceneCase { scene: Scene::Planar(world), .. }) = read_scene(text.as_bytes(), &Limits::default())
            else {
                continue;
            };
            let again = partplan::report::json::document(&partplan::report::json::scene("again", &world));
            assert_eq!(planar(&again), world, "{}", path.display());
            written += 1;
        }
    }
    assert!(written > 15, "{written}");
    let driven = r#"{"scene": {"duration": 1, "friction": 0.2, "bodies": [
        {"name": "pusher", "shape": {"circle": {"radius": 0.5}}, "pose": [5, 0, 0], "kinematic": true,
         "motion": [{"from": 0, "velocity": [-1, 0, 0]}, {"from": 0.5, "velocity": [0, 0, 0]}]},
        {"name": "peg", "mass": 1, "inertia": 1, "pose": [0, 0, 0], "restitution": {"poisson": 0.5},
         "shape": {"compound": [{"circle": {"radius": 1}}, {"polygon": [[0, 0], [1, 0], [0, 1]]}]}}]}}"#;
    let world = planar(driven);
    assert_eq!(planar(&partplan::report::json::scene("again", &world).to_string()), world);
}
