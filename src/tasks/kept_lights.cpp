// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/kept_lights.h"

#include "meter/places.h"
#include "options/output.h"
#include "output/film_images.h"
#include "output/layers.h"
#include "picture/file.h"
#include "relight/light_recorder.h"
#include "relight/record_file.h"
#include "render/measure.h"
#include "render/seen_normals.h"
#include "tasks/measuring.h"
#include "text/message.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace candelabra {

namespace {

std::nullptr_t refuse(std::string text, std::string help, Diagnostics& diagnostics) {
    diagnostics.add(error(Fault::option, {}, std::move(text)).with_help(std::move(help)));
    return nullptr;
}

}  // namespace

void check_kept_lights(const Options& options, Diagnostics& diagnostics) {
    if (options.kept_lights.empty()) {
        if (options.kept_lights_bytes)
            diagnostics.add(warning(Fault::option, {},
                                    "--keep-lights-size is the size of a file that nobody asks for")
                                .with_help("--keep-lights FILE"));
        return;
    }
    const bool part = !options.shard.empty() && options.shard_by != ShardBy::frames &&
                      options.shard_by != ShardBy::tiles;
    if (options.task != Task::render || options.preview_port)
        refuse("--keep-lights is for pictures that are rendered to the end", "", diagnostics);
    else if (part)
        refuse("--keep-lights needs all samples of a pixel, and a shard by samples has some",
               "--shard-by tiles", diagnostics);
    else if (options.draft)
        refuse("--keep-lights keeps light as it is, and --draft averages it",
               "--denoise averages it in a picture beside the exact one", diagnostics);
    else if (is_stream(options.kept_lights))
        refuse("--keep-lights needs a file, and not a stream", "--keep-lights scene.lights",
               diagnostics);
}

std::unique_ptr<LightRecorder> light_recorder(const Shot& shot, const SourceStore& sources,
                                              const PictureFormat& format, const Options& options,
                                              Diagnostics& diagnostics) {
    if (options.kept_lights.empty()) return nullptr;
    const World& world = *shot.world;
    const int width = options.render.width, height = options.render.height;
    RecordPlan plan{width, height, 0, record_overhead(width, height, options.alpha)};
    plan.bytes = options.kept_lights_bytes.value_or(usual_record_bytes(width, height));
    WorldLamps lamps = world_lamps(world, light_names(world, sources));
    if (format.gamma != 1 || !format.encoded)
        return refuse("--keep-lights is for light as it is", "global_settings { assumed_gamma 1 }",
                      diagnostics);
    if (lamps.list.size() == 0)
        return refuse("the scene has no lamps whose light could be kept",
                      "a glowing object, or a light_source", diagnostics);
    constexpr std::uint64_t kilobyte = 1 << 10;
    const std::uint64_t least = least_record_bytes(plan, lamps.list) / kilobyte + 1;
    if (plan.bytes < least * kilobyte)
        return refuse(
            message("the light of ", lamps.list.size(), lamps.list.size() == 1 ? " lamp" : " lamps",
                    " in a picture of ", width, "x", height, " needs ", least, " kB"),
            message("--keep-lights-size ", least, "K"), diagnostics);
    auto recorder = std::make_unique<LightRecorder>(std::move(lamps), plan);
    recorder->keep(seen_normals(shot, width, height, options.render.threads));
    return recorder;
}

bool keep_meters(LightRecorder& recorder, SceneSteps& steps, const Shot& shot,
                 std::span<const Meter> all) {
    // One shard measures for all.
    if (steps.shard() && steps.shard()->number > 1) return true;
    const double metres = shot.world->rules.settings.light_units().metres;
    std::vector<Meter> meters;
    std::size_t points = 0;
    for (const Meter& meter : all) {
        const std::size_t own = is_sum_of_lamps(meter) ? places_of(meter, metres).size() : 0;
        if (own > 0) meters.push_back(meter);
        points += own;
    }
    if (meters.empty()) return true;
    std::vector<LampRange> nodes = nodes_for_points(recorder.lamps(), points);
    std::vector<std::size_t> columns(recorder.lamps().size());
    for (std::size_t n = 0; n < nodes.size(); ++n)
        for (std::uint32_t lamp = nodes[n].first; lamp < nodes[n].last; ++lamp)
            columns[lamp] = 3 * n;
    bool stopped = false;
    MeasureSettings settings = measure_settings(steps, stopped);
    settings.lamps = {3 * nodes.size(), [&](Lamp lamp) { return columns[recorder.place_of(lamp)]; },
                      true};
    const std::vector<MeterReading> readings = measure(shot, meters, settings);
    recorder.keep(kept_meters(meters, readings, std::move(nodes)));
    return !stopped;
}

LightRecords write_kept_lights(const LightRecorder& recorder, const Film& film,
                               const FilmFiles& files, const std::string& path,
                               Diagnostics& diagnostics) {
    LightRecords records = recorder.finish(film, files.threads);
    records.origin = files.format.description;
    if (files.film.on) records.film = to_text(files.film);
    if (files.alpha)
        for (const double alpha : alpha_of(film))
            records.alpha.push_back(std::clamp(static_cast<float>(alpha), 0.0F, 1.0F));
    write_file(path, encode(records, files.threads), diagnostics);
    return records;
}

}  // namespace candelabra
