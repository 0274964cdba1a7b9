// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/settings.h"

#include "vocabulary/written.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("settings start with POV-Ray 3.7's values and write what differs", "[scene]") {
    GlobalSettings settings;
    CHECK(settings.max_trace_level == 5);
    CHECK(settings.adc_bailout == 1.0 / 255);
    settings.max_trace_level = 7;
    CHECK(written_fields(GlobalSettings::vocabulary, &settings) == "max_trace_level 7");
}

TEST_CASE("a run has at least one pixel", "[scene]") {
    for (const FieldInfo& field : RenderSettings::vocabulary.fields) {
        CAPTURE(field.name);
        if (field.name == "width" || field.name == "height") CHECK_FALSE(field.range.contains(0));
    }
}

}  // namespace candelabra
