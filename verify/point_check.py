"""Exact points: whether relations hold there."""

from .evaluation import Evaluation, NotExpressible, Undefined, reached
from .half_turn import OfHalfTurn
from .numbers import ExactPoint, Number
from .part_check import Rejected

NUMBERS = ("const", "root", "+", "-", "*", "/", "neg", "pow")


def exact_point(check):
    """The domain of a part's point, and the letters inside those of its angles whose coordinates it gives."""
    entries = check.part.proof["point"]
    half_turns = {here: Number.of(OfHalfTurn.itself()) for here, operation in enumerate(check.program) if operation == ("letter", "pi")}
    numbers = Evaluation(check.program, (), ExactPoint(dict(half_turns), {}, {}), check.angles)
    letters, functions, halves = dict(half_turns), {}, {}
    formal = set()
    for leaf, value in entries:
        kind = check.program[leaf][0]
        if leaf in half_turns:
            raise Rejected("the point gives pi a value")
        if any(check.program[each][0] not in NUMBERS and each not in half_turns for each in reached(check.program, [value])):
            raise Rejected("a value of the point is no number")
        if kind == "letter":
            letters[leaf] = numbers.value(value)
        elif kind in ("cos", "sin"):
            argument = check.program[leaf][1]
            key, number = single_step(check, argument), numbers.value(value)
            if key is None:
                continue
            name, times = key
            halves.setdefault(name, {})[kind] = -number if kind == "sin" and times < 0 else number
            formal |= {each for each in reached(check.program, [argument]) if check.program[each][0] == "letter"}
        elif kind != "function":
            raise Rejected(f"a point gives no value to {kind}")
    point = ExactPoint(letters, {name: circle(half) for name, half in halves.items()}, functions)
    for leaf, value in entries:
        if check.program[leaf][0] == "function":
            name, argument = check.program[leaf][1:]
            inside = Evaluation(check.program, check.solves, point, check.angles).value(argument)
            key = (name, frozenset((d, str(c)) for d, c in inside.parts.items()))
            if not (functions.setdefault(key, numbers.value(value)) + -numbers.value(value)).is_zero():
                raise Rejected("a function has two values at equal arguments")
    formal |= left_open(check, point)
    return point, formal & set(letters)


def left_open(check, point):
    """The letters of angles whose coordinates the point does not give; an angle that is zero there has its own."""
    open_letters = set()
    for here in reached(check.program, check.goals):
        if check.program[here][0] not in ("cos", "sin"):
            continue
        argument = check.program[here][1]
        steps = check.angles.steps_of(argument, 0)
        if any(is_number(check, key) for key, _ in steps):
            raise NotExpressible("the cosine of a number at a point")
        if len(steps) != 1 or steps[0][0] in point.circles:
            continue
        inside = {each for each in reached(check.program, [argument]) if check.program[each][0] == "letter"}
        if inside <= set(point.letters) and is_zero_at(check, point, argument):
            point.circles[steps[0][0]] = (Number.of(1), Number.of(0))
        else:
            open_letters |= inside
    return open_letters


def is_number(check, key):
    """Whether the term of an angle is a number, or a root of one: its coordinates are what they are, and no point chooses them."""
    term = key.rsplit(" / ", 1)[0]
    return not any(name in term for name in check.angles.ring.generators if name[0] != "r")


def is_zero_at(check, point, argument):
    try:
        return Evaluation(check.program, check.solves, point, check.angles).value(argument).is_zero()
    except (NotExpressible, Undefined):
        return False


def single_step(check, argument):
    """The one step that an angle is, and its sign; none of an angle that the steps of the part make a number."""
    steps = check.angles.steps_of(argument, 0)
    if not steps:
        return None
    if len(steps) == 1 and abs(steps[0][1]) == 1:
        return steps[0]
    raise NotExpressible("the coordinates of a multiple of an angle are given, and not those of the angle")


def circle(half):
    """Cosine and sine, on the circle."""
    one = Number.of(1)
    if set(half) == {"cos", "sin"}:
        cos, sin = half["cos"], half["sin"]
        if not (cos * cos + sin * sin + -one).is_zero():
            raise Rejected("a cosine and a sine of the point are not on the circle")
        return cos, sin
    ((name, value),) = half.items()
    other = (one + -(value * value)).root()
    return (value, other) if name == "cos" else (other, value)


def holds(check, relation, values):
    """Whether a relation holds at the point."""
    value = values.value(check.difference(relation))
    if relation.kind in ("=", "rate"):
        return value.is_zero()
    if relation.kind == "!=":
        return not value.is_zero()
    return value.sign() == 1 or relation.kind == ">=" and value.is_zero()


def all_given_hold(check, values):
    """Everything that is presupposed holds at the point."""
    for relation in check.part.given:
        if not holds(check, relation, values):
            raise Rejected("something that is presupposed does not hold at the point")


def independent_angles(check, formal):
    """Coordinates of angles may be chosen beside the angles where no equality that is presupposed ties these to anything."""
    if not formal:
        return
    tied = [each for each in check.part.given if each.kind == "="]
    for relation in tied:
        entry = check.difference(relation)
        inside = {e for e in reached(check.program, [entry]) if check.program[e][0] == "letter"}
        if inside & formal and not check.vanishes(entry):
            raise Rejected("the point has cosines and sines that are not those of its angles")


def counterexample(check):
    """Everything that is presupposed holds, and a conclusion does not."""
    point, formal = exact_point(check)
    values = Evaluation(check.program, check.solves, point, check.angles)
    all_given_hold(check, values)
    independent_angles(check, formal)
    if all(holds(check, relation, values) for relation in check.part.then):
        raise Rejected("every conclusion holds at the point")


def example(check):
    """Everything holds."""
    point, formal = exact_point(check)
    values = Evaluation(check.program, check.solves, point, check.angles)
    all_given_hold(check, values)
    if formal:
        raise Rejected("an example has cosines and sines that are not those of its angles")
    if not all(holds(check, relation, values) for relation in check.part.then):
        raise Rejected("a conclusion does not hold at the point")

