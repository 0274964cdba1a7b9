// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/kept_lights.h"

#include "options/output.h"
#include "output/film_images.h"
#include "output/layers.h"
#include "picture/file.h"
#include "relight/light_recorder.h"
#include "relight/record_file.h"
#include "text/message.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

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
    const bool part = !options.shard.empty() && options.shard_by != ShardBy::frames;
    if (options.task != Task::render || options.preview_port)
        refuse("--keep-lights is for pictures that are rendered to the end", "", diagnostics);
    else if (part)
        refuse("--keep-lights needs the whole picture, and a shard is a part of it",
               "--layers lights goes with shards", diagnostics);
    else if (options.draft)
        refuse("--keep-lights keeps light as it is, and --draft averages it",
               "--denoise averages it in a picture beside the exact one", diagnostics);
    else if (is_stream(options.kept_lights))
        refuse("--keep-lights needs a file, and not a stream", "--keep-lights scene.lights",
               diagnostics);
}

std::unique_ptr<LightRecorder> light_recorder(const World& world, const SourceStore& sources,
                                              const PictureFormat& format, const Options& options,
                                              Diagnostics& diagnostics) {
    if (options.kept_lights.empty()) return nullptr;
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
    return std::make_unique<LightRecorder>(std::move(lamps), plan);
}

void write_kept_lights(LightRecorder& recorder, const Film& film, const FilmFiles& files,
                       const Options& options, Diagnostics& diagnostics) {
    LightRecords records = recorder.finish(film, files.threads);
    records.origin = files.format.description;
    if (files.film.on) records.film = to_text(files.film);
    if (options.alpha)
        for (const double alpha : alpha_of(film))
            records.alpha.push_back(std::clamp(static_cast<float>(alpha), 0.0F, 1.0F));
    write_file(options.kept_lights, encode(records, files.threads), diagnostics);
}

}  // namespace candelabra
