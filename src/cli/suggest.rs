//! `plan insert --suggest`: where to put the fixels.

use super::common::Common;
use super::input::Task;
use super::progress::Bar;
use super::{Failure, Outcome, output};
use partplan::answer::Suggestion;
use partplan::model::Fixture;
use partplan::{planner, report};
use std::io::Write;
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

/// Proposes `count` places for the fixels of the task; what is found when a limit is reached is still an answer.
pub fn run(
    task: &Task<Fixture>,
    common: &Common,
    count: usize,
    svg: Option<&Path>,
    out: &mut dyn Write,
) -> Result<Outcome, Failure> {
    let subject = task.subject();
    let (bar, latest) = (Bar::new(), Arc::new(Mutex::new(Suggestion::default())));
    let found = common.limits.within({
        let (part, fixture) = (task.case.part.clone(), task.section.clone());
        let (bar, latest) = (bar.clone(), Arc::clone(&latest));
        move || {
            planner::suggest(&part, &fixture, count, &mut |progress| {
                bar.show(&progress);
                latest.lock().unwrap_or_else(PoisonError::into_inner).clone_from(progress.so_far);
            })
        }
    });
    bar.clear();
    let found = match found {
        Ok(found) => found?,
        Err(reached) => {
            let so_far = latest.lock().unwrap_or_else(PoisonError::into_inner).clone();
            let found = Suggestion { limit: Some(reached), ..so_far };
            if found.proposals.is_empty() {
                let document = || report::json::suggestion(&subject, &found);
                common.limits.say_reached(reached, common.format, document, out)?;
                return Ok(Outcome::Undecided);
            }
            found
        }
    };
    if let Some(path) = svg {
        output::picture(path, &report::svg::suggestion(&subject, &found))?;
    }
    output::answer(
        out,
        common.format,
        || report::text::suggestion(&subject, &found),
        || report::json::suggestion(&subject, &found),
    )?;
    Ok(if found.proposals.is_empty() { Outcome::No } else { Outcome::Yes })
}
