// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measuring.h"

#include "output/measurement.h"
#include "picture/file.h"

namespace candelabra {

std::function<bool()> ends_measuring(const SceneSteps& steps, bool& stopped) {
    return [&steps, &stopped, begun = seconds_now()] {
        const auto& take = steps.console().interrupts.take;
        stopped = stopped || (take && take() == Interrupt::stop);
        const auto& time = steps.options().time;
        return stopped || (time && seconds_now() - begun > *time);
    };
}

bool measures_as_json(const Options& options) {
    return reading_format(options.readings_file) == ReadingFormat::json;
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
