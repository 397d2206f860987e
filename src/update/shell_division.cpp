// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/shell_division.h"

#include <map>

namespace featuremesh {

namespace {

class ShellDivision {
  public:
    /// `segments`: before they were divided.
    ShellDivision(std::span<const std::array<NodeId, 2>> segments, Mesh& mesh) : mesh_(mesh) {
        for (std::size_t s = 0; s < segments.size(); ++s)
            if (mesh.segments[s] != segments[s]) divided_.emplace(segments[s], mesh.segment_edges[s]);
        for (const auto& [ends, edge] : divided_) next_[edge];
        for (std::size_t s = 0; s < mesh.segments.size(); ++s)
            if (const auto it = next_.find(mesh.segment_edges[s]); it != next_.end())
                it->second.emplace(mesh.segments[s][0], mesh.segments[s][1]);
    }

    void run(const Brep& brep) {
        for (std::size_t t = 0; t < mesh_.triangles.size() && !divided_.empty(); ++t)
            while (brep.is_free(mesh_.triangle_faces[t]) && divide(t)) {
            }
    }

  private:
    /// The triangle at its first divided side, at the first node along that.
    bool divide(std::size_t t) {
        const std::array<NodeId, 3> corners = mesh_.triangles[t];
        for (std::size_t k = 0; k < 3; ++k) {
            const NodeId a = corners[k], b = corners[(k + 1) % 3], c = corners[(k + 2) % 3];
            for (const bool is_forward : {true, false}) {
                const NodeId first = is_forward ? a : b, last = is_forward ? b : a;
                const auto found = divided_.find({first, last});
                if (found == divided_.end()) continue;
                const auto& next = next_.at(found->second);
                const NodeId middle = next.at(first);
                if (next.at(middle) != last) divided_.emplace(std::array{middle, last}, found->second);
                mesh_.triangles[t] = {a, middle, c};
                mesh_.triangle_numbers[t] = mesh_.next_element_number++;
                mesh_.add_triangle({middle, b, c}, mesh_.triangle_faces[t]);
                return true;
            }
        }
        return false;
    }

    Mesh& mesh_;
    std::map<std::array<NodeId, 2>, EdgeId> divided_;
    std::map<EdgeId, std::map<NodeId, NodeId>> next_;  ///< along edges with divided segments
};

}  // namespace

void divide_shells(const Brep& brep, std::span<const std::array<NodeId, 2>> segments, Mesh& mesh) {
    ShellDivision(segments, mesh).run(brep);
}

}  // namespace featuremesh
