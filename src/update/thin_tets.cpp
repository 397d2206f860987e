// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/thin_tets.h"

#include <algorithm>
#include <map>

#include "brep/brep.h"
#include "core/numbers_in_words.h"
#include "mesh/short_sides.h"

namespace featuremesh {

namespace {

/// Thinner tets than this tell of details of the part that no mesh of the wanted size can follow.
constexpr double thin_deg = 2;

Entity lowest_entity(const Mesh& mesh, TetId tet) {
    Entity lowest;
    for (const NodeId n : mesh.tets[tet.index()]) lowest = std::min(lowest, mesh.entities[n.index()]);
    return lowest;
}

std::string place_of(const Mesh& mesh, TetId tet) {
    const Entity at = lowest_entity(mesh, tet);
    return at.dim < 3 ? "at " + name_of(at) : "inside the part";
}

/// "Edge12 (4e-05 mm long)", "Edge3 and Edge7 (0.0001 mm apart)", by length.
class ForcingDetails {
  public:
    explicit ForcingDetails(const Mesh& mesh) : mesh_(mesh), short_sides_(mesh) {
        for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
            const auto& [a, b, c, d] = mesh.tets[t];
            if (dihedral_range(mesh.point(a), mesh.point(b), mesh.point(c), mesh.point(d)).smallest_deg >= thin_deg)
                continue;
            if (const auto side = short_sides_.forced_side(TetId(t))) add((*side)[0], (*side)[1]);
        }
    }

    std::size_t tet_count() const { return tet_count_; }
    bool force(TetId tet) const { return short_sides_.forced_side(tet).has_value(); }

    std::string listed() const {
        constexpr std::size_t most = 4;
        std::vector<std::pair<double, std::string>> details;
        for (const auto& [name, length] : length_of_) details.emplace_back(length, name);
        std::sort(details.begin(), details.end());
        std::string text;
        for (std::size_t i = 0; i < std::min(most, details.size()); ++i)
            text += (i == 0 ? "" : ", ") + details[i].second + " (" + in_words(details[i].first, 2) + " mm " +
                    (details[i].second.find(" and ") == std::string::npos ? "long)" : "apart)");
        return details.size() > most ? text + " and " + std::to_string(details.size() - most) + " more" : text;
    }

  private:
    void add(NodeId a, NodeId b) {
        ++tet_count_;
        const std::int32_t segment = short_sides_.segment_at(a, b);
        const auto [low, high] = std::minmax(mesh_.entities[a.index()], mesh_.entities[b.index()]);
        const std::string name = segment >= 0
                                     ? name_of(entity_of(mesh_.segment_edges[static_cast<std::size_t>(segment)]))
                                     : name_of(low) + " and " + name_of(high);
        const double length = distance(mesh_.point(a), mesh_.point(b));
        const auto [it, is_new] = length_of_.try_emplace(name, length);
        if (!is_new) it->second = std::min(it->second, length);
    }

    const Mesh& mesh_;
    ShortSides short_sides_;
    std::map<std::string, double> length_of_;
    std::size_t tet_count_ = 0;
};

}  // namespace

std::vector<std::string> warnings_of_thin_tets(const Mesh& mesh, const QualityReport& quality) {
    if (!quality.worst.is_valid() || quality.min_dihedral >= thin_deg) return {};
    std::vector<std::string> lines;
    const ForcingDetails details(mesh);
    if (details.tet_count() > 0)
        lines.push_back("Details of the part far smaller than the elements force an angle below 2 degrees on " +
                        std::to_string(details.tet_count()) + " elements: " + details.listed() +
                        ". Results there are poor. Take them out of the features that make them (points of a sketch "
                        "that nearly coincide, a step as "
                        "shallow), or mesh finer there.");
    if (!details.force(quality.worst))
        lines.push_back("The smallest angle of an element is " + in_words(quality.min_dihedral, 2) + " degrees, " +
                        place_of(mesh, quality.worst) +
                        ": results there are poor. Take details out that are much smaller than the edge length, or "
                        "mesh finer there.");
    return lines;
}

}  // namespace featuremesh
