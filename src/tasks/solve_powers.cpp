// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/solve_powers.h"

#include "meter/places.h"
#include "output/estimates.h"
#include "output/layers.h"
#include "output/measurement.h"
#include "picture/file.h"
#include "relight/lamp_names.h"
#include "relight/lamp_powers.h"
#include "relight/world_lamps.h"
#include "render/measure.h"
#include "tasks/measuring.h"
#include "text/message.h"
#include "text/nearest.h"
#include "text/printable.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

namespace candelabra {

namespace {

/// Values of the tables of light, of 8 bytes; a few such tables are in memory together.
constexpr std::size_t most_products = 1'000'000;
/// Bounds that the report names of a kind.
constexpr std::size_t most_named = 10;

/// Rounding of sums, in terms of them.
constexpr double rounding = 1e-9;

/// The powers that are sought.
struct PowerColumns {
    std::vector<std::string> names;
    std::vector<double> costs;
    std::vector<std::uint32_t> of_place;  ///< the column of each lamp of the list
};

/// The meters of the scene that the demands name, each once. `which`: of each demand, its meter
/// there. Empty after an error has been reported.
std::vector<Meter> demanded_meters(const std::vector<Meter>& meters, const SolveRequest& request,
                                   std::vector<std::size_t>& which, Diagnostics& diagnostics) {
    std::vector<Meter> used;
    std::vector<std::string_view> names;
    std::string all;
    for (const Meter& meter : meters) {
        names.push_back(meter.name);
        if (!meter.name.empty())
            all += message(all.empty() ? "" : ", ", "`", printable(meter.name), "`");
    }
    const auto refuse = [&](Fault fault, std::string text, std::string help) {
        diagnostics.add(error(fault, {}, std::move(text)).with_help(std::move(help)));
        return std::vector<Meter>();
    };
    for (const MeterDemand& demand : request.demands) {
        const auto found = std::ranges::find(meters, demand.meter, &Meter::name);
        if (found == meters.end()) {
            const std::string meant = nearest(demand.meter, names);
            return refuse(Fault::unknown_name,
                          message("the scene has no meter `", printable(demand.meter), "`"),
                          all.empty()
                              ? "meter { \"Street\" corner <0, 0, 0> along 30*x across 7*z }"
                          : meant.empty()
                              ? "there are " + all
                              : message("did you mean `", printable(meant), "`? there are ", all));
        }
        if (unit_of(found->measures()) != "lx")
            return refuse(
                Fault::wrong_type,
                message("meter `", printable(demand.meter), "` measures ",
                        name_of(found->measures()), ", and powers are solved for light in lux"),
                "a meter of illuminance at the same points");
        const auto known = std::ranges::find(used, *found);
        which.push_back(static_cast<std::size_t>(known - used.begin()));
        if (known == used.end()) used.push_back(*found);
    }
    return used;
}

/// The columns of the wanted lamps. Reports errors.
std::optional<PowerColumns> columns_of(const WorldLamps& lamps, bool has_sky,
                                       const SolveRequest& request, Diagnostics& diagnostics) {
    const LampList& list = lamps.list;
    const auto none = static_cast<std::uint32_t>(-1);
    PowerColumns made;
    made.of_place.assign(list.size(), none);
    std::vector<bool> wanted(list.size(), request.lamps.empty());
    if (request.lamps.empty() && has_sky) wanted[lamps.of_sky] = false;
    const LampNames names(list);
    for (const std::string& name : request.lamps) {
        const auto places = names.chosen(name, diagnostics);
        if (!places) return std::nullopt;
        for (const std::uint32_t place : *places) wanted[place] = true;
    }
    for (std::size_t g = 0; g < list.groups().size(); ++g) {
        const LampGroup& group = list.groups()[g];
        bool begun = false;
        for (std::uint32_t number = 0; number < group.lamps; ++number) {
            const std::uint32_t place = list.place_of(g, number);
            if (!wanted[place]) continue;
            if (!begun || !request.together) {
                const bool whole = request.together || group.lamps == 1;
                made.names.push_back(whole ? group.name : message(group.name, "[", number, "]"));
                made.costs.push_back(0);
                begun = true;
            }
            made.of_place[place] = static_cast<std::uint32_t>(made.names.size() - 1);
            made.costs.back() += list.powers()[place];
        }
    }
    if (made.names.empty()) {
        diagnostics.add(
            error(Fault::missing, {}, "the scene has no lamps whose powers could be solved")
                .with_help("a glowing object, or a light_source"));
        return std::nullopt;
    }
    return made;
}

/// The linear programme of what the meters have read. `which`: of each demand, its meter.
PowerProblem problem_of(const SolveRequest& request, const std::vector<MeterReading>& readings,
                        const std::vector<std::size_t>& which, const PowerColumns& columns) {
    PowerProblem made;
    made.lamps = columns.names.size();
    made.costs = columns.costs;
    made.most = request.most;
    std::vector<std::size_t> firsts;
    std::size_t points = 0;
    for (const MeterReading& reading : readings) {
        firsts.push_back(points);
        points += reading.places.size();
        for (std::size_t h = 0; h < made.halves.size(); ++h) {
            const MeterHalf& half = reading.halves[h];
            LightAtPoints& light = made.halves[h];
            light.by_lamp.insert(light.by_lamp.end(), half.by_column.begin(), half.by_column.end());
            for (std::size_t i = 0; i < half.values.size(); ++i) {
                double rest = half.values[i];
                for (std::size_t k = 0; k < made.lamps; ++k)
                    rest -= half.by_column[i * made.lamps + k];
                // What is left of sums over all lamps is rounding, unless it is light.
                light.fixed.push_back(rest > rounding * half.values[i] ? rest : 0);
            }
        }
    }
    for (std::size_t d = 0; d < request.demands.size(); ++d) {
        const MeterDemand& demand = request.demands[d];
        made.demands.push_back({firsts[which[d]], readings[which[d]].places.size(), demand.low,
                                demand.high, demand.of_mean});
    }
    return made;
}

/// Says what has been found.
class SolveReport {
public:
    SolveReport(const SolveRequest& request, const PowerProblem& problem,
                const std::vector<MeterReading>& readings, const std::vector<std::size_t>& which,
                const std::vector<std::string>& names, const SolvedPowers& found)
        : request_(request),
          problem_(problem),
          readings_(readings),
          which_(which),
          names_(names),
          found_(found) {}

    /// The report for people.
    std::string text() const {
        const std::size_t count = found_.powers.size();
        std::string made = message(count, count == 1 ? " power" : " powers", " with ",
                                   cell(rounded(100 * found_.cost, 3)),
                                   " % of the light of these lamps as the scene has them\n");
        for (std::size_t i = 0; i < std::min(found_.unknown.size(), most_named); ++i)
            made += message("left out: `", printable(names_[found_.unknown[i]]),
                            "`, of whose light there are too few samples at the meters\n");
        if (found_.unknown.size() > most_named)
            made += message("left out: ", found_.unknown.size() - most_named, " more\n");
        std::size_t tight = 0, missed = 0;
        double by = 0;
        for (const SolvedBound& bound : found_.bounds) {
            if (bound.tight && ++tight <= most_named)
                made += message("tight: ", asked(bound), ", and ", lux(bound.judged),
                                " by the other half of the samples\n");
            const double over =
                (bound.upper ? bound.judged - bound.bound : bound.bound - bound.judged) /
                bound.bound;
            if (!bound.missed && over > rounding) {
                ++missed;
                by = std::max(by, over);
            }
        }
        if (tight > most_named) made += message("tight: ", tight - most_named, " more\n");
        made += message("gap: readings differ by up to ", percent(found_.gap),
                        " of a bound between the halves of the samples; by the other half, ",
                        missed, " of ", found_.bounds.size(),
                        found_.bounds.size() == 1 ? " bound is" : " bounds are", " missed");
        if (missed > 0) made += message(", by up to ", percent(by));
        return made + "\n";
    }

    /// Reports what no powers meet.
    void name_missed(Diagnostics& diagnostics) const {
        std::size_t missed = 0;
        for (const SolvedBound& bound : found_.bounds)
            if (bound.missed && ++missed <= most_named)
                diagnostics.add(
                    error(Fault::out_of_range, {},
                          message("cannot be met: ", asked(bound), "; it has ", lux(bound.solved),
                                  " with the powers that come nearest"))
                        .with_help(missed > 1 ? "" : way_out()));
        if (missed > most_named)
            diagnostics.add(error(Fault::out_of_range, {},
                                  message("cannot be met: ", missed - most_named, " more bounds")));
    }

private:
    static std::string lux(double value) { return cell(rounded(value, 4)) + " lx"; }
    static std::string percent(double share) { return cell(rounded(100 * share, 2)) + " %"; }

    std::string way_out() const {
        if (!found_.unknown.empty())
            return message("more --samples, as ", found_.unknown.size(),
                           found_.unknown.size() == 1 ? " lamp was" : " lamps were",
                           " left out, or wider bounds");
        return std::isfinite(request_.most) ? "wider bounds, more lamps, or a greater --max-power"
                                            : "wider bounds, or more lamps";
    }

    /// `Street` at <0, 0, 0>, at least 20 lx
    std::string asked(const SolvedBound& bound) const {
        const LightDemand& demand = problem_.demands[bound.demand];
        const MeterReading& reading = readings_[which_[bound.demand]];
        std::string at = ", mean";
        if (!demand.of_mean) {
            const Vec3& place = reading.places[bound.point - demand.first].position;
            at = message(" at <", cell(place.x), ", ", cell(place.y), ", ", cell(place.z), ">");
        }
        return message("`", printable(request_.demands[bound.demand].meter), "`", at,
                       bound.upper ? ", at most " : ", at least ", cell(bound.bound), " lx");
    }

    const SolveRequest& request_;
    const PowerProblem& problem_;
    const std::vector<MeterReading>& readings_;
    const std::vector<std::size_t>& which_;
    const std::vector<std::string>& names_;  ///< of the powers
    const SolvedPowers& found_;
};

/// The powers as an array of the language.
std::string powers_text(const std::vector<double>& powers, const PowerColumns& columns) {
    std::string made = message(
        "// Powers of lamps in terms of those that the scene had, found by candelabra solve.\n"
        "#declare Power = array[",
        powers.size(), "] {\n");
    for (std::size_t i = 0; i < powers.size(); ++i)
        made += message("  ", rounded(powers[i], 7), i + 1 < powers.size() ? "," : "", "  // ",
                        printable(columns.names[i]), "\n");
    return made + "}\n";
}

int write_powers(SceneSteps& steps, const std::string& powers, const std::string& report) {
    const Options& options = steps.options();
    const bool to_file = options.readings_file != "-";
    if (!to_file)
        steps.console().out(powers);
    else if (!write_file(options.readings_file, powers, steps.diagnostics())) {
        steps.say_diagnostics();
        return exit_status::file;
    }
    if (options.verbose) (to_file ? steps.console().out : steps.console().err)(report);
    return exit_status::done;
}

}  // namespace

int solve_powers(SceneSteps& steps, const SolveRequest& request) {
    std::optional<Scene> scene = steps.valid_scene();
    if (!scene) return exit_status::scene;
    std::vector<std::size_t> which;
    const std::vector<Meter> meters =
        demanded_meters(scene->meters, request, which, steps.diagnostics());
    if (steps.say_diagnostics()) return exit_status::scene;
    const SharedWorld world =
        steps.reviewed_world(std::move(*scene), Session::Shutter::all_samples);
    if (!world) return exit_status::scene;
    const Shot shot = steps.shot(world);
    review_meters(*world, meters, steps.diagnostics());
    const WorldLamps lamps = world_lamps(*world, light_names(*world, steps.sources()));
    const auto columns = columns_of(lamps, !world->sky.light.empty(), request, steps.diagnostics());
    if (steps.say_diagnostics() || !columns) return exit_status::scene;
    const double metres = world->rules.settings.light_units().metres;
    std::size_t points = 0;
    for (const Meter& meter : meters) points += places_of(meter, metres).size();
    if (points > most_products / columns->names.size()) {
        steps.diagnostics().add(
            error(Fault::out_of_range, {},
                  message(points, " points and ", columns->names.size(),
                          " powers are too many: their product may be ", most_products))
                .with_help("--together gives all lamps of a name one power"));
        steps.say_diagnostics();
        return exit_status::scene;
    }
    bool stopped = false;
    MeasureSettings settings = measure_settings(steps, stopped);
    settings.lamps = {columns->names.size(),
                      [&](Lamp lamp) { return columns->of_place[lamps.place_of(lamp)]; }};
    const std::vector<MeterReading> readings = measure(shot, meters, settings);
    const PowerProblem problem = problem_of(request, readings, which, *columns);
    const SolvedPowers found = solved(problem, steps.diagnostics());
    if (steps.say_diagnostics()) return exit_status::scene;
    const SolveReport report(request, problem, readings, which, columns->names, found);
    const int written = write_powers(steps, powers_text(found.powers, *columns), report.text());
    if (written != exit_status::done) return written;
    report.name_missed(steps.diagnostics());
    if (steps.say_diagnostics()) return exit_status::scene;
    return stopped ? exit_status::stopped : exit_status::done;
}

}  // namespace candelabra
