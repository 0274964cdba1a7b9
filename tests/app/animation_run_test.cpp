// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/animation_run.h"

#include "support/shell.h"

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>

#include <unistd.h>

namespace candelabra {

namespace fs = std::filesystem;

namespace {

/// Polls test() until it returns true. Returns false after some seconds.
template <class Test>
bool soon(const Test& test) {
    for (int i = 0; i < 3000; ++i) {
        if (test()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
}

}  // namespace

TEST_CASE("a frame is prepared while the one before it is rendered") {
    Shell shell;
    // The second frame writes a file, whose existence shows that the frame is being read.
    shell.write("moving.pov", std::string(lit_scene) +
                                  "#if (frame_number = 2) #fopen Sign \"sign.txt\" write #end");
    std::atomic<bool> met = false, once = true;
    shell.interrupts.take = [&] {
        if (once.exchange(false))  // set by the rendering of the first frame
            met =
                soon([&] { return std::filesystem::exists(shell.path("moving.files/sign.txt")); });
        return Interrupt::none;
    };
    REQUIRE(shell({shell.path("moving.pov"), "-V", "+W16", "+H12", "--samples", "2", "+KFF2",
                   "+WT2", "+O" + shell.path("f.png"), "--stats", shell.path("s.json")}) == 0);
    CHECK(met);
    const auto ahead = [&](const char* name) {
        return nlohmann::json::parse(shell.content(name))["prepared_ahead"].get<bool>();
    };
    CHECK_FALSE(ahead("s1.json"));
    CHECK(ahead("s2.json"));
}

TEST_CASE("frames are the same whether they are prepared ahead or not") {
    Shell shell;
    shell.write("moving.pov", std::string(lit_scene) +
                                  "sphere { clock*x, 0.3 pigment { rgb 1 } }\n"
                                  "#warning concat(\"clock \", str(clock, 0, 2), \"\\n\")");
    const auto frames = [&](const std::string& threads, const std::string& name) {
        REQUIRE(shell({shell.path("moving.pov"), "+W16", "+H12", "--samples", "2", "+KFF4", threads,
                       "+O" + shell.path(name + ".png")}) == 0);
        std::string all;
        for (const char* number : {"1", "2", "3", "4"})
            all += shell.content(name + number + ".png");
        // Output appears in frame order.
        std::size_t at = 0;
        for (const char* part : {"frame 1 (", "clock 0.00", "a1", "frame 2 (", "clock 0.33"})
            CHECK((at = shell.err.find(part[0] == 'a' ? name + "1.png: " : part, at)) !=
                  std::string::npos);
        return all;
    };
    CHECK(frames("+WT2", "a") == frames("+WT1", "b"));
}

TEST_CASE("a frame that is made from the picture before it waits for that") {
    Shell shell;
    shell.write("back.pov", R"(#version 3.7; camera { orthographic location -5*z right 4*x up 3*y }
        plane { z, 1 #if (frame_number = 1) pigment { rgb 0.25 }
            #else pigment { image_map { png concat("f", str(frame_number - 1, 0, 0), ".png") } scale 4 translate -2 } #end
            finish { ambient 2 diffuse 0 } })");
    const auto run = [&](const std::string& threads) {
        REQUIRE(shell({shell.path("back.pov"), "-V", "+W16", "+H12", "-A", "+KFF3", threads,
                       "+O" + shell.path("f.png")}) == 0);
        return shell.content("f3.png");
    };
    const std::string first = run("+WT2");  // there is no previous picture
    CHECK(run("+WT2") == first);            // there are the pictures of the last run
    CHECK(run("+WT1") == first);
}

TEST_CASE("frames that are torn, empty or of another size are not finished", "[app]") {
    for (const std::string way : {"--skip-existing", "+C"})
        for (const std::string ending : {".png", ".jpg"}) {
            CAPTURE(way, ending);
            Shell shell;
            const auto make = [&](std::vector<std::string> more) {
                more.insert(more.end(), {shell.path("lit.pov"), "+W16", "+H12", "--samples", "2",
                                         "+KFF6", "+O" + shell.path("f" + ending)});
                return shell(more);
            };
            const auto frame = [&](int number) { return "f" + std::to_string(number) + ending; };
            REQUIRE(make({"-V"}) == 0);
            std::vector<std::string> whole(7);
            for (int i = 1; i <= 6; ++i)
                whole[static_cast<std::size_t>(i)] = shell.content(frame(i));
            shell.write(frame(1), whole[1].substr(0, 60));
            shell.write(frame(2), "");
            shell.write(frame(3), "#EXTM3U\nfile:///etc/passwd\n");
            fs::remove(shell.path(frame(4)));
            REQUIRE(shell({shell.path("lit.pov"), "-V", "+W8", "+H8",
                           "+O" + shell.path(frame(5))}) == 0);
            REQUIRE(make({way}) == 0);
            for (int i = 1; i <= 6; ++i)
                CHECK(shell.content(frame(i)) == whole[static_cast<std::size_t>(i)]);
            for (const int i : {1, 2, 3, 5})
                CHECK(has(shell.err, frame(i) + "` is no finished frame, and is made again: "));
            CHECK_FALSE(has(shell.err, frame(4) + "` is no finished"));
            CHECK(has(shell.err, "frame 6 (6 of 6), clock 1: is there\n"));
        }
}

TEST_CASE("a frame without its layers or its denoised picture is not finished", "[app]") {
    Shell shell;
    const std::vector<std::string> run = {shell.path("lit.pov"),
                                          "-V",
                                          "+W16",
                                          "+H12",
                                          "--samples",
                                          "2",
                                          "+KFF1",
                                          "+O" + shell.path("f.png"),
                                          "--layers",
                                          "depth",
                                          "--skip-existing"};
    REQUIRE(shell(run) == 0);
    const std::string whole = shell.content("f1.layers.exr");
    REQUIRE_FALSE(whole.empty());
    fs::remove(shell.path("f1.layers.exr"));
    REQUIRE(shell(run) == 0);
    CHECK(shell.content("f1.layers.exr") == whole);
    shell.write("f1.layers.exr", whole.substr(0, whole.size() / 2));
    REQUIRE(shell(run) == 0);
    CHECK(shell.content("f1.layers.exr") == whole);
}

TEST_CASE("frames that are listed or numbered backwards have the clocks of the whole", "[app]") {
    Shell shell;
    shell.write("moving.pov", std::string(lit_scene) + "sphere { clock*x, 0.3 pigment { rgb 1 } }");
    const auto make = [&](const std::string& name, std::vector<std::string> more) {
        more.insert(more.end(), {shell.path("moving.pov"), "-V", "+W16", "+H12", "--samples", "2",
                                 "+O" + shell.path(name + ".ppm")});
        return shell(more);
    };
    // The recorded options differ, the pixels do not.
    const auto pixels = [&](const std::string& name) {
        const std::string file = shell.content(name + ".ppm");
        return file.size() < 576 ? file : file.substr(file.size() - 576);
    };
    REQUIRE(make("a", {"+KFI1", "+KFF5"}) == 0);
    REQUIRE(make("b", {"+KFI1", "+KFF5", "--frames", "4,2-1"}) == 0);
    for (const char* number : {"4", "2", "1"})
        CHECK(pixels(std::string("a") + number) == pixels(std::string("b") + number));
    CHECK_FALSE(fs::exists(shell.path("b3.ppm")));
    REQUIRE(make("c", {"+KFI5", "+KFF1"}) == 0);
    CHECK(pixels("c5") == pixels("a1"));
    CHECK(pixels("c2") == pixels("a4"));
    CHECK(shell({shell.path("moving.pov"), "--frames", "2"}) == exit_status::usage);
    CHECK(has(shell.err, "--frames chooses some frames of an animation"));
}

TEST_CASE("an error or a stop in one frame leaves nothing of the next") {
    Shell shell;
    shell.write("bad.pov",
                std::string(lit_scene) + "#if (frame_number = 2) sphere { 0, Sise } #end");
    CHECK(shell({shell.path("bad.pov"), "-V", "+W16", "+H12", "+KFF3", "+WT2",
                 "+O" + shell.path("f.png")}) == exit_status::scene);
    CHECK(fs::exists(shell.path("f1.png")));
    CHECK_FALSE(fs::exists(shell.path("f3.png")));
    CHECK(shell.err.find("Sise") != shell.err.npos);
    CHECK(shell.err.find("error", shell.err.find("Sise") + 200) == shell.err.npos);
    fs::remove(shell.path("f1.png"));
    int calls = 0;
    std::mutex mutex;
    shell.interrupts.take = [&] {
        const std::lock_guard lock(mutex);
        return ++calls == 10 ? Interrupt::stop : Interrupt::none;
    };
    CHECK(shell.render({"-V", "+KFF3", "+WT2", "+O" + shell.path("f.png")}) ==
          exit_status::stopped);
    CHECK(fs::exists(shell.path("f1.png.state.exr")));
    for (const char* name : {"f1.png", "f2.png", "f2.png.state.exr", "f3.png.state.exr"})
        CHECK_FALSE(fs::exists(shell.path(name)));
}

TEST_CASE("shards of an animation have every so many frames") {
    Shell shell;
    const std::string file = "+O" + shell.path("f.png");
    REQUIRE(shell.render({"-V", file, "+KFF5", "--shard", "2/3"}) == 0);
    for (const int frame : {1, 2, 3, 4, 5})
        CHECK(fs::exists(shell.path("f" + std::to_string(frame) + ".png")) ==
              (frame == 2 || frame == 5));
    CHECK(shell.render({"-V", file, "+KFF5", "--shard", "4/3"}) == 2);
}

TEST_CASE("+C goes on with an animation at the frame that was begun") {
    Shell shell;
    const std::string file = "+O" + shell.path("f.png");
    int calls = 0;
    shell.interrupts.take = [&] { return ++calls == 32 ? Interrupt::stop : Interrupt::none; };
    CHECK(shell.render({"-V", file, "+KFF3", "+WT1", "+C"}) == exit_status::stopped);
    CHECK(fs::exists(shell.path("f1.png")));
    CHECK(fs::exists(shell.path("f2.png.state.exr")));
    // Another picture of the size, so that one that is made again differs.
    shell.interrupts.take = {};
    REQUIRE(shell.render({"-V", "--seed", "9", "+O" + shell.path("f1.png")}) == 0);
    const std::string kept = shell.content("f1.png");
    CHECK(shell.render({"-V", file, "+KFF3", "+C"}) == 0);
    CHECK(shell.content("f1.png") == kept);
    CHECK(fs::exists(shell.path("f2.png")));
    CHECK(fs::exists(shell.path("f3.png")));
    CHECK_FALSE(fs::exists(shell.path("f2.png.state.exr")));
}

TEST_CASE("what is wrong with the command line is said once, whichever frames a run has") {
    for (const char* shard : {"1/1", "2/3"}) {
        Shell shell;
        REQUIRE(shell.render(
                    {"-V", "+O" + shell.path("f.png"), "+KFF3", "--shard", shard, "+BS16"}) == 0);
        const std::size_t said = shell.err.find("`+BS16` is ignored");
        CHECK(said != std::string::npos);
        CHECK(shell.err.find("is ignored", said + 20) == std::string::npos);
    }
}

TEST_CASE("a film that cannot be made is refused before the first frame") {
    Shell shell;
    const auto refused = [&](std::vector<std::string> more, std::string_view why) {
        more.insert(more.begin(), {"--movie", shell.path("f.mp4"), "+O" + shell.path("f.png")});
        CHECK(shell.render(more) == exit_status::usage);
        CAPTURE(shell.err, why);
        CHECK(has(shell.err, why));
        CHECK_FALSE(fs::exists(shell.path("f1.png")));
    };
    refused({}, "a film needs the frames of an animation");
    refused({"+KFF2", "--shard", "1/2"}, "of which a shard has some");
    refused({"+KFF2", "-F"}, "frames in files");
    refused({"+KFF2", "--movie", shell.path("none/f.mp4")}, "there is no folder");
    // A check makes no film.
    CHECK(shell.render({"--check", "+KFF2", "--movie", shell.path("f.mp4")}) == 0);
    CHECK_FALSE(fs::exists(shell.path("f.mp4")));
}

TEST_CASE("programs hear one progress of all frames, and each frame has its own figures") {
    Shell shell;
    REQUIRE(shell.render({"-V", "+O" + shell.path("f.png"), "+KFF2", "--progress", "openjd",
                          "--stats", shell.path("s.json"), "--depfile", shell.path("d")}) == 0);
    std::vector<int> heard;
    for (std::size_t at = 0; (at = shell.out.find(": ", at)) != std::string::npos; ++at)
        heard.push_back(std::stoi(shell.out.substr(at + 2)));
    CHECK(std::is_sorted(heard.begin(), heard.end()));
    CHECK(std::count(heard.begin(), heard.end(), 50) == 1);
    CHECK(std::count(heard.begin(), heard.end(), 100) == 1);
    for (const char* name : {"s1.json", "s2.json", "d1", "d2"}) CHECK(fs::exists(shell.path(name)));
}

}  // namespace candelabra
