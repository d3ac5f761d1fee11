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

from inspect import Parameter, Signature

from ._model import Model
from ._builder import ModelBuilder
from ._check import Check, CheckedEquation, check
from ._columns import TimedColumns
from ._forces import Forces
from ._ledger import Claim, Correction, Ledger, Unread, judge
from ._native import METHODS, PRINCIPLES, VERSION, Equations, Judgement, LinearEquations, ModelError, JacobianMatrix, RightHandSide
from ._proofs import Judgements
from ._reference import Reference, ReferenceEvent
from ._regimes import Margin, Regime, Regimes
from ._regulator import Regulator
from ._results import Chart, Ensemble, ModelChoice, SteadyMotion, SteadyMotions
from ._sympy import from_sympy
from ._trajectory import Trajectory

__version__ = VERSION

# what is compiled shows no signature by itself
for _callable in (RightHandSide, JacobianMatrix):
    _callable.__signature__ = Signature([Parameter(name, Parameter.POSITIONAL_OR_KEYWORD) for name in ("t", "y")])

__all__ = [
    "METHODS",
    "PRINCIPLES",
    "Chart",
    "Check",
    "CheckedEquation",
    "Claim",
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
