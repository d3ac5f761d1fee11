/* The sides of the indicators: which case of each condition holds, which events have passed, and what they set. */

static void indicator_values(const Instance *instance, double time, const double *y, double *z)
{
    indicators(time, y, y + COORDINATES, &instance->p, instance->s, z);
    for (int i = 0; i < INDICATORS; ++i) z[i] -= instance->counted_from[i];
}

/* the rate of an indicator along the motion, with the cases as they stand; where it is zero, the indicator a moment later */
static double indicator_trend(Instance *instance, int i)
{
    double dy[STATES], dz[INDICATORS + 1];
    if (rates_of(instance, instance->time, instance->y, dy)) return 0.0;
    indicators_along(instance->time, instance->y, speeds(instance), &instance->p, instance->s, 1.0, dy, dy + COORDINATES, &unchanged, dz);
    if (dz[i] != 0.0) return dz[i];
    const double moment = 1e-6 * (1.0 + fabs(instance->time));
    double now[INDICATORS + 1], later[INDICATORS + 1], y[STATES], error;
    if (try_step(instance, moment, y, &error)) return 0.0;
    indicator_values(instance, instance->time, instance->y, now);
    indicator_values(instance, instance->time + moment, y, later);
    return (later[i] - now[i]) / moment;
}

static void set_side(Instance *instance, int i, int side)
{
    instance->side[i] = side;
    if (i < CONDITIONS) instance->s[i] = side > 0 ? 1.0 : 0.0;
}

/* the side of an indicator that is at its zero: the one to which the motion takes it; zero where each drives it back */
static int side_from_zero(Instance *instance, int i, int first)
{
    set_side(instance, i, first);
    if (indicator_trend(instance, i) * first >= 0.0) return first;
    set_side(instance, i, -first);
    return indicator_trend(instance, i) * -first >= 0.0 ? -first : 0;
}

static fmi3Status stays(const Instance *instance, int i)
{
    return tell(instance, fmi3Error, "at t = %.17g s %s stays at zero, as dry friction that sticks: this unit has no law for it", instance->time,
                indicator_names[i]);
}

/* the sides at a state of which nothing is known yet */
static fmi3Status find_sides(Instance *instance)
{
    double z[INDICATORS + 1];
    for (int i = 0; i < INDICATORS; ++i) instance->counted_from[i] = 0.0;
    /* a condition may hold those before it */
    for (int i = 0; i < INDICATORS; ++i) set_side(instance, i, -1);
    for (int i = 0; i < INDICATORS; ++i) {
        indicator_values(instance, instance->time, instance->y, z);
        if (z[i] != 0.0) {
            set_side(instance, i, z[i] > 0.0 ? 1 : -1);
            continue;
        }
        const int side = side_from_zero(instance, i, -1);
        if (side == 0) return stays(instance, i);
        set_side(instance, i, side);
    }
    instance->has_sides = true;
    changed(instance);
    return fmi3OK;
}

/* whether an indicator is beyond its side */
static bool is_beyond(const Instance *instance, const double *z, int i)
{
    return z[i] * instance->side[i] < 0.0;
}

static bool any_is_beyond(const Instance *instance, double time, const double *y)
{
    double z[INDICATORS + 1];
    indicator_values(instance, time, y, z);
    for (int i = 0; i < INDICATORS; ++i)
        if (is_beyond(instance, z, i)) return true;
    return false;
}

/* the events that have passed set the state, and each indicator has its side after them */
static fmi3Status pass_events(Instance *instance, bool *sets)
{
    double z[INDICATORS + 1], y[STATES], before_all[STATES];
    bool left[INDICATORS + 1];
    bool has_set = false;
    indicator_values(instance, instance->time, instance->y, z);
    memcpy(before_all, instance->y, sizeof before_all);
    for (int i = 0; i < INDICATORS; ++i)
        left[i] = is_beyond(instance, z, i) || (z[i] == 0.0 && indicator_trend(instance, i) * instance->side[i] < 0.0);
    for (int i = CONDITIONS; i < INDICATORS; ++i) {
        const int event = i - CONDITIONS;
        if (!left[i] || directions[event] == instance->side[i]) continue;
        /* events of one instant follow each other; one whose indicator an event before it sends back does not happen */
        if (has_set && indicator_trend(instance, i) * instance->side[i] >= 0.0) continue;
        memcpy(y, instance->y, sizeof y);
        set_by_event(event, instance->time, instance->y, speeds(instance), &instance->p, instance->s, y);
        memcpy(instance->y, y, sizeof y);
        has_set = true;
        changed(instance);
        if (ends[event]) {
            instance->ended = true;
            tell(instance, fmi3OK, "at t = %.17g s %s ends the run", instance->time, indicator_names[i]);
        }
    }
    *sets = memcmp(before_all, instance->y, sizeof before_all) != 0;
    changed(instance);
    for (int i = 0; i < INDICATORS; ++i) {
        if (left[i]) instance->counted_from[i] = 0.0;
        indicator_values(instance, instance->time, instance->y, z);
        if (!left[i] && !(*sets && is_beyond(instance, z, i))) continue;
        const int before = instance->side[i];
        if (left[i] && z[i] * before <= 0.0) {
            /* at its zero: the motion may take it on, or back */
            const int side = side_from_zero(instance, i, -before);
            if (side == 0 && i < CONDITIONS) return stays(instance, i);
            set_side(instance, i, side == 0 ? before : side);
            if (instance->side[i] == before) instance->counted_from[i] = z[i];
        } else {
            set_side(instance, i, z[i] > 0.0 ? 1 : z[i] < 0.0 ? -1 : before);
        }
    }
    changed(instance);
    if (*sets && CONSTRAINTS > 0) {
        memcpy(y, instance->y, sizeof y);
        if (onto_constraints(instance)) return tell(instance, fmi3Error, "at t = %.17g s an event leaves the constraints", instance->time);
        for (int i = 0; i < STATES; ++i)
            if (fabs(instance->y[i] - y[i]) > 1e-6 * (1.0 + fabs(y[i])))
                return tell(instance, fmi3Error, "at t = %.17g s an event sets a state that breaks the constraints", instance->time);
    }
    return fmi3OK;
}

/* an indicator that is beyond its zero again is counted from there */
static void recount(Instance *instance)
{
    double z[INDICATORS + 1];
    indicators(instance->time, instance->y, speeds(instance), &instance->p, instance->s, z);
    for (int i = 0; i < INDICATORS; ++i)
        if (z[i] * instance->side[i] > 0.0) instance->counted_from[i] = 0.0;
}
