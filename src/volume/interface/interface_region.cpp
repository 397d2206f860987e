// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/interface/interface_region.h"

#include <algorithm>
#include <tuple>

#include "core/sort_once.h"
#include "volume/tets/cavity_editor.h"
#include "volume/tets/tet_topology.h"

namespace featuremesh {

namespace {

bool is_outside(const Brep& brep, FaceId face) {
    const auto solids = brep.solids_beside(face);
    return solids[0].is_valid() != solids[1].is_valid();
}

}  // namespace

InterfaceRegion::InterfaceRegion(const Cavity& cavity, TetComplex filled)
    : complex(std::move(filled)), nodes_(cavity.nodes), is_at_interface_(cavity.nodes.size(), 0) {
    for (std::size_t f = 0; f < cavity.facets.size(); ++f)
        if (cavity.tet_of_facet[f].is_valid())
            for (const int v : cavity.facets[f].corners) is_at_interface_[static_cast<std::size_t>(v)] = 1;
}

std::vector<int> InterfaceRegion::bad_tets_at_interface(const Objective& objective) const {
    std::vector<int> bad;
    for (std::size_t t = 0; t < complex.tets.size(); ++t) {
        const Tet& tet = complex.tets[t];
        if (tet[0] < 0 || std::none_of(tet.begin(), tet.end(), [&](int v) { return is_at_interface(v); })) continue;
        if (objective.flaw(complex, tet) > objective.asked()) bad.push_back(static_cast<int>(t));
    }
    return bad;
}

bool InterfaceRegion::has_interface() const {
    return std::find(is_at_interface_.begin(), is_at_interface_.end(), 1) != is_at_interface_.end();
}

std::vector<int> InterfaceRegion::tets_near_interface(int edges) const {
    std::vector<int> tets;
    for (std::size_t t = 0; t < complex.tets.size(); ++t)
        if (const Tet& tet = complex.tets[t];
            tet[0] >= 0 && std::any_of(tet.begin(), tet.end(), [&](int v) { return is_at_interface(v); }))
            tets.push_back(static_cast<int>(t));
    return with_rings(std::move(tets), edges - 1);
}

std::vector<int> InterfaceRegion::with_rings(std::vector<int> tets, int rings) const {
    if (tets.empty()) return tets;
    std::vector<char> is_in(complex.points.size(), 0);
    for (int ring = 0; ring < rings; ++ring) {
        for (const int t : tets)
            for (const int v : complex.tets[t]) is_in[static_cast<std::size_t>(v)] = 1;
        tets.clear();
        for (std::size_t t = 0; t < complex.tets.size(); ++t) {
            const Tet& tet = complex.tets[t];
            if (tet[0] >= 0 && std::any_of(tet.begin(), tet.end(), [&](int v) { return is_in[v] != 0; }))
                tets.push_back(static_cast<int>(t));
        }
    }
    return tets;
}

std::vector<NodeId> InterfaceRegion::nodes_of(std::span<const int> tets) const {
    std::vector<NodeId> nodes;
    for (const int t : tets)
        for (const int v : complex.tets[t])
            if (const NodeId n = node_of(v); n.is_valid()) nodes.push_back(n);
    sort_once(nodes);
    return nodes;
}

int InterfaceRegion::add_vertex(NodeId node, const Mesh& mesh) {
    const int vertex = static_cast<int>(complex.points.size());
    complex.points.push_back(mesh.point(node));
    complex.mobility.push_back(Mobility::fixed);
    complex.tet_of_vertex.push_back(-1);
    nodes_.resize(complex.points.size());
    nodes_.back() = node;
    return vertex;
}

std::vector<int> InterfaceRegion::take_in(const Mesh& mesh, std::span<const TetId> tets) {
    std::vector<int> vertex_of(mesh.node_count(), -1), places;
    for (std::size_t v = 0; v < nodes_.size(); ++v)
        if (nodes_[v].is_valid()) vertex_of[nodes_[v].index()] = static_cast<int>(v);
    for (const TetId tet : tets) {
        const int place = static_cast<int>(complex.tets.size());
        std::array<int, 4> corners;
        for (int k = 0; k < 4; ++k) {
            const NodeId node = mesh.tets[tet.index()][k];
            int& vertex = vertex_of[node.index()];
            if (vertex < 0) vertex = add_vertex(node, mesh);
            corners[k] = vertex;
        }
        complex.tets.push_back(corners);
        complex.neighbours.push_back({-1, -1, -1, -1});
        complex.regions.push_back(mesh.tet_solids[tet.index()].value);
        taken_.push_back({tet, place, corners});
        places.push_back(place);
        for (const int v : corners) complex.tet_of_vertex[v] = place;
    }
    is_at_interface_.resize(complex.points.size(), 0);
    for (const int t : places)
        for (const int v : complex.tets[t]) is_at_interface_[static_cast<std::size_t>(v)] = 1;
    link_open_facets();
    return places;
}

void InterfaceRegion::link_open_facets() {
    struct HalfFacet {
        std::array<int, 3> corners;
        int region, tet, face;
        auto key() const { return std::tie(corners, region); }
    };
    std::vector<std::uint8_t> is_of_taken(complex.points.size(), 0);
    for (const Taken& taken : taken_)
        for (const int v : taken.corners) is_of_taken[static_cast<std::size_t>(v)] = 1;
    std::vector<HalfFacet> open;
    for (std::size_t t = 0; t < complex.tets.size(); ++t)
        for (int face = 0; complex.tets[t][0] >= 0 && face < 4; ++face) {
            if (complex.neighbours[t][face] >= 0) continue;
            const std::array<int, 3> corners = sorted_face(complex.tets[t], face);
            if (std::all_of(corners.begin(), corners.end(), [&](int v) { return is_of_taken[v] != 0; }))
                open.push_back({corners, complex.regions[t], static_cast<int>(t), face});
        }
    std::sort(open.begin(), open.end(), [](const HalfFacet& a, const HalfFacet& b) {
        return std::tie(a.corners, a.region, a.tet) < std::tie(b.corners, b.region, b.tet);
    });
    for (std::size_t i = 1; i < open.size(); ++i) {
        const HalfFacet &a = open[i - 1], &b = open[i];
        if (a.key() != b.key()) continue;
        complex.neighbours[a.tet][a.face] = b.tet;
        complex.neighbours[b.tet][b.face] = a.tet;
    }
}

void InterfaceRegion::free_inner_nodes(const Mesh& mesh) {
    std::vector<int> star;
    for (std::size_t v = 0; v < nodes_.size(); ++v) {
        if (!nodes_[v].is_valid() || mesh.entities[nodes_[v].index()].dim < 3) continue;
        if (gather_star(complex, static_cast<int>(v), star)) complex.mobility[v] = Mobility::kept;
    }
}

bool InterfaceRegion::is_moved(int vertex, const Mesh& mesh) const {
    const NodeId node = node_of(vertex);
    return node.is_valid() && complex.points[static_cast<std::size_t>(vertex)] != mesh.point(node);
}

bool InterfaceRegion::is_changed(const Taken& taken, const Mesh& mesh) const {
    return complex.tets[static_cast<std::size_t>(taken.place)] != taken.corners ||
           std::any_of(taken.corners.begin(), taken.corners.end(), [&](int v) { return is_moved(v, mesh); });
}

std::size_t InterfaceRegion::changed_count(const Mesh& mesh) const {
    return static_cast<std::size_t>(
        std::count_if(taken_.begin(), taken_.end(), [&](const Taken& taken) { return is_changed(taken, mesh); }));
}

std::vector<std::pair<NodeId, int>> InterfaceRegion::moved_nodes(const Mesh& mesh) const {
    std::vector<std::pair<NodeId, int>> moved;
    for (int v = 0; v < static_cast<int>(nodes_.size()); ++v)
        if (is_moved(v, mesh)) moved.emplace_back(nodes_[static_cast<std::size_t>(v)], v);
    return moved;
}

std::vector<TetId> InterfaceRegion::give_back(const Mesh& mesh) {
    std::vector<TetId> given;
    for (const Taken& taken : taken_) {
        if (is_changed(taken, mesh)) continue;
        complex.tets[static_cast<std::size_t>(taken.place)] = {-1, -1, -1, -1};
        given.push_back(taken.tet);
    }
    taken_.clear();
    return given;
}

std::vector<SurfaceVertex> movable_vertices(const Brep& brep, const Mesh& mesh, const InterfaceRegion& region,
                                            std::size_t kept_nodes, bool moves_kept_nodes) {
    std::vector<SurfaceVertex> vertices;
    for (int v = 0; v < static_cast<int>(region.complex.points.size()); ++v) {
        const NodeId node = region.node_of(v);
        if (!node.is_valid() || region.is_at_interface(v) || region.complex.tet_of_vertex[v] < 0) continue;
        const bool is_kept = node.index() < kept_nodes;
        if (is_kept && !moves_kept_nodes) continue;
        const Entity on = mesh.entities[node.index()];
        if (on.dim != 1 && on.dim != 2) continue;
        const std::vector<FaceId> faces = brep.faces_at(on);
        if (faces.size() <= 2 && std::all_of(faces.begin(), faces.end(), [&](FaceId f) { return is_outside(brep, f); }))
            vertices.push_back({v, on, mesh.parameters[node.index()], is_kept});
    }
    return vertices;
}

}  // namespace featuremesh
