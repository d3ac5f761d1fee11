"""Derives, proves and runs the equations of motion of mechanical and electromechanical systems.

    >>> import dalembert
    >>> model = dalembert.Model.from_text('''
    ... [parameters]
    ... m = "1 kg"
    ... k = "4 N/m"
    ... [coordinates]
    ... x = "m"
    ... [bodies.block]
    ... centre = "O + x*N.x"
    ... mass = "m"
    ... [[force]]
    ... on = "block"
    ... is = "-k*x*N.x"
    ... [start]
    ... x = "0.1 m"
    ... ''')
    >>> run = model.run(span=10)
    >>> run["x"], run.time                       # NumPy arrays
    >>> model.derive("lagrange")                 # typeset in a notebook
    >>> model.prove()                            # do all principles agree?
    >>> solve_ivp(model.rhs(), (0, 10), model.start, jac=model.jacobian(), method="Radau")

The language of the texts stands in the book of the project, in the chapter "Your own system, as text". All numbers are in SI units unless a text says
otherwise. What is wrong with a model raises ModelError with file, line, column and what is accepted there.
"""

import copyreg as _copyreg
from inspect import Parameter, Signature

from ._model import Model
from ._builder import ModelBuilder
from ._check import Check, CheckedEquation, check
from ._columns import TimedColumns
from ._equations import Equations
from ._forces import Forces
from ._ledger import Claim, Correction, Ledger, Unread, judge
from ._linear import LinearEquations
from ._native import METHODS, PRINCIPLES, VERSION, JacobianMatrix, ModelError, RightHandSide
from ._proofs import Judgement, Judgements
from ._reference import Reference, ReferenceEvent
from ._regimes import Margin, Regime, Regimes
from ._regulator import ClosedLoop, Regulator
from ._results import Chart, Ensemble, ModelChoice, SteadyMotion, SteadyMotions
from ._sympy import from_sympy
from ._trajectory import Trajectory

__version__ = VERSION



def _not_pickled(function):
    raise TypeError(f"{function!r} is machine code of this process and is not pickled; its model is, and its rhs() and jacobian() make the functions again")


# what is compiled shows no signature by itself
for _callable in (RightHandSide, JacobianMatrix):
    _copyreg.pickle(_callable, _not_pickled)
    _callable.__signature__ = Signature([Parameter(name, Parameter.POSITIONAL_OR_KEYWORD) for name in ("t", "y")])

__all__ = [
    "METHODS",
    "PRINCIPLES",
    "Chart",
    "Check",
    "CheckedEquation",
    "Claim",
    "ClosedLoop",
    "Correction",
    "Ensemble",
    "Equations",
    "Forces",
    "JacobianMatrix",
    "Judgement",
    "Judgements",
    "Ledger",
    "LinearEquations",
    "Margin",
    "Model",
    "ModelBuilder",
    "ModelChoice",
    "ModelError",
    "Reference",
    "ReferenceEvent",
    "Regime",
    "Regimes",
    "Regulator",
    "RightHandSide",
    "SteadyMotion",
    "SteadyMotions",
    "TimedColumns",
    "Trajectory",
    "Unread",
    "check",
    "from_sympy",
    "judge",
]
