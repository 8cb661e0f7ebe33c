//! Trajectories read back.

use super::{AWKWARD, peg, sphere, two};
use partplan::report::{Run, trajectory};
use serde_json::Value;

/// Rows of fields, as RFC 4180 has them.
fn rows(text: &str) -> Vec<Vec<String>> {
    let (mut rows, mut row, mut field, mut is_quoted) = (Vec::new(), Vec::new(), String::new(), false);
    let mut letters = text.chars().peekable();
    while let Some(letter) = letters.next() {
        match letter {
            '"' if is_quoted && letters.peek() == Some(&'"') => field.extend(letters.next()),
            '"' => is_quoted = !is_quoted,
            ',' if !is_quoted => row.push(std::mem::take(&mut field)),
            '\n' if !is_quoted => {
                row.push(std::mem::take(&mut field));
                rows.push(std::mem::take(&mut row));
            }
            letter => field.push(letter),
        }
    }
    assert!(field.is_empty() && row.is_empty(), "the last row ends");
    rows
}

#[test]
fn values_separated_by_commas_are_the_frames_to_the_last_bit() {
    let (world, answer) = peg();
    let text = trajectory::csv(&Run { name: "x", world: &world, warnings: &[] }, &answer);
    let rows = rows(&text);
    let head = [
        "time [s]",
        "peg x [m]",
        "peg y [m]",
        "peg angle [rad]",
        "peg vx [m/s]",
        "peg vy [m/s]",
        "peg omega [rad/s]",
        "energy [J]",
    ];
    assert_eq!(rows[0], head);
    assert_eq!(rows.len(), answer.frames.len() + 1);
    for (row, frame) in rows[1..].iter().zip(&answer.frames) {
        let bits: Vec<u64> = row.iter().map(|field| field.parse::<f64>().unwrap().to_bits()).collect();
        let state = [&[frame.time][..], &frame.poses[0], &frame.velocities[0]].concat();
        assert_eq!(bits[..7], state.iter().map(|number| number.to_bits()).collect::<Vec<_>>());
    }
    // m g h at the start
    let energy: f64 = rows[1][7].parse().unwrap();
    assert!((energy - 0.2 * 9.81 * 0.2).abs() < 1e-15);
}

#[test]
fn headings_survive_awkward_names() {
    let (world, answer) = two();
    let text = trajectory::csv(&Run { name: "x", world: &world, warnings: &[] }, &answer);
    let rows = rows(&text);
    assert_eq!(rows[0][1], format!("{AWKWARD} x [m]"));
    assert!(rows.iter().all(|row| row.len() == 1 + 2 * 6 + 1));
}

#[test]
fn every_line_of_jsonl_is_a_document() {
    let (world, answer) = sphere();
    let text = trajectory::jsonl(&Run { name: AWKWARD, world: &world, warnings: &[] }, &answer);
    let lines: Vec<Value> = text.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(lines[0]["schema"], "plan.trajectory/1");
    assert_eq!(lines[0]["columns"].as_array().map(Vec::len), Some(1 + 7 + 6 + 1));
    assert_eq!(lines.len(), answer.frames.len() + 1);
    assert_eq!(lines[1][3].as_f64(), Some(0.2));
    // kinetic energy of rolling: m v² / 2 + J ω² / 2 + m g h
    let energy = 0.1 * 0.25 + 0.5 * 0.4 * 0.2 * 0.0025 * 400.0 + 0.2 * 9.81 * 0.2;
    assert!((lines[1][14].as_f64().unwrap() - energy).abs() < 1e-12);
}
