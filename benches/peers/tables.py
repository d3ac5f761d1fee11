"""The results as Markdown."""

from turns import at_error

ERRORS = [1e-6, 1e-9, 1e-12]
# of the tables of all tools
COLUMNS = [1e-4, 1e-6, 1e-8, 1e-10, 1e-12]
FINE = [1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15]
# what has more digits than double precision
FINER = ("double-double", "long double")
REDUCED = ", reduced"


def page(results):
    machine = results["machine"]
    scenes = {key: result for key, result in results.items() if key not in ("machine", "summary")}
    tables = {key: result for key, result in scenes.items() if result["nanoseconds"]}
    reduced = {key: result for key, result in scenes.items() if key.endswith(REDUCED)}
    full = {key: result for key, result in scenes.items() if key not in reduced}
    parts = ["# Beside other tools", f"{machine['processor']}, Python {machine['python']}. How it was measured: run.py."]
    parts += [table(key, result) for key, result in tables.items()]
    parts += ["## Beside heyoka, every scene", HEYOKA, beside(full, full)]
    if reduced:
        parts += ["## The reduced model, both sides", REDUCED_MODEL, beside(reduced, reduced)]
        parts += ["## Our reduced model beside heyoka's full one", beside(reduced, {key: full.get(key.removesuffix(REDUCED)) for key in reduced})]
    parts += ["\n".join(f"{name}: {reason}." for name, reason in machine["missing"].items())]
    return "\n\n".join(part for part in parts if part) + "\n"


HEYOKA = """Microseconds to reach the error: ours (the best of our methods) and heyoka (the best of its settings), in brackets
how many times as long heyoka takes. `-`: the tool does not get there. `*`: in double precision rounding stops it before,
and it is ours in double-double, heyoka in long double. The last column has the least error that either reaches in double
precision at any tolerance."""

REDUCED_MODEL = """Two windings in the place of all damper bars. Errors are those of the model's own states."""


def share(result, name, nanoseconds):
    """Operations, and what part they are of as many as one core can in that time."""
    count = result.get("operations", {}).get(name)
    return [f"{count:.0f}", f"{count / nanoseconds / result['peak']:.1%}"] if count else ["", ""]


def summary(results):
    """The tables that the report shows."""
    scenes = {key: result for key, result in results.items() if key not in ("machine", "summary")}
    times = [[key, str(result["states"]), *(pair(best(rows(result, True), error), best(rows(result, False), error)) for error in ERRORS)]
             for key, result in scenes.items()]
    evaluations = [[key, name, f"{value:.0f}", f"{value / result['nanoseconds']['our rates']:.1f}", *share(result, name, value)]
                   for key, result in scenes.items() for name, value in result["nanoseconds"].items()]
    return [
        {"caption": "Beside heyoka: microseconds to reach an error, ours and theirs; in brackets how many times as long theirs takes",
         "head": ["scene", "states", *(f"{error:.0e}" for error in ERRORS)], "rows": times},
        {"caption": "One evaluation, and what part of the operations that one core can do at most",
         "head": ["scene", "evaluation", "ns", "in our rates", "sums and products", "of the most"], "rows": evaluations},
    ]


def rows(result, ours):
    return {name: own for name, own in result["points"].items() if name.startswith("dalembert" if ours else "heyoka")}


def best(named, error, finer=False):
    """The least time in double precision, or in what has more digits."""
    kind = [points for name, points in named.items() if name.endswith(FINER) == finer]
    return min((took for took in (at_error(points, error) for points in kind) if took), default=None)


def beside(own, other):
    """A row a scene: our best beside heyoka's."""
    lines = ["| scene | states | " + " | ".join(f"{error:.0e}" for error in FINE) + " | least error |", "|---|---|" + "---|" * (len(FINE) + 1)]
    for key, result in own.items():
        if not other[key] or not rows(other[key], False):
            continue
        ours, theirs = rows(result, True), rows(other[key], False)
        cells = [pair(*(best(side, error) for side in (ours, theirs)), *(best(side, error, True) for side in (ours, theirs))) for error in FINE]
        plain = [[points for name, points in side.items() if not name.endswith(FINER)] for side in (ours, theirs)]
        least = [min((error for points in side for _, error, _ in points), default=1.0) for side in plain]
        lines.append(f"| {key} | {result['states']} | " + " | ".join(cells) + f" | {least[0]:.0e}, {least[1]:.0e} |")
    return "\n".join(lines)


def pair(ours, theirs, our_finer=None, their_finer=None):
    """Times of both, with more digits where double precision does not get there."""
    number = lambda took: f"{took * 1e3:.3g}" if took < 1 else f"{took * 1e3:.0f}"
    shown = lambda plain, finer: number(plain) if plain else f"{number(finer)}*" if finer else "-"
    took = [ours or our_finer, theirs or their_finer]
    ratio = f" ({took[1] / took[0]:.2f})" if all(took) else ""
    return f"{shown(ours, our_finer)}, {shown(theirs, their_finer)}{ratio}"


def table(key, result):
    """One scene, all tools."""
    plain = {name: points for name, points in result["points"].items() if not name.endswith(FINER)}
    milliseconds = {name: [at_error(points, error) for error in COLUMNS] for name, points in plain.items()}
    own = [row for name, row in milliseconds.items() if name.startswith("dalembert")]
    least = [min((row[k] for row in own if row[k]), default=None) for k in range(len(COLUMNS))]
    cell = lambda value, ours: "-" if value is None else f"{value:.3f} ({value / ours:.2f})" if ours else f"{value:.3f}"
    lines = [f"## {key}, {result['states']} states", "", "Milliseconds to reach the error, and in brackets the ratio to our best.", "",
             "| tool | " + " | ".join(f"{error:.0e}" for error in COLUMNS) + " |", "|---|" + "---|" * len(COLUMNS)]
    for name, row in milliseconds.items():
        shown = ["does not agree with the reference"] * len(COLUMNS) if name in result["disagree"] else map(cell, row, least)
        lines.append(f"| {name} | " + " | ".join(shown) + " |")
    rates = result["nanoseconds"]["our rates"]
    lines += ["", "| evaluation | ns | in our rates | sums and products | of the processor's most |", "|---|---|---|---|---|"]
    lines += [f"| {name} | {value:.0f} | {value / rates:.1f} | {' | '.join(share(result, name, value))} |" for name, value in result["nanoseconds"].items()]
    lines += ["", "Set up once: " + ", ".join(f"{name} {took:.3g} s" for name, took in result["setup"].items()) + "."]
    return "\n".join(lines)
