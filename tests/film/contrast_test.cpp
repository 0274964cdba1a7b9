// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/contrast.h"

#include "support/edges.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("what is clear counts where a picture has an alpha channel", "[render]") {
    const Contrast contrast = contrast_of(rows(3), 1);
    const DisplayValue black = contrast.shown(Rgb(0), 0);
    CHECK(contrast.between(black, contrast.shown(Rgb(0), 0.31)));
    CHECK_FALSE(contrast.between(black, contrast.shown(Rgb(0), 0.29)));
}

}  // namespace candelabra
