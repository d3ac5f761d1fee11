/* Co-simulation: steps by the tolerance, with events found within a step. */

/* the part of a step after which some indicator has first been seen beyond its side, to rounding; 2 where none is */
static double first_event(Instance *instance, double h, const double *after)
{
    double low = 0.0, high = 2.0, y[STATES], error;
    for (int part = 1; part <= 4 && high > 1.0; ++part) {
        const double to = part / 4.0;
        if (part < 4 && try_step(instance, to * h, y, &error)) break;
        if (any_is_beyond(instance, instance->time + to * h, part < 4 ? y : after)) high = to;
        else low = to;
    }
    if (high > 1.0) return 2.0;
    for (int halving = 0; halving < 60 && (high - low) * fabs(h) > 1e-15 * (1.0 + fabs(instance->time)); ++halving) {
        const double middle = (low + high) / 2.0;
        if (try_step(instance, middle * h, y, &error)) break;
        if (any_is_beyond(instance, instance->time + middle * h, y)) high = middle;
        else low = middle;
    }
    return high;
}

static fmi3Status run_to(Instance *instance, double end)
{
    const double rounding = 1e-14 * (1.0 + fabs(end));
    double h = instance->step > 0.0 ? instance->step : end - instance->time;
    int events = 0;
    while (end - instance->time > rounding && !instance->ended) {
        double after[STATES], error;
        const bool is_last = h >= end - instance->time - rounding;
        double step = is_last ? end - instance->time : h;
        const int failed = try_step(instance, step, after, &error);
        if (failed || error > 1.0) {
            h = step * (failed ? 0.1 : fmax(0.1, 0.9 * pow(error, -0.2)));
            if (h < 1e-14 * (1.0 + fabs(instance->time)))
                return tell(instance, fmi3Error, "at t = %.17g s no step meets the tolerance: the state has no rates, or none that are bounded", instance->time);
            continue;
        }
        const double longer = step * fmin(5.0, 0.9 * pow(fmax(error, 1e-10), -0.2));
        const double part = INDICATORS > 0 ? first_event(instance, step, after) : 2.0;
        if (part <= 1.0) {
            if (part < 1.0 && try_step(instance, part * step, after, &error)) return tell(instance, fmi3Error, "an event cannot be reached");
            step *= part;
        }
        instance->time = part > 1.0 && is_last ? end : instance->time + step;
        memcpy(instance->y, after, sizeof after);
        changed(instance);
        if (onto_constraints(instance)) return tell(instance, fmi3Error, "at t = %.17g s the constraints cannot be kept", instance->time);
        /* a last step that is short says nothing of the next one */
        if (!is_last || longer < h) h = longer;
        if (part <= 1.0) {
            bool sets;
            const fmi3Status status = pass_events(instance, &sets);
            if (status > fmi3Warning) return status;
            if (++events > 10000)
                return tell(instance, fmi3Error, "at t = %.17g s more than 10000 events have followed each other: they come ever faster", instance->time);
        } else {
            recount(instance);
        }
    }
    instance->step = h;
    return fmi3OK;
}
