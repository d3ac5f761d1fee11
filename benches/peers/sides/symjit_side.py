"""symjit: machine code of the right-hand side from SymPy's expressions, run by SciPy."""

from types import SimpleNamespace

from sides import scipy_side

# it takes expressions as trees, what they share written out; so many nodes take it half a minute
MOST = 2_000_000


def runs(scene):
    import sympy
    from symjit import compile_ode

    y = sympy.symbols(f"y:{scene.n}")
    rates = [sympy.sympify(rate) for rate in scene.model.rates(y, cos=sympy.cos, sin=sympy.sin, sqrt=sympy.sqrt)]
    if nodes(rates) > MOST:
        raise ValueError(f"as trees the expressions have {nodes(rates):.1e} nodes, more than {MOST:.0e}")
    compiled = SimpleNamespace(rates=compile_ode(sympy.Symbol("t"), y, rates))
    return scipy_side.runs(scene, compiled, ["DOP853"], "symjit, {}")


def nodes(expressions):
    """Of all trees together, what is shared counted as often as it stands in them."""
    known = {}

    def count(one):
        if one not in known:
            known[one] = 1 + sum(map(count, one.args))
        return known[one]

    return sum(map(count, expressions))
