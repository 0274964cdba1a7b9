// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/streams.h"

#include "support/folder.h"
#include "support/shell.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("what is said goes to the console, to files, or both") {
    Folder folder;
    std::string said;
    StreamSettings settings;
    settings[Stream::debug] = {false, folder / "a.txt"};
    settings[Stream::warning] = {true, folder / "a.txt"};
    Streams streams(settings, [&](std::string_view text) { said += text; });
    CHECK(streams.problem().empty());
    streams.say(Stream::debug, "1\n", "1\n");
    streams.say(Stream::warning, "[red]2\n", "2\n");
    streams.say(Stream::fatal, "3\n", "3\n");
    CHECK(said == "[red]2\n3\n");
    CHECK(folder.get("a.txt") == "1\n2\n");
    settings[Stream::fatal].file = folder / "none/b.txt";
    CHECK(Streams(settings, {}).problem() == folder / "none/b.txt");
}

TEST_CASE("what a scene says appears without progress, too, and ends its line", "[app]") {
    Shell shell;
    shell.write("talks.pov", std::string("#debug \"a=\" #warning \"beware\"\n") + lit_scene);
    REQUIRE(shell({shell.path("talks.pov"), "+W8", "+H8", "-F", "-V",
                   "+GD" + shell.path("debug.txt")}) == exit_status::done);
    CHECK(shell.err.starts_with("a=\nwarning[user-warning]: beware\n"));
    CHECK_FALSE(has(shell.err, "rays"));
    CHECK(shell.content("debug.txt") == "a=\n");
}

TEST_CASE("POV-Ray's switches for its consoles sort what a run says") {
    Shell shell;
    shell.write("talks.pov", std::string("#debug \"hello\\n\" #warning \"beware\"\n") + lit_scene);
    const std::vector<std::string> run = {shell.path("talks.pov"), "+W8", "+H8", "-F"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.end(), run.begin(), run.end());
        return shell(more);
    };
    REQUIRE(with({"-GA", "+GD" + shell.path("debug.txt")}) == exit_status::done);
    CHECK(shell.err == "hello\n");
    CHECK(shell.content("debug.txt") == "hello\n");
    REQUIRE(with({"All_File=" + shell.path("all.txt"), "-GW"}) == exit_status::done);
    CHECK_FALSE(has(shell.err, "beware"));
    CHECK(has(shell.content("all.txt"), "hello\n"));
    CHECK(has(shell.content("all.txt"), "beware"));
    CHECK(has(shell.content("all.txt"), "rays"));
    CHECK(with({"+GF" + shell.path("none/x.txt")}) == exit_status::file);
}

}  // namespace candelabra
