// SPDX-License-Identifier: GPL-3.0-or-later
// One luminaire, all with the same probability (the paper, section 4.1). It is never wrong, and
// hardly ever good.
#pragma once

#include "base/random.h"
#include "lighting/light_query.h"
#include "lighting/light_scene.h"
#include "lighting/settings.h"

namespace candelabra {

class BuiltConstantAlpha {
public:
    explicit BuiltConstantAlpha(std::size_t count) : count_(static_cast<LightIndex>(count)) {}

    PickAnswer<BuiltConstantAlpha> at(const LightQuery& query) const {
        return {*this, query.receiver};
    }
    void choose(const Receiver&, const Key&, LightPicks&) const;
    double expected(const Receiver&, const Key&, LightIndex) const {
        return 1 / static_cast<double>(count_);
    }
    std::size_t memory_bytes() const { return 0; }

private:
    LightIndex count_;
};

BuiltConstantAlpha build(const ConstantAlpha&, const LightScene&, int threads);

}  // namespace candelabra
