"""Runs the scenes that are in the plane in Chipmunk through pymunk: pymunk_driver.py SCENES.json NAME…

A step is one call from Python, which costs about half a microsecond of the time shown.
"""

import math

import common
import pymunk


# name, iterations, overlap left alone (m), part of the rest that is still there after a second
SETTINGS = [
    ("default", 10, 1e-3, 0.9**60),
    ("tight", 10, 1e-5, 1e-10),
    ("tight, 100 iterations", 100, 1e-5, 1e-10),
]


class World:
    def __init__(self, scene, h, iterations, slop, bias):
        self.h = h
        self.space = space = pymunk.Space()
        space.gravity = upright(scene["gravity"])
        space.iterations = iterations
        space.collision_slop = slop  # 0.1 if left alone, meant for pixels
        space.collision_bias = bias
        self.bodies = []

        def surface(shape):
            # of both surfaces of a contact the product counts
            shape.friction, shape.elasticity = math.sqrt(scene["mu"]), math.sqrt(scene["e"])
            space.add(shape)

        for plane in scene["planes"]:
            (x, y), (nx, ny) = upright(plane["point"]), upright(plane["normal"])
            # a plane is a slab; as a segment, piles on it would be much less accurate
            corners = [(20, 0), (20, -2), (-20, -2), (-20, 0)]
            corners = [(x + along * ny + up * nx, y - along * nx + up * ny) for along, up in corners]
            surface(pymunk.Poly(space.static_body, corners))
        for body in scene["bodies"]:
            part = pymunk.Body(body["mass"], body["I"][1])
            part.position, part.angle = upright(body["pos"]), body["th"]
            part.velocity, part.angular_velocity = upright(body["vel"]), body["om_planar"]
            space.add(part)
            for shape in shapes(part, body):
                surface(shape)
            self.bodies.append(part)

    def steps(self, count):
        step, h = self.space.step, self.h
        for _ in range(count):
            step(h)

    def state(self):
        poses = [[*body.position, body.angle] for body in self.bodies]
        return poses, [[*body.velocity, body.angular_velocity] for body in self.bodies]


def shapes(part, body):
    if body["shape"] == "box":
        a, b = upright(body["half"])
        return [pymunk.Poly(part, [(-a, -b), (a, -b), (a, b), (-a, b)])]
    if body["shape"] == "sphere":
        return [pymunk.Circle(part, body["r"])]
    return [pymunk.Circle(part, body["rho"], (x, 0)) for x in (-body["half"], body["half"])]


def upright(triple):
    return triple[0], triple[2]


if __name__ == "__main__":
    for scene in common.scenes():
        if scene["dim"] == "3d":
            continue
        for name, *setting in SETTINGS:
            for h in common.STEPS:
                common.measure(f"pymunk {name}", scene, h, lambda: World(scene, h, *setting))
