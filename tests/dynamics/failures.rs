//! The scenes where rigid contact is hard.
use partplan::answer::Simulation;
use partplan::case::{Limits, read_scene};
use partplan::dynamics::{ModelKind, Options, simulate};
use partplan::model::{Planar, Scene, World};

fn stability(name: &str) -> World<Planar> {
    let path = format!("{}/cases/stability/{name}.json", env!("CARGO_MANIFEST_DIR"));
    let case = read_scene(&std::fs::read(path).unwrap(), &Limits::default()).unwrap();
    let Scene::Planar(world) = case.scene else { panic!("{name} is spatial") };
    world
}

fn run(world: &World<Planar>, model: ModelKind, step: Option<f64>) -> Result<Simulation<Planar>, partplan::dynamics::SimulationError> {
    let options = Options { model, step, frames: 200_000, ..Options::default() };
    simulate(world, &options, &mut |_| true)
}

#[test]
fn measure() {
    let mut all: Vec<_> = std::fs::read_dir(format!("{}/cases/stability", env!("CARGO_MANIFEST_DIR"))).unwrap().map(|e| e.unwrap().path()).collect();
    all.sort();
    for path in all {
        let name = path.file_stem().unwrap().to_str().unwrap().to_string();
        let mut world = stability(&name);
        if name == "at_rest" { world.duration = 10.0; }
        for model in [ModelKind::Auto, ModelKind::StewartTrinkle, ModelKind::Moreau, ModelKind::SongPangKumar] {
            match run(&world, model, None) {
                Ok(r) => println!("{name} {model:?}: {:?} t {} last {:?} {:?} gain {:e} pen {:?} res {:e} step {:e} chosen {} err {:?} ev {} impacts {} notes {:?}", r.status, r.time, r.last.poses, r.last.velocities, r.energy.largest_gain, r.penetration, r.solver.residual, r.model.step, r.model.chosen, r.model.error, r.events.len(), r.solver.impacts, r.notes),
                Err(e) => println!("{name} {model:?}: ERR {e}"),
            }
        }
    }
}
