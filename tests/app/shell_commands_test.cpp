// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/shell_commands.h"

#include "support/shell.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("commands are told what they are about, safely") {
    const CommandFacts facts{"a b's.png", "scene", 7, 0.25, 640, 480};
    CHECK(filled_in("convert %o -size %wx%h %s-%n@%k 100%% %q%", facts) ==
          "convert 'a b'\\''s.png' -size 640x480 scene-7@0.25 100% %q%");
}

namespace {

struct Commanded : Shell {
    /// Returns a command that appends words to a log of the commands run.
    std::string note(const std::string& words) const {
        return "echo " + words + " >> " + path("log") + ";";
    }
    int run_with(std::vector<std::string> more) {
        more.insert(more.end(),
                    {path("lit.pov"), "-V", "+W4", "+H4", "--samples", "1", "+O" + path("p.png"),
                     "Pre_Scene_Command=" + note("begin"), "Post_Scene_Command=" + note("end"),
                     "Post_Frame_Command=" + note("after %n %o")});
        return (*this)(more);
    }
};

}  // namespace

TEST_CASE("commands need a permission") {
    Commanded shell;
    CHECK(shell.run_with({}) == exit_status::done);
    CHECK(has(shell.err, "warning"));
    CHECK(has(shell.err, "Post_Frame_Command"));
    CHECK(has(shell.err, "--allow-commands"));
    CHECK(shell.content("log").empty());
    CHECK_FALSE(shell.content("p.png").empty());
}

TEST_CASE("of a command that is not run the message names the line") {
    Shell shell;
    shell.write("a.ini",
                "; a film\nWidth=4\nHeight=4\nPost_Scene_Command=rm %o\n"
                "Pre_Frame_Command=false\nPre_Frame_Return=F\n");
    CHECK(shell({shell.path("lit.pov"), shell.path("a.ini"), "-V", "--samples", "1",
                 "+O" + shell.path("p.png"), "+KFF2"}) == exit_status::done);
    CHECK(has(shell.err, "a.ini:4: `Post_Scene_Command=rm %o` is not run"));
    CHECK(has(shell.err, "a.ini:5: `Pre_Frame_Command=false` is not run"));
    // Reported once, not for each frame.
    CHECK(shell.err.find("Pre_Frame_Command") == shell.err.rfind("Pre_Frame_Command"));
    CHECK_FALSE(shell.content("p2.png").empty());
}

TEST_CASE("commands are run around pictures and frames") {
    Commanded shell;
    REQUIRE(shell.run_with({"--allow-commands"}) == exit_status::done);
    CHECK(shell.content("log") == "begin\nafter 0 " + shell.path("p.png") + "\nend\n");
    shell.write("log", "");
    REQUIRE(shell.run_with({"--allow-commands", "+KFF2"}) == exit_status::done);
    CHECK(shell.content("log") == "begin\nafter 1 " + shell.path("p1.png") + "\nafter 2 " +
                                      shell.path("p2.png") + "\nend\n");
}

TEST_CASE("what a command answers decides how the run goes on") {
    struct Case {
        std::vector<std::string> options;
        int status;
        const char* log;  ///< with file names removed
    };
    const Case cases[] = {
        {{"Pre_Frame_Command=test %n != 1", "Pre_Frame_Return=S"}, 0, "begin after2 end"},
        {{"Pre_Frame_Command=test %n != 1", "Pre_Frame_Return=-S"}, 0, "begin after1 end"},
        {{"Pre_Frame_Command=false", "Pre_Frame_Return=A"}, 0, "begin end"},
        {{"Pre_Scene_Return=-Q"}, 0, "begin"},
        {{"Pre_Frame_Command=false", "Pre_Frame_Return=F"}, 1, "begin failed"},
        {{"Pre_Frame_Command=false", "Pre_Frame_Return=U"}, 4, "begin aborted"},
        {{"Pre_Frame_Command=false", "Pre_Frame_Return=I"}, 0, "begin after1 after2 end"},
    };
    for (const Case& each : cases) {
        Commanded shell;
        std::vector<std::string> options = each.options;
        options.insert(options.end(),
                       {"--allow-commands", "+KFF2", "Fatal_Error_Command=" + shell.note("failed"),
                        "User_Abort_Command=" + shell.note("aborted")});
        CAPTURE(each.options);
        CHECK(shell.run_with(options) == each.status);
        std::string log, said = shell.content("log");
        for (std::size_t at = 0; at < said.size();) {
            const std::size_t end = said.find('\n', at);
            std::string line = said.substr(at, end - at);
            if (line.starts_with("after ")) line = "after" + line.substr(6, 1);
            log += (log.empty() ? "" : " ") + line;
            at = end + 1;
        }
        CHECK(log == each.log);
    }
}

}  // namespace candelabra
