// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/model_settings.h"

#include <catch2/catch.hpp>

#include <algorithm>

namespace candelabra {

TEST_CASE("a model has a file and a part", "[scene]") {
    const ItemInfo& info = ModelSettings::vocabulary;
    CHECK(info.name == "model");
    for (const char* field : {"file", "part"})
        CHECK(std::ranges::find(info.fields, field, &FieldInfo::name) != info.fields.end());
}

}  // namespace candelabra
