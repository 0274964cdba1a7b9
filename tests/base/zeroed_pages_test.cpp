// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/zeroed_pages.h"

#include "support/folder.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>

#include <unistd.h>

namespace candelabra {

namespace {

std::span<std::uint64_t> numbers_in(const ZeroedPages& pages) {
    return {static_cast<std::uint64_t*>(pages.data()), pages.size() / sizeof(std::uint64_t)};
}

std::size_t resident_bytes() {
    std::ifstream file("/proc/self/statm");
    std::size_t all = 0, resident = 0;
    file >> all >> resident;
    return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

constexpr std::size_t much = std::size_t{64} << 20;

}  // namespace

TEST_CASE("pages are zero, keep what is written, and move") {
    const Folder folder;
    for (const int kind : {0, 1, 2}) {
        CAPTURE(kind);
        constexpr std::size_t bytes = 1 << 16;
        ZeroedPages pages = kind == 0   ? ZeroedPages(bytes)
                            : kind == 1 ? ZeroedPages::sparse(bytes)
                                        : std::move(*ZeroedPages::in_file(folder.path(), bytes));
        CHECK(std::ranges::all_of(numbers_in(pages), [](std::uint64_t n) { return n == 0; }));
        numbers_in(pages).back() = 7;
        pages.let_go();
        ZeroedPages other = std::move(pages);
        CHECK(pages.size() == 0);
        CHECK(numbers_in(other).back() == 7);
        pages = std::move(other);
        CHECK(numbers_in(pages).back() == 7);
    }
    CHECK(std::filesystem::is_empty(folder.path()));
    CHECK(ZeroedPages().size() == 0);
    CHECK(ZeroedPages(0).data() == nullptr);
}

TEST_CASE("pages that nobody uses take no memory, nor do those that lie in a file") {
    const Folder folder;
    const std::size_t before = resident_bytes();
    const ZeroedPages pages(much);
    numbers_in(pages).back() = 1;
    CHECK(resident_bytes() < before + much / 4);
    const auto stored = ZeroedPages::in_file(folder.path(), much);
    REQUIRE(stored);
    std::ranges::fill(numbers_in(*stored), 1);
    stored->let_go();
    CHECK(resident_bytes() < before + much / 4);
    CHECK(numbers_in(*stored)[much / 16] == 1);
}

TEST_CASE("a folder that takes no file gives no pages") {
    CHECK_FALSE(ZeroedPages::in_file("/no/such/folder", 4096));
    CHECK_FALSE(ZeroedPages::in_file("/proc", 4096));
    const Folder folder;
    CHECK_FALSE(ZeroedPages::in_file(folder.path(), std::size_t{1} << 60));
    CHECK(std::filesystem::is_empty(folder.path()));
}

}  // namespace candelabra
