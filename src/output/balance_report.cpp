// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/balance_report.h"

#include "output/estimates.h"
#include "output/light_report.h"
#include "text/message.h"
#include "text/printable.h"
#include "transport/flux_rays.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string_view>
#include <vector>

namespace candelabra {

namespace {

using BalanceJson = nlohmann::json;

constexpr std::array<std::string_view, light_ends> end_names = {
    "surfaces", "air", "above", "above_reflected", "below", "below_reflected", "unknown"};
/// Statements of objects that are shown to people.
constexpr std::size_t most_objects = 10;

MeterValue in_lumens(const BalancedScene& scene, const MeterValue& value) {
    const LightUnits units = scene.world.rules.settings.light_units();
    return {units.lumens(value.value), units.lumens(value.error)};
}

std::string statement_of(const BalancedScene& scene, std::size_t i) {
    return statement_text(scene.world.provenance.light_statements[i], scene.sources);
}

/// The statements that make luminaires, the brightest first.
std::vector<std::size_t> by_light(const LightBalance& balance) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < balance.lamps.size(); ++i)
        if (balance.lamps[i].lamps > 0) order.push_back(i);
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
        return balance.lamps[a].sent.value > balance.lamps[b].sent.value;
    });
    return order;
}

BalanceJson lamps_json(const BalancedScene& scene, const LampBalance& lamps) {
    BalanceJson json{{"lamps", lamps.lamps}, {"sent", value_json(in_lumens(scene, lamps.sent))}};
    for (std::size_t end = 0; end < light_ends; ++end)
        json[end_names[end]] = value_json(in_lumens(scene, lamps.ends[end]));
    return json;
}

std::string per_cent(double part, double whole) {
    return message(whole > 0 ? std::round(1000 * part / whole) / 10 : 0, " %");
}

std::string line_of(const BalancedScene& scene, const LampBalance& lamps, const std::string& what) {
    constexpr std::size_t width = 9, of_lumens = 10;
    std::string text = padded(cell(rounded(in_lumens(scene, lamps.sent).value, 4)), of_lumens);
    for (const LightEnd end :
         {LightEnd::surfaces, LightEnd::air, LightEnd::above, LightEnd::above_reflected,
          LightEnd::below, LightEnd::below_reflected})
        text += padded(per_cent(lamps.of(end).value, lamps.sent.value), width);
    return text + padded(message(lamps.lamps), width) + "  " + what + "\n";
}

}  // namespace

void review_balance(const World& world, Diagnostics& diagnostics) {
    std::size_t sources = 0, left_out = 0;
    Span first;
    for (std::uint32_t i = 0; i < world.lights.sources.size(); ++i) {
        if (sends_flux(world, i)) {
            ++sources;
            continue;
        }
        const Provenance& from = world.provenance;
        if (left_out++ == 0) first = from.light_statements[from.statement_of_light[i]];
    }
    if (!world.lights.any_glowing() && sources == 0) {
        diagnostics.add(
            error(Fault::missing, {}, "the scene has no lamp whose light could be followed")
                .with_help("finish { emission 5 } makes an object a luminaire, and "
                           "light_source { 2*y, 1 flux lumen(800) } has a flux"));
        return;
    }
    if (left_out > 0)
        diagnostics.add(
            warning(
                Fault::no_effect, first,
                message(left_out, left_out == 1 ? " light source has" : " light sources have",
                        " no flux, and ", left_out == 1 ? "is" : "are", " left out of the balance"))
                .with_help("a source with `flux`, `intensity`, `ies` or `ldt` has one; parallel "
                           "light, light without shadows and light of light groups have none"));
    if (!world.sky.light.empty())
        diagnostics.add(warning(Fault::no_effect, {},
                                "light of the sky is left out of the balance: it has no flux"));
}

std::string balance_as_csv(const BalancedScene& scene) {
    std::string text = "statement,name,lamps,sent,sent_error";
    for (const std::string_view name : end_names) text += message(',', name, ',', name, "_error");
    text += '\n';
    const auto line = [&](std::string_view statement, std::string_view name,
                          const LampBalance& lamps) {
        text += message(csv_cell(statement), ',', csv_cell(name), ',', lamps.lamps);
        const auto add = [&](const MeterValue& value) {
            const auto [lumens, error] = in_lumens(scene, value);
            text += message(',', cell(lumens), ',', cell(error));
        };
        add(lamps.sent);
        for (const MeterValue& end : lamps.ends) add(end);
        text += '\n';
    };
    for (const std::size_t i : by_light(scene.balance))
        line(statement_of(scene, i), scene.world.provenance.light_names[i], scene.balance.lamps[i]);
    line("all", "", scene.balance.all);
    return text;
}

std::string balance_as_json(const BalancedScene& scene) {
    const LightBalance& balance = scene.balance;
    BalanceJson json{{"unit", "lm"},
                     {"interval", "95 %: value - error to value + error"},
                     {"seed", scene.seed},
                     {"paths", balance.paths},
                     {"reached", balance.reached},
                     {"all", lamps_json(scene, balance.all)}};
    json["statements"] = BalanceJson::array();
    for (const std::size_t i : by_light(balance)) {
        BalanceJson lamps = lamps_json(scene, balance.lamps[i]);
        lamps["statement"] = statement_of(scene, i);
        const std::string& name = scene.world.provenance.light_names[i];
        if (!name.empty()) lamps["name"] = name;
        json["statements"].push_back(std::move(lamps));
    }
    json["surfaces"] = BalanceJson::array();
    for (const ObjectBalance& each : balance.objects)
        json["surfaces"].push_back({{"statement", statement_text(each.statement, scene.sources)},
                                    {"absorbed", value_json(in_lumens(scene, each.absorbed))}});
    // Names may be in any encoding.
    return json.dump(2, ' ', false, BalanceJson::error_handler_t::replace) + "\n";
}

std::string balance_as_text(const BalancedScene& scene) {
    const LightBalance& balance = scene.balance;
    const double all = balance.all.sent.value;
    std::string text = message("lamps send ", shown(in_lumens(scene, balance.all.sent)), " lm; ",
                               balance.paths, " paths were followed\n");
    text +=
        "                                above the horizon  below the horizon\n"
        "        lm surfaces      air   direct reflected   direct reflected    lamps  "
        "statement\n";
    for (const std::size_t i : by_light(balance))
        text += line_of(scene, balance.lamps[i], statement_of(scene, i));
    text += line_of(scene, balance.all, "all");
    if (const double lost = balance.all.of(LightEnd::unknown).value; lost != 0)
        text += message(per_cent(lost, all), " was still on its way after very many surfaces\n");
    std::size_t shown_objects = 0;
    for (const ObjectBalance& each : balance.objects) {
        if (!(each.absorbed.value > 0) || ++shown_objects > most_objects) break;
        if (shown_objects == 1) text += "surfaces that absorb most:\n";
        text += padded(per_cent(each.absorbed.value, all), 10) + "  " +
                statement_text(each.statement, scene.sources) + "\n";
    }
    return text;
}

}  // namespace candelabra
