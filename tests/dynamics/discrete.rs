//! The discrete runs: same step, same number of steps, same state.

use crate::published::{expected, list, number, scenes};
use partplan::dynamics::ModelKind;

/// Every ST scene ends where four orders of the contacts of an independent code end.
#[test]
fn stewart_trinkle_runs_end_where_published() {
    compare(ModelKind::StewartTrinkle);
}

fn compare(model: ModelKind) {
    let (expected, mut faults, mut compared) = (expected(), Vec::new(), 0);
    for scene in scenes().into_iter().filter(|scene| scene.model == model) {
        for row in list(&expected[&scene.name]["rows"]).iter().filter(|row| row.get("discrete").is_some()) {
            let discrete = &row["discrete"];
            let h = number(&row["h"]);
            let steps = usize::try_from(row["steps"].as_u64().unwrap()).unwrap();
            let run = scene.run(h, steps);
            let n_positions = list(&discrete["q"]).len();
            // of a sphere's pose, the position is compared
            for (name, found, wanted) in
                [("q", &run.q[..n_positions], &discrete["q"]), ("v", &run.v[..], &discrete["v"])]
            {
                let tol = number(&discrete["tol"]);
                for (i, (found, wanted)) in found.iter().zip(list(wanted)).enumerate() {
                    compared += 1;
                    let off = (found - number(wanted)).abs();
                    if off > tol {
                        faults.push(format!(
                            "{} h {h} steps {steps}: {name}[{i}] {found} for {wanted}, off {off:e}",
                            scene.name
                        ));
                    }
                }
            }
        }
    }
    assert!(compared > 100, "only {compared} numbers compared");
    assert!(faults.is_empty(), "{} of {compared}:\n{}", faults.len(), faults.join("\n"));
}
