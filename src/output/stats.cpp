// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/stats.h"

#include "base/parallel.h"
#include "console/progress.h"
#include "output/layers.h"
#include "output/light_report.h"
#include "text/message.h"
#include "world/shot.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <sys/resource.h>
#include <time.h>

namespace candelabra {

namespace {

using OrderedJson = nlohmann::ordered_json;

double read_clock(clockid_t which) {
    timespec time{};
    ::clock_gettime(which, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

OrderedJson phases(const RunStatistics& run, double Phase::*which) {
    return {{"parse", run.parse.*which},
            {"compile", run.compile.*which},
            {"render", run.render.*which},
            {"total", run.total.*which}};
}

}  // namespace

double seconds_now() { return read_clock(CLOCK_MONOTONIC); }

Phase time_now() { return {seconds_now(), read_clock(CLOCK_PROCESS_CPUTIME_ID)}; }

std::size_t peak_memory_bytes() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

void complete(RunStatistics& run, const Shot& shot, const RenderSettings& settings,
              const SourceStore& sources) {
    const World& world = *shot.world;
    run.objects = world.provenance.object_count;
    run.primitives = world.geometry.primitive_count();
    run.luminaires = world.lights.glowing();
    run.light_sources = world.lights.sources.size();
    run.index = Kinds<RayIndex>::infos[world.rules.settings.index.index()]->name;
    run.tree = statistics(world.geometry.tree);
    run.peak_memory_bytes = peak_memory_bytes();
    run.light_sampler_bytes =
        std::visit([](const auto& built) { return built.memory_bytes(); }, shot.sampler);
    const LightSampler& sampler = world.rules.settings.light_sampler;
    run.light_sampler = Kinds<LightSampler>::infos[sampler.index()]->name;
    if (traits(sampler).has_cells) run.light_octree_bytes = run.light_sampler_bytes;
    run.seed = settings.seed;
    run.threads = settings.threads > 0 ? settings.threads : core_count();
    run.width = settings.width;
    run.height = settings.height;
    run.samples = settings.samples;
    run.shadow_rays = settings.shadow_rays;
    if (run.rays.lights.empty()) return;
    const std::vector<std::string> names = light_names(world, sources);
    run.lights.resize(names.size());
    for (const LightRow& row : light_shares(world, run.rays).rows)
        run.lights[row.statement] = {
            names[row.statement],
            statement_text(world.provenance.light_statements[row.statement], sources), row.light,
            row.rays, row.lights};
}

namespace {

OrderedJson lights_as_json(const RunStatistics& run) {
    OrderedJson rows = OrderedJson::array();
    for (const LightStatistics& each : run.lights)
        rows.push_back({{"name", each.name},
                        {"statement", each.statement},
                        {"light", each.light},
                        {"rays", each.rays},
                        {"lights", each.lights}});
    return rows;
}

}  // namespace

std::string to_json(const RunStatistics& run) {
    const double pixels = static_cast<double>(run.width) * run.height;
    const OrderedJson json = {
        {"seconds", phases(run, &Phase::seconds)},
        {"cpu_seconds", phases(run, &Phase::cpu_seconds)},
        {"width", run.width},
        {"height", run.height},
        {"samples", run.samples},
        {"samples_per_pixel", pixels > 0 ? static_cast<double>(run.rays.camera) / pixels : 0.0},
        {"shadow_rays", run.shadow_rays},
        {"light_sampler", run.light_sampler},
        {"seed", run.seed},
        {"prepared_ahead", run.prepared_ahead},
        {"threads", run.threads},
        {"objects", run.objects},
        {"primitives", run.primitives},
        {"luminaires", run.luminaires},
        {"light_sources", run.light_sources},
        {"rays",
         {{"camera", run.rays.camera},
          {"shadow", run.rays.shadow},
          {"scattered", run.rays.scattered}}},
        {"lights", lights_as_json(run)},
        {"index", run.index},
        {run.index == KdTree::vocabulary.name ? "kdtree" : "bounding_boxes",
         {{"bytes", run.tree.bytes},
          {"nodes", run.tree.nodes},
          {"cells", run.tree.leaves},
          {"depth", run.tree.max_depth},
          {"references", run.tree.references},
          {"references_per_cell", run.tree.mean_items_per_leaf},
          {"cost", run.tree.cost}}},
        {"light_octree", {{"bytes", run.light_octree_bytes}}},
        {"light_sampler_bytes", run.light_sampler_bytes},
        {"peak_memory_bytes", run.peak_memory_bytes},
    };
    return json.dump(2) + "\n";
}

std::string short_count(double count) {
    static constexpr auto units = std::array{"", " k", " M", " G", " T"};
    std::size_t unit = 0;
    while (count >= 999.95 && unit + 1 < units.size()) {
        count /= 1000;
        ++unit;
    }
    if (unit == 0) return message(std::llround(count));
    const long long tenths = std::llround(count * 10);
    return message(tenths / 10, '.', tenths % 10, units[unit]);
}

std::string summary(const RunStatistics& run) {
    const auto rays = [](std::uint64_t count) { return short_count(static_cast<double>(count)); };
    return message(run.width, " x ", run.height, " in ", duration(run.total.seconds), ": ",
                   run.objects, run.objects == 1 ? " object, " : " objects, ", run.luminaires,
                   run.luminaires == 1 ? " luminaire (" : " luminaires (", run.light_sampler, "); ",
                   rays(run.rays.camera), " camera, ", rays(run.rays.shadow), " shadow, ",
                   rays(run.rays.scattered), " scattered rays");
}

}  // namespace candelabra
