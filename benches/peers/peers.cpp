// Peers in C and C++ on an exported right-hand side, driven by run.py: one line a run, `METHOD TOLERANCE`, answered by
// the nanoseconds of a run (the median of several) and its last state. Compiled with -O3 -march=native, -DGSL and -DODEINT as installed.

#include "rates.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>
#ifdef GSL
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#endif
#ifdef ODEINT
#include <boost/numeric/odeint.hpp>
#include <boost/numeric/ublas/matrix.hpp>
#include <boost/numeric/ublas/vector.hpp>
#endif

#ifdef CASADI
extern "C" int casadi_jacobian(const double **arguments, double **results, long long *, double *room, int);
#endif

using Clock = std::chrono::steady_clock;
using State = std::vector<double>;

static double nanoseconds(Clock::time_point begin) {
    return std::chrono::duration<double, std::nano>(Clock::now() - begin).count();
}

static size_t n;

#ifdef GSL
static int gsl_rates(double, const double *y, double *dy, void *) {
    rates(y, dy);
    return GSL_SUCCESS;
}

static int gsl_jacobian(double, const double *y, double *dfdy, double *dfdt, void *) {
    jacobian(y, dfdy);
    for (size_t i = 0; i < n; ++i) dfdt[i] = 0.0;
    return GSL_SUCCESS;
}

static bool run_gsl(const std::string &method, double tolerance, double end, State &y) {
    const gsl_odeiv2_step_type *type = method == "gsl_bsimp"   ? gsl_odeiv2_step_bsimp
                                       : method == "gsl_rk8pd" ? gsl_odeiv2_step_rk8pd
                                       : method == "gsl_msbdf" ? gsl_odeiv2_step_msbdf
                                                               : nullptr;
    if (!type) return false;
    gsl_odeiv2_system system = {gsl_rates, gsl_jacobian, n, nullptr};
    gsl_odeiv2_driver *driver = gsl_odeiv2_driver_alloc_y_new(&system, type, 1e-6, tolerance, tolerance);
    gsl_odeiv2_driver_set_nmax(driver, 300000);
    double t = 0.0;
    bool reached = gsl_odeiv2_driver_apply(driver, &t, end, y.data()) == GSL_SUCCESS;
    gsl_odeiv2_driver_free(driver);
    return reached;
}
#endif

#ifdef ODEINT
namespace odeint = boost::numeric::odeint;
namespace ublas = boost::numeric::ublas;

static bool run_odeint(const std::string &method, double tolerance, double end, State &y) {
    auto law = [](const State &y, State &dy, double) { rates(y.data(), dy.data()); };
    if (method == "odeint_dopri5") {
        auto stepper = odeint::make_controlled<odeint::runge_kutta_dopri5<State>>(tolerance, tolerance);
        odeint::integrate_adaptive(stepper, law, y, 0.0, end, 1e-6);
    } else if (method == "odeint_fehlberg78") {
        auto stepper = odeint::make_controlled<odeint::runge_kutta_fehlberg78<State>>(tolerance, tolerance);
        odeint::integrate_adaptive(stepper, law, y, 0.0, end, 1e-6);
    } else if (method == "odeint_bulirsch_stoer") {
        odeint::bulirsch_stoer<State> stepper(tolerance, tolerance);
        odeint::integrate_adaptive(stepper, law, y, 0.0, end, 1e-6);
    } else if (method == "odeint_rosenbrock4") {
        using Vector = ublas::vector<double>;
        using Matrix = ublas::matrix<double>;
        auto stiff = [](const Vector &y, Vector &dy, double) { rates(&y[0], &dy[0]); };
        auto slopes = [](const Vector &y, Matrix &j, double, Vector &dfdt) {
            jacobian(&y[0], &j.data()[0]);
            dfdt.clear();
        };
        Vector state(n);
        std::copy(y.begin(), y.end(), state.begin());
        auto stepper = odeint::make_controlled<odeint::rosenbrock4<double>>(tolerance, tolerance);
        odeint::integrate_adaptive(stepper, std::make_pair(stiff, slopes), state, 0.0, end, 1e-6);
        std::copy(state.begin(), state.end(), y.begin());
    } else {
        return false;
    }
    return true;
}
#endif

// Nanoseconds of one evaluation; each depends on the one before.
static double evaluations(const std::string &what, const State &start) {
    const int calls = 20000;
    State y = start, dy(n), matrix(n * n), room(1 << 16);
    auto begin = Clock::now();
    for (int k = 0; k < calls; ++k) {
        if (what == "rates") {
            rates(y.data(), dy.data());
            y[0] = start[0] + 1e-15 * dy[0];
#ifdef CASADI
        } else if (what == "casadi") {
            const double *arguments[] = {y.data()};
            double *results[] = {matrix.data()};
            casadi_jacobian(arguments, results, nullptr, room.data(), 0);
            y[0] = start[0] + 1e-15 * matrix[n];
#endif
        } else {
            jacobian(y.data(), matrix.data());
            y[0] = start[0] + 1e-15 * matrix[1];
        }
    }
    return nanoseconds(begin) / calls;
}

int main(int, char **arguments) {
    const double end = std::stod(arguments[1]);
    State start;
    for (char **argument = arguments + 2; *argument; ++argument) start.push_back(std::stod(*argument));
    n = start.size();
#ifdef GSL
    gsl_set_error_handler_off();
#endif
    for (std::string line; std::getline(std::cin, line);) {
        std::istringstream words(line);
        std::string method;
        double tolerance = 0.0;
        if (!(words >> method >> tolerance)) {
            printf("%.3f\n", evaluations(method, start));
            fflush(stdout);
            continue;
        }
        State y;
        bool reached = false;
        std::vector<double> times;
        const auto all = Clock::now();
        do {
            y = start;
            reached = false;
            const auto begin = Clock::now();
            try {
#ifdef GSL
                if (method.rfind("gsl", 0) == 0) reached = run_gsl(method, tolerance, end, y);
#endif
#ifdef ODEINT
                if (method.rfind("odeint", 0) == 0) reached = run_odeint(method, tolerance, end, y);
#endif
            } catch (const std::exception &) {
                reached = false;
            }
            times.push_back(nanoseconds(begin));
        } while (times.size() < 25 && nanoseconds(all) < 1e7);
        std::sort(times.begin(), times.end());
        printf("%.0f", times[times.size() / 2]);
        for (size_t i = 0; reached && i < n; ++i) printf(" %.17g", y[i]);
        printf("\n");
        fflush(stdout);
    }
}
