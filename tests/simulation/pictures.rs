//! Drawings of runs.

use super::made::{planar, run as made_run, spatial};
use super::{AWKWARD, peg, sphere, two};
use partplan::answer::Frame;
use partplan::report::svg;
use partplan::report::{Run, Shown};

/// Checks nesting of elements and quoting of attributes.
fn assert_well_formed(svg: &str) {
    let (mut open, mut rest) = (Vec::new(), svg);
    while let Some(start) = rest.find('<') {
        let text = &rest[..start];
        assert!(
            !text.contains('>')
                && text.split('&').skip(1).all(|after| ["amp;", "lt;", "gt;", "quot;", "apos;", "#39;"]
                    .iter()
                    .any(|entity| after.starts_with(entity))),
            "{text:?}"
        );
        let end = start + rest[start..].find('>').unwrap();
        let tag = &rest[start + 1..end];
        assert_eq!(tag.matches('"').count() % 2, 0, "quotes in {tag:?}");
        match tag.strip_prefix('/') {
            Some(name) => assert_eq!(open.pop(), Some(name), "elements nest"),
            None if !tag.ends_with('/') => open.push(tag.split_whitespace().next().unwrap()),
            None => {}
        }
        rest = &rest[end + 1..];
    }
    assert!(open.is_empty() && svg.starts_with("<svg") && svg.ends_with("</svg>\n"));
    assert!(!svg.contains("NaN") && !svg.contains("inf"));
}

fn drawn<S: Shown>(
    name: &str,
    (world, answer): &(partplan::model::World<S>, partplan::answer::Simulation<S>),
) -> String {
    let drawing = svg::simulation(&Run { name, world, warnings: &[] }, answer);
    assert_well_formed(&drawing);
    drawing
}

#[test]
fn about_ten_poses_are_drawn_between_start_and_end() {
    let svg = drawn("peg drop", &peg());
    let poses = svg.matches("fill-opacity=\"0.12\"").count() + svg.matches("fill-opacity=\"0.35\"").count();
    assert!((8..=12).contains(&poses), "{poses} poses");
    for said in [
        "start, 0 s",
        "end, 1 s",
        "0.05 m",
        "path of a center of mass",
        "peg, from light at 0 s to dark at 1 s",
        "\nfixed\n",
    ] {
        assert!(svg.contains(said), "{said:?}");
    }
}

#[test]
fn space_is_seen_from_the_side_and_from_above() {
    let svg = drawn("sphere", &sphere());
    assert!(svg.contains("from the side") && svg.contains("from above"));
    // the floor is edge on in one of them
    assert_eq!(svg.matches("#eceff1").count(), 1);
}

#[test]
fn every_body_is_named_whatever_its_name() {
    let svg = drawn(AWKWARD, &two());
    assert!(svg.contains("&lt;i&gt;") && svg.contains("body 1: start, 0 s"), "{svg}");
}

#[test]
fn texts_are_not_over_each_other() {
    for svg in [drawn("peg", &peg()), drawn("sphere", &sphere()), drawn("two", &two())] {
        let value = |tag: &str, key: &str| -> f64 {
            let (_, rest) = tag.split_once(&format!(" {key}=\"")).unwrap();
            rest.split('"').next().unwrap().parse().unwrap()
        };
        let boxes: Vec<[f64; 4]> = svg
            .split("<text")
            .skip(1)
            .map(|rest| {
                let (tag, rest) = rest.split_once('>').unwrap();
                let letters = rest.split('<').next().unwrap().trim().chars().count() as f64;
                let (x, y, size) = (value(tag, "x"), value(tag, "y"), value(tag, "font-size"));
                let half = 0.25 * size * letters;
                let middle = if tag.contains("middle") { x } else { x + half };
                [middle - half, middle + half, y - 0.7 * size, y]
            })
            .collect();
        for (index, a) in boxes.iter().enumerate() {
            for b in &boxes[index + 1..] {
                let apart = a[0] >= b[1] || b[0] >= a[1] || a[2] >= b[3] || b[2] >= a[3];
                assert!(apart, "{a:?} and {b:?}");
            }
        }
    }
}

/// So many bodies have no room for ten poses and their times.
#[test]
fn crowds_are_drawn_at_the_start_and_at_the_end() {
    let (mut world, mut answer) = peg();
    world.bodies = (0..40).map(|_| world.bodies[0].clone()).collect();
    for frame in &mut answer.frames {
        frame.poses = (0..40).map(|k| [frame.poses[0][0] + 0.1 * f64::from(k), frame.poses[0][1], 0.0]).collect();
        frame.velocities = vec![frame.velocities[0]; 40];
    }
    answer.last = answer.frames[answer.frames.len() - 1].clone();
    let svg = drawn("crowd", &(world, answer));
    assert_eq!((svg.matches("fill-opacity=\"0.35\"").count(), svg.contains("start, ")), (40, false));
    assert!(svg.contains("bodies, from light at 0 s to dark at 1 s"));
}

#[test]
fn odd_runs_are_drawn_too() {
    let (world, answer) = peg();
    let still = made_run(answer.frames[..1].to_vec(), Vec::new());
    let svg = drawn("one frame", &(world.clone(), still));
    assert!(svg.contains("start, 0 s") && !svg.contains("end, "));
    let wild = |pose: [f64; 3]| Frame { time: 0.0, poses: vec![pose], velocities: vec![[0.0; 3]], touches: Vec::new() };
    let frames = vec![wild([f64::NAN, 0.0, 0.0]), wild([1e300, 0.0, 0.0])];
    drawn("no sound frame", &(world.clone(), made_run(frames, Vec::new())));
    let mut far = answer.clone();
    far.frames.iter_mut().for_each(|frame| frame.poses[0][0] += 1e9);
    drawn("far away", &(world, far));
    let shapes = planar(
        r#"{"scene": {"duration": 1, "friction": 0, "bodies": [{"shape": {"compound": [{"circle": {"radius": 1}},
            {"polygon": [[0, 0], [2, 0], [0, 2]]}]}, "mass": 1, "inertia": 1, "pose": [0, 0, 0]}],
            "fixed": [{"shape": {"point": [3, 0]}}, {"shape": {"circle": {"center": [0, 3], "radius": 1}}},
            {"shape": {"polygon": [[-9, -9], [9, -9], [9, -3], [-9, -3]]}}]}}"#,
    );
    let frame = |x: f64| Frame { time: x, poses: vec![[x, 0.0, x]], velocities: vec![[0.0; 3]], touches: Vec::new() };
    drawn("shapes", &(shapes, made_run(vec![frame(0.0), frame(1.0)], Vec::new())));
    let box_ = spatial(
        r#"{"scene": {"dimension": 3, "duration": 1, "friction": 0, "bodies": [{"shape": {"box": {"half": [1, 2, 3]}},
            "mass": 1, "pose": [0, 0, 9, 1, 0, 0, 0]}], "fixed": [{"shape": {"half_space": {"point": [0, 0, 0], "normal": [1, 1, 1]}}}]}}"#,
    );
    let frame = |z: f64| Frame {
        time: z,
        poses: vec![[0.0, 0.0, z, 0.8, 0.6, 0.0, 0.0]],
        velocities: vec![[0.0; 6]],
        touches: Vec::new(),
    };
    drawn("box", &(box_, made_run(vec![frame(9.0), frame(1.0)], Vec::new())));
}
