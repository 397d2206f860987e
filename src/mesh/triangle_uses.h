// SPDX-License-Identifier: GPL-3.0-or-later
// Which tets and which surface triangles meet in each triangle of a mesh.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/ids.h"
#include "core/run_context.h"
#include "mesh/mesh.h"

namespace featuremesh {

/// One tet or surface triangle at a triangle.
struct TriangleUse {
    std::uint32_t middle, largest;  ///< of the triangle's three nodes; the smallest one is that of the bucket
    std::int32_t code;

    bool is_tet() const { return code >= 0; }
    /// Tet or surface triangle, counted from 0.
    std::size_t element() const { return static_cast<std::size_t>(is_tet() ? code : -1 - code) / 2; }
    /// The triangle (smallest, middle, largest) has its normal out of the tet, or is the surface triangle as it is
    /// oriented.
    bool is_forward() const { return (is_tet() ? code : -1 - code) % 2 == 0; }
};

/// The uses of all triangles, grouped by their smallest node.
class TriangleUses {
  public:
    /// All triangles, or those whose three nodes are marked in `only`; `near` are then all tets with a marked node.
    TriangleUses(const Mesh& mesh, std::span<const char> only, std::span<const TetId> near, RunContext& context);
    explicit TriangleUses(const Mesh& mesh);

    std::size_t bucket_count() const { return begin_.size() - 1; }
    /// Sorts the uses with this smallest node and calls visit(uses of one triangle) for each of its triangles, tets
    /// before surface triangles.
    template <class Visit>
    void visit_bucket(std::size_t smallest, Visit visit) {
        const std::span<TriangleUse> uses(uses_.get() + begin_[smallest], uses_.get() + begin_[smallest + 1]);
        sort(uses);
        for (std::size_t first = 0, last; first < uses.size(); first = last) {
            last = first + 1;
            while (last < uses.size() && uses[last].middle == uses[first].middle &&
                   uses[last].largest == uses[first].largest)
                ++last;
            visit(std::span<const TriangleUse>(uses.subspan(first, last - first)));
        }
    }

  private:
    void gather(const Mesh& mesh, std::span<const char> only, std::span<const TetId> near, RunContext& context);
    static void sort(std::span<TriangleUse> uses);
    std::vector<std::size_t> begin_;
    std::unique_ptr<TriangleUse[]> uses_;
};

}  // namespace featuremesh
