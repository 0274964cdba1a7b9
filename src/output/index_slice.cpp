// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/index_slice.h"

#include "text/message.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

namespace {

constexpr double longer_side = 1000;  ///< of the drawing

int longest_axis(const Vec3& v) {
    const Vec3 size = glm::abs(v);
    return size.x >= std::max(size.y, size.z) ? 0 : size.y >= size.z ? 1 : 2;
}

void for_each_cell(const WideTree& tree, FunctionRef<void(const Box&)> use) {
    tree.for_each_node([&](std::uint32_t number, const TreeFrame& frame, int) {
        const TreeNode& node = tree.nodes()[number];
        for (std::size_t slot = 0; slot < TreeNode::width; ++slot)
            if (node.used(slot) && node.children[slot].is_leaf()) use(node.box(slot, frame.origin));
    });
}

/// Returns a box around nearly all cells; outliers such as a floor may reach much further.
Box crowded(const WideTree& tree) {
    constexpr double enough = 3;  // standard deviations
    Vec3 sum(0), squares(0);
    double count = 0;
    for_each_cell(tree, [&](const Box& cell) {
        const Vec3 centre = cell.centre() - tree.bounds().centre();
        sum += centre;
        squares += centre * centre;
        ++count;
    });
    const Vec3 mean = sum / count;
    const Vec3 reach = enough * glm::sqrt(glm::max(squares / count - mean * mean, Vec3(0)));
    const Vec3 middle = tree.bounds().centre() + mean;
    const Box around = clip({middle - reach, middle + reach}, tree.bounds());
    const Vec3 size = around.size();
    return size.x > 0 && size.y > 0 && size.z > 0 ? around : tree.bounds();
}

/// Maps boxes to the drawing.
class Slice {
public:
    Slice(const Projection& camera, const Box& whole) : whole_(whole) {
        depth_ = longest_axis(camera.direction);
        Vec3 up = camera.up;
        up[depth_] = 0;
        y_ = up == Vec3(0) ? (depth_ + 1) % 3 : longest_axis(up);
        x_ = 3 - depth_ - y_;
        level_ = whole.centre()[depth_];
        left_ = camera.right[x_] < 0;
        upright_ = camera.up[y_] >= 0;
        scale_ = longer_side / std::max(whole.size()[x_], whole.size()[y_]);
    }

    bool cuts(const Box& box) const {
        return box.low[depth_] <= level_ && level_ <= box.high[depth_];
    }
    std::string size() const {
        return message(rounded(scale_ * whole_.size()[x_]), ' ',
                       rounded(scale_ * whole_.size()[y_]));
    }
    std::string rectangle(const Box& box, std::string_view look) const {
        const double x = left_ ? whole_.high[x_] - box.high[x_] : box.low[x_] - whole_.low[x_];
        const double y = upright_ ? whole_.high[y_] - box.high[y_] : box.low[y_] - whole_.low[y_];
        return message("<rect x='", rounded(scale_ * x), "' y='", rounded(scale_ * y), "' width='",
                       rounded(scale_ * box.size()[x_]), "' height='",
                       rounded(scale_ * box.size()[y_]), "' ", look, "/>\n");
    }

private:
    static double rounded(double x) { return std::round(100 * x) / 100; }

    Box whole_;
    int depth_, x_, y_;
    double level_, scale_;
    bool left_, upright_;
};

/// Returns the style of a cell with this number of items.
std::string fill(std::size_t items) {
    const auto light = 245 - 25 * std::min<std::size_t>(items, 8);
    return message("fill='rgb(", light, ',', light + 5, ",250)' stroke='#357' stroke-width='0.3'");
}

}  // namespace

std::string index_slice(const World& world) {
    const WideTree& tree = world.geometry.tree;
    if (tree.nodes().empty()) return "<svg xmlns='http://www.w3.org/2000/svg'/>\n";
    const Slice slice(world.stated_view.camera, crowded(tree));
    std::string cells, nodes;
    tree.for_each_node([&](std::uint32_t number, const TreeFrame& frame, int level) {
        const TreeNode& node = tree.nodes()[number];
        for (std::size_t slot = 0; slot < TreeNode::width; ++slot) {
            if (!node.used(slot)) continue;
            const Box box = node.box(slot, frame.origin);
            if (!slice.cuts(box)) continue;
            if (node.children[slot].is_leaf())
                cells += slice.rectangle(box, fill(tree.items(node.children[slot]).size()));
            else
                nodes += slice.rectangle(
                    box, message("fill='none' stroke='#b20' stroke-width='", 3.0 / level, "'"));
        }
    });
    return message("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 ", slice.size(), "'>\n",
                   cells, nodes, "</svg>\n");
}

}  // namespace candelabra
