// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/apart.h"

#include <catch2/catch.hpp>

#include <csignal>
#include <stdexcept>
#include <vector>

namespace candelabra {

namespace {

constexpr ApartLimits enough{std::uint64_t{256} << 20, 20};
const auto no_wait = [] {};

/// The end of a process that does this work, while this one waits for its end.
std::string end_of(const ApartLimits& limits, FunctionRef<void(MessageEnd&)> work) {
    return work_apart(limits, work, [](MessageEnd& end) {
        while (end.receive(no_wait)) {
        }
    });
}

}  // namespace

TEST_CASE("two processes exchange messages of any size", "[apart]") {
    const std::string large(3'000'000, 'a');
    std::vector<std::string> got;
    const std::string ended = work_apart(
        enough,
        [&](MessageEnd& end) {
            end.send('x', "question");
            const auto answer = end.receive(no_wait);
            end.send('y', answer ? *answer + large : "none");
        },
        [&](MessageEnd& end) {
            got.push_back(end.receive(no_wait).value_or(""));
            end.send('z', "answer");
            got.push_back(end.receive(no_wait).value_or(""));
            CHECK_FALSE(end.receive(no_wait));
        });
    CHECK(ended.empty());
    CHECK(got == std::vector<std::string>{"xquestion", "yzanswer" + large});
}

TEST_CASE("crashes, too much time and too much memory end the other process alone", "[apart]") {
    CHECK(end_of(enough, [](MessageEnd&) {}).empty());
    CHECK(end_of(enough, [](MessageEnd&) { std::raise(SIGKILL); }).find("crashed") !=
          std::string::npos);
    CHECK(end_of(enough, [](MessageEnd&) { throw std::runtime_error("no"); }) != "");
    const ApartLimits short_time{std::uint64_t{256} << 20, 1};
    CHECK(end_of(short_time, [](MessageEnd&) {
              for (volatile int i = 0;; i = i + 1) {
              }
          }) == "it takes too long");
    std::string large;
    CHECK(end_of(enough, [&](MessageEnd&) { large.resize(std::size_t{1} << 33); }) != "");
    CHECK(large.empty());
}

TEST_CASE("an exception of the waiting side ends the other process", "[apart]") {
    int waits = 0;
    const auto wait = [&] {
        if (++waits == 2) throw std::runtime_error("enough");
    };
    CHECK_THROWS_AS(work_apart(
                        enough, [](MessageEnd& end) { end.receive(no_wait); },
                        [&](MessageEnd& end) { end.receive(wait); }),
                    std::runtime_error);
}

TEST_CASE("memory is shared with a process of its own", "[base]") {
    SharedMemory memory(std::size_t{1} << 30);
    REQUIRE(memory.size() == std::size_t{1} << 30);
    std::string seen;
    const std::string ended = work_apart(
        {std::uint64_t{2} << 30, 10},
        [&](MessageEnd& end) {
            memory.data()[memory.size() - 1] = 'x';
            end.send('d', {});
        },
        [&](MessageEnd& end) {
            if (end.receive([] {})) seen = memory.data()[memory.size() - 1];
        });
    CHECK(ended.empty());
    CHECK(seen == "x");
}

}  // namespace candelabra
