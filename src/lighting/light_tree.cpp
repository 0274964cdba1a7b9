// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/light_tree.h"

#include "base/function_ref.h"
#include "base/memory_pages.h"
#include "base/parallel.h"
#include "lighting/hierarchy_builder.h"
#include "lighting/opposed_axes.h"
#include "lighting/tuning.h"

#include <algorithm>
#include <limits>

namespace candelabra {

namespace {

/// Least intensity, as a fraction of all, above which whole slots of WeightedIndex tell the
/// intensities apart well.
constexpr double wide_range = 0x1p-40;

using Float3 = std::array<float, 3>;

/// A luminaire that is to be placed in the tree.
struct TreeItem {
    Float3 low, high;
    float intensity;
    LightIndex light;
};

/// Cost of a part: its surface times its strength, as fractions that are never quite 0.
struct TreeCost {
    using Item = TreeItem;
    using Number = float;
    static constexpr int bins = tuning::light_tree.bins;
    static constexpr std::size_t many = tuning::light_tree.many;

    struct Sum {
        Float3 low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
        float intensity = 0;
    };

    static float place(const Item& item, int axis) {
        return item.low[axis] + item.high[axis];  // doubled: harmless
    }
    static LightIndex light(const Item& item) { return item.light; }
    static int bin(float from_low, float size) {
        return static_cast<int>(from_low * (bins / size));
    }
    template <class Part>
    static void add(Sum& sum, const Part& part) {
        for (int axis = 0; axis < 3; ++axis) {
            sum.low[axis] = std::min(sum.low[axis], part.low[axis]);
            sum.high[axis] = std::max(sum.high[axis], part.high[axis]);
        }
        sum.intensity += part.intensity;
    }
    static double of(const Sum& sum) {
        const double x = sum.high[0] - sum.low[0], y = sum.high[1] - sum.low[1],
                     z = sum.high[2] - sum.low[2];
        return (x * y + y * z + z * x) * (sum.intensity + 1e-12);
    }
    static bool longer(float later, float earlier) { return later > earlier; }
    static double of_side(float, float) { return 1; }
    bool is_second_kind(const Item& item) const {
        return falling && falling->falloff(item.light).has_value();
    }

    const ChoosableLights* falling = nullptr;  ///< null: all fall off with the square
};

/// Emission of all luminaires of a node: sums, weighted by intensity.
struct Shine {
    Vec3 axis = Vec3(0), bent_normal = Vec3(0);
    double flat = 0, even = 0, all = 0;
};

Shine join(const Shine& a, const Shine& b) {
    const Vec3 turned = are_opposed(a.axis, b.axis) ? -b.axis : b.axis;
    return {a.axis + turned, a.bent_normal + b.bent_normal, a.flat + b.flat, a.even + b.even,
            a.all + b.all};
}

/// Components as multiples of 1 / unit.
std::array<std::int8_t, 3> in_bytes(const Vec3& v, double unit) {
    const auto part = [&](int axis) {
        return static_cast<std::int8_t>(std::lround(unit * v[axis]));
    };
    return {part(0), part(1), part(2)};
}

/// The median centre, from at most about a thousand luminaires: a few far ones do not take the
/// others' precision.
Vec3 middle_of(const ChoosableLights& lights) {
    constexpr std::size_t enough = 1024;
    const std::size_t step = 1 + lights.size() / enough;
    std::array<std::vector<double>, 3> places;
    for (std::size_t i = 0; i < lights.size(); i += step) {
        const Vec3 centre = lights.bounds(static_cast<LightIndex>(i)).centre;
        for (int axis = 0; axis < 3; ++axis) places[axis].push_back(centre[axis]);
    }
    Vec3 result;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double>& along = places[axis];
        std::ranges::sort(along);
        result[axis] = along[along.size() / 2];
    }
    return result;
}

/// Lights that one thread takes at a time.
constexpr std::size_t batch = 4096;

/// Calls use(part, light) for each of `count` lights; the lights of a part in order.
void for_batches(std::size_t count, int threads,
                 FunctionRef<void(std::size_t part, LightIndex)> use) {
    const std::size_t parts = (count + batch - 1) / batch;
    run_parallel(parts, parts > 1 ? threads : 1, [&](std::size_t part) {
        for (std::size_t i = part * batch; i < std::min((part + 1) * batch, count); ++i)
            use(part, static_cast<LightIndex>(i));
    });
}

}  // namespace

class LightTreeBuilder {
public:
    LightTreeBuilder(LightTree& tree, const ChoosableLights& choosable, int threads)
        : tree_(tree), choosable_(choosable), threads_(threads) {
        find_units();
        const std::size_t count = unit_count();
        intensities_.resize(count);
        std::vector<Box> boxes((count + batch - 1) / batch);
        for_batches(count, threads, [&](std::size_t part, std::uint32_t unit) {
            boxes[part] = join(boxes[part], box(unit));
            intensities_[unit] = intensity(unit);
        });
        Box all;
        for (const Box& part : boxes) all = join(all, part);
        double least = INFINITY;
        for (const double intensity : intensities_) {
            total_ += intensity;
            if (intensity > 0) least = std::fmin(least, intensity);
        }
        if (least < wide_range * total_ || !tree_.copies_.empty())
            tree_.intensities_.resize(2 * count - 1);
        tree_.origin_ = middle_of(choosable);
        tree_.size_ = std::fmax(max_abs_component(all.low - tree_.origin_),
                                max_abs_component(all.high - tree_.origin_));
        build(items());
        run_on_threads(count > together ? threads : 1, [&] { finish(); });
        use_huge_pages(tree_.nodes_.data(), tree_.nodes_.size() * sizeof(LightTreeNode));
    }

private:
    /// A node with the units below it, which are consecutive in the tree's order.
    struct Part {
        std::uint32_t node, first, count;
    };

    /// Nodes with at most this number of units are finished by one thread.
    static constexpr std::uint32_t together = 4096;

    /// Returns a number of single precision that is surely below x.
    static float below(double x) {
        return std::nextafter(static_cast<float>(x), -std::numeric_limits<float>::infinity());
    }

    std::vector<TreeItem> items() const {
        std::vector<TreeItem> items(unit_count());
        for_batches(items.size(), threads_, [&](std::size_t, std::uint32_t unit) {
            const Box box = this->box(unit);
            TreeItem& item = items[unit];
            for (int axis = 0; axis < 3; ++axis) {
                item.low[axis] = below(box.low[axis] - tree_.origin_[axis]);
                item.high[axis] = -below(tree_.origin_[axis] - box.high[axis]);
            }
            item.intensity = total_ > 0 ? static_cast<float>(intensities_[unit] / total_) : 0;
            item.light = first_light(unit);
        });
        return items;
    }

    void build(std::vector<TreeItem> items) {
        const std::size_t nodes = 2 * items.size() - 1;
        tree_.nodes_.reserve(nodes);
        expect_huge_pages(tree_.nodes_.data(), nodes * sizeof(LightTreeNode));
        tree_.nodes_.resize(nodes);
        HierarchyBuilder<TreeCost> builder(
            std::move(items), {.falling = choosable_.falls_off() ? &choosable_ : nullptr});
        builder.build(
            threads_, [&](std::size_t own, std::size_t first, std::size_t middle, std::size_t end) {
                TreeCost::Sum all;
                for (std::size_t i = first; i < end; ++i) TreeCost::add(all, builder.items()[i]);
                LightTreeNode& node = tree_.nodes_[own];
                node.low = all.low;
                node.high = all.high;
                node.first_half = middle < end ? static_cast<std::uint32_t>(middle - first) : 0;
            });
        tree_.place_of_.resize(builder.items().size());
        tree_.order_.reserve(builder.items().size());
        for (const TreeItem& item : builder.items()) {
            tree_.place_of_[unit_of(item.light)] = static_cast<std::uint32_t>(tree_.order_.size());
            tree_.order_.push_back(item.light);
        }
        tree_.lights_ = static_cast<std::uint32_t>(choosable_.size());
        if (!tree_.copies_.empty()) number_places();
    }

    /// Lists the units, if some are copies.
    void find_units() {
        const auto copies = choosable_.copies();
        if (copies.empty()) return;
        tree_.copies_.assign(copies.begin(), copies.end());
        LightIndex light = 0;
        for (const LightCopy& copy : copies) {
            for (; light < copy.first; ++light) add_unit(light, LightCluster::no_copy);
            add_unit(light, static_cast<std::uint32_t>(&copy - copies.data()));
            light += copy.lights->lights();
        }
        for (; light < choosable_.size(); ++light) add_unit(light, LightCluster::no_copy);
    }
    void add_unit(LightIndex first, std::uint32_t copy) {
        tree_.unit_lights_.push_back(first);
        copies_of_units_.push_back(copy);
    }
    std::size_t unit_count() const {
        return tree_.copies_.empty() ? choosable_.size() : tree_.unit_lights_.size();
    }
    LightIndex first_light(std::uint32_t unit) const {
        return tree_.copies_.empty() ? unit : tree_.unit_lights_[unit];
    }
    /// The unit that begins with a light.
    std::uint32_t unit_of(LightIndex light) const {
        if (tree_.copies_.empty()) return light;
        return static_cast<std::uint32_t>(std::ranges::lower_bound(tree_.unit_lights_, light) -
                                          tree_.unit_lights_.begin());
    }
    /// Null if the unit is a light.
    const LightCopy* copy(std::uint32_t unit) const {
        const bool is = !tree_.copies_.empty() && copies_of_units_[unit] != LightCluster::no_copy;
        return is ? &tree_.copies_[copies_of_units_[unit]] : nullptr;
    }
    Box box(std::uint32_t unit) const {
        const LightCopy* const copied = copy(unit);
        return copied ? copied->place->box(copied->lights->box(copied->lights->root()))
                      : choosable_.bounds(first_light(unit)).box;
    }
    double intensity(std::uint32_t unit) const {
        const LightCopy* const copied = copy(unit);
        return copied ? copied->scale * copied->scale *
                            copied->lights->intensity(copied->lights->root())
                      : choosable_.bounds(first_light(unit)).intensity;
    }

    /// Gives each unit its places in the tree's order, and each node those of its first half.
    void number_places() {
        tree_.copy_begin_.resize(tree_.copies_.size());
        std::uint32_t next = 0;
        for (const LightIndex light : tree_.order_) {
            const std::uint32_t copy = copies_of_units_[unit_of(light)];
            tree_.unit_begin_.push_back(next);
            tree_.copy_of_.push_back(copy);
            if (copy != LightCluster::no_copy) tree_.copy_begin_[copy] = next;
            next += copy == LightCluster::no_copy ? 1 : tree_.copies_[copy].lights->lights();
        }
        tree_.half_places_.resize(tree_.nodes_.size());
        number_halves(all_units());
    }
    void number_halves(const Part& part) {
        if (part.count == 1) {
            tree_.half_places_[part.node] = part.first;
            return;
        }
        const auto [first, second] = halves(part);
        tree_.half_places_[part.node] =
            tree_.unit_begin_[second.first] - tree_.unit_begin_[first.first];
        number_halves(first);
        number_halves(second);
    }

    Part all_units() const { return {0, 0, static_cast<std::uint32_t>(tree_.order_.size())}; }
    std::pair<Part, Part> halves(const Part& part) const {
        const std::uint32_t half = tree_.nodes_[part.node].first_half;
        return {{part.node + 1, part.first, half},
                {part.node + 2 * half, part.first + half, part.count - half}};
    }

    /// Calls first and second, which finish the halves of a part.
    template <class First, class Second>
    void finish_both(const Part& part, const First& first, const Second& second) const {
        if (part.count > together) return run_both(threads_, first, second);
        first();
        second();
    }

    void finish() {
        std::vector<double> in_order;
        in_order.reserve(tree_.order_.size());
        for (const LightIndex light : tree_.order_)
            in_order.push_back(intensities_[unit_of(light)]);
        tree_.strengths_ = WeightedIndex(in_order);
        if (tree_.strengths_.total() > 0)
            tree_.unit_ = total_ / static_cast<double>(tree_.strengths_.total());
        shine(all_units());
        if (!choosable_.falls_off()) return;
        const bool all = choosable_.falloff(tree_.order_.front()).has_value();
        const Part falling = all ? all_units() : halves(all_units()).second;
        tree_.first_falling_ = falling.node;
        tree_.falloffs_.resize(tree_.nodes_.size() - falling.node);
        fall_off(falling);
    }

    /// Sets the falloff of the nodes of a part, from the leaves up.
    Falloff fall_off(const Part& part) {
        Falloff result;
        if (part.count > 1) {
            const auto both = halves(part);
            Falloff first, second;
            finish_both(
                part, [&] { first = fall_off(both.first); },
                [&] { second = fall_off(both.second); });
            result = join(first, second);
        } else {
            result = choosable_.falloff(tree_.order_[part.first]).value();
        }
        return tree_.falloffs_[part.node - tree_.first_falling_] = result;
    }

    /// Sets the emission of the nodes, from the leaves up. (The depth is bounded: see
    /// HierarchyBuilder.)
    Shine shine(const Part& part) {
        Shine sum;
        const LightCopy* const copied =
            part.count == 1 ? copy(unit_of(tree_.order_[part.first])) : nullptr;
        if (copied) {
            sum = shine(*copied);
        } else if (part.count == 1) {
            const LightBounds b = choosable_.bounds(tree_.order_[part.first]);
            const bool flat = b.axis != Vec3(0);
            const double rest = b.intensity * (1 - length(b.bent_normal));
            sum = {rest * b.axis, b.intensity * b.bent_normal, flat ? rest : 0,
                   flat ? rest * (flat_evenness + b.evenness) : rest, b.intensity};
        } else {
            const auto both = halves(part);
            Shine first, second;
            finish_both(
                part, [&] { first = shine(both.first); }, [&] { second = shine(both.second); });
            sum = join(first, second);
        }
        if (!tree_.intensities_.empty()) tree_.intensities_[part.node] = sum.all;
        // Opposite bent normals may cancel, and still weaken what each luminaire sends elsewhere.
        const bool plain = !(sum.flat > 0 || sum.even < sum.all);
        if (plain || !(sum.all > 0)) return sum;
        LightTreeNode& node = tree_.nodes_[part.node];
        const double spread = sum.flat > 0 ? sum.flat - length(sum.axis) : 0;
        const double even = (sum.even + 0.5 * spread) / sum.all;
        node.axis = in_bytes(sum.axis / sum.all, 127);
        node.bent_normal = in_bytes(sum.bent_normal / sum.all, 254);
        node.evenness = static_cast<std::uint8_t>(std::clamp(std::ceil(255 * even), 1.0, 255.0));
        return sum;
    }
    static Shine shine(const LightCopy& copy) {
        const LightProxy all = copy.lights->light_proxy(copy.lights->root());
        const double intensity = copy.scale * copy.scale * all.strength * all.radius;
        const Vec3 axis = (intensity / copy.scale) * copy.place->direction(all.axis);
        return {axis, Vec3(0), length(axis), intensity * all.evenness, intensity};
    }

    LightTree& tree_;
    const ChoosableLights& choosable_;
    int threads_;
    std::vector<double> intensities_;             ///< of the units, in the order of their lights
    std::vector<std::uint32_t> copies_of_units_;  ///< in that order; empty: there are none
    double total_ = 0;
};

LightTree::LightTree(const ChoosableLights& lights, int threads) {
    if (lights.size() > 0) LightTreeBuilder(*this, lights, threads);
}

LightCluster LightTree::whole_copy(const LightCluster& c) const {
    const std::uint32_t copy = copy_of_[half_places_[c.node]];
    return copy == no_copy ? c : LightCluster{0, c.first, c.count, copy};
}

std::pair<LightCluster, LightCluster> LightTree::halves_among_copies(const LightCluster& c) const {
    if (c.is_copied()) {
        auto both = copies_[c.copy].lights->halves(within(c));
        for (LightCluster* half : {&both.first, &both.second}) {
            half->first += copy_begin_[c.copy];
            half->copy = c.copy;
        }
        return both;
    }
    const std::uint32_t half = nodes_[c.node].first_half, places = half_places_[c.node];
    return {whole({c.node + 1, c.first, places}),
            whole({c.node + 2 * half, c.first + places, c.count - places})};
}

std::uint32_t LightTree::unit_at(std::uint32_t place) const {
    return static_cast<std::uint32_t>(std::ranges::upper_bound(unit_begin_, place) -
                                      unit_begin_.begin()) -
           1;
}

LightIndex LightTree::light_of_unit(std::uint32_t place) const {
    const std::uint32_t unit = unit_at(place), copy = copy_of_[unit];
    return order_[unit] +
           (copy == no_copy ? 0 : copies_[copy].lights->light(place - unit_begin_[unit]));
}

std::uint32_t LightTree::place_in_unit(LightIndex light) const {
    const auto unit = std::ranges::upper_bound(unit_lights_, light) - 1;
    const std::uint32_t at = place_of_[static_cast<std::size_t>(unit - unit_lights_.begin())],
                        copy = copy_of_[at];
    return unit_begin_[at] + (copy == no_copy ? 0 : copies_[copy].lights->place_of(light - *unit));
}

/// The proxy of its own tree, moved to its place.
LightProxy LightTree::proxy_of_copy(const LightCluster& c, double intensity) const {
    const LightCopy& copy = copies_[c.copy];
    LightProxy proxy = copy.lights->light_proxy(within(c), 0);
    const Box around = copy.place->box({proxy.centre - proxy.half, proxy.centre + proxy.half});
    const double rounding =
        1e-15 * (max_abs_component(around.low) + max_abs_component(around.high));
    proxy.centre = copy.place->point(proxy.centre);
    proxy.half = 0.5 * around.size() + rounding;
    // Strength is intensity, which grows with the area, over the radius.
    proxy.radius = copy.scale * proxy.radius + rounding;
    proxy.strength = intensity / proxy.radius;
    proxy.axis = copy.place->direction(proxy.axis) / copy.scale;
    return proxy;
}

Box LightTree::box(const LightCluster& c) const {
    if (c.is_copied()) return copies_[c.copy].place->box(copies_[c.copy].lights->box(within(c)));
    const LightTreeNode& n = nodes_[c.node];
    return {origin_ + Vec3(n.low[0], n.low[1], n.low[2]),
            origin_ + Vec3(n.high[0], n.high[1], n.high[2])};
}

LightProxy LightTree::light_proxy(const LightCluster& c, double intensity) const {
    if (c.is_copied()) return proxy_of_copy(c, intensity);
    const LightTreeNode& n = nodes_[c.node];
    const Box around = box(c);
    const double rounding =
        1e-15 * (max_abs_component(around.low) + max_abs_component(around.high));
    const double radius = 0.5 * length(around.size()) + rounding + 1e-150;
    return {around.centre(),
            radius,
            intensity / radius,
            Vec3(n.axis[0], n.axis[1], n.axis[2]) / 127.0,
            n.evenness / 255.0,
            0.5 * around.size() + rounding,
            Vec3(n.bent_normal[0], n.bent_normal[1], n.bent_normal[2]) / 254.0};
}

std::uint64_t LightTree::strength_before(const LightCluster& c) const {
    return strengths_.before(c.first);
}
std::uint64_t LightTree::strength(const LightCluster& c) const {
    return strengths_.end(c.first + c.count - 1) - strength_before(c);
}

double LightTree::intensity(const LightCluster& c) const {
    if (c.is_copied()) {
        const LightCopy& copy = copies_[c.copy];
        return copy.scale * copy.scale * copy.lights->intensity(within(c));
    }
    return intensities_.empty() ? static_cast<double>(strength(c)) * unit_ : intensities_[c.node];
}

bool LightTree::dark(const LightCluster& c) const {
    return copies_.empty() ? strength(c) == 0 : intensity(c) == 0;
}

double LightTree::share(const LightCluster& c, std::uint32_t place) const {
    if (c.is_copied()) return copies_[c.copy].lights->share(within(c), place - copy_begin_[c.copy]);
    if (intensities_.empty())
        return static_cast<double>(strengths_.of(place)) / static_cast<double>(strength(c));
    LightCluster here = c;
    while (here.count > 1 && !here.is_copied()) {
        const auto [first, second] = halves(here);
        here = first.holds(place) ? first : second;
    }
    return intensity(here) / intensity(c) * (here.is_copied() ? share(here, place) : 1);
}

std::uint32_t LightTree::draw(const LightCluster& c, double u) const {
    if (c.count == 1) return c.first;
    if (c.is_copied()) return copy_begin_[c.copy] + copies_[c.copy].lights->draw(within(c), u);
    if (!intensities_.empty()) {
        double target = u * intensity(c);
        LightCluster here = c;
        while (here.count > 1 && !here.is_copied()) {
            const auto [first, second] = halves(here);
            const double before = intensity(first);
            const bool in_first = dark(second) || (target < before && !dark(first));
            if (!in_first) target -= before;
            here = in_first ? first : second;
        }
        if (here.is_copied()) return draw(here, std::clamp(target / intensity(here), 0.0, below_1));
        return here.first;
    }
    const std::uint64_t all = strength(c);
    const auto drawn = static_cast<std::uint64_t>(u * static_cast<double>(all));
    return strengths_.at(strength_before(c) + std::min(drawn, all - 1));
}

std::size_t LightTree::memory_bytes() const {
    return nodes_.capacity() * sizeof(LightTreeNode) + falloffs_.capacity() * sizeof(Falloff) +
           intensities_.capacity() * sizeof(double) + order_.capacity() * sizeof(LightIndex) +
           place_of_.capacity() * sizeof(std::uint32_t) + strengths_.memory_bytes() +
           copies_.capacity() * sizeof(LightCopy) +
           (copy_begin_.capacity() + unit_lights_.capacity() + unit_begin_.capacity() +
            copy_of_.capacity() + half_places_.capacity()) *
               sizeof(std::uint32_t);
}

}  // namespace candelabra
