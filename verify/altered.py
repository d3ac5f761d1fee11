"""Claims that are made false, or whose refutation is made void: a checker that accepts one of them checks nothing."""

import copy

SHOWN_FALSE = {"counterexample", "excluded", "no_root"}


def altered(entries):
    """Each claim that has a certificate, with its first conclusion changed."""
    for entry in entries:
        if entry.get("parts"):
            changed = copy.deepcopy(entry)
            if change(changed["program"], changed["parts"][0]):
                yield changed | {"id": f"{changed['id']} (altered)"}


def change(program, part):
    """Whether a part could be changed into one that must be rejected."""
    proof = part["proof"]["by"]
    if proof == "undefined":
        return False
    if proof in ("stability", "minimum"):
        # the other sign
        of = part["proof"]
        of["printed"] = put(program, "neg", of["printed"])
        return True
    if proof in SHOWN_FALSE:
        # what holds is refuted
        part["then"] = [held(program)]
        return True
    first = part["then"][0]
    if first["is"] == "=":
        # a sign or a term is wrong: the sides differ by one more than before
        first["left"] = put(program, "+", first["left"], put(program, "const", "1"))
    elif first["is"] == "rate":
        first["right"] = put(program, "+", first["right"], put(program, "const", "1"))
    elif first["is"] in (">", ">="):
        first["left"], first["right"] = first["right"], put(program, "+", first["left"], put(program, "const", "1"))
    else:
        first["left"] = first["right"]
    return True


def held(program):
    """A relation that holds."""
    zero = put(program, "const", "0")
    return {"is": "=", "left": zero, "right": zero}


def put(program, *operation):
    program.append(list(operation))
    return len(program) - 1
