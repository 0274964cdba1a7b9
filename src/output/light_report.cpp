// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/light_report.h"

#include "output/estimates.h"
#include "text/message.h"
#include "text/printable.h"
#include "world/emitters.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace candelabra {

namespace {

std::string percent(double share) {
    return padded(message(std::round(100 * share * 100) / 100, " %"), 9);
}

std::vector<std::size_t> made_by(const World& world) {
    std::vector<std::size_t> counts = world.provenance.lights_of_statements();
    if (!world.sky.light.empty()) ++counts[world.provenance.statement_of_sky];
    return counts;
}

}  // namespace

std::string statement_text(const Span& span, const SourceStore& sources) {
    if (!span.known()) return "?";
    constexpr std::size_t longest = 50;
    const Place place = sources.place(span.source, span.first);
    std::string line(sources.line(span.source, place.line));
    // From the beginning of the statement, or of the #declare around it.
    const std::size_t column = std::min(line.size(), static_cast<std::size_t>(place.column - 1));
    const std::size_t before = line.substr(0, column).find_last_of("};");
    line.erase(0, before == line.npos ? 0 : before + 1);
    line.erase(0, line.find_first_not_of(" \t"));
    if (line.size() > longest) line = line.substr(0, longest) + "...";
    return message(printable(sources.name(span.source)), ":", place.line, ": ", printable(line));
}

LightShares light_shares(const World& world, const LightLedger& counted) {
    std::vector<LightCount> lights = counted.lights;
    lights.resize(world.provenance.light_statements.size() + 1);
    double light = 0, rays = 0;
    for (const LightCount& each : lights) {
        light += each.light.value();
        rays += static_cast<double>(each.rays);
    }
    const auto share = [](double part, double whole) { return whole > 0 ? part / whole : 0; };
    const auto rays_of = [&](const LightCount& count) {
        return share(static_cast<double>(count.rays), rays);
    };
    const std::vector<std::size_t> made = made_by(world);
    LightShares table;
    for (std::size_t i = 0; i < made.size(); ++i)
        table.rows.push_back(
            {i, share(lights[i].light.value(), light), rays_of(lights[i]), made[i]});
    std::ranges::stable_sort(table.rows, std::greater(), [&](const LightRow& row) {
        return lights[row.statement].light.value();
    });
    table.missed = rays_of(lights.back());
    table.glowing = glows_without_light(world);
    return table;
}

std::string light_report(const World& world, const LightLedger& counted,
                         const SourceStore& sources) {
    const LightShares table = light_shares(world, counted);
    const auto statement = [&](const LightRow& row) {
        return statement_text(world.provenance.light_statements[row.statement], sources);
    };
    std::string text = "    light      rays    lights  statement\n";
    const auto line = [&](double light, double rays, const std::string& number,
                          const std::string& what) {
        text += percent(light) + " " + percent(rays) + padded(number, 10) + "  " + what + "\n";
    };
    for (const LightRow& row : table.rows)
        line(row.light, row.rays, message(row.lights), statement(row));
    line(0, table.missed, "", "rays that met no light");
    constexpr std::size_t number_column = 29;
    if (table.glowing > 0)
        text += padded(message(table.glowing), number_column) + "  that glow, but light nothing\n";
    const bool lit = !table.rows.empty() && table.rows.front().light > 0;
    for (const LightRow& row : table.rows)
        if (row.light == 0 && lit)
            text +=
                message("no light came from ", statement(row),
                        "\n    it may stand inside or below something that lets no light out\n");
    return text;
}

}  // namespace candelabra
