"""Installs the peers by name, in target/peers: nothing of the reader's is changed.

From PyPI into a virtual environment. From Debian the development packages are downloaded and unpacked, not installed: that
needs no rights. What a machine has already is taken as it is, and what cannot be had is said.
"""

import pathlib
import platform
import re
import subprocess
import sys
import venv

PYTHON = ["numpy", "heyoka", "scipy", "jax", "diffrax", "casadi", "mujoco", "drake", "exudyn", "sympy", "symjit"]
# a header that is needed, and the package that brings it
DEBIAN = {"gsl/gsl_odeiv2.h": "libgsl-dev", "boost/numeric/odeint.hpp": "libboost-dev", "ida/ida.h": "libsundials-dev"}
# RADAU5 of Hairer and Wanner stands compiled in a library for R, which it needs for printing alone
RADAU5 = "usr/lib/R/site-library/deSolve/libs/deSolve.so"
RADAU5_PACKAGES = ["r-cran-desolve", "libblas3", "libgfortran5", "libquadmath0"]


def environment(folder, names=PYTHON):
    """The interpreter of the virtual environment with all that pip finds, and what it does not."""
    python, missing = folder / "venv" / "bin" / "python", {}
    if not python.exists():
        venv.create(folder / "venv", with_pip=True)
    have = subprocess.run([python, "-m", "pip", "list", "--format", "freeze"], capture_output=True, text=True).stdout.lower()
    for name in names:
        if not re.search(rf"^{re.escape(name)}==", have, re.MULTILINE):
            print(f"pip: {name}", file=sys.stderr, flush=True)
            done = subprocess.run([python, "-m", "pip", "install", "--quiet", name], capture_output=True, text=True)
            if done.returncode:
                missing[name] = f"pip cannot install it: {done.stderr.strip().splitlines()[-1]}"
    return python, missing


def processor():
    """Its name and the widest of its registers, as far as the system tells: ratios depend on it."""
    path = pathlib.Path("/proc/cpuinfo")
    facts = re.findall(r"^(model name|flags)\s*: (.*)$", path.read_text(), re.MULTILINE) if path.exists() else []
    facts = dict(reversed(facts))
    wide = [name for name in ("avx2", "avx512f", "amx_tile") if name in facts.get("flags", "").split()]
    return ", ".join([facts.get("model name", platform.machine()), *wide])


def has(header, flags=()):
    """Whether the C++ compiler finds a header."""
    command = ["g++", *flags, "-E", "-x", "c++", "-"]
    return subprocess.run(command, input=f"#include <{header}>", capture_output=True, text=True).returncode == 0


def unpacked(root):
    """Flags by which compiler and program find what was unpacked, the libraries of its libraries too (hence no new dtags)."""
    places = root.glob("usr/lib/*-linux-gnu")
    libraries = (flag for place in places for flag in (f"-L{place}", f"-Wl,-rpath,{place},--disable-new-dtags"))
    return [f"-I{root}/usr/include", *libraries]


def debian(folder):
    """Flags for the C++ compiler, the headers that it finds, and what is missing."""
    if subprocess.run(["which", "g++"], capture_output=True).returncode:
        return [], [], {"g++": "not installed (Debian: g++): no rows of GSL, odeint and the exported C"}
    root = folder / "debian"
    flags = unpacked(root)
    missing = {}
    for header, package in DEBIAN.items():
        if not has(header, flags):
            unpack(package, root)
            flags = unpacked(root)
        if not has(header, flags):
            missing[package] = "apt-get cannot download it"
    return flags, [header for header in DEBIAN if has(header, flags)], missing


def radau5(folder):
    """Flags that link RADAU5, and why there is none."""
    root = folder / "debian"
    library = root / RADAU5
    if not library.exists():
        for package in RADAU5_PACKAGES:
            unpack(package, root)
    if not library.exists():
        return [], {"RADAU5": f"apt-get cannot download {RADAU5_PACKAGES[0]}"}
    # an empty library in the place of R
    stand_in = root / "libR.so"
    subprocess.run(["gcc", "-shared", "-x", "c", "/dev/null", "-o", stand_in], check=True)
    places = [root, *root.glob("usr/lib/*-linux-gnu"), *root.glob("usr/lib/*-linux-gnu/blas")]
    return [str(library), "-Wl,--allow-shlib-undefined", *(f"-Wl,-rpath,{place},--disable-new-dtags" for place in places)], {}


def unpack(package, root):
    """Unpacks a Debian package, and those of its own source that it depends on."""
    root.mkdir(parents=True, exist_ok=True)
    family = re.match(r"[a-z-]+", package).group().removesuffix("-dev")
    waiting, seen = [package], set()
    while waiting:
        name = waiting.pop()
        if name in seen or not name.startswith(family):
            continue
        seen.add(name)
        print(f"Debian: {name}", file=sys.stderr, flush=True)
        if subprocess.run(["apt-get", "download", name], cwd=root, capture_output=True).returncode:
            return
        for archive in pathlib.Path(root).glob(f"{name}_*.deb"):
            subprocess.run(["dpkg", "-x", archive, root], check=True)
            depends = subprocess.run(["dpkg", "-f", archive, "Depends"], capture_output=True, text=True).stdout
            waiting += re.findall(r"lib[a-z0-9.+-]+", depends)
