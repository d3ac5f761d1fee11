"""One scene: our side of it, and its laws as code for the others."""

import ctypes
import importlib.util
import pathlib
import subprocess

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
FLAGS = ["-O3", "-march=native"]


class Server:
    """A program that answers each line by nanoseconds and a state."""

    def __init__(self, command):
        self.process = subprocess.Popen(command, cwd=ROOT, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def read(self):
        return [float(word) for word in self.process.stdout.readline().split()]

    def ask(self, line):
        self.process.stdin.write(line + "\n")
        self.process.stdin.flush()
        return self.read()

    def alive(self):
        """Itself, if it still runs a moment after its start: a program without its libraries does not."""
        try:
            code = self.process.wait(timeout=0.2)
        except subprocess.TimeoutExpired:
            return self
        raise RuntimeError(f"{self.process.args[0]} ended at once, with {code}")

    def run(self, method):
        def run(tolerance):
            nanoseconds, *state = self.ask(f"{method} {tolerance!r}")
            return nanoseconds, state

        return run

    def close(self):
        self.process.stdin.close()
        self.process.wait()


class Scene:
    """The reference, where all start, and the exported right-hand side."""

    def __init__(self, path, folder, model=None):
        self.name, self.folder = path.stem, pathlib.Path(folder)
        self.stiff = "stiff" in self.name
        chosen = ["--model", model] if model else []
        self.ours = Server(["cargo", "bench", "--quiet", "--bench", "peers", "--", str(path), "--code", str(folder), *chosen])
        head = self.ours.read()
        if not head:
            raise RuntimeError(f"{path}: no reference")
        self.digits, self.end = head
        self.exact, self.sizes, self.start = (np.array(self.ours.read()) for _ in range(3))
        self.n = len(self.start)
        described = importlib.util.spec_from_file_location("exported", self.folder / "exported.py")
        self.model = importlib.util.module_from_spec(described)
        described.loader.exec_module(self.model)

    def error(self, state):
        """Of a last state: relative to the largest size of each component."""
        return float(np.max(np.abs(np.asarray(state) - self.exact) / self.sizes))


class Library:
    """The exported C as a shared library, for tools that call back."""

    def __init__(self, scene):
        out, source = scene.folder / "rates.so", scene.folder / "rates.h"
        subprocess.run(["gcc", *FLAGS, "-shared", "-fPIC", "-o", out, "-x", "c", source, "-lm"], check=True)
        self.code = ctypes.CDLL(str(out))
        for function in (self.code.rates, self.code.jacobian):
            function.argtypes = [ctypes.c_void_p, ctypes.c_void_p]
        self.n, self.room = scene.n, np.zeros((scene.n, scene.n))

    def rates(self, t, y):
        y, out = np.ascontiguousarray(y), np.empty(self.n)
        self.code.rates(y.ctypes.data, out.ctypes.data)
        return out

    def jacobian(self, t, y):
        y, out = np.ascontiguousarray(y), np.empty((self.n, self.n))
        self.code.jacobian(y.ctypes.data, out.ctypes.data)
        return out
