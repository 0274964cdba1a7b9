// SPDX-License-Identifier: GPL-3.0-or-later
// A law says that pictures of changed scenes agree. It makes claims from a draft or a script, and
// renders nothing itself: so a claim is checked again for a smaller script while a fault is
// narrowed down.
#pragma once

#include "proof/features.h"
#include "proof/studio.h"

#include <compare>
#include <concepts>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace candelabra::proof {

/// Replaces the camera's view by another way of looking at the world: an image of samples. Copies
/// are the same view, so that what they see is made once for several claims.
class View {
public:
    using Way = std::function<Image(const Prepared&, int samples, int seed, const Deadline& end)>;

    View() = default;
    template <class F>
    requires std::convertible_to<F, Way> View(F way)
        : way_(std::make_shared<const Way>(std::move(way))) {}

    explicit operator bool() const { return way_ != nullptr; }
    Image operator()(const Prepared& scene, int samples, int seed, const Deadline& end) const {
        return (*way_)(scene, samples, seed, end);
    }
    friend auto operator<=>(const View&, const View&) = default;

private:
    std::shared_ptr<const Way> way_;
};

/// One rendering of a sum.
struct Term {
    std::string text;
    double factor = 1;
    std::vector<RunOption> options = {};
    View view = {};  ///< empty: the picture of the camera
};

enum class Bound {
    equal,    ///< both have the same mean
    at_most,  ///< the left is not brighter than the right
    bytes     ///< both are the same in every bit
};

struct Claim {
    std::string name;
    std::vector<Term> left, right;  ///< sums; an empty one is a constant
    Bound bound = Bound::equal;
    double constant = 0;      ///< of an empty sum
    double tolerance = 2e-3;  ///< share of the light that does not count
    int effort = 1;           ///< factor of samples, for differences that are small beside the noise
    bool by_chance = false;   ///< the right finds light by chance, and may miss what is rare
};

struct Law {
    std::string_view name;
    std::string_view says;
    unsigned without;  ///< traits of levels for which it does not hold
    /// The scene on which it is tested.
    Script (*stage)(Draft&);
    std::vector<Claim> (*claims)(const Script&, Dice&);
};

/// The table of laws.
const std::vector<Law>& laws();

}  // namespace candelabra::proof
