// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/sha256.h"

#include <nettle/sha2.h>

#include <array>
#include <cstdint>

namespace candelabra {

std::string sha256(std::string_view text) {
    sha256_ctx state;
    sha256_init(&state);
    sha256_update(&state, text.size(), reinterpret_cast<const std::uint8_t*>(text.data()));
    std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest;
    sha256_digest(&state, digest.size(), digest.data());
    std::string digits;
    for (const std::uint8_t byte : digest)
        for (const int half : {byte >> 4, byte & 15}) digits += "0123456789abcdef"[half];
    return digits;
}

}  // namespace candelabra
