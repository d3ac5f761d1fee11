// The gyrostat's second form as one would write it by hand for speed: data folded beforehand, no division, the bars side by
// side. The data A, AXIS, GE, AXIAL, ... come before, from the bench.

#define WINDINGS (N > 8 ? N - 8 : 1)
static double k[3], q[3], along[WINDINGS], across[WINDINGS], decay[WINDINGS], response[WINDINGS], inverse_d, inverse_axial;

static void fold(void) {
    double d = 1;
    for (int i = 0; i < 3; i++) {
        k[i] = 1 / A[i];
        q[i] = AXIS[i] / A[i];
        d -= AXIAL * AXIS[i] * q[i];
    }
    inverse_d = 1 / d;
    inverse_axial = 1 / AXIAL;
    for (int n = 0; n < WINDINGS; n++) {
        const double t = 2 * M_PI * n / (N > 9 ? WINDINGS - 1 : 1) - M_PI / 4;
        along[n] = n ? -A2 * cos(t) : 0;
        across[n] = n ? A2 * sin(t) : -A1;
        response[n] = 1 / (n ? L2 : L1);
        decay[n] = (n ? R2 : R1) * response[n];
    }
}

__attribute__((noinline)) void by_hand(const double *y, double *dy) {
    double s, c;
    sincos(y[6], &s, &c);
    const double slip = y[7], speed = slip + FIELD_SPEED, h = AXIAL * speed;
    double moment = -B0 * s - MU * slip - F * speed;
#if N > 8
    double torque[WINDINGS];
    for (int n = 0; n < WINDINGS; n++) {
        const double coupling = along[n] * c + across[n] * s;
        torque[n] = coupling * y[8 + n];
        dy[8 + n] = -(decay[n] * y[8 + n] + response[n] * (coupling * slip));
    }
    moment += ((torque[0] + torque[1]) + (torque[2] + torque[3])) + ((torque[4] + torque[5]) + torque[6]);
#endif
    const double x0 = A[0] * y[0] + AXIS[0] * h, x1 = A[1] * y[1] + AXIS[1] * h, x2 = A[2] * y[2] + AXIS[2] * h;
    const double f0 = x1 * y[2] - x2 * y[1] + (GE[1] * y[5] - GE[2] * y[4]);
    const double f1 = x2 * y[0] - x0 * y[2] + (GE[2] * y[3] - GE[0] * y[5]);
    const double f2 = x0 * y[1] - x1 * y[0] + (GE[0] * y[4] - GE[1] * y[3]);
    const double turn = inverse_d * (moment * inverse_axial - (q[0] * f0 + q[1] * f1 + q[2] * f2)), back = AXIAL * turn;
    dy[0] = k[0] * f0 - q[0] * back;
    dy[1] = k[1] * f1 - q[1] * back;
    dy[2] = k[2] * f2 - q[2] * back;
    dy[3] = y[4] * y[2] - y[5] * y[1];
    dy[4] = y[5] * y[0] - y[3] * y[2];
    dy[5] = y[3] * y[1] - y[4] * y[0];
    dy[6] = slip;
    dy[7] = turn;
}
