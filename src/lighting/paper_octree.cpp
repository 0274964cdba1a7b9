// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/paper_octree.h"

#include "lighting/draw.h"
#include "lighting/tuning.h"

#include <algorithm>

namespace candelabra {

namespace {

/// Approximate light of a luminaire on a surface that faces it.
double straight_on_bound(const LightProxy& g, const Vec3& position) {
    const Vec3 v = g.centre - position;
    return g.strength * g.radius / std::fmax(dot(v, v), g.radius * g.radius);
}

}  // namespace

BuiltPaperOctree::BuiltPaperOctree(const PaperOctree& settings, const LightScene& scene,
                                   int threads)
    : representatives_(settings.representatives), table_(scene.lights) {
    std::vector<LightBounds> lights;
    std::vector<double> intensities;
    for (LightIndex light = 0; light < scene.count(); ++light) {
        lights.push_back(scene.lights->bounds(light));
        intensities.push_back(lights.back().intensity);
    }
    places_ = WeightedIndex(intensities);
    cells_ = build_light_cells(settings, scene, lights, threads);
    std::size_t bright = 0;
    for (const std::vector<LightIndex>& list : cells_.lists) bright += list.size();
    table_.reserve(cells_.lists.size(), bright);
    for (std::vector<LightIndex>& list : cells_.lists) {
        lists_.push_back(table_.append(list));
        dim_before_.resize(lists_.back().first);
        const std::vector<std::uint64_t> before = dim_places_before(places_, list);
        dim_before_.insert(dim_before_.end(), before.begin(), before.end());
        list = {};
    }
    cells_.lists = {};
}

LightList BuiltPaperOctree::list_at(const Vec3& point) const {
    const std::uint32_t list = cells_.list_at(point);
    return list == LightCell::no_list ? LightList{} : lists_[list];
}

DimSet BuiltPaperOctree::dim_set(const LightList& list) const {
    return {places_, table_.lights(list), {dim_before_.data() + list.first, list.count}};
}

double BuiltPaperOctree::share(const DimSet& dim, LightIndex light) const {
    return tuning::even_share / static_cast<double>(dim.lights()) +
           (1 - tuning::even_share) *
               (static_cast<double>(places_.of(light)) / static_cast<double>(dim.places()));
}

double BuiltPaperOctree::guess_dim(const Receiver& point, const Key& key, const DimSet& dim) const {
    if (dim.places() == 0) return 0;
    // Representatives are sampled by intensity, so that they differ in position and not in
    // strength.
    double given = 0, straight_on = 0;
    for (int i = 0; i < representatives_; ++i) {
        const LightIndex light = dim.at(draw_integer(key, Purpose::dim_representative,
                                                     static_cast<std::uint64_t>(i), dim.places()));
        const auto places = static_cast<double>(places_.of(light));
        given += table_.estimate(light, point) / places;
        straight_on += straight_on_bound(table_.light_proxy(light), point.position) / places;
    }
    return std::fmax(given, tuning::min_dim_height * straight_on) *
           static_cast<double>(dim.places()) / representatives_;
}

void BuiltPaperOctree::weigh(const Receiver& point, const Key& key, Odds& odds) const {
    odds.list = list_at(point.position);
    table_.sum(odds.list, point, odds.bright);
    odds.dim = guess_dim(point, key, dim_set(odds.list));
}

void BuiltPaperOctree::choose(const Receiver& point, const Key& key, LightPicks& picks) const {
    Odds odds;
    weigh(point, key, odds);
    if (!(odds.total() > 0)) return;
    const double target = uniform(key, Purpose::light_choice) * odds.total();
    if (target < odds.bright.total || odds.dim == 0) {
        const auto [row, estimate] = table_.find(odds.list, point, odds.bright, target);
        picks.push_back({table_.light(row), estimate / odds.total()});
        return;
    }
    // Uses new random numbers, since the remainder of the target may be too coarse for millions of
    // luminaires.
    const DimSet dim = dim_set(odds.list);
    const bool evenly = draw(key, Purpose::light_choice, 1) < tuning::even_share;
    const std::uint64_t drawn =
        draw_integer(key, Purpose::light_choice, 2, evenly ? dim.lights() : dim.places());
    const LightIndex light = evenly ? dim.nth(drawn) : dim.at(drawn);
    picks.push_back({light, odds.dim * share(dim, light) / odds.total()});
}

double BuiltPaperOctree::expected(const Receiver& point, const Key& key, LightIndex light) const {
    Odds odds;
    weigh(point, key, odds);
    if (!(odds.total() > 0)) return 0;
    if (std::ranges::binary_search(table_.lights(odds.list), light))
        return table_.estimate(light, point) / odds.total();
    if (odds.dim == 0) return 0;
    return odds.dim * share(dim_set(odds.list), light) / odds.total();
}

std::size_t BuiltPaperOctree::memory_bytes() const {
    return cells_.cells.capacity() * sizeof(LightCell) + lists_.capacity() * sizeof(LightList) +
           table_.memory_bytes() + dim_before_.capacity() * sizeof(std::uint64_t) +
           places_.memory_bytes();
}

}  // namespace candelabra
