// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/console_options.h"

#include <cctype>

namespace candelabra {

void store::stream_file(StreamSettings::One& stream, const Given& given) {
    const std::optional<bool> on = truth(*given.value);
    // As in POV-Ray, `off` writes no file, and `on` writes one with a default name.
    if (!on) stream.file = *given.value;
    if (on && !*on) stream.file.clear();
}

void store::all_streams(Options& options, const Given& given, Diagnostics&) {
    for (StreamSettings::One& each : options.streams.all) {
        each.shown = given.on;
        if (given.value) each.file = *given.value;
    }
}

void store::all_stream_files(Options& options, const Given& given, Diagnostics&) {
    for (StreamSettings::One& each : options.streams.all) stream_file(each, given);
}

void store::command_return(CommandSettings::One& one, const Given& given,
                           Diagnostics& diagnostics) {
    std::string_view text = *given.value;
    one.inverted = text.starts_with('-') || text.starts_with('!');
    if (one.inverted) text.remove_prefix(1);
    const char letter =
        text.empty() ? ' ' : static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    if (std::string_view("ISAQUF").find(letter) == std::string_view::npos)
        return refuse(given, diagnostics,
                      "a command's return is one of ignore, skip, all, quit, user and fatal, with "
                      "a hyphen before it for success instead of failure");
    one.after = static_cast<After>(letter);
}

void store::allow_commands(Options& options, const Given&, Diagnostics&) {
    options.commands.allowed = true;
}

}  // namespace candelabra
