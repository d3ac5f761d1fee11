// Nanoseconds a call of `value`, `by_hand` and `jacobian`, medians; each call depends on the one before.

typedef void (*Law)(const double *, double *);

static int ascending(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double nanoseconds(Law law) {
    double y[N], out[N * N], times[REPEATS];
    for (int i = 0; i < N; i++) y[i] = 0.1 + 0.05 * i;
    for (int repeat = 0; repeat < REPEATS; repeat++) {
        struct timespec start, end;
        clock_gettime(CLOCK_MONOTONIC, &start);
        for (int call = 0; call < CALLS; call++) {
            law(y, out);
            y[0] += out[0] * 1e-15;
        }
        clock_gettime(CLOCK_MONOTONIC, &end);
        times[repeat] = ((end.tv_sec - start.tv_sec) * 1e9 + (end.tv_nsec - start.tv_nsec)) / CALLS;
    }
    qsort(times, REPEATS, sizeof(double), ascending);
    return times[REPEATS / 2];
}

int main(void) {
    double y[N], exported[N], own[N], off = 0;
    for (int i = 0; i < N; i++) y[i] = 0.1 + 0.05 * i;
    fold();
    value(y, exported);
    by_hand(y, own);
    for (int i = 0; i < N; i++) off = fmax(off, fabs(exported[i] - own[i]) / fmax(1, fabs(own[i])));
    printf("%g %g %g %g\n", nanoseconds(value), nanoseconds(by_hand), nanoseconds(jacobian), off);
    return 0;
}
