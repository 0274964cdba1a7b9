// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/render_job.h"

#include "options/memory_limit.h"
#include "picture/file.h"
#include "production/checkpoint.h"
#include "support/shell.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <ctime>
#include <random>
#include <thread>

#include <sys/resource.h>

namespace candelabra {

namespace fs = std::filesystem;

namespace {

/// Gives back the memory that runs of a test deny to this process.
struct DataLimit {
    DataLimit() { getrlimit(RLIMIT_DATA, &limit); }
    ~DataLimit() { setrlimit(RLIMIT_DATA, &limit); }
    rlimit limit{};
};

/// Runs with +C until the picture is finished, stopping each run at a random poll of the interrupts
/// (one poll per 16 samples). Returns the number of stops.
int stop_and_go(Shell& shell, std::vector<std::string> arguments, std::mt19937& random) {
    arguments.insert(arguments.end(), {shell.path("lit.pov"), "-V", "+C"});
    std::atomic<int> left = 0;
    shell.interrupts.take = [&] { return --left > 0 ? Interrupt::none : Interrupt::stop; };
    int stops = 0;
    for (;; ++stops) {
        left = static_cast<int>(random() % 100);
        const int status = shell(arguments);
        if (status == exit_status::done) break;
        REQUIRE(status == exit_status::stopped);
        REQUIRE(stops < 300);
    }
    shell.interrupts.take = nullptr;
    return stops;
}

}  // namespace

TEST_CASE("a picture that is stopped at random moments and continued has the same bytes") {
    Shell shell;
    std::mt19937 random(5);
    const std::vector<std::vector<std::string>> ways = {
        {"--samples", "7"}, {}, {"-A", "--seed", "4"}, {"--noise", "0.3", "+SR3", "+EC9"}};
    for (const std::vector<std::string>& way : ways) {
        std::vector<std::string> all = way;
        all.insert(all.end(), {"+W32", "+H24", "+O" + shell.path("a.png")});
        std::vector<std::string> plain = all;
        plain.insert(plain.end(), {shell.path("lit.pov"), "-V"});
        REQUIRE(shell(plain) == 0);
        const std::string whole = shell.content("a.png");
        fs::remove(shell.path("a.png"));
        CHECK(stop_and_go(shell, all, random) > 1);
        CHECK(shell.content("a.png") == whole);
        CHECK_FALSE(fs::exists(shell.path("a.png.state.exr")));
    }
}

TEST_CASE("a state is written when it is asked for, and the work goes on") {
    Shell shell;
    int calls = 0;
    std::string seen;
    shell.interrupts.take = [&] {
        ++calls;
        if (calls == 15) seen = shell.content("a.png.state.exr");
        return calls == 5 ? Interrupt::save : Interrupt::none;
    };
    CHECK(shell.render({"-V", "+WT1", "+O" + shell.path("a.png")}) == 0);
    CHECK(seen.size() > 100);
    CHECK_FALSE(fs::exists(shell.path("a.png.state.exr")));
}

TEST_CASE("a stop that comes while another thread is asked to save is not lost") {
    Shell shell;
    std::atomic<int> calls = 0;
    shell.interrupts.take = [&] {
        const int call = calls++;
        if (call == 1) return Interrupt::stop;
        if (call > 0) return Interrupt::none;
        const auto pause = std::chrono::milliseconds(20);
        for (int i = 0; i < 50 && calls < 2; ++i) std::this_thread::sleep_for(pause);
        std::this_thread::sleep_for(pause);
        return Interrupt::save;
    };
    CHECK(shell({shell.path("lit.pov"), "-V", "+W64", "+H48", "--samples", "4", "+WT2",
                 "+O" + shell.path("a.png")}) == exit_status::stopped);
}

TEST_CASE("one ray without end obeys a stop, the time and a bound") {
    Shell shell;
    shell.write("mirrors.pov", R"(
        #version 3.7;
        global_settings { assumed_gamma 1 max_trace_level 256 adc_bailout 0 }
        camera { location <0, 0, -3> look_at 0 } light_source { <3, 4, -5>, 1 }
        box { -9, 9 pigment { rgbt 0.9 } finish { reflection 1 } interior { ior 1.5 } }
        sphere { 0, 1 pigment { rgbt 1 } finish { reflection 1 } interior { ior 1.2 } }
    )");
    std::vector<std::string> all = {shell.path("mirrors.pov"), "-A", "+WT1", "+W1", "+H1",
                                    "+O" + shell.path("a.png")};
    CHECK(shell(all) == exit_status::done);
    CHECK(has(shell.err, "warning[recursion-limit]"));
    CHECK(has(shell.err, "the first is in the pixel 0, 0"));
    CHECK(has(shell.err, "adc_bailout"));
    all[3] = "+W99";
    all[4] = "+H99";
    int calls = 0;
    shell.interrupts.take = [&] { return ++calls > 3 ? Interrupt::stop : Interrupt::none; };
    CHECK(shell(all) == exit_status::stopped);
    CHECK(calls < 9);
    CHECK(fs::exists(shell.path("a.png.state.exr")));
    shell.interrupts.take = nullptr;
    all.insert(all.end(), {"--time", "0.1"});
    CHECK(shell(all) == exit_status::done);
}

TEST_CASE("a stop that comes while the first light is sent ends the run at once") {
    Shell shell;
    shell.write("slow.pov", R"(
        #version 3.7;
        global_settings { integrator { path_traced bounces 8 reflected_luminaires 100000 } }
        camera { location <0, 0, -3> look_at 0 }
        sphere { <0, 3, 0>, 1 pigment { rgb 1 } finish { diffuse 0 emission 5 } }
        isosurface {
            function { x*x + y*y + z*z - 1 #for (I, 1, 400) + 0.0001*sin(I*x)*cos(I*y) #end }
            contained_by { sphere { 0, 1.2 } } max_gradient 90 accuracy 0.00001
        }
        sphere { 0, 9 pigment { rgb 0.9 } finish { diffuse 1 } inverse }
    )");
    std::atomic<int> asked = 0;
    shell.interrupts.take = [&] { return ++asked > 1 ? Interrupt::stop : Interrupt::none; };
    for (const char* threads : {"+WT1", "+WT2"}) {
        asked = 0;
        const double before = static_cast<double>(std::clock());
        CHECK(shell({shell.path("slow.pov"), threads, "+W64", "+H64", "--samples", "4",
                     "+O" + shell.path("a.png")}) == exit_status::stopped);
        CHECK((static_cast<double>(std::clock()) - before) / CLOCKS_PER_SEC < 4);
        CHECK(asked == 2);
        CHECK(has(shell.err, "stopped before the first sample"));
        CHECK_FALSE(fs::exists(shell.path("a.png.state.exr")));
    }
}

TEST_CASE("a picture that does not fit into the memory tells what it needs") {
    const DataLimit kept;
    Shell shell;
    const auto posters = [&](std::vector<std::string> more) {
        std::vector<std::string> all = {shell.path("lit.pov"),
                                        "-V",
                                        "+W8000",
                                        "+H6000",
                                        "--memory",
                                        "512M",
                                        "--samples",
                                        "1",
                                        "+O" + shell.path("a.png")};
        all.insert(all.end(), more.begin(), more.end());
        return shell(all);
    };
    const auto needed = [&] {
        const std::string words = "help: --limit-memory ";
        const std::size_t place = shell.err.find(words);
        return place == shell.err.npos ? 0 : std::stoi(shell.err.substr(place + words.size()));
    };
    CHECK(posters({}) == exit_status::file);
    CHECK(has(shell.err, "a picture of 8000x6000 needs "));
    CHECK(has(shell.err, "the limit is 512 MB"));
    CHECK(needed() > 550);  // 12 bytes a pixel, as the sums lie in a file
    CHECK(needed() < 800);
    CHECK(posters({"-F"}) == exit_status::file);
    CHECK(needed() > 5600 - 550);  // with the sums, as there is no folder for a file
    CHECK(posters({"-F", "+SR1", "+ER2"}) == exit_status::done);
    CHECK_FALSE(has(shell.err, "layers"));
    CHECK(posters({"--layers", "normal"}) == exit_status::file);
    CHECK(has(shell.err, "without layers"));
}

TEST_CASE("a picture whose sums are too large for the memory lies in a file until it is made") {
    const DataLimit kept;
    Shell shell;
    const auto run = [&](std::vector<std::string> more) {
        const std::vector<std::string> all = {
            shell.path("lit.pov"), "-V", "-A", "+W1000", "+H600", "-P", "--samples", "1"};
        more.insert(more.begin(), all.begin(), all.end());
        return shell(more);
    };
    REQUIRE(run({"+O" + shell.path("a.png")}) == exit_status::done);
    const std::string whole = shell.content("a.png");
    // The sums take 64 MB, a state 240, and writing the picture 7.
    const std::string limit = std::to_string(memory_in_use() / (1 << 20) + 55);
    REQUIRE(run({"+O" + shell.path("b.png"), "--limit-memory", limit}) == exit_status::done);
    CHECK(shell.content("b.png") == whole);
    CHECK(has(shell.err, "warning[option]: a state of this picture needs "));
    CHECK(has(shell.err, "cannot be stopped and gone on with"));
    CHECK(run({"+O" + shell.path("c.png"), "--limit-memory", limit, "--keep-state"}) ==
          exit_status::file);
    CHECK(has(shell.err, "a state of this picture needs "));
    CHECK(run({"-F", "--limit-memory", limit}) == exit_status::file);
    CHECK(has(shell.err, "a picture of 1000x600 needs "));
    // A stripe takes the memory of its rows.
    CHECK(run({"-F", "--limit-memory", limit, "+SR1", "+ER50"}) == exit_status::done);
    std::vector<std::string> files;
    for (const auto& entry : fs::directory_iterator(shell.folder))
        files.push_back(entry.path().filename().string());
    std::ranges::sort(files);
    CHECK(files == std::vector<std::string>{"a.png", "b.png", "lit.pov"});
}

TEST_CASE("what cannot be kept is said") {
    Shell shell;
    shell.interrupts.take = [] { return Interrupt::stop; };
    CHECK(shell.render({"-F"}) == exit_status::stopped);
    CHECK(has(shell.err, "there is no place for a state"));
}

TEST_CASE("what a state says of wanted samples is bounded by what a run would want") {
    Shell shell;
    const std::vector<std::string> arguments = {
        shell.path("lit.pov"),     "-V", "+C", "+W8", "+H6", "--samples", "3",
        "+O" + shell.path("a.png")};
    REQUIRE(shell(arguments) == 0);
    const std::string whole = shell.content("a.png");
    shell.interrupts.take = [] { return Interrupt::stop; };
    REQUIRE(shell(arguments) == exit_status::stopped);
    shell.interrupts.take = nullptr;
    const std::string path = shell.path("a.png.state.exr");
    Diagnostics diagnostics;
    auto state = read_checkpoint(path, diagnostics);
    REQUIRE(state);
    for (PixelSum& pixel : state->state.film.pixels()) pixel.planned = 1u << 30;
    state->state.rounds = std::max(1u, state->state.rounds);
    const auto bytes = encode(*state, diagnostics);
    REQUIRE(bytes);
    REQUIRE(write_file(path, *bytes, diagnostics));
    CHECK(shell(arguments) == 0);
    CHECK(shell.content("a.png") == whole);
}

}  // namespace candelabra
