// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/scene_run.h"

#include "output/layers.h"
#include "picture/layers.h"
#include "support/shell.h"
#include "tasks/render_picture.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <atomic>

namespace candelabra {

namespace {

/// What a program that calls a run gets of it.
struct Caller {
    Console console;
    std::vector<std::uint8_t> shown;
    std::vector<std::string> planes;
    std::vector<std::string> messages;
    std::atomic<int> steps = 0;

    Caller() {
        console.out = console.err = [](std::string_view) {};
        console.text = lit_scene;
        console.text_name = "the text";
        console.owns_process = false;
        console.progressed = [this](double) { ++steps; };
        console.diagnosed = [this](const Diagnostic& each, const SourceStore& sources) {
            messages.push_back(each.span.known() ? sources.name(each.span.source) : each.message);
        };
        console.finished = [this](const FinishedPicture& made) {
            shown = shown_bytes(made.film, made.files);
            for (const ChannelPlane& plane : layered_picture(made.film, made.files).planes)
                planes.push_back(plane.name);
        };
    }
    int operator()(const std::vector<std::string_view>& words) {
        Diagnostics diagnostics;
        Options options = read_options(words, diagnostics);
        REQUIRE_FALSE(diagnostics.failed());
        options.for_caller = true;
        options.to_file = false;
        return run_scene(options, console, diagnostics);
    }
};

}  // namespace

TEST_CASE("a program that calls a run gets the pixels of the command's file, and no file") {
    const std::vector<std::vector<std::string>> looks = {
        {}, {"--film", "on", "--exposure", "2"}, {"--draft"}, {"--film", "on", "--draft"}};
    for (const std::vector<std::string>& look : looks) {
        CAPTURE(look);
        Shell shell;
        std::vector<std::string> words = look;
        words.push_back("+O" + shell.path("a.ppm"));
        REQUIRE(shell.render(words) == exit_status::done);
        const bool draft = std::ranges::find(look, "--draft") != look.end();
        const std::string file = shell.content(draft ? "a.draft.ppm" : "a.ppm");
        Caller caller;
        std::vector<std::string_view> own = {"-", "+W16", "+H12",     "--samples",
                                             "2", "-V",   "--layers", "depth"};
        own.insert(own.end(), look.begin(), look.end());
        REQUIRE(caller(own) == exit_status::done);
        CHECK(file.ends_with(std::string(caller.shown.begin(), caller.shown.end())));
        CHECK(caller.shown.size() == 16 * 12 * 3);
        CHECK(std::ranges::count(caller.planes, "depth") == 1);
        CHECK(std::ranges::count(caller.planes, "R") == 1);
        CHECK(caller.steps > 0);
        CHECK(caller.messages.empty());
    }
}

TEST_CASE("a program that calls a run gets messages with the name of its text") {
    Caller caller;
    caller.console.text = "camera { } sphere { 0, red }";
    CHECK(caller({"-", "+W16", "+H12"}) == exit_status::scene);
    CHECK(caller.messages == std::vector<std::string>{"the text"});
    CHECK(caller.shown.empty());
}

TEST_CASE("each task over a scene has its row, and needs the scene's text") {
    Shell shell;
    shell.write("lit.pov", std::string(lit_scene) + "meter { points { 1, <0, 0, 0> } }\n");
    const std::vector<std::vector<std::string>> tasks = {{"-F"},
                                                         {"--check"},
                                                         {"--check=syntax"},
                                                         {"--dump=tokens"},
                                                         {"--dump=tree"},
                                                         {"--dump=scene"},
                                                         {"--dump=world"},
                                                         {"--dump=index"},
                                                         {"--pick=1,2"},
                                                         {"--export-mesh", shell.path("a.ply")},
                                                         {"--measure", shell.path("a.csv")},
                                                         {"--light-balance", shell.path("b.csv")}};
    for (std::vector<std::string> task : tasks) {
        CAPTURE(task);
        CHECK(shell.render(task) == exit_status::done);
        task.insert(task.begin(), shell.path("none.pov"));
        CHECK(shell(task) == exit_status::file);
        CHECK(has(shell.err, "none.pov"));
    }
}

}  // namespace candelabra
