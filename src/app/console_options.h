// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of the options for what is said, and for commands that are run. The table of options
// names these functions; more of the kind are in app/option_store.h.
#pragma once

#include "app/option_store.h"

namespace candelabra {

namespace store {

/// +GD and its relatives: the stream on or off, and perhaps into a file.
template <Stream stream>
void stream_switch(Options& options, const Given& given, Diagnostics&) {
    options.streams[stream].shown = given.on;
    if (given.value) options.streams[stream].file = *given.value;
}

/// Debug_File and its relatives.
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

/// Pre_Frame_Return and its relatives.
void command_return(CommandSettings::One&, const Given&, Diagnostics&);
template <Moment moment>
void command_return(Options& options, const Given& given, Diagnostics& diagnostics) {
    command_return(options.commands[moment], given, diagnostics);
}

void allow_commands(Options&, const Given&, Diagnostics&);

}  // namespace store

}  // namespace candelabra
