"""Runs the scenes that are in the plane in Chipmunk through pymunk: pymunk_driver.py SCENES.json NAME…

A step is one call from Python, which costs about half a microsecond of the time shown.
"""

import math

import common
import pymunk


class World:
    def __init__(self, scene, h, iterations, slop):
        self.h = h
        self.space = space = pymunk.Space()
        space.gravity = upright(scene["gravity"])
        space.iterations = iterations
        space.collision_slop = slop  # 0.1 by default, meant for pixels
        self.bodies = []

        def surface(shape):
            # of both surfaces of a contact the product counts
            shape.friction, shape.elasticity = math.sqrt(scene["mu"]), math.sqrt(scene["e"])
            space.add(shape)

        for plane in scene["planes"]:
            (x, y), (nx, ny) = upright(plane["point"]), upright(plane["normal"])
            # a plane is a slab: a segment as thick as the parts are long
            x, y = x - nx, y - ny
            surface(pymunk.Segment(space.static_body, (x - 20 * ny, y + 20 * nx), (x + 20 * ny, y - 20 * nx), 1.0))
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
        for iterations, slop in [(10, 1e-3), (100, 1e-5)]:
            for h in common.STEPS:
                common.measure(f"pymunk {iterations} iterations", scene, h, lambda: World(scene, h, iterations, slop))
