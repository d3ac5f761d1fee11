/* One instance of the system: its state, its data, the cases of its conditions, and what follows from them. */

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { STATES = COORDINATES + SPEEDS, DATA = PARAMETERS + INPUTS, INDICATORS = CONDITIONS + EVENTS };

/* where each kind of variable begins among the value references; time is the first of all */
enum {
    STATE_AT = 1,
    DERIVATIVE_AT = STATE_AT + STATES,
    DATA_AT = DERIVATIVE_AT + STATES,
    OUTPUT_AT = DATA_AT + DATA,
    INDICATOR_AT = OUTPUT_AT + OUTPUTS,
    VARIABLES = INDICATOR_AT + INDICATORS
};

typedef enum { INSTANTIATED, INITIALIZING, EVENT, CONTINUOUS, STEPPING, TERMINATED } Mode;

typedef struct {
    fmi3LogMessageCallback log;
    fmi3InstanceEnvironment environment;
    bool steps_itself;
    Mode mode;
    double time, tolerance, step;
    double y[STATES];
    struct parameters p;
    /* 1 where a condition holds, else 0 */
    double s[CONDITIONS + 1];
    /* the sign of each indicator, and the value from which it is counted: an event may leave it a rounding beyond its zero */
    int side[INDICATORS + 1];
    double counted_from[INDICATORS + 1];
    bool has_sides, has_rates, has_outputs;
    double dy[STATES], lambda[CONSTRAINTS + 1], shown[OUTPUTS];
    bool ended;
} Instance;

static fmi3Status tell(const Instance *instance, fmi3Status status, const char *format, ...)
{
    char message[512];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    if (instance->log) instance->log(instance->environment, status, "system", message);
    return status;
}

/* what follows from state and data is computed anew */
static void changed(Instance *instance)
{
    instance->has_rates = instance->has_outputs = false;
}

static const double *speeds(const Instance *instance)
{
    return instance->y + COORDINATES;
}

/* dy/dt; nonzero where it is not determined, or no number */
static int rates_of(Instance *instance, double time, const double *y, double *dy)
{
    if (rates(time, y, &instance->p, instance->s, dy)) return 1;
    for (int i = 0; i < STATES; ++i)
        if (!isfinite(dy[i])) return 1;
    return 0;
}

static fmi3Status with_rates(Instance *instance)
{
    if (instance->has_rates) return fmi3OK;
    if (rates_of(instance, instance->time, instance->y, instance->dy))
        return tell(instance, fmi3Discard, "at t = %.17g s the accelerations are not determined, or are no numbers", instance->time);
    instance->has_rates = true;
    return fmi3OK;
}

static fmi3Status with_outputs(Instance *instance)
{
    if (instance->has_outputs) return fmi3OK;
    double a[SPEEDS];
    if (accelerations(instance->time, instance->y, speeds(instance), &instance->p, instance->s, a, instance->lambda))
        return tell(instance, fmi3Discard, "at t = %.17g s the accelerations are not determined", instance->time);
    outputs(instance->time, instance->y, speeds(instance), &instance->p, instance->s, a, instance->lambda, instance->shown);
    instance->has_outputs = true;
    return fmi3OK;
}

/* data that do not change along a motion */
static const struct parameters unchanged;

/* the changes of accelerations and multipliers along a direction */
static int solved_along(const Instance *instance, const double *a, const double *lambda, double dt, const double *dq, const double *du,
                        const struct parameters *dp, double *change)
{
    enum { N = SPEEDS, M = CONSTRAINTS, J = N * N + N, C = J + M * N };
    double v[C + M], dv[C + M], right[N + M];
    const double *q = instance->y, *u = speeds(instance);
    terms(instance->time, q, u, &instance->p, instance->s, v);
    terms_along(instance->time, q, u, &instance->p, instance->s, dt, dq, du, dp, dv);
    for (int i = 0; i < N; ++i) {
        right[i] = -dv[N * N + i];
        for (int j = 0; j < N; ++j) right[i] -= dv[N * i + j] * a[j];
        for (int k = 0; k < M; ++k) right[i] += dv[J + N * k + i] * lambda[k];
    }
    for (int k = 0; k < M; ++k) {
        right[N + k] = -dv[C + k];
        for (int j = 0; j < N; ++j) right[N + k] -= dv[J + N * k + j] * a[j];
    }
    return solve(v, right, change);
}

/* how constraints are kept: of speeds or of coordinates by their reactions, or led by a law of their own, which leaves them open */
enum { OF_SPEEDS, OF_COORDINATES, LED };

/* the least displacement, or change of speeds, weighed by the inertia, that changes constraints so much */
static int least_change(const Instance *instance, const double *wanted, double *change)
{
    enum { N = SPEEDS, M = CONSTRAINTS };
    double v[N * N + N + M * N + M], right[N + M], x[N + M];
    terms(instance->time, instance->y, speeds(instance), &instance->p, instance->s, v);
    for (int i = 0; i < N; ++i) right[i] = 0.0;
    for (int k = 0; k < M; ++k) right[N + k] = wanted[k];
    if (solve(v, right, x)) return 1;
    for (int i = 0; i < N; ++i) {
        if (!isfinite(x[i])) return 1;
        change[i] = x[i];
    }
    return 0;
}

/* moves coordinates, then speeds onto the constraints; nonzero where no such state is found near */
static int onto_constraints(Instance *instance)
{
    const double zero[STATES] = {0.0};
    const struct parameters *p = &instance->p;
    double *q = instance->y, *u = instance->y + COORDINATES, f[CONSTRAINTS + 1], wanted[CONSTRAINTS + 1], change[SPEEDS];
    if (CONSTRAINTS == 0) return 0;
    for (int round = 0; round < 30; ++round) {
        double dq[COORDINATES], largest = 0.0;
        constraints(instance->time, q, u, p, instance->s, f);
        for (int k = 0; k < CONSTRAINTS; ++k) wanted[k] = kept[k] == OF_COORDINATES ? -f[k] : 0.0;
        if (least_change(instance, wanted, change)) return 1;
        position_rates_along(instance->time, q, u, p, instance->s, 0.0, zero, change, &unchanged, dq);
        for (int i = 0; i < COORDINATES; ++i) {
            q[i] += dq[i];
            largest = fmax(largest, fabs(dq[i]) / (1.0 + fabs(q[i])));
        }
        if (largest < 1e-13) {
            double rate[COORDINATES], g[CONSTRAINTS + 1];
            position_rates(instance->time, q, u, p, instance->s, rate);
            constraints(instance->time, q, u, p, instance->s, f);
            constraints_along(instance->time, q, u, p, instance->s, 1.0, rate, zero, &unchanged, g);
            for (int k = 0; k < CONSTRAINTS; ++k) wanted[k] = kept[k] == OF_COORDINATES ? -g[k] : kept[k] == OF_SPEEDS ? -f[k] : 0.0;
            if (least_change(instance, wanted, change)) return 1;
            for (int i = 0; i < SPEEDS; ++i) u[i] += change[i];
            changed(instance);
            return 0;
        }
    }
    return 1;
}
