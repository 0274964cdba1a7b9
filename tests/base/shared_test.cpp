// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/shared.h"

#include <catch2/catch.hpp>

#include <vector>

namespace candelabra {

TEST_CASE("copies share a value until one of them is edited", "[base]") {
    Shared<std::vector<int>> first(std::vector<int>{1, 2, 3});
    Shared<std::vector<int>> second = first;
    CHECK(&*first == &*second);
    second.edit().push_back(4);
    CHECK(first->size() == 3);
    CHECK(second->size() == 4);
    const auto* place = &*second;
    second.edit().push_back(5);
    CHECK(&*second == place);
    CHECK(Shared<std::vector<int>>()->empty());
}

}  // namespace candelabra
