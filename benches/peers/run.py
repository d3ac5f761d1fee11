#!/usr/bin/env python3
"""Milliseconds to reach an error: dalembert beside other tools, on the same scenes, side by side in one run.

    python3 benches/peers/run.py [--rounds 3] [--install] [--reduced] [SCENE.toml ...]

needs cargo, Python 3.10, and the network once: the peers go into target/peers (install.py). Without scenes all are run: the
three here and problems of others against all peers, those of scenes/ against heyoka, and these with the reduced model where they have one. With
scenes only these, with --reduced their reduced model; the others' last figures are kept. `--install` installs, compiles, and
runs nothing. Writes results.json and results.md; ends with 1 where a tool does not agree with the reference.

What is compared, and how:

* The model is written once: ours.rs exports the right-hand side and its exact Jacobian from the recorded laws. heyoka, JAX,
  CasADi and SymPy trace the Python, the others call the C (-O3 -march=native).
* Every tool runs over a scan of tolerances. Errors are those achieved at the end, relative to the largest size of each
  component, against a reference in double-double that two methods of ours confirm. Times are interpolated between the two
  runs around an error, logarithmically; a tool that is better than asked at its loosest tolerance counts with that run.
* Below what double precision rounds we go on in double-double, and heyoka in long double, in a scan of its own of each round.
* The tools take turns at each tolerance, several rounds; figures are medians. Each clock runs inside the tool's own process.
  Setting up (recording, compiling, tracing) is counted apart; heyoka compiles for each tolerance, and it is that of one.
  SciPy calls the compiled C through ctypes: that and its own Python are in its times, as in any use of it from Python.
* symjit compiles the right-hand side from SymPy's expressions, for SciPy's DOP853: its calls are in its times too. It takes trees, so that
  what expressions share is written out, and it is left out where that is too long.
* CVODE, IDA and RADAU5 run in one compiled program on the same C (dae.cpp). CVODE and RADAU5 take the ordinary differential
  equations; IDA and RADAU5 take the residual with multipliers too, in index 1 and, after Gear, Gupta and Leimkuhler, in
  index 2 (residual.rs). Errors count positions and speeds; heyoka is left out where it is not compiled in a minute.
* MuJoCo, Drake and EXUDYN state two of the problems by models of their own, and their results are taken to our coordinates.
* The reduced model has two windings in the place of all damper bars: the same motion, proved. It is compared with itself,
  and ours with heyoka's full one.
"""

import argparse
import json
import pathlib
import platform
import statistics
import subprocess
import sys
import tempfile
import time

import install

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
FOLDER = ROOT / "target" / "peers"
TABLES = [HERE / f"{name}.toml" for name in ("synchronous", "six_bars", "six_bars_stiff")]
SMOOTH = sorted((ROOT / "scenes").glob("*.toml"))
# problems of others that are smooth: of constraints twice differentiated, which all tools run
FOREIGN = [ROOT / "scenes" / "foreign" / f"{name}.toml" for name in (
    "andrews_mechanism", "bicycle", "car_axis", "cartesian_pendulum", "flexible_slider_crank", "pleiades", "pushed_cart_pole", "triple_pendulum")]
# a drive whose diodes conduct backwards, with a constraint that is led to zero
FOREIGN += [ROOT / "scenes" / "drive" / "stiff_diode.toml"]
# all methods of ours that are ahead at some tolerance of some of them
OURS_OF_OTHERS = ["taylor", "dormand_prince_8", "verner_9", "gragg_bulirsch_stoer", "bader_deuflhard", "rodas_4", "radau_iia:3", "radau_iia:5", "radau_iia:7"]
# one tolerance of one setting takes longer to compile
NO_HEYOKA = {"andrews_mechanism", "bicycle", "flexible_slider_crank", "stiff_diode"}
REDUCED = "equivalent_windings"
# the scans: of double precision, and of what has more digits
TOLERANCES = [10.0 ** (-k / 2) for k in range(6, 31)]
FINER = [10.0 ** (-k / 4) for k in range(54, 73)]
OURS = {
    False: ["taylor", "dormand_prince_8", "gragg_bulirsch_stoer"],
    True: ["taylor", "bader_deuflhard", "rodas_4", "radau_iia:3", "radau_iia:5", "radau_iia:7"],
}
FINEST = {False: "taylor in double-double", True: "radau_iia:7 in double-double"}
# who never comes nearer to the reference does not agree with it
AGREES = 1e-5


def optional(scene, name, missing, setup, make):
    """A tool's runs by name; nothing where it is not installed or fails on the scene."""
    begin = time.perf_counter()
    try:
        runs = make()
    except ImportError as error:
        missing[name] = f"not installed: {error}"
    except Exception as error:
        missing[f"{name}, {scene.name}"] = f"failed: {type(error).__name__}: {error}"
    else:
        setup[name] = time.perf_counter() - begin
        return runs
    return {}


def compare(path, model, rounds, cpp, radau5, missing):
    """One scene: times by tolerance, evaluations, set-up times."""
    from scene import Library, Scene
    from sides import casadi_side, compiled_side, dae_side, diffrax_side, heyoka_side, multibody_side, scipy_side, symjit_side
    from turns import measure

    with tempfile.TemporaryDirectory() as folder:
        scene = Scene(path, folder, model)
        setup, ask = {"dalembert": scene.ours.ask("setup")[0] / 1e9}, {}
        with_heyoka = path.stem not in NO_HEYOKA
        runs = {f"dalembert {name}": scene.ours.run(name) for name in (OURS_OF_OTHERS if path in FOREIGN else OURS[scene.stiff])}
        if with_heyoka:
            runs |= optional(scene, "heyoka", missing, setup, lambda: heyoka_side.runs(scene, TOLERANCES))
        if "heyoka" in setup:
            setup["heyoka"] /= len(TOLERANCES) * len(heyoka_side.SETTINGS)
        if path in TABLES + FOREIGN:
            casadi = optional(scene, "CasADi", missing, setup, lambda: casadi_side.compiled(scene))
            ask = {"our rates": (scene.ours, "rates"), "our Jacobian": (scene.ours, "jacobian"), "num-dual Jacobian": (scene.ours, "num-dual")}
            found = optional(scene, "C++", missing, setup, lambda: compiled_side.server(scene, *cpp, casadi)) or (None, {})
            if found[0]:
                ask |= {"exported C, rates": (found[0], "rates"), "exported C, Jacobian": (found[0], "jacobian")}
            if found[0] and casadi:
                ask["CasADi's C, Jacobian"] = (found[0], "casadi")
            library = Library(scene)
            scipy = ["DOP853", "Radau"] if path in FOREIGN else ["Radau", "BDF"] if scene.stiff else ["DOP853"]
            runs |= found[1]
            runs |= optional(scene, "SciPy", missing, setup, lambda: scipy_side.runs(scene, library, scipy))
            if "DOP853" in scipy:
                runs |= optional(scene, "symjit", missing, setup, lambda: symjit_side.runs(scene))
            runs |= optional(scene, "SUNDIALS and RADAU5", missing, setup, lambda: dae_side.runs(scene, cpp[0], radau5))
        if path.stem in multibody_side.SCENES:
            for name, side in multibody_side.TOOLS.items():
                runs |= optional(scene, name, missing, setup, lambda side=side: side(scene))
        if path in TABLES:
            runs |= optional(scene, "diffrax", missing, setup, lambda: diffrax_side.runs(scene))
        finest = FINEST[scene.stiff]
        finer = {f"dalembert {finest}": scene.ours.run(finest)}
        if with_heyoka:
            finer |= optional(scene, "heyoka, long double", missing, setup, lambda: heyoka_side.finer(scene, FINER))
        if "heyoka, long double" in setup:
            setup["heyoka, long double"] /= len(FINER)
        points, failed = measure(scene, [(runs, TOLERANCES), (finer, FINER)], rounds)
        operations = dict(zip(["our rates", "our Jacobian"], scene.ours.ask("operations"))) if ask else {}
        peak = max(scene.ours.ask("peak")[0] for _ in range(rounds)) if ask else None
        samples = {name: [server.ask(what)[0] for _ in range(2 * rounds + 1)] for name, (server, what) in ask.items()}
        scene.ours.close()
        return {
            "states": scene.n,
            "digits": scene.digits,
            "rounds": rounds,
            "setup": setup,
            "nanoseconds": {name: statistics.median(values) for name, values in samples.items()},
            "operations": operations,
            "peak": peak,
            "points": points,
            "failed": {name: tolerances for name, tolerances in failed.items() if tolerances},
            "disagree": [name for name, own in points.items() if disagrees(own)],
        }


def disagrees(own):
    """Whether a tool was asked for more than it came near to; one that is too slow for fine tolerances is not judged."""
    finest = min((tolerance for tolerance, _, _ in own), default=0.0)
    return finest <= AGREES / 100 and min((error for _, error, _ in own), default=1.0) > AGREES


def has_reduced(path):
    return 'model = "multi_current"' in path.read_text() and "currents =" not in path.read_text()


def write(results):
    from tables import page, summary

    results["summary"] = summary(results)
    lines = ",\n".join(f"{json.dumps(key)}: {json.dumps(value)}" for key, value in results.items())
    (HERE / "results.json").write_text("{\n" + lines + "\n}\n")
    (HERE / "results.md").write_text(page(results))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--install", action="store_true")
    parser.add_argument("--reduced", action="store_true")
    parser.add_argument("scenes", nargs="*", type=pathlib.Path)
    asked = parser.parse_args()
    python, missing = install.environment(FOLDER)
    if pathlib.Path(sys.prefix) != FOLDER / "venv":
        return subprocess.run([python, __file__, *sys.argv[1:]]).returncode
    flags, headers, without = install.debian(FOLDER)
    radau5, without_radau5 = install.radau5(FOLDER)
    missing |= without | without_radau5
    subprocess.run(["cargo", "bench", "--quiet", "--bench", "peers", "--no-run"], cwd=ROOT, check=True)
    if asked.install:
        print("\n".join(f"{name}: {reason}" for name, reason in missing.items()) or "all peers are there")
        return 0
    if asked.scenes:
        plan = [(path.resolve(), REDUCED if asked.reduced else None) for path in asked.scenes]
    else:
        plan = [(path, None) for path in TABLES + SMOOTH + FOREIGN] + [(path, REDUCED) for path in SMOOTH if has_reduced(path)]
    stored = HERE / "results.json"
    results = json.loads(stored.read_text()) if stored.exists() else {}
    for path, model in plan:
        key = path.stem + (", reduced" if model else "")
        print(key, file=sys.stderr, flush=True)
        results[key] = compare(path, model, asked.rounds, (flags, headers), radau5, missing)
        results["machine"] = {"processor": install.processor(), "python": platform.python_version(), "missing": missing}
        write(results)
    disagree = [f"{key}: {name}" for key, result in results.items() if key not in ("machine", "summary") for name in result["disagree"]]
    print("\n".join(f"does not agree with the reference: {each}" for each in disagree))
    return 1 if disagree else 0


if __name__ == "__main__":
    sys.exit(main())
