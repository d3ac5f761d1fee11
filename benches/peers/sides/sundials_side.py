"""SUNDIALS' CVODE by scikit-sundae, with the compiled C as the right-hand side and its Jacobian."""

import numpy as np
from turns import clocked, repeated


def runs(scene, library):
    from sksundae.cvode import CVODE

    def rates(t, y, dy):
        library.code.rates(y.ctypes.data, dy.ctypes.data)

    def jacobian(t, y, dy, matrix):
        library.code.jacobian(y.ctypes.data, library.room.ctypes.data)
        matrix[:] = library.room

    def by(method):
        options = {"jacfn": jacobian} if method == "BDF" else {}

        def once(tolerance):
            solver = CVODE(rates, method=method, rtol=tolerance, atol=tolerance, max_num_steps=10**6, **options)
            took, out = clocked(lambda: solver.solve(np.array([0.0, scene.end]), np.array(scene.start)))
            return took, out.y[-1] if out.success else []

        return lambda tolerance: repeated(lambda: once(tolerance))

    return {f"CVODE {method}": by(method) for method in (["BDF"] if scene.stiff else ["Adams", "BDF"])}
