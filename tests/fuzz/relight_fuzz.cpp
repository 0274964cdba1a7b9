// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a show of FSEQ, as a tile of records of light, and as a file of records whose digest
// is right: no crash, and what is read fits together.
#include "fuzz/target.h"
#include "relight/fseq.h"
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
    const std::vector<Vec3> factors(records.lamps.size(), Vec3(1, 0.5, 2));
    if (relit(records, factors, 1).pixels.empty()) std::abort();
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

/// Reads the sound file with changes, each a place and a value.
void read_changed(std::string_view changes) {
    static const std::string file = encode(sound(), 1);
    constexpr std::size_t digest_bytes = 64;
    std::string content = file.substr(0, file.size() - digest_bytes);
    for (; changes.size() >= 3; changes.remove_prefix(3)) {
        const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(changes[i]); };
        content[(byte(0) + 256U * byte(1)) % content.size()] = changes[2];
    }
    std::string problem;
    const auto records = decode_records(content + sha256(content), problem);
    if (!records && problem.empty()) std::abort();
    if (records) relight(*records);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    switch (data[0] % 3) {
        case 0:
            read_show(bytes);
            break;
        case 1:
            read_tile(bytes);
            break;
        default:
            read_changed(bytes);
            break;
    }
    return 0;
}
