"""A chain of links as a file of ours."""

MASS, LENGTH, ACROSS, ALONG, GRAVITY = 1.0, 0.2, 0.01, 0.002, 9.81


def axis(kind, link):
    return "z" if kind == "plane" or link % 2 == 0 else "x"


def text(kind, links):
    """Each link is a rigid body of 1 kg, hinged to the one before it: about z alone in a plane, about z and x in turn in space."""
    one = f"inertia = {{ principal = [\"{ACROSS} kg m^2\", \"{ALONG} kg m^2\", \"{ACROSS} kg m^2\"] }}" if kind == "space" else f'inertia = "{ACROSS} kg m^2"'
    names = range(1, links + 1)
    frame = lambda k: f"F{k}" if k else "N"
    point = lambda k: f"P{k}" if k else "O"
    lines = [f'title = "A chain of {links} links"', 'gravity = "-(9.81 m/s^2)*N.y"', "[coordinates]"]
    lines += [f'q{k} = "rad"' for k in names]
    lines += ["[frames]"] + [f'F{k} = "{frame(k - 1)} turned q{k} about {axis(kind, k - 1)}"' for k in names]
    lines += ["[points]"] + [f'P{k} = "{point(k - 1)} - (0.2 m)*F{k}.y"' for k in names]
    lines += ["[bodies]"]
    lines += [f'b{k} = {{ frame = "F{k}", centre = "{point(k - 1)} - (0.1 m)*F{k}.y", mass = "1 kg", {one} }}' for k in names]
    return "\n".join([*lines, "[run]", 'span = "1 s"', ""])
