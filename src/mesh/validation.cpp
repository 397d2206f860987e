// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/validation.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <span>

#include "core/geometry.h"
#include "core/messages.h"
#include "mesh/findings.h"
#include "mesh/second_order.h"
#include "mesh/side_table.h"
#include "mesh/tets_at_nodes.h"
#include "mesh/triangle_uses.h"

namespace featuremesh {
namespace {

constexpr std::size_t grain = 1 << 14;

Message at_node(const Mesh& mesh, NodeId n) { return say<Code::at_node>(mesh.node_numbers[n.index()], mesh.point(n)); }
Message at_tet(const Mesh& mesh, std::size_t t) {
    return say<Code::at_tet>(mesh.tet_numbers[t], at_node(mesh, mesh.tets[t][0]));
}
Message at_triangle(const Mesh& mesh, std::size_t t) {
    return say<Code::at_triangle>(mesh.triangle_numbers[t], mesh.triangle_faces[t],
                                  at_node(mesh, mesh.triangles[t][0]));
}
Message at_side(const Mesh& mesh, std::size_t t) { return say<Code::at_side>(at_triangle(mesh, t)); }
Message at_segment(const Mesh& mesh, std::size_t s) {
    return say<Code::at_segment>(mesh.segment_numbers[s], mesh.segment_edges[s], at_node(mesh, mesh.segments[s][0]));
}
Message solid_or_outside(SolidId s) { return s.is_valid() ? say<Code::of_solid>(s) : say<Code::outside>(); }

void check_size(std::size_t have, std::size_t want, const char* array, Findings& findings) {
    if (have != want) findings.add<Code::array_length_wrong>(say<Code::array_length>(array, have, want));
}

void check_array_sizes(const Mesh& mesh, Findings& findings) {
    const bool second = mesh.order == 2;
    if (mesh.order != 1 && !second) findings.add<Code::order_wrong>(say<Code::just_number>(mesh.order));
    if (mesh.corner_count > mesh.points.size() || (!second && mesh.corner_count != mesh.points.size()))
        findings.add<Code::corner_count_wrong>(say<Code::so_many_of>(mesh.corner_count, mesh.points.size()));
    check_size(mesh.entities.size(), mesh.points.size(), "entities", findings);
    check_size(mesh.parameters.size(), mesh.points.size(), "parameters", findings);
    check_size(mesh.node_numbers.size(), mesh.points.size(), "node_numbers", findings);
    check_size(mesh.segment_mids.size(), second ? mesh.segments.size() : 0, "segment_mids", findings);
    check_size(mesh.segment_edges.size(), mesh.segments.size(), "segment_edges", findings);
    check_size(mesh.segment_numbers.size(), mesh.segments.size(), "segment_numbers", findings);
    check_size(mesh.triangle_mids.size(), second ? mesh.triangles.size() : 0, "triangle_mids", findings);
    check_size(mesh.triangle_faces.size(), mesh.triangles.size(), "triangle_faces", findings);
    check_size(mesh.triangle_numbers.size(), mesh.triangles.size(), "triangle_numbers", findings);
    check_size(mesh.tet_mids.size(), second ? mesh.tets.size() : 0, "tet_mids", findings);
    check_size(mesh.tet_solids.size(), mesh.tets.size(), "tet_solids", findings);
    check_size(mesh.tet_numbers.size(), mesh.tets.size(), "tet_numbers", findings);
}

template <std::size_t count>
void check_nodes(const std::vector<std::array<NodeId, count>>& elements, std::size_t begin, std::size_t end,
                 const char* array, Findings& findings) {
    const auto first = static_cast<std::uint32_t>(begin), places = static_cast<std::uint32_t>(end - begin);
    bool is_within = true;
    for (const auto& element : elements)
        for (const NodeId n : element) is_within &= static_cast<std::uint32_t>(n.value) - first < places;
    if (is_within) return;  // the common case, looked at many at a time
    for (std::size_t i = 0; i < elements.size(); ++i)
        for (NodeId n : elements[i])
            if (n.value < 0 || n.index() < begin || n.index() >= end)
                findings.add<Code::node_out_of_range>(say<Code::array_entry>(array, n.value, i));
}

template <class Id>
void check_owners(const std::vector<Id>& owners, std::size_t count, const char* array, Findings& findings) {
    for (std::size_t i = 0; i < owners.size(); ++i)
        if (owners[i].value < 0 || (count > 0 && owners[i].index() >= count))
            findings.add<Code::entity_out_of_range>(say<Code::array_entry>(array, owners[i].value, i));
}

/// Checks the entity of every node. The numbers of vertices and edges are not known here (0), so only faces and solids
/// are checked against an upper bound.
void check_entities(const Mesh& mesh, const Expectation& expected, Findings& findings) {
    const std::array<std::size_t, 4> counts{0, 0, expected.solids_beside_face.size(), expected.solid_volumes.size()};
    for (std::size_t n = 0; n < mesh.entities.size(); ++n) {
        const auto [dim, index] = mesh.entities[n];
        const std::size_t count = dim >= 0 && dim <= 3 ? counts[static_cast<std::size_t>(dim)] : 0;
        if (dim < 0 || dim > 3 || index < 0 || (count > 0 && static_cast<std::size_t>(index) >= count))
            findings.add<Code::entity_out_of_range>(say<Code::array_entry>("entities", index, n));
    }
}

void check_ranges(const Mesh& mesh, const Expectation& expected, Findings& findings) {
    const std::size_t corners = mesh.corner_count, nodes = mesh.points.size();
    check_nodes(mesh.segments, 0, corners, "segments", findings);
    check_nodes(mesh.triangles, 0, corners, "triangles", findings);
    check_nodes(mesh.tets, 0, corners, "tets", findings);
    check_nodes(mesh.triangle_mids, corners, nodes, "triangle_mids", findings);
    check_nodes(mesh.tet_mids, corners, nodes, "tet_mids", findings);
    for (std::size_t i = 0; i < mesh.segment_mids.size(); ++i)
        if (mesh.segment_mids[i].value < 0 || mesh.segment_mids[i].index() < corners ||
            mesh.segment_mids[i].index() >= nodes)
            findings.add<Code::node_out_of_range>(
                say<Code::array_entry>("segment_mids", mesh.segment_mids[i].value, i));
    check_owners(mesh.segment_edges, 0, "segment_edges", findings);
    check_owners(mesh.triangle_faces, expected.solids_beside_face.size(), "triangle_faces", findings);
    check_owners(mesh.tet_solids, expected.solid_volumes.size(), "tet_solids", findings);
    check_entities(mesh, expected, findings);
    for (std::size_t i = 0; i < nodes; ++i)
        if (!std::isfinite(mesh.points[i].x + mesh.points[i].y + mesh.points[i].z))
            findings.add<Code::coordinate_not_finite>(say<Code::just_number>(mesh.node_numbers[i]));
}

/// Every number once, positive, and below the next one to be given.
template <Code twice, Code outside>
void check_numbers(std::initializer_list<std::span<const Number>> lists, Number next, Findings& findings) {
    Number low = next, high = 0;
    std::size_t count = 0;
    for (const auto& list : lists) {
        count += list.size();
        for (const Number n : list) low = std::min(low, n), high = std::max(high, n);
    }
    if (count == 0) return;
    if (low < 1 || high >= next) {
        findings.add<outside>(say<Code::number_range>(low, high, next));
        return;
    }
    constexpr Number sparse = 64;  // a bit for each number between takes less than the numbers themselves
    if (high - low < sparse * static_cast<Number>(count)) {
        std::vector<std::uint64_t> is_taken(static_cast<std::size_t>(high - low) / 64 + 1, 0);
        for (const auto& list : lists)
            for (const Number n : list) {
                const auto place = static_cast<std::uint64_t>(n - low);
                const std::uint64_t bit = std::uint64_t{1} << (place % 64);
                if (is_taken[place / 64] & bit) findings.add<twice>(say<Code::just_number>(n));
                is_taken[place / 64] |= bit;
            }
        return;
    }
    std::vector<Number> all;
    all.reserve(count);
    for (const auto& list : lists) all.insert(all.end(), list.begin(), list.end());
    std::sort(all.begin(), all.end());
    for (std::size_t i = 1; i < count; ++i)
        if (all[i] == all[i - 1]) findings.add<twice>(say<Code::just_number>(all[i]));
}

/// Whether all of the nodes are as they were in a valid mesh, with the same elements around them.
template <std::size_t count>
bool are_proven(const Expectation& expected, const std::array<NodeId, count>& nodes) {
    return !expected.is_unproven.empty() &&
           std::none_of(nodes.begin(), nodes.end(), [&](NodeId n) { return expected.is_unproven[n.index()] != 0; });
}

/// Of the element as it is curved: the mean of the Bernstein coefficients is the mean of det J.
double volume_of(const Mesh& mesh, std::size_t t, double straight) {
    if (mesh.order == 1 || !has_curved_side(mesh, TetId(t))) return straight;
    const auto coefficients = jacobian_coefficients(tet_nodes(mesh, TetId(t)));
    return std::accumulate(coefficients.begin(), coefficients.end(), 0.0) / 120;
}

bool is_flat(const Mesh& mesh, const std::array<NodeId, 4>& n, double& six_volume) {
    const Vec3 &a = mesh.point(n[0]), u = mesh.point(n[1]) - a, v = mesh.point(n[2]) - a, w = mesh.point(n[3]) - a;
    six_volume = dot(cross(u, v), w);
    const double squares = squared_length(u) * squared_length(v) * squared_length(w);
    // flat: the height is a millionth of the other lengths, far below what any wedge of a part forces
    return !(six_volume > 0) || six_volume * six_volume < 1e-12 * squares;
}

void check_volumes(const std::vector<double>& volumes, const Expectation& expected, Findings& findings) {
    for (std::size_t s = 0; s < volumes.size(); ++s) {
        const double wanted = expected.solid_volumes[s];
        if (std::abs(volumes[s] - wanted) > expected.volume_tolerance * std::abs(wanted))
            findings.add<Code::volume_wrong>(
                say<Code::volume_of_elements>(SolidId(s), Volume{volumes[s]}, Volume{wanted}));
    }
}

void check_tets(const Mesh& mesh, const Expectation& expected, RunContext& context, Findings& findings) {
    const std::size_t chunks = (mesh.tets.size() + grain - 1) / grain, solids = expected.solid_volumes.size();
    std::vector<Findings> parts(chunks);
    std::vector<double> by_chunk(chunks * solids, 0.0);
    parallel_for(context, mesh.tets.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            double six_volume = 0;
            if (is_flat(mesh, mesh.tets[t], six_volume))
                parts[begin / grain].add<Code::tet_without_volume>(at_tet(mesh, t));
            if (solids > 0)
                by_chunk[begin / grain * solids + mesh.tet_solids[t].index()] += volume_of(mesh, t, six_volume / 6);
        }
    });
    for (const Findings& part : parts) findings.add(part);
    std::vector<double> volumes(solids, 0.0);
    for (std::size_t i = 0; i < by_chunk.size(); ++i) volumes[i % solids] += by_chunk[i];
    check_volumes(volumes, expected, findings);
}

/// Between the triangle as it is curved and the apex, positive where the normal points away from it: exact, since the
/// points of the rule are enough for a polynomial of degree 4. [Dunavant1985]
double volume_over(const Mesh& mesh, std::size_t t, const Vec3& apex) {
    const auto& n = mesh.triangles[t];
    const Vec3 a = mesh.point(n[0]) - apex, b = mesh.point(n[1]) - apex, c = mesh.point(n[2]) - apex;
    const double straight = dot(a, cross(b, c)) / 6;
    if (mesh.order == 1) return straight;
    const auto bend = [&](int s) {  // four times the way of the mid-side node off the middle
        return 4.0 * (mesh.point(mesh.triangle_mids[t][s]) - 0.5 * (mesh.point(n[s]) + mesh.point(n[(s + 1) % 3])));
    };
    const Vec3 ab = bend(0), bc = bend(1), ca = bend(2);
    const double bent = squared_length(ab) + squared_length(bc) + squared_length(ca);
    if (bent <= 1e-20 * (squared_length(b - a) + squared_length(c - a))) return straight;
    double sum = 0;
    for (const auto& [weight, share] :
         {std::pair{0.223381589678011, 0.445948490915965}, {0.109951743655322, 0.091576213509771}})
        for (int corner = 0; corner < 3; ++corner) {
            std::array<double, 3> l{share, share, share};
            l[static_cast<std::size_t>(corner)] = 1 - 2 * share;
            const Vec3 at = l[0] * a + l[1] * b + l[2] * c + l[0] * l[1] * ab + l[1] * l[2] * bc + l[2] * l[0] * ca;
            const Vec3 u = b - a + (l[0] - l[1]) * ab + l[2] * bc - l[2] * ca,
                       v = c - a - l[1] * ab + l[1] * bc + (l[0] - l[2]) * ca;
            sum += weight * dot(at, cross(u, v));
        }
    return sum / 6;
}

/// Only `near`, of which a node is unproven. The volume is what the triangles around each solid enclose: where every
/// facet of a tet has a tet or a triangle beyond it, which is checked besides, that is the sum of the tets.
void check_unproven_tets(const Mesh& mesh, const Expectation& expected, std::span<const TetId> near,
                         RunContext& context, Findings& findings) {
    std::vector<Findings> parts((near.size() + grain - 1) / grain);
    parallel_for(context, near.size(), grain, [&](std::size_t begin, std::size_t end) {
        double six_volume = 0;
        for (const TetId t : near.subspan(begin, end - begin))
            if (is_flat(mesh, mesh.tets[t.index()], six_volume))
                parts[begin / grain].add<Code::tet_without_volume>(at_tet(mesh, t.index()));
    });
    for (const Findings& part : parts) findings.add(part);
    if (expected.solid_volumes.empty() || expected.solids_beside_face.empty()) return;
    const Vec3 apex = mesh.points.front();
    std::vector<double> volumes(expected.solid_volumes.size(), 0.0);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const double share = volume_over(mesh, t, apex);
        const auto& solids = expected.solids_beside_face[mesh.triangle_faces[t].index()];
        if (solids[0].is_valid()) volumes[solids[0].index()] += share;
        if (solids[1].is_valid()) volumes[solids[1].index()] -= share;
    }
    check_volumes(volumes, expected, findings);
}

/// The tets (behind and before) at one surface triangle, against the solids beside its face.
void check_solids_beside(const Mesh& mesh, const Expectation& expected, std::span<const TriangleUse> tets,
                         const TriangleUse& triangle, Findings& findings) {
    std::array<SolidId, 2> solids;
    for (const TriangleUse& tet : tets)
        solids[tet.is_forward() == triangle.is_forward() ? 0 : 1] = mesh.tet_solids[tet.element()];
    const auto& wanted = expected.solids_beside_face[mesh.triangle_faces[triangle.element()].index()];
    for (int i = 0; i < 2; ++i)
        if (solids[i] != wanted[i]) {
            const Message place = at_triangle(mesh, triangle.element()), is = solid_or_outside(solids[i]),
                          should_be = solid_or_outside(wanted[i]);
            findings.add<Code::solid_at_triangle_wrong>(i == 0 ? say<Code::solid_behind>(place, is, should_be)
                                                               : say<Code::solid_before>(place, is, should_be));
        }
}

bool is_free(const Expectation& expected, FaceId face) {
    return expected.dimension == Dimension::faces ||
           (!expected.is_free_face.empty() && expected.is_free_face[face.index()] != 0);
}
bool is_free(const Expectation& expected, EdgeId edge) {
    return expected.dimension == Dimension::edges ||
           (!expected.is_free_edge.empty() && expected.is_free_edge[edge.index()] != 0);
}

void check_triangle(const Mesh& mesh, const Expectation& expected, std::span<const TriangleUse> uses,
                    Findings& findings) {
    const auto first_triangle =
        std::find_if(uses.begin(), uses.end(), [](const TriangleUse& use) { return !use.is_tet(); });
    const std::span<const TriangleUse> tets(uses.begin(), first_triangle), triangles(first_triangle, uses.end());
    if (tets.size() > 2) findings.add<Code::triangle_of_more_than_two>(at_tet(mesh, tets[0].element()));
    if (tets.size() == 2 && tets[0].is_forward() == tets[1].is_forward())
        findings.add<Code::tets_overlap>(
            say<Code::both>(at_tet(mesh, tets[0].element()), at_tet(mesh, tets[1].element())));
    if (triangles.size() > 1) findings.add<Code::triangle_twice>(at_triangle(mesh, triangles[0].element()));
    if (triangles.empty()) {
        if (tets.size() == 1)
            findings.add<Code::boundary_without_triangle>(at_tet(mesh, tets[0].element()));
        else if (mesh.tet_solids[tets[0].element()] != mesh.tet_solids[tets[1].element()])
            findings.add<Code::border_without_triangle>(at_tet(mesh, tets[0].element()));
    } else if (tets.empty()) {
        if (!is_free(expected, mesh.triangle_faces[triangles[0].element()]))
            findings.add<Code::triangle_without_tet>(at_triangle(mesh, triangles[0].element()));
    } else if (!expected.solids_beside_face.empty() && tets.size() <= 2) {
        check_solids_beside(mesh, expected, tets, triangles[0], findings);
    }
}

void check_triangles_against_tets(const Mesh& mesh, const Expectation& expected, std::span<const TetId> near,
                                  RunContext& context, Findings& findings) {
    TriangleUses uses(mesh, expected.is_unproven, near, context);
    std::vector<Findings> parts((uses.bucket_count() + grain - 1) / grain);
    parallel_for(context, uses.bucket_count(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t smallest = begin; smallest < end; ++smallest)
            uses.visit_bucket(smallest, [&](std::span<const TriangleUse> triangle) {
                const bool inner = triangle.size() == 2 && triangle[1].is_tet() &&
                                   triangle[0].is_forward() != triangle[1].is_forward() &&
                                   mesh.tet_solids[triangle[0].element()] == mesh.tet_solids[triangle[1].element()];
                if (!inner) check_triangle(mesh, expected, triangle, parts[begin / grain]);
            });
    });
    for (const Findings& part : parts) findings.add(part);
}

/// For a surface without tets: the triangles around each solid leave no gap.
void check_closed_surface(const Mesh& mesh, const Expectation& expected, Findings& findings) {
    SolidId last{0};
    for (const auto& solids : expected.solids_beside_face) last = std::max({last, solids[0], solids[1]});
    for (SolidId solid{0}; solid <= last; ++solid.value) {
        SideTable balance(mesh.corner_count);
        for (const bool report : {false, true})
            for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
                for (int place = 0; place < 2; ++place) {
                    if (!expected.solids_beside_face.empty() &&
                        expected.solids_beside_face[mesh.triangle_faces[t].index()][place] != solid)
                        continue;
                    if (expected.solids_beside_face.empty() && place == 1) continue;
                    for (int s = 0; s < 3; ++s) {
                        const NodeId a = mesh.triangles[t][s], b = mesh.triangles[t][(s + 1) % 3];
                        std::int32_t& count = balance.value(a, b);
                        // -1 stands for a side seen for the first time: sums are kept shifted by a large even number
                        constexpr std::int32_t zero = 1 << 20;
                        if (!report)
                            count = (count < 0 ? zero : count) + (expected.solids_beside_face.empty() ? 1
                                                                  : (a < b) == (place == 0)           ? 1
                                                                                                      : -1);
                        else if (expected.solids_beside_face.empty() ? count < zero + 2 : count != zero)
                            findings.add<Code::surface_open>(say<Code::around_solid>(solid, at_side(mesh, t)));
                    }
                }
    }
}

/// The side of a triangle of one face.
struct SideUse {
    std::int32_t low, high, face;
    bool is_forward;
    std::size_t triangle;
    auto operator<=>(const SideUse&) const = default;
    bool is_beside(const SideUse& b) const { return low == b.low && high == b.high && face == b.face; }
};

std::vector<SideUse> sorted_sides(const Mesh& mesh, const std::vector<std::size_t>& triangles) {
    std::vector<SideUse> uses;
    for (const std::size_t t : triangles)
        for (std::size_t s = 0; s < 3; ++s) {
            const NodeId a = mesh.triangles[t][s], b = mesh.triangles[t][(s + 1) % 3];
            uses.push_back({std::min(a, b).value, std::max(a, b).value, mesh.triangle_faces[t].value, a < b, t});
        }
    std::sort(uses.begin(), uses.end());
    return uses;
}

/// Where faces are meshed for themselves: the triangles of each are all there, up to the segments of its edges.
void check_faces(const Mesh& mesh, const Expectation& expected, Findings& findings) {
    std::vector<std::size_t> shells;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        if (is_free(expected, mesh.triangle_faces[t])) shells.push_back(t);
    if (shells.empty()) return;
    SideTable segments(mesh.corner_count);
    for (const auto& [a, b] : mesh.segments) segments.value(a, b) = 1;
    const std::vector<SideUse> uses = sorted_sides(mesh, shells);
    for (std::size_t i = 0, next; i < uses.size(); i = next) {
        for (next = i + 1; next < uses.size() && uses[next].is_beside(uses[i]);) ++next;
        const bool is_pair = next == i + 2 && uses[i].is_forward != uses[i + 1].is_forward;
        const bool is_free = next == i + 1;
        if (!is_pair && !is_free) findings.add<Code::triangles_overlap>(at_side(mesh, uses[i].triangle));
        if (is_free && segments.find(NodeId(uses[i].low), NodeId(uses[i].high)) < 0)
            findings.add<Code::gap_in_face>(at_side(mesh, uses[i].triangle));
    }
    for (const std::size_t t : shells) {
        const auto& [a, b, c] = mesh.triangles[t];
        const Vec3 u = mesh.point(b) - mesh.point(a), v = mesh.point(c) - mesh.point(a);
        if (!(squared_length(cross(u, v)) > 1e-24 * squared_length(u) * squared_length(v)))
            findings.add<Code::triangle_without_area>(at_triangle(mesh, t));
        if (mesh.order == 2 && !(min_scaled_jacobian(triangle_nodes(mesh, TriangleId(t))) > 0))
            findings.add<Code::triangle_folded>(at_triangle(mesh, t));
    }
}

/// Where edges are meshed for themselves: each is a chain of segments; of a mesh of edges nothing else is there.
void check_edges(const Mesh& mesh, const Expectation& expected, Findings& findings) {
    std::vector<std::size_t> beams;
    for (std::size_t s = 0; s < mesh.segments.size(); ++s)
        if (is_free(expected, mesh.segment_edges[s])) beams.push_back(s);
    const bool has_edges_only = expected.dimension == Dimension::edges;
    if (beams.empty() && !has_edges_only) return;
    std::vector<int> ends(mesh.corner_count, 0);
    for (const std::size_t s : beams)
        for (const NodeId n : mesh.segments[s]) ++ends[n.index()];
    const auto is_of_beam = [&](const Entity& e) { return e.dim == 1 && is_free(expected, EdgeId(e.index)); };
    for (std::size_t n = 0; n < mesh.corner_count; ++n)
        if (is_of_beam(mesh.entities[n]) ? ends[n] != 2 : has_edges_only && ends[n] == 0)
            findings.add<Code::gap_in_edge>(at_node(mesh, NodeId(n)));
    if (has_edges_only && !mesh.triangles.empty()) findings.add<Code::triangle_among_edges>(at_triangle(mesh, 0));
    for (const std::size_t s : beams) {
        const auto& [a, b] = mesh.segments[s];
        if (!(distance(mesh.point(a), mesh.point(b)) > 0))
            findings.add<Code::segment_without_length>(at_segment(mesh, s));
    }
}

void check_segments(const Mesh& mesh, const Expectation& expected, Findings& findings) {
    SideTable sides(mesh.corner_count);
    for (std::size_t i = 0; i < mesh.segments.size(); ++i) {
        if (are_proven(expected, mesh.segments[i])) continue;
        std::int32_t& seen = sides.value(mesh.segments[i][0], mesh.segments[i][1]);
        if (seen >= 0) findings.add<Code::segment_twice>(at_segment(mesh, i));
        seen = 0;
    }
    if (expected.dimension == Dimension::edges) return;
    for (const auto& triangle : mesh.triangles) {
        if (are_proven(expected, triangle)) continue;
        for (int s = 0; s < 3; ++s)
            if (sides.find(triangle[s], triangle[(s + 1) % 3]) == 0)
                sides.value(triangle[s], triangle[(s + 1) % 3]) = 1;
    }
    for (std::size_t i = 0; i < mesh.segments.size(); ++i)
        if (!are_proven(expected, mesh.segments[i]) && !is_free(expected, mesh.segment_edges[i]) &&
            sides.find(mesh.segments[i][0], mesh.segments[i][1]) != 1)
            findings.add<Code::segment_beside_triangles>(at_segment(mesh, i));
}

/// Of the elements with an unproven node: all tets at a side with such an end are among them.
void check_mid_side_nodes(const Mesh& mesh, const Expectation& expected, std::span<const TetId> near,
                          const RunContext& context, Findings& findings) {
    RoundWatch watch(context);
    SideTable sides(mesh.corner_count);
    std::vector<bool> is_taken(mesh.points.size(), false);
    const auto check = [&](NodeId a, NodeId b, NodeId mid) {
        std::int32_t& known = sides.value(a, b);
        if (known == mid.value) return;
        if (known >= 0) {
            findings.add<Code::two_mid_side_nodes>(say<Code::both>(at_node(mesh, mid), at_node(mesh, NodeId(known))));
            return;
        }
        known = mid.value;
        if (is_taken[mid.index()]) findings.add<Code::mid_side_node_of_two>(at_node(mesh, mid));
        is_taken[mid.index()] = true;
    };
    for (const TetId tet : near) {
        watch();
        const std::size_t i = tet.index();
        for (int s = 0; s < 6; ++s)
            check(mesh.tets[i][tet_sides[s][0]], mesh.tets[i][tet_sides[s][1]], mesh.tet_mids[i][s]);
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (are_proven(expected, mesh.triangles[i])) continue;
        for (int s = 0; s < 3; ++s)
            check(mesh.triangles[i][s], mesh.triangles[i][(s + 1) % 3], mesh.triangle_mids[i][s]);
    }
    for (std::size_t i = 0; i < mesh.segments.size(); ++i)
        if (!are_proven(expected, mesh.segments[i]))
            check(mesh.segments[i][0], mesh.segments[i][1], mesh.segment_mids[i]);
}

void check_jacobians(const Mesh& mesh, std::span<const TetId> near, RunContext& context, Findings& findings) {
    std::vector<Findings> parts((near.size() + grain - 1) / grain);
    parallel_for(context, near.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (const TetId t : near.subspan(begin, end - begin)) {
            if (!has_curved_side(mesh, t)) continue;
            const auto nodes = tet_nodes(mesh, t);
            const auto coefficients = jacobian_coefficients(nodes);
            if (*std::min_element(coefficients.begin(), coefficients.end()) > 0) continue;
            if (!(min_scaled_jacobian(nodes) > 0))
                parts[begin / grain].add<Code::jacobian_not_positive>(at_tet(mesh, t.index()));
        }
    });
    for (const Findings& part : parts) findings.add(part);
}

}  // namespace

std::vector<Message> broken_invariants(const Mesh& mesh, const Expectation& expected, RunContext& context) {
    Findings findings;
    check_array_sizes(mesh, findings);
    if (findings.empty()) check_ranges(mesh, expected, findings);
    if (!findings.empty()) return findings.messages();
    check_numbers<Code::node_number_twice, Code::node_number_out_of_range>({mesh.node_numbers}, mesh.next_node_number,
                                                                           findings);
    check_numbers<Code::element_number_twice, Code::element_number_out_of_range>(
        {mesh.segment_numbers, mesh.triangle_numbers, mesh.tet_numbers}, mesh.next_element_number, findings);
    context.check_cancelled();
    std::vector<TetId> near = expected.unproven_tets;
    if (!expected.is_unproven.empty() && near.empty()) near = tets_at_nodes(mesh, expected.is_unproven);
    if (!expected.is_unproven.empty())
        check_unproven_tets(mesh, expected, near, context, findings);
    else
        check_tets(mesh, expected, context, findings);
    check_faces(mesh, expected, findings);
    check_edges(mesh, expected, findings);
    if (expected.dimension == Dimension::solids && mesh.tets.empty())
        check_closed_surface(mesh, expected, findings);
    else if (expected.dimension == Dimension::solids)
        check_triangles_against_tets(mesh, expected, near, context, findings);
    check_segments(mesh, expected, findings);
    if (mesh.order == 2) {
        if (expected.is_unproven.empty()) {
            near.resize(mesh.tets.size());
            std::generate(near.begin(), near.end(), [t = TetId{0}]() mutable { return TetId(t.value++); });
        }
        check_mid_side_nodes(mesh, expected, near, context, findings);
        check_jacobians(mesh, near, context, findings);
    }
    return findings.messages();
}

std::vector<Message> broken_invariants(const Mesh& mesh, const Expectation& expected) {
    RunContext context;
    return broken_invariants(mesh, expected, context);
}

}  // namespace featuremesh
