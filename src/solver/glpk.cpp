// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/linear_programme.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <glpk.h>

namespace candelabra {

namespace {

/// GLPK's kind of a bound with these ends.
int kind_of(double low, double high) {
    const bool below = std::isfinite(low), above = std::isfinite(high);
    if (below && above) return low == high ? GLP_FX : GLP_DB;
    return below ? GLP_LO : above ? GLP_UP : GLP_FR;
}

double finite(double bound) { return std::isfinite(bound) ? bound : 0; }

void add_row(glp_prob& problem, const LinearProgramme::Row& row) {
    const int number = glp_add_rows(&problem, 1);
    glp_set_row_bnds(&problem, number, kind_of(row.low, row.high), finite(row.low),
                     finite(row.high));
    std::vector<int> columns = {0};  // GLPK counts from 1
    std::vector<double> factors = {0};
    for (std::size_t i = 0; i < row.factors.size(); ++i)
        if (row.factors[i] != 0) {
            columns.push_back(static_cast<int>(i) + 1);
            factors.push_back(row.factors[i]);
        }
    if (row.slack != 0) {
        columns.push_back(static_cast<int>(row.slack_column) + 1);
        factors.push_back(row.slack);
    }
    glp_set_mat_row(&problem, number, static_cast<int>(columns.size()) - 1, columns.data(),
                    factors.data());
}

std::string minimise(const LinearProgramme& programme, std::vector<double>& x) {
    glp_term_out(GLP_OFF);
    const std::unique_ptr<glp_prob, decltype(&glp_delete_prob)> problem(glp_create_prob(),
                                                                        &glp_delete_prob);
    glp_set_obj_dir(problem.get(), GLP_MIN);
    for (std::size_t i = 0; i < programme.costs.size(); ++i) {
        const int column = glp_add_cols(problem.get(), 1);
        glp_set_obj_coef(problem.get(), column, programme.costs[i]);
        glp_set_col_bnds(problem.get(), column, kind_of(0, programme.most[i]), 0,
                         finite(programme.most[i]));
    }
    for (const LinearProgramme::Row& row : programme.rows) add_row(*problem, row);
    glp_smcp control;
    glp_init_smcp(&control);
    control.msg_lev = GLP_MSG_OFF;
    control.tol_bnd = control.tol_dj = 1e-9;
    const std::size_t size = programme.rows.size() + programme.costs.size();
    control.it_lim = static_cast<int>(std::min<std::size_t>(1000 + 100 * size, 1'000'000'000));
    glp_scale_prob(problem.get(), GLP_SF_GM | GLP_SF_EQ | GLP_SF_2N);
    glp_adv_basis(problem.get(), 0);
    if (glp_simplex(problem.get(), &control) != 0)
        return "the solver of linear programmes found no end";
    if (glp_get_status(problem.get()) != GLP_OPT) return "there is no solution";
    x.resize(programme.costs.size());
    for (std::size_t i = 0; i < x.size(); ++i)
        x[i] = std::fmax(0, glp_get_col_prim(problem.get(), static_cast<int>(i) + 1));
    return {};
}

}  // namespace

extern "C" const Solver* candelabra_solver() {
    static constexpr Solver entries{&minimise};
    return &entries;
}

}  // namespace candelabra
