"""A model built call by call: each call writes one part of its text."""

from __future__ import annotations

import json
from numbers import Integral
from typing import TYPE_CHECKING, Any

from ._arguments import mapping, shown

if TYPE_CHECKING:
    from ._model import Model

__all__ = ["ModelBuilder", "in_toml", "key_in_toml"]


def key_in_toml(name: str) -> str:
    """A name as a key of TOML."""
    plain = name.isascii() and name.replace("_", "a").replace("-", "a").isalnum()
    return name if plain else _text(name)


def _text(value: str) -> str:
    # the escapes of JSON are escapes of TOML, which asks for one more
    return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")


def in_toml(value: Any) -> str:
    """A value of a model as TOML."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return _text(value)
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key_in_toml(str(name))} = {in_toml(one)}" for name, one in value.items()) + " }"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(in_toml, value)) + "]"
    # numbers and arrays of NumPy too, whose own form is none of TOML
    try:
        if hasattr(value, "tolist"):
            return in_toml(value.tolist())
        if isinstance(value, Integral):
            return repr(int(value))
        return repr(float(value))
    except (TypeError, ValueError, OverflowError):
        raise TypeError(f"{shown(value)} is no value of a model: texts, numbers, truth values, lists and dictionaries are accepted") from None


def _plain(name: str) -> str:
    return name[:-1] if name.endswith("_") and len(name) > 1 else name


def _name(value: Any) -> str:
    if not isinstance(value, str):
        raise TypeError(f"a name is a text, and not {shown(value)}")
    return value


# tables that may stand more than once
_LISTS = {"force", "torque", "constraint", "contact", "drive", "event", "diode", "freewheel", "drive.winding", "ensemble.vary"}


class ModelBuilder:
    """A model built call by call.

        model = (
            dalembert.Model.builder("Cart with a pendulum")
            .parameters(M="1 kg", m="0.1 kg", l="0.5 m", g="9.81 m/s^2")
            .coordinates(x="m", theta="rad")
            .point("C", "O + x*N.x")
            .point("P", "C + l*(sin(theta)*N.x - cos(theta)*N.y)")
            .body("cart", centre="C", mass="M")
            .body("bob", centre="P", mass="m")
            .gravity("-g*N.y")
            .start({"theta": "0.3 rad", "theta'": "1 rad/s"})
            .build()
        )

    Every call takes the keys of a table of a text, and gives the builder back. A table of names, such as [parameters] or [start], has a call of its
    own name; an entry of [frames], [points], [bodies], [inputs] and [outputs] has one in the singular, which takes the name of the entry first; a
    table that may stand more than once, such as [[force]], is added by each call. A key that is a word of Python has an underscore behind it:
    is_="-k*x*N.x", from_="1 kg". `text` shows what was written; `table` writes a table by its name.
    """

    def __init__(self, title: str) -> None:
        if not isinstance(title, str):
            raise TypeError(f"a title is a text, and not {shown(title)}")
        self._title = title
        self._top: dict[str, Any] = {}
        self._tables: dict[str, dict[str, Any]] = {}
        self._lists: list[tuple[str, dict[str, Any]]] = []

    def _set(self, table: str, values: dict[str, Any] | None, more: dict[str, Any]) -> ModelBuilder:
        given = mapping(f"values of [{table}]", values, "{'x': 'm'}")
        known = self._tables.setdefault(table, {})
        for name, value in {**given, **{_plain(name): value for name, value in more.items()}}.items():
            if name in known:
                raise ValueError(f"[{table}] has `{name}` already: {known[name]!r}")
            known[name] = value
        return self

    def _add(self, table: str, keys: dict[str, Any]) -> ModelBuilder:
        self._lists.append((table, {_plain(name): value for name, value in keys.items()}))
        return self

    def description(self, text: str) -> ModelBuilder:
        """A sentence on what happens in the model, and why it is of interest."""
        self._top["description"] = text
        return self

    def known_as(self, name: str) -> ModelBuilder:
        """The name of a system about which the program has knowledge beyond its equations: .known_as("crank_drive")."""
        self._top["known_as"] = name
        return self

    def language(self, version: int) -> ModelBuilder:
        """The version of the language, for a text that is kept for years."""
        self._top["language"] = version
        return self

    def parameters(self, values: dict[str, Any] | None = None, **more: Any) -> ModelBuilder:
        """Letters with values and units, m="2 kg"; a unit alone, "kg", leaves a letter without a value."""
        return self._set("parameters", values, more)

    def coordinates(self, values: dict[str, Any] | None = None, **more: Any) -> ModelBuilder:
        """Coordinates with their units: theta="rad"."""
        return self._set("coordinates", values, more)

    def speeds(self, values: dict[str, Any] | None = None, **more: Any) -> ModelBuilder:
        """Quasi-velocities: v="velocity(G) . A.x"."""
        return self._set("speeds", values, more)

    def definitions(self, values: dict[str, Any] | None = None, **more: Any) -> ModelBuilder:
        """Abbreviations of any kind: I="m*r^2/2"."""
        return self._set("definitions", values, more)

    def frame(self, name: str, is_: str) -> ModelBuilder:
        """A frame: .frame("B", "N turned theta about z")."""
        return self._set("frames", {name: is_}, {})

    def point(self, name: str, is_: str) -> ModelBuilder:
        """A point: .point("P", "O + l*B.x")."""
        return self._set("points", {name: is_}, {})

    def body(self, name: str, **keys: Any) -> ModelBuilder:
        """A body: centre, mass, frame, turns, inertia. With mass alone it is a particle."""
        return self._set(f"bodies.{key_in_toml(_name(name))}", keys, {})

    def gravity(self, is_: str) -> ModelBuilder:
        """The acceleration that acts on every body with mass: .gravity("-g*N.y")."""
        self._top["gravity"] = is_
        return self

    def energies(self, values: dict[str, Any] | None = None, **more: Any) -> ModelBuilder:
        """kinetic, potential, dissipation, coenergy: beside bodies, or in their place."""
        return self._set("energies", values, more)

    def force(self, **keys: Any) -> ModelBuilder:
        """A force: .force(on="bob", is_="-k*x*N.x"), or .force(between=["a at P", "b at Q"], is_="k*distance(P, Q)")."""
        return self._add("force", keys)

    def torque(self, **keys: Any) -> ModelBuilder:
        """A torque: .torque(between=["ground", "crank"], is_="T*N.z")."""
        return self._add("torque", keys)

    def constraint(self, **keys: Any) -> ModelBuilder:
        """A constraint: .constraint(zero="x - r*phi")."""
        return self._add("constraint", keys)

    def contact(self, **keys: Any) -> ModelBuilder:
        """A contact with Coulomb's friction."""
        return self._add("contact", keys)

    def diode(self, **keys: Any) -> ModelBuilder:
        """A diode, whose current does not fall below zero: .diode(current="q'", drop="(0.7 V)")."""
        return self._add("diode", keys)

    def freewheel(self, **keys: Any) -> ModelBuilder:
        """A freewheel: .freewheel(speed="wheel' - shaft'")."""
        return self._add("freewheel", keys)

    def drive(self, **keys: Any) -> ModelBuilder:
        """A drive: .drive(turns="theta", inertia="J"), with .machine or .winding behind it."""
        return self._add("drive", keys)

    def machine(self, **keys: Any) -> ModelBuilder:
        """The motor of the drive that was added last, a name of the program and its data: .machine(model="brushed", voltage="24 V", ...)."""
        return self._of_drive("drive.machine", keys)

    def winding(self, **keys: Any) -> ModelBuilder:
        """A winding of the drive that was added last: .winding(inductance="L", resistance="R", supply="U")."""
        return self._of_drive("drive.winding", keys)

    def _of_drive(self, table: str, keys: dict[str, Any]) -> ModelBuilder:
        if all(known != "drive" for known, _ in self._lists):
            raise ValueError(f"[{table}] is a part of a drive, and there is none yet; .drive(...) is called before")
        return self._add(table, keys)

    def event(self, **keys: Any) -> ModelBuilder:
        """An event: .event(when="x - a", direction="up", set={"x'": "-e*x'"})."""
        return self._add("event", keys)

    def input(self, name: str, **keys: Any) -> ModelBuilder:
        """An input: .input("u", unit="N", value="if(t < (2 s), (1 N), 0)")."""
        return self._set("inputs", {name: keys}, {})

    def output(self, name: str, is_: str) -> ModelBuilder:
        """A scalar that runs show beside the state: .output("height", "(P - O) . N.y")."""
        return self._set("outputs", {name: is_}, {})

    def regulator(self, **keys: Any) -> ModelBuilder:
        """An optimal regulator: .regulator(cost="x^2 + u^2", inputs=["u"])."""
        return self._set("regulator", keys, {})

    def start(self, values: dict[str, Any] | None = None, **more: Any) -> ModelBuilder:
        """The state at time zero: {"theta": "0.3 rad", "theta'": "1 rad/s"}; what is left out is zero."""
        return self._set("start", values, more)

    def run(self, **keys: Any) -> ModelBuilder:
        """The run of the model where a call of `run` says nothing: span, method, tolerance, samples."""
        return self._set("run", keys, {})

    def ensemble(self, **keys: Any) -> ModelBuilder:
        """The number of members of an ensemble, and its seed: .ensemble(members=1000); .vary says what varies."""
        return self._set("ensemble", keys, {})

    def vary(self, name: str, **keys: Any) -> ModelBuilder:
        """What varies in an ensemble: .vary("parameters.m", mean="1 kg", deviation="1 g"), .vary("start.x'", values="0 1 m/s"), from_ and to."""
        table, dot, name = _name(name).partition(".")
        if not dot or table not in ("parameters", "start"):
            raise ValueError('the name of what varies begins with "parameters." or "start."')
        return self._set(f"ensemble.vary.{table}", {name: {_plain(key): value for key, value in keys.items()}}, {})

    def failure(self, **keys: Any) -> ModelBuilder:
        """An entry of the catalogue of failure: what is varied, and where it fails."""
        return self._set("failure", {_plain(key): value for key, value in keys.items()}, {})

    def table(self, table: str, values: dict[str, Any]) -> ModelBuilder:
        """A table by its name: .table("diode", {...}), .table("drive.machine", {...}) of the last drive."""
        values = mapping(f"values of [{_name(table)}]", values, "{'x': 'm'}")
        if table in _LISTS:
            return self._add(table, values)
        if table.startswith("drive."):
            return self._of_drive(table, values)
        return self._set(table, values, {})

    @property
    def text(self) -> str:
        """The text of the model."""
        lines = [f"title = {_text(self._title)}"] + [f"{name} = {in_toml(value)}" for name, value in self._top.items()]
        for table, values in self._tables.items():
            lines += ["", f"[{table}]"] + [f"{key_in_toml(name)} = {in_toml(value)}" for name, value in values.items()]
        for table, values in self._lists:
            lines += ["", f"[[{table}]]" if table in _LISTS else f"[{table}]"] + [f"{key_in_toml(name)} = {in_toml(value)}" for name, value in values.items()]
        return "\n".join(lines) + "\n"

    def build(self) -> Model:
        """Reads the text: raises ModelError where something is wrong with it, with its line in `text`."""
        from ._model import Model

        return Model.from_text(self.text, f"<{self._title}>")

    def __repr__(self) -> str:
        return self.text
