"""Ctrl-C in calls that derive: it ends them at once, wherever the algebra is."""

import os
import signal
import threading
import time

import dalembert
import numpy as np
import pytest


def chain(links):
    """Links with masses beside their axes; deriving and proving takes longer than Ctrl-C."""
    text = 'gravity = "-(9.81 m/s^2)*N.y"\n[coordinates]\n' + "".join(f'a{k} = "rad"\n' for k in range(links))
    text += "[frames]\n" + "".join(f'A{k} = "N turned a{k} about z"\n' for k in range(links)) + "[points]\n"
    before = ["O"] + [f"P{k}" for k in range(links - 1)]
    text += "".join(f'P{k} = "{point} - (1 m)*A{k}.y + (0.1 m)*A{k}.x"\n' for k, point in enumerate(before))
    text += "".join(f'[bodies.b{k}]\ncentre = "P{k}"\nmass = "1 kg"\n' for k in range(links))
    return dalembert.Model.from_text(text + '[start]\na0 = "1 rad"\n')


@pytest.mark.parametrize("name", ["prove", "derive", "linearise", "rhs", "jacobian"])
def test_a_call_ends_at_ctrl_c(name):
    signal.signal(signal.SIGINT, signal.default_int_handler)
    call = getattr(chain(10), name)
    threading.Timer(0.1, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
    begin = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        call()
        time.sleep(2)
    assert time.monotonic() - begin < 2
    # the model is as it was
    assert chain(2).rhs()(0.0, np.zeros(4)).shape == (4,)


def test_a_warning_of_a_call_has_the_place_of_the_call():
    text = '[parameters]\nm = "1 kg"\nc = "1 N"\n[coordinates]\nx = "m"\n[energies]\nkinetic = "m*x\'^2/2"\n'
    with pytest.warns(UserWarning, match="`c` is not used") as told:
        dalembert.Model.from_text(text).derive()
    assert {one.filename for one in told} == {__file__}


def test_a_complex_state_is_refused():
    rhs = chain(1).rhs()
    for state in (np.zeros(2, dtype=complex), [0.0, 1j]):
        with pytest.raises(TypeError, match="a state is real"):
            rhs(0.0, state)


def test_a_name_that_is_no_text_of_unicode_is_refused():
    with pytest.raises(ValueError, match="a name in Unicode is accepted"):
        dalembert.Model.from_file("\ud800")
