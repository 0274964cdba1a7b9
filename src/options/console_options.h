// SPDX-License-Identifier: GPL-3.0-or-later
// Handlers of the options for console output and shell commands. The table of options refers to
// these functions; options/option_store.h declares more of them.
#pragma once

#include "options/option_store.h"

namespace candelabra {

namespace store {

/// Handles +GD and its relatives: switches a stream on or off and may direct it to a file.
template <Stream stream>
void stream_switch(Options& options, const Given& given, Diagnostics&) {
    options.streams[stream].shown = given.on;
    if (given.value) options.streams[stream].file = *given.value;
}

/// Handles Debug_File and its relatives.
void stream_file(StreamSettings::One&, const Given&);
template <Stream stream>
void stream_file(Options& options, const Given& given, Diagnostics&) {
    stream_file(options.streams[stream], given);
}

void all_streams(Options&, const Given&, Diagnostics&);
void all_stream_files(Options&, const Given&, Diagnostics&);

template <Moment moment>
void command(Options& options, const Given& given, Diagnostics&) {
    options.commands[moment].command = *given.value;
    options.commands[moment].given = shown(given);
}

/// Handles Pre_Frame_Return and its relatives.
void command_return(CommandSettings::One&, const Given&, Diagnostics&);
template <Moment moment>
void command_return(Options& options, const Given& given, Diagnostics& diagnostics) {
    command_return(options.commands[moment], given, diagnostics);
}

void allow_commands(Options&, const Given&, Diagnostics&);

}  // namespace store

}  // namespace candelabra
