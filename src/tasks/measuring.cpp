// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measuring.h"

#include "options/option_row.h"
#include "output/measurement.h"
#include "picture/file.h"
#include "text/message.h"
#include "text/printable.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace candelabra {

namespace {

/// See RenderSettings::quality.
constexpr int full_quality = 9;

/// Whether an option promises something that measuring does not do.
bool is_of_pictures(const OptionRow& row) {
    static constexpr auto words = std::to_array<std::string_view>(
        {"noise", "layers", "light-report", "keep-state", "checkpoint"});
    static constexpr auto switches = std::to_array<std::string_view>({"C", "SR", "ER", "SC", "EC"});
    return std::ranges::find(words, row.word) != words.end() ||
           std::ranges::find(switches, row.letters) != switches.end();
}

std::string name_of_task(const Options& options) {
    return options.task == Task::balance ? "--light-balance" : "--measure";
}

}  // namespace

std::function<bool()> ends_measuring(const SceneSteps& steps, bool& stopped) {
    return [&steps, &stopped, begun = seconds_now()] {
        const auto& take = steps.console().interrupts.take;
        stopped = stopped || (take && take() == Interrupt::stop);
        const auto& time = steps.options().time;
        return stopped || (time && seconds_now() - begun > *time);
    };
}

MeasureSettings measure_settings(const SceneSteps& steps, bool& stopped) {
    const RenderSettings& render = steps.options().render;
    MeasureSettings settings;
    settings.seed = render.seed;
    settings.threads = render.threads;
    settings.samples = render.samples;
    settings.goal = steps.options().meter_goal;
    settings.ended = ends_measuring(steps, stopped);
    return settings;
}

void check_measuring(const Options& options, Diagnostics& diagnostics) {
    const std::string name = name_of_task(options);
    for (const auto& [row, given] : options.given)
        if (row && is_of_pictures(*row))
            diagnostics.add(warning(
                Fault::option, {},
                message("`", printable(given), "` has no effect: ", name, " renders no picture")));
    if (options.render.quality < full_quality)
        diagnostics.add(warning(Fault::option, {},
                                message(name, " measures the light that pictures of quality ",
                                        options.render.quality, " have"))
                            .with_help("+Q9 has all light"));
    if (!options.shard.empty() && options.shard_by != ShardBy::frames)
        diagnostics.add(error(Fault::option, {}, name + " measures all at once, and has no shards")
                            .with_help("shards are for pictures, and for frames of animations"));
    if (!reading_format(options.readings_file))
        diagnostics.add(error(Fault::option, {},
                              message("results are written as CSV or JSON, which `",
                                      printable(options.readings_file), "` is not by its ending"))
                            .with_help(name + " light.csv, or light.json"));
    if (options.denoise)
        diagnostics.add(error(Fault::option, {},
                              name + " reports light as it is, and --denoise changes pictures"));
}

void review_moments(const Shot& shot, const Options& options, Diagnostics& diagnostics) {
    if (shot.moments() > 1)
        diagnostics.add(warning(Fault::no_effect, {},
                                message("the scene moves while its shutter is open, and ",
                                        name_of_task(options), " measures when it opens"))
                            .with_help("each frame of an animation has a table of its own"));
}

bool measures_as_json(const Options& options) {
    return options.for_caller || reading_format(options.readings_file) == ReadingFormat::json;
}

int write_measured(SceneSteps& steps, const std::string& table, const std::string& text,
                   bool stopped) {
    const Options& options = steps.options();
    if (options.readings_file == "-")
        steps.console().out(table);
    else if (write_file(options.readings_file, table, steps.diagnostics()) && options.verbose)
        steps.console().out(text);
    if (steps.say_diagnostics()) return exit_status::file;
    return stopped ? exit_status::stopped : exit_status::done;
}

}  // namespace candelabra
