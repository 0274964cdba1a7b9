// SPDX-License-Identifier: GPL-3.0-or-later
// What light costs: noise, CPU time and memory of the light samplers on scenes with few to a
// million luminaires, all in one run. Run by hand; names of rows choose some:
//   light_bench [flake] [city] [room] [figure2] [million]
// Noise is that of two pictures with different seeds against each other, so no converged picture is
// needed: half of their mean squared difference is the variance of a pixel. Figures of a row are
// comparable with each other; times are CPU seconds of rendering in one thread.
#include "evaluate/evaluate.h"
#include "render/render.h"
#include "support/draw.h"
#include "support/scripts.h"
#include "world/compile.h"

#include <ctime>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace {

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Strategy {
    std::string name;
    LightSampler sampler;
    int samples = 10;
    int shadow_rays = 1;
};

struct Measured {
    double mean = 0, rmse = 0, seconds = 0;
    double work() const { return rmse * std::sqrt(seconds); }
};

RenderSettings settings_for(const Strategy& strategy, int size) {
    RenderSettings settings;
    settings.width = settings.height = size;
    settings.antialias = false;
    settings.samples = strategy.samples;
    settings.shadow_rays = strategy.shadow_rays;
    settings.threads = 1;
    return settings;
}

/// Pixels that look straight at a luminaire have no noise; the noise of the others is measured all
/// the same.
Measured measure(const World& world, const Strategy& strategy, int size) {
    RenderSettings settings = settings_for(strategy, size);
    const double start = cpu_seconds();
    const Image a = render(world, settings).image;
    const double end = cpu_seconds();
    settings.seed = 1;
    const Image b = render(world, settings).image;
    Measured result;
    double squares = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const double x = grey(a.pixels[i]), y = grey(b.pixels[i]);
        result.mean += (x + y) / 2;
        squares += (x - y) * (x - y) / 2;
    }
    const auto count = static_cast<double>(a.pixels.size());
    result.mean /= count;
    result.rmse = std::sqrt(squares / count);
    result.seconds = end - start;
    return result;
}

LightOctree octree() { return {}; }
LightOctree alone() {
    LightOctree result;
    result.alone = true;
    return result;
}
LightOctree paper() {
    LightOctree result;
    result.paper = true;
    return result;
}
LightBvh pair() {
    LightBvh result;
    result.mis = true;
    return result;
}

const std::vector<Strategy>& usual() {
    static const std::vector<Strategy> strategies = {
        {"light_bvh { mis }", pair()},       {"light_bvh", LightBvh{}},
        {"light_octree { paper }", paper()}, {"light_octree { alone }", alone()},
        {"light_octree", octree()},          {"light_octree, 4 rays", octree(), 4, 4}};
    return strategies;
}

/// A row for each strategy; the first is the opponent.
void compare(const std::string& title, const std::string& file, const Declares& declares,
             const std::vector<Strategy>& strategies, int size) {
    double opponent = 0;
    for (const Strategy& strategy : strategies) {
        const World world = world_of_file(file, declares, strategy.sampler, size);
        const Measured found = measure(world, strategy, size);
        if (opponent == 0) opponent = found.work();
        std::printf(
            "%-22s %7zu  %-24s %3d x %d %8.2f s  mean %.4f  RMSE %.5f  at equal time %.3f\n",
            title.c_str(), world.luminaires.size(), strategy.name.c_str(), strategy.samples,
            strategy.shadow_rays, found.seconds, found.mean, found.rmse, found.work() / opponent);
        std::fflush(stdout);
    }
}

void flake() {
    compare("flake pair", "examples/paper/fig6.pov", {}, usual(), 320);
    for (const Strategy& strategy :
         {Strategy{"light_bvh", LightBvh{}, 10}, Strategy{"light_octree", octree(), 10},
          Strategy{"light_octree { alone }", alone(), 10}}) {
        const auto seconds = [&](const Declares& declares) {
            return measure(world_of_file("examples/paper/fig6.pov", declares, strategy.sampler),
                           strategy, 320)
                .seconds;
        };
        const double many = seconds({}), one = seconds({{"Luminaires", 1.0}});
        std::printf("flake pair: 7381 luminaires over one, %s: %.2f s / %.2f s = %.2f\n",
                    strategy.name.c_str(), many, one, many / one);
    }
}

void city() {
    for (const double blocks : {12.0, 36.0})
        compare("city", "examples/gallery/city.pov", {{"Blocks", blocks}}, usual(), 320);
}

/// A closed room whose walls are triangles that all glow, and 16 boxes in it.
void room() {
    for (const double side : {29.0, 91.0})
        compare("infrared room", "tests/bench/room.pov", {{"Side", side}}, usual(), 200);
    for (const Strategy& strategy : usual()) {
        const World world = world_of_file("tests/bench/room.pov", {{"Side", 29.0}, {"Same", 1.0}},
                                          strategy.sampler, 100);
        const Measured found = measure(world, strategy, 100);
        std::printf("isothermal room, %s: deviation %.2e\n", strategy.name.c_str(),
                    found.rmse / found.mean);
    }
}

void figure2() {
    for (const Strategy& strategy :
         {Strategy{"light_bvh", LightBvh{}, 1}, Strategy{"light_octree", octree(), 1}}) {
        const Measured found =
            measure(world_of_file("examples/paper/fig2.pov", {}, strategy.sampler), strategy, 160);
        std::printf("figure 2, %s: relative noise %.2e\n", strategy.name.c_str(),
                    found.rmse / found.mean);
    }
}

void million() {
    Draw draw(1);
    std::vector<Luminaire> luminaires(1000000);
    for (Luminaire& luminaire : luminaires) {
        luminaire.emitter = SphereEmitter{draw.point(100), 0.01 + 0.05 * draw.number()};
        luminaire.radiance = Vec3(1 + draw.number());
        luminaire.primitive = 0;
    }
    const std::vector<Box> surfaces = {{Vec3(-100), Vec3(100)}};
    const LightScene scene{luminaires, surfaces};
    for (const Strategy& strategy :
         {Strategy{"light_bvh", LightBvh{}}, Strategy{"light_octree", octree()}}) {
        const double start = cpu_seconds();
        const BuiltLightSampler built = build(strategy.sampler, scene, 1);
        const double end = cpu_seconds();
        const std::size_t bytes = std::visit([](const auto& b) { return b.memory_bytes(); }, built);
        std::printf("a million luminaires, %s: built in %.2f s, %.1f bytes each\n",
                    strategy.name.c_str(), end - start, static_cast<double>(bytes) / 1e6);
        constexpr int choices = 200000;
        LightPicks picks;
        for (const bool again : {false, true}) {
            Draw where(2);
            const double begin = cpu_seconds();
            for (int i = 0; i < choices; ++i) {
                picks.clear();
                const ShadingPoint point{where.point(50), where.direction(), false};
                std::visit([&](const auto& b) { b.choose(point, Key{1, 2, 3, 4}, picks); }, built);
            }
            std::printf("  %.0f ns a choice, %s\n", 1e9 * (cpu_seconds() - begin) / choices,
                        again ? "again" : "first at random points");
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::pair<std::string, void (*)()>> rows = {{"flake", flake},
                                                                  {"city", city},
                                                                  {"room", room},
                                                                  {"figure2", figure2},
                                                                  {"million", million}};
    const std::vector<std::string> wanted(argv + 1, argv + argc);
    for (const auto& [name, run] : rows)
        if (wanted.empty() || std::ranges::find(wanted, name) != wanted.end()) run();
}
