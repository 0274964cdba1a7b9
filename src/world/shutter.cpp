// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/shutter.h"

#include <map>
#include <string>
#include <tuple>

namespace candelabra {

void share_light_statements(World& world, const SourceStore& sources) {
    using Place = std::tuple<std::string, std::string, std::uint32_t, std::uint32_t>;
    std::map<Place, std::uint32_t> numbers;
    Provenance all;
    const auto number = [&](const Span& statement, const std::string& name) {
        const std::string source =
            statement.known() ? sources.name(statement.source) : std::string();
        const Place place = name.empty() ? Place(name, source, statement.first, statement.last)
                                         : Place(name, {}, 0, 0);
        const auto [found, added] =
            numbers.try_emplace(place, static_cast<std::uint32_t>(numbers.size()));
        if (added) all.add_light_statement(statement, name);
        return found->second;
    };
    const auto renumber = [&](World& sample) {
        std::vector<std::uint32_t> now;
        const Provenance& own = sample.provenance;
        for (std::size_t k = 0; k < own.light_statements.size(); ++k)
            now.push_back(number(own.light_statements[k], own.light_names[k]));
        for (auto* list :
             {&sample.provenance.statement_of_luminaire, &sample.provenance.statement_of_light})
            for (std::uint32_t& statement : *list) statement = now[statement];
        for (auto& placed : sample.provenance.statement_of_placed)
            placed.statement = now[placed.statement];
        if (!sample.sky.light.empty())
            sample.provenance.statement_of_sky = now[sample.provenance.statement_of_sky];
    };
    renumber(world);
    for (World& sample : world.shutter) renumber(sample);
    const auto share = [&](Provenance& own) {
        own.light_statements = all.light_statements;
        own.light_names = all.light_names;
    };
    for (World& sample : world.shutter) share(sample.provenance);
    share(world.provenance);
}

}  // namespace candelabra
