//! Where throws are defined, and the friction that they need, exactly.

use crate::answer::{CommonGrasp, EdgeGrasp, GraspEdge, SurdRatio};
use crate::exact::{Q, Surd};
use crate::mechanics::throwing::RestingEdge;
use crate::model::Thrower;

/// Every edge of the hull on the arm.
pub(super) fn edges(edges: &[RestingEdge], rho2: &Q, thrower: &Thrower) -> Vec<GraspEdge> {
    let offset = &thrower.offset;
    let grasp = |resting: &RestingEdge| {
        let (r_geom, level) = (resting.r_geom(offset, rho2), resting.height_over_pivot(offset));
        // (2) and (4)
        let by_friction = thrower.friction.as_ref().map(|mu| &level / &Surd::from(mu.min.clone()));
        EdgeGrasp {
            r_grasp: by_friction.map_or_else(|| r_geom.clone(), |least| r_geom.clone().max(least)),
            mu_edge: r_geom.sign().is_gt().then(|| &level / &r_geom),
            r_clear: resting.r_clear.clone(),
            r_geom,
        }
    };
    let of = |(edge, resting): (usize, &RestingEdge)| GraspEdge {
        edge,
        is_stable: resting.is_stable(),
        length2: resting.length2.clone(),
        u_left: resting.u_left.clone(),
        u_right: resting.u_right.clone(),
        d: resting.d.clone(),
        energy_kept: resting.energy_kept.clone(),
        grasp: resting.is_stable().then(|| grasp(resting)),
    };
    edges.iter().enumerate().map(of).collect()
}

/// What holds for all stable edges; `None` if there are none.
pub(super) fn common(edges: &[GraspEdge], offset: &Q) -> Option<CommonGrasp> {
    let grasps = || edges.iter().filter_map(|edge| Some((edge.edge, edge.grasp.as_ref()?)));
    let level = |edge: usize| (&Surd::from(offset.clone()) + &edges[edge].d).abs();
    let r_common = most(grasps().map(|(edge, grasp)| (edge, grasp.r_geom.clone())))?;
    let (at, highest) = most(grasps().map(|(edge, _)| (edge, level(edge))))?;
    let mu_common = r_common.1.sign().is_gt().then(|| (at, ratio(&highest, &r_common.1)));
    let by_edge: Option<Vec<(usize, Surd)>> =
        grasps().map(|(edge, grasp)| Some((edge, grasp.mu_edge.clone()?))).collect();
    Some(CommonGrasp { r_common, mu_common, mu_edgewise: by_edge.and_then(|by_edge| most(by_edge.into_iter())) })
}

/// The largest, the first of equals.
fn most(numbers: impl Iterator<Item = (usize, Surd)>) -> Option<(usize, Surd)> {
    numbers.reduce(|a, b| if b.1 > a.1 { b } else { a })
}

fn ratio(a: &Surd, b: &Surd) -> SurdRatio {
    let ([.., n], [.., m]) = (a.parts(), b.parts());
    if a.rational().is_some() || b.rational().is_some() || n == m {
        SurdRatio::Number(a / b)
    } else {
        SurdRatio::Quotient(a.clone(), b.clone())
    }
}
