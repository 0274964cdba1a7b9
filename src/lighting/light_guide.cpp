// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/light_guide.h"

#include "base/circle.h"
#include "base/elementary.h"
#include "base/random.h"
#include "base/running_sums.h"
#include "base/target_clones.h"
#include "lighting/survey_draw.h"
#include "lighting/tuning.h"

#include <algorithm>
#include <numbers>

namespace candelabra {

namespace {

using std::numbers::pi;

constexpr std::size_t rings = LightGuide::rings, sectors = LightGuide::sectors;
/// Cosine and sine at the centres of the sectors.
struct Compass {
    std::array<float, sectors> cosine, sine;
};
const Compass& compass() {
    static const Compass made = [] {
        Compass c{};
        for (std::size_t i = 0; i < sectors; ++i) {
            const double angle = 2 * pi * (static_cast<double>(i) + 0.5) / sectors;
            c.cosine[i] = static_cast<float>(math::cos(angle));
            c.sine[i] = static_cast<float>(math::sin(angle));
        }
        return c;
    }();
    return made;
}

/// A ring's directions are along + across (cosine x + sine y) of the sectors.
struct RingView {
    float along, x, y;
};
using RingViews = std::array<RingView, rings>;

/// Sets the weights of a ring's bins by their light and their height above the horizon. Returns
/// their sum.
[[gnu::always_inline]] inline double weigh_ring(const float* light, const Compass& c,
                                                const RingView& view, float margin, bool both_sides,
                                                float* out) {
    std::array<float, sectors> weights;
    for (std::size_t i = 0; i < sectors; ++i) {
        const float signed_height = view.along + (view.x * c.cosine[i] + view.y * c.sine[i]);
        const float height = both_sides ? std::abs(signed_height) : signed_height;
        const float lifted = height + margin;
        weights[i] = light[i] * (lifted > 0 ? lifted : 0);
    }
    std::ranges::copy(weights, out);
    std::array<double, 8> strand{};
    for (std::size_t i = 0; i < sectors; i += 8)
        for (std::size_t j = 0; j < 8; ++j) strand[j] += static_cast<double>(weights[i + j]);
    for (std::size_t half = 4; half > 0; half /= 2)
        for (std::size_t j = 0; j < half; ++j) strand[j] += strand[j + half];
    return strand[0];
}

CANDELABRA_TARGET_CLONES
void weigh_rings(const float* light, const Compass& c, const RingViews& views, float margin,
                 bool both_sides, LightGuide::Weights& result) {
    for (std::size_t ring = 0; ring < rings; ++ring) {
        const std::size_t first = ring * sectors;
        result.ring[ring] = weigh_ring(light + first, c, views[ring], margin, both_sides,
                                       result.weight.data() + first);
    }
}

/// Chooses an index by a target in [0, total). The target becomes the place within its weight, in
/// [0, 1).
template <class Weight>
std::size_t find(std::span<const Weight> weights, double& target) {
    const ChosenWeight found = choose(weights, target);
    target = found.passed ? target / found.weight : below_1;
    return found.index;
}

using Picture = std::array<double, LightGuide::bins>;

/// Estimated light of each bin after one ray each: part of it comes from the neighbouring bins and,
/// with weight `care`, from the mean of all.
Picture guess(const Picture& seen, double care) {
    double mean = 0;
    for (const double light : seen) mean += light / LightGuide::bins;
    Picture result{};
    for (std::size_t r = 0; r < rings; ++r)
        for (std::size_t s = 0; s < sectors; ++s) {
            const auto at = [&](std::size_t ring, std::size_t sector) {
                return seen[ring * sectors + sector % sectors];
            };
            const double beside = at(r, s + 1) + at(r, s + sectors - 1) + at(r > 0 ? r - 1 : r, s) +
                                  at(r + 1 < rings ? r + 1 : r, s);
            const double here =
                (1 - tuning::from_neighbours) * at(r, s) + tuning::from_neighbours / 4 * beside;
            result[r * sectors + s] = (here + care * mean) / (1 + care);
        }
    return result;
}

/// Variance over squared mean of rays sampled in proportion to a guess, as measured by other rays.
double noise_of(const Picture& guess, const Picture& seen) {
    double all = 0, sum = 0, second = 0;
    for (std::size_t bin = 0; bin < LightGuide::bins; ++bin) {
        all += guess[bin];
        sum += seen[bin];
        if (seen[bin] > 0) second += seen[bin] * seen[bin] / guess[bin];
    }
    return sum > 0 && all > 0 ? std::fmax(second * all / (sum * sum) - 1, 0) : INFINITY;
}

}  // namespace

Vec3 LightGuide::Cone::direction(double ring, double sector) const {
    const double versine = ring / rings * widest;
    const double sine = std::sqrt(versine * (2 - versine));
    return (1 - versine) * middle + sine * on_circle(2 * pi * sector / sectors, x, y);
}

double LightGuide::Cone::bin_density() const { return bins / (2 * pi * widest); }

LightGuide::LightGuide(const Box& cell, const LightBall& ball,
                       std::span<const SurveyPlace> receivers, const LightProbe& probe,
                       SkySeen* sky)
    : ball_(ball) {
    const Vec3 nearest = glm::clamp(ball.centre, cell.low, cell.high);
    around_ = sky || !(length(nearest - ball.centre) > tuning::well_outside * ball.radius);
    // A pole far from the ball's direction, so that all points of the cell orient the picture
    // alike.
    const Vec3 away = glm::abs(cell.centre() - ball.centre);
    if (!around_)
        pole_ = away.x < away.y ? (away.x < away.z ? Vec3(1, 0, 0) : Vec3(0, 0, 1))
                                : (away.y < away.z ? Vec3(0, 1, 0) : Vec3(0, 0, 1));
    // Steps that have no divisor in common with the number of places reach all of them.
    const std::size_t step = receivers.size() % 5 == 0 ? 7 : 5;
    const auto place_of = [&](std::size_t bin, std::size_t i) {
        return (tuning::guide_tries * bin + i) * step % receivers.size();
    };
    std::array<Picture, tuning::guide_tries> seen{};
    std::vector<double> arriving(receivers.size(), 0);
    double cosines = 0, sum = 0, squares = 0;
    for (std::uint32_t bin = 0; bin < bins; ++bin)
        for (std::uint32_t i = 0; i < tuning::guide_tries; ++i) {
            const std::size_t place = place_of(bin, i);
            const SurveyPlace& from = receivers[place];
            const Cone cone = cone_at(from.point.position);
            const Vec3 direction =
                cone.direction(bin / sectors + survey_number(bin, i, CellDraw::ring),
                               bin % sectors + survey_number(bin, i, CellDraw::sector));
            const double cosine = from.point.cosine(direction);
            if (cosine <= 0) continue;
            cosines += cosine;
            double luminance = 0;
            const double left = look_along({from.point.position, direction}, from.tolerance, probe,
                                           [&](const ProbeHit& sight, double share) {
                                               luminance += share * sight.luminance;
                                               return false;
                                           });
            if (sky && left > 0) {
                const double behind = left * sky->sky.luminance(direction);
                luminance += behind;
                sky->rays.push_back(
                    {&from, direction, behind, tuning::guide_tries * cone.bin_density()});
            }
            seen[i][bin] = luminance;
            arriving[place] += cosine * luminance;
            sum += cosine * luminance;
            irradiance_ += cosine * luminance / (tuning::guide_tries * cone.bin_density());
            squares += cosine * luminance * luminance;
        }
    if (around_ && sum > 0) {
        mean_luminance_ = sum / cosines;
        noise_of_scattering_ = std::fmax(squares * cosines / (sum * sum) - 1, 0);
    }
    const std::vector<double> counts = balanced(arriving);
    for (std::size_t bin = 0; bin < bins; ++bin)
        for (std::size_t i = 0; i < tuning::guide_tries; ++i)
            seen[i][bin] *= counts[place_of(bin, i)];
    noise_ = INFINITY;
    double best = tuning::caution[0];
    for (const double care : tuning::caution) {
        // Each half of the rays measures the quality of the picture by the other half.
        const double noise = 0.5 * (noise_of(guess(seen[0], care), seen[1]) +
                                    noise_of(guess(seen[1], care), seen[0]));
        if (!(noise < noise_)) continue;
        noise_ = noise;
        best = care;
    }
    if (std::isinf(noise_)) return;
    Picture all{};
    for (std::size_t bin = 0; bin < bins; ++bin) all[bin] = 0.5 * (seen[0][bin] + seen[1][bin]);
    const Picture picture = guess(all, best / tuning::guide_tries);
    light_.assign(picture.begin(), picture.end());
}

LightGuide::Cone LightGuide::cone_at(const Vec3& point) const {
    if (around_) return {Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0, 1, 0), 2};
    const Vec3 offset = ball_.centre - point;
    const double distance = length(offset), sine = ball_.radius / distance;
    if (!(sine < 0.99)) return {};
    const Vec3 middle = offset / distance, x = unit(cross(pole_, middle));
    return {middle, x, cross(middle, x), sine * sine / (1 + std::sqrt(1 - sine * sine))};
}

void LightGuide::weigh(const Receiver& point, Weights& result) const {
    result.total = 0;
    if (light_.empty()) return;
    result.cone = cone_at(point.position);
    const double widest = result.cone.widest;
    if (!(widest > 0)) return;
    // In the air all directions count alike, as if all were straight above.
    const bool in_air = point.horizon == Horizon::none;
    const double along = dot(result.cone.middle, point.normal),
                 x = dot(result.cone.x, point.normal), y = dot(result.cone.y, point.normal);
    RingViews views;
    for (std::size_t ring = 0; ring < rings; ++ring) {
        const double versine = (static_cast<double>(ring) + 0.5) / rings * widest;
        const double sine = std::sqrt(versine * (2 - versine));
        views[ring] = in_air ? RingView{1, 0, 0}
                             : RingView{static_cast<float>((1 - versine) * along),
                                        static_cast<float>(sine * x), static_cast<float>(sine * y)};
    }
    // Bins that the horizon cuts get some weight, too.
    const double margin = in_air ? 0 : 0.12 * std::sqrt(widest / 2);
    weigh_rings(light_.data(), compass(), views, static_cast<float>(margin),
                point.horizon == Horizon::both_sides, result);
    for (const double ring : result.ring) result.total += ring;
}

LightGuide::Drawn LightGuide::draw(const Weights& weights, const Vec2& u) {
    double along = u.x * weights.total, around = 0;
    const std::size_t ring = find(std::span<const double>(weights.ring), along);
    around = u.y * weights.ring[ring];
    const auto sector_weights = std::span(weights.weight).subspan(ring * sectors, sectors);
    const std::size_t sector = find(sector_weights, around);
    return {weights.cone.direction(static_cast<double>(ring) + along,
                                   static_cast<double>(sector) + around),
            sector_weights[sector] / weights.total * weights.cone.bin_density()};
}

double LightGuide::density(const Weights& weights, const Vec3& direction) {
    if (!(weights.total > 0)) return 0;
    const Vec3 off = direction - weights.cone.middle;
    const double share = dot(off, off) / 2 / weights.cone.widest;
    if (share > 1 + 1e-12) return 0;
    const double angle =
        math::atan2(dot(direction, weights.cone.y), dot(direction, weights.cone.x)) / (2 * pi);
    const auto ring = static_cast<std::size_t>(share * rings);
    const auto sector = static_cast<std::size_t>((angle < 0 ? angle + 1 : angle) * sectors);
    const std::size_t bin = std::min(ring, rings - 1) * sectors + std::min(sector, sectors - 1);
    return weights.weight[bin] / weights.total * weights.cone.bin_density();
}

}  // namespace candelabra
