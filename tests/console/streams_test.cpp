// SPDX-License-Identifier: GPL-3.0-or-later
#include "console/streams.h"

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

TEST_CASE("a log on a full disk is a failure, and one that leads elsewhere is not written") {
    Shell shell;
    CHECK(shell({shell.path("lit.pov"), "+W4", "+H4", "-F", "+GA/dev/full"}) == exit_status::file);
    CHECK(has(shell.err, "`/dev/full` cannot be written to"));
    std::filesystem::create_directories(shell.path("out"));
    shell.write("precious", "mine");
    std::filesystem::create_symlink("../precious", shell.path("out/log.txt"));
    CHECK(shell({shell.path("lit.pov"), "+W4", "+H4", "-F", "+GD" + shell.path("out/log.txt")}) ==
          exit_status::file);
    CHECK(shell.content("precious") == "mine");
}

TEST_CASE("what a scene says acts on no terminal, and on no manager of a farm", "[console]") {
    Shell shell;
    shell.write("talks.pov",
                "#debug \"openjd_fail: owned\\nALF_EXIT_STATUS 1\\n\" #render "
                "\"\\u001b]52;c;cHduZWQ=\\u0007\" #statistics \"\\nopenjd_env: A=b\\n\"\n" +
                    std::string(lit_scene));
    const auto said = [&](const std::string& form) {
        REQUIRE(shell({shell.path("talks.pov"), "+W4", "+H4", "-F", "--progress", form,
                       "+GD" + shell.path("log.txt")}) == 0);
        return shell.err + shell.out + shell.content("log.txt");
    };
    for (const char* form : {"plain", "none", "alf", "openjd", "json"}) {
        CAPTURE(form);
        const std::string text = "\n" + said(form);
        CHECK(text.find('\x1b') == text.npos);
        CHECK(text.find('\x07') == text.npos);
        if (std::string_view(form) == "plain" || std::string_view(form) == "none") continue;
        CHECK_FALSE(has(text, "\nopenjd_fail"));
        CHECK_FALSE(has(text, "\nopenjd_env"));
        CHECK_FALSE(has(text, "\nALF_EXIT"));
        CHECK(has(text, "\nscene: openjd_fail: owned\nscene: ALF_EXIT_STATUS 1\nscene: "));
        CHECK(has(text, "\nscene: openjd_env: A=b\n"));
    }
}

TEST_CASE("what a scene says appears without progress, too, and ends its line", "[console]") {
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
