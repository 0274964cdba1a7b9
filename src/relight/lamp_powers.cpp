// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/lamp_powers.h"

#include "base/loaded_library.h"
#include "text/message.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace candelabra {

namespace {

/// How near to its bound a value counts as tight, and how far from it as missed, in terms of it.
constexpr double close_to = 1e-6;

const Solver* the_solver(Diagnostics& diagnostics) {
    static const LoadedFunction library = load_function(solver_library, solver_function);
    if (!library.address) {
        diagnostics.add(error(Fault::io, {},
                              message("the solver of powers cannot be opened: ", library.problem)));
        return nullptr;
    }
    static const Solver* const solver = reinterpret_cast<const Solver* (*)()>(library.address)();
    return solver;
}

/// A value that is bounded, as a sum over the lamps.
struct BoundedValue {
    std::size_t demand, point;
    std::vector<double> factors;
    double fixed = 0;

    double at(const std::vector<double>& powers) const {
        double sum = fixed;
        for (std::size_t i = 0; i < factors.size(); ++i) sum += factors[i] * powers[i];
        return sum;
    }
};

/// The values that the demands bound, by one half of the samples.
std::vector<BoundedValue> values_of(const PowerProblem& problem, const LightAtPoints& light) {
    std::vector<BoundedValue> values;
    for (std::size_t d = 0; d < problem.demands.size(); ++d) {
        const LightDemand& demand = problem.demands[d];
        const double share = demand.of_mean ? 1 / static_cast<double>(demand.count) : 1;
        for (std::size_t i = demand.first; i < demand.first + demand.count; ++i) {
            if (!demand.of_mean || i == demand.first)
                values.push_back({d, i, std::vector<double>(problem.lamps, 0)});
            BoundedValue& value = values.back();
            value.fixed += share * light.fixed[i];
            for (std::size_t k = 0; k < problem.lamps; ++k)
                value.factors[k] += share * light.by_lamp[i * problem.lamps + k];
        }
    }
    return values;
}

/// The lamps whose light may be nothing but luck: a sample or two that found a far lamp would have
/// it replace all others.
std::vector<std::size_t> unknown_lamps(const PowerProblem& problem) {
    std::vector<bool> asked(problem.halves[0].fixed.size());
    for (const LightDemand& demand : problem.demands)
        for (std::size_t i = demand.first; i < demand.first + demand.count; ++i) asked[i] = true;
    std::vector<std::size_t> unknown;
    for (std::size_t k = 0; k < problem.lamps; ++k) {
        double off = 0, sum = 0;
        for (std::size_t i = 0; i < asked.size(); ++i) {
            if (!asked[i]) continue;
            const double one = problem.halves[0].by_lamp[i * problem.lamps + k],
                         other = problem.halves[1].by_lamp[i * problem.lamps + k];
            off += std::abs(one - other);
            sum += std::abs(one + other);
        }
        constexpr double errors = 2;
        if (errors * off > sum) unknown.push_back(k);
    }
    return unknown;
}

/// A programme whose columns are the lamps and then, if wanted, what each demanded value may lack
/// and exceed, in terms of its bound.
LinearProgramme programme_of(const PowerProblem& problem, const std::vector<BoundedValue>& values,
                             std::span<const std::size_t> unknown, bool elastic) {
    LinearProgramme made;
    made.costs = problem.costs;
    if (elastic) std::ranges::fill(made.costs, 0);
    made.most.assign(problem.lamps, problem.most);
    for (const std::size_t lamp : unknown) made.most[lamp] = 0;
    const std::size_t spare = elastic ? values.size() : 0;
    made.costs.resize(problem.lamps + spare, 1);
    made.most.resize(problem.lamps + spare, LinearProgramme::unbounded);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const LightDemand& demand = problem.demands[values[i].demand];
        const auto add = [&](double low, double high, double slack) {
            made.rows.push_back(
                {values[i].factors, low, high, elastic ? slack : 0, problem.lamps + i});
        };
        const double fixed = values[i].fixed;
        if (demand.low > 0) add(demand.low - fixed, LinearProgramme::unbounded, demand.low);
        if (std::isfinite(demand.high))
            add(-LinearProgramme::unbounded, demand.high - fixed, -std::max(demand.high, 1e-9));
    }
    return made;
}

/// Lets each bound be missed by as much as it has to be.
void relax(LinearProgramme& programme, const LinearProgramme& elastic,
           const std::vector<double>& x) {
    for (std::size_t r = 0; r < programme.rows.size(); ++r) {
        const LinearProgramme::Row& missed = elastic.rows[r];
        const double slack = missed.slack * x[missed.slack_column];
        const double room = std::abs(missed.slack) * close_to / 100;
        if (slack > 0) programme.rows[r].low -= slack + room;
        if (slack < 0) programme.rows[r].high -= slack - room;
    }
}

bool all_finite(const std::vector<double>& values) {
    return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

void judge(const PowerProblem& problem, const std::vector<BoundedValue>& values,
           SolvedPowers& made) {
    const std::vector<BoundedValue> others = values_of(problem, problem.halves[1]);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const LightDemand& demand = problem.demands[values[i].demand];
        const double solved = values[i].at(made.powers), judged = others[i].at(made.powers);
        const auto add = [&](bool upper, double bound) {
            if (bound > 0) made.gap = std::max(made.gap, std::abs(judged - solved) / bound);
            const double over = (upper ? solved - bound : bound - solved) / std::max(bound, 1e-9);
            const bool missed = over > close_to, tight = !missed && over > -close_to;
            made.met = made.met && !missed;
            made.bounds.push_back(
                {values[i].demand, values[i].point, upper, bound, solved, judged, tight, missed});
        };
        if (demand.low > 0) add(false, demand.low);
        if (std::isfinite(demand.high)) add(true, demand.high);
    }
}

}  // namespace

SolvedPowers solved(const PowerProblem& problem, Diagnostics& diagnostics) {
    SolvedPowers made;
    const Solver* const solver = the_solver(diagnostics);
    if (!solver) return made;
    for (const LightAtPoints& half : problem.halves)
        if (!all_finite(half.fixed) || !all_finite(half.by_lamp)) {
            diagnostics.add(error(Fault::domain, {}, "the light at a meter is not finite"));
            return made;
        }
    const std::vector<BoundedValue> values = values_of(problem, problem.halves[0]);
    made.unknown = unknown_lamps(problem);
    LinearProgramme programme = programme_of(problem, values, made.unknown, false);
    std::string trouble = solver->minimise(programme, made.powers);
    if (!trouble.empty()) {
        const LinearProgramme elastic = programme_of(problem, values, made.unknown, true);
        std::vector<double> x;
        trouble = solver->minimise(elastic, x);
        if (trouble.empty()) {
            relax(programme, elastic, x);
            // At the edge of what can be met, the powers found so far are as good.
            if (!solver->minimise(programme, made.powers).empty())
                made.powers.assign(x.begin(),
                                   x.begin() + static_cast<std::ptrdiff_t>(problem.lamps));
        }
    }
    if (!trouble.empty()) {
        diagnostics.add(error(Fault::domain, {}, trouble));
        made.powers.clear();
        return made;
    }
    double all = 0;
    for (std::size_t i = 0; i < problem.lamps; ++i) {
        all += problem.costs[i];
        made.cost += problem.costs[i] * made.powers[i];
    }
    if (all > 0) made.cost /= all;
    judge(problem, values, made);
    return made;
}

}  // namespace candelabra
