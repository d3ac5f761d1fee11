"""Rates of entries by the rates of letters: new entries at the end of a program."""

from .evaluation import NotExpressible, reached


def rate(program, entry, rates):
    """The entry that is the rate of an entry, where letters have these rates and the others rest."""
    known = dict(rates)
    zero, one = emit(program, "const", "0"), emit(program, "const", "1")
    for here in reached(program, [entry]):
        if here not in known:
            known[here] = single(program, here, known, zero, one)
    return known[entry]


def emit(program, *operation):
    program.append(operation)
    return len(program) - 1


def single(program, here, known, zero, one):
    """The rate of an entry by those of its operands."""
    name, *rest = program[here]
    if name in ("const", "letter"):
        return zero

    def add(a, b, sign="+"):
        return a if b == zero else emit(program, sign, a, b)

    def times(a, b):
        return zero if zero in (a, b) else a if b == one else b if a == one else emit(program, "*", a, b)

    if name == "function":
        return times(emit(program, "function", rest[0] + "'", rest[1]), known[rest[1]]) if known[rest[1]] != zero else zero
    slope = known[rest[0]]
    if name in ("+", "-"):
        return add(slope, known[rest[1]], name)
    if name == "*":
        return add(times(slope, rest[1]), times(rest[0], known[rest[1]]))
    if name == "/":
        above = add(slope, times(here, known[rest[1]]), "-")
        return zero if above == zero else emit(program, "/", above, rest[1])
    if slope == zero and name != "atan2":
        return zero
    if name == "neg":
        return emit(program, "neg", slope)
    if name == "pow":
        power = rest[0] if rest[1] == 2 else emit(program, "pow", rest[0], rest[1] - 1)
        return times(times(emit(program, "const", str(rest[1])), power), slope)
    if name == "cos":
        return emit(program, "neg", times(emit(program, "sin", rest[0]), slope))
    if name == "sin":
        return times(emit(program, "cos", rest[0]), slope)
    if name == "root":
        return emit(program, "/", slope, emit(program, "+", here, here))
    if name == "exp":
        return times(here, slope)
    if name == "ln":
        return emit(program, "/", slope, rest[0])
    if name == "tanh":
        return times(emit(program, "-", one, emit(program, "*", here, here)), slope)
    if name == "atan2":
        y, x = rest
        square = emit(program, "+", emit(program, "*", x, x), emit(program, "*", y, y))
        return emit(program, "/", emit(program, "-", times(x, known[y]), times(y, known[x])), square)
    raise NotExpressible(f"the rate of {name}")
