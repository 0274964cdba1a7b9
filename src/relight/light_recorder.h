// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the light of each lamp while a picture is made, in bounded memory.
#pragma once

#include "film/film.h"
#include "relight/light_records.h"
#include "relight/tile_light.h"
#include "relight/world_lamps.h"
#include "render/hooks.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace candelabra {

/// The size of a picture, and of the file that keeps its light.
struct RecordPlan {
    int width = 0, height = 0;
    std::uint64_t bytes = 0;   ///< most, before it is compressed
    std::uint64_t before = 0;  ///< bytes that are taken by other things than tiles and lamps
};

/// The size of a file without a limit: about 150 bytes a pixel, at least 16 MB.
std::uint64_t usual_record_bytes(int width, int height);
/// The least size that can be asked for.
std::uint64_t least_record_bytes(const RecordPlan&, const LampList&);

class LightRecorder final : public LampSink {
public:
    /// Precondition: the bytes are at least least_record_bytes().
    LightRecorder(WorldLamps, const RecordPlan&);

    void add(int x, int y, std::span<const LampPart>, bool negative) override;
    void passed(const Region&) override;

    /// Most bytes of memory that it takes.
    std::uint64_t most_memory() const;

    /// Returns the records when all samples have been made; the recorder is empty then.
    LightRecords finish(const Film&, int threads);

private:
    std::uint64_t seed_of(std::size_t tile) const;

    WorldLamps lamps_;
    LightRecords made_;
    std::size_t room_;  ///< bytes of a tile
    std::vector<TileLight> tiles_;
};

}  // namespace candelabra
