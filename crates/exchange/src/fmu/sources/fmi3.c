/* The functions of FMI 3.0 for model exchange and co-simulation, over the functions of one system. */

#include "types.h"
#include "system.h"
#include "instance.h"
#include "pair.h"
#include "events.h"
#include "steps.h"

#define OF(handle) Instance *instance = (Instance *)(handle)
#define UNUSED(value) (void)(value)

EXPORT const char *FMI(fmi3GetVersion)(void)
{
    return "3.0";
}

EXPORT fmi3Status FMI(fmi3SetDebugLogging)(fmi3Instance handle, fmi3Boolean on, size_t count, const fmi3String categories[])
{
    UNUSED(handle), UNUSED(on), UNUSED(count), UNUSED(categories);
    return fmi3OK;
}

static void begin(Instance *instance)
{
    const Instance kept_of = *instance;
    memset(instance, 0, sizeof *instance);
    instance->log = kept_of.log;
    instance->environment = kept_of.environment;
    instance->steps_itself = kept_of.steps_itself;
    instance->p = defaults;
    instance->tolerance = TOLERANCE;
    memcpy(instance->y, start, sizeof instance->y);
}

static fmi3Instance made(fmi3String token, bool steps_itself, fmi3InstanceEnvironment environment, fmi3LogMessageCallback log)
{
    Instance *instance = calloc(1, sizeof *instance);
    if (!instance) return NULL;
    instance->log = log;
    instance->environment = environment;
    instance->steps_itself = steps_itself;
    if (!token || strcmp(token, TOKEN) != 0) {
        tell(instance, fmi3Error, "the instantiation token is that of another unit");
        free(instance);
        return NULL;
    }
    begin(instance);
    return instance;
}

EXPORT fmi3Instance FMI(fmi3InstantiateModelExchange)(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible,
                                                      fmi3Boolean logging, fmi3InstanceEnvironment environment, fmi3LogMessageCallback log)
{
    UNUSED(name), UNUSED(resources), UNUSED(visible), UNUSED(logging);
    return made(token, false, environment, log);
}

EXPORT fmi3Instance FMI(fmi3InstantiateCoSimulation)(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible,
                                                     fmi3Boolean logging, fmi3Boolean event_mode, fmi3Boolean early_return,
                                                     const fmi3ValueReference intermediate[], size_t count,
                                                     fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
                                                     fmi3IntermediateUpdateCallback update)
{
    UNUSED(name), UNUSED(resources), UNUSED(visible), UNUSED(logging), UNUSED(early_return), UNUSED(intermediate), UNUSED(count), UNUSED(update);
    return event_mode ? NULL : made(token, true, environment, log);
}

EXPORT fmi3Instance FMI(fmi3InstantiateScheduledExecution)(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible,
                                                           fmi3Boolean logging, fmi3InstanceEnvironment environment,
                                                           fmi3LogMessageCallback log, fmi3ClockUpdateCallback update,
                                                           fmi3LockPreemptionCallback lock, fmi3UnlockPreemptionCallback unlock)
{
    UNUSED(name), UNUSED(token), UNUSED(resources), UNUSED(visible), UNUSED(logging), UNUSED(environment), UNUSED(log), UNUSED(update);
    UNUSED(lock), UNUSED(unlock);
    return NULL;
}

EXPORT void FMI(fmi3FreeInstance)(fmi3Instance handle)
{
    free(handle);
}

EXPORT fmi3Status FMI(fmi3EnterInitializationMode)(fmi3Instance handle, fmi3Boolean has_tolerance, fmi3Float64 tolerance, fmi3Float64 time,
                                                   fmi3Boolean has_end, fmi3Float64 end)
{
    OF(handle);
    UNUSED(has_end), UNUSED(end);
    if (has_tolerance && tolerance > 0.0) instance->tolerance = tolerance;
    instance->time = time;
    instance->mode = INITIALIZING;
    instance->has_sides = false;
    changed(instance);
    return fmi3OK;
}

EXPORT fmi3Status FMI(fmi3ExitInitializationMode)(fmi3Instance handle)
{
    OF(handle);
    if (onto_constraints(instance)) return tell(instance, fmi3Error, "no state that meets the constraints is found near the start");
    const fmi3Status status = find_sides(instance);
    instance->mode = instance->steps_itself ? STEPPING : EVENT;
    return status;
}

EXPORT fmi3Status FMI(fmi3EnterEventMode)(fmi3Instance handle)
{
    OF(handle);
    instance->mode = EVENT;
    return fmi3OK;
}

EXPORT fmi3Status FMI(fmi3EnterContinuousTimeMode)(fmi3Instance handle)
{
    OF(handle);
    instance->mode = CONTINUOUS;
    return fmi3OK;
}

EXPORT fmi3Status FMI(fmi3EnterStepMode)(fmi3Instance handle)
{
    OF(handle);
    instance->mode = STEPPING;
    return fmi3OK;
}

EXPORT fmi3Status FMI(fmi3Terminate)(fmi3Instance handle)
{
    OF(handle);
    instance->mode = TERMINATED;
    return fmi3OK;
}

EXPORT fmi3Status FMI(fmi3Reset)(fmi3Instance handle)
{
    begin((Instance *)handle);
    return fmi3OK;
}

/* where states and data are being set, what holds at their conditions is not known */
static fmi3Status ready(Instance *instance)
{
    return instance->has_sides ? fmi3OK : find_sides(instance);
}

EXPORT fmi3Status FMI(fmi3GetFloat64)(fmi3Instance handle, const fmi3ValueReference of[], size_t count, fmi3Float64 values[], size_t length)
{
    OF(handle);
    if (count != length) return fmi3Error;
    fmi3Status status = fmi3OK;
    for (size_t k = 0; k < count && status <= fmi3Warning; ++k) {
        const size_t at = of[k];
        if (at >= VARIABLES) return tell(instance, fmi3Error, "no variable has the value reference %u", (unsigned)at);
        if (at == 0) values[k] = instance->time;
        else if (at < DERIVATIVE_AT) values[k] = instance->y[at - STATE_AT];
        else if (at >= DATA_AT && at < OUTPUT_AT) values[k] = ((const double *)&instance->p)[at - DATA_AT];
        else if ((status = ready(instance)) > fmi3Warning) break;
        else if (at < DATA_AT) {
            status = with_rates(instance);
            values[k] = instance->dy[at - DERIVATIVE_AT];
        } else if (at < INDICATOR_AT) {
            status = with_outputs(instance);
            values[k] = instance->shown[at - OUTPUT_AT];
        } else {
            double z[INDICATORS + 1];
            indicator_values(instance, instance->time, instance->y, z);
            values[k] = z[at - INDICATOR_AT];
        }
    }
    return status;
}

EXPORT fmi3Status FMI(fmi3SetFloat64)(fmi3Instance handle, const fmi3ValueReference of[], size_t count, const fmi3Float64 values[], size_t length)
{
    OF(handle);
    if (count != length) return fmi3Error;
    for (size_t k = 0; k < count; ++k) {
        const size_t at = of[k];
        const bool is_data = at >= DATA_AT && at < OUTPUT_AT, is_state = at >= STATE_AT && at < DERIVATIVE_AT;
        if (!is_data && !(is_state && instance->mode <= INITIALIZING))
            return tell(instance, fmi3Error, "the variable with the value reference %u cannot be set now", (unsigned)at);
        if (!isfinite(values[k])) return tell(instance, fmi3Error, "a value that is no number cannot be set");
        if (is_data) ((double *)&instance->p)[at - DATA_AT] = values[k];
        else instance->y[at - STATE_AT] = values[k];
        if (instance->mode <= INITIALIZING) instance->has_sides = false;
        changed(instance);
    }
    return fmi3OK;
}

EXPORT fmi3Status FMI(fmi3UpdateDiscreteStates)(fmi3Instance handle, fmi3Boolean *again, fmi3Boolean *terminate, fmi3Boolean *nominals,
                                                fmi3Boolean *states, fmi3Boolean *has_next, fmi3Float64 *next)
{
    OF(handle);
    bool sets = false;
    const fmi3Status status = pass_events(instance, &sets);
    *again = false;
    *terminate = instance->ended;
    *nominals = false;
    *states = sets;
    *has_next = false;
    *next = 0.0;
    return status;
}

EXPORT fmi3Status FMI(fmi3EvaluateDiscreteStates)(fmi3Instance handle)
{
    UNUSED(handle);
    return fmi3OK;
}

EXPORT fmi3Status FMI(fmi3CompletedIntegratorStep)(fmi3Instance handle, fmi3Boolean no_return, fmi3Boolean *event, fmi3Boolean *terminate)
{
    OF(handle);
    UNUSED(no_return);
    recount(instance);
    /* an importer may have stepped over a zero near the beginning of its step */
    *event = any_is_beyond(instance, instance->time, instance->y);
    *terminate = false;
    return fmi3OK;
}

EXPORT fmi3Status FMI(fmi3SetTime)(fmi3Instance handle, fmi3Float64 time)
{
    OF(handle);
    instance->time = time;
    changed(instance);
    return fmi3OK;
}

EXPORT fmi3Status FMI(fmi3SetContinuousStates)(fmi3Instance handle, const fmi3Float64 states[], size_t count)
{
    OF(handle);
    if (count != STATES) return fmi3Error;
    memcpy(instance->y, states, sizeof instance->y);
    changed(instance);
    return fmi3OK;
}

EXPORT fmi3Status FMI(fmi3GetContinuousStates)(fmi3Instance handle, fmi3Float64 states[], size_t count)
{
    OF(handle);
    if (count != STATES) return fmi3Error;
    memcpy(states, instance->y, sizeof instance->y);
    return fmi3OK;
}

EXPORT fmi3Status FMI(fmi3GetContinuousStateDerivatives)(fmi3Instance handle, fmi3Float64 derivatives[], size_t count)
{
    OF(handle);
    if (count != STATES) return fmi3Error;
    fmi3Status status = ready(instance);
    if (status <= fmi3Warning) status = with_rates(instance);
    if (status <= fmi3Warning) memcpy(derivatives, instance->dy, sizeof instance->dy);
    return status;
}

EXPORT fmi3Status FMI(fmi3GetEventIndicators)(fmi3Instance handle, fmi3Float64 values[], size_t count)
{
    OF(handle);
    double z[INDICATORS + 1];
    if (count != INDICATORS) return fmi3Error;
    indicator_values(instance, instance->time, instance->y, z);
    for (int i = 0; i < INDICATORS; ++i) values[i] = z[i];
    return fmi3OK;
}

EXPORT fmi3Status FMI(fmi3GetNominalsOfContinuousStates)(fmi3Instance handle, fmi3Float64 nominals[], size_t count)
{
    UNUSED(handle);
    for (size_t i = 0; i < count; ++i) nominals[i] = 1.0;
    return fmi3OK;
}

EXPORT fmi3Status FMI(fmi3GetNumberOfEventIndicators)(fmi3Instance handle, size_t *count)
{
    UNUSED(handle);
    *count = INDICATORS;
    return fmi3OK;
}

EXPORT fmi3Status FMI(fmi3GetNumberOfContinuousStates)(fmi3Instance handle, size_t *count)
{
    UNUSED(handle);
    *count = STATES;
    return fmi3OK;
}

EXPORT fmi3Status FMI(fmi3GetDirectionalDerivative)(fmi3Instance handle, const fmi3ValueReference unknowns[], size_t n_unknowns,
                                                    const fmi3ValueReference knowns[], size_t n_knowns, const fmi3Float64 seed[],
                                                    size_t n_seed, fmi3Float64 sensitivity[], size_t n_sensitivity)
{
    OF(handle);
    double dy[STATES] = {0.0}, moved[COORDINATES], change[SPEEDS + CONSTRAINTS], dz[INDICATORS + 1], shown[OUTPUTS], a[SPEEDS], dt = 0.0;
    struct parameters dp = unchanged;
    if (n_seed != n_knowns || n_sensitivity != n_unknowns) return fmi3Error;
    for (size_t k = 0; k < n_knowns; ++k) {
        const size_t at = knowns[k];
        if (at == 0) dt += seed[k];
        else if (at < DERIVATIVE_AT) dy[at - STATE_AT] += seed[k];
        else if (at >= DATA_AT && at < OUTPUT_AT) ((double *)&dp)[at - DATA_AT] += seed[k];
        else return tell(instance, fmi3Error, "the value reference %u is that of no state, parameter or input", (unsigned)at);
    }
    const fmi3Status status = ready(instance);
    if (status > fmi3Warning) return status;
    const double *q = instance->y, *u = speeds(instance), *dq = dy, *du = dy + COORDINATES;
    const struct parameters *p = &instance->p;
    if (accelerations(instance->time, q, u, p, instance->s, a, instance->lambda) ||
        solved_along(instance, a, instance->lambda, dt, dq, du, &dp, change))
        return tell(instance, fmi3Discard, "at t = %.17g s the accelerations are not determined", instance->time);
    position_rates_along(instance->time, q, u, p, instance->s, dt, dq, du, &dp, moved);
    indicators_along(instance->time, q, u, p, instance->s, dt, dq, du, &dp, dz);
    outputs_along(instance->time, q, u, p, instance->s, a, instance->lambda, dt, dq, du, &dp, change, change + SPEEDS, shown);
    for (size_t k = 0; k < n_unknowns; ++k) {
        const size_t at = unknowns[k];
        if (at >= OUTPUT_AT && at < INDICATOR_AT) sensitivity[k] = shown[at - OUTPUT_AT];
        else if (at >= INDICATOR_AT && at < VARIABLES) sensitivity[k] = dz[at - INDICATOR_AT];
        else if (at >= DERIVATIVE_AT && at < DERIVATIVE_AT + COORDINATES) sensitivity[k] = moved[at - DERIVATIVE_AT];
        else if (at >= DERIVATIVE_AT + COORDINATES && at < DATA_AT) sensitivity[k] = change[at - DERIVATIVE_AT - COORDINATES];
        else return tell(instance, fmi3Error, "the value reference %u is that of no derivative or output", (unsigned)at);
    }
    return fmi3OK;
}

EXPORT fmi3Status FMI(fmi3DoStep)(fmi3Instance handle, fmi3Float64 time, fmi3Float64 length, fmi3Boolean no_return, fmi3Boolean *event,
                                  fmi3Boolean *terminate, fmi3Boolean *early, fmi3Float64 *reached)
{
    OF(handle);
    UNUSED(no_return);
    /* data that were set may have moved an indicator across its zero */
    bool sets;
    fmi3Status status = any_is_beyond(instance, instance->time, instance->y) ? pass_events(instance, &sets) : fmi3OK;
    if (status <= fmi3Warning) status = run_to(instance, time + length);
    *event = *early = false;
    *terminate = instance->ended;
    *reached = instance->time;
    return status;
}

EXPORT fmi3Status FMI(fmi3GetFMUState)(fmi3Instance handle, fmi3FMUState *state)
{
    if (!*state) *state = malloc(sizeof(Instance));
    if (!*state) return fmi3Error;
    memcpy(*state, handle, sizeof(Instance));
    return fmi3OK;
}

EXPORT fmi3Status FMI(fmi3SetFMUState)(fmi3Instance handle, fmi3FMUState state)
{
    memcpy(handle, state, sizeof(Instance));
    return fmi3OK;
}

EXPORT fmi3Status FMI(fmi3FreeFMUState)(fmi3Instance handle, fmi3FMUState *state)
{
    UNUSED(handle);
    free(*state);
    *state = NULL;
    return fmi3OK;
}

#include "others.h"
