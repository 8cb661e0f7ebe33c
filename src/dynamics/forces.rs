//! All forces that a contact problem allows, exactly: with redundant contacts they are many that move bodies alike.

use super::contact::{Contact, add_scaled};
use super::mechanics::Mechanics;
use crate::answer::ContactName;
use crate::complementarity::{Enumeration, ExactLcp, Factors, LcpError, enumerate};
use crate::exact::to_f64;
use crate::model::World;
use std::collections::BTreeSet;

/// Most contacts and most variables of a problem whose solutions are all looked for, and most complementary cases looked
/// at for them: a ball on a cone of 16 edges has 18 variables, and all its cases take seconds.
const MAX_ENUMERATED: usize = 3;
const MAX_VARIABLES: usize = 12;
const MAX_CASES: usize = 4096;

/// The normal forces of all solutions of a contact problem.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Forces {
    /// Least and greatest of each contact (N); the greatest is `None` where there is none.
    pub ranges: Vec<(ContactName, f64, Option<f64>)>,
    /// Number of contacts and of velocities, where there are more contacts: the forces are then never determined.
    pub surplus: Option<(usize, usize)>,
}

/// All normal forces that a problem allows, for a step of length `h`: its contacts, the edges of their friction cones, and q.
pub(super) fn forces<S: Mechanics>(
    world: &World<S>,
    poses: &[S::Pose],
    contacts: &[Contact<S>],
    edges: &[[f64; 2]],
    q: &[f64],
    h: f64,
) -> Option<Forces> {
    if contacts.is_empty() {
        return None;
    }
    // more contacts than velocities: their normals are dependent, whatever else holds
    let freedoms = S::Velocity::default().as_ref().len();
    let is_free = |body: usize| !world.bodies[body].is_kinematic;
    let bodies: BTreeSet<usize> = contacts.iter().flat_map(Contact::sides).map(|(body, _)| body).collect();
    let n_velocities = freedoms * bodies.into_iter().filter(|body| is_free(*body)).count();
    if contacts.len() > n_velocities {
        return Some(Forces { ranges: Vec::new(), surplus: Some((contacts.len(), n_velocities)) });
    }
    if contacts.len() > MAX_ENUMERATED || q.len() > MAX_VARIABLES {
        return None;
    }
    let lcp = exact_problem(world, poses, contacts, edges, q).ok()?;
    let Enumeration::Complete(all) = enumerate(&lcp, MAX_CASES) else {
        return None;
    };
    let ranges = contacts.iter().enumerate().filter_map(|(i, contact)| {
        let range = all.range(i)?;
        Some((contact.name, to_f64(&range.min) / h, range.max.as_ref().map(|max| to_f64(max) / h)))
    });
    Some(Forces { ranges: ranges.collect(), surplus: None })
}

/// The problem as it is, from rows and masses: a rounded M would ask another question.
pub(super) fn exact_problem<S: Mechanics>(
    world: &World<S>,
    poses: &[S::Pose],
    contacts: &[Contact<S>],
    edges: &[[f64; 2]],
    q: &[f64],
) -> Result<ExactLcp, LcpError> {
    let dof = S::Velocity::default().as_ref().len();
    let n_v = dof * world.bodies.len();
    let mut jacobian = Vec::new();
    let mut push = |contact: &Contact<S>, factors: [f64; 3]| {
        let start = jacobian.len();
        jacobian.resize(start + n_v, 0.0);
        for (body, rows) in contact.sides() {
            let mut row = S::Velocity::default();
            for (factor, from) in factors.iter().zip(rows.as_ref()) {
                add_scaled(&mut row, *factor, from);
            }
            let row = S::principal(&world.bodies[body], &poses[body], &row);
            jacobian[start + dof * body..][..dof].copy_from_slice(row.as_ref());
        }
    };
    contacts.iter().for_each(|contact| push(contact, [1.0, 0.0, 0.0]));
    let n_l = edges.len() / contacts.len().max(1);
    for (i, contact) in contacts.iter().enumerate() {
        edges[i * n_l..(i + 1) * n_l].iter().for_each(|[t, o]| push(contact, [0.0, *t, *o]));
    }
    let inverse_mass: Vec<f64> = world.bodies.iter().flat_map(|body| S::inverse_mass(body).as_ref().to_vec()).collect();
    let mu: Vec<f64> = contacts.iter().map(|contact| contact.material.friction).collect();
    Factors { jacobian: &jacobian, inverse_mass: &inverse_mass, mu: &mu, directions: n_l, q }.to_exact()
}
