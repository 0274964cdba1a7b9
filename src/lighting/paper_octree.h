// SPDX-License-Identifier: GPL-3.0-or-later
// One luminaire, chosen by the lists of an octree's cells (the paper, section 4.3): luminaires that
// are bright in the cell in proportion to their unoccluded contribution, and the dim rest by an
// estimate from a few of them. A luminaire has probability 0 only if it is bright and all of it is
// below the horizon: the probability of the rest is never quite 0.
#pragma once

#include "base/random.h"
#include "base/weighted_index.h"
#include "lighting/dim_set.h"
#include "lighting/light_cells.h"
#include "lighting/light_query.h"
#include "lighting/light_scene.h"
#include "lighting/light_table.h"
#include "lighting/settings.h"

namespace candelabra {

class BuiltPaperOctree {
public:
    BuiltPaperOctree(const PaperOctree&, const LightScene&, int threads);

    PickAnswer<BuiltPaperOctree> at(const LightQuery& query) const {
        return {*this, query.receiver};
    }
    void choose(const Receiver&, const Key&, LightPicks&) const;
    /// Evaluates the same representatives of the dim luminaires as choose() with this key.
    double expected(const Receiver&, const Key&, LightIndex) const;
    std::size_t memory_bytes() const;

    std::size_t cells() const { return cells_.cells.size(); }
    /// Number of luminaires that are bright at a point; 0 at points without surfaces.
    std::size_t bright(const Vec3& point) const { return list_at(point).count; }

private:
    /// Unnormalised probabilities at a point.
    struct Odds {
        LightList list;
        LightTable::Sums bright;
        double dim = 0;  ///< of all dim luminaires together
        double total() const { return bright.total + dim; }
    };

    LightList list_at(const Vec3& point) const;
    DimSet dim_set(const LightList&) const;
    /// Fraction of the dim luminaires' probability that one of them has.
    double share(const DimSet&, LightIndex) const;
    void weigh(const Receiver&, const Key&, Odds&) const;
    /// Light of all dim luminaires together, estimated from some of them; 0 only if all are dark.
    double guess_dim(const Receiver&, const Key&, const DimSet&) const;

    int representatives_;
    LightCells cells_;  ///< without its lists, which are moved to lists_
    std::vector<LightList> lists_;
    LightTable table_;
    WeightedIndex places_;
    std::vector<std::uint64_t> dim_before_;  ///< per row of the table: see DimSet
};

}  // namespace candelabra
