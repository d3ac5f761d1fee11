"""Simulators of bodies on the problems that they can state: MuJoCo, Drake and EXUDYN, each by its own model and its own loop of steps.

MuJoCo and EXUDYN have constant steps: as many as a method of its order needs for a tolerance. MuJoCo wants inertia of every body; a mass point
has 1e-13 kg m^2. Drake takes the tolerance as its target accuracy, down to 1e-9.
"""

import math

import numpy as np
from turns import clocked, repeated

LINK, MASS = 0.5, 1.0


def cartesian(angles, speeds):
    """Places and velocities of three masses by the angles of their links from the axis x, each from the link before it."""
    places, velocities = [], []
    place, velocity, turned, spin = np.zeros(2), np.zeros(2), 0.0, 0.0
    for angle, speed in zip(angles, speeds):
        turned, spin = turned + angle, spin + speed
        along = np.array([math.cos(turned), math.sin(turned)])
        place = place + LINK * along
        velocity = velocity + LINK * spin * np.array([-along[1], along[0]])
        places, velocities = [*places, *place], [*velocities, *velocity]
    return np.array([*places, *velocities])


def joined(positions, speeds):
    return np.array([*positions, *speeds])


def mujoco_triple_pendulum():
    link = f'<joint type="hinge" axis="0 0 1"/><inertial pos="{LINK} 0 0" mass="{MASS}" diaginertia="1e-13 1e-13 1e-13"/>'
    bodies = "".join(f'<body pos="{LINK if number else 0} 0 0">{link}' for number in range(3)) + "</body>" * 3
    return f'<mujoco><option gravity="0 -9.81 0" integrator="RK4"/><worldbody>{bodies}</worldbody></mujoco>', [0, 0, 0], [0, 0, 0], cartesian


def mujoco_pushed_cart_pole():
    pole = '<joint type="hinge" axis="0 0 -1"/><inertial pos="0 0.5 0" mass="0.1" diaginertia="0.005 0.005 0.0083333333333333333"/>'
    cart = '<joint name="x" type="slide" axis="1 0 0"/><inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>'
    push = '<actuator><general joint="x" gainprm="0" biastype="affine" biasprm="10 0 0"/></actuator>'
    world = f'<worldbody><body>{cart}<body>{pole}</body></body></worldbody>'
    return f'<mujoco><option gravity="0 -9.8 0" integrator="RK4"/>{world}{push}</mujoco>', [0, 0.1], [0, 0.5], joined


MUJOCO = {"triple_pendulum": mujoco_triple_pendulum, "pushed_cart_pole": mujoco_pushed_cart_pole}


def mujoco(scene):
    import mujoco
    from mujoco import rollout

    text, positions, speeds, shown = MUJOCO[scene.name]()
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    end = float(scene.end)

    def once(tolerance):
        steps = math.ceil(10 * end * tolerance**-0.25)
        model.opt.timestep = end / steps
        start = np.array([[0.0, *positions, *speeds]])
        took, (states, _) = clocked(lambda: rollout.rollout(model, data, start, nstep=steps))
        count = len(positions)
        return took, shown(states[0, -1, 1 : 1 + count], states[0, -1, 1 + count : 1 + 2 * count])

    return {"MuJoCo RK4": lambda tolerance: repeated(lambda: once(tolerance))}


def drake_triple_pendulum(plant):
    from pydrake.math import RigidTransform
    from pydrake.multibody.tree import FixedOffsetFrame, RevoluteJoint, SpatialInertia, UnitInertia

    plant.mutable_gravity_field().set_gravity_vector([0.0, -9.81, 0.0])
    parent = plant.world_body()
    for number in range(3):
        body = plant.AddRigidBody(f"b{number}", SpatialInertia(MASS, [LINK, 0.0, 0.0], UnitInertia.PointMass([LINK, 0.0, 0.0])))
        place = RigidTransform([LINK if number else 0.0, 0.0, 0.0])
        frame = plant.AddFrame(FixedOffsetFrame(f"at {number}", parent.body_frame(), place))
        plant.AddJoint(RevoluteJoint(f"q{number}", frame, body.body_frame(), [0.0, 0.0, 1.0]))
        parent = body
    return [0, 0, 0], [0, 0, 0], cartesian, []


def drake_pushed_cart_pole(plant):
    from pydrake.multibody.tree import PrismaticJoint, RevoluteJoint, SpatialInertia, UnitInertia

    plant.mutable_gravity_field().set_gravity_vector([0.0, -9.8, 0.0])
    cart = plant.AddRigidBody("cart", SpatialInertia(1.0, [0.0, 0.0, 0.0], UnitInertia(1.0, 1.0, 1.0)))
    # about the joint, per unit of mass: (2 l)^2/3 of a thin pole
    pole = plant.AddRigidBody("pole", SpatialInertia(0.1, [0.0, 0.5, 0.0], UnitInertia(1 / 3, 0.0, 1 / 3)))
    slide = plant.AddJoint(PrismaticJoint("x", plant.world_frame(), cart.body_frame(), [1.0, 0.0, 0.0]))
    plant.AddJoint(RevoluteJoint("theta", cart.body_frame(), pole.body_frame(), [0.0, 0.0, -1.0]))
    plant.AddJointActuator("push", slide)
    return [0, 0.1], [0, 0.5], joined, [10.0]


DRAKE = {"triple_pendulum": drake_triple_pendulum, "pushed_cart_pole": drake_pushed_cart_pole}


def drake(scene):
    from pydrake.multibody.plant import MultibodyPlant
    from pydrake.systems.analysis import ResetIntegratorFromFlags, Simulator

    plant = MultibodyPlant(0.0)
    positions, speeds, shown, push = DRAKE[scene.name](plant)
    plant.Finalize()
    count, end = len(positions), float(scene.end)
    simulator = Simulator(plant)
    context = simulator.get_mutable_context()
    if push:
        plant.get_actuation_input_port().FixValue(context, push)

    def once(tolerance):
        integrator = ResetIntegratorFromFlags(simulator, "runge_kutta3", end)
        integrator.set_target_accuracy(max(tolerance, 1e-9))
        context.SetTime(0.0)
        plant.SetPositionsAndVelocities(context, [*positions, *speeds])
        simulator.Initialize()
        took, _ = clocked(lambda: simulator.AdvanceTo(end))
        state = plant.GetPositionsAndVelocities(context)
        return took, shown(state[:count], state[count:])

    return {"Drake RK3": lambda tolerance: repeated(lambda: once(tolerance))}


def exudyn(scene):
    """The masses on links as the scene has them, in Cartesian coordinates with constraints of distance."""
    import exudyn as exu
    from exudyn import itemInterface as items

    if scene.name != "triple_pendulum":
        return {}
    system = exu.SystemContainer().AddSystem()
    last = system.AddMarker(items.MarkerBodyPosition(bodyNumber=system.AddObject(items.ObjectGround())))
    for number in range(1, 4):
        node = system.AddNode(items.NodePoint2D(referenceCoordinates=[number * LINK, 0.0]))
        marker = system.AddMarker(items.MarkerBodyPosition(bodyNumber=system.AddObject(items.MassPoint2D(physicsMass=MASS, nodeNumber=node))))
        system.AddLoad(items.Force(markerNumber=marker, loadVector=[0, -9.81 * MASS, 0]))
        system.AddObject(items.DistanceConstraint(markerNumbers=[last, marker], distance=LINK))
        last = marker
    system.Assemble()
    places = np.array([LINK, 0, 2 * LINK, 0, 3 * LINK, 0])
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime = float(scene.end)
    settings.timeIntegration.verboseMode = 0
    settings.solutionSettings.writeSolutionToFile = False
    settings.timeIntegration.generalizedAlpha.useIndex2Constraints = True
    settings.timeIntegration.generalizedAlpha.useNewmark = True
    settings.timeIntegration.newton.relativeTolerance = 1e-12

    def once(tolerance):
        settings.timeIntegration.numberOfSteps = math.ceil(10 * float(scene.end) * tolerance**-0.5)
        took, _ = clocked(lambda: system.SolveDynamic(settings))
        data = system.systemData
        return took, joined(places + data.GetODE2Coordinates(), data.GetODE2Coordinates_t())

    return {"EXUDYN trapezoidal, index 2": lambda tolerance: repeated(lambda: once(tolerance))}


TOOLS = {"MuJoCo": mujoco, "Drake": drake, "EXUDYN": exudyn}
SCENES = tuple(MUJOCO)
