// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the light of each lamp while a picture is made, in bounded memory.
#pragma once

#include "film/film.h"
#include "film/picture_shard.h"
#include "relight/light_records.h"
#include "relight/tile_light.h"
#include "relight/world_lamps.h"
#include "render/hooks.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
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

    const LampList& lamps() const { return made_.lamps; }
    /// Returns for each lamp whether any sample of the picture has had light of it.
    std::vector<bool> lit() const { return {lit_.begin(), lit_.end()}; }
    std::uint32_t place_of(Lamp lamp) const { return lamps_.place_of(lamp); }
    void keep(KeptMeters meters) { made_.meters = std::move(meters); }
    /// See LightRecords::normals.
    void keep(std::vector<std::int8_t> normals) { made_.normals = std::move(normals); }

    /// Returns the records when all samples have been made.
    LightRecords finish(const Film&, int threads) const;

    /// Returns the bytes of all that has been kept so far.
    std::string state(int threads) const;
    /// Goes on from a state, and keeps its own meters. Returns false, and changes nothing, if it is
    /// of other lamps or another size, or damaged.
    bool go_on(std::string_view state);
    /// Returns what a state has kept; null if it is damaged. It takes no more light.
    static std::unique_ptr<LightRecorder> of_state(std::string_view);
    /// Takes the blocks that a part of the picture has made, and its meters, if it has some.
    /// Returns false if the part is of another picture or size.
    bool adopt(LightRecorder&& part, const PictureShard&);

private:
    LightRecorder() = default;

    bool is_like(const LightRecorder&) const;
    std::uint64_t seed_of(std::size_t tile) const;

    WorldLamps lamps_;      ///< without their list
    LightRecords made_;     ///< without tiles
    std::size_t room_ = 0;  ///< bytes of a tile
    std::vector<TileLight> tiles_;
    std::vector<std::atomic<bool>> lit_;  ///< of each lamp
};

}  // namespace candelabra
