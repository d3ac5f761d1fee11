"""Pictures of a run, by matplotlib."""

from __future__ import annotations

from ._arguments import shown


def _matplotlib():
    try:
        from matplotlib import pyplot
    except ImportError as missing:
        raise ImportError("pictures need matplotlib: pip install matplotlib") from missing
    return pyplot


def _label(unit: str) -> str:
    return "" if unit == "1" else f" [{unit}]"


def plot(run, names, figure=None):
    """Columns over time, one picture for each unit."""
    pyplot = _matplotlib()
    for name in names:
        run[name]
    units: dict[str, list[str]] = {}
    for name in names:
        units.setdefault(run.unit(name), []).append(name)
    if figure is not None and not hasattr(figure, "subplots"):
        raise TypeError(f"`figure` is {shown(figure)}; a figure of matplotlib is accepted")
    if figure is None:
        figure = pyplot.figure(figsize=(7, 2.2 * len(units) + 0.6), layout="constrained")
    # a figure with as many pictures takes another run over the first
    axes = figure.axes
    if len(axes) != len(units):
        axes = figure.subplots(len(units), 1, sharex=True, squeeze=False)[:, 0]
    for own, (unit, columns) in zip(axes, units.items()):
        for name in columns:
            own.plot(run.time, run[name], label=name, linewidth=1.2)
        own.set_ylabel(", ".join(columns) + _label(unit) if len(columns) == 1 else _label(unit).strip() or "1")
        if len(columns) > 1:
            own.legend(loc="upper right", fontsize="small")
        for time in run._marks():
            own.axvline(time, color="0.8", linewidth=0.6, zorder=0)
        own.grid(alpha=0.3)
    axes[0].set_title(run.title)
    axes[-1].set_xlabel("t [s]")
    return figure


def phase(run, abscissa, ordinate, axes=None):
    """One column over another."""
    x, y = run[abscissa], run[ordinate]
    if axes is not None and not hasattr(axes, "plot"):
        raise TypeError(f"`axes` is {shown(axes)}; axes of matplotlib are accepted")
    axes = axes if axes is not None else _matplotlib().subplots(layout="constrained")[1]
    axes.plot(x, y, linewidth=1.2)
    axes.plot(x[:1], y[:1], "o", markersize=4)
    axes.set_xlabel(abscissa + _label(run.unit(abscissa)))
    axes.set_ylabel(ordinate + _label(run.unit(ordinate)))
    axes.set_title(run.title)
    axes.grid(alpha=0.3)
    return axes
