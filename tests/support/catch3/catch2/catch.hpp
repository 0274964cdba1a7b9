// SPDX-License-Identifier: GPL-3.0-or-later
// The header of Catch2 2 by that of Catch2 3, with the names that tests use. Only found with the
// latter (tests/CMakeLists.txt).
#pragma once

#include <catch2/catch_all.hpp>

#include <string>

using Catch::Approx;

namespace Catch {

inline Matchers::StringContainsMatcher Contains(const std::string& part) {
    return Matchers::ContainsSubstring(part);
}

}  // namespace Catch
