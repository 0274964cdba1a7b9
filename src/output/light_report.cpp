// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/light_report.h"

#include "output/estimates.h"
#include "text/message.h"
#include "text/printable.h"
#include "world/emitters.h"

#include <algorithm>
#include <numeric>

namespace candelabra {

namespace {

std::string percent(double part, double whole) {
    const double value = whole > 0 ? 100 * part / whole : 0;
    return padded(message(std::round(value * 100) / 100, " %"), 9);
}

std::vector<std::size_t> made_by(const World& world) {
    std::vector<std::size_t> counts(world.provenance.light_statements.size());
    for (const auto* lights :
         {&world.provenance.statement_of_luminaire, &world.provenance.statement_of_light})
        for (const std::uint32_t statement : *lights) ++counts[statement];
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

std::string light_report(const World& world, const LightLedger& counted,
                         const SourceStore& sources) {
    std::vector<LightCount> lights = counted.lights;
    lights.resize(world.provenance.light_statements.size() + 1);
    double light = 0, rays = 0;
    for (const LightCount& each : lights) {
        light += each.light.value();
        rays += static_cast<double>(each.rays);
    }
    const std::vector<std::size_t> made = made_by(world);
    std::vector<std::size_t> order(made.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
        return lights[a].light.value() > lights[b].light.value();
    });
    std::string text = "    light      rays    lights  statement\n";
    const auto line = [&](const LightCount& count, const std::string& number,
                          const std::string& what) {
        text += percent(count.light.value(), light) + " " +
                percent(static_cast<double>(count.rays), rays) + padded(number, 10) + "  " + what +
                "\n";
    };
    for (const std::size_t i : order)
        line(lights[i], message(made[i]),
             statement_text(world.provenance.light_statements[i], sources));
    line(lights.back(), "", "rays that met no light");
    constexpr std::size_t number_column = 29;
    if (const std::size_t glows = glows_without_light(world); glows > 0)
        text += padded(message(glows), number_column) + "  that glow, but light nothing\n";
    for (const std::size_t i : order)
        if (lights[i].light.value() == 0 && light > 0)
            text +=
                message("no light came from ",
                        statement_text(world.provenance.light_statements[i], sources),
                        "\n    it may stand inside or below something that lets no light out\n");
    return text;
}

}  // namespace candelabra
