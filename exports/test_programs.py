"""Programs of other languages, compiled and run: their rates, integrated, end where our own runs end."""

import importlib.util
import subprocess

import numpy as np
import pytest

SCENES = ["models/double_pendulum.toml", "models/slider_crank.toml", "models/geared_motor.toml"]

# classical Runge-Kutta steps over the rates of a program
STEPS = 20000

C = """
#include <stdio.h>
int main(void)
{
    enum { N = COORDINATES + SPEEDS, STEPS = %d };
    const double h = %r / STEPS;
    double y[N], k[4][N], at[N];
    for (int i = 0; i < N; ++i) y[i] = start[i];
    for (int step = 0; step < STEPS; ++step) {
        for (int stage = 0; stage < 4; ++stage) {
            const double part = stage == 0 ? 0.0 : stage == 3 ? h : h / 2;
            for (int i = 0; i < N; ++i) at[i] = y[i] + (stage == 0 ? 0.0 : part * k[stage - 1][i]);
            if (rates(step * h + part, at, &defaults, k[stage])) return 1;
        }
        for (int i = 0; i < N; ++i) y[i] += h / 6 * (k[0][i] + 2 * k[1][i] + 2 * k[2][i] + k[3][i]);
    }
    for (int i = 0; i < N; ++i) printf("%%.17g\\n", y[i]);
    return 0;
}
"""

RUST = """
fn main() {
    const N: usize = COORDINATES + SPEEDS;
    let (p, h) = (Parameters::default(), %r / %d as f64);
    let mut y = START;
    for step in 0..%d {
        let mut k = [[0.0; N]; 4];
        for stage in 0..4 {
            let part = [0.0, h / 2.0, h / 2.0, h][stage];
            let at = std::array::from_fn(|i| y[i] + if stage == 0 { 0.0 } else { part * k[stage - 1][i] });
            k[stage] = rates(step as f64 * h + part, &at, &p).expect("they are determined");
        }
        for i in 0..N {
            y[i] += h / 6.0 * (k[0][i] + 2.0 * k[1][i] + 2.0 * k[2][i] + k[3][i]);
        }
    }
    y.iter().for_each(|value| println!("{value:?}"));
}
"""


def last(own, count):
    return np.array([values[-1] for values in list(own.values())[1 : count + 1]])


def near(found, own):
    known = last(own, len(found))
    assert np.allclose(found, known, rtol=0, atol=1e-6 * max(1.0, np.max(np.abs(known)))), (found, known)


def module(path):
    spec = importlib.util.spec_from_file_location(path.stem, path)
    loaded = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(loaded)
    return loaded


@pytest.mark.parametrize("scene", SCENES)
def test_c(workbench, scene):
    own, path = workbench.run(scene), workbench.export(scene, "--c", "system.c")
    path.write_text(path.read_text() + C % (STEPS, float(own["time"][-1])))
    program = workbench.folder / "system"
    subprocess.run(["cc", "-std=c99", "-O2", "-o", program, path, "-lm"], check=True)
    near(np.array(subprocess.run([program], capture_output=True, text=True, check=True).stdout.split(), float), own)


@pytest.mark.parametrize("scene", SCENES)
def test_rust(workbench, scene):
    own, path = workbench.run(scene), workbench.export(scene, "--rust", "system.rs")
    path.write_text(path.read_text() + RUST % (float(own["time"][-1]), STEPS, STEPS))
    program = workbench.folder / "system"
    subprocess.run(["rustc", "-O", "-A", "warnings", "-o", program, path], check=True)
    near(np.array(subprocess.run([program], capture_output=True, text=True, check=True).stdout.split(), float), own)


# conditions within conditions, of which two have one expression
NESTED = """title = "A mass between springs"
[parameters]
m = "2 kg"
F = "3 N"
[coordinates]
x = "m"
[energies]
kinetic = "m*x'^2/2"
[[force]]
along = "x"
is = "-F*if(sign(x)*x <= (1 m)*cos(x/(1 m)), x/(1 m), 2*sign(x)) - F*table(x, (0 m), 0, (2 m), 1) + if(t >= (1 s), F, 0)"
[start]
x = "0.5 m"
[run]
span = "4 s"
"""


@pytest.mark.parametrize("scene", [*SCENES, NESTED])
def test_programs_are_compiled_without_warnings(workbench, scene):
    path = workbench.export(scene, "--c", "system.c")
    subprocess.run(["cc", "-std=c99", "-O1", "-Wall", "-Wextra", "-Werror", "-c", "-o", workbench.folder / "system.o", path], check=True)
    path = workbench.export(scene, "--rust", "system.rs")
    subprocess.run(["rustc", "--crate-type", "lib", "--emit", "metadata", "-D", "warnings", "-o", workbench.folder / "system.rmeta", path], check=True)


def test_nested_conditions_hold_in_every_program(workbench):
    own, path = workbench.run(NESTED), workbench.export(NESTED, "--c", "system.c")
    path.write_text(path.read_text() + C % (STEPS, float(own["time"][-1])))
    program = workbench.folder / "system"
    subprocess.run(["cc", "-std=c99", "-O2", "-o", program, path, "-lm"], check=True)
    found = np.array(subprocess.run([program], capture_output=True, text=True, check=True).stdout.split(), float)
    # steps of constant length go over jumps of the force
    assert np.allclose(found, last(own, 2), rtol=0, atol=1e-3)
    system = module(workbench.export(NESTED, "--python", "system_python.py"))
    y = np.array([0.7, -0.2])
    # at the instant of a condition with equality it holds
    assert system.rates(1.0, y)[1] == system.rates(1.5, y)[1] != system.rates(0.5, y)[1]


@pytest.mark.parametrize("scene", SCENES)
def test_python(workbench, scene):
    own, path = workbench.run(scene), workbench.export(scene, "--python", "system_python.py")
    system = module(path)
    y, steps = system.START, 1000
    h = own["time"][-1] / 10 / steps
    for step in range(steps):
        t = step * h
        a = system.rates(t, y)
        b = system.rates(t + h / 2, y + h / 2 * a)
        c = system.rates(t + h / 2, y + h / 2 * b)
        d = system.rates(t + h, y + h * c)
        y = y + h / 6 * (a + 2 * b + 2 * c + d)
    known = np.array([values[len(own["time"]) // 10] for values in list(own.values())[1 : len(y) + 1]])
    assert np.allclose(y, known, rtol=0, atol=1e-6 * max(1.0, np.max(np.abs(known))))


@pytest.mark.parametrize("scene", SCENES)
def test_casadi(workbench, scene):
    casadi = pytest.importorskip("casadi")
    own, path = workbench.run(scene), workbench.export(scene, "--casadi", "system_casadi.py")
    system = module(path)
    problem = {"t": system.t, "x": system.y, "p": system.letters, "ode": system.rates(system.t, system.y, system.letters)}
    integrator = casadi.integrator("run", "cvodes", problem, 0.0, own["time"][-1], {"reltol": 1e-11, "abstol": 1e-12})
    near(np.array(integrator(x0=system.START, p=system.values())["xf"]).ravel(), own)
    # its derivatives are those of differences
    jacobian = casadi.Function("jacobian", [system.t, system.y, system.letters],
                               [casadi.jacobian(system.rates(system.t, system.y, system.letters), system.y)])
    start = np.array(system.START) + 0.05
    direction = np.linspace(-1.0, 1.0, len(start))
    sides = [np.array(system.rates(0, start + sign * 1e-6 * direction, system.values())).ravel() for sign in (1, -1)]
    wanted = (sides[0] - sides[1]) / 2e-6
    found = np.array(jacobian(0, start, system.values())) @ direction
    assert np.allclose(found, wanted, rtol=1e-5, atol=1e-5 * np.max(np.abs(wanted)))
