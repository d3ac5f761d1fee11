"""The builder has a call for every table of the language."""

import json
from pathlib import Path

import pytest

import dalembert

ROOT = Path(__file__).parents[3]
TEXTS = sorted(file for folder in ("models", "foreign", "failures") for file in (ROOT / "scenes" / folder).glob("*.toml"))

NAMED = {"frames": "frame", "points": "point", "outputs": "output"}
SINGLE = ("title", "description", "known_as", "language", "gravity")


def rebuilt(tables):
    """The same text by the calls of the builder alone."""

    def keys(values):
        return {name + "_" if name in ("is", "from", "while") else name: value for name, value in values.items()}

    built = dalembert.Model.builder(tables.get("title", "a model"))
    for table, values in tables.items():
        if table == "title":
            continue
        if table in SINGLE:
            built = getattr(built, table)(values)
        elif table in NAMED:
            for name, value in values.items():
                built = getattr(built, NAMED[table])(name, value)
        elif table == "bodies":
            for name, value in values.items():
                built = built.body(name, **keys(value))
        elif table == "inputs":
            for name, value in values.items():
                built = built.input(name, **(keys(value) if isinstance(value, dict) else {"unit": value}))
        elif table == "drive":
            for drive in values:
                built = built.drive(**keys({name: value for name, value in drive.items() if name not in ("machine", "winding")}))
                if "machine" in drive:
                    built = built.machine(**keys(drive["machine"]))
                for winding in drive.get("winding", []):
                    built = built.winding(**keys(winding))
        elif table == "ensemble":
            built = built.ensemble(**{name: value for name, value in values.items() if name != "vary"})
            for kind, varied in values.get("vary", {}).items():
                for name, value in varied.items():
                    built = built.vary(f"{kind}.{name}", **keys(value))
        elif isinstance(values, list):
            for value in values:
                built = getattr(built, table)(**keys(value))
        elif table in ("run", "failure", "regulator"):
            built = getattr(built, table)(**keys(values))
        else:
            built = getattr(built, table)(values)
    return built


def test_every_table_of_the_language_has_a_call():
    tables = json.loads((ROOT / "schema" / "model.schema.json").read_text())["properties"]
    calls = {"frames": "frame", "points": "point", "bodies": "body", "inputs": "input", "outputs": "output", "title": "build"}
    for table in [*tables, "machine", "winding", "vary"]:
        assert callable(getattr(dalembert.ModelBuilder, calls.get(table, table), None)), table


@pytest.mark.parametrize("file", TEXTS, ids=lambda file: file.stem)
def test_a_text_is_built_again_by_calls(file):
    tomllib = pytest.importorskip("tomllib")
    tables = tomllib.loads(file.read_text())
    if "coordinates" not in tables:
        pytest.skip("no system in tables")
    built = rebuilt(tables)
    again = tomllib.loads(built.text)
    for name, value in tables.get("inputs", {}).items():
        if not isinstance(value, dict):
            tables["inputs"][name] = {"unit": value}
    assert again == tables
    assert built.build().states


def test_parts_of_a_drive_need_one():
    with pytest.raises(ValueError, match=r"\.drive\(\.\.\.\) is called before"):
        dalembert.Model.builder().winding(inductance="L")
    with pytest.raises(ValueError, match='begins with "parameters."'):
        dalembert.Model.builder().vary("m", values="1 kg")


def test_the_examples_of_the_builder_are_read():
    circuit = dalembert.Model.builder().coordinates(q="C").energies(coenergy="(1 H)*q'^2/2").force(along="q", is_="(1 V)")
    assert circuit.diode(current="q'", drop="(0.7 V)").build().states == ["q", "q'"]
    driven = dalembert.Model.builder().coordinates(a="rad").drive(name="w", turns="a", inertia="(1e-3 kg m^2)")
    driven = driven.machine(model="brushed", voltage="24 V", flux="0.05 Wb", inductance="2 mH", resistance="0.5 ohm", f="1e-5 N m s")
    assert driven.build().parameters["w_voltage"] == 24


def test_names_of_another_kind_are_refused():
    for call in (lambda b: b.body(3), lambda b: b.frame(3, "N"), lambda b: b.vary(3), lambda b: b.table(3, {}), lambda b: b.table("run", 3), lambda b: b.start([1])):
        with pytest.raises(TypeError, match="a name is a text|names as its keys is accepted"):
            call(dalembert.Model.builder())
