"""Runs the scenes in DART through dartpy: dartpy_driver.py SCENES.json NAME…

All bodies are free in space: with planar joints the friction across the plane has nothing to move, and DART's LCP
solver fails. Planes are large boxes because DART's own detector knows no planes. A step is one call from Python, which
costs about half a microsecond of the time shown.
"""

import math

import common
import dartpy as dart


class World:
    def __init__(self, scene, h):
        self.is_planar = scene["dim"] != "3d"
        self.world = dart.simulation.World()
        self.world.setGravity(scene["gravity"])
        self.world.setTimeStep(h)
        self.world.setCollisionDetector(dart.collision.DARTCollisionDetector())
        sleep = self.world.getDeactivationOptions()
        sleep.mEnabled = False
        self.world.setDeactivationOptions(sleep)

        def surface(node, shape, place=None):
            part = node.createShapeNode(shape)
            part.createCollisionAspect()
            aspect = part.createDynamicsAspect()
            # of both surfaces of a contact the smaller friction counts, and the product of the restitutions
            aspect.setFrictionCoeff(scene["mu"])
            aspect.setRestitutionCoeff(math.sqrt(scene["e"]))
            if place is not None:
                part.setRelativeTranslation(place)

        for plane in scene["planes"]:
            ground = dart.dynamics.Skeleton()
            joint, node = ground.createWeldJointAndBodyNodePair()
            surface(node, dart.dynamics.BoxShape([20.0, 20.0, 2.0]))
            joint.setTransformFromParentBodyNode(slab(plane))
            self.world.addSkeleton(ground)
        self.bodies = []
        for i, body in enumerate(scene["bodies"]):
            skeleton = dart.dynamics.Skeleton(f"body {i}")
            joint, node = skeleton.createFreeJointAndBodyNodePair()
            node.setInertia(dart.dynamics.Inertia(body["mass"], [0.0, 0.0, 0.0], diagonal(body["I"])))
            for shape, place in shapes(body):
                surface(node, shape, place)
            spin = [0.0, -body["om_planar"], 0.0] if self.is_planar else body["om"]
            joint.setPositions([0.0, -body["th"], 0.0, *body["pos"]])
            joint.setLinearVelocity(body["vel"])
            joint.setAngularVelocity(spin)
            self.world.addSkeleton(skeleton)
            self.bodies.append(node)

    def steps(self, count):
        step = self.world.step
        for _ in range(count):
            step()

    def state(self):
        poses, velocities = [], []
        for body in self.bodies:
            pose, v, w = body.getWorldTransform(), body.getLinearVelocity().tolist(), body.getAngularVelocity()
            place, turn = pose.translation().tolist(), pose.rotation()
            angle = math.atan2(turn[2][0], turn[0][0])
            poses.append([place[0], place[2], angle] if self.is_planar else place)
            velocities.append([v[0], v[2], -w[1]] if self.is_planar else v)
        return poses, velocities


def slab(plane):
    """Pose of a box, two metres thick, whose upper face is the plane."""
    (px, py, pz), (nx, _, nz) = plane["point"], plane["normal"]
    pose = dart.math.Isometry3()
    pose.set_rotation([[nz, 0.0, nx], [0.0, 1.0, 0.0], [-nx, 0.0, nz]])
    pose.set_translation([px - nx, py, pz - nz])
    return pose


def shapes(body):
    if body["shape"] == "box":
        return [(dart.dynamics.BoxShape([2 * half for half in body["half"]]), None)]
    if body["shape"] == "sphere":
        return [(dart.dynamics.SphereShape(body["r"]), None)]
    return [(dart.dynamics.SphereShape(body["rho"]), [x, 0.0, 0.0]) for x in (-body["half"], body["half"])]


def diagonal(values):
    return [[value if i == j else 0.0 for j in range(3)] for i, value in enumerate(values)]


if __name__ == "__main__":
    for scene in common.scenes():
        for h in common.STEPS:
            common.measure("DART", scene, h, lambda: World(scene, h))
