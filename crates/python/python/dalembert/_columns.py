"""Columns of numbers, each with a name and a unit."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

import numpy

from ._arguments import names as names_of
from ._arguments import shown

__all__ = ["Columns", "TimedColumns", "needed_pandas", "of_unit"]


def needed_pandas() -> Any:
    """pandas, or the way to it."""
    try:
        import pandas
    except ImportError:
        raise ImportError("a DataFrame needs pandas: pip install pandas") from None
    return pandas


def of_unit(unit: str) -> str:
    """A unit behind a number; nothing for a pure number."""
    return "" if unit == "1" else unit


class Columns:
    """Columns of numbers: columns["x"] is one, columns[["x", "y"]] has some side by side, `array` all of them, as in `names`.

    `units` has the unit of each name; dict(columns) has the columns by their names. Each column has a name of its own: where the model has a
    coordinate or an output with the name of a number of the run, such as `steps` or `kinetic_energy`, that of the run is `run.steps`.
    """

    __slots__ = ("array", "names", "title", "units", "_places")

    def __init__(self, array: numpy.ndarray, columns: Iterable[tuple[str, str]], title: str) -> None:
        known = _distinct(list(columns))
        self.array = array
        self.names: list[str] = [name for name, _ in known]
        self.units: dict[str, str] = dict(known)
        self.title = title
        self._places = {name: place for place, name in enumerate(self.names)}

    def __getitem__(self, name: str | list[str]) -> numpy.ndarray:
        if isinstance(name, list):
            return numpy.column_stack([self[one] for one in name]) if name else self.array[:, :0]
        if not isinstance(name, str) or name not in self._places:
            raise KeyError(f"no column is called {shown(name)}; there are {', '.join(self.names)}")
        return self.array[:, self._places[name]]

    def __contains__(self, name: object) -> bool:
        return isinstance(name, str) and name in self._places

    def __iter__(self) -> Iterator[str]:
        return iter(self.names)

    def keys(self) -> list[str]:
        """Names of the columns."""
        return self.names

    def items(self) -> list[tuple[str, numpy.ndarray]]:
        """Names and columns."""
        return [(name, self[name]) for name in self.names]

    def __len__(self) -> int:
        return len(self.names)


# numbers of a run that stand before the columns of the model; all others stand behind them
_BEFORE = ("time", "steps")
_ENERGIES = ("kinetic_energy", "potential_energy", "work")


def _distinct(columns: list[tuple[str, str]]) -> list[tuple[str, str]]:
    """Columns with names of their own, of which the model's stay."""
    distinct = list(columns)
    names = [name for name, _ in columns]
    for name in {name for name in names if names.count(name) > 1}:
        places = [place for place, one in enumerate(names) if one == name]
        place = places[0 if name in _BEFORE else -1]
        # by its name an energy would have the unit of the model's column
        distinct[place] = f"run.{name}", "J" if name in _ENERGIES else columns[place][1]
    return distinct


class TimedColumns(Columns):
    """Columns with a row for each of the times `time`, which columns["time"] has too."""

    __slots__ = ("time",)

    def __init__(self, time: numpy.ndarray, array: numpy.ndarray, columns: Iterable[tuple[str, str]], title: str) -> None:
        super().__init__(array, columns, title)
        time.setflags(write=False)
        array.setflags(write=False)
        self.time = time

    def __getitem__(self, name: str | list[str]) -> numpy.ndarray:
        return self.time if isinstance(name, str) and name == "time" and name not in self._places else super().__getitem__(name)

    def __contains__(self, name: object) -> bool:
        return name == "time" or super().__contains__(name)

    def unit(self, name: str) -> str:
        """The unit of a column, of `time` too."""
        return self.units.get(name, "s")

    @property
    def last(self) -> dict[str, float]:
        """The last row by its names."""
        return dict(zip(self.names, map(float, self.array[-1])))

    def to_dataframe(self) -> Any:
        """A pandas DataFrame, indexed by time; pandas must be installed."""
        pandas = needed_pandas()
        return pandas.DataFrame(self.array, index=pandas.Index(self.time, name="time"), columns=self.names)

    def plot(self, *names: str | Iterable[str], figure: Any = None) -> Any:
        """Draws columns over time, one picture for each unit; without names all of them. Gives the figure of matplotlib."""
        from ._plot import plot

        flat = [one for listed in names for one in names_of("names", listed, "names of columns")]
        return plot(self, flat or self._usual(), figure)

    def phase(self, abscissa: str, ordinate: str, axes: Any = None) -> Any:
        """Draws one column over another: run.phase("theta", "theta'"). Gives the axes of matplotlib."""
        from ._plot import phase

        return phase(self, abscissa, ordinate, axes)

    def _usual(self) -> list[str]:
        """The columns of a picture where none are named."""
        return self.names

    def _marks(self) -> list[float]:
        """Times that a picture marks."""
        return []
