// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a show of FSEQ, as a tile of records of light, as a file of records whose digest is
// right, and as the light in a state, whole or a tile of it: no crash, and what is read fits
// together.
#include "fuzz/target.h"
#include "relight/fseq.h"
#include "relight/light_recorder.h"
#include "relight/record_blocks.h"
#include "relight/record_file.h"
#include "relight/relighting.h"
#include "text/sha256.h"

#include <cmath>
#include <cstdlib>
#include <string>

using namespace candelabra;

namespace {

constexpr std::uint32_t lamps = 5;

LightRecords sound() {
    LightRecords records;
    records.width = 9;
    records.height = 5;
    records.lamps = LampList({{"A", lamps}}, {0, 1, 2, 3, 4}, std::vector<float>(lamps, 1.0F));
    records.tiles.resize(2);
    std::vector<TilePlanes> light(1);
    light[0].fill(2);
    records.tiles[1].nodes = {{0, 3}};
    records.tiles[1].own = {{1, 9, false, {1, 0, 0}}};
    records.tiles[1].residual = {{2, 10, false, {4, 4, 4}}};
    round_to_file(records.tiles[1], light);
    return records;
}

void read_show(std::string_view bytes) {
    std::string problem, way_out;
    const auto data = read_fseq(bytes, problem, way_out);
    if (!data && problem.empty()) std::abort();
    if (data && (data->frames() == 0 || data->bytes.size() % data->channels != 0)) std::abort();
}

void relight(const LightRecords& records) {
    const auto tiles = static_cast<std::size_t>(records.tiles_across() * records.tiles_down());
    if (records.tiles.size() != tiles) std::abort();
    constexpr int small = 1000;
    if (records.width > small || records.height > small) return;
    const std::vector<Rgb> factors(records.lamps.size(), Rgb(1, 0.5, 2));
    if (relit(records, factors, 1).pixels.empty()) std::abort();
    if (Relighting(records, 4, 1).picture(factors).pixels.empty()) std::abort();
}

/// Reads one tile, which is followed by nothing, as that of the sound picture.
void read_tile(std::string_view bytes) {
    LightRecords records = sound();
    auto tile = take_tile(bytes, lamps);
    if (!tile) return;
    records.tiles[0] = std::move(*tile);
    std::string again;
    append_tile(again, records.tiles[0]);
    std::string_view left = again;
    const auto same = take_tile(left, lamps);
    if (!same || *same != records.tiles[0] || !left.empty()) std::abort();
    relight(records);
}

/// The bytes with changes, each a place and a value.
std::string changed(std::string bytes, std::string_view changes) {
    for (; changes.size() >= 3; changes.remove_prefix(3)) {
        const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(changes[i]); };
        bytes[(byte(0) + 256U * byte(1)) % bytes.size()] = changes[2];
    }
    return bytes;
}

/// Reads the sound file with changes.
void read_changed(std::string_view changes) {
    static const std::string file = encode(sound(), 1);
    constexpr std::size_t digest_bytes = 64;
    const std::string content = changed(file.substr(0, file.size() - digest_bytes), changes);
    std::string problem;
    const auto records = decode_records(content + sha256(content), problem);
    if (!records && problem.empty()) std::abort();
    if (records) relight(*records);
}

/// A tile while samples are made, with a node, lamps by themselves, and fresh light.
TileLight tile_at_work() {
    TileLight tile;
    constexpr std::size_t room = 700;
    for (std::uint32_t i = 0; i < 300; ++i)
        tile.add(i % lamps, i * 7 % tile_pixels, Rgb(1, 0.5, 0.25), i % 11 == 0);
    tile.settle(sound().lamps, room, 1);
    tile.add(1, 3, Rgb(1), false);
    return tile;
}

std::string bytes_of(const TileLight& tile) {
    std::string bytes;
    tile.append_to(bytes);
    return bytes;
}

/// Reads a tile of a state, and goes on with it to its end.
void read_tile_at_work(std::string_view bytes) {
    auto tile = TileLight::take(bytes, lamps);
    if (!tile) return;
    const std::string again = bytes_of(*tile);
    std::string_view left = again;
    const auto same = TileLight::take(left, lamps);
    if (!same || bytes_of(*same) != again || !left.empty()) std::abort();
    const LampList list = sound().lamps;
    constexpr std::size_t room = 2000;
    tile->add(2, 5, Rgb(1), false);
    tile->settle(list, room, 1);
    TilePixels pixels;
    pixels.weight.fill(2);
    pixels.mean.fill(Rgb(3));
    tile->finished(list, pixels, room, 1);
}

/// Reads the light of a sound state with changes in its head, its normals or its tiles.
void read_changed_state(std::string_view changes) {
    static const std::string head = head_of(sound()), tile = bytes_of(tile_at_work());
    if (changes.empty()) return;
    const unsigned which = static_cast<unsigned char>(changes[0]) % 3;
    changes.remove_prefix(1);
    std::string state;
    append_number(state, std::uint64_t{1000});
    const std::string normals(std::size_t{3} * 9 * 5, 'n');
    state += block_of(which == 0 ? changed(head, changes) : head) + block_of(meters_of({})) +
             block_of(which == 1 ? changed(normals, changes) : normals) +
             block_of(which == 2 ? changed(tile + tile, changes) : tile + tile);
    const auto read = LightRecorder::of_state(state);
    if (!read) return;
    const std::string again = read->state(1);
    const auto same = LightRecorder::of_state(again);
    if (!same || same->state(1) != again) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    switch (data[0] % 6) {
        case 0:
            read_show(bytes);
            break;
        case 1:
            read_tile(bytes);
            break;
        case 2:
            read_changed(bytes);
            break;
        case 3:
            read_tile_at_work(bytes);
            break;
        case 4:
            read_changed_state(bytes);
            break;
        default:
            LightRecorder::of_state(bytes);
            break;
    }
    return 0;
}
