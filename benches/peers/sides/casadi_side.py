"""CasADi's own Jacobian of the exported Python, as its C, compiled."""

import subprocess

from scene import FLAGS


def compiled(scene):
    import casadi

    y = casadi.SX.sym("y", scene.n)
    rates = casadi.vertcat(*scene.model.rates(casadi.vertsplit(y), cos=casadi.cos, sin=casadi.sin, sqrt=casadi.sqrt))
    function = casadi.Function("casadi_jacobian", [y], [casadi.densify(casadi.jacobian(rates, y))])
    generator = casadi.CodeGenerator("casadi_jacobian.c")
    generator.add(function)
    generator.generate(f"{scene.folder}/")
    out = scene.folder / "casadi.o"
    subprocess.run(["gcc", *FLAGS, "-c", "-o", out, scene.folder / "casadi_jacobian.c"], check=True)
    return out
