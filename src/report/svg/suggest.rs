//! Proposed places for the fixels, one picture below the other.

use super::super::{Subject, phrase};
use super::canvas::{Canvas, MUTED};
use super::finger::outward;
use super::legend::Legend;
use super::scene::Scene;
use super::view::{Outline, WIDTH};
use super::{contact, plan};
use crate::answer::{Action, Proposal, Suggestion};
use std::collections::BTreeSet;

/// So many of the best are drawn.
const MOST: usize = 4;

/// The drawing of `plan insert --suggest`: the part with the fixels and the push of each of the best proposals.
#[must_use]
pub fn suggestion(subject: &Subject, answer: &Suggestion) -> String {
    let mut page = Canvas::new();
    let mut legend = Legend::default();
    let mut bottom = 0.0;
    let count = answer.proposals.len();
    for (index, proposal) in answer.proposals.iter().take(MOST).enumerate() {
        let subject = Subject { fixture: &proposal.fixture, ..*subject };
        let mut scene = Scene::new(&subject);
        contact::draw_cones(&mut scene, &subject);
        contact::draw_fixels(&mut scene, &subject);
        plan::draw(&mut scene, &proposal.plan);
        name_edges(&mut scene, proposal);
        let title = format!("{}: proposal {} of {count}", subject.name, index + 1);
        let height = scene.close(&title, &phrase::proposal(proposal));
        page.inset(scene.canvas, bottom);
        legend.extend(scene.legend);
        bottom += height;
    }
    let bottom = legend.draw(&mut page, WIDTH, bottom);
    page.finish(WIDTH, bottom, subject.name, &phrase::suggestion(answer))
}

/// Names the edges that bear a fixel or the push.
fn name_edges(scene: &mut Scene, proposal: &Proposal) {
    let Outline::Polygon(corners) = scene.view.outline.clone() else { return };
    let mut edges: BTreeSet<usize> = proposal.places.iter().map(|(edge, _)| *edge).collect();
    if let Action::PushEdge { edge, .. } = &proposal.plan.action {
        edges.insert(*edge);
    }
    for edge in edges {
        let (from, to) = (corners[edge], corners[(edge + 1) % corners.len()]);
        let middle = from.along(to.minus(from), 0.5);
        scene.labels.want(middle, outward([from, to]), 13.0, MUTED, false, format!("edge {edge}"));
    }
}
