"""What the drivers in Python share: the scenes, the steps, the CPU time of a run and the line that says its end."""

import json
import sys
import time

STEPS = [5e-2, 2e-2, 1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4]
TRACED = {"rocking_block", "popout_1mm"}  # the measure of these needs the whole way


def scenes():
    """Scenes named on the command line: DRIVER SCENES.json NAME…"""
    with open(sys.argv[1], encoding="utf-8") as file:
        return [scene for scene in json.load(file)["scenes"] if scene["name"] in sys.argv[2:]]


def measure(peer, scene, h, build):
    """Prints one run. `build()` gives an object with `steps(n)` and `state()`, which is (poses, velocities)."""
    steps = round(scene["T"] / h)
    if abs(steps * h - scene["T"]) > 1e-9:
        return  # these engines know no shorter last step
    world, way = build(), []
    if scene["name"] in TRACED:
        for _ in range(steps):
            world.steps(1)
            poses, velocities = world.state()
            way.append([poses[0][1], poses[0][2], velocities[0][2]])
    else:
        world.steps(steps)
    poses, velocities = world.state()
    row = {"peer": peer, "scene": scene["name"], "h": h, "steps": steps, "cpu": fastest(build, steps)}
    print(json.dumps(row | {"poses": poses, "velocities": velocities, "way": way}), flush=True)


def fastest(build, steps):
    """CPU time (s) of the run that others on the machine disturb least.

    Of so many that they take a few hundredths of a second; one is enough if it is long.
    """
    times = []
    while (len(times) < 5 or sum(times) < 0.03) and len(times) < 100 and sum(times) < 0.2:
        world = build()
        start = time.thread_time()
        world.steps(steps)
        times.append(time.thread_time() - start)
    return min(times)
