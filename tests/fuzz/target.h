// SPDX-License-Identifier: GPL-3.0-or-later
// What a fuzz target offers: libFuzzer's entry, which mutate.cpp calls as well.
#pragma once

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
