"""Adds the runs of other engines to a chart: to_chart.py SCENES.json PEERS.jsonl chart.csv

Of each engine the points that no other setting or step of it beats in both error and time. Errors are those of the final
place in metres, as `plan chart` has them; the time is that of the least disturbed run, so its quartiles are alike.
"""

import csv
import json
import math
import sys
from collections import defaultdict

from compare import error

# scene, the name of its work in a chart, metres for an error of one, and the way from start to end in metres: a run that is
# no nearer than the start was has failed, as in src/chart/stepping.rs
WORKS = {
    "slide_stop": ("box slides to a stop", 1.529051987767584, 1.529051987767584),
    "incline_slip": ("box slips on an incline", 0.08756747335166935, 0.08756747335166935),
    "backspin_57": ("ball with backspin", 1.0, 0.5104190503928377),
    "bounce_e08": ("ball bounces", 0.15, 0.12391696214870594),
}
ENGINES = {"pymunk": "Chipmunk", "Rapier2D": "Rapier"}


def front(runs):
    """Runs (error, time, setting) that none beats in both, by time."""
    kept, best = [], math.inf
    for run in sorted(runs, key=lambda run: (run[1], run[0])):
        if run[0] < best:
            kept.append(run)
            best = run[0]
    return kept


def main():
    scenes_path, peers_path, chart_path = sys.argv[1:]
    with open(scenes_path, encoding="utf-8") as file:
        scenes = {scene["name"]: scene for scene in json.load(file)["scenes"]}
    found = defaultdict(list)
    with open(peers_path, encoding="utf-8") as file:
        for line in file:
            run = json.loads(line.replace("null", "NaN"))
            if run["scene"] not in WORKS:
                continue
            work, scale, way = WORKS[run["scene"]]
            engine, _, setting = run["peer"].partition(" ")
            engine = ENGINES.get(engine, engine)
            metres = scale * error(scenes[run["scene"]], run)
            if math.isfinite(metres):
                setting = ", ".join(filter(None, [f"h = {run['h']:g}", setting.strip(" ,()")]))
                found[work, engine].append((metres, run["cpu"], setting, run["scene"], int(metres > way)))
    with open(chart_path, encoding="utf-8", newline="") as file:
        lines = file.read().splitlines(keepends=True)
    head = [line for line in lines if line.startswith("#")]
    rows = list(csv.reader(line for line in lines if not line.startswith("#")))
    columns, rows = rows[0], rows[1:]
    rows = [row for row in rows if "dynamics_peers" not in row[columns.index("command")]]
    ends = [i for i, row in enumerate(rows) if row[:2] == ["point", "stepping"]]
    own, rest = rows[: ends[-1] + 1], rows[ends[-1] + 1 :]
    for (work, engine), runs in sorted(found.items(), key=lambda item: list(WORKS).index(item[1][0][3])):
        for metres, cpu, setting, scene, failed in front(runs):
            row = dict.fromkeys(columns, "") | {
                "kind": "point", "family": "stepping", "work": work, "method": engine, "setting": setting,
                "error": repr(metres), "failed": failed, "of": 1,
                "time_low_s": repr(cpu), "time_median_s": repr(cpu), "time_high_s": repr(cpu),
                "command": f"benches/dynamics_peers.sh {scene}",
            }
            own.append([row[column] for column in columns])
    with open(chart_path, "w", encoding="utf-8", newline="") as file:
        file.writelines(head)
        csv.writer(file, lineterminator="\n").writerows([columns, *own, *rest])


main()
