// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/cavity.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>

#include "core/errors.h"
#include "core/joined_sets.h"
#include "core/messages.h"
#include "mesh/second_order.h"

namespace featuremesh {

namespace {

std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
    return x ^ (x >> 31);
}

std::uint64_t node_key(NodeId n) { return mixed(static_cast<std::uint64_t>(n.value) + 0x9e3779b97f4a7c15ull); }

/// The key of a half-facet (a triangle seen from within one region), the same for any order of its corners.
std::uint64_t half_facet_key(std::uint64_t sum_of_node_keys, int region) {
    return mixed(sum_of_node_keys + 0x632be59bd9b4e019ull * static_cast<std::uint64_t>(region + 1));
}

/// A triangle, seen from within one region, that something covers (a tet) or asks to be covered (a CAD face).
struct HalfFacet {
    std::array<NodeId, 3> sorted;
    int region;
    bool is_odd_outward;  ///< the order in which the normal leaves the region
    TriangleId triangle;
    TetId tet;
    auto key() const { return std::tie(sorted, region, is_odd_outward); }
};

HalfFacet make_half_facet(std::array<NodeId, 3> outward, int region, TriangleId triangle, TetId tet) {
    HalfFacet half{outward, region, is_odd(outward), triangle, tet};
    std::sort(half.sorted.begin(), half.sorted.end());
    return half;
}

std::array<NodeId, 3> reversed(const std::array<NodeId, 3>& c) { return {c[0], c[2], c[1]}; }

/// Sums signed keys of all half-facets around each node: 0 where each meets its opposite one in the region, so that
/// only nodes at the cavity remain. Keys are 64 bits; that a sum is 0 by chance is as likely as a memory error.
class OpenNodes {
  public:
    explicit OpenNodes(std::size_t node_count) : sums_(node_count, 0) {}

    void add_tet(const std::array<NodeId, 4>& tet, int region) {
        std::uint64_t keys[4], total = 0;
        for (int k = 0; k < 4; ++k) total += keys[k] = node_key(tet[k]);
        std::uint64_t by_corner[4], all = 0;
        for (int k = 0; k < 4; ++k) {
            const std::uint64_t key = half_facet_key(total - keys[k], region);
            all += by_corner[k] = is_odd(facet_opposite(tet, k)) ? key : 0 - key;
        }
        for (int k = 0; k < 4; ++k) sums_[tet[k].index()] += all - by_corner[k];
    }
    void add_triangle(const std::array<NodeId, 3>& outward, int region) {
        const std::uint64_t key =
            half_facet_key(node_key(outward[0]) + node_key(outward[1]) + node_key(outward[2]), region);
        for (const NodeId n : outward) sums_[n.index()] += is_odd(outward) ? 0 - key : key;
    }
    std::vector<char> marks() const {
        std::vector<char> is_open(sums_.size());
        std::transform(sums_.begin(), sums_.end(), is_open.begin(), [](std::uint64_t sum) { return sum != 0; });
        return is_open;
    }

  private:
    std::vector<std::uint64_t> sums_;
};

bool are_open(std::span<const char> is_open, const std::array<NodeId, 3>& nodes) {
    return is_open[nodes[0].index()] && is_open[nodes[1].index()] && is_open[nodes[2].index()];
}

template <class Visit>
void visit_triangles(const Mesh& mesh, std::span<const std::array<SolidId, 2>> solids_beside_face, Visit visit) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& solids = solids_beside_face[mesh.triangle_faces[i].index()];
        if (solids[0].is_valid()) visit(TriangleId(i), mesh.triangles[i], solids[0].value);
        if (solids[1].is_valid()) visit(TriangleId(i), reversed(mesh.triangles[i]), solids[1].value);
    }
}

template <class Visit>
void visit_kept(const Mesh& mesh, std::span<const std::uint8_t> is_released, std::optional<std::span<const TetId>> near,
                Visit visit) {
    const std::size_t count = near ? near->size() : mesh.tets.size();
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t t = near ? (*near)[i].index() : i;
        if (is_released.empty() || !is_released[t]) visit(TetId(t), mesh.tets[t], mesh.tet_solids[t].value);
    }
}

std::vector<char> open_nodes(const Mesh& mesh, std::span<const std::array<SolidId, 2>> solids_beside_face,
                             std::span<const std::uint8_t> is_released) {
    OpenNodes open(mesh.node_count());
    visit_triangles(mesh, solids_beside_face, [&](TriangleId, const std::array<NodeId, 3>& outward, int region) {
        open.add_triangle(outward, region);
    });
    visit_kept(mesh, is_released, {},
               [&](TetId, const std::array<NodeId, 4>& tet, int region) { open.add_tet(tet, region); });
    return open.marks();
}

/// By nodes, region, direction and origin. Few half-facets have the same lowest node.
std::vector<HalfFacet> sorted(const std::vector<HalfFacet>& half_facets, std::size_t node_count) {
    std::vector<std::uint32_t> next(node_count + 1, 0);  // place of the next one with this lowest node
    for (const HalfFacet& half : half_facets) ++next[half.sorted[0].index() + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    std::vector<HalfFacet> rows(half_facets.size());
    for (const HalfFacet& half : half_facets) rows[next[half.sorted[0].index()]++] = half;
    for (std::size_t begin = 0, end; begin < rows.size(); begin = end) {
        end = next[rows[begin].sorted[0].index()];
        std::sort(rows.begin() + static_cast<std::ptrdiff_t>(begin), rows.begin() + static_cast<std::ptrdiff_t>(end),
                  [](const HalfFacet& a, const HalfFacet& b) {
                      if (a.sorted[1] != b.sorted[1]) return a.sorted[1] < b.sorted[1];
                      if (a.sorted[2] != b.sorted[2]) return a.sorted[2] < b.sorted[2];
                      return std::tie(a.region, a.is_odd_outward, a.triangle, a.tet) <
                             std::tie(b.region, b.is_odd_outward, b.triangle, b.tet);
                  });
    }
    return rows;
}

std::vector<HalfFacet> half_facets_at(std::span<const char> open, const Mesh& mesh,
                                      std::span<const std::array<SolidId, 2>> solids_beside_face,
                                      std::span<const std::uint8_t> is_released,
                                      std::optional<std::span<const TetId>> near) {
    std::vector<HalfFacet> half_facets;
    visit_triangles(mesh, solids_beside_face, [&](TriangleId t, const std::array<NodeId, 3>& outward, int region) {
        if (are_open(open, outward)) half_facets.push_back(make_half_facet(outward, region, t, TetId()));
    });
    visit_kept(mesh, is_released, near, [&](TetId t, const std::array<NodeId, 4>& tet, int region) {
        const int count = open[tet[0].index()] + open[tet[1].index()] + open[tet[2].index()] + open[tet[3].index()];
        if (count < 3) return;
        for (int k = 0; k < 4; ++k)
            if (const auto face = facet_opposite(tet, k); are_open(open, face))
                half_facets.push_back(make_half_facet(face, region, TriangleId(), t));
    });
    return sorted(half_facets, mesh.node_count());
}

/// Index of the next half-facet that lies on another triangle or in another region.
std::size_t end_of_group(const std::vector<HalfFacet>& half_facets, std::size_t begin) {
    std::size_t end = begin;
    while (end < half_facets.size() && half_facets[end].sorted == half_facets[begin].sorted &&
           half_facets[end].region == half_facets[begin].region)
        ++end;
    return end;
}

[[noreturn]] void throw_overlap(const Mesh& mesh, const HalfFacet& half) {
    throw MeshError(say<Code::kept_elements_overlap>(mesh.node_numbers[half.sorted[0].index()]));
}

/// Half-facets of one triangle in one region that remain to be filled: those of a CAD face without a tet, those of a
/// tet without a partner.
void append_unmatched(const Mesh& mesh, std::span<const HalfFacet> group, std::vector<HalfFacet>& unmatched) {
    const HalfFacet* asked[2] = {nullptr, nullptr};  // by is_odd_outward
    const HalfFacet* covers[2] = {nullptr, nullptr};
    for (const HalfFacet& half : group) {
        const HalfFacet*& place = (half.triangle.is_valid() ? asked : covers)[half.is_odd_outward];
        if (place) throw_overlap(mesh, half);
        place = &half;
    }
    for (const int odd : {0, 1}) {
        if (asked[odd] && !covers[odd]) unmatched.push_back(*asked[odd]);
        if (covers[odd] && !asked[odd] && !covers[1 - odd]) unmatched.push_back(*covers[odd]);
    }
}

Cavity make_cavity(const Mesh& mesh, const std::vector<HalfFacet>& half_facets) {
    Cavity cavity;
    std::vector<int> place(mesh.node_count(), -1);  // among the nodes of the cavity
    for (const HalfFacet& half : half_facets)
        for (const NodeId n : half.sorted) place[n.index()] = 0;
    for (std::size_t n = 0; n < place.size(); ++n) {
        if (place[n] < 0) continue;
        place[n] = static_cast<int>(cavity.nodes.size());
        cavity.nodes.emplace_back(n);
        cavity.points.push_back(mesh.points[n]);
    }
    const auto local = [&](NodeId n) { return place[n.index()]; };
    for (const HalfFacet& half : half_facets) {
        Facet facet{{local(half.sorted[0]), local(half.sorted[1]), local(half.sorted[2])}, {-1, -1}};
        // A tet fills what is behind its face: the cavity is before it.
        facet.regions[half.is_odd_outward != half.tet.is_valid()] = half.region;
        const bool is_other_half = !cavity.facets.empty() && cavity.facets.back().corners == facet.corners &&
                                   cavity.triangle_of_facet.back().is_valid() && half.triangle.is_valid();
        if (is_other_half) {
            auto& regions = cavity.facets.back().regions;
            for (int k = 0; k < 2; ++k) regions[k] = std::max(regions[k], facet.regions[k]);
            continue;
        }
        cavity.facets.push_back(facet);
        cavity.triangle_of_facet.push_back(half.triangle);
        cavity.tet_of_facet.push_back(half.tet);
    }
    return cavity;
}

/// A connected piece of the boundary: its box and the regions it bounds.
struct Shell {
    int root;
    Box box;
    std::set<int> regions;

    bool may_bound_with(const Shell& other) const {
        return box.overlaps(other.box) &&
               std::any_of(regions.begin(), regions.end(), [&](int r) { return other.regions.contains(r); });
    }
};

std::vector<Shell> find_shells(const Cavity& cavity, JoinedSets& sets) {
    std::vector<Shell> shells;
    std::vector<int> shell_of(cavity.points.size(), -1);
    for (std::size_t n = 0; n < cavity.points.size(); ++n) {
        const int root = sets.root(static_cast<int>(n));
        if (shell_of[root] < 0) shell_of[root] = static_cast<int>(shells.size()), shells.push_back({root, {}, {}});
        shells[shell_of[root]].box.add(cavity.points[n]);
    }
    for (const Facet& f : cavity.facets)
        for (const int region : f.regions)
            if (region >= 0) shells[shell_of[sets.root(f.corners[0])]].regions.insert(region);
    std::sort(shells.begin(), shells.end(), [](const Shell& a, const Shell& b) {
        return std::tie(a.box.low.x, a.root) < std::tie(b.box.low.x, b.root);
    });
    return shells;
}

/// The number of the part to which each cavity node belongs. Two shells of one solid are one part if the box of one
/// meets that of the other, because one may bound a void in the other. Solids without a common node are different
/// parts, even where they touch.
std::vector<int> number_parts(const Cavity& cavity, int& part_count) {
    JoinedSets sets(cavity.points.size());
    for (const Facet& f : cavity.facets) sets.join(f.corners[0], f.corners[1]), sets.join(f.corners[0], f.corners[2]);
    bool is_changed = true;
    while (is_changed) {
        is_changed = false;
        const std::vector<Shell> shells = find_shells(cavity, sets);
        for (std::size_t i = 0; i < shells.size(); ++i)
            for (std::size_t j = i + 1; j < shells.size() && shells[j].box.low.x <= shells[i].box.high.x; ++j)
                if (shells[i].may_bound_with(shells[j]) && sets.root(shells[i].root) != sets.root(shells[j].root))
                    sets.join(shells[i].root, shells[j].root), is_changed = true;
    }
    std::vector<int> part(cavity.points.size(), -1);
    part_count = 0;
    for (std::size_t n = 0; n < part.size(); ++n) {
        const int root = sets.root(static_cast<int>(n));
        part[n] = root == static_cast<int>(n) ? part_count++ : part[root];
    }
    return part;
}

}  // namespace

Cavity find_cavity(const Mesh& mesh, std::span<const std::array<SolidId, 2>> solids_beside_face,
                   std::span<const std::uint8_t> is_released, std::span<const char> may_be_open,
                   std::optional<std::span<const TetId>> near) {
    std::vector<char> found;
    if (may_be_open.empty()) found = open_nodes(mesh, solids_beside_face, is_released);
    const std::vector<HalfFacet> half_facets =
        half_facets_at(may_be_open.empty() ? found : may_be_open, mesh, solids_beside_face, is_released, near);
    std::vector<HalfFacet> unmatched;
    for (std::size_t begin = 0; begin < half_facets.size();) {
        const std::size_t end = end_of_group(half_facets, begin);
        append_unmatched(mesh, std::span(half_facets).subspan(begin, end - begin), unmatched);
        begin = end;
    }
    return make_cavity(mesh, unmatched);
}

std::vector<int> open_facets(const Cavity& cavity) {
    // By region and edge: how often facets run along it one way less the other way.
    std::map<std::array<int, 3>, int> balance;
    const auto visit_edges = [&](auto&& visit) {
        for (std::size_t i = 0; i < cavity.facets.size(); ++i)
            for (const int half : {0, 1})
                for (int k = 0; k < 3 && cavity.facets[i].regions[half] >= 0; ++k) {
                    const int a = cavity.facets[i].corners[k], b = cavity.facets[i].corners[(k + 1) % 3];
                    int& count = balance[{cavity.facets[i].regions[half], std::min(a, b), std::max(a, b)}];
                    visit(static_cast<int>(i), count, (a < b) == (half == 0) ? 1 : -1);
                }
    };
    visit_edges([](int, int& count, int sign) { count += sign; });
    std::vector<int> open;
    visit_edges([&](int facet, const int& count, int) {
        if (count != 0 && (open.empty() || open.back() != facet)) open.push_back(facet);
    });
    return open;
}

std::vector<Cavity> separate_cavities(Cavity cavity) {
    int part_count = 0;
    const std::vector<int> part = number_parts(cavity, part_count);
    if (part_count == 1) return {std::move(cavity)};
    std::vector<Cavity> parts(part_count);
    std::vector<int> local(cavity.points.size());
    for (std::size_t n = 0; n < part.size(); ++n) {
        Cavity& own = parts[part[n]];
        local[n] = static_cast<int>(own.points.size());
        own.nodes.push_back(cavity.nodes[n]);
        own.points.push_back(cavity.points[n]);
    }
    for (std::size_t i = 0; i < cavity.facets.size(); ++i) {
        Facet facet = cavity.facets[i];
        Cavity& own = parts[part[facet.corners[0]]];
        for (int& corner : facet.corners) corner = local[corner];
        own.facets.push_back(facet);
        own.triangle_of_facet.push_back(cavity.triangle_of_facet[i]);
        own.tet_of_facet.push_back(cavity.tet_of_facet[i]);
    }
    return parts;
}

}  // namespace featuremesh
