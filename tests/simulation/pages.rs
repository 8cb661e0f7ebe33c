//! Pages that play runs.

use super::{AWKWARD, peg, sphere, two};
use partplan::report::{Run, Shown, html};
use serde_json::{Value, json};

fn page<S: Shown>(
    name: &str,
    (world, answer): &(partplan::model::World<S>, partplan::answer::Simulation<S>),
) -> String {
    html::simulation(&Run { name, world, warnings: &[] }, answer)
}

/// What the script reads.
fn data(page: &str) -> Value {
    let (_, rest) = page.split_once("<script type=\"application/json\" id=\"run\">").unwrap();
    serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap()
}

#[test]
fn the_page_holds_the_whole_run() {
    let (world, answer) = peg();
    let page = page("peg drop", &(world, answer.clone()));
    let data = data(&page);
    assert_eq!(data["times"].as_array().map(Vec::len), Some(answer.frames.len()));
    for (key, count) in
        [("poses", answer.frames.len()), ("touches", answer.frames.len()), ("events", answer.events.len())]
    {
        assert_eq!(data[key].as_array().map(Vec::len), Some(count), "{key}");
    }
    assert_eq!(data["graph"]["values"].as_array().map(Vec::len), Some(answer.frames.len()));
    // as written, which a reader of JSON may round
    assert!(answer.frames.iter().all(|frame| page.contains(&json!(frame.poses).to_string())));
    assert_eq!(data["bodies"][0]["pieces"][0]["polygon"][0], json!([-0.05, -0.025]));
    assert_eq!(data["fixed"][0]["pieces"][0], json!({ "half": [0.0, 0.0, 0.0, 1.0] }));
    let touch = answer.frames.iter().position(|frame| !frame.touches.is_empty()).unwrap();
    let [n, t, _] = answer.frames[touch].touches[0].impulse;
    // with n = +y the tangent is +x
    assert!(page.contains(&json!({ "impulse": [t, n] }).to_string()[1..]) && !data["touches"][touch][0].is_null());
}

#[test]
fn space_has_two_views() {
    let (world, answer) = sphere();
    let page = page("sphere", &(world, answer.clone()));
    let data = data(&page);
    assert_eq!((&data["dimension"], data["views"].as_array().map(Vec::len)), (&json!(3), Some(2)));
    assert_eq!(data["bodies"][0]["pieces"][0], json!({ "sphere": [0.0, 0.0, 0.0, 0.05] }));
    let touch = answer.frames.iter().position(|frame| !frame.touches.is_empty()).unwrap();
    let [n, t, o] = answer.frames[touch].touches[0].impulse;
    // with n = +z the tangents are +x and +y
    assert!(page.contains(&json!({ "impulse": [t, o, n] }).to_string()[1..]) && !data["touches"][touch][0].is_null());
}

#[test]
fn the_page_refers_to_nothing_else() {
    let page = page("peg drop", &peg());
    for word in ["http:", "https:", "//", "src=", "href=", "url(", "@import", "fetch(", "XMLHttpRequest", "import("] {
        let code = page.lines().filter(|line| !line.trim_start().starts_with("//"));
        let hits: Vec<&str> = code.filter(|line| line.contains(word)).collect();
        assert!(hits.is_empty(), "{word}: {hits:?}");
    }
    assert!(page.contains("default-src 'none'"));
}

#[test]
fn names_do_not_end_the_script() {
    let page = page(AWKWARD, &two());
    assert_eq!((page.matches("</script>").count(), page.matches("<script").count()), (2, 2));
    assert!(!page.contains("<i>") && !page.contains("<!--"));
    assert_eq!(data(&page)["bodies"][0]["name"], AWKWARD);
}
