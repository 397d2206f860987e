// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/distances.h"
#include "difference/feature_difference.h"

namespace featuremesh {
namespace {
using Triangle = std::array<Vec3, 3>;

double depth_in_box(const Vec3& p, const Box& box) {
    const Vec3 low = p - box.low, high = box.high - p;
    return std::max(0.0, std::min({low.x, low.y, low.z, high.x, high.y, high.z}));
}
}  // namespace

/// Boxes in preorder: the left child follows its parent, the right one is named; leaves hold up to four triangles.
struct ChangedBoundary::Tree {
    struct Node {
        Box box;
        std::int32_t right = -1, begin = 0, count = 0;
    };
    std::vector<Triangle> triangles;
    std::vector<Node> nodes;
    std::optional<Box> domain;

    void build() {
        if (triangles.empty()) return;
        sort_along_curve();
        split(0, triangles.size());
    }

    /// Neighbours in the order are neighbours in space, so that halving the order halves the boxes. [Morton1966]
    void sort_along_curve() {
        Box centres;
        for (const Triangle& t : triangles) centres.add(centre(t));
        const Vec3 size = centres.size();
        const double longest = std::max({size.x, size.y, size.z, 1e-300});
        std::vector<std::uint64_t> keys(triangles.size());  // place on the curve, then index
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            const Vec3 at = (centre(triangles[t]) - centres.low) * (1023 / longest);
            const std::uint64_t place = spread(at.x) << 2 | spread(at.y) << 1 | spread(at.z);
            keys[t] = place << 32 | t;
        }
        std::sort(keys.begin(), keys.end());
        std::vector<Triangle> sorted(triangles.size());
        for (std::size_t i = 0; i < keys.size(); ++i) sorted[i] = triangles[keys[i] & 0xffffffffu];
        triangles = std::move(sorted);
    }

    /// The ten bits of a number below 1024, two places between each two.
    static std::uint64_t spread(double value) {
        auto bits = static_cast<std::uint64_t>(value);
        bits = (bits | bits << 16) & 0x030000ff;
        bits = (bits | bits << 8) & 0x0300f00f;
        bits = (bits | bits << 4) & 0x030c30c3;
        return (bits | bits << 2) & 0x09249249;
    }

    std::int32_t split(std::size_t begin, std::size_t end) {
        const auto index = std::int32_t(nodes.size());
        nodes.emplace_back();
        Box box;
        if (end - begin <= 4) {
            for (std::size_t t = begin; t < end; ++t)
                for (const Vec3& p : triangles[t]) box.add(p);
            nodes.back().begin = std::int32_t(begin);
            nodes.back().count = std::int32_t(end - begin);
        } else {
            const std::size_t middle = (begin + end) / 2;
            split(begin, middle);
            const std::int32_t right = split(middle, end);
            nodes[std::size_t(index)].right = right;
            box = nodes[std::size_t(index) + 1].box;
            box.add(nodes[std::size_t(right)].box);
        }
        nodes[std::size_t(index)].box = box;
        return index;
    }

    static Vec3 centre(const Triangle& t) { return t[0] + t[1] + t[2]; }

    /// The smaller of `best` and the squared distance; of the places below `enough` any will do.
    double nearest(const Vec3& p, double best, double enough) const {
        struct Waiting {
            std::int32_t node;
            double at_least;
        };
        std::array<Waiting, 64> stack;
        int depth = 0;
        if (!nodes.empty()) stack[depth++] = {0, squared_distance_to_box(p, nodes[0].box)};
        while (depth > 0) {
            if (best < enough) return best;
            const auto [index, at_least] = stack[--depth];
            if (at_least >= best) continue;
            const Node& node = nodes[std::size_t(index)];
            for (std::int32_t t = node.begin; t < node.begin + node.count; ++t) {
                const auto& [a, b, c] = triangles[std::size_t(t)];
                best = std::min(best, squared_distance_to_triangle(p, a, b, c));
            }
            if (node.count > 0) continue;
            const Waiting left{index + 1, squared_distance_to_box(p, nodes[std::size_t(index) + 1].box)};
            const Waiting right{node.right, squared_distance_to_box(p, nodes[std::size_t(node.right)].box)};
            const bool left_first = left.at_least <= right.at_least;
            stack[depth++] = left_first ? right : left;
            stack[depth++] = left_first ? left : right;
        }
        return best;
    }
};

ChangedBoundary::ChangedBoundary() : ChangedBoundary(std::vector<Triangle>{}) {}

ChangedBoundary::ChangedBoundary(std::vector<Triangle> triangles) {
    auto tree = std::make_shared<Tree>();
    tree->triangles = std::move(triangles);
    tree->build();
    tree_ = std::move(tree);
}

ChangedBoundary::ChangedBoundary(std::vector<Triangle> triangles, const Box& domain) {
    auto tree = std::make_shared<Tree>();
    tree->triangles = std::move(triangles);
    tree->domain = domain;
    tree->build();
    tree_ = std::move(tree);
}

bool ChangedBoundary::is_empty() const { return tree_->triangles.empty() && !tree_->domain; }

std::span<const std::array<Vec3, 3>> ChangedBoundary::triangles() const { return tree_->triangles; }

double ChangedBoundary::distance(const Vec3& p, double limit) const {
    if (tree_->domain) limit = std::min(limit, depth_in_box(p, *tree_->domain));
    if (!(limit > 0)) return 0;
    const double best = tree_->nearest(p, limit * limit, 0);
    return best < limit * limit ? std::sqrt(best) : limit;
}

bool ChangedBoundary::is_within(double reach, const Vec3& p) const {
    if (tree_->domain && depth_in_box(p, *tree_->domain) < reach) return true;
    return reach > 0 && tree_->nearest(p, reach * reach, reach * reach) < reach * reach;
}

Box ChangedBoundary::box() const {
    if (tree_->domain) return Box{Box{}.high, Box{}.low};
    return tree_->nodes.empty() ? Box{} : tree_->nodes[0].box;
}

}  // namespace featuremesh
