"""GSL and Boost's odeint on the exported C, in one program: peers.cpp."""

import pathlib
import subprocess

from scene import FLAGS, Server

SOURCE = pathlib.Path(__file__).resolve().parent.parent / "peers.cpp"


def server(scene, flags, headers, casadi):
    """The program, and the runs that it knows."""
    definitions, libraries, names = [], [], []
    if "gsl/gsl_odeiv2.h" in headers:
        definitions, libraries = definitions + ["-DGSL"], libraries + ["-lgsl", "-lgslcblas"]
        names += ["gsl_bsimp", "gsl_msbdf"] if scene.stiff else ["gsl_rk8pd"]
    if "boost/numeric/odeint.hpp" in headers:
        definitions += ["-DODEINT"]
        names += ["odeint_rosenbrock4"] if scene.stiff else ["odeint_dopri5", "odeint_fehlberg78", "odeint_bulirsch_stoer"]
    extra = []
    if casadi:
        definitions, extra = definitions + ["-DCASADI"], [casadi]
    program = scene.folder / "peers"
    command = ["g++", *FLAGS, *definitions, f"-I{scene.folder}", "-o", program, SOURCE, *extra, *flags, *libraries]
    subprocess.run(command, check=True)
    started = Server([str(program), repr(float(scene.end)), *(repr(float(y)) for y in scene.start)]).alive()
    shown = {"gsl": "GSL", "odeint": "odeint"}
    return started, {" ".join([shown[name.split("_")[0]], name.split("_", 1)[1]]): started.run(name) for name in names}
