// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/lit_layer.h"

namespace candelabra {

double LitLayer::grain(const Key& key) const {
    if (scatterer.in_air()) return 0;
    return scatterer.bsdf().shading().finish->crand > 0 ? uniform(key, Purpose::grain) : 0;
}

}  // namespace candelabra
