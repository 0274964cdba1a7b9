// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sandbox.h"

#include "bind/evaluate.h"
#include "production/checkpoint.h"
#include "support/apart.h"
#include "support/folder.h"
#include "support/shell.h"
#include "text/loader.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <fstream>

namespace candelabra {

namespace {

/// Evaluates a scene with access to every file, in a process that is confined to a folder. Returns
/// 0 if there is no error.
int without_file_access(const std::string& folder, const std::string& script) {
    return apart([&] {
        if (!confine({{folder}, {folder}})) return 64;
        SourceStore sources;
        Diagnostics diagnostics;
        Loader loader(disk_reader(), folder, {}, FileAccess({"/"}, {"/"}));
        EvaluateOptions options;
        options.print = [](std::string_view) {};
        const SourceId main = sources.add("scene.pov", script);
        evaluate(sources, loader, main, options, diagnostics);
        return diagnostics.failed() ? 1 : 0;
    });
}

}  // namespace

TEST_CASE("a mistake in the file access leads to the sandbox", "[app]") {
    const Folder folder;
    const std::string in = (folder.path() / "in").string(), out = (folder.path() / "out").string();
    for (const std::string& each : {in, out}) {
        std::filesystem::create_directories(each);
        std::ofstream(each + "/a.inc") << "#declare A = 1;";
    }
    const auto reads = [&](const std::string& from) {
        return "#version 3.7; #include \"" + from + "/a.inc\"";
    };
    const auto writes = [&](const std::string& to) {
        return "#version 3.7; #fopen F \"" + to + "/b.txt\" write #write (F, 1) #fclose F";
    };
    const int inside = without_file_access(in, reads(in));
    if (inside == 64) {
        WARN("this system has no Landlock or no seccomp");
        return;
    }
    CHECK(inside == 0);
    CHECK(without_file_access(in, writes(in)) == 0);
    CHECK(without_file_access(in, reads(out)) == 1);
    CHECK(without_file_access(in, writes(out)) == 1);
    CHECK_FALSE(std::filesystem::exists(out + "/b.txt"));
}

TEST_CASE("a run may touch its scene, its library and the folders of what it makes", "[app]") {
    const auto has = [](const std::vector<std::string>& list, const std::string& one) {
        return std::ranges::find(list, one) != list.end();
    };
    Options options;
    options.scene = "scenes/a.pov";
    options.output = "pictures/a.png";
    options.stats_file = "figures/a.json";
    options.readable = {"models"};
    options.writable = {"tables"};
    const SandboxRules rules = sandbox_rules(options, "library");
    for (const char* each : {"models", "library"}) CHECK(has(rules.readable, each));
    const std::filesystem::path here = std::filesystem::canonical(".");
    for (const std::filesystem::path& each : {here, here / "scenes"})
        CHECK(has(rules.readable, each.string()));
    for (const char* each : {"pictures", "figures", "tables"}) CHECK(has(rules.writable, each));
    CHECK_FALSE(has(rules.readable, "/etc"));
    CHECK_FALSE(has(rules.writable, "."));
    CHECK_FALSE(rules.sockets);
    CHECK_FALSE(rules.programs);
    options.task = Task::check;
    CHECK_FALSE(has(sandbox_rules(options, "").writable, "pictures"));
    options.preview_port = 8000;
    options.movie = "film.mp4";
    CHECK(sandbox_rules(options, "").sockets);
    CHECK(sandbox_rules(options, "").programs);
}

TEST_CASE("a home that holds the scene and the picture is not opened as a whole", "[app]") {
    const auto has = [](const std::vector<std::string>& list, const std::string& one) {
        return std::ranges::find(list, one) != list.end();
    };
    const Folder folder;
    folder.put("job/a.pov", "");
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path("/");
    Options options;
    options.scene = folder / "job/a.pov";
    const SandboxRules elsewhere = sandbox_rules(options, "");
    options.scene = "/a.pov";
    const SandboxRules wide = sandbox_rules(options, "");
    options.animation.final_frame = 3;
    const SandboxRules frames = sandbox_rules(options, "");
    std::filesystem::current_path(before);
    for (const SandboxRules* rules : {&elsewhere, &wide})
        for (const char* root : {"/", "."}) {
            CHECK_FALSE(has(rules->readable, root));
            CHECK_FALSE(has(rules->writable, root));
        }
    CHECK(has(elsewhere.readable, std::filesystem::canonical(folder / "job").string()));
    CHECK(has(wide.written, "."));
    CHECK(has(frames.writable, "."));  // frames may read the one before
}

TEST_CASE("a sandbox that is missing is warned of, once", "[app]") {
    Shell shell;
    shell.confine = [](const SandboxRules&) { return false; };
    const std::string warning = "this system has no whole sandbox";
    for (const char* way : {"+KFF2", "+W16"}) {
        REQUIRE(shell.render({way, "-V", "+O" + shell.path("a.png")}) == 0);
        const std::size_t at = shell.err.find(warning);
        CHECK(at != std::string::npos);
        CHECK(shell.err.find(warning, at + 1) == std::string::npos);
    }
    REQUIRE(shell.render({"-V", "--sandbox", "off", "+O" + shell.path("a.png")}) == 0);
    CHECK(shell.err.empty());
}

TEST_CASE("who develops or merges reaches the files, and the folder of the output", "[app]") {
    const Folder folder;
    const std::string in = (folder.path() / "in").string(), out = (folder.path() / "out").string();
    for (const std::string& each : {in, out}) {
        std::filesystem::create_directories(each);
        std::ofstream(each + "/a") << "text";
    }
    const std::vector<std::string> files = {in + "/a"};
    Options options;
    const int beside = tried(sandbox_rules(options, "", files), in, out);
    if (beside == 64) {
        WARN("this system has no Landlock or no seccomp");
        return;
    }
    CHECK(beside == (reads_inside | writes_inside));
    const int elsewhere = reads_outside | reads_inside | writes_inside;
    for (const std::string& output : {out + "/p.png", out, out + "/"}) {
        options.output = output;
        CHECK(tried(sandbox_rules(options, "", files), out, in) == elsewhere);
    }
}

TEST_CASE("pictures and states of strangers are read behind the wall", "[app]") {
    Shell shell;
    REQUIRE(shell.render({"-V", "--keep-state", "+O" + shell.path("a.exr")}) == 0);
    const std::string state = "a.exr" + std::string(state_ending);
    REQUIRE(std::filesystem::exists(shell.path(state)));
    int asked = 0;
    shell.confine = [&](const SandboxRules& rules) {
        ++asked;
        CHECK(std::ranges::find(rules.writable, shell.folder.string()) != rules.writable.end());
        return false;
    };
    const std::vector<std::string> develop = {"develop", shell.path("a.exr")},
                                   merge = {"merge", shell.path(state), "+O" + shell.path("b.png")};
    for (std::vector<std::string> words : {develop, merge}) {
        asked = 0;
        CHECK(shell(words) == 0);
        CHECK(asked == 1);
        words.emplace_back("--sandbox=off");
        CHECK(shell(words) == 0);
        CHECK(shell.err == "");
        CHECK(asked == 1);
        words.back() = "--sandbox=on";
        CHECK(shell(words) == exit_status::usage);
        CHECK(has(shell.err, "this system has no sandbox"));
    }
}

}  // namespace candelabra
