// SPDX-License-Identifier: GPL-3.0-or-later
// What the paper claims of its strategies, row by row (tests/bench/claims.md says which claim is
// shown where). Run by hand; names of rows choose some:
//   claim_bench [choices] [contributors] [threshold] [split] [samples] [rays] [bulb] [few] [scale]
#include "lighting/paper_octree.h"
#include "noise.h"
#include "support/choices.h"
#include "support/draw.h"
#include "support/scripts.h"
#include "transport/integrator.h"

#include <algorithm>
#include <cstdio>
#include <numeric>

using namespace candelabra;

namespace {

const std::string flakes = "examples/paper/fig6.pov", city = "examples/gallery/city.pov";

/// Points of surfaces that the camera sees, in a grid.
struct Seen {
    Receiver point;
    double tolerance;
};
std::vector<Seen> seen_points(const Shot& shot, int across) {
    std::vector<Seen> result;
    for (int i = 0; i < across * across; ++i) {
        const Ray ray = middle_ray(shot, {i % across, i / across, across, across});
        Hit hit;
        if (ray.direction == Vec3(0) || !shot.world->first_hit(ray, 0, RayKind::camera, hit))
            continue;
        if (shot.world->luminaire_of(hit.primitive) != no_primitive) continue;
        const Vec3 normal = dot(hit.normal, ray.direction) > 0 ? -hit.normal : hit.normal;
        result.push_back({{hit.position, normal}, hit.tolerance});
    }
    return result;
}

/// Nanoseconds for a choice, by the number of luminaires. [claim-5] [claim-6] [claim-20]
void choices() {
    const std::vector<Strategy> strategies = {{"constant_alpha", ConstantAlpha{}},
                                              {"linear_alpha", LinearAlpha{}},
                                              {"light_bvh", LightBvh{}},
                                              {"light_octree", octree()}};
    for (const Strategy& strategy : strategies) {
        double first = 0, last = 0, most = 0;
        for (const int count : {100, 1000, 10000, 100000, 1000000}) {
            const bool linear = strategy.name == "linear_alpha";
            if (linear && count > 100000) continue;
            Draw draw(1);
            std::vector<Luminaire> luminaires(static_cast<std::size_t>(count));
            for (Luminaire& luminaire : luminaires) {
                luminaire.emitter = SphereEmitter{draw.point(100), 0.05};
                luminaire.radiance = Rgb(1);
                luminaire.primitive = 0;
            }
            const Box surface{Vec3(-100), Vec3(100)};
            const auto built =
                build(strategy.sampler, LightScene{choices(luminaires), {&surface, 1}}, 1);
            // So many points as a picture has cells, asked again and again.
            constexpr int places = 1000;
            const int tries = linear ? 2000000 / count : 100 * places;
            LightSamples samples;
            double seconds = 0;
            for (const bool again : {false, true}) {
                Draw where(2);
                const double start = cpu_seconds();
                for (int i = 0; i < (again ? tries : std::min(tries, places)); ++i) {
                    if (i % places == 0) where = Draw(2);
                    samples.clear();
                    add_picks(built, {where.point(30), where.direction()}, {1, 2, 3, 4}, samples);
                }
                if (again) seconds = cpu_seconds() - start;
            }
            last = 1e9 * seconds / tries, most = count;
            if (first == 0) first = last;
            std::printf("%-16s %8d luminaires: %10.0f ns a choice\n", strategy.name.c_str(), count,
                        last);
            std::fflush(stdout);
        }
        std::printf("%-16s grows with the power %.2f\n", strategy.name.c_str(),
                    std::log(last / first) / std::log(most / 100));
    }
    // [claim-21]
    const Shot shot = shot_of_file(city, {{"Blocks", 36.0}}, octree());
    const std::vector<Seen> points = seen_points(shot, 100);
    LightSamples samples;
    double choosing = 0, tracing = 0;
    for (int round = 0; round < 2; ++round) {
        samples.clear();
        const double start = cpu_seconds();
        for (std::uint32_t i = 0; i < points.size(); ++i)
            add_picks(shot.sampler, points[i].point, {i, 1, 0, 0}, samples);
        choosing = cpu_seconds() - start;
    }
    const double start = cpu_seconds();
    for (std::size_t i = 0; i < std::min(samples.picks.size(), points.size()); ++i)
        if (const auto to = sample(shot.world->lights.luminaires.own()[samples.picks[i].light],
                                   points[i].point, {0.3, 0.7}))
            shot.world->transmittance({points[i].point.position, to->direction},
                                      points[i].tolerance, to->distance);
    tracing = cpu_seconds() - start;
    std::printf("city, %zu luminaires: choosing is %.0f %% of choosing and tracing\n",
                shot.world->lights.luminaires.size(), 100 * choosing / (choosing + tracing));
}

/// How many luminaires give 95 and 99 % of the light of a point. [claim-10]
void contributors() {
    for (const auto& [title, file] : {std::pair{"flake pair", flakes}, {"city", city}}) {
        const Shot shot = shot_of_file(file, {{"Blocks", 12.0}}, LightSampler{EveryLight{}});
        std::vector<std::size_t> counts95, counts99;
        for (const Seen& seen : seen_points(shot, 9)) {
            std::vector<double> given;
            for (const Luminaire& luminaire : shot.world->lights.luminaires.own()) {
                const auto to = sample(luminaire, seen.point, {0.4, 0.6});
                if (!to || !(dot(to->direction, seen.point.normal) > 0)) continue;
                const Ray ray{seen.point.position, to->direction};
                if (shot.world->transmittance(ray, seen.tolerance, to->distance) != Rgb(0))
                    given.push_back(unoccluded(luminaire, seen.point));
            }
            std::ranges::sort(given, std::greater<>{});
            const double all = std::accumulate(given.begin(), given.end(), 0.0);
            const auto enough = [&](double share) {
                double sum = 0;
                std::size_t n = 0;
                while (n < given.size() && sum < share * all) sum += given[n++];
                return n;
            };
            counts95.push_back(enough(0.95));
            counts99.push_back(enough(0.99));
        }
        for (auto* counts : {&counts95, &counts99}) std::ranges::sort(*counts);
        const auto at = [](const auto& counts, double share) {
            return counts[static_cast<std::size_t>(share * static_cast<double>(counts.size() - 1))];
        };
        std::printf(
            "%s, %zu luminaires: 95 %% of a point's light come from %zu of them (median; "
            "%zu at 9 of 10 points), 99 %% from %zu (%zu)\n",
            title, shot.world->lights.luminaires.size(), at(counts95, 0.5), at(counts95, 0.9),
            at(counts99, 0.5), at(counts99, 0.9));
    }
}

/// The paper's threshold. [claim-14] [claim-15]
void threshold() {
    for (const double value : {0.0002, 0.0007, 0.002, 0.008, 0.03}) {
        LightOctree settings = paper();
        settings.threshold = value;
        const Strategy strategy{"light_octree { paper }", settings, 4, 1};
        const Shot shot = shot_of_file(city, {{"Blocks", 12.0}}, strategy.sampler, 160);
        const std::vector<Seen> points = seen_points(shot, 60);
        std::vector<Box> surfaces;
        for (const Seen& seen : points)
            surfaces.push_back({seen.point.position - 0.1, seen.point.position + 0.1});
        const double start = cpu_seconds();
        const BuiltPaperOctree built(settings.as_in_paper(),
                                     {choices(shot.world->lights.luminaires.own()), surfaces}, 1);
        const double built_in = cpu_seconds() - start;
        std::vector<std::size_t> lengths;
        for (const Seen& seen : points) lengths.push_back(built.bright(seen.point.position));
        std::ranges::sort(lengths);
        const Measured found = measure(shot, strategy, 160);
        std::printf(
            "threshold %.4f: built in %.2f s, %.1f MB, %.0f bright (99 %%: %zu), "
            "mean %.4f, RMSE %.4f\n",
            value, built_in, static_cast<double>(built.memory_bytes()) / 1e6,
            std::accumulate(lengths.begin(), lengths.end(), 0.0) /
                static_cast<double>(lengths.size()),
            lengths[lengths.size() * 99 / 100], found.mean, found.rmse);
        std::fflush(stdout);
    }
}

/// Where the noise of one shadow ray comes from: which luminaire, where on it, and what is between.
/// [claim-19]
void split() {
    const Shot shot = shot_of_file(flakes, {}, LightSampler{LinearAlpha{}});
    double choice = 0, cosine = 0, visibility = 0, all = 0;
    LightSamples samples;
    const std::vector<Seen> points = seen_points(shot, 24);
    constexpr std::uint32_t tries = 64;
    for (std::uint32_t n = 0; n < points.size(); ++n) {
        const Seen& seen = points[n];
        double by_choice = 0, by_choice2 = 0, open = 0, open2 = 0, lit = 0, lit2 = 0;
        for (std::uint32_t i = 0; i < tries; ++i) {
            const Key key{n, i, 0, 0};
            samples.clear();
            add_picks(shot.sampler, seen.point, key, samples);
            if (samples.picks.empty()) continue;
            const Luminaire& luminaire =
                shot.world->lights.luminaires.own()[samples.picks[0].light];
            const Vec2 place{uniform(key, Purpose::light_u), uniform(key, Purpose::light_v)};
            const auto to = sample(luminaire, seen.point, place);
            const double whole = unoccluded(luminaire, seen.point) / samples.picks[0].expected;
            const double height = to ? std::fmax(0, dot(to->direction, seen.point.normal)) : 0;
            const double here = to ? luminance(luminaire.radiance) * height /
                                         (to->density * samples.picks[0].expected)
                                   : 0;
            const bool clear =
                here > 0 && shot.world->transmittance({seen.point.position, to->direction},
                                                      seen.tolerance, to->distance) != Rgb(0);
            by_choice += whole, by_choice2 += whole * whole;
            open += here, open2 += here * here;
            lit += clear ? here : 0, lit2 += clear ? here * here : 0;
        }
        const auto variance = [](double sum, double squares) {
            return (squares - sum * sum / tries) / (tries - 1);
        };
        const double by = variance(by_choice, by_choice2), of_open = variance(open, open2),
                     of_lit = variance(lit, lit2);
        choice += by, cosine += of_open - by, visibility += of_lit - of_open, all += of_lit;
    }
    std::printf(
        "flake pair, linear_alpha: of the variance of one shadow ray %.1f %% are the "
        "choice's, %.1f %% the cosine's on the luminaire, %.1f %% what is between\n",
        100 * choice / all, 100 * cosine / all, 100 * visibility / all);
}

/// Noise by the number of samples. [claim-4] [claim-18] [claim-29]
void samples() {
    for (const auto& [title, file] :
         {std::pair{"figure 3", std::string("examples/paper/fig3.pov")}, {"flake pair", flakes}})
        for (const Strategy& strategy :
             {Strategy{"constant_alpha", ConstantAlpha{}}, Strategy{"linear_alpha", LinearAlpha{}},
              Strategy{"every_light", EveryLight{}}, Strategy{"light_octree", octree()}}) {
            const bool few = file != flakes, octree_too = strategy.name == "light_octree";
            if (!few && !octree_too) continue;
            const Shot shot = shot_of_file(file, {}, strategy.sampler, 160);
            double first = 0, last = 0;
            std::printf("%s, %s: RMSE", title, strategy.name.c_str());
            for (const int count : {1, 4, 16, 64}) {
                last = measure(shot, {strategy.name, strategy.sampler, count}, 160).rmse;
                if (first == 0) first = last;
                std::printf(" %.5f (%d)", last, count);
            }
            std::printf(", slope %.2f\n", std::log(last / first) / std::log(64));
            std::fflush(stdout);
        }
}

/// Shadow rays at each hit, and what the pilot takes. [claim-30]
void rays() {
    for (const auto& [title, file] : {std::pair{"flake pair", flakes}, {"city", city}}) {
        const Shot shot = shot_of_file(file, {{"Blocks", 12.0}}, octree(), 160);
        for (const int count : {1, 2, 3, 4, 8, 16, 0}) {
            const int hits = count == 0 ? 4 : std::max(1, 16 / count);
            measure(shot, {"", octree(), 1, 1}, 160);  // the cells are there after this
            const Measured found = measure(shot, {"", octree(), hits, count}, 160);
            std::printf("%s, %2d hits of %2d shadow rays%s: %.2f s, RMSE %.5f, work %.4f\n", title,
                        hits, count, count == 0 ? " (as many as pay)" : "", found.seconds,
                        found.rmse, found.work());
            std::fflush(stdout);
        }
    }
}

/// A lamp of many patches gets one shadow ray. [claim-24] [claim-25]
void bulb() {
    double first = 0;
    for (const double across : {10.0, 32.0, 100.0, 316.0}) {
        const Strategy strategy{"light_octree", octree(), 4, 0};
        const Shot shot =
            shot_of_file("tests/bench/bulb.pov", {{"Across", across}}, strategy.sampler, 200);
        const Measured found = measure(shot, strategy, 200);
        if (first == 0) first = found.seconds;
        std::printf("bulb of %zu patches: %.2f s (%.2f), mean %.4f, RMSE %.5f\n",
                    shot.world->lights.luminaires.size(), found.seconds, found.seconds / first,
                    found.mean, found.rmse);
        std::fflush(stdout);
    }
}

/// With 108 luminaires the octree has little to win. [claim-17]
void few() {
    for (const Strategy& strategy :
         {Strategy{"linear_alpha", LinearAlpha{}, 9}, Strategy{"light_octree", octree(), 9},
          Strategy{"light_octree { paper }", paper(), 9},
          Strategy{"light_octree { alone }", alone(), 9}}) {
        const Shot shot = shot_of_file("examples/paper/fig5.pov", {}, strategy.sampler, 200);
        const Measured found = measure(shot, strategy, 200);
        std::printf("figure 5, %-24s %.2f s, mean %.4f, RMSE %.5f\n", strategy.name.c_str(),
                    found.seconds, found.mean, found.rmse);
    }
}

/// The same noise at any scale, and with lamps that shrink to nothing.
void scale() {
    for (const double factor : {1.0, 0.001, 1000.0}) {
        const Strategy strategy{"light_octree", octree(), 4};
        const Measured found =
            measure(shot_of_file("tests/bench/scaled.pov", {{"Scale", factor}}, strategy.sampler),
                    strategy, 120);
        std::printf("scale %g: mean %.5f, RMSE over mean %.5f\n", factor, found.mean,
                    found.rmse / found.mean);
    }
    for (const Strategy& strategy :
         {Strategy{"every_light", EveryLight{}, 1}, Strategy{"light_octree", octree(), 16}}) {
        const Measured found =
            measure(shot_of_file("tests/bench/scaled.pov", {{"Shrink", 0.8}}, strategy.sampler),
                    strategy, 120);
        std::printf("lamps that shrink by 0.8, %s: mean %.5f, RMSE over mean %.5f\n",
                    strategy.name.c_str(), found.mean, found.rmse / found.mean);
    }
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::pair<std::string, void (*)()>> rows = {
        {"choices", choices},     {"contributors", contributors},
        {"threshold", threshold}, {"split", split},
        {"samples", samples},     {"rays", rays},
        {"bulb", bulb},           {"few", few},
        {"scale", scale}};
    const std::vector<std::string> wanted(argv + 1, argv + argc);
    for (const auto& [name, run] : rows)
        if (wanted.empty() || std::ranges::find(wanted, name) != wanted.end()) run();
}
