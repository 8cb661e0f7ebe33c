use crate::peers::scenes;
use partplan::dynamics::*;
#[test]
fn dbg() {
    for s in scenes() {
        for m in [ModelKind::StewartTrinkle, ModelKind::Moreau] {
            let run = simulate(&s.world, &Options { model: m, step: Some(1e-3), ..Default::default() }, &mut |_| true);
            println!("{} {:?} {:?} {} ev {}", s.name, m, run.solver, run.energy.largest_gain, run.events.len());
        }
    }
}
