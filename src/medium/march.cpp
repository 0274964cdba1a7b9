// SPDX-License-Identifier: GPL-3.0-or-later
#include "medium/march.h"

#include "base/elementary.h"
#include "base/work_watch.h"
#include "medium/transmittance.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace candelabra {

namespace {

/// Fraction of the points that lie in the far part of a ray, if it has one.
constexpr double far_share = 0.25;
/// A segment longer than this multiple of the near distance has a far part.
constexpr double far_from = 4;

/// Distances along a segment of a ray for stratified random numbers: in equal steps, in proportion
/// to the transmittance, or in equal ratios.
class Spread {
public:
    enum class Kind { even, exponential, ratios };

    /// `rate`, for exponential spreads, is the mean extinction, above 0. For ratios, `from` is
    /// above 0.
    Spread(Kind kind, double from, double to, double rate)
        : kind_(kind), from_(from), to_(to), rate_(rate) {}

    /// Precondition: u is in [0, 1].
    double distance(double u) const {
        switch (kind_) {
            case Kind::exponential:
                return std::min(to_,
                                from_ - math::log1p(u * math::expm1(-rate_ * length())) / rate_);
            case Kind::ratios:
                return from_ * math::pow(to_ / from_, u);
            case Kind::even:
                break;
        }
        return from_ + u * length();
    }
    /// One over the density at a distance.
    double per_density(double distance) const {
        switch (kind_) {
            case Kind::exponential:
                return -math::expm1(-rate_ * length()) / rate_ *
                       math::exp(rate_ * (distance - from_));
            case Kind::ratios:
                return distance * math::log(to_ / from_);
            case Kind::even:
                break;
        }
        return length();
    }

private:
    double length() const { return to_ - from_; }

    Kind kind_;
    double from_, to_, rate_;
};

/// A density over [0, 1) that is constant in each of several cells.
class MarchCells {
public:
    static constexpr std::size_t count = 16;

    static double middle(std::size_t cell) { return (static_cast<double>(cell) + 0.5) / count; }

    /// Makes a uniform density if `worth` is 0 everywhere.
    explicit MarchCells(const std::array<double, count>& worth) {
        double total = 0;
        for (const double each : worth) total += each;
        for (std::size_t i = 0; i < count; ++i) {
            const double share = total > 0 ? count * worth[i] / total : 1;
            density_[i] = even_share + (1 - even_share) * share;
        }
    }

    /// Inverts the integral of the density at v in [0, 1). Successive values of v must not
    /// decrease.
    double place(double v) {
        while (cell_ + 1 < count && below_ + density_[cell_] / count <= v)
            below_ += density_[cell_++] / count;
        const double within = (v - below_) / density_[cell_];
        return std::min(static_cast<double>(cell_) / count + within, 1.0);
    }
    /// Density at the last place.
    double density() const { return density_[cell_]; }

private:
    /// Fraction of the points that are spread evenly.
    static constexpr double even_share = 0.3;

    std::array<double, count> density_;
    std::size_t cell_ = 0;
    double below_ = 0;  ///< the integral before the cell
};

/// Emission of one channel along a segment with constant coefficients.
double emitted(double emission, double extinction, double way) {
    const double depth = extinction * way;
    return std::abs(depth) < 1e-12 ? emission * way : -emission * math::expm1(-depth) / extinction;
}

class Marcher {
public:
    Marcher(MediaView media, const MediaStretch& stretch, const PatternScene& scene, const Key& key,
            MediaMarch& result)
        : media_(media),
          stretch_(stretch),
          ray_(stretch.ray),
          scene_(scene),
          first_(coefficients(media, ray_.origin, scene, stretch.light)),
          even_(homogeneous(media)),
          random_(key, Purpose::media_transmittance),
          shift_(uniform(key, Purpose::media_distance)),
          result_(result) {}

    void go() {
        const bool scatters = std::ranges::any_of(
            media_, [&](const Media* each) { return each->scatters(stretch_.light); });
        if (!even_) greatest_ = max_extinction(media_);
        if (!even_ || scatters || stretch_.shows) walk();
        if (even_) {
            left_ = math::exp(-stretch_.distance * first_.extinction);
            if (!stretch_.shows) {
                emitted_ = whole(first_.emission);
                of_luminaires_ = whole(first_.luminaires);
            }
        }
        if (!scatters) result_.places.clear();
        if (!stretch_.counted) result_.of_luminaires = of_luminaires_;
        result_.veil = {left_, emitted_ + result_.of_luminaires};
    }

private:
    /// Emission along the whole segment, if the coefficients are constant.
    Rgb whole(const Rgb& e) const {
        const Rgb& x = first_.extinction;
        const double way = stretch_.distance;
        return {emitted(e.r, x.r, way), emitted(e.g, x.g, way), emitted(e.b, x.b, way)};
    }

    void walk() {
        const double distance = stretch_.distance,
                     near = stretch_.near > 0 ? stretch_.near : distance;
        const int count = stretch_.count;
        const bool far = distance > far_from * near;
        const int far_count = far ? std::max(1, static_cast<int>(far_share * count)) : 0;
        add_places(0, far ? near : distance, count - far_count, false);
        if (far) add_places(near, distance, far_count, true);
        if (!even_ && !opaque_) pass_to(distance);
    }

    void add_places(double from, double to, int count, bool far) {
        const double rate = (first_.extinction.r + first_.extinction.g + first_.extinction.b) / 3;
        const bool thins = even_ && rate * (to - from) > 1e-6;
        const Spread spread(thins ? Spread::Kind::exponential
                            : far ? Spread::Kind::ratios
                                  : Spread::Kind::even,
                            from, to, rate);
        MarchCells cells = cells_of(spread);
        for (int i = 0; i < count && !opaque_; ++i) {
            count_work(1);
            const double distance = spread.distance(cells.place((i + shift_) / count));
            add(distance, spread.per_density(distance) / (count * cells.density()));
        }
    }

    MarchCells cells_of(const Spread& spread) const {
        std::array<double, MarchCells::count> worth{};
        if (!stretch_.worth) return MarchCells(worth);
        std::array<Vec3, MarchCells::count> places;
        for (std::size_t i = 0; i < places.size(); ++i)
            places[i] = ray_.at(spread.distance(MarchCells::middle(i)));
        (*stretch_.worth)(places, worth);
        for (std::size_t i = 0; i < places.size(); ++i) {
            const double distance = spread.distance(MarchCells::middle(i));
            worth[i] *= spread.per_density(distance);
            if (even_) worth[i] *= max_component(math::exp(-distance * first_.extinction));
        }
        return MarchCells(worth);
    }

    void add(double distance, double way) {
        if (even_) {
            const Rgb left = math::exp(-distance * first_.extinction);
            result_.places.push_back({distance, way * left, first_.scattering});
            if (stretch_.shows) add_emission(distance, way * left, first_);
            return;
        }
        const MediumPoint here = pass_to(distance);
        add_emission(distance, way * left_, here);
        if (here.scattering != Rgb(0))
            result_.places.push_back({distance, way * left_, here.scattering});
    }

    void add_emission(double distance, const Rgb& weight, const MediumPoint& here) {
        if (!stretch_.shows) {
            emitted_ += weight * here.emission;
            of_luminaires_ += weight * here.luminaires;
            return;
        }
        const Vec3 point = ray_.at(distance);
        for (std::size_t i = 0; i < media_.size(); ++i) {
            const Media& each = *media_[i];
            if (each.emission != Rgb(0) && (*stretch_.shows)(i, point))
                (each.luminaire ? of_luminaires_ : emitted_) +=
                    weight * density(each, point, scene_) * each.emission;
        }
    }

    /// Advances to a distance, and returns the coefficients there.
    MediumPoint pass_to(double distance) {
        const MediumPoint here = coefficients(media_, ray_.at(distance), scene_, stretch_.light);
        left_ *= segment_transmittance(media_, {ray_, passed_, distance, before_, here.extinction},
                                       greatest_, scene_, random_);
        opaque_ = !survives(left_, random_);
        if (opaque_) left_ = Rgb(0);
        passed_ = distance;
        before_ = here.extinction;
        return here;
    }

    MediaView media_;
    const MediaStretch& stretch_;
    const Ray& ray_;
    const PatternScene& scene_;
    MediumPoint first_;  ///< at the ray's origin
    bool even_;
    RandomStream random_;
    double shift_, greatest_ = 0;
    MediaMarch& result_;
    double passed_ = 0;
    bool opaque_ = false;  ///< nothing arrives from further on
    Rgb before_ = first_.extinction, left_ = Rgb(1), emitted_ = Rgb(0), of_luminaires_ = Rgb(0);
};

}  // namespace

void march(MediaView media, const MediaStretch& stretch, const PatternScene& scene, const Key& key,
           MediaMarch& result) {
    result.veil = {};
    result.of_luminaires = Rgb(0);
    result.places.clear();
    if (media.empty() || !(stretch.distance > 0)) return;
    Marcher(media, stretch, scene, key, result).go();
}

}  // namespace candelabra
