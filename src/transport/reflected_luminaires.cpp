// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/reflected_luminaires.h"

#include "base/order.h"
#include "base/parallel.h"
#include "luminaire/sphere.h"
#include "luminaire/triangle.h"
#include "surface/quality.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace candelabra {

namespace {

/// Number of generations kept in memory.
constexpr std::size_t kept_generations =
    ReflectedLuminaires::single_samples +
    ReflectedLuminaires::samples_at_once / ReflectedLuminaires::shared_samples + 2;
/// Number of light paths that one thread follows at a time, and that are followed to find the
/// bound.
constexpr std::uint32_t paths_at_once = 1024, pilot_paths = 2048;
/// Maximum fraction of a uniformly lit surface's light that one reflected luminaire may contribute,
/// by their number in the whole scene and by that about it: "Indirect light".
constexpr double kappa = 1.0 / 16, kappa_there = 1.0 / 10;
/// The same of the light that a place in a medium gets from all about it: "Light in air".
constexpr double kappa_in_air = 1.0 / 32;
/// Number of places from which each of the pilot's reflected luminaires is looked for.
constexpr std::uint32_t trials_of_each = 4;
/// Fraction of the seen places from which a reflected luminaire is visible below which it is chosen
/// less often than its light suggests.
constexpr double well_seen = 0.15;
/// Minimum cosine at which a reflected luminaire outside of the lit region counts for the choice,
/// which takes the greatest one towards the region.
constexpr double least_facing = 0.05;
/// See LightScene: "Indirect light".
constexpr double even_share = 0.05;
/// Noise of the choice above which the octree's cells are divided: higher than among luminaires,
/// because a generation's cells serve few samples. See "Indirect light".
constexpr double eta = 0.1;
/// The same for places in media, which are spread over more cells: "Light in air".
constexpr double eta_in_air = 0.3;
/// Length of the bent normal: for the strategy, a reflected luminaire shines on both sides, and a
/// little more on its own.
constexpr double lean = 0.25;
/// Radius of a reflected luminaire for the strategy, as a fraction of the distance from which it
/// lights with its full power. With the whole distance, which is wide where reflections are sparse,
/// one of them widens the clusters that it shares with narrow ones, and these are chosen a thousand
/// times too rarely. It is chosen too often within that distance, where it stands for a small part
/// of the light. See "Indirect light".
constexpr double narrow = 1.0 / 32;

/// Bounds as of a triangle with this circumradius around the luminaire.
LightBounds bounds_of(const ReflectedLuminaire& luminaire, double radius) {
    const std::pair<Vec3, Vec3> across = perpendiculars(luminaire.normal);
    const double height = std::sqrt(0.75), area = 1.5 * height * radius * radius;
    const auto corner = [&](double along_x, double along_y) {
        return luminaire.position + radius * (along_x * across.first + along_y * across.second);
    };
    LightBounds result =
        bounds(TriangleEmitter{corner(1, 0), corner(-0.5, height), corner(-0.5, -height)},
               luminance(abs(luminaire.power) / area));
    result.bent_normal = lean * luminaire.normal;
    return result;
}

/// Bounds as of a sphere of that radius around a reflected luminaire in a medium.
LightBounds bounds_in_air(const ReflectedLuminaire& luminaire, double radius) {
    const double across = std::numbers::pi * radius * radius;
    return bounds(SphereEmitter{luminaire.position, radius},
                  luminance(abs(luminaire.power)) * mean_phase(*luminaire.scattering) / across);
}

/// Reflected luminaires as the strategy chooses among them. Their occlusion is not surveyed.
class ReflectedChoices final : public ChoosableLights {
public:
    /// `full`: the distance from which those on surfaces light with their full power.
    ReflectedChoices(const ReflectedSet& set, double full, const SeenShare& seen,
                     const AirToCamera& air, const LitRegion& region) {
        bounds_.reserve(set.list.size());
        for (std::size_t i = 0; i < set.list.size(); ++i) {
            ReflectedLuminaire counted = set.list[i];
            counted.power *= air.transmittance(counted.position);
            if (counted.in_air()) {
                bounds_.push_back(bounds_in_air(counted, narrow / std::sqrt(set.bounds[i])));
                continue;
            }
            counted.power *= std::fmin(seen.at(counted.position, counted.normal) / well_seen, 1);
            counted.power *=
                std::fmax(region.greatest_cosine(counted.position, counted.normal), least_facing);
            bounds_.push_back(bounds_of(counted, narrow * full));
        }
    }
    std::size_t size() const override { return bounds_.size(); }
    LightBounds bounds(LightIndex light) const override { return bounds_[light]; }

private:
    std::vector<LightBounds> bounds_;
};

/// Number of light paths in a generation. If the scene leaves it open, it follows the number of
/// pixels, so that the paths are a small part of the work in small pictures as well.
std::uint32_t paths_of(const PathTraced& wanted, const Shot& shot) {
    if (wanted.reflected_luminaires)
        return static_cast<std::uint32_t>(*wanted.reflected_luminaires);
    constexpr std::uint64_t pixels_for_each = 16, fewest = 500, most = 5000;
    return static_cast<std::uint32_t>(std::clamp(shot.pixels / pixels_for_each, fewest, most));
}

}  // namespace

std::shared_ptr<ReflectedLuminaires> reflected_luminaires_of(const Shot& shot, int seed,
                                                             int threads) {
    const World& world = *shot.world;
    const auto* wanted = std::get_if<PathTraced>(&world.rules.settings.integrator);
    if (!wanted || wanted->reflected_luminaires == 0 || wanted->bounces == 0 ||
        world.rules.quality < quality_full || world.appearance.any_loose_surface)
        return nullptr;
    auto made = std::make_shared<ReflectedLuminaires>(shot, paths_of(*wanted, shot),
                                                      wanted->bounces, seed, threads);
    return made->any() ? made : nullptr;
}

ReflectedLuminaires::ReflectedLuminaires(const Shot& shot, std::uint32_t count, int max_reflections,
                                         int seed, int threads)
    : shot_(shot),
      max_reflections_(max_reflections),
      paths_(shot, max_reflections),
      air_(shot, paths_.region()),
      count_(count),
      seed_(mix(static_cast<std::uint64_t>(seed) + 0x5ef1)),
      threads_(threads),
      generations_(kept_generations) {
    if (!paths_.any()) return;
    std::vector<ReflectedLuminaire> tried =
        sent(paths_.with_reflections(std::max(max_reflections_, 2)), pilot_paths, mix(seed_));
    std::erase_if(tried,
                  [&](const ReflectedLuminaire& each) { return is_far_in_air(each.position); });
    find_bound(tried);
    if (any()) find_seen(tried);
}

/// Returns all reflected luminaires of a random stream, in the order of their paths.
std::vector<ReflectedLuminaire> ReflectedLuminaires::sent(const LightPaths& paths,
                                                          std::uint32_t count,
                                                          std::uint64_t stream) const {
    return sent_in_batches<ReflectedLuminaire>(
        count, paths_at_once, threads_,
        [&](std::uint32_t first, std::uint32_t last, std::vector<ReflectedLuminaire>& found) {
            for (std::uint32_t i = first; i < last; ++i)
                paths.follow({stream, i, 0, 0}, 1.0 / count, found);
        });
}

/// Finds the bound from light paths that light nothing else. In the whole scene, the scale is the
/// median distance between successive reflections of a path.
void ReflectedLuminaires::find_bound(const std::vector<ReflectedLuminaire>& tried) {
    std::vector<double> distances;
    std::vector<Vec3> positions, in_air;
    for (std::size_t i = 0; i < tried.size(); ++i) {
        (tried[i].in_air() ? in_air : positions).push_back(tried[i].position);
        if (i > 0 && tried[i].reflections == tried[i - 1].reflections + 1)
            distances.push_back(length(tried[i].position - tried[i - 1].position));
    }
    if (distances.empty()) return;
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    put_nth(distances.begin(), middle, distances.end());
    const double usual = *middle, share = static_cast<double>(count_) / pilot_paths;
    if (!(usual > 0)) return;
    greatest_bound_ = kappa * share * static_cast<double>(tried.size()) / (usual * usual);
    per_density_ = kappa_there * share;
    per_density_in_air_ = kappa_in_air * 4 * std::numbers::pi * usual * share;
    if (positions.size() > 1) density_ = ReflectionDensity(std::move(positions));
    if (in_air.size() > 1) density_in_air_ = ReflectionDensity::in_air(std::move(in_air));
}

/// Finds from how many of the places that the camera sees reflected light is visible.
void ReflectedLuminaires::find_seen(const std::vector<ReflectedLuminaire>& tried) {
    const std::vector<SeenPlace>& places = paths_.seen();
    if (places.empty()) return;
    std::vector<std::size_t> on_surfaces;
    for (std::size_t i = 0; i < tried.size(); ++i)
        if (!tried[i].in_air()) on_surfaces.push_back(i);
    std::vector<SeenShare::Trial> trials(on_surfaces.size());
    run_parallel(trials.size(), threads_, [&](std::size_t number) {
        const std::size_t i = on_surfaces[number];
        const ReflectedLuminaire& each = tried[i];
        double seen = 0;
        for (std::uint32_t n = 0; n < trials_of_each; ++n) {
            const Key key{mix(seed_ + i), n, 0, 0};
            const auto place = static_cast<std::size_t>(uniform(key, Purpose::seen_place) *
                                                        static_cast<double>(places.size()));
            seen += sees(*shot_.world, places[place], each.position, each.normal, each.tolerance);
        }
        trials[number] = {each.position, each.normal, seen / trials_of_each};
    });
    seen_ = SeenShare(trials);
}

ReflectedSet ReflectedLuminaires::made(std::uint32_t number) const {
    ReflectedSet set;
    set.list = sent(paths_, count_, mix(seed_ ^ mix(number + 1)));
    const auto bound_of = [&](const ReflectedLuminaire& each) {
        return each.in_air() ? bound_in_air(each.position) : bound(each.position, each.normal);
    };
    std::erase_if(set.list, [&](const ReflectedLuminaire& each) { return bound_of(each) == 0; });
    for (const ReflectedLuminaire& each : set.list) set.bounds.push_back(bound_of(each));
    const double full = 1 / std::sqrt(greatest_bound_);
    // Occlusion is not surveyed, as a generation is soon over. The surfaces that they light are
    // those on which they lie.
    LightOctree octree;
    octree.alone = true;
    octree.eta = eta;
    LightScene scene{std::make_shared<ReflectedChoices>(set, full, seen_, air_, paths_.region())};
    scene.even = even_share;
    const Projection& camera = shot_.view.camera;
    if (!camera.parallel) scene.eye = camera.location;
    set.sampler = build(LightSampler(octree), scene, threads_);
    if (!in_air()) return set;
    octree.eta = eta_in_air;
    set.in_air = build(LightSampler(octree), scene, threads_);
    return set;
}

std::shared_ptr<const ReflectedSet> ReflectedLuminaires::generation(std::uint32_t number) {
    return generations_.get(number, [&] { return made(number); });
}

}  // namespace candelabra
