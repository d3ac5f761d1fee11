"""Scenes as other simulators run them, beside our own runs."""

import csv
import os
import subprocess
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parent.parent


class Workbench:
    """The program `dalembert`, in a folder of its own."""

    def __init__(self, folder):
        self.folder = folder
        self.program = os.environ.get("DALEMBERT", str(ROOT / "target" / "debug" / "dalembert"))

    def call(self, *arguments, accepted=True):
        found = subprocess.run([self.program, *map(str, arguments)], cwd=self.folder, capture_output=True, text=True)
        assert not accepted or found.returncode == 0, found.stderr
        return found

    def scene(self, name):
        """A scene of the repository, or a text."""
        if "\n" not in name:
            return ROOT / "scenes" / name
        path = self.folder / "scene.toml"
        path.write_text(name)
        return path

    def run(self, scene, tolerance=1e-11, samples=100):
        """Our own run: the columns by their names without units."""
        table = self.folder / "run.csv"
        self.call("run", self.scene(scene), "--tol", tolerance, "--samples", samples, "--out", table, "--force")
        with open(table, newline="") as file:
            rows = list(csv.reader(line for line in file if not line.startswith("#")))
        names = [name.rsplit(" [", 1)[0] for name in rows[0]]
        return dict(zip(names, np.array([[float(cell or "nan") for cell in row] for row in rows[1:]]).T))

    def export(self, scene, option, file, *more, accepted=True):
        path = self.folder / file
        found = self.call("export", self.scene(scene), option, path, *more, "--force", accepted=accepted)
        return path if accepted else found


@pytest.fixture
def workbench(tmp_path):
    return Workbench(tmp_path)


def difference(own, name, times, values):
    """The largest difference between our run and another, relative to the size of the quantity; instants of events are left out, where a
    speed has two values."""
    by_time = dict(zip(np.round(own["time"], 9), own[name]))
    pairs = [(by_time[time], value) for time, value in zip(np.round(times, 9), values) if time in by_time]
    assert len(pairs) > 20, "the runs share no instants"
    known, found = np.array(pairs).T
    return np.max(np.abs(known - found)) / max(1.0, np.max(np.abs(known)))
