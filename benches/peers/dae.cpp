// SUNDIALS and RADAU5 on exported C, driven by run.py: one line a run, `METHOD TOLERANCE`, answered by the nanoseconds of a run (the
// median of several) and its last state. Compiled with -O3 -march=native; -DDAE where the model has constraints, -DRADAU5 as installed.
//
// CVODE and RADAU5 take the ordinary differential equations (rates.h). IDA and RADAU5 take residuals with multipliers (dae.h): `index1`
// has constraints differentiated to accelerations, `index2` those of positions and of speeds (Gear, Gupta, Leimkuhler). All have exact
// Jacobians and dense elimination. RADAU5 is Hairer's and Wanner's Fortran; its mass matrix is constant, so accelerations are unknowns there.

#include "rates.h"
#ifdef DAE
#include "dae.h"
#endif

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include <cvode/cvode.h>
#include <ida/ida.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

using Clock = std::chrono::steady_clock;
using State = std::vector<double>;

static const long MOST_STEPS = 1000000;
static const double NO_BOUND = 1e10;
static double end_time;
static size_t n;

static double nanoseconds(Clock::time_point begin) {
    return std::chrono::duration<double, std::nano>(Clock::now() - begin).count();
}

// One run of SUNDIALS: its vectors, matrix and solver.
struct Room {
    SUNContext context;
    N_Vector y, dy, id, bounds;
    SUNMatrix matrix;
    SUNLinearSolver solver;
    explicit Room(size_t size) {
        SUNContext_Create(nullptr, &context);
        y = N_VNew_Serial(size, context), dy = N_VNew_Serial(size, context);
        id = N_VNew_Serial(size, context), bounds = N_VNew_Serial(size, context);
        matrix = SUNDenseMatrix(size, size, context);
        solver = SUNLinSol_Dense(y, matrix, context);
    }
    ~Room() {
        SUNLinSolFree(solver), SUNMatDestroy(matrix);
        N_VDestroy(y), N_VDestroy(dy), N_VDestroy(id), N_VDestroy(bounds);
        SUNContext_Free(&context);
    }
};

// CVODE

static int cvode_rates(realtype, N_Vector y, N_Vector dy, void *) {
    rates(N_VGetArrayPointer(y), N_VGetArrayPointer(dy));
    return 0;
}

static int cvode_jacobian(realtype, N_Vector y, N_Vector, SUNMatrix matrix, void *, N_Vector, N_Vector, N_Vector) {
    static std::vector<double> rows;
    rows.resize(n * n);
    jacobian(N_VGetArrayPointer(y), rows.data());
    for (size_t j = 0; j < n; ++j)
        for (size_t i = 0; i < n; ++i) SM_COLUMN_D(matrix, j)[i] = rows[i * n + j];
    return 0;
}

static bool run_cvode(int kind, double tolerance, State &state) {
    Room room(n);
    std::copy(state.begin(), state.end(), N_VGetArrayPointer(room.y));
    void *memory = CVodeCreate(kind, room.context);
    CVodeInit(memory, cvode_rates, 0.0, room.y);
    CVodeSStolerances(memory, tolerance, tolerance);
    CVodeSetErrFile(memory, nullptr);
    CVodeSetMaxNumSteps(memory, MOST_STEPS);
    CVodeSetLinearSolver(memory, room.solver, room.matrix);
    CVodeSetJacFn(memory, cvode_jacobian);
    CVodeSetStopTime(memory, end_time);
    double t = 0.0;
    const bool reached = CVode(memory, end_time, room.y, &t, CV_NORMAL) >= 0;
    std::copy_n(N_VGetArrayPointer(room.y), n, state.begin());
    CVodeFree(&memory);
    return reached;
}

#ifdef DAE
static const size_t SHARED = NQ + NU;

// One form of the equations with multipliers.
struct Form {
    size_t unknowns, entries;
    const int *rows, *columns;
    void (*residual)(const double *, double *);
    void (*slopes)(const double *, double *);
    std::vector<double> inputs, values;

    void at(double t, const double *y, const double *dy) {
        inputs.resize(2 * unknowns + 1);
        std::copy_n(y, unknowns, inputs.begin());
        inputs[unknowns] = t;
        std::copy_n(dy, unknowns, inputs.begin() + unknowns + 1);
    }
    void entries_at(double t, const double *y, const double *dy) {
        at(t, y, dy);
        values.resize(entries);
        slopes(inputs.data(), values.data());
    }
};

static Form index1_form{index1_n, index1_entries, index1_rows, index1_columns, index1, index1_slopes, {}, {}};
#ifdef HAS_INDEX2
static Form index2_form{index2_n, index2_entries, index2_rows, index2_columns, index2, index2_slopes, {}, {}};
#endif

// Solves a dense system in place by elimination with pivots; the solution stands in `right`.
static void eliminate(std::vector<State> matrix, State &right) {
    const size_t size = right.size();
    for (size_t k = 0; k < size; ++k) {
        size_t best = k;
        for (size_t i = k; i < size; ++i)
            if (std::fabs(matrix[i][k]) > std::fabs(matrix[best][k])) best = i;
        std::swap(matrix[k], matrix[best]), std::swap(right[k], right[best]);
        for (size_t i = k + 1; i < size; ++i) {
            const double factor = matrix[i][k] / matrix[k][k];
            for (size_t j = k; j < size; ++j) matrix[i][j] -= factor * matrix[k][j];
            right[i] -= factor * right[k];
        }
    }
    for (size_t k = size; k-- > 0;) {
        for (size_t j = k + 1; j < size; ++j) right[k] -= matrix[k][j] * right[j];
        right[k] /= matrix[k][k];
    }
}

// Rates of the start and its multipliers: the first form is linear in them.
static void consistent(const State &start, State &y, State &dy) {
    Form &form = index1_form;
    const size_t size = form.unknowns;
    y.assign(size, 0.0), dy.assign(size, 0.0);
    std::copy_n(start.begin(), SHARED, y.begin());
    form.entries_at(0.0, y.data(), dy.data());
    std::vector<State> matrix(size, State(size, 0.0));
    for (size_t k = 0; k < form.entries; ++k) {
        const size_t row = form.rows[k], column = form.columns[k];
        // rates of q and u, then multipliers themselves
        if (column >= size && column - size < SHARED) matrix[row][column - size] = form.values[k];
        if (column >= SHARED && column < size) matrix[row][column] = form.values[k];
    }
    State right(size);
    form.residual(form.inputs.data(), right.data());
    for (double &each : right) each = -each;
    eliminate(matrix, right);
    std::copy_n(right.begin(), SHARED, dy.begin());
    std::copy(right.begin() + SHARED, right.end(), y.begin() + SHARED);
}

// IDA

static int ida_residual(realtype t, N_Vector y, N_Vector dy, N_Vector out, void *data) {
    Form &form = *static_cast<Form *>(data);
    form.at(t, N_VGetArrayPointer(y), N_VGetArrayPointer(dy));
    form.residual(form.inputs.data(), N_VGetArrayPointer(out));
    return 0;
}

static int ida_jacobian(realtype t, realtype factor, N_Vector y, N_Vector dy, N_Vector, SUNMatrix matrix, void *data, N_Vector, N_Vector, N_Vector) {
    Form &form = *static_cast<Form *>(data);
    form.entries_at(t, N_VGetArrayPointer(y), N_VGetArrayPointer(dy));
    SUNMatZero(matrix);
    for (size_t k = 0; k < form.entries; ++k) {
        const size_t column = form.columns[k];
        const bool is_rate = column >= form.unknowns;
        SM_ELEMENT_D(matrix, form.rows[k], is_rate ? column - form.unknowns : column) += (is_rate ? factor : 1.0) * form.values[k];
    }
    return 0;
}

static bool run_ida(Form &form, double tolerance, State &state) {
    Room room(form.unknowns);
    State y, dy;
    consistent(state, y, dy);
    y.resize(form.unknowns, 0.0), dy.resize(form.unknowns, 0.0);
    std::copy(y.begin(), y.end(), N_VGetArrayPointer(room.y));
    std::copy(dy.begin(), dy.end(), N_VGetArrayPointer(room.dy));
    for (size_t k = 0; k < form.unknowns; ++k) N_VGetArrayPointer(room.id)[k] = k < SHARED ? 1.0 : 0.0;
    void *memory = IDACreate(room.context);
    IDAInit(memory, ida_residual, 0.0, room.y, room.dy);
    // multipliers of a residual of index 2 change as 1/h from one iterate to the next, and none is compared
    for (size_t k = 0; k < form.unknowns; ++k) N_VGetArrayPointer(room.bounds)[k] = k < SHARED ? tolerance : NO_BOUND;
    IDASVtolerances(memory, tolerance, room.bounds);
    IDASetErrFile(memory, nullptr);
    IDASetUserData(memory, &form);
    IDASetMaxNumSteps(memory, MOST_STEPS);
    IDASetId(memory, room.id);
    // as the manual advises beyond index 1; multipliers are not compared in any case
    IDASetSuppressAlg(memory, 1);
    IDASetLinearSolver(memory, room.solver, room.matrix);
    IDASetJacFn(memory, ida_jacobian);
    IDASetStopTime(memory, end_time);
    double t = 0.0;
    const bool reached = IDASolve(memory, end_time, &t, room.y, room.dy, IDA_NORMAL) >= 0;
    std::copy_n(N_VGetArrayPointer(room.y), SHARED, state.begin());
    IDAFree(&memory);
    return reached;
}
#endif

#ifdef RADAU5
using Rates = void(int *, double *, double *, double *, double *, int *);
using Slopes = void(int *, double *, double *, int *, int *, double *, int *, double *, int *);
using Mass = void(int *, double *, int *, double *, int *);
using Output = void(int *, double *, double *, double *, double *, int *, int *, double *, int *, int *);
extern "C" {
void radau5_(int *, Rates *, double *, double *, double *, double *, double *, double *, int *, Slopes *, int *, int *, int *, Mass *, int *,
             int *, int *, Output *, int *, double *, int *, int *, int *, double *, int *, int *);
// what the library of Debian asks of R, where it prints
int R_NilValue, R_NaString, R_NamesSymbol;
double R_NaReal;
void rexit_() {}
void intpr_() {}
void dblepr_() {}
void Rprintf(const char *, ...) {}
}

static void ode_rates(int *, double *, double *y, double *dy, double *, int *) { rates(y, dy); }

static void ode_slopes(int *, double *, double *y, int *, int *, double *out, int *lead, double *, int *) {
    static State rows;
    rows.resize(n * n);
    jacobian(y, rows.data());
    for (size_t j = 0; j < n; ++j)
        for (size_t i = 0; i < n; ++i) out[i + j * *lead] = rows[i * n + j];
}

static void no_output(int *, double *, double *, double *, double *, int *, int *, double *, int *, int *) {}

#ifdef DAE
static Form *radau_form;
static State of_residual, no_rates;

// y is q, u, a, then multipliers: q' and u' are explicit, the rest is algebraic.
static void split(const double *y, State &unknowns, State &slopes) {
    const size_t size = radau_form->unknowns;
    unknowns.resize(size), slopes.assign(size, 0.0);
    std::copy_n(y, SHARED, unknowns.begin());
    std::copy_n(y + SHARED, NU, slopes.begin() + NQ);
    std::copy_n(y + SHARED + NU, size - SHARED, unknowns.begin() + SHARED);
}

static void dae_rates(int *, double *t, double *y, double *dy, double *, int *) {
    static State unknowns, slopes;
    split(y, unknowns, slopes);
    radau_form->at(*t, unknowns.data(), slopes.data());
    of_residual.resize(radau_form->unknowns);
    radau_form->residual(radau_form->inputs.data(), of_residual.data());
    for (size_t k = 0; k < NQ; ++k) dy[k] = -of_residual[k];
    std::copy_n(y + SHARED, NU, dy + NQ);
    std::copy(of_residual.begin() + NQ, of_residual.end(), dy + SHARED);
}

static void dae_slopes(int *size, double *t, double *y, int *, int *, double *out, int *lead, double *, int *) {
    static State unknowns, slopes;
    split(y, unknowns, slopes);
    Form &form = *radau_form;
    form.entries_at(*t, unknowns.data(), slopes.data());
    std::fill_n(out, static_cast<size_t>(*lead) * *size, 0.0);
    const size_t lead_size = *lead;
    for (size_t k = 0; k < form.entries; ++k) {
        size_t row = form.rows[k], column = form.columns[k];
        if (column >= form.unknowns) {
            column -= form.unknowns;
            // of q' nothing is left, u' is the unknown a
            if (column < NQ) continue;
            column = SHARED + column - NQ;
        } else if (column >= SHARED) {
            column += NU;
        }
        const double sign = row < NQ ? -1.0 : 1.0;
        row = row < NQ ? row : row + NU;
        out[row + column * lead_size] += sign * form.values[k];
    }
    for (size_t k = 0; k < NU; ++k) out[NQ + k + (SHARED + k) * lead_size] = 1.0;
}

static void dae_mass(int *size, double *out, int *lead, double *, int *) {
    for (int k = 0; k < *size; ++k) out[k * *lead] = k < static_cast<int>(SHARED) ? 1.0 : 0.0;
}
#endif

static bool run_radau5(bool is_dae, double tolerance, State &state) {
    State y = state;
    int size = n, full = size, scalar = 0, given = 1, has_mass = 0, mass_band = 0, silent = 0, outcome = 0, idle[1] = {0};
    Rates *law = ode_rates;
    Slopes *slopes = ode_slopes;
    Mass *mass = nullptr;
    std::vector<int> integers;
#ifdef DAE
    if (is_dae) {
        State held, dy;
        consistent(state, held, dy);
        held.resize(radau_form->unknowns, 0.0);
        y.assign(held.begin(), held.begin() + SHARED);
        y.insert(y.end(), dy.begin() + NQ, dy.begin() + SHARED);
        y.insert(y.end(), held.begin() + SHARED, held.end());
        size = full = y.size(), has_mass = 1;
        law = dae_rates, slopes = dae_slopes, mass = dae_mass;
    }
#endif
    integers.assign(3 * size + 20, 0);
    integers[0] = is_dae ? 0 : 1;
    integers[1] = MOST_STEPS;
#ifdef DAE
    if (is_dae) {
        const bool is_second = radau_form != &index1_form;
        integers[4] = is_second ? SHARED : size;
        integers[5] = is_second ? size - SHARED : 0;
    }
#endif
    int reals_size = size * (4 * size + 12 + (has_mass ? 1 : 0)) + size + 20, integers_size = integers.size();
    State reals(reals_size, 0.0);
    double t = 0.0, end = end_time, step = 1e-6 * end_time, relative = tolerance, absolute = tolerance, data[1] = {0.0};
    radau5_(&size, law, &t, y.data(), &end, &step, &relative, &absolute, &scalar, slopes, &given, &full, &full, mass, &has_mass, &mass_band,
            &mass_band, no_output, &silent, reals.data(), &reals_size, integers.data(), &integers_size, data, idle, &outcome);
    std::copy_n(y.begin(), std::min(state.size(), y.size()), state.begin());
    return outcome > 0;
}
#endif

static bool run(const std::string &method, double tolerance, State &y) {
    if (method == "cvode_adams") return run_cvode(CV_ADAMS, tolerance, y);
    if (method == "cvode_bdf") return run_cvode(CV_BDF, tolerance, y);
#ifdef RADAU5
    if (method == "radau5_ode") return run_radau5(false, tolerance, y);
#endif
#ifdef DAE
    Form *form = method.find("index1") != std::string::npos ? &index1_form : nullptr;
#ifdef HAS_INDEX2
    if (method.find("index2") != std::string::npos) form = &index2_form;
#endif
    if (form && method.rfind("ida", 0) == 0) return run_ida(*form, tolerance, y);
#ifdef RADAU5
    radau_form = form;
    if (form && method.rfind("radau5", 0) == 0) return run_radau5(true, tolerance, y);
#endif
#endif
    return false;
}

int main(int, char **arguments) {
    end_time = std::stod(arguments[1]);
    State start;
    for (char **argument = arguments + 2; *argument; ++argument) start.push_back(std::stod(*argument));
    n = start.size();
    for (std::string line; std::getline(std::cin, line);) {
        std::istringstream words(line);
        std::string method;
        double tolerance = 0.0;
        if (!(words >> method >> tolerance)) continue;
        State y;
        bool reached = false;
        std::vector<double> times;
        const auto all = Clock::now();
        do {
            y = start;
            const auto begin = Clock::now();
            reached = run(method, tolerance, y);
            times.push_back(nanoseconds(begin));
        } while (times.size() < 25 && nanoseconds(all) < 1e7);
        // to others the time is a state: it has no error
        if (y.size() > 0 && reached && method.find("index") != std::string::npos)
            for (size_t k = 0; k < y.size(); ++k)
#ifdef DAE
                if (k >= SHARED) y[k] = end_time;
#else
                ;
#endif
        std::sort(times.begin(), times.end());
        printf("%.0f", times[times.size() / 2]);
        for (size_t i = 0; reached && i < n; ++i) printf(" %.17g", y[i]);
        printf("\n");
        fflush(stdout);
    }
}
