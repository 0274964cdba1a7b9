// SPDX-License-Identifier: GPL-3.0-or-later
// One luminaire, in proportion to the unoccluded contribution of each (the paper, section 4.2).
// Evaluates all of them at every choice. A luminaire has probability 0 only if all of it is below
// the horizon.
#pragma once

#include "base/random.h"
#include "lighting/light_query.h"
#include "lighting/light_scene.h"
#include "lighting/light_table.h"
#include "lighting/settings.h"

namespace candelabra {

class BuiltLinearAlpha {
public:
    explicit BuiltLinearAlpha(const LightScene&);

    PickAnswer<BuiltLinearAlpha> at(const LightQuery& query) const {
        return {*this, query.receiver};
    }
    void choose(const Receiver&, const Key&, LightPicks&) const;
    double expected(const Receiver&, const Key&, LightIndex) const;
    std::size_t memory_bytes() const { return table_.memory_bytes(); }

private:
    LightTable table_;
    LightList all_;
};

BuiltLinearAlpha build(const LinearAlpha&, const LightScene&, int threads);

}  // namespace candelabra
