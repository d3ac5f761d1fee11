"""Tables and archives of runs, as pandas and NumPy read them."""

import hashlib

import numpy as np
import pandas as pd

SCENE = "models/geared_motor.toml"


def test_pandas_reads_a_table_with_its_origin_as_comments(workbench):
    workbench.call("run", workbench.scene(SCENE), "--samples", 10, "--out", "run.csv")
    table = pd.read_csv(workbench.folder / "run.csv", comment="#")
    assert list(table)[:3] == ["time [s]", "alpha [rad]", "theta [rad]"]
    assert len(table) == 11 and all(pd.api.types.is_numeric_dtype(kind) for kind in table.dtypes)
    comments = [line for line in (workbench.folder / "run.csv").read_text().splitlines() if line.startswith("# ")]
    assert f"# sha256 of the scene: {hashlib.sha256(workbench.scene(SCENE).read_bytes()).hexdigest()}" in comments
    assert {"# method", "# tolerance", "# scene", "# made by"} <= {line.split(":")[0] for line in comments}


def test_numpy_reads_an_archive_with_the_numbers_of_the_table(workbench):
    for file in ("run.csv", "run.npz"):
        workbench.call("run", workbench.scene(SCENE), "--samples", 10, "--out", file)
    table = pd.read_csv(workbench.folder / "run.csv", comment="#")
    archive = np.load(workbench.folder / "run.npz")
    named = [f"{name} [{unit}]" for name, unit in zip(archive["columns"], archive["units"])]
    assert named == list(table)
    for name, column in zip(archive["columns"], table):
        assert np.array_equal(archive[str(name)], table[column].to_numpy())
    lines = (workbench.folder / "run.csv").read_text().splitlines()
    # the first comment ends with the hash of the table, which the archive holds in an array
    comments = [line.split("; sha256 of all else here: ")[0] for line in lines if line.startswith("#")]
    assert [f"# {line}" for line in archive["provenance"]] == comments and archive["sha256"].size == 1


def test_a_transition_matrix_says_its_origin_too(workbench):
    workbench.call("run", workbench.scene(SCENE), "--transition", "matrix.csv")
    matrix = pd.read_csv(workbench.folder / "matrix.csv", comment="#", index_col=0)
    assert matrix.shape[0] == matrix.shape[1] == 6
