"""How far every run is from its closed form, which settings are the cheapest to a given error, and which goals are met.

compare.py SCENES.json OURS.csv PEERS.jsonl

OURS.csv is what `cargo bench --bench dynamics -- --csv` prints; its errors come from `tests/dynamics/peers.rs`, whose
measure is repeated here for the peers, from their last poses and velocities: planar bodies as x, z, angle, the sphere
as x, y, z. The way of the first body holds z, angle and spin after every step.

Times are CPU times of the steps alone. What partplan does once at the end, no peer does: it says which contact forces
rigid bodies do not determine. That has a column of its own.
"""

import csv
import json
import math
import sys
from collections import defaultdict

TOLERANCES = [1e-2, 1e-3, 1e-4]
# the measure of these only tells which of the admissible motions was taken: free flight after it is a tenth
BRANCHES = ("painleve_inconsistent", "painleve_indeterminate")

# (scene, error, how many times cheaper than the cheapest peer we want to be)
GOALS = [
    ("slide_stop", 1e-3, 10),
    ("slide_stop", 1e-4, 30),
    ("incline_slip", 1e-3, 10),
    ("incline_slip", 1e-4, 40),
    ("backspin_57", 1e-4, 20),
    ("bounce_e08", 1e-2, 20),
    ("rocking_block", 1e-3, 20),
    ("peg_drop_mu0.2", 1e-2, 3),
    ("peg_drop_mu0.2", 1e-3, 10),
    ("peg_drop_mu1", 1e-3, 10),
    ("stack4", 1e-4, 4),
    ("mass_ratio_1000", 1e-3, 50),
    ("mass_ratio_1000", 1e-4, 100),
    ("incline_stick", 1e-4, 2.5),
    ("vgroove_mu0.5", 1e-4, 4),
    ("seed_sphere", 1e-3, 10),
]
# (scene, error, ms of CPU per simulated second): where no peer gets so far
LIMITS = [
    ("bounce_e08", 1e-9, 0.05),
    ("rocking_block", 1e-4, 5),
    ("peg_drop_mu0.2", 1e-4, 5),
]


def error(scene, run):
    """Relative to the natural scale of the scene; not a number for a run that blew up."""
    name, exact, poses, velocities = scene["name"], scene["exact"], run["poses"], run["velocities"]

    def drift(body, x, z):
        return max(abs(poses[body][0] - x), abs(poses[body][1] - z)) / 0.1

    if name in ("slide_stop", "incline_slip"):
        return abs(poses[0][0] - exact["x_final"]) / exact["x_final"]
    if name == "incline_stick":
        return abs(poses[0][0]) / 0.1
    if name == "bounce_e08":
        return abs(poses[0][1] - exact["z_T"]) / 0.15
    if name == "backspin_57":
        return abs(poses[0][0] - exact["x_T"])
    if name == "rocking_block":
        return abs(second_swing(scene["bodies"][0]["th"], run) - exact["theta_next_apex"]) / exact["theta_next_apex"]
    if name.startswith("peg_drop"):
        return abs(poses[0][0] - exact["x_T"]) / 0.1
    if name == "seed_sphere":
        return math.dist(poses[0][:2], exact["xy_T"])
    if name == "painleve_inconsistent":
        return math.dist(velocities[0], exact["v_after_jam"])
    if name == "painleve_indeterminate":
        return min(math.dist(velocities[0], exact[branch]) for branch in ("v_after_jam", "detach_v"))
    if name.startswith("vgroove"):
        return drift(0, 0, exact["z_T"])
    if name in ("stack4", "mass_ratio_100", "mass_ratio_1000"):
        return max(drift(body, 0, z) for body, z in enumerate(exact["z"]))
    if name == "flat_landing":
        return max(drift(0, 0, exact["z_T"]), abs(poses[0][2]))
    if name == "cradle3":
        # two laws of simultaneous impacts are admissible, ours is the second
        found = [velocity[0] for velocity in velocities]
        laws = (exact["v_sequential"], exact["v_simultaneous_newton"])
        return min(max(abs(v - w) for v, w in zip(found, law)) for law in laws)
    if name == "popout_1mm":
        return max(0, max(z for z, _, _ in run["way"]) - 0.05) / 0.1
    raise ValueError(f"no measure for {name}")


def second_swing(start, run):
    """Largest angle between the second and the third time that the block stands upright."""
    way = [(start, 0.0)] + [(angle, spin) for _, angle, spin in run["way"]]
    pairs = list(zip(way, way[1:]))
    upright = next((i for i, (a, b) in enumerate(pairs) if a[0] > 0 >= b[0]), len(way))
    until = next((i for i in range(upright, len(pairs)) if pairs[i][0][0] < 0 <= pairs[i][1][0]), len(way))
    for (angle, spin), (_, next_spin) in pairs[upright:until]:
        if spin < 0 <= next_spin:
            # where the spin changes its sign inside the step
            s = spin / (spin - next_spin)
            return abs(angle + run["h"] * s * (spin + 0.5 * s * (next_spin - spin)))
    return 0.0


def cheapest(settings, tolerance):
    """Cheapest (cost, name, h) of runs {name: {h: (error, cost)}} that is right, and not by luck.

    At the next smaller step the error may be at most three times the tolerance; of the smallest step nothing is known.
    """
    reached = []
    for name, runs in settings.items():
        steps = sorted(runs, reverse=True)
        for h, finer in zip(steps, steps[1:] + [None]):
            if runs[h][0] <= tolerance and (finer is None or runs[finer][0] <= 3 * tolerance):
                reached.append((runs[h][1], name, h))
    return min(reached, default=None)


def shown(best):
    return f"{best[1]}, h={best[2]:g} | {best[0]:.3g}" if best else "none | -"


def read(scenes, ours_path, peers_path):
    """Errors and ms of CPU per simulated second by scene, setting and step, and partplan's ms at the end of runs."""
    ours, peers = defaultdict(lambda: defaultdict(dict)), defaultdict(lambda: defaultdict(dict))
    ends = {}
    with open(ours_path, encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            h, found = float(row["h"]), (float(row["error"]), float(row["ms_per_simulated_second"]))
            ours[row["scene"]][row["model"]][h] = found
            ends[row["scene"], row["model"], h] = float(row["ms_at_end"])
    with open(peers_path, encoding="utf-8") as file:
        for line in file:
            run = json.loads(line.replace("null", "NaN"))  # what JSON has for the numbers of a run that blew up
            scene = scenes[run["scene"]]
            found = (error(scene, run), run["cpu"] * 1e3 / scene["T"])
            peers[run["scene"]][run["peer"]][run["h"]] = found
    return ours, peers, ends


def print_errors(ours, peers):
    print("Siconos is driven from C++, Rapier from Rust, MuJoCo by one call into C a run, Chipmunk (pymunk) and DART by")
    print("one call from Python a step, about half a microsecond. CPU times of the steps, in the least disturbed runs.\n")
    print("## Error, and microseconds of CPU per step")
    for name in ours:
        settings = [*peers[name].items(), *((f"partplan {model}", runs) for model, runs in ours[name].items())]
        steps = sorted({h for _, runs in settings for h in runs}, reverse=True)
        print(f"\n| {name} | " + " | ".join(f"h={h:g}" for h in steps) + " |")
        print("|---" * (len(steps) + 1) + "|")
        for setting, runs in settings:
            cells = [f"{runs[h][0]:.0e} / {runs[h][1] * h * 1e3:.2g}" if h in runs else "" for h in steps]
            print(f"| {setting} | " + " | ".join(cells) + " |")


def print_cheapest(best, ends):
    print("\n## Cheapest to a given error, CPU in ms per simulated second\n")
    print("| scene | error | peer | ms/s | partplan | ms/s | peer / partplan | partplan once at the end, ms |")
    print("|---|---|---|---|---|---|---|---|")
    for (name, tolerance), (peer, own) in best.items():
        if tolerance in TOLERANCES and name not in BRANCHES:
            ratio = f"{peer[0] / own[0]:.1f}" if peer and own else "-"
            end = f"{ends[name, own[1], own[2]]:.2g}" if own else "-"
            print(f"| {name} | {tolerance:g} | {shown(peer)} | {shown(own)} | {ratio} | {end} |")
    print("\nAt the end partplan says which contact forces are not determined; the peers do nothing of the kind.")


def print_goals(best):
    print("\n## Goals\n")
    print("| scene | error | goal | measured | |")
    print("|---|---|---|---|---|")

    def line(name, tolerance, goal, measured, is_met):
        print(f"| {name} | {tolerance:g} | {goal} | {measured} | {'reached' if is_met else 'missed'} |")

    for name, tolerance, goal in GOALS:
        peer, own = best.get((name, tolerance), (None, None))
        if peer and own:
            line(name, tolerance, f"{goal:g} x", f"{peer[0] / own[0]:.1f} x", peer[0] / own[0] >= goal)
        elif own:
            line(name, tolerance, f"{goal:g} x", "no peer gets there", True)
        elif (name, tolerance) in best:
            line(name, tolerance, f"{goal:g} x", "not reached by partplan", False)
    for name, tolerance, limit in LIMITS:
        if (name, tolerance) in best:
            own = best[name, tolerance][1]
            measured = f"{own[0]:.3g} ms/s" if own else "not reached by partplan"
            line(name, tolerance, f"{limit:g} ms/s", measured, own is not None and own[0] <= limit)


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        scenes = {scene["name"]: scene for scene in json.load(file)["scenes"]}
    ours, peers, ends = read(scenes, *sys.argv[2:])
    best = {
        (name, tolerance): (cheapest(peers[name], tolerance), cheapest(ours[name], tolerance))
        for name in ours
        for tolerance in [*TOLERANCES, 1e-9]
    }
    print_errors(ours, peers)
    print_cheapest(best, ends)
    print_goals(best)


if __name__ == "__main__":
    main()
