// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/light_octree.h"

#include "lighting/draw.h"

#include <algorithm>

namespace {

/// How often representatives are drawn before it is taken that hardly any dim luminaire is above the horizon. (The paper
/// goes on until one is, which need never happen.)
constexpr int most_draws = 8;

/// What a luminaire gives a surface that faces it, nearly.
double straight_on_bound(const Glow& g, const Vec3& position) {
    const Vec3 v = g.centre - position;
    return g.strength * g.radius / std::fmax(dot(v, v), g.radius * g.radius);
}

}  // namespace

BuiltLightOctree::BuiltLightOctree(const LightOctree& settings, const LightScene& scene, int threads)
    : representatives_(settings.representatives), table_(scene.luminaires) {
    std::vector<LightBounds> lights;
    std::vector<double> intensities;
    for (const Luminaire& luminaire : scene.luminaires) {
        lights.push_back(bounds(luminaire));
        intensities.push_back(lights.back().intensity);
    }
    weights_ = LightWeights(intensities);
    cells_ = build_light_cells(settings, scene, lights, threads);
    std::size_t bright = 0;
    for (const std::vector<LightIndex>& list : cells_.lists) bright += list.size();
    table_.reserve(cells_.lists.size(), bright);
    for (std::vector<LightIndex>& list : cells_.lists) {
        lists_.push_back(table_.append(list));
        dim_places_.resize(lists_.back().first);
        const std::vector<std::uint64_t> places = dim_places(weights_, list);
        dim_places_.insert(dim_places_.end(), places.begin(), places.end());
        list = {};
    }
    cells_.lists = {};
}

LightList BuiltLightOctree::list_at(const Vec3& point) const {
    const std::uint32_t list = cells_.list_at(point);
    return list == LightCell::no_list ? LightList{} : lists_[list];
}

DimSet BuiltLightOctree::dim_set(const LightList& list) const {
    return {weights_, table_.lights(list), {dim_places_.data() + list.first, list.count}};
}

double BuiltLightOctree::guess_dim(const ShadingPoint& point, const Key& key, const DimSet& dim) const {
    double sum = 0, straight_on = 0;
    int drawn = 0;
    while (drawn < representatives_ || (sum == 0 && drawn < most_draws)) {
        const std::uint64_t place = draw_integer(key, Purpose::light_representative, static_cast<std::uint64_t>(drawn), dim.total());
        const LightIndex light = dim.at(place);
        const auto weight = static_cast<double>(weights_.weight(light));
        sum += table_.estimate(light, point) / weight;
        if (sum == 0) straight_on += straight_on_bound(table_.glow(light), point.position) / weight;
        ++drawn;
    }
    // None of so many is above the horizon: at most about one in that many and one more is.
    return (sum > 0 ? sum : straight_on / (drawn + 1)) / drawn;
}

void BuiltLightOctree::weigh(const ShadingPoint& point, const Key& key, Odds& odds) const {
    odds.list = list_at(point.position);
    table_.sum(odds.list, point, odds.bright);
    const DimSet dim = dim_set(odds.list);
    odds.dim_places = dim.total();
    odds.dim_per_place = odds.dim_places > 0 ? guess_dim(point, key, dim) : 0;
    odds.total = odds.bright.total + odds.dim_per_place * static_cast<double>(odds.dim_places);
}

void BuiltLightOctree::choose(const ShadingPoint& point, const Key& key, LightPicks& picks) const {
    Odds odds;
    weigh(point, key, odds);
    if (!(odds.total > 0)) return;
    const double target = uniform(key, Purpose::light_choice) * odds.total;
    if (target < odds.bright.total || odds.dim_places == 0) {
        const auto [row, estimate] = table_.find(odds.list, point, odds.bright, target);
        picks.push_back({table_.light(row), estimate / odds.total});
        return;
    }
    // A number of its own, since what is left of the target may be too coarse for millions of luminaires.
    const std::uint64_t place = draw_integer(key, Purpose::light_choice, 1, odds.dim_places);
    const LightIndex light = dim_set(odds.list).at(place);
    picks.push_back({light, odds.dim_per_place * static_cast<double>(weights_.weight(light)) / odds.total});
}

double BuiltLightOctree::expected(const ShadingPoint& point, const Key& key, LightIndex light) const {
    Odds odds;
    weigh(point, key, odds);
    if (!(odds.total > 0)) return 0;
    if (std::ranges::binary_search(table_.lights(odds.list), light))
        return table_.estimate(light, point) / odds.total;
    return odds.dim_per_place * static_cast<double>(weights_.weight(light)) / odds.total;
}

std::size_t BuiltLightOctree::memory_bytes() const {
    return cells_.cells.capacity() * sizeof(LightCell) + lists_.capacity() * sizeof(LightList) + table_.memory_bytes() +
           dim_places_.capacity() * sizeof(std::uint64_t) + weights_.memory_bytes();
}

BuiltLightOctree build(const LightOctree& settings, const LightScene& scene, int threads) {
    return BuiltLightOctree(settings, scene, threads);
}
