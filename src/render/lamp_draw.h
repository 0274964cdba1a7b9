// SPDX-License-Identifier: GPL-3.0-or-later
// Which lamps a sample of a meter looks at, where each lamp has a part of its own in the result, as
// in ratings of glare. Of very many lamps some thousands are drawn, each with a weight that keeps
// the mean of the sum right.
#pragma once

#include "base/function_ref.h"
#include "world/luminaire_list.h"

#include <array>
#include <cstddef>
#include <vector>

namespace candelabra {

class LampDraw {
public:
    /// So many lamps at most are looked at in a sample.
    static constexpr std::size_t most_lamps = 4096;

    explicit LampDraw(const LuminaireList&, std::size_t most = most_lamps);

    /// An observer, and how what is summed grows with the luminance of a lamp.
    struct Sight {
        Vec3 from;
        Vec3 ahead;            ///< unit
        bool squares = false;  ///< with its square; otherwise in proportion to it

        friend bool operator==(const Sight&, const Sight&) = default;
    };
    /// The lamps' chances for one observer.
    class Chances {
    public:
        /// Calls use(lamp, weight) for the lamps of a sample: for all of them with the weight 1 if
        /// they are few. The mean of the sum of the weights of each lamp is 1; u is in [0, 1).
        void draw(double u, FunctionRef<void(LightIndex, double)> use) const;

    private:
        friend class LampDraw;
        std::size_t lamps_ = 0;
        std::vector<double> reached_ = {};  ///< sums of the chances; empty if the lamps are few
    };
    Chances chances(const Sight&) const;

private:
    /// A ball around a lamp. Its numbers decide on chances only.
    struct Ball {
        std::array<float, 3> centre;
        float radius;
        float luminance;  ///< over the greatest one
    };

    std::size_t lamps_;
    std::size_t most_;
    std::vector<Ball> balls_;  ///< empty if they are few
};

}  // namespace candelabra
