// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/light_balance.h"

#include "base/parallel.h"
#include "photometry/light_colour.h"
#include "transport/flux_rays.h"
#include "transport/lamp_rays.h"
#include "transport/light_left.h"
#include "transport/surface_lobes.h"
#include "world/radiance.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace candelabra {

namespace {

/// Paths of a batch in the first round, each further one of which doubles them.
constexpr std::uint32_t first_paths = 1024, most_paths = 1U << 17U;
/// Paths of a batch at most if their number is stated.
constexpr std::uint32_t most_stated_paths = 1U << 28U;
constexpr int most_surfaces = 1000;  ///< that a path may meet
/// Number of surfaces from which on paths are subject to Russian roulette, and their minimum
/// survival probability.
constexpr int first_chance = 3;
constexpr double least_survival = 0.05;

/// Sums of a batch of paths.
struct BalanceSums {
    std::vector<std::array<double, light_ends>> ends;  ///< of each statement that makes lamps
    std::vector<double> objects;                       ///< of each statement that makes objects

    void add(std::uint32_t statement, LightEnd end, double light) {
        ends[statement][static_cast<std::size_t>(end)] += light;
    }
};

/// Follows paths from luminaires to their ends.
class BalancePaths {
public:
    BalancePaths(const Shot& shot, const Vec3& up)
        : shot_(shot),
          world_(*shot.world),
          rules_(shading_rules(world_)),
          up_(up),
          lamp_rays_(world_),
          flux_rays_(world_) {
        // A luminaire sends four times its mean intensity, in luminance times area.
        double luminaires = 0;
        world_.lights.for_each_glowing(
            [&](const auto& glowing) { luminaires += 4 * bounds(glowing).intensity; });
        if (flux_rays_.light() > 0)
            of_sources_ = flux_rays_.light() / (flux_rays_.light() + luminaires);
        std::map<Place, std::uint32_t> numbers;
        for (const Span& span : world_.provenance.object_spans) {
            const auto [found, fresh] =
                numbers.try_emplace({span.source, span.first}, statements_.size());
            if (fresh) statements_.push_back(span);
            statement_of_.push_back(found->second);
        }
    }

    bool any() const { return lamp_rays_.any() || of_sources_ > 0; }
    /// The statements that made objects, in the order of BalanceSums::objects.
    const std::vector<Span>& statements() const { return statements_; }

    void follow(const Key& key, BalanceSums& sums) const {
        if (of_sources_ > 0 && uniform(key, Purpose::sender_kind) < of_sources_)
            return follow_source(key, sums);
        if (!lamp_rays_.any()) return;
        auto drawn = lamp_rays_.draw(
            key, 1, [&](const Luminaire& luminaire) { return inner_rays(luminaire); });
        if (!drawn) return;
        PathState& path = drawn->path;
        const std::uint32_t statement = world_.provenance.luminaire_statement(drawn->light);
        path.throughput = Rgb(drawn->power_of_one / (1 - of_sources_));
        world_.lights.visit(drawn->light, [&](const auto& glowing) {
            path.dim(leaving(glowing, path));
            const Rgb left = left_by_fog(glowing, path);
            sums.add(statement, LightEnd::air, light_luminance((Rgb(1) - left) * path.throughput));
            path.dim(left);
        });
        go_on(std::move(path), statement, sums);
    }

private:
    void follow_source(const Key& key, BalanceSums& sums) const {
        auto drawn = flux_rays_.draw(key);
        if (!drawn) return;
        drawn->path.throughput = drawn->power / of_sources_;
        go_on(std::move(drawn->path), world_.provenance.statement_of_light[drawn->source], sums);
    }

    using Place = std::pair<std::uint32_t, std::uint32_t>;

    /// Fraction of the rays on the inner side. Light that cannot leave its lamp is left out, unless
    /// the camera is in there.
    double inner_rays(const Luminaire& luminaire) const {
        return luminaire.keeps_inner_light && shot_.inner_rays(luminaire) < 0.5 ? 0 : 0.5;
    }

    /// Radiance with which the path leaves its luminaire or box of media.
    template <class Glowing>
    Rgb leaving(const Glowing& glowing, const PathState& path) const {
        Hit hit;
        double free = bounds(glowing).radius;
        if (world_.first_hit(path.ray, path.tolerance, path.kind, hit))
            free = std::min(free, length(hit.position - path.ray.origin));
        const double distance = free / 2;
        const Ray back{path.ray.at(distance), -path.ray.direction};
        return radiance_seen(world_, glowing, {back, 0, distance});
    }

    /// Fraction that fog behind the start of the path leaves of its light.
    Rgb left_by_fog(const Luminaire&, const PathState&) const { return Rgb(1); }
    Rgb left_by_fog(const MediaBox&, const PathState& path) const {
        return left_by_fog_behind(world_, {path.ray.origin, -path.ray.direction}, path.tolerance,
                                  path.key.branched(Branch::medium, 1));
    }

    void go_on(PathState path, std::uint32_t statement, BalanceSums& sums) const {
        const double begun = max_abs_component(path.throughput);
        for (int met = 0; path.throughput != Rgb(0); ++met) {
            Hit hit;
            const bool meets = world_.first_hit(path.ray, path.tolerance, path.kind, hit);
            dim_by_air(path, meets ? length(hit.position - path.ray.origin) : INFINITY, meets,
                       statement, sums);
            if (meets && straight(path) && world_.material(hit.primitive).no_shadow) {
                // The light of a lamp passes it, as that of shadow rays does.
                path.media = interface_at(world_, path.media, hit.primitive, path.band).behind;
                path.ray.origin = hit.position;
                path.tolerance = hit.tolerance;
                if (met < most_surfaces) continue;
            }
            const double light = light_luminance(path.throughput);
            if (!meets || met == most_surfaces)
                return sums.add(statement, meets ? LightEnd::unknown : way_out(path), light);
            if (!scatter(path, hit, begun, met)) path.throughput = Rgb(0);
            const double absorbed = light - light_luminance(path.throughput);
            sums.add(statement, LightEnd::surfaces, absorbed);
            if (!statement_of_.empty())
                sums.objects[statement_of_[world_.provenance.object_of[hit.primitive]]] += absorbed;
        }
    }

    void dim_by_air(PathState& path, double distance, bool meets, std::uint32_t statement,
                    BalanceSums& sums) const {
        if (!world_.facts.dims_between) return;
        const std::span<const PrimitiveIndex> solids(path.media.data(), path.media.size());
        const Rgb left = left_in_air(world_, {path.ray, {0, distance}, solids, meets},
                                     path.key.branched(Branch::medium));
        sums.add(statement, LightEnd::air, light_luminance((Rgb(1) - left) * path.throughput));
        path.dim(left);
    }

    /// Whether the path is still that of light right from its lamp.
    static bool straight(const PathState& path) { return path.depth == 0 && path.bounces == 0; }

    LightEnd way_out(const PathState& path) const {
        if (dot(path.ray.direction, up_) > 0)
            return straight(path) ? LightEnd::above : LightEnd::above_reflected;
        return straight(path) ? LightEnd::below : LightEnd::below_reflected;
    }

    /// Continues the path in one of the ways on from a surface. Returns false if it ends.
    bool scatter(PathState& path, const Hit& hit, double begun, int met) const {
        // The path changes while the vertex refers to the solids around it.
        const MediaStack around = path.media;
        const Vertex vertex = vertex_at(world_, path.ray, hit, {around.data(), around.size()});
        path.dim(left_inside(world_, path, hit));
        const auto textures = visible_textures(world_, vertex);
        const auto* texture = choose(textures, uniform(path.key, Purpose::texture_choice));
        if (!texture) return false;
        const LayerStack stack(world_, path, vertex, texture->layers);
        SurfaceLobes lobes(world_, rules_, path, vertex, stack);
        stack.visit([&](const LayerStack::Seen& layer) { lobes.add(layer, {}); });
        lobes.add_behind();
        const auto chosen = lobes.choose(uniform(path.key, Purpose::way_choice));
        if (!chosen) return false;
        const auto& [lobe, chance] = *chosen;
        double survival = 1;
        if (met >= first_chance) {
            const double left = max_abs_component(path.throughput * lobe.share) / chance;
            survival = std::clamp(left / begun, least_survival, 1.0);
        }
        if (survival < 1 && uniform(path.key, Purpose::roulette) >= survival) return false;
        path.dim(lobe.through / (chance * survival));
        return lobes.follow(lobe, path);
    }

    const Shot& shot_;
    const World& world_;
    ShadingRules rules_;
    Vec3 up_;
    LampRays lamp_rays_;
    FluxRays flux_rays_;
    double of_sources_ = 0;  ///< fraction of the paths that start at light sources
    std::vector<Span> statements_;
    std::vector<std::uint32_t> statement_of_;  ///< of each of Provenance::object_spans
};

/// The value that `of` finds in the sums of each batch, of which each has so many paths.
template <class Of>
MeterValue value_of(const std::vector<BalanceSums>& batches, std::uint32_t paths, const Of& of) {
    Batches means;
    double all = 0;
    for (std::size_t b = 0; b < batch_count; ++b) {
        means[b] = of(batches[b]) / paths;
        all += means[b] / batch_count;
    }
    return with_interval(all, means);
}

/// The balance of the lamps for which `of` finds sums.
template <class Of>
LampBalance lamps_of(const std::vector<BalanceSums>& batches, std::uint32_t paths, const Of& of) {
    LampBalance result;
    for (std::size_t end = 0; end < light_ends; ++end)
        result.ends[end] =
            value_of(batches, paths, [&](const BalanceSums& sums) { return of(sums)[end]; });
    result.sent = value_of(batches, paths, [&](const BalanceSums& sums) {
        const auto& ends = of(sums);
        return std::accumulate(ends.begin(), ends.end(), 0.0);
    });
    return result;
}

LightBalance balance_of(const std::vector<BalanceSums>& batches, std::uint32_t paths,
                        const std::vector<Span>& statements) {
    LightBalance result;
    result.paths = std::uint64_t{paths} * batch_count;
    for (std::size_t i = 0; i < batches[0].ends.size(); ++i)
        result.lamps.push_back(lamps_of(
            batches, paths, [&](const BalanceSums& sums) -> const auto& { return sums.ends[i]; }));
    result.all = lamps_of(batches, paths, [](const BalanceSums& sums) {
        std::array<double, light_ends> all{};
        for (const auto& each : sums.ends)
            for (std::size_t end = 0; end < light_ends; ++end) all[end] += each[end];
        return all;
    });
    for (std::size_t i = 0; i < statements.size(); ++i)
        result.objects.push_back(
            {statements[i],
             value_of(batches, paths, [&](const BalanceSums& sums) { return sums.objects[i]; })});
    std::ranges::stable_sort(result.objects, [](const ObjectBalance& a, const ObjectBalance& b) {
        return a.absorbed.value > b.absorbed.value;
    });
    return result;
}

bool is_known(const LightBalance& balance, double error) {
    return std::ranges::all_of(balance.lamps, [&](const LampBalance& each) {
        return std::ranges::all_of(each.ends, [&](const MeterValue& end) {
            return end.error <= error * balance.all.sent.value;
        });
    });
}

/// The paths of a batch after which a balance ends.
std::uint32_t last_paths(std::size_t lamps, int samples) {
    if (samples <= 0) return most_paths;
    const std::uint64_t all = std::uint64_t{lamps} * static_cast<std::uint64_t>(samples);
    const std::uint64_t of_batch = all / batch_count + (all % batch_count > 0 ? 1 : 0);
    return static_cast<std::uint32_t>(std::min<std::uint64_t>(of_batch, most_stated_paths));
}

}  // namespace

LightBalance balance_of_light(const Shot& shot, const BalanceSettings& settings) {
    const BalancePaths paths(shot, unit(settings.up));
    const Provenance& provenance = shot.world->provenance;
    std::vector<BalanceSums> batches(batch_count);
    for (BalanceSums& each : batches) {
        each.ends.resize(provenance.light_statements.size());
        each.objects.resize(paths.statements().size());
    }
    LightBalance result;
    std::uint32_t done = 0;
    // The number of lamps of each statement.
    std::vector<std::size_t> lamps = provenance.luminaires_of_statements();
    for (std::uint32_t i = 0; i < provenance.statement_of_light.size(); ++i)
        if (sends_flux(*shot.world, i)) ++lamps[provenance.statement_of_light[i]];
    const std::size_t all = std::accumulate(lamps.begin(), lamps.end(), std::size_t{0});
    const std::uint32_t last = last_paths(all, settings.samples);
    for (std::uint32_t level = std::min(first_paths, last); paths.any();
         level = std::min(2 * level, last)) {
        run_parallel(batch_count, settings.threads, [&](std::size_t batch) {
            const std::uint64_t stream =
                mix(mix(static_cast<std::uint64_t>(settings.seed) + 0xba1a) + batch);
            for (std::uint32_t n = done; n < level; ++n)
                paths.follow({stream, n, 0, 0}, batches[batch]);
        });
        done = level;
        result = balance_of(batches, done, paths.statements());
        result.reached = is_known(result, settings.error);
        const bool enough = result.reached && settings.samples <= 0;
        if (enough || level == last || (settings.ended && settings.ended())) break;
    }
    result.lamps.resize(provenance.light_statements.size());
    for (std::size_t i = 0; i < lamps.size(); ++i) result.lamps[i].lamps = lamps[i];
    result.all.lamps = all;
    return result;
}

}  // namespace candelabra
