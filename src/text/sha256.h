// SPDX-License-Identifier: GPL-3.0-or-later
// The SHA-256 digest of a text (FIPS 180-4), as sha256sum(1) prints it. Used to detect changes to a
// scene and the files that it reads. Computed by Nettle, which uses the processor's instructions
// for it.
#pragma once

#include <string>
#include <string_view>

namespace candelabra {

/// Returns 64 hexadecimal digits.
std::string sha256(std::string_view text);

}  // namespace candelabra
