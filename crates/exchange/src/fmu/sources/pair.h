/* The pair of Dormand and Prince of orders 5 and 4. */

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
    double k[7][STATES], y[STATES];
    for (int stage = 0; stage < 7; ++stage) {
        for (int i = 0; i < STATES; ++i) {
            y[i] = instance->y[i];
            for (int j = 0; j < stage; ++j) y[i] += h * a[stage][j] * k[j][i];
        }
        if (rates_of(instance, instance->time + c[stage] * h, y, k[stage])) return 1;
    }
    *error = 0.0;
    for (int i = 0; i < STATES; ++i) {
        double part = 0.0;
        for (int stage = 0; stage < 7; ++stage) part += e[stage] * k[stage][i];
        const double size = fmax(fabs(y[i]), fabs(instance->y[i]));
        *error = fmax(*error, fabs(h * part) / (instance->tolerance * (1.0 + size)));
        after[i] = y[i];
    }
    return isfinite(*error) ? 0 : 1;
}
