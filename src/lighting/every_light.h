// SPDX-License-Identifier: GPL-3.0-or-later
// The conventional way: every luminaire, at every point. Slow, without noise of its own, and the
// reference for the others.
#pragma once

#include "base/random.h"
#include "lighting/light_query.h"
#include "lighting/light_scene.h"
#include "lighting/settings.h"

namespace candelabra {

class BuiltEveryLight {
public:
    BuiltEveryLight() = default;
    explicit BuiltEveryLight(std::size_t count) : count_(static_cast<LightIndex>(count)) {}

    PickAnswer<BuiltEveryLight> at(const LightQuery& query) const {
        return {*this, query.receiver};
    }
    void choose(const Receiver&, const Key&, LightPicks&) const;
    double expected(const Receiver&, const Key&, LightIndex) const { return 1; }
    std::size_t memory_bytes() const { return 0; }

private:
    LightIndex count_ = 0;
};

BuiltEveryLight build(const EveryLight&, const LightScene&, int threads);

}  // namespace candelabra
