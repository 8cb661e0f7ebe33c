//! Polyhedral conversions beside those of other programs: `benches/peers.sh`, or alone `cargo bench --bench polyhedra`.
//!
//! Every conversion runs in a process of its own, on one thread, from coprime integer rows in memory to both minimal
//! forms. Times are CPU times, medians. Each line has the peers' times of the same run, so that its ratio means
//! something on any machine.

mod goals;
mod instances;
mod timing;

use clap::Parser;
use instances::{Instance, Size};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

#[derive(Parser)]
struct Args {
    /// Instances whose names contain one of these; all of them by default.
    names: Vec<String>,
    /// Folder of the peers' drivers; every program in it is one.
    #[arg(long)]
    peers: Option<PathBuf>,
    /// Seconds of CPU time for one program on one instance.
    #[arg(long, default_value_t = 60)]
    cap: u64,
    /// Where the rows of the instances are written.
    #[arg(long, default_value_os_t = env::temp_dir().join("partplan-peers"))]
    scratch: PathBuf,
    /// Time this one file of rows and print its figures.
    #[arg(long, conflicts_with_all = ["names", "peers"])]
    one: Option<PathBuf>,
    /// Passed by cargo.
    #[arg(long, hide = true)]
    bench: bool,
}

fn main() {
    let args = Args::parse();
    if let Some(path) = &args.one {
        let instance = Instance::from_rows(&fs::read_to_string(path).expect("a readable file of rows"));
        let microseconds = timing::median(instance.conversion());
        let size = instance.size();
        println!("{microseconds:.4} {} {}", size.rows, size.linear);
        return;
    }
    fs::create_dir_all(&args.scratch).expect("a folder for the rows");
    let peers = args.peers.as_deref().map(programs).unwrap_or_default();
    let chosen = instances::all().into_iter().filter(|instance| {
        args.names.is_empty() || args.names.iter().any(|name| instance.name.contains(name.as_str()))
    });
    let headings: Vec<&str> = peers.iter().map(|peer| stem(peer)).collect();
    println!("| instance | in | out | plan | {} | best peer / plan |", headings.join(" | "));
    println!("|---|---|---|---{}|---|", "|---".repeat(peers.len()));
    let mut lines = Vec::new();
    for instance in chosen {
        let rows = args.scratch.join(instance.name.replace('/', "_"));
        fs::write(&rows, instance.rows()).expect("a writable folder");
        let own = run(Command::new(env::current_exe().expect("this program")).arg("--one").arg(&rows), args.cap);
        let others: Vec<Option<Figure>> =
            peers.iter().map(|peer| run(Command::new(peer).arg(&rows), args.cap)).collect();
        let line = Line { instance, own, others };
        println!("{}", line.markdown());
        lines.push(line);
    }
    summary(&lines);
    goals::report(|name| {
        lines.iter().find(|line| line.instance.name == name).and_then(|line| line.own.as_ref()?.microseconds.into())
    });
}

/// What one program printed about one instance.
struct Figure {
    microseconds: f64,
    /// Unknown for programs that are only timed.
    size: Option<Size>,
}

struct Line {
    instance: Instance,
    own: Option<Figure>,
    others: Vec<Option<Figure>>,
}

impl Line {
    /// Time of the fastest peer over ours; `None` if either has none.
    fn ratio(&self) -> Option<f64> {
        let best = self.others.iter().flatten().map(|figure| figure.microseconds).min_by(f64::total_cmp)?;
        Some(best / self.own.as_ref()?.microseconds)
    }

    /// Whether every peer that says how many rows it found says the same as we.
    fn agrees(&self) -> bool {
        let Some(own) = self.own.as_ref().and_then(|figure| figure.size) else { return true };
        self.others.iter().flatten().filter_map(|figure| figure.size).all(|size| size == own)
    }

    fn markdown(&self) -> String {
        let time = |figure: &Option<Figure>| figure.as_ref().map_or("-".to_owned(), |f| shown(f.microseconds));
        let size = self.own.as_ref().and_then(|figure| figure.size);
        let size = size.map_or("-".to_owned(), |size| format!("{}+{}L", size.rows, size.linear));
        let others: String = self.others.iter().map(|figure| format!(" {} |", time(figure))).collect();
        let ratio = self.ratio().map_or("-".to_owned(), |ratio| format!("{ratio:.2}"));
        let warning = if self.agrees() { "" } else { " sizes differ" };
        format!(
            "| {} | {} | {size} | {} |{others} {ratio}{warning} |",
            self.instance.name,
            self.instance.shape(),
            time(&self.own)
        )
    }
}

fn summary(lines: &[Line]) {
    let mut ratios: Vec<f64> = lines.iter().filter_map(Line::ratio).collect();
    if ratios.is_empty() {
        return;
    }
    ratios.sort_by(f64::total_cmp);
    let ahead = ratios.iter().filter(|ratio| **ratio >= 1.0).count();
    println!("\nat least parity with the fastest peer on {ahead} of {} instances", ratios.len());
    println!("fastest peer over plan: median {:.2}, least {:.2}", ratios[ratios.len() / 2], ratios[0]);
}

fn programs(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder of drivers");
    let mut programs: Vec<PathBuf> = entries.map(|entry| entry.expect("a readable folder").path()).collect();
    programs.sort();
    programs
}

fn stem(program: &Path) -> &str {
    program.file_stem().and_then(|name| name.to_str()).expect("a driver has a name")
}

/// Runs a program on one instance; `None` if it fails or takes too long.
fn run(program: &mut Command, cap: u64) -> Option<Figure> {
    let cap = cap.to_string();
    // the limit of a shell holds for whatever it becomes, ours and the peers' alike
    let mut shell = Command::new("sh");
    shell.args(["-c", "ulimit -t \"$0\"; exec \"$@\"", &cap]).arg(program.get_program()).args(program.get_args());
    let output = shell.env("CAP", &cap).env("OMP_NUM_THREADS", "1").output().expect("a shell");
    let text = String::from_utf8(output.stdout).ok()?;
    let words: Vec<&str> = text.split_whitespace().collect();
    let [microseconds, rows, linear] = words[..] else { return None };
    let size = rows.parse().ok().zip(linear.parse().ok()).map(|(rows, linear)| Size { rows, linear });
    Some(Figure { microseconds: microseconds.parse().ok()?, size })
}

fn shown(microseconds: f64) -> String {
    match microseconds {
        t if t < 10.0 => format!("{t:.2} µs"),
        t if t < 1_000.0 => format!("{t:.0} µs"),
        t if t < 1e6 => format!("{:.2} ms", t / 1e3),
        t => format!("{:.2} s", t / 1e6),
    }
}
