// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/console_options.h"

#include "options/read_words.h"

namespace candelabra {

TEST_CASE("streams are switched one by one or together, and sent to files") {
    StreamSettings streams = read({"-GA", "+GDdebug.txt", "Warning_File=w.txt"}).streams;
    CHECK_FALSE(streams[Stream::fatal].shown);
    CHECK(streams[Stream::debug].shown);
    CHECK(streams[Stream::debug].file == "debug.txt");
    CHECK(streams[Stream::warning].file == "w.txt");
    streams = read({"+GAall.txt", "-GR", "Fatal_File=off"}).streams;
    CHECK(streams[Stream::statistics].file == "all.txt");
    CHECK_FALSE(streams[Stream::render].shown);
    CHECK(streams[Stream::fatal].file.empty());
}

TEST_CASE("commands have consequences by their letters") {
    const CommandSettings commands = read({"--allow-commands", "Pre_Frame_Command=a b",
                                           "Pre_Frame_Return=-skip", "Post_Scene_Return=F"})
                                         .commands;
    CHECK(commands.allowed);
    CHECK(commands.any());
    CHECK(commands[Moment::pre_frame].command == "a b");
    CHECK(commands[Moment::pre_frame].after == After::skip);
    CHECK(commands[Moment::pre_frame].inverted);
    CHECK(commands[Moment::post_scene].after == After::fatal);
    CHECK_FALSE(commands[Moment::post_scene].inverted);
    read({"Post_Frame_Return=7"}, false);
    CHECK_FALSE(read({}).commands.any());
}

}  // namespace candelabra
