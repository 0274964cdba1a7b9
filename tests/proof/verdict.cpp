// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/verdict.h"

#include "proof/statistics.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

namespace candelabra::proof {

namespace {

/// A first look, of which most claims come away: one whose |T| is within `t` in all regions holds.
/// What is seen here counts for nothing later.
struct Look {
    int samples;
    double t;
};
constexpr Look first_look{4, 2.5};

/// One test with noise of its own. A claim whose T is within `t` holds.
struct Stage {
    int batches, samples;
    double t;       ///< least |T| of the pixels that is suspicious
    double spread;  ///< least |t| of the batches that is suspicious
    double sure;    ///< least |t| of the batches that needs no further stage
};
constexpr double never = std::numeric_limits<double>::infinity();
/// With symmetric noise the first stage stops 99 of 100 scenes for the 51 regions; the second has
/// one region and a false alarm in 10^4, the third one in 10^6 by pixels and, whatever the noise in
/// a batch is, one in 10^6 by 16 batches (Student's t with 15 degrees of freedom beyond 8), as the
/// second by 6 (5 degrees of freedom beyond 30), whose time may be all there is. The fourth decides
/// where these batches were too few (31 degrees of freedom beyond 6.2).
constexpr Stage stages[] = {
    {2, 8, 3.8, 0, never}, {6, 12, 4.2, 3, 30}, {16, 16, 5.2, 4, 8}, {32, 16, 5.2, 6.2, 6.2}};

/// Pixels count for so many times the constant at most.
constexpr double brightest = 20;

/// Samples in a pixel of pictures whose bytes are compared.
constexpr int samples_of_bytes = 3;

/// What the claims of a law have in common: scenes that are ready, and pictures of them.
class Shelf {
public:
    explicit Shelf(const Studio& studio) : studio_(studio) {}

    const Studio& studio() const { return studio_; }
    const Prepared& prepared(const Term& term) { return *at(term).scene; }
    /// The picture of the term for claims of equal bytes, which is made once if it comes in time.
    Image picture(const Term& term, const Deadline& end) {
        Scene& scene = at(term);
        Image& image = scene.pictures[term.view];
        if (image.pixels.empty()) image = seen(*scene.scene, term, samples_of_bytes, 1, end);
        return image;
    }
    static Image seen(const Prepared& scene, const Term& term, int samples, int seed,
                      const Deadline& end) {
        return term.view ? term.view(scene, samples, seed, end) : scene.render(samples, seed, end);
    }

private:
    struct Scene {
        std::unique_ptr<const Prepared> scene = {};
        std::map<View, Image> pictures = {};
    };
    Scene& at(const Term& term) {
        std::string key = term.text;
        for (const RunOption& each : term.options)
            key += '\n' + std::to_string(each.field) + ' ' + text_of(each.value);
        Scene& scene = scenes_[std::move(key)];
        if (!scene.scene)
            scene.scene = std::make_unique<const Prepared>(studio_, term.text, term.options);
        return scene;
    }

    const Studio& studio_;
    std::map<std::string, Scene> scenes_;
};

/// Renders the terms of a claim, within its time.
class Renderings {
public:
    explicit Renderings(Shelf& shelf) : shelf_(shelf), end_(shelf.studio().look_seconds) {}

    /// Takes more time for a claim that is suspicious.
    void go_on() { end_ = Deadline(shelf_.studio().seconds); }

    /// Returns an empty image if there is trouble.
    Image sum(const std::vector<Term>& terms, int samples, int seed) {
        return summed(terms, [&](const Prepared& scene, const Term& term) {
            return Shelf::seen(scene, term, samples, seed, end_);
        });
    }
    /// The sum with the samples and the seed that claims of equal bytes have.
    Image sum_of_bytes(const std::vector<Term>& terms) {
        return summed(
            terms, [&](const Prepared&, const Term& term) { return shelf_.picture(term, end_); });
    }
    Trouble trouble() const { return trouble_; }
    const std::string& complaint() const { return complaint_; }

private:
    template <class PictureOf>
    Image summed(const std::vector<Term>& terms, const PictureOf& picture_of) {
        Image total;
        for (const Term& term : terms) {
            const Prepared& scene = shelf_.prepared(term);
            if (scene.trouble() != Trouble::none) {
                trouble_ = scene.trouble();
                complaint_ = scene.complaint();
                return {};
            }
            const Image image = picture_of(scene, term);
            if (image.pixels.empty()) {
                trouble_ = Trouble::too_slow;
                return {};
            }
            if (total.pixels.empty()) total = Image(image.width, image.height);
            for (std::size_t i = 0; i < image.pixels.size(); ++i)
                total.pixels[i] += term.factor * image.pixels[i];
        }
        return total;
    }

    Shelf& shelf_;
    Deadline end_;
    Trouble trouble_ = Trouble::none;
    std::string complaint_;
};

std::string name_of_region(std::size_t region) {
    static constexpr const char* channels[] = {"red", "green", "blue"};
    const std::size_t block = region / 3;
    const std::string where = block == whole ? "picture"
                                             : "block " + std::to_string(block % blocks) + "," +
                                                   std::to_string(block / blocks);
    return where + ", " + channels[region % 3];
}

class Judge {
public:
    Judge(const Claim& claim, Shelf& shelf)
        : claim_(claim), studio_(shelf.studio()), renderings_(shelf) {
        verdict_.claim = claim.name;
    }

    Verdict verdict() {
        if (claim_.bound == Bound::bytes) return bytes();
        int seed = 1;
        Comparison look(claim_.tolerance);
        if (!batches(1, first_look.samples * claim_.effort, seed, look)) return troubled(false);
        const double seen = look.t(worst(look));
        if ((claim_.bound == Bound::at_most ? seen : std::abs(seen)) <= first_look.t)
            return verdict_;
        seed += 2;
        renderings_.go_on();
        int suspected = 0;
        for (const Stage& stage : stages) {
            Comparison comparison(claim_.tolerance);
            const int samples = stage.samples * claim_.effort;
            if (!batches(stage.batches, samples, seed, comparison))
                return troubled(&stage != stages);
            seed += 2 * stage.batches;
            const double spread = suspicion(stage, samples, comparison);
            const bool rare = spread > 0 && is_rare(comparison, *region_, samples);
            if (rare && &stage != std::end(stages) - 1) continue;  // more samples may find it
            if (spread == 0 || rare) {
                if (rare || suspected >= 2) verdict_.outcome = Outcome::undecided;
                return verdict_;
            }
            ++suspected;
            if (spread > stage.sure) break;
            renderings_.go_on();  // what is suspicious is worth the time of a stage
        }
        verdict_.outcome = Outcome::fails;
        return verdict_;
    }

private:
    bool batches(int count, int samples, int seed, Comparison& comparison) {
        for (int i = 0; i < count; ++i) {
            Image left = renderings_.sum(claim_.left, samples, seed + 2 * i);
            if (renderings_.trouble() != Trouble::none) return false;
            Image right = renderings_.sum(claim_.right, samples, seed + 2 * i + 1);
            if (renderings_.trouble() != Trouble::none) return false;
            fill(left, right);
            fill(right, left);
            if (claim_.right.empty()) clip(left);
            comparison.add(left, right);
        }
        return true;
    }

    void fill(Image& image, const Image& like) const {
        if (!image.pixels.empty()) return;
        image = Image(like.width, like.height);
        for (Rgb& each : image.pixels) each = Rgb(claim_.constant);
    }

    /// Beside a constant a few pixels of any brightness would only be noise, which hides itself.
    void clip(Image& image) const {
        for (Rgb& each : image.pixels) each = min(each, Rgb(brightest * claim_.constant));
    }

    /// Returns |t| of the batches if the region may break the law; else 0.
    double suspicion(const Stage& stage, int samples, const Comparison& comparison) {
        const std::size_t region = region_ ? *region_ : first_suspect(stage, samples, comparison);
        const double t = comparison.t(region);
        const Spread spread = comparison.spread(region);
        const double pixels = static_cast<double>(studio_.width * studio_.height) *
                              static_cast<double>(comparison.batches()) /
                              (region / 3 == whole ? 1 : blocks * blocks);
        verdict_.t = t;
        verdict_.left = comparison.left(region) / pixels;
        verdict_.right = comparison.right(region) / pixels;
        verdict_.said = name_of_region(region) + ", " + std::to_string(stage.batches) + " times " +
                        std::to_string(samples) + " samples, t of batches " +
                        text_of(std::round(spread.t * 10) / 10);
        const bool same = !region_ || t * before_ > 0;
        region_ = region;
        before_ = t;
        if (claim_.bound == Bound::at_most && t < 0) return 0;
        const bool suspect = std::abs(t) > stage.t && std::abs(spread.t) > stage.spread && same;
        return suspect ? std::abs(spread.t) : 0;
    }

    /// Whether a side may have missed what hardly ever comes to the region.
    bool is_rare(const Comparison& comparison, std::size_t region, int samples) const {
        return claim_.bound == Bound::equal && !claim_.right.empty() &&
               (comparison.too_rare(region, samples) ||
                (claim_.by_chance && comparison.lacks_rare(region, samples)));
    }

    /// The region that further stages test: the worst one, but a suspicious one before those of rare
    /// light, which hardly any number of samples decides.
    std::size_t first_suspect(const Stage& stage, int samples, const Comparison& comparison) const {
        std::size_t found = worst(comparison);
        if (!is_rare(comparison, found, samples)) return found;
        double most = stage.t;
        for (std::size_t i = 0; i < regions; ++i) {
            const double t = std::abs(comparison.t(i));
            if (t <= most || is_rare(comparison, i, samples)) continue;
            most = t;
            found = i;
        }
        return found;
    }

    std::size_t worst(const Comparison& comparison) const {
        if (claim_.bound == Bound::equal) return comparison.worst();
        std::size_t worst = 0;
        for (std::size_t i = 1; i < regions; ++i)
            if (comparison.t(i) > comparison.t(worst)) worst = i;
        return worst;
    }

    Verdict bytes() {
        const Image left = renderings_.sum_of_bytes(claim_.left);
        if (renderings_.trouble() != Trouble::none) return troubled(false);
        const Image right = renderings_.sum_of_bytes(claim_.right);
        if (renderings_.trouble() == Trouble::illegal) return refused();
        if (renderings_.trouble() != Trouble::none) return troubled(false);
        if (left.pixels.size() != right.pixels.size()) {
            verdict_.outcome = Outcome::fails;
            verdict_.said = std::to_string(left.pixels.size()) + " pixels, and " +
                            std::to_string(right.pixels.size());
            return verdict_;
        }
        std::size_t unequal = 0;
        double greatest = 0;
        for (std::size_t i = 0; i < left.pixels.size(); ++i) {
            double here = 0;
            for (int c = 0; c < 3; ++c) {
                const double a = left.pixels[i][c], b = right.pixels[i][c];
                if (a != b) here = std::max(here, std::abs(a - b) / (std::abs(a) + std::abs(b)));
            }
            if (here <= claim_.tolerance) continue;
            ++unequal;
            if (here <= greatest) continue;
            greatest = here;
            verdict_.left = left.pixels[i].r, verdict_.right = right.pixels[i].r;
        }
        if (unequal > 0) verdict_.outcome = Outcome::fails;
        verdict_.said = std::to_string(unequal) + " pixels differ, by at most their " +
                        text_of(greatest) + "th part";
        return verdict_;
    }

    /// What is the same scene must be one.
    Verdict refused() {
        verdict_.outcome = Outcome::fails;
        verdict_.said = renderings_.complaint();
        return verdict_;
    }

    Verdict troubled(bool suspected) {
        const bool slow = renderings_.trouble() == Trouble::too_slow;
        verdict_.outcome = !slow       ? Outcome::illegal
                           : suspected ? Outcome::undecided
                                       : Outcome::too_slow;
        if (!slow) verdict_.said = renderings_.complaint();
        return verdict_;
    }

    const Claim& claim_;
    const Studio& studio_;
    Renderings renderings_;
    Verdict verdict_;
    std::optional<std::size_t> region_;
    double before_ = 0;
};

int rank(Outcome outcome) {
    switch (outcome) {
        case Outcome::holds:
            return 0;
        case Outcome::too_slow:
            return 1;
        case Outcome::illegal:
            return 2;
        case Outcome::undecided:
            return 3;
        case Outcome::fails:
            return 4;
    }
    return 0;
}

}  // namespace

Verdict judged(const Law& law, const Script& script, std::uint64_t seed, const Studio& studio) {
    Dice dice(seed);
    Verdict worst;
    Shelf shelf(studio);
    for (const Claim& claim : law.claims(script, dice)) {
        Verdict verdict = Judge(claim, shelf).verdict();
        if (rank(verdict.outcome) > rank(worst.outcome)) worst = std::move(verdict);
        if (worst.outcome == Outcome::fails || worst.outcome == Outcome::illegal) break;
    }
    return worst;
}

std::string described(const Verdict& verdict) {
    static constexpr const char* names[] = {"holds", "fails", "undecided", "too slow", "illegal"};
    std::string text = names[static_cast<std::size_t>(verdict.outcome)];
    if (!verdict.claim.empty()) text += ": " + verdict.claim;
    if (verdict.outcome == Outcome::fails || verdict.outcome == Outcome::undecided)
        text += ": " + text_of(verdict.left) + " / " + text_of(verdict.right) + ", T " +
                text_of(verdict.t);
    return verdict.said.empty() ? text : text + " (" + verdict.said + ")";
}

}  // namespace candelabra::proof
