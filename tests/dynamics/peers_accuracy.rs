//! Located impacts on the scenes of the other engines.
use crate::peers::{scenes, sphere, sphere_error};
use partplan::dynamics::{ModelKind, Options, simulate};
#[test]
fn measure() {
    for peer in scenes() {
        let at = |model, step, tolerance| {
            let options = Options { model, step, tolerance, frames: 1_000_000, ..Options::default() };
            simulate(&peer.world, &options, &mut |_| true).unwrap()
        };
        let [a, b, c, d] = [1e-2, 1e-3, 5e-4, 2.5e-4].map(|h| { let r = at(ModelKind::Moreau, Some(h), 1e-3); (peer.error(&r), r.status) });
        println!("{}: {:e} {:e} {:e} {:e} {:?}", peer.name, a.0, b.0, c.0, d.0, b.1);
        let r = at(ModelKind::Auto, None, 1e-3);
        println!("    auto {:e} est {:?} step {:e} {:?} gain {:e} {:?}", peer.error(&r), r.model.error, r.model.step, r.status, r.energy.largest_gain, r.notes);
    }
    for h in [1e-2, 1e-3] {
        let options = Options { model: ModelKind::Moreau, step: Some(h), ..Options::default() };
        println!("sphere {h} {:e}", sphere_error(&simulate(&sphere(), &options, &mut |_| true).unwrap()));
    }
        let r = simulate(&sphere(), &Options::default(), &mut |_| true).unwrap();
        println!("sphere auto {:e} {:?}", sphere_error(&r), r.model.error);
}
