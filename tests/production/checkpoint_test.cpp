// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/checkpoint.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <random>

namespace candelabra {

namespace {

Checkpoint example() {
    RenderSettings settings;
    settings.width = 7;
    settings.height = 5;
    Checkpoint checkpoint{
        {{"program", "x"}, {"file a b.pov", "12"}}, begin_picture(settings, 2), 3, 9, true};
    checkpoint.state.shard = {{0, 1, 7, 5}, 2, 4, 6, 7};
    checkpoint.state.rounds = 2;
    double value = -1;
    for (PixelSum& pixel : checkpoint.state.film.pixels()) {
        pixel.planned = 5;
        for (int i = 0; i < 3; ++i, value += 0.37) pixel.add(Rgb(value, 1e9 * value, 1e-9));
    }
    for (std::size_t i = 0; i < 35; ++i) checkpoint.state.film.extra(i)[i % 2].add(-1e6 * value);
    return checkpoint;
}

}  // namespace

TEST_CASE("a state comes back bit by bit; a damaged one is an error and no crash") {
    const std::string path = std::filesystem::temp_directory_path() / "candelabra_state.exr";
    Diagnostics diagnostics;
    const Checkpoint made = example();
    const auto bytes = encode(made, diagnostics);
    REQUIRE(bytes);
    const auto put = [&](const std::string& text) {
        std::ofstream(path, std::ios::binary) << text;
    };
    put(*bytes);
    CHECK(read_checkpoint(path, diagnostics) == made);
    CHECK(diagnostics.all().empty());

    std::mt19937 random(1);
    for (int i = 0; i < 200; ++i) {
        std::string damaged = *bytes;
        if (i % 2)
            damaged.resize(random() % damaged.size());
        else
            for (int k = 0; k < 1 + i / 20; ++k)
                damaged[random() % damaged.size()] = static_cast<char>(random());
        if (damaged == *bytes) continue;
        put(damaged);
        Diagnostics problems;
        const auto read = read_checkpoint(path, problems);
        CAPTURE(i);
        // Data that the sums do not cover may differ: the picture for viewers, and the texts.
        CHECK((read ? read->state.film == made.state.film : problems.error_count() == 1));
    }
    std::filesystem::remove(path);
}

TEST_CASE("a state whose shard cannot be is refused") {
    const std::string path = std::filesystem::temp_directory_path() / "candelabra_share.exr";
    const auto readable = [&](const auto& change) {
        Checkpoint made = example();
        change(made);
        Diagnostics diagnostics;
        const auto bytes = encode(made, diagnostics);
        REQUIRE(bytes);
        std::ofstream(path, std::ios::binary) << *bytes;
        return read_checkpoint(path, diagnostics).has_value();
    };
    CHECK(readable([](Checkpoint&) {}));
    CHECK_FALSE(readable([](Checkpoint& c) { c.state.shard.first_tile = 4; }));
    CHECK_FALSE(readable([](Checkpoint& c) { c.state.shard.first_tile = -1; }));
    CHECK_FALSE(readable([](Checkpoint& c) { c.state.shard.tile_step = 2'000'000'000; }));
    CHECK_FALSE(readable([](Checkpoint& c) { c.state.shard.first_sample = 7; }));
    CHECK_FALSE(readable([](Checkpoint& c) { c.samples = 0xffffffffu; }));
    CHECK_FALSE(readable([](Checkpoint& c) { c.state.shard.region.right = 8; }));
    CHECK_FALSE(readable([](Checkpoint& c) { c.state.shard.region.top = -1; }));
    CHECK_FALSE(readable([](Checkpoint& c) { c.state.shard.region.left = 8; }));
    CHECK_FALSE(readable([](Checkpoint& c) { c.state.rounds = 0xffffffffu; }));
    CHECK_FALSE(readable([](Checkpoint& c) { c.all_samples = 0xffffffffu; }));
    std::filesystem::remove(path);
}

TEST_CASE("a state whose sums cannot be is refused, though its checksum is right") {
    const std::string path = std::filesystem::temp_directory_path() / "candelabra_sums.exr";
    const auto readable = [&](const auto& change) {
        Checkpoint made = example();
        change(made.state.film.at(3, 2));
        Diagnostics diagnostics;
        const auto bytes = encode(made, diagnostics);
        REQUIRE(bytes);
        std::ofstream(path, std::ios::binary) << *bytes;
        return read_checkpoint(path, diagnostics).has_value();
    };
    CHECK(readable([](PixelSum&) {}));
    CHECK_FALSE(readable([](PixelSum& p) { p.planned = 0xffffffffu; }));
    CHECK_FALSE(readable([](PixelSum& p) { p.samples = 0xffffffffu; }));
    CHECK_FALSE(readable([](PixelSum& p) { p.samples = 0; }));
    CHECK_FALSE(readable([](PixelSum& p) { p.display[1] = std::uint64_t{1} << 40; }));
    CHECK_FALSE(readable([](PixelSum& p) { p.display_squared[2] = ~std::uint64_t{0}; }));
    std::filesystem::remove(path);
}

TEST_CASE("light of lamps comes back behind a state, and any damage to it is found") {
    const std::string path = std::filesystem::temp_directory_path() / "candelabra_lamps.state.exr";
    Diagnostics diagnostics;
    Checkpoint made = example();
    const auto plain = encode(made, diagnostics);
    made.lamps = std::string("\0light of lamps", 15);
    const auto bytes = encode(made, diagnostics);
    REQUIRE(bytes);
    CHECK(bytes->starts_with(*plain));
    const auto read = [&](const std::string& text) {
        std::ofstream(path, std::ios::binary) << text;
        Diagnostics problems;
        auto state = read_checkpoint(path, problems);
        CHECK(problems.failed() == !state);
        return state;
    };
    CHECK(read(*bytes) == made);
    for (std::size_t i = plain->size(); i < bytes->size(); ++i) {
        std::string damaged = *bytes;
        damaged[i] = static_cast<char>(damaged[i] ^ 1);
        const auto state = read(damaged);
        // Without the mark at the end there is a state without lamps.
        REQUIRE((!state || state->lamps.empty()));
    }
    std::filesystem::remove(path);
}

}  // namespace candelabra
