/* The pair of Dormand and Prince of orders 5 and 4. Its error bounds the indicators too: where an indicator bends and the motion does not, a
   step that passed several of its zeros would see none. */

/* the part of the size of an indicator, or of its change, that its error may have */
#define OF_INDICATOR 1e-3

/* one step from the state; nonzero where a stage has no rates; the error in units of the tolerance */
static int try_step(Instance *instance, double h, double *after, double *error)
{
    static const double c[7] = {0.0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1.0, 1.0};
    static const double a[7][6] = {
        {0.0},
        {1.0 / 5},
        {3.0 / 40, 9.0 / 40},
        {44.0 / 45, -56.0 / 15, 32.0 / 9},
        {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
        {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
        {35.0 / 384, 0.0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84},
    };
    static const double e[7] = {71.0 / 57600, 0.0, -71.0 / 16695, 71.0 / 1920, -17253.0 / 339200, 22.0 / 525, -1.0 / 40};
    double k[7][STATES], dz[7][INDICATORS + 1], first[INDICATORS + 1], last[INDICATORS + 1], y[STATES];
    for (int stage = 0; stage < 7; ++stage) {
        for (int i = 0; i < STATES; ++i) {
            y[i] = instance->y[i];
            for (int j = 0; j < stage; ++j) y[i] += h * a[stage][j] * k[j][i];
        }
        const double time = instance->time + c[stage] * h;
        if (rates_of(instance, time, y, k[stage])) return 1;
        indicators_along(time, y, y + COORDINATES, &instance->p, instance->s, 1.0, k[stage], k[stage] + COORDINATES, &unchanged, dz[stage]);
    }
    *error = 0.0;
    for (int i = 0; i < STATES; ++i) {
        double part = 0.0;
        for (int stage = 0; stage < 7; ++stage) part += e[stage] * k[stage][i];
        const double size = fmax(fabs(y[i]), fabs(instance->y[i]));
        *error = fmax(*error, fabs(h * part) / (instance->tolerance * (1.0 + size)));
        after[i] = y[i];
    }
    indicators(instance->time, instance->y, speeds(instance), &instance->p, instance->s, first);
    indicators(instance->time + h, y, y + COORDINATES, &instance->p, instance->s, last);
    for (int i = 0; i < INDICATORS; ++i) {
        double part = 0.0, size = fmax(fabs(first[i]), fabs(last[i]));
        for (int stage = 0; stage < 7; ++stage) {
            part += e[stage] * dz[stage][i];
            size = fmax(size, fabs(h * dz[stage][i]));
        }
        if (size > 0.0) *error = fmax(*error, fabs(h * part) / (OF_INDICATOR * size));
    }
    return isfinite(*error) ? 0 : 1;
}
