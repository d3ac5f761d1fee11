/* The functions of FMI 2.0 for model exchange and co-simulation, over those of FMI 3.0, which are not seen from outside. */

#define EXPORT static
#if defined __GNUC__
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#include "fmi3.c"
#include "types2.h"

/* a component of FMI 2.0: an instance of FMI 3.0, and what an importer says of it at another time than there */
typedef struct {
    fmi3Instance of;
    fmi2CallbackFunctions callbacks;
    char *name;
    bool has_tolerance, has_end;
    double tolerance, begin, end;
} Component;

#define INSTANCE(handle) ((Instance *)((Component *)(handle))->of)

static void log_by_callback(fmi3InstanceEnvironment environment, fmi3Status status, fmi3String category, fmi3String message)
{
    const Component *component = environment;
    /* the message is no format: it may hold a percent sign */
    if (component->callbacks.logger)
        component->callbacks.logger(component->callbacks.componentEnvironment, component->name, (fmi2Status)status, category, "%s", message);
}

VISIBLE const char *FMI2(fmi2GetTypesPlatform)(void)
{
    return "default";
}

VISIBLE const char *FMI2(fmi2GetVersion)(void)
{
    return "2.0";
}

VISIBLE fmi2Status FMI2(fmi2SetDebugLogging)(fmi2Component handle, fmi2Boolean on, size_t count, const fmi2String categories[])
{
    UNUSED(handle), UNUSED(on), UNUSED(count), UNUSED(categories);
    return fmi2OK;
}

VISIBLE fmi2Component FMI2(fmi2Instantiate)(fmi2String name, fmi2Type type, fmi2String token, fmi2String resources,
                                            const fmi2CallbackFunctions *callbacks, fmi2Boolean visible, fmi2Boolean logging)
{
    UNUSED(resources), UNUSED(visible), UNUSED(logging);
    Component *component = calloc(1, sizeof *component);
    const char *own = name ? name : "";
    if (!component) return NULL;
    if (callbacks) component->callbacks = *callbacks;
    component->name = malloc(strlen(own) + 1);
    if (component->name) {
        strcpy(component->name, own);
        component->of = made(token, type == fmi2CoSimulation, component, log_by_callback);
    }
    if (!component->of) {
        free(component->name);
        free(component);
        return NULL;
    }
    return component;
}

VISIBLE void FMI2(fmi2FreeInstance)(fmi2Component handle)
{
    Component *component = handle;
    if (!component) return;
    fmi3FreeInstance(component->of);
    free(component->name);
    free(component);
}

VISIBLE fmi2Status FMI2(fmi2SetupExperiment)(fmi2Component handle, fmi2Boolean has_tolerance, fmi2Real tolerance, fmi2Real begin,
                                             fmi2Boolean has_end, fmi2Real end)
{
    Component *component = handle;
    component->has_tolerance = has_tolerance;
    component->tolerance = tolerance;
    component->begin = begin;
    component->has_end = has_end;
    component->end = end;
    return fmi2OK;
}

VISIBLE fmi2Status FMI2(fmi2EnterInitializationMode)(fmi2Component handle)
{
    const Component *component = handle;
    return (fmi2Status)fmi3EnterInitializationMode(component->of, component->has_tolerance, component->tolerance, component->begin, component->has_end,
                                                   component->end);
}

VISIBLE fmi2Status FMI2(fmi2ExitInitializationMode)(fmi2Component handle)
{
    return (fmi2Status)fmi3ExitInitializationMode(INSTANCE(handle));
}

VISIBLE fmi2Status FMI2(fmi2Terminate)(fmi2Component handle)
{
    return (fmi2Status)fmi3Terminate(INSTANCE(handle));
}

VISIBLE fmi2Status FMI2(fmi2Reset)(fmi2Component handle)
{
    Component *component = handle;
    const Component before = *component;
    memset(component, 0, sizeof *component);
    component->of = before.of;
    component->callbacks = before.callbacks;
    component->name = before.name;
    return (fmi2Status)fmi3Reset(component->of);
}

VISIBLE fmi2Status FMI2(fmi2GetReal)(fmi2Component handle, const fmi2ValueReference of[], size_t count, fmi2Real values[])
{
    return (fmi2Status)fmi3GetFloat64(INSTANCE(handle), of, count, values, count);
}

VISIBLE fmi2Status FMI2(fmi2SetReal)(fmi2Component handle, const fmi2ValueReference of[], size_t count, const fmi2Real values[])
{
    return (fmi2Status)fmi3SetFloat64(INSTANCE(handle), of, count, values, count);
}

/* kinds of variables that this unit has none of */
#define VALUES2(type) \
    VISIBLE fmi2Status FMI2(fmi2Get##type)(fmi2Component handle, const fmi2ValueReference of[], size_t count, fmi2##type values[]) \
    { \
        UNUSED(handle), UNUSED(of), UNUSED(values); \
        return count == 0 ? fmi2OK : fmi2Error; \
    } \
    VISIBLE fmi2Status FMI2(fmi2Set##type)(fmi2Component handle, const fmi2ValueReference of[], size_t count, const fmi2##type values[]) \
    { \
        UNUSED(handle), UNUSED(of), UNUSED(values); \
        return count == 0 ? fmi2OK : fmi2Error; \
    }
VALUES2(Integer)
VALUES2(Boolean)
VALUES2(String)

VISIBLE fmi2Status FMI2(fmi2GetFMUstate)(fmi2Component handle, fmi2FMUstate *state)
{
    return (fmi2Status)fmi3GetFMUState(INSTANCE(handle), state);
}

VISIBLE fmi2Status FMI2(fmi2SetFMUstate)(fmi2Component handle, fmi2FMUstate state)
{
    return (fmi2Status)fmi3SetFMUState(INSTANCE(handle), state);
}

VISIBLE fmi2Status FMI2(fmi2FreeFMUstate)(fmi2Component handle, fmi2FMUstate *state)
{
    return (fmi2Status)fmi3FreeFMUState(INSTANCE(handle), state);
}

VISIBLE fmi2Status FMI2(fmi2SerializedFMUstateSize)(fmi2Component handle, fmi2FMUstate state, size_t *size)
{
    UNUSED(handle), UNUSED(state), UNUSED(size);
    return fmi2Error;
}

VISIBLE fmi2Status FMI2(fmi2SerializeFMUstate)(fmi2Component handle, fmi2FMUstate state, fmi2Byte bytes[], size_t size)
{
    UNUSED(handle), UNUSED(state), UNUSED(bytes), UNUSED(size);
    return fmi2Error;
}

VISIBLE fmi2Status FMI2(fmi2DeSerializeFMUstate)(fmi2Component handle, const fmi2Byte bytes[], size_t size, fmi2FMUstate *state)
{
    UNUSED(handle), UNUSED(bytes), UNUSED(size), UNUSED(state);
    return fmi2Error;
}

VISIBLE fmi2Status FMI2(fmi2GetDirectionalDerivative)(fmi2Component handle, const fmi2ValueReference unknowns[], size_t n_unknowns,
                                                      const fmi2ValueReference knowns[], size_t n_knowns, const fmi2Real seed[],
                                                      fmi2Real sensitivity[])
{
    return (fmi2Status)fmi3GetDirectionalDerivative(INSTANCE(handle), unknowns, n_unknowns, knowns, n_knowns, seed, n_knowns, sensitivity, n_unknowns);
}

VISIBLE fmi2Status FMI2(fmi2EnterEventMode)(fmi2Component handle)
{
    return (fmi2Status)fmi3EnterEventMode(INSTANCE(handle));
}

VISIBLE fmi2Status FMI2(fmi2NewDiscreteStates)(fmi2Component handle, fmi2EventInfo *info)
{
    bool again, terminate, nominals, states, has_next;
    const fmi3Status status = fmi3UpdateDiscreteStates(INSTANCE(handle), &again, &terminate, &nominals, &states, &has_next, &info->nextEventTime);
    info->newDiscreteStatesNeeded = again;
    info->terminateSimulation = terminate;
    info->nominalsOfContinuousStatesChanged = nominals;
    info->valuesOfContinuousStatesChanged = states;
    info->nextEventTimeDefined = has_next;
    return (fmi2Status)status;
}

VISIBLE fmi2Status FMI2(fmi2EnterContinuousTimeMode)(fmi2Component handle)
{
    return (fmi2Status)fmi3EnterContinuousTimeMode(INSTANCE(handle));
}

VISIBLE fmi2Status FMI2(fmi2CompletedIntegratorStep)(fmi2Component handle, fmi2Boolean no_return, fmi2Boolean *event, fmi2Boolean *terminate)
{
    bool has_event, ends;
    const fmi3Status status = fmi3CompletedIntegratorStep(INSTANCE(handle), no_return, &has_event, &ends);
    *event = has_event;
    *terminate = ends;
    return (fmi2Status)status;
}

VISIBLE fmi2Status FMI2(fmi2SetTime)(fmi2Component handle, fmi2Real time)
{
    return (fmi2Status)fmi3SetTime(INSTANCE(handle), time);
}

VISIBLE fmi2Status FMI2(fmi2SetContinuousStates)(fmi2Component handle, const fmi2Real states[], size_t count)
{
    return (fmi2Status)fmi3SetContinuousStates(INSTANCE(handle), states, count);
}

VISIBLE fmi2Status FMI2(fmi2GetDerivatives)(fmi2Component handle, fmi2Real rates[], size_t count)
{
    return (fmi2Status)fmi3GetContinuousStateDerivatives(INSTANCE(handle), rates, count);
}

VISIBLE fmi2Status FMI2(fmi2GetEventIndicators)(fmi2Component handle, fmi2Real values[], size_t count)
{
    return (fmi2Status)fmi3GetEventIndicators(INSTANCE(handle), values, count);
}

VISIBLE fmi2Status FMI2(fmi2GetContinuousStates)(fmi2Component handle, fmi2Real states[], size_t count)
{
    return (fmi2Status)fmi3GetContinuousStates(INSTANCE(handle), states, count);
}

VISIBLE fmi2Status FMI2(fmi2GetNominalsOfContinuousStates)(fmi2Component handle, fmi2Real nominals[], size_t count)
{
    return (fmi2Status)fmi3GetNominalsOfContinuousStates(INSTANCE(handle), nominals, count);
}

VISIBLE fmi2Status FMI2(fmi2SetRealInputDerivatives)(fmi2Component handle, const fmi2ValueReference of[], size_t count, const fmi2Integer orders[],
                                                     const fmi2Real values[])
{
    UNUSED(handle), UNUSED(of), UNUSED(count), UNUSED(orders), UNUSED(values);
    return fmi2Error;
}

VISIBLE fmi2Status FMI2(fmi2GetRealOutputDerivatives)(fmi2Component handle, const fmi2ValueReference of[], size_t count, const fmi2Integer orders[],
                                                      fmi2Real values[])
{
    UNUSED(handle), UNUSED(of), UNUSED(count), UNUSED(orders), UNUSED(values);
    return fmi2Error;
}

/* an event that ends the run discards the rest of a step */
VISIBLE fmi2Status FMI2(fmi2DoStep)(fmi2Component handle, fmi2Real time, fmi2Real length, fmi2Boolean no_return)
{
    bool event, ends, early;
    double reached;
    const fmi3Status status = fmi3DoStep(INSTANCE(handle), time, length, no_return, &event, &ends, &early, &reached);
    return status <= fmi3Warning && ends ? fmi2Discard : (fmi2Status)status;
}

VISIBLE fmi2Status FMI2(fmi2CancelStep)(fmi2Component handle)
{
    UNUSED(handle);
    return fmi2Error;
}

VISIBLE fmi2Status FMI2(fmi2GetStatus)(fmi2Component handle, const fmi2StatusKind kind, fmi2Status *value)
{
    if (kind != fmi2DoStepStatus) return fmi2Discard;
    *value = INSTANCE(handle)->ended ? fmi2Discard : fmi2OK;
    return fmi2OK;
}

VISIBLE fmi2Status FMI2(fmi2GetRealStatus)(fmi2Component handle, const fmi2StatusKind kind, fmi2Real *value)
{
    if (kind != fmi2LastSuccessfulTime) return fmi2Discard;
    *value = INSTANCE(handle)->time;
    return fmi2OK;
}

VISIBLE fmi2Status FMI2(fmi2GetIntegerStatus)(fmi2Component handle, const fmi2StatusKind kind, fmi2Integer *value)
{
    UNUSED(handle), UNUSED(kind), UNUSED(value);
    return fmi2Discard;
}

VISIBLE fmi2Status FMI2(fmi2GetBooleanStatus)(fmi2Component handle, const fmi2StatusKind kind, fmi2Boolean *value)
{
    if (kind != fmi2Terminated) return fmi2Discard;
    *value = INSTANCE(handle)->ended;
    return fmi2OK;
}

VISIBLE fmi2Status FMI2(fmi2GetStringStatus)(fmi2Component handle, const fmi2StatusKind kind, fmi2String *value)
{
    UNUSED(handle), UNUSED(kind), UNUSED(value);
    return fmi2Discard;
}
