// SPDX-License-Identifier: GPL-3.0-or-later
// The file that keeps the light of each lamp. It is its own format:
//     "CANDLAMP", version (u32), size of the rest (u64), the rest, SHA-256 of all before it (text).
// The rest is blocks, each its size (u64), its packed size (u64) and its bytes by zlib: a head with
// the size of the picture and the lamps, one for the meters, one for the alpha channel, and one for
// each row of tiles.
// Numbers have their lowest byte first.
#pragma once

#include "relight/light_records.h"
#include "text/diagnostic.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace candelabra {

/// Returns the bytes of a file.
std::string encode(const LightRecords&, int threads);

/// Most bytes of a file besides its lamps, their names and its tiles.
std::uint64_t record_overhead(int width, int height, bool alpha);

/// Reads the bytes of a file. Sets `problem`, which continues the name of the file, if there are no
/// records in it.
std::optional<LightRecords> decode_records(std::string_view bytes, std::string& problem);

/// Reads a file. Returns nothing after an error has been reported.
std::optional<LightRecords> read_records(const std::string& path, Diagnostics&);

}  // namespace candelabra
