// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measuring.h"

#include "output/measurement.h"
#include "picture/file.h"
#include "text/message.h"
#include "text/printable.h"

namespace candelabra {

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
    const std::string name = options.task == Task::balance ? "--light-balance" : "--measure";
    if (!reading_format(options.readings_file))
        diagnostics.add(error(Fault::option, {},
                              message("results are written as CSV or JSON, which `",
                                      printable(options.readings_file), "` is not by its ending"))
                            .with_help(name + " light.csv, or light.json"));
    if (options.denoise)
        diagnostics.add(error(Fault::option, {},
                              name + " reports light as it is, and --denoise changes pictures"));
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
