// SPDX-License-Identifier: GPL-3.0-or-later
// The blocks of bytes of which files with the light of lamps, and states of them, consist: each its
// size (u64), its packed size (u64) and its bytes by zlib.
#pragma once

#include "relight/byte_stream.h"
#include "relight/light_records.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace candelabra {

/// Returns the bytes packed by zlib; effort: 1 to 9.
std::string packed_by_zlib(const std::string& raw, int effort);

/// Returns a block with the bytes.
std::string block_of(const std::string& raw);

/// Takes a block from the front of the bytes, and its size from `left`, which blocks may still
/// have. Returns nothing if there is none of at most that size.
std::optional<std::string> take_block(ByteReader&, std::uint64_t& left);

/// Most bytes that the blocks of a file of so many bytes may have together when they are unpacked.
/// The files of this program unpack to a few times their size; a dark picture to more, of little.
std::uint64_t most_unpacked(std::size_t file_bytes);

/// The size of the picture, its texts and its lamps.
std::string head_of(const LightRecords&);
bool take_head(const std::string& raw, LightRecords&);

/// See LightRecords::normals.
std::string normals_of(const std::vector<std::int8_t>&);
/// Returns false if there are not as many as the picture has pixels, or none.
bool take_normals(const std::string& raw, LightRecords&);

std::string meters_of(const KeptMeters&);
/// Returns false if the bytes are not those of meters with this number of lamps.
bool take_meters(const std::string& raw, std::uint32_t lamps, KeptMeters&);

}  // namespace candelabra
