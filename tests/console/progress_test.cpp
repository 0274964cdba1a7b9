// SPDX-License-Identifier: GPL-3.0-or-later
#include "console/progress.h"

#include <catch2/catch.hpp>

#include <vector>

namespace candelabra {

namespace {

struct Listener {
    double now = 100;
    std::vector<std::string> said;

    Progress progress(Progress::Style style) {
        return {style, [this] { return now; },
                [this](std::string_view text) { said.emplace_back(text); }};
    }
};

}  // namespace

TEST_CASE("times are told as people say them") {
    struct Case {
        double seconds;
        const char* expected;
    };
    const Case cases[] = {
        {0, "0.0 s"},          {-1, "0.0 s"},        {0.04, "0.0 s"},
        {8.34, "8.3 s"},       {9.94, "9.9 s"},      {9.96, "10 s"},
        {42.4, "42 s"},        {99.6, "1 min 40 s"}, {125, "2 min 05 s"},
        {3599, "59 min 59 s"}, {3725, "1 h 02 min"}, {1e300, "277777 h 46 min"},
    };
    for (const Case& each : cases) CHECK(duration(each.seconds) == each.expected);
}

TEST_CASE("progress is percentage, time so far and time left") {
    CHECK(progress_text(0, 3) == "0.0 %, 3.0 s so far");
    CHECK(progress_text(0.25, 3) == "25.0 %, 3.0 s so far, about 9.0 s left");
    CHECK(progress_text(0.9999, 50) == "99.9 %, 50 s so far, about 0.0 s left");
    CHECK(progress_text(1, 50) == "100.0 %, 50 s so far, about 0.0 s left");
}

TEST_CASE("a terminal gets one line that is rewritten, and cleaned at the end") {
    Listener listener;
    Progress progress = listener.progress(Progress::Style::terminal);
    progress.update(0.1);
    CHECK(listener.said.empty());
    listener.now += 10;
    progress.update(0.2);
    REQUIRE(listener.said.size() == 1);
    CHECK(listener.said[0] == "\r20.0 %, 10 s so far, about 40 s left");
    listener.now += 0.1;
    progress.update(0.3);
    CHECK(listener.said.size() == 1);
    listener.now += 0.2;
    progress.update(0.9);
    REQUIRE(listener.said.size() == 2);
    CHECK(listener.said[1].size() >= listener.said[0].size());
    progress.finish();
    CHECK(listener.said.back().find_first_not_of("\r ") == std::string::npos);
}

TEST_CASE("elsewhere a tenth of the way or some seconds give a line") {
    Listener listener;
    Progress progress = listener.progress(Progress::Style::lines);
    for (int i = 0; i <= 100; ++i) {
        listener.now += 1;
        progress.update(i / 100.0);
    }
    progress.finish();
    CHECK(listener.said.size() >= 10);
    CHECK(listener.said.size() <= 11);
    for (const std::string& line : listener.said) {
        CHECK(line.back() == '\n');
        CHECK(line.find('\r') == std::string::npos);
    }
}

TEST_CASE("a quick rendering says nothing, nor does a silent one") {
    for (const auto style :
         {Progress::Style::lines, Progress::Style::terminal, Progress::Style::silent}) {
        Listener listener;
        Progress progress = listener.progress(style);
        for (int i = 0; i <= 10; ++i) {
            listener.now += style == Progress::Style::silent ? 10 : 0.01;
            progress.update(i / 10.0);
        }
        progress.finish();
        CHECK(listener.said.empty());
    }
}

TEST_CASE("a caller hears each fraction, whatever the style") {
    std::vector<double> heard;
    Progress silent(
        Progress::Style::silent, [] { return 0.0; }, [](std::string_view) {}, {0, 1},
        [&](double fraction) { heard.push_back(fraction); });
    silent.update(0.25);
    silent.update(1);
    CHECK(heard == std::vector<double>{0.25, 1});
}

TEST_CASE("progress never goes back") {
    Listener listener;
    Progress progress = listener.progress(Progress::Style::terminal);
    for (const double fraction : {0.5, 0.4, 0.0 / 0.0, 0.6, 7.0}) {
        listener.now += 1;
        progress.update(fraction);
    }
    REQUIRE(listener.said.size() == 3);
    CHECK(listener.said[1].starts_with("\r60.0 %"));
    CHECK(listener.said[2].starts_with("\r100.0 %"));
}

TEST_CASE("programs read how far it is") {
    using enum ProgressStyle;
    CHECK(progress_line(json, 0.4237, 12.5) == "{\"progress\":0.423,\"seconds\":12.5}\n");
    CHECK(progress_line(alf, 0.4299, 1) == "ALF_PROGRESS 42%\n");
    CHECK(progress_line(openjd, 1, 1) == "openjd_progress: 100\n");
    CHECK(progress_line(povray, 0.4299, 1, 4800) == "Rendered 2063 of 4800 pixels (42%)\n");
    double now = 0;
    std::string heard;
    Progress progress(
        openjd, [&] { return now; }, [&](std::string_view text) { heard += text; });
    progress.update(0.1);
    now = 1;
    progress.update(0.25);
    progress.update(1);
    progress.finish();
    CHECK(heard == "openjd_progress: 25\nopenjd_progress: 100\n");
}

}  // namespace candelabra
