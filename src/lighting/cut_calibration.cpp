// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/cut_calibration.h"

#include "base/elementary.h"
#include "base/short_list.h"
#include "lighting/cluster_descent.h"
#include "lighting/survey_draw.h"
#include "lighting/tuning.h"

#include <algorithm>

namespace candelabra {

namespace {

/// Survey of an entry: the fraction of its weight that arrives, and its mean weight.
struct Trial {
    double share = 0, weight = 0;
};

std::vector<float> judged(std::span<const Trial> trials) {
    double sum = 0, squares = 0;
    for (const Trial& t : trials) {
        sum += t.share * t.weight;
        squares += t.share * t.share * t.weight;
    }
    if (!(sum > 0)) return std::vector<float>(trials.size(), 1.0f);
    // Weighted by arriving light, so that strong occluded entries do not count.
    const double mean = squares / sum;
    // Each entry from which little light arrives is limited by itself first, so that one of them
    // does not take the chance from the others.
    const double most = tuning::max_unseen * sum / mean;
    const auto dark = [&](const Trial& t) {
        return t.weight * tuning::min_share > most ? most / t.weight : tuning::min_share;
    };
    double faint = 0;
    for (const Trial& t : trials)
        if (t.share < tuning::min_share * mean) faint += dark(t) * t.weight;
    const double kept = faint > most ? most / faint : 1;
    std::vector<float> shares;
    for (const Trial& t : trials)
        shares.push_back(
            static_cast<float>(std::clamp(t.share / mean, kept * dark(t), tuning::max_share)));
    return shares;
}

}  // namespace

float cautious_share(float share, const Box& cell, const LightProxy& g) {
    const double reach = 0.5 * length(cell.size()) + g.radius;
    const Vec3 offset = g.centre - cell.centre();
    const double lowest = std::fmin(reach * reach / dot(offset, offset), 1);
    return std::fmax(share, static_cast<float>(lowest));
}

std::vector<float> arriving_shares(const LightCut& cut, const LightTree& tree,
                                   const ChoosableLights& lights,
                                   std::span<const SurveyPlace> receivers,
                                   const LightProbe& probe) {
    const std::size_t places = std::min(receivers.size(), tuning::max_entry_places);
    std::vector<CutWeights> weights(places);
    for (std::size_t i = 0; i < places; ++i) cut.weigh(receivers[i].point, weights[i]);
    const auto place_of = [&](std::size_t entry, std::size_t i) { return (i + entry) % places; };
    std::vector<std::array<double, tuning::entry_rays>> given(cut.entries());
    std::vector<double> at_place(places, 0);
    struct Drawn {
        std::size_t entry;
        std::uint32_t ray;
        MemberDraw member;
        DrawnMember found = {};
    };
    ShortList<Drawn, draws_together> drawn;
    const auto trace = [&] {
        ShortList<MemberDraw*, draws_together> members;
        for (Drawn& d : drawn) members.push_back(&d.member);
        descend_together({members.data(), members.size()});
        for (Drawn& d : drawn) {
            d.found = d.member.draw();
            lights.fetch(tree.light(d.found.place));
        }
        for (const Drawn& d : drawn) {
            const DrawnMember& member = d.found;
            if (!(member.probability > 0)) continue;
            const auto n = static_cast<std::uint32_t>(d.entry);
            const std::size_t place = place_of(d.entry, d.ray);
            const double light = lights.arriving(tree.light(member.place), receivers[place],
                                                 {survey_number(n, d.ray, EntryDraw::point_u),
                                                  survey_number(n, d.ray, EntryDraw::point_v)},
                                                 probe) /
                                 member.probability;
            given[d.entry][d.ray] = light / weights[place].weight[d.entry];
            at_place[place] += light;
        }
        drawn.clear();
    };
    for (std::size_t entry = 0; entry < cut.entries(); ++entry)
        for (std::uint32_t i = 0; i < tuning::entry_rays; ++i) {
            const std::size_t place = place_of(entry, i);
            if (!(weights[place].weight[entry] > 0)) continue;
            const auto n = static_cast<std::uint32_t>(entry);
            drawn.push_back({entry, i,
                             MemberDraw(tree, cut.cluster(entry), receivers[place].point,
                                        survey_key(n, i, EntryDraw::further_members),
                                        survey_number(n, i, EntryDraw::member))});
            if (drawn.size() == draws_together) trace();
        }
    trace();
    const std::vector<double> counts = balanced(at_place);
    std::vector<Trial> trials(cut.entries());
    for (std::size_t entry = 0; entry < cut.entries(); ++entry) {
        double squares = 0, weight_sum = 0;
        int tried = 0;
        for (std::size_t i = 0; i < tuning::entry_rays; ++i) {
            const std::size_t place = place_of(entry, i);
            const double weight = weights[place].weight[entry];
            if (!(weight > 0)) continue;
            ++tried;
            weight_sum += weight;
            squares += math::pow(counts[place] * given[entry][i], 2);
        }
        if (tried > 0) trials[entry] = {std::sqrt(squares / tried), weight_sum / tried};
    }
    return judged(trials);
}

double mean_total(const LightCut& cut, std::span<const SurveyPlace> receivers) {
    CutWeights weights;
    double sum = 0;
    for (const SurveyPlace& receiver : receivers) {
        cut.weigh(receiver.point, weights);
        sum += weights.total;
    }
    return sum / static_cast<double>(receivers.size());
}

}  // namespace candelabra
