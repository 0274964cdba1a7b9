// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/shutter.h"

#include <map>
#include <string>
#include <tuple>

namespace candelabra {

void share_light_statements(World& world, const SourceStore& sources) {
    using Place = std::tuple<std::string, std::uint32_t, std::uint32_t>;
    std::map<Place, std::uint32_t> numbers;
    std::vector<Span> all;
    const auto number = [&](const Span& statement) {
        const Place place{statement.known() ? sources.name(statement.source) : std::string(),
                          statement.first, statement.last};
        const auto [found, added] =
            numbers.try_emplace(place, static_cast<std::uint32_t>(all.size()));
        if (added) all.push_back(statement);
        return found->second;
    };
    const auto renumber = [&](World& sample) {
        std::vector<std::uint32_t> now;
        for (const Span& statement : sample.provenance.light_statements)
            now.push_back(number(statement));
        for (auto* list :
             {&sample.provenance.statement_of_luminaire, &sample.provenance.statement_of_light})
            for (std::uint32_t& statement : *list) statement = now[statement];
        if (!sample.sky.light.empty())
            sample.provenance.statement_of_sky = now[sample.provenance.statement_of_sky];
    };
    renumber(world);
    for (World& sample : world.shutter) renumber(sample);
    for (World& sample : world.shutter) sample.provenance.light_statements = all;
    world.provenance.light_statements = std::move(all);
}

}  // namespace candelabra
