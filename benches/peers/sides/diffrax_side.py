"""diffrax: JAX traces the exported Python and compiles the whole run."""

import numpy as np
from turns import clocked, repeated


def runs(scene):
    import jax

    jax.config.update("jax_enable_x64", True)
    import diffrax
    import jax.numpy as jnp

    def law(t, y, _):
        return jnp.stack(scene.model.rates(y, cos=jnp.cos, sin=jnp.sin, sqrt=jnp.sqrt))

    def by(solver):
        @jax.jit
        def solve(tolerance, y):
            control = diffrax.PIDController(rtol=tolerance, atol=tolerance)
            out = diffrax.diffeqsolve(
                diffrax.ODETerm(law), solver, 0.0, scene.end, None, y, stepsize_controller=control, max_steps=10**6, throw=False
            )
            return out.ys[-1], out.result == diffrax.RESULTS.successful

        first = jnp.array(scene.start)
        solve(1e-4, first)[0].block_until_ready()

        def finished(tolerance):
            state, reached = solve(tolerance, first)
            return state.block_until_ready(), reached

        def once(tolerance):
            took, (state, reached) = clocked(lambda: finished(tolerance))
            return took, np.asarray(state) if reached else []

        return lambda tolerance: repeated(lambda: once(tolerance))

    return {"diffrax Kvaerno5": by(diffrax.Kvaerno5())} if scene.stiff else {"diffrax Dopri8": by(diffrax.Dopri8())}
