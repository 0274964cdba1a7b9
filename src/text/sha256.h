// SPDX-License-Identifier: GPL-3.0-or-later
// The SHA-256 digest of a text (FIPS 180-4), as sha256sum(1) prints it: how a scene and the files
// that it reads are told from changed ones.
#pragma once

#include <string>
#include <string_view>

/// 64 hexadecimal digits. The processor's own instructions for it are used where it has them and
/// nobody forbids it.
std::string sha256(std::string_view text, bool by_instructions = true);
