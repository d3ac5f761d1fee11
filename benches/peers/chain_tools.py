"""A chain of links in each tool: its accelerations at a state, their derivatives, and the size of the code that is made for it.

A class for each tool. `at` takes a state; `rates` and `jacobian` are the calls that are timed, `accelerations` and `slopes` what they find:
the derivatives of the accelerations by all positions, then by all speeds. `differentiate` prepares them, where a tool has exact ones.
`code` has functions that count the bytes of instructions and constants, by what the code computes, of tools that write code for each
chain; they give None where there is none.
"""

import pathlib
import subprocess
import tempfile

import numpy as np
from chain_text import ACROSS, ALONG, GRAVITY, LENGTH, MASS, axis, text
from scene import FLAGS

# seconds that writing equations, or compiling them, may take
WRITING = 30


class Chain:
    """A tool without derivatives that writes no code."""

    differentiate = None

    def code(self):
        return {}


class Dalembert(Chain):
    def __init__(self, kind, links):
        import dalembert

        self.links, self.model = links, dalembert.Model.from_text(text(kind, links))
        self.f, self.y = self.model.rhs(), np.zeros(2 * links)

    def at(self, q, v):
        self.y[:] = *q, *v

    def rates(self):
        return self.f(0.0, self.y)

    def accelerations(self):
        return self.rates()[self.links :]

    def differentiate(self):
        self.derivatives = self.model.jacobian()

    def jacobian(self):
        return self.derivatives(0.0, self.y)

    def slopes(self):
        return self.jacobian()[self.links :]

    def code(self):
        return {"": lambda: self.f.code_size, ", derivatives": lambda: self.derivatives.code_size}


class Pinocchio(Chain):
    def __init__(self, kind, links):
        import pinocchio as pin

        self.pin, self.model, parent = pin, pin.Model(), 0
        self.model.gravity.linear = np.array([0.0, -GRAVITY, 0.0])
        inertia = pin.Inertia(MASS, np.array([0.0, -LENGTH / 2, 0.0]), np.diag([ACROSS, ALONG, ACROSS]))
        for link in range(links):
            joint = pin.JointModelRZ() if axis(kind, link) == "z" else pin.JointModelRX()
            place = pin.SE3(np.eye(3), np.array([0.0, -LENGTH if link else 0.0, 0.0]))
            parent = self.model.addJoint(parent, joint, place, f"q{link + 1}")
            self.model.appendBodyToJoint(parent, inertia, pin.SE3.Identity())
        self.data, self.load = self.model.createData(), np.zeros(links)

    def at(self, q, v):
        self.q, self.v = q, v

    def rates(self):
        return self.pin.aba(self.model, self.data, self.q, self.v, self.load)

    def accelerations(self):
        return np.array(self.rates())

    def differentiate(self):
        pass

    def jacobian(self):
        return self.pin.computeABADerivatives(self.model, self.data, self.q, self.v, self.load)

    def slopes(self):
        by_positions, by_speeds, _ = self.jacobian()
        return np.hstack([by_positions, by_speeds])


class Mujoco(Chain):
    """Its derivatives are finite differences of a step, and are left out."""

    def __init__(self, kind, links):
        import mujoco

        opened = "".join(
            f'<body pos="0 {-LENGTH if link else 0} 0"><joint type="hinge" axis="{"0 0 1" if axis(kind, link) == "z" else "1 0 0"}"/>'
            f'<inertial pos="0 {-LENGTH / 2} 0" mass="{MASS}" diaginertia="{ACROSS} {ALONG} {ACROSS}"/>'
            for link in range(links)
        )
        xml = f'<mujoco><option gravity="0 {-GRAVITY} 0"/><worldbody>{opened}{"</body>" * links}</worldbody></mujoco>'
        self.forward, self.model = mujoco.mj_forward, mujoco.MjModel.from_xml_string(xml)
        self.data = mujoco.MjData(self.model)

    def at(self, q, v):
        self.data.qpos[:], self.data.qvel[:] = q, v

    def rates(self):
        self.forward(self.model, self.data)

    def accelerations(self):
        self.rates()
        return self.data.qacc.copy()


class Drake(Chain):
    """Its derivatives are those of the same plant over numbers with derivatives."""

    def __init__(self, kind, links):
        from pydrake.math import RigidTransform
        from pydrake.multibody.plant import MultibodyPlant
        from pydrake.multibody.tree import FixedOffsetFrame, RevoluteJoint, SpatialInertia, UnitInertia

        self.links, self.plant = links, MultibodyPlant(0.0)
        self.plant.mutable_gravity_field().set_gravity_vector([0.0, -GRAVITY, 0.0])
        # about the joint, per unit of mass: Steiner's part is added to the moments about the centre
        about = UnitInertia(ACROSS / MASS + (LENGTH / 2) ** 2, ALONG / MASS, ACROSS / MASS + (LENGTH / 2) ** 2)
        inertia, parent = SpatialInertia(MASS, [0.0, -LENGTH / 2, 0.0], about), self.plant.world_body()
        for link in range(links):
            body = self.plant.AddRigidBody(f"b{link}", inertia)
            place = RigidTransform([0.0, -LENGTH if link else 0.0, 0.0])
            about_axis = [0.0, 0.0, 1.0] if axis(kind, link) == "z" else [1.0, 0.0, 0.0]
            offset = self.plant.AddFrame(FixedOffsetFrame(f"at {parent.name()}", parent.body_frame(), place))
            self.plant.AddJoint(RevoluteJoint(f"q{link}", offset, body.body_frame(), about_axis))
            parent = body
        self.plant.Finalize()
        self.context, self.found = self.plant.CreateDefaultContext(), self.plant.AllocateTimeDerivatives()

    def at(self, q, v):
        self.state = np.concatenate([q, v])

    def rates(self):
        # what is known of a state is kept until another is set
        self.plant.SetPositionsAndVelocities(self.context, self.state)
        self.plant.CalcTimeDerivatives(self.context, self.found)

    def accelerations(self):
        self.rates()
        return self.found.CopyToVector()[self.links :]

    def differentiate(self):
        from pydrake.autodiffutils import ExtractGradient, InitializeAutoDiff

        self.dual, self.gradient = self.plant.ToAutoDiffXd(), ExtractGradient
        self.duals, self.dual_context = InitializeAutoDiff(self.state), self.dual.CreateDefaultContext()
        self.dual_rates = self.dual.AllocateTimeDerivatives()

    def jacobian(self):
        self.dual.SetPositionsAndVelocities(self.dual_context, self.duals)
        self.dual.CalcTimeDerivatives(self.dual_context, self.dual_rates)

    def slopes(self):
        self.jacobian()
        return self.gradient(self.dual_rates.CopyToVector())[self.links :]


def energies(kind, links, q, v, cos, sin):
    """Kinetic and potential energy of the chain, over the numbers of any tool."""
    turn, spin, velocity, height = np.eye(3), np.zeros(3), np.zeros(3), 0
    kinetic = potential = 0
    for link in range(links):
        c, s = cos(q[link]), sin(q[link])
        own = [[c, -s, 0], [s, c, 0], [0, 0, 1]] if axis(kind, link) == "z" else [[1, 0, 0], [0, c, -s], [0, s, c]]
        product = lambda a, b: [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]
        into = lambda vector: [sum(own[k][i] * vector[k] for k in range(3)) for i in range(3)]
        turn = product(turn, own)
        # in the axes of the link
        spin, velocity = into(spin), into(velocity)
        spin[2 if axis(kind, link) == "z" else 0] += v[link]
        moved = lambda length: [velocity[0] + spin[2] * length, velocity[1], velocity[2] - spin[0] * length]
        centre = moved(LENGTH / 2)
        kinetic += MASS / 2 * sum(one * one for one in centre)
        kinetic += (ACROSS * spin[0] * spin[0] + ALONG * spin[1] * spin[1] + ACROSS * spin[2] * spin[2]) / 2
        potential += MASS * GRAVITY * (height - LENGTH / 2 * turn[1][1])
        velocity, height = moved(LENGTH), height - LENGTH * turn[1][1]
    return kinetic, potential


def compiled_size(source):
    """Bytes of instructions and constants that the C compiler makes of C code; None where it takes too long."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "code.o"
        try:
            subprocess.run(["gcc", *FLAGS, "-c", "-o", out, "-x", "c", "-"], input=source, text=True, check=True, timeout=WRITING)
        except subprocess.TimeoutExpired:
            return None
        listed = subprocess.run(["size", "-A", out], capture_output=True, text=True, check=True).stdout
    sections = [line.split() for line in listed.splitlines()]
    return sum(int(words[1]) for words in sections if words and words[0].startswith((".text", ".rodata")))


class Casadi(Chain):
    """Lagrange's equations over its expressions."""

    def __init__(self, kind, links):
        import casadi as ca

        self.ca, self.links = ca, links
        self.letters = q, v = ca.SX.sym("q", links), ca.SX.sym("v", links)
        kinetic, potential = energies(kind, links, ca.vertsplit(q), ca.vertsplit(v), ca.cos, ca.sin)
        momentum = ca.gradient(kinetic, v)
        right = ca.gradient(kinetic - potential, q) - ca.jtimes(momentum, q, v)
        self.written = ca.solve(ca.jacobian(momentum, v), right)
        self.functions, self.found, self.buffers = {}, {}, {}
        self.rates = self.compile("rates", self.written)

    def compile(self, name, expression):
        """The call of an expression, with places for what it reads and writes."""
        function = self.functions[name] = self.ca.Function(name, [*self.letters], [expression])
        buffer, call = function.buffer()
        self.buffers[name], self.found[name] = buffer, np.zeros(expression.shape, order="F")
        buffer.set_res(0, memoryview(self.found[name].reshape(-1, order="F")))
        return call

    def at(self, q, v):
        # what calls read lives as long as they
        self.state = np.array(q), np.array(v)
        self.read("rates")

    def read(self, name):
        for place, part in enumerate(self.state):
            self.buffers[name].set_arg(place, memoryview(part))

    def accelerations(self):
        self.rates()
        return self.found["rates"][:, 0].copy()

    def differentiate(self):
        ca = self.ca
        self.jacobian = self.compile("jacobian", ca.densify(ca.jacobian(self.written, ca.vertcat(*self.letters))))
        self.read("jacobian")

    def slopes(self):
        self.jacobian()
        return self.found["jacobian"].copy()

    def code(self):
        def size(function):
            generator = self.ca.CodeGenerator("chain.c")
            generator.add(function)
            return compiled_size(generator.dump())

        names = {"rates": "", "jacobian": ", derivatives"}
        return {names[name]: lambda function=function: size(function) for name, function in self.functions.items()}


class Sympy(Chain):
    """Lagrange's equations; NumPy solves for the accelerations, and for their derivatives with the same matrix."""

    def __init__(self, kind, links):
        import sympy as sp
        from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols

        q = dynamicsymbols(f"q:{links}")
        v = [one.diff() for one in q]
        kinetic, potential = energies(kind, links, q, v, sp.cos, sp.sin)
        method = LagrangesMethod(kinetic - potential, q)
        method.form_lagranges_equations()
        self.sp, self.letters = sp, sp.symbols(f"a:{links} b:{links}")
        given = dict(zip([*v, *q], [*self.letters[links:], *self.letters[:links]]))
        self.mass, self.forcing = method.mass_matrix.subs(given), method.forcing.subs(given)
        self.terms = sp.lambdify(self.letters, [self.mass, self.forcing], modules="numpy", cse=True)

    def at(self, q, v):
        self.state = [*q, *v]

    def rates(self):
        mass, forcing = self.terms(*self.state)
        return np.linalg.solve(np.array(mass, float), np.array(forcing, float)[:, 0])

    accelerations = rates

    def differentiate(self):
        # M z = f, so M z' = f' - M' z
        known = self.sp.symbols(f"z:{len(self.letters) // 2}")
        right = (self.forcing - self.mass * self.sp.Matrix(known)).jacobian(self.letters)
        self.right = self.sp.lambdify([*self.letters, *known], right, modules="numpy", cse=True)

    def jacobian(self):
        mass, forcing = self.terms(*self.state)
        mass = np.array(mass, float)
        known = np.linalg.solve(mass, np.array(forcing, float)[:, 0])
        return np.linalg.solve(mass, np.array(self.right(*self.state, *known), float))

    slopes = jacobian

    def code(self):
        return {", matrix and forces": lambda: compiled_size(self.source())}

    def source(self):
        steps, values = self.sp.cse([*self.mass, *self.forcing])
        rows = [f"double {name} = {self.sp.ccode(value)};" for name, value in steps]
        rows += [f"out[{place}] = {self.sp.ccode(value)};" for place, value in enumerate(values)]
        read = [f"double {letter} = y[{place}];" for place, letter in enumerate(self.letters)]
        head = "#include <math.h>\nvoid terms(const double *y, double *out) {\n"
        return head + "\n".join([*read, *rows, "}", ""])


TOOLS = {"dalembert": Dalembert, "Pinocchio": Pinocchio, "MuJoCo": Mujoco, "Drake": Drake, "CasADi": Casadi, "SymPy": Sympy}
