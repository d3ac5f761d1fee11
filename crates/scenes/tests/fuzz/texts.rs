//! Texts of systems that are changed at random.

/// A ball on a rough slope in space, beside a rough wall.
pub const BALL: &str = r#"
title = "A ball"
gravity = "-g*N.z"

[parameters]
m = "0.17 kg"
r = "30 mm"
g = "9.81 m/s^2"
mu = "0.2"
a = "0.1 rad"

[coordinates]
x = "m"
y = "m"
z = "m"

[frames]
B = "N free"
S = "N turned a about y"

[points]
G = "O + x*S.x + y*S.y + z*S.z"
P = "G - r*S.z"

[bodies.ball]
frame = "B"
centre = "G"
mass = "m"
inertia = { principal = ["2/5*m*r^2", "2/5*m*r^2", "2/5*m*r^2"] }

[[contact]]
name = "cloth"
of = "ball at P"
through = "O"
normal = "S.z"
friction = "mu"
restitution = "0.5"

[[contact]]
name = "wall"
of = "ball at G + r*S.x"
through = "O + (0.2 m)*S.x"
normal = "-S.x"
friction = "mu"

[outputs]
slip = "norm(sliding(cloth))"
T = "friction(cloth) . N.x"

[start]
z = "30 mm"
"x'" = "1 m/s"
"y'" = "0.5 m/s"
"B.wx" = "-30 rad/s"

[run]
span = "0.3 s"
"#;

/// A system with windings, diodes, a freewheel, a contact and a regulator.
pub const MACHINE: &str = r#"
title = "A machine"
gravity = "-g*N.y"

[parameters]
m = "2 kg"
J = "1e-3 kg m^2"
L = "10 mH"
M = "4 mH"
R = "2 ohm"
k = "0.05 V s"
U = "12 V"
g = "9.81 m/s^2"
mu = "0.3"
e = "0.5"

[coordinates]
theta = "rad"
load = "rad"
x = "m"
y = "m"
q = "C"

[points]
C = "O + x*N.x + y*N.y"

[bodies]
block = { centre = "C", mass = "m" }
wheel = { turns = "load", inertia = "J" }
rotor = { turns = "theta", inertia = "J" }

[energies]
coenergy = "L/2*q'^2 + M*q'*motor.i"
dissipation = "R/2*q'^2"

[inputs]
u = "N"

[[force]]
along = "q"
is = "U*sin((300 rad/s)*t)"

[[force]]
along = "x"
is = "u"

[[drive]]
name = "motor"
turns = "theta"
torque = "-(1e-4 N m s)*motor.speed"

[[drive.winding]]
inductance = "L"
resistance = "R"
supply = "U"
motional = "k"

[[diode]]
name = "D"
current = "q'"
drop = "(0.7 V)"

[[freewheel]]
name = "F"
speed = "load' - theta'"

[[contact]]
name = "floor"
of = "block"
through = "O"
normal = "N.y"
friction = "mu"
restitution = "e"

[regulator]
inputs = ["u"]
cost = "(x/(1 m))^2 + (u/(1 N))^2"
horizon = "0.1 s"

[outputs]
blocked = "reaction(D)"
pressure = "reaction(floor)"

[start]
y = "0.1 m"
"x'" = "0.5 m/s"

[run]
span = "0.2 s"
samples = 5
"#;

/// Motors of the catalogue and with laws as text, a shaft in space, and charges without inductances.
pub const MOTORS: &str = r#"
title = "Motors"

[parameters]
A = "0.4 kg m^2"
J = "1e-3 kg m^2"
U = "10 V"
R = "1 kohm"
C = "1 uF"

[coordinates]
s = "rad"
theta = "rad"
q = "C"
p = "C"
z = "rad"

[frames]
F = "N free"
W = "F turned s about x"

[bodies.satellite]
frame = "F"
inertia = { principal = ["A", "A", "2*A"] }

[bodies.disc]
turns = "theta"
inertia = "J"

[energies]
potential = "q^2/(2*C)"
dissipation = "R/2*(p' - q')^2 + R/2*p'^2"

[[force]]
along = "p"
is = "U*cos((300 rad/s)*t)"

[[constraint]]
name = "integral"
zero = "z' - ((100 rad/s) - theta')"

[[drive]]
name = "wheel"
between = ["satellite", "W"]
inertia = "J"

[drive.machine]
model = "brushed"
voltage = "24 V"
flux = "45 mWb"
inductance = "2 mH"
resistance = "0.6 ohm"
f = "1e-4 N m s"

[[drive]]
name = "motor"
turns = "theta"
ratio = "3"
torque = "(1e-3 N m)*z"

[drive.machine]
model = "text"
field_speed = "50 rad/s"
field_energy = "-b*cos(g)"
torque_law = "-f*phi' - k*g'"

[drive.machine.parameters]
b = "0.1 N m"
f = "1e-3 N m s"
k = "2e-3 N m s"
l = "3 mH"
r = "2 ohm"

[[drive.machine.winding]]
inductance = "l"
resistance = "r"
flux = "(0.05 Wb)*cos(g)"

[outputs]
current = "wheel.i"
torque = "motor.torque"

[start]
"F.wy" = "0.3 rad/s"

[run]
span = "0.05 s"
samples = 5
"#;

/// A system with every construct of the language.
pub const EVERYTHING: &str = r#"
title = "Everything"
gravity = "-g*N.y"

[parameters]
m = "2 kg"
l = "0.5 m"
F = "3 N"
g = "9.81 m/s^2"

[coordinates]
x = "m"
theta = "rad"

[speeds]
v = "velocity(rod) . A.x"
w = "theta' + v/l"

[definitions]
reach = "l*sin(theta) + l*tanh(theta)*exp(-theta^2)"

[frames]
A = "N turned theta about z"

[points]
C = "O + x*N.x"
P = "C - l*A.y"

[bodies.cart]
centre = "C"
mass = "m"

[bodies.rod]
frame = "A"
centre = "P"
mass = "m"
inertia = "m*l^2/12"

[inputs]
u = { unit = "N", value = "if(t < (0.1 s), F, 0) + F*table(t, (0 s), 0, (1 s), 1)" }

[[force]]
on = "cart"
is = "(u - F/10*sign(x'))*N.x"

[[force]]
between = ["ground at O + (2 m)*N.y", "rod"]
is = "-F*min(distance(P, O + (2 m)*N.y)/l, 2)"

[[torque]]
between = ["ground", "rod"]
is = "-(0.1 N m s)*theta'*N.z"

[energies]
potential = "F*l*abs(x/l)"

[[constraint]]
name = "led"
zero = "theta - atan2(x, l)"
programmed = { gains = ["(2 1/s)", "(1 1/s^2)"] }

[[event]]
name = "wall"
when = "x - (0.1 m)"
direction = "up"
set = { "x'" = "-0.5*x'" }

[[event]]
when = "x + l"
end = true

[outputs]
width = "max(reach, ln(1 + (x/l)^2)*l)"
led = "reaction(led)"
slip = "v' - l*w'"
height = "(P - O) . N.y"

[start]
theta = "0.3 rad"
x = "guess 0.01 m"

[run]
span = "0.3 s"
samples = 5
"#;
