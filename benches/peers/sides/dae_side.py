"""SUNDIALS (CVODE, IDA) and RADAU5 on the exported C, in one program: dae.cpp."""

import pathlib
import subprocess

from scene import FLAGS, Server

SOURCE = pathlib.Path(__file__).resolve().parent.parent / "dae.cpp"
SUNDIALS = ["-lsundials_cvode", "-lsundials_ida", "-lsundials_nvecserial", "-lsundials_sunmatrixdense", "-lsundials_sunlinsoldense"]
SHOWN = {
    "cvode_adams": "CVODE Adams, in C",
    "cvode_bdf": "CVODE BDF, in C",
    "ida_index1": "IDA, index 1",
    "ida_index2": "IDA, index 2 stabilised",
    "radau5_ode": "RADAU5",
    "radau5_index1": "RADAU5, index 1",
    "radau5_index2": "RADAU5, index 2 stabilised",
}


def runs(scene, flags, radau5):
    """All that the model has forms for."""
    header = scene.folder / "dae.h"
    forms = [form for form in ("index1", "index2") if header.exists() and f"HAS_{form.upper()}" in header.read_text()]
    names = ["cvode_adams", "cvode_bdf", *(f"ida_{form}" for form in forms)]
    definitions = ["-DDAE"] if forms else []
    if radau5:
        definitions += ["-DRADAU5"]
        names += ["radau5_ode", *(f"radau5_{form}" for form in forms)]
    program = scene.folder / "dae"
    command = ["g++", *FLAGS, "-rdynamic", *definitions, f"-I{scene.folder}", "-o", program, SOURCE, *radau5, *flags, *SUNDIALS]
    subprocess.run(command, check=True)
    started = Server([str(program), repr(float(scene.end)), *(repr(float(y)) for y in scene.start)]).alive()
    return {SHOWN[name]: started.run(name) for name in names}
