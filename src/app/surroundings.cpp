// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/surroundings.h"

#include "app/sandbox.h"
#include "console/streams.h"
#include "options/ini.h"
#include "options/memory_limit.h"
#include "options/option_table.h"
#include "options/option_values.h"
#include "picture/file.h"
#include "text/loader.h"
#include "text/message.h"
#include "text/printable.h"
#include "text/scene_folders.h"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>

namespace candelabra {

namespace {

/// Returns the options in effect as an INI file: all settings of the run, and what else was given.
std::string ini_text(const Options& options) {
    std::string text;
    for (const OptionRow& row : option_table()) {
        if (row.field.empty() || row.unoffered != Unoffered::no) continue;
        for (const std::string& value : values_in_force(row, options)) {
            const bool switched_off = row.takes == Takes::nothing && value == "off";
            if (!switched_off) text += ini_line(ini_option(row, value)) + "\n";
        }
    }
    for (const GivenOption& option : options.given)
        if (!option.row || option.row->field.empty()) text += ini_line(option.line) + "\n";
    return text;
}

/// Warns of shell commands that the user has not permitted and drops them; the picture is made
/// without them.
void leave_out_commands(Options& options, Diagnostics& diagnostics) {
    if (options.commands.allowed) return;
    for (const CommandSettings::One& one : options.commands.all)
        if (!one.command.empty())
            diagnostics.add(warning(Fault::option, {},
                                    message(one.given,
                                            " is not run: commands are run only when "
                                            "that is permitted"))
                                .with_help("--allow-commands"));
    options.commands = {};
}

/// Warns if the scene reads nothing from the current directory, although it lies below it.
void warn_of_wide_folder(const Options& options, Diagnostics& diagnostics) {
    if (!options.scene || *options.scene == "-") return;
    const std::string wide = scene_folders(directory_of(*options.scene), {}).left_out;
    if (!wide.empty())
        diagnostics.add(
            warning(Fault::file_access, {},
                    message("the scene reads nothing from the current directory, `",
                            printable(wide), "`, since that is or holds a home, or the system"))
                .with_help("--allow-read FOLDER permits a folder of it"));
}

}  // namespace

int run_with_surroundings(Options options, const Console& console, Diagnostics& diagnostics,
                          const std::function<int(const Options&, const Console&)>& work) {
    // Measured once, before the run has allocated memory.
    if (!options.memory_bytes) options.memory_bytes = usual_memory_limit();
    options.libraries.insert(options.libraries.end(), console.first_libraries.begin(),
                             console.first_libraries.end());
    const auto end = [&](int status) {
        say_errors(console, options, diagnostics);
        return status;
    };
    if (options.ini_file && !write_file(*options.ini_file, ini_text(options), diagnostics))
        return end(exit_status::file);
    leave_out_commands(options, diagnostics);
    Streams streams(options.streams, console.err);
    const auto log_works = [&] {
        if (streams.problem().empty()) return true;
        Diagnostics problem = diagnostics.fresh();
        problem.add(error(Fault::io, {},
                          message("`", printable(streams.problem()), "` cannot be written to")));
        say_errors(console, options, problem);
        return false;
    };
    if (!log_works()) return exit_status::file;
    Console sorted = console;
    sorted.sorted = [&](Stream stream, std::string_view text, std::string_view plain) {
        streams.say(stream, text, plain);
    };
    sorted.made_files = std::make_shared<MadeFiles>(*options.scene);
    warn_of_wide_folder(options, diagnostics);
    const SandboxRules rules = sandbox_rules(options, console.library);
    if (!confined(options, rules, console, diagnostics)) return end(exit_status::usage);
    const int status = work(options, sorted);
    std::error_code not_empty;  // or it does not exist
    if (!rules.made.empty()) std::filesystem::remove(rules.made, not_empty);
    return log_works() || status != exit_status::done ? status : exit_status::file;
}

}  // namespace candelabra
