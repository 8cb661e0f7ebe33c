//! JSON on the page: one line for what is short, a line an entry for the rest.

use serde_json::Value;

/// Entries longer than this are broken up.
const WIDTH: usize = 100;

/// The text of a document, with `schema` and the other words of the envelope before the result.
#[must_use]
pub fn document(value: &Value) -> String {
    let mut text = String::new();
    write(&mut text, value, 0);
    text.push('\n');
    text
}

fn write(text: &mut String, value: &Value, depth: usize) {
    let short = value.to_string();
    let entries: Vec<(Option<&String>, &Value)> = match value {
        Value::Array(entries) if short.len() > WIDTH => entries.iter().map(|entry| (None, entry)).collect(),
        Value::Object(entries) if short.len() > WIDTH || depth == 0 => {
            let mut entries: Vec<_> = entries.iter().map(|(key, entry)| (Some(key), entry)).collect();
            // the whole document, as every envelope begins
            entries.sort_by_key(|(key, _)| (depth == 0).then(|| rank(key.map_or("", String::as_str))));
            entries
        }
        _ => {
            text.push_str(&short);
            return;
        }
    };
    let [open, close] = if value.is_array() { ['[', ']'] } else { ['{', '}'] };
    text.push(open);
    for (index, (key, entry)) in entries.into_iter().enumerate() {
        text.push_str(if index == 0 { "\n" } else { ",\n" });
        text.push_str(&"  ".repeat(depth + 1));
        if let Some(key) = key {
            text.push_str(&format!("{}: ", Value::from(key.as_str())));
        }
        write(text, entry, depth + 1);
    }
    text.push('\n');
    text.push_str(&"  ".repeat(depth));
    text.push(close);
}

fn rank(key: &str) -> usize {
    let order = ["schema", "version", "case", "status", "units", "result"];
    order.iter().position(|name| *name == key).unwrap_or(order.len())
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn layout_changes_no_value_and_puts_the_schema_first() {
        let rows: Vec<Value> = (0..40).map(|k| json!([k, format!("{k}/7"), "a \"b\" \\ \n"])).collect();
        let value =
            json!({ "case": "x", "schema": "plan.insert/1", "result": { "rows": rows, "empty": {}, "none": [] } });
        let text = document(&value);
        assert_eq!(serde_json::from_str::<Value>(&text).unwrap(), value);
        assert!(text.starts_with("{\n  \"schema\": \"plan.insert/1\",\n  \"case\": \"x\",\n"));
        assert!(text.lines().count() > 40 && text.lines().all(|line| line.len() < WIDTH + 20));
    }
}
