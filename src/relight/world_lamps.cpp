// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/world_lamps.h"

#include "base/box.h"
#include "base/order.h"
#include "luminaire/luminaire.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace candelabra {

namespace {

/// A lamp before it has its place.
struct PlacedLamp {
    Vec3 position;
    double power;
    std::uint32_t number;  ///< in its group
    std::uint32_t* place;  ///< where its place is noted
};

using LampIterator = std::vector<PlacedLamp>::iterator;

/// Sorts lamps so that each half of a range lies on one side of a plane.
void sort_by_place(LampIterator begin, LampIterator end) {
    if (end - begin < 3) return;
    Vec3 low = begin->position, high = low;
    for (auto lamp = begin; lamp != end; ++lamp) {
        low = glm::min(low, lamp->position);
        high = glm::max(high, lamp->position);
    }
    const Vec3 size = high - low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto middle = begin + (end - begin) / 2;
    put_nth(begin, middle, end, [&](const PlacedLamp& a, const PlacedLamp& b) {
        const double at_a = a.position[axis], at_b = b.position[axis];
        return at_a < at_b || (at_a == at_b && a.number < b.number);
    });
    sort_by_place(begin, middle);
    sort_by_place(middle, end);
}

/// Powers above 0, also of lamps whose estimate is none.
std::vector<float> usable_powers(const std::vector<double>& powers) {
    double sum = 0;
    for (const double power : powers)
        if (std::isfinite(power)) sum += power;
    const double mean = sum > 0 ? sum / static_cast<double>(powers.size()) : 1;
    constexpr double least = 1e-6, most = 1e6;
    std::vector<float> usable;
    for (const double power : powers)
        usable.push_back(
            static_cast<float>(std::clamp(std::isfinite(power) ? power / mean : 1.0, least, most)));
    return usable;
}

Vec3 finite_place(const Vec3& place) {
    const double sum = place.x + place.y + place.z;
    return std::isfinite(sum) ? place : Vec3(0);
}

}  // namespace

WorldLamps world_lamps(const World& world, const std::vector<std::string>& names) {
    const Provenance& made = world.provenance;
    WorldLamps lamps;
    lamps.of_luminaire.resize(world.lights.glowing());
    lamps.of_source.resize(world.lights.sources.size());
    std::vector<std::vector<PlacedLamp>> by_group(names.size());
    const auto add = [&](std::size_t group, const Vec3& position, double power,
                         std::uint32_t& place) {
        auto& all = by_group[group];
        all.push_back(
            {finite_place(position), power, static_cast<std::uint32_t>(all.size()), &place});
    };
    for (std::size_t i = 0; i < lamps.of_luminaire.size(); ++i) {
        const auto light = static_cast<LightIndex>(i);
        const LightBounds around =
            world.lights.visit(light, [](const auto& glowing) { return bounds(glowing); });
        add(made.luminaire_statement(light), around.centre, around.intensity,
            lamps.of_luminaire[i]);
    }
    for (std::size_t i = 0; i < lamps.of_source.size(); ++i) {
        const PointLight& source = world.lights.sources[i];
        add(made.statement_of_light[i], source.location, luminance(abs(source.colour)),
            lamps.of_source[i]);
    }
    if (!world.sky.light.empty()) add(made.statement_of_sky, Vec3(0), 1, lamps.of_sky);
    std::vector<LampGroup> groups;
    std::vector<std::uint32_t> numbers;
    std::vector<double> powers;
    for (std::size_t i = 0; i < names.size(); ++i) {
        sort_by_place(by_group[i].begin(), by_group[i].end());
        groups.push_back({names[i], static_cast<std::uint32_t>(by_group[i].size())});
        for (const PlacedLamp& lamp : by_group[i]) {
            *lamp.place = static_cast<std::uint32_t>(numbers.size());
            numbers.push_back(lamp.number);
            powers.push_back(lamp.power);
        }
    }
    lamps.list = LampList(std::move(groups), std::move(numbers), usable_powers(powers));
    return lamps;
}

}  // namespace candelabra
