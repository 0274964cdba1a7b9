// SPDX-License-Identifier: GPL-3.0-or-later
// What light costs: noise, CPU time and memory of the light samplers on scenes with few to a
// million luminaires, all in one run. Run by hand; names of rows choose some:
//   light_bench [flake] [city] [growth] [room] [glossy] [sources] [sun] [horizon] [figure2]
//   [figure5] [million]
// Noise is that of two pictures with different seeds against each other, so no converged picture is
// needed: half of their mean squared difference is the variance of a pixel. Figures of a row are
// comparable with each other; times are CPU seconds of rendering in one thread.
#include "luminaire/composite.h"
#include "noise.h"
#include "support/choices.h"
#include "support/lights.h"
#include "support/scripts.h"

#include <algorithm>
#include <cstdio>

using namespace candelabra;

namespace {

const std::vector<Strategy>& usual() {
    static const std::vector<Strategy> strategies = {{"light_bvh { mis }", pair()},
                                                     {"light_bvh", LightBvh{}},
                                                     {"light_octree { paper }", paper()},
                                                     {"light_octree { alone }", alone()},
                                                     {"light_octree", octree()},
                                                     {"light_octree, 4 rays", octree(), 4, 4},
                                                     {"light_bvh { mis }, 4", pair(), 4, 4},
                                                     {"light_octree, as pays", octree(), 4, 0}};
    return strategies;
}

/// A row for each strategy; the first is the opponent.
void compare(const std::string& title, const std::string& file, const Declares& declares,
             const std::vector<Strategy>& strategies, int size) {
    double opponent = 0;
    for (const Strategy& strategy : strategies) {
        const Shot shot = shot_of_file(file, declares, strategy.sampler, size);
        const Measured found = measure(shot, strategy, size);
        if (opponent == 0) opponent = found.work();
        std::printf(
            "%-22s %7zu  %-24s %3d x %d %8.2f s  mean %.4f  RMSE %.5f  at equal time %.3f\n",
            title.c_str(), shot.world->lights.glowing() + shot.world->lights.sources.size(),
            strategy.name.c_str(), strategy.samples, strategy.shadow_rays, found.seconds,
            found.mean, found.rmse, found.work() / opponent);
        std::fflush(stdout);
    }
}

/// [claim-18]
void flake() {
    compare("flake pair", "examples/paper/fig6.pov", {}, usual(), 320);
    for (const Strategy& strategy :
         {Strategy{"constant_alpha", ConstantAlpha{}, 10}, Strategy{"light_bvh", LightBvh{}, 10},
          Strategy{"light_octree", octree(), 10}, Strategy{"light_octree, as pays", octree(), 4, 0},
          Strategy{"light_octree { alone }", alone(), 10}}) {
        const auto seconds = [&](const Declares& declares) {
            return measure(shot_of_file("examples/paper/fig6.pov", declares, strategy.sampler),
                           strategy, 320)
                .seconds;
        };
        const double many = seconds({}), one = seconds({{"Luminaires", 1.0}});
        std::printf("flake pair: 7381 luminaires over one, %s: %.2f s / %.2f s = %.2f\n",
                    strategy.name.c_str(), many, one, many / one);
    }
}

/// [claim-32]
void city() {
    for (const double blocks : {12.0, 36.0})
        compare("city", "examples/gallery/city.pov", {{"Blocks", blocks}}, usual(), 320);
}

/// What more luminaires cost when the view stays as it is: more houses with theirs, or more lit
/// windows and lamps of the same houses, so that all else is the same. [claim-32]
void growth() {
    const auto row = [](const std::string& title, const std::vector<Declares>& series) {
        double seconds = 0, noise = 0;
        for (const Declares& declares : series) {
            const Strategy strategy{"light_octree", octree(), 4, 0};
            const Shot shot =
                shot_of_file("examples/gallery/city.pov", declares, strategy.sampler, 160);
            const Measured found = measure(shot, strategy, 160);
            const double relative = found.rmse / found.mean;
            if (seconds == 0) seconds = found.seconds, noise = relative;
            std::printf("%s, %7zu luminaires: %.2f s (%.2f), RMSE over mean %.3f (%.2f)\n",
                        title.c_str(), shot.world->lights.glowing(), found.seconds,
                        found.seconds / seconds, relative, relative / noise);
            std::fflush(stdout);
        }
    };
    std::vector<Declares> houses, windows;
    for (const double blocks : {1.0, 3.0, 10.0, 31.0, 100.0})
        houses.push_back({{"Blocks", blocks}});
    for (const double lit : {0.00017, 0.0017, 0.017, 0.17, 1.0})
        windows.push_back({{"Blocks", 100.0}, {"Lit", lit}});
    row("city, more houses", houses);
    row("city, more windows lit", windows);
}

/// Luminaires beside surfaces that shine: a flake, and many small lamps.
void glossy() {
    const std::vector<Strategy> strategies = {{"light_bvh { mis }", pair()},
                                              {"light_bvh { mis }, 4", pair(), 4, 4},
                                              {"light_octree", octree()},
                                              {"light_octree, as pays", octree(), 4, 0}};
    const char* kinds[] = {"metal", "facets", "highlights", "highlights only"};
    for (int kind = 0; kind < 4; ++kind) {
        const Declares flake = {{"Kind", static_cast<double>(kind)}};
        Declares lamps = flake;
        lamps.emplace_back("Lamps", 3000.0);
        compare(kinds[kind], "tests/bench/glossy.pov", flake, strategies, 200);
        compare(kinds[kind] + std::string(", lamps"), "tests/bench/glossy.pov", lamps, strategies,
                200);
    }
}

/// 10,000 light sources, and as many glowing spheres in their places.
void sources() {
    double spheres = 0;
    for (const auto& [name, kind] :
         {std::pair{"glowing spheres", 2.0}, {"points", 0.0}, {"spots", 1.0}}) {
        const Strategy strategy{"light_octree", octree()};
        const Shot shot =
            shot_of_file("tests/bench/sources.pov", {{"Kind", kind}}, strategy.sampler, 200);
        const Measured found = measure(shot, strategy, 200);
        if (spheres == 0) spheres = found.seconds;
        std::printf("10000 %s: %.2f s, %.2f times the spheres', RMSE over mean %.3f\n", name,
                    found.seconds, found.seconds / spheres, found.rmse / found.mean);
        std::fflush(stdout);
    }
}

/// A closed room whose walls are triangles that all glow, and 16 boxes in it. [claim-31]
void room() {
    for (const double side : {29.0, 91.0, 289.0})
        compare("infrared room", "tests/bench/room.pov", {{"Side", side}}, usual(), 200);
    for (const Strategy& strategy : usual()) {
        const Shot shot = shot_of_file("tests/bench/room.pov", {{"Side", 29.0}, {"Same", 1.0}},
                                       strategy.sampler, 100);
        const Measured found = measure(shot, strategy, 100);
        std::printf("isothermal room, %s: deviation %.2e\n", strategy.name.c_str(),
                    found.rmse / found.mean);
    }
}

/// A glaring luminaire that is seen from nowhere in the picture. [claim-27]
void sun() {
    double without = 0;
    for (const double there : {0.0, 1.0}) {
        const Strategy strategy{"light_octree", octree(), 16};
        const Measured found =
            measure(shot_of_file("tests/bench/sun.pov", {{"Sun", there}}, strategy.sampler, 200),
                    strategy, 200);
        if (without == 0) without = found.rmse;
        std::printf("hidden sun: %d, RMSE %.5f, %.2f times that without\n", there > 0, found.rmse,
                    found.rmse / without);
    }
}

/// What horizon() draws: the kinds of emitter(), and a torus, which has no formula.
constexpr int horizon_kinds = emitter_kinds + 1;
Emitter any_emitter(int kind, Draw& draw) {
    const Vec3 place = draw.point(4);
    const double size = std::pow(10, draw.between(-2, 0));
    if (kind < emitter_kinds) return emitter(kind, place, size, draw);
    CompositeBuilder builder;
    const Transform turned = Transform::rotation(draw.point(180));
    const PartRef torus =
        builder.add({Torus{size, size / 3},
                     make_handle<Transform>(turned.then(Transform::translation(place)))});
    return composite_emitter(make_handle<Composite>(builder.finish(torus)), torus.index);
}

/// A light that can reach a point must have a chance there, alone or in a cluster: 10^7 cases for
/// each kind, with the luminaire across the horizon. What a rule that asks for the centre would
/// lose is counted, too: the planted error is seen. [claim-9]
void horizon() {
    constexpr long wanted = 10'000'000;
    struct Cases {
        long lit = 0, lost = 0, lost_by_centre = 0;
    };
    Draw draw(1);
    std::array<Cases, horizon_kinds> cases;
    while (std::ranges::any_of(cases, [](const Cases& c) { return c.lit < wanted; })) {
        std::vector<Luminaire> luminaires;
        for (int i = 0; i < 3 * horizon_kinds; ++i)
            luminaires.push_back(glowing(any_emitter(i % horizon_kinds, draw)));
        const Box surface{Vec3(-4), Vec3(4)};
        LightOctree settings;
        settings.cut = 6;
        const BuiltCutOctree built(settings, LightScene{choices(luminaires), {&surface, 1}});
        for (int i = 0; i < 300000; ++i) {
            const auto light = static_cast<LightIndex>(draw.number() * luminaires.size());
            Cases& kind = cases[light % horizon_kinds];
            if (kind.lit >= wanted) continue;
            const LightBounds b = bounds(luminaires[light]);
            Receiver point{draw.point(6), draw.direction(), lit_from(i % 11 == 0)};
            if (i % 4 != 0) point.position = point_around(b.centre, b.radius, draw);
            const auto s =
                sample(luminaires[light], point.position, {draw.number(), draw.number()});
            if (!s) continue;
            const Vec3 level = cross(cross(s->direction, point.normal), s->direction);
            point.normal = unit(unit(level) + std::pow(10, draw.between(-9, 0)) * s->direction);
            if (!(dot(s->direction, point.normal) > 1e-12)) continue;
            ++kind.lit;
            const BsdfLobes lobes;
            const auto answer = built.at({point, lobes, nullptr, nullptr});
            kind.lost += !(answer.expected(Key{}, light) > 0);
            kind.lost_by_centre += point.horizon == Horizon::one_side &&
                                   dot(b.centre - point.position, point.normal) < 0;
        }
    }
    for (int kind = 0; kind < horizon_kinds; ++kind)
        std::printf(
            "horizon, kind %2d: %ld cases, %ld without a chance; by centres alone it would be "
            "%ld\n",
            kind, cases[kind].lit, cases[kind].lost, cases[kind].lost_by_centre);
}

/// [claim-3]
void figure2() {
    for (const Strategy& strategy :
         {Strategy{"light_bvh", LightBvh{}, 1}, Strategy{"light_octree", octree(), 1}}) {
        const Measured found =
            measure(shot_of_file("examples/paper/fig2.pov", {}, strategy.sampler), strategy, 160);
        std::printf("figure 2, %s: relative noise %.2e\n", strategy.name.c_str(),
                    found.rmse / found.mean);
    }
}

/// How uncertain the pixels around one are, at most: how many samples a pixel gets owes nothing to
/// its own, as the renderer does it.
double variance_around(const Film& film, int x, int y) {
    double most = 0;
    for (int v = std::max(0, y - 1); v <= std::min(film.height() - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(film.width() - 1, x + 1); ++u)
            if (u != x || v != y) most = std::max(most, film.at(u, v).variance_of_mean());
    return most;
}

/// The pixels with the noisiest neighbours after 9 samples get 30. [claim-16]
void figure5() {
    constexpr int size = 256;
    const Strategy uniform{"light_octree", octree(), 9};
    const Shot shot = shot_of_file("examples/paper/fig5.pov", {}, uniform.sampler, size);
    RenderSettings settings = settings_for(uniform, size);
    const auto refined = [&](int seed) {
        settings.seed = seed;
        RenderState state = begin_picture(settings);
        LightLedger rays;
        advance(plan_of(shot, settings), state, rays, {});
        std::vector<double> variances;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) variances.push_back(variance_around(state.film, x, y));
        std::vector<double> sorted = variances;
        std::ranges::sort(sorted);
        const double bound = sorted[static_cast<std::size_t>(0.91 * size * size)];
        for (std::size_t i = 0; i < variances.size(); ++i)
            if (variances[i] > bound) state.film.pixels()[i].planned = 30;
        advance(plan_of(shot, settings), state, rays, {});
        return state.film;
    };
    const Film a = refined(0), b = refined(1);
    double squares = 0, samples = 0, more = 0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        const double d = grey(a.pixels()[i].mean()) - grey(b.pixels()[i].mean());
        squares += d * d / 2;
        samples += a.pixels()[i].samples;
        more += a.pixels()[i].samples > 9;
    }
    const auto count = static_cast<double>(a.pixels().size());
    const double rmse = std::sqrt(squares / count), mean = samples / count;
    const auto even = [&](int n) {
        return measure(shot, {"light_octree", octree(), n}, size).rmse;
    };
    const int below = static_cast<int>(mean);
    const double among = mean - below, equal = (1 - among) * even(below) + among * even(below + 1);
    std::printf(
        "figure 5, %zu luminaires: %.1f %% of the pixels refined, %.2f samples a pixel, "
        "RMSE %.5f, %.2f times that of as many everywhere\n",
        shot.world->lights.glowing(), 100 * more / count, mean, rmse, rmse / equal);
}

void million() {
    Draw draw(1);
    std::vector<Luminaire> luminaires(1000000);
    for (Luminaire& luminaire : luminaires) {
        luminaire.emitter = SphereEmitter{draw.point(100), 0.01 + 0.05 * draw.number()};
        luminaire.radiance = Rgb(1 + draw.number());
        luminaire.primitive = 0;
    }
    const std::vector<Box> surfaces = {{Vec3(-100), Vec3(100)}};
    const LightScene scene{choices(luminaires), surfaces};
    for (const Strategy& strategy :
         {Strategy{"light_bvh", LightBvh{}}, Strategy{"light_octree", octree()}}) {
        const double start = cpu_seconds();
        const BuiltLightSampler built = build(strategy.sampler, scene, 1);
        const double end = cpu_seconds();
        const std::size_t bytes = std::visit([](const auto& b) { return b.memory_bytes(); }, built);
        std::printf("a million luminaires, %s: built in %.2f s, %.1f bytes each\n",
                    strategy.name.c_str(), end - start, static_cast<double>(bytes) / 1e6);
        constexpr int choices = 200000;
        LightSamples samples;
        for (const bool again : {false, true}) {
            Draw where(2);
            const double begin = cpu_seconds();
            for (int i = 0; i < choices; ++i) {
                samples.clear();
                add_picks(built, {where.point(50), where.direction()}, {1, 2, 3, 4}, samples);
            }
            std::printf("  %.0f ns a choice, %s\n", 1e9 * (cpu_seconds() - begin) / choices,
                        again ? "again" : "first at random points");
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::pair<std::string, void (*)()>> rows = {
        {"flake", flake},     {"city", city},       {"growth", growth},  {"room", room},
        {"glossy", glossy},   {"sources", sources}, {"sun", sun},        {"horizon", horizon},
        {"figure2", figure2}, {"figure5", figure5}, {"million", million}};
    const std::vector<std::string> wanted(argv + 1, argv + argc);
    for (const auto& [name, run] : rows)
        if (wanted.empty() || std::ranges::find(wanted, name) != wanted.end()) run();
}
