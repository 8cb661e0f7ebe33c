//! Pages that play a run or throws: one file each, without references to any other.

mod chart;
mod feeder;
mod throw;

pub use chart::chart;
pub use feeder::feeder;
pub use throw::throw;

use super::motion::{self, Run, Shown};
use super::phrase;
use crate::answer::{Frame, Simulation};
use serde_json::{Value, json};

const STYLE: &str = include_str!("player.css");
const SCRIPT: &str = include_str!("player.js");

/// The page of `plan simulate`: plays the motion with impulses, time and energy.
#[must_use]
pub fn simulation<S: Shown>(run: &Run<S>, answer: &Simulation<S>) -> String {
    let remark = "Arrows are contact impulses, their length by the square root. Energy is kinetic and potential.";
    page(run.name, &phrase::simulation(run, answer), remark, &simulation_data(run, answer))
}

/// A page that plays frames; `data` is what its script reads.
fn page(name: &str, said: &str, remark: &str, data: &Value) -> String {
    let (heading, said, remark, data) = (escaped(name), escaped(said), escaped(remark), embedded(data));
    let policy = "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'";
    let body = format!(
        r#"<h1>{heading}</h1>
<p id="said">{said}</p>
<div id="views"></div>
<div id="controls">
<button id="play" type="button">Play</button>
<input id="time" type="range" min="0" max="1" step="any" value="0" aria-label="time">
<label>speed <select id="speed"><option value="0.05">1/20</option><option value="0.1">1/10</option><option value="0.25">1/4</option><option value="0.5">1/2</option><option value="1" selected>1</option><option value="2">2</option></select></label>
<label id="pushes"><input id="impulses" type="checkbox" checked> impulses</label>
<label><input id="paths" type="checkbox" checked> paths</label>
</div>
<p id="now"></p>
<canvas id="graph"></canvas>
<p class="remark">{remark} Space starts and stops, the arrow keys step.</p>
<script type="application/json" id="run">{data}</script>
<script>
{SCRIPT}</script>"#
    );
    document(name, policy, STYLE, &body)
}

/// A page in one file.
fn document(title: &str, policy: &str, style: &str, body: &str) -> String {
    let title = escaped(title);
    format!(
        r#"<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title}</title>
<style>
{style}</style>
</head>
<body>
{body}
</body>
</html>
"#
    )
}

/// What the script plays.
fn simulation_data<S: Shown>(run: &Run<S>, answer: &Simulation<S>) -> Value {
    let world = run.world;
    let frames = motion::sound(run, answer);
    let poses = |frame: &&Frame<S>| frame.poses.iter().map(|pose| json!(pose.as_ref())).collect::<Value>();
    let views = S::VIEWS.iter().map(|view| json!({ "name": view.name, "right": view.right, "up": view.up }));
    let bodies = world.bodies.iter().map(|body| json!({ "name": body.name, "pieces": S::pieces(&body.shape) }));
    let fixed = world.fixed.iter().map(|fixed| json!({ "name": fixed.name, "pieces": S::pieces(&fixed.shape) }));
    let events = answer.events.iter().map(|event| {
        let contact = motion::contact(run, &event.contact, motion::plain);
        json!({ "time": event.time, "text": format!("{contact} {}", motion::change(event)) })
    });
    let energies = frames.iter().map(|frame| motion::energy(run, frame)).collect::<Vec<_>>();
    json!({
        "dimension": S::DIMENSION,
        "views": views.collect::<Value>(),
        "bodies": bodies.collect::<Value>(),
        "fixed": fixed.collect::<Value>(),
        "times": frames.iter().map(|frame| frame.time).collect::<Vec<_>>(),
        "poses": frames.iter().map(poses).collect::<Value>(),
        "graph": { "name": "energy", "unit": "J", "values": energies },
        "touches": frames.iter().map(|frame| touches::<S>(frame)).collect::<Value>(),
        "events": events.collect::<Value>(),
    })
}

/// Where contacts push, and their impulses along the axes of the world.
fn touches<S: Shown>(frame: &Frame<S>) -> Value {
    let touch = frame.touches.iter().map(|touch| {
        let impulse = S::impulse(&touch.normal, touch.impulse);
        json!({ "at": touch.point.as_ref(), "impulse": impulse.as_ref() })
    });
    touch.collect()
}

/// Text of a page.
fn escaped(text: &str) -> String {
    let escape = |c: char| match c {
        '&' => "&amp;".to_owned(),
        '<' => "&lt;".to_owned(),
        '>' => "&gt;".to_owned(),
        '"' => "&quot;".to_owned(),
        '\'' => "&#39;".to_owned(),
        c if c.is_control() => " ".to_owned(),
        c => c.to_string(),
    };
    text.chars().map(escape).collect()
}

/// JSON that no page takes for the end of its script.
fn embedded(value: &Value) -> String {
    value.to_string().replace('<', "\\u003c").replace('>', "\\u003e").replace('&', "\\u0026")
}
