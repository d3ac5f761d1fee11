"""SciPy's own integrators, with a compiled right-hand side and its Jacobian."""

from turns import clocked, repeated


def runs(scene, library, methods, called="SciPy {}"):
    from scipy.integrate import solve_ivp

    def by(method):
        options = {"jac": library.jacobian} if method in ("Radau", "BDF") else {}

        def once(tolerance):
            took, out = clocked(
                lambda: solve_ivp(
                    library.rates, (0.0, scene.end), scene.start, method=method, rtol=max(tolerance, 3e-14), atol=tolerance, **options
                )
            )
            return took, out.y[:, -1] if out.success else []

        return lambda tolerance: repeated(lambda: once(tolerance))

    return {called.format(method): by(method) for method in methods}
