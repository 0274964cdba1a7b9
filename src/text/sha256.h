// SPDX-License-Identifier: GPL-3.0-or-later
// The SHA-256 digest of a text (FIPS 180-4), as sha256sum(1) prints it: how a scene and the files
// that it reads are told from changed ones. By Nettle, which knows the processor's own instructions
// for it.
#pragma once

#include <string>
#include <string_view>

namespace candelabra {

/// 64 hexadecimal digits.
std::string sha256(std::string_view text);

}  // namespace candelabra
