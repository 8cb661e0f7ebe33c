"""Runs the scenes in MuJoCo: mujoco_driver.py SCENES.json NAME…

Planar bodies have two slides and a hinge, so that MuJoCo too solves three degrees of freedom a body. All steps of a run
are one call into C.
"""

import math

import common
import mujoco

# the manual's advice against slip: elliptic cones, a stiff ratio of friction to normal impedance, and noslip iterations
TUNED = '<option cone="elliptic" impratio="100" noslip_iterations="20" noslip_tolerance="1e-12" tolerance="1e-12"/>'


class World:
    def __init__(self, scene, h, is_tuned):
        self.is_planar = scene["dim"] != "3d"
        self.model = mujoco.MjModel.from_xml_string(xml(scene, h, is_tuned))
        self.data = mujoco.MjData(self.model)
        self.count = len(scene["bodies"])
        for i, body in enumerate(scene["bodies"]):
            if self.is_planar:
                self.data.qpos[3 * i : 3 * i + 3] = [body["pos"][0], body["pos"][2], body["th"]]
                self.data.qvel[3 * i : 3 * i + 3] = [body["vel"][0], body["vel"][2], body["om_planar"]]
            else:
                self.data.qpos[:3] = body["pos"]
                self.data.qvel[:] = body["vel"] + body["om"]

    def steps(self, count):
        mujoco.mj_step(self.model, self.data, count)

    def state(self):
        q, v = self.data.qpos.tolist(), self.data.qvel.tolist()
        cut = lambda values: [values[3 * i : 3 * i + 3] for i in range(self.count)]
        return cut(q), cut(v)


def xml(scene, h, is_tuned):
    mu = scene["mu"]
    surface = f'condim="{3 if mu > 0 else 1}" friction="{mu} 0 0" {stiffness(scene["e"], h, is_tuned)}'
    planes = [
        f'<geom type="plane" size="0 0 1" zaxis="{words(p["normal"])}" pos="{words(p["point"])}" {surface}/>'
        for p in scene["planes"]
    ]
    joints = '<freejoint/>'
    if scene["dim"] != "3d":
        joints = (
            '<joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 0 1"/><joint type="hinge" axis="0 -1 0"/>'
        )
    bodies = [
        f'<body>{joints}<inertial pos="0 0 0" mass="{b["mass"]}" diaginertia="{words(b["I"])}"/>'
        f'{"".join(f"<geom {shape} {surface}/>" for shape in shapes(b))}</body>'
        for b in scene["bodies"]
    ]
    return (
        f'<mujoco><compiler angle="radian"/><option timestep="{h}" gravity="{words(scene["gravity"])}"/>'
        f'{TUNED if is_tuned else ""}<worldbody>{"".join(planes + bodies)}</worldbody></mujoco>'
    )


def shapes(body):
    if body["shape"] == "box":
        return [f'type="box" size="{words(body["half"])}"']
    if body["shape"] == "sphere":
        return [f'type="sphere" size="{body["r"]}"']
    return [f'type="sphere" size="{body["rho"]}" pos="{x} 0 0"' for x in (-body["half"], body["half"])]


def stiffness(e, h, is_tuned):
    """MuJoCo has no restitution: a contact is a spring with a dashpot, and e follows from its damping ratio."""
    if not is_tuned:
        return ""
    if e == 0:
        return f'solref="{2 * h} 1" solimp="0.99 0.999 0.0001"'
    damping = -math.log(e) / math.hypot(math.pi, math.log(e))
    frequency = 0.3 / h  # rad/s, the stiffest that the steps still resolve
    return f'solref="{-(frequency**2)} {-2 * damping * frequency}" solimp="0.99 0.999 0.0001"'


def words(values):
    return " ".join(map(repr, values))


if __name__ == "__main__":
    for scene in common.scenes():
        for name, is_tuned in [("default", False), ("tuned", True)]:
            for h in common.STEPS:
                common.measure(f"MuJoCo {name}", scene, h, lambda: World(scene, h, is_tuned))
