"""Systems that several tests use."""

OSCILLATOR = """
title = "A block on a spring"
[parameters]
m = "1 kg"
k = "4 N/m"
[coordinates]
x = "m"
[bodies.block]
centre = "O + x*N.x"
mass = "m"
[[force]]
on = "block"
is = "-k*x*N.x"
[start]
x = "0.1 m"
"""
