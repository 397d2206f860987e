// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstring>
#include <span>

#include "bindings.h"
#include "core/errors.h"
#include "core/messages.h"
#include "difference/face_owners.h"
#include "update/feature_groups.h"

namespace featuremesh {

namespace {

static_assert(sizeof(Vec3) == 3 * sizeof(double) && sizeof(Entity) == 8 && sizeof(NodeId) == 4 &&
                  sizeof(SharedNode) == 12,
              "arrays are handed over as they lie");

/// A read-only view of a vector of small fixed-size rows of `Scalar`; `owner` keeps it alive.
template <class Scalar, class Row>
py::array view(const std::vector<Row>& rows, const py::object& owner) {
    constexpr std::size_t width = sizeof(Row) / sizeof(Scalar);
    const auto* data = reinterpret_cast<const Scalar*>(rows.data());
    py::array array = width == 1 ? py::array(py::dtype::of<Scalar>(), {rows.size()}, {sizeof(Scalar)}, data, owner)
                                 : py::array(py::dtype::of<Scalar>(), {rows.size(), width},
                                             {sizeof(Row), sizeof(Scalar)}, data, owner);
    array.attr("setflags")(py::arg("write") = false);
    return array;
}

template <class Scalar, class Row>
void read(const py::dict& arrays, const char* name, std::vector<Row>& rows) {
    constexpr std::size_t width = sizeof(Row) / sizeof(Scalar);
    if (!arrays.contains(name))
        throw StateError(say<Code::damaged_state>(std::string("The saved mesh has no array '") + name + "'."));
    const auto array = py::array_t<Scalar, py::array::c_style | py::array::forcecast>::ensure(arrays[name]);
    if (!array)
        throw StateError(say<Code::damaged_state>(std::string("The saved array '") + name + "' is not numeric."));
    if (!has_values_of(array, arrays[name]))
        throw StateError(say<Code::damaged_state>(std::string("The saved array '") + name +
                                                  "' has numbers that are not whole, or too large."));
    const bool fits = array.size() == 0 ||
                      (width == 1 ? array.ndim() == 1 : array.ndim() == 2 && std::size_t(array.shape(1)) == width);
    if (!fits)
        throw StateError(say<Code::damaged_state>(std::string("The saved array '") + name + "' has the wrong shape."));
    rows.resize(std::size_t(array.size()) / width);
    std::memcpy(static_cast<void*>(rows.data()), array.data(), rows.size() * sizeof(Row));
}

template <class Scalar>
Scalar read_one(const py::dict& arrays, const char* name) {
    std::vector<Scalar> values;
    read<Scalar>(arrays, name, values);
    if (values.size() != 1)
        throw StateError(say<Code::damaged_state>(std::string("The saved array '") + name + "' has the wrong shape."));
    return values.front();
}

template <class Nodes>
void check_nodes(const Nodes& row, std::size_t nodes) {
    for (const NodeId n : row)
        if (!n.is_valid() || n.index() >= nodes)
            throw StateError(say<Code::damaged_state>("The saved mesh refers to nodes that it does not have."));
}
template <std::size_t N>
void check_nodes(const std::vector<std::array<NodeId, N>>& rows, std::size_t nodes) {
    for (const auto& row : rows) check_nodes(row, nodes);
}

void require_lengths(bool are_lengths) {
    if (!are_lengths) throw StateError(say<Code::damaged_state>("The saved mesh has lengths that are none."));
}

bool is_length(double x) { return std::isfinite(x) && x >= 0; }
bool is_finite(const Vec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

void check_places(const Mesh& mesh) {
    const auto are_finite = [](const auto& uv) { return std::isfinite(uv[0]) && std::isfinite(uv[1]); };
    if (!std::all_of(mesh.points.begin(), mesh.points.end(), is_finite) ||
        !std::all_of(mesh.parameters.begin(), mesh.parameters.end(), are_finite))
        throw StateError(say<Code::damaged_state>("The saved mesh has coordinates that are no numbers."));
}

void check_sizes(const Mesh& mesh) {
    const std::size_t n = mesh.points.size();
    const std::size_t mids = mesh.order == 2 ? 1 : 0;
    if (mesh.corner_count > n || mesh.entities.size() != n || mesh.parameters.size() != n ||
        mesh.node_numbers.size() != n || mesh.segment_edges.size() != mesh.segments.size() ||
        mesh.triangle_faces.size() != mesh.triangles.size() || mesh.tet_solids.size() != mesh.tets.size() ||
        mesh.segment_numbers.size() != mesh.segments.size() || mesh.triangle_numbers.size() != mesh.triangles.size() ||
        mesh.tet_numbers.size() != mesh.tets.size() || mesh.segment_mids.size() != mids * mesh.segments.size() ||
        mesh.triangle_mids.size() != mids * mesh.triangles.size() || mesh.tet_mids.size() != mids * mesh.tets.size())
        throw StateError(say<Code::damaged_state>("The saved mesh is cut short: its arrays do not fit together."));
    const std::size_t corners = mesh.corner_count;
    check_nodes(mesh.segments, corners), check_nodes(mesh.triangles, corners), check_nodes(mesh.tets, corners);
    check_nodes(mesh.segment_mids, n), check_nodes(mesh.triangle_mids, n), check_nodes(mesh.tet_mids, n);
    check_places(mesh);
}

py::array_t<double> wanted_sizes(const PartMesh& part,
                                 const py::array_t<double, py::array::c_style | py::array::forcecast>& points) {
    if (points.ndim() != 2 || points.shape(1) != 3)
        throw InputError(say<Code::wrong_call>("Points are an array of shape (n,3)."));
    py::array_t<double> sizes(points.shape(0));
    const std::span<const double> at(points.data(), std::size_t(points.size()));
    const std::span<double> size(sizes.mutable_data(), std::size_t(sizes.size()));
    run_released({}, 1, [&](RunContext&) {
        for (std::size_t i = 0; i < size.size(); ++i)
            size[i] = part.sizing.at({at[3 * i], at[3 * i + 1], at[3 * i + 2]});
    });
    return sizes;
}

std::vector<std::vector<std::string>> owners_of_each_face(const PartMesh& part) {
    return run_released({}, 1, [&](RunContext&) { return names_of_owners(part.part); });
}

std::vector<std::vector<std::string>> labels_of_owners_in_mesh(const PartMesh& part,
                                                               const std::vector<std::string>& names) {
    const std::vector<Entity> entities = entities_from(names);
    return run_released({}, 1, [&](RunContext&) { return labels_of_owners(part.part, entities); });
}

py::list tets_of_each_feature(const PartMesh& part) {
    const auto groups = run_released({}, 1, [&](RunContext& context) { return tets_of_features(part, context); });
    py::list out;
    for (const auto& [name, tets] : groups) {
        py::array_t<Number> numbers(tets.size());
        for (std::size_t i = 0; i < tets.size(); ++i) numbers.mutable_at(i) = part.mesh.tet_numbers[tets[i].index()];
        out.append(py::make_tuple(name, numbers));
    }
    return out;
}

static_assert(sizeof(SizeSource) == 4 * sizeof(double), "arrays are handed over as they lie");

py::dict arrays_of_part(const py::object& self) {
    const auto& part = self.cast<const PartMesh&>();
    py::dict arrays = arrays_of(part.mesh, self);
    arrays["made_for_nodes"] = view<std::int32_t>(part.made_for.nodes, self);
    arrays["made_for_sizes"] = view<double>(part.made_for.sizes, self);
    arrays["adopted_sizes"] = view<double>(part.adopted_sizes, self);
    arrays["refined_narrow_faces"] = py::array_t<bool>(1, &part.options.sizing.refines_narrow_faces);
    arrays["ignored_below"] = py::array_t<double>(1, &part.options.ignored_below);
    arrays["shared_nodes"] = view<std::int32_t>(part.shared_nodes, self);
    return arrays;
}

}  // namespace

py::dict arrays_of(const Mesh& mesh, const py::object& owner) {
    py::dict arrays;
    arrays["points"] = view<double>(mesh.points, owner);
    arrays["entities"] = view<std::int32_t>(mesh.entities, owner);
    arrays["parameters"] = view<double>(mesh.parameters, owner);
    arrays["node_numbers"] = view<Number>(mesh.node_numbers, owner);
    arrays["segments"] = view<std::int32_t>(mesh.segments, owner);
    arrays["segment_mids"] = view<std::int32_t>(mesh.segment_mids, owner);
    arrays["segment_edges"] = view<std::int32_t>(mesh.segment_edges, owner);
    arrays["segment_numbers"] = view<Number>(mesh.segment_numbers, owner);
    arrays["triangles"] = view<std::int32_t>(mesh.triangles, owner);
    arrays["triangle_mids"] = view<std::int32_t>(mesh.triangle_mids, owner);
    arrays["triangle_faces"] = view<std::int32_t>(mesh.triangle_faces, owner);
    arrays["triangle_numbers"] = view<Number>(mesh.triangle_numbers, owner);
    arrays["tets"] = view<std::int32_t>(mesh.tets, owner);
    arrays["tet_mids"] = view<std::int32_t>(mesh.tet_mids, owner);
    arrays["tet_solids"] = view<std::int32_t>(mesh.tet_solids, owner);
    arrays["tet_numbers"] = view<Number>(mesh.tet_numbers, owner);
    py::array_t<Number> counters(4);
    counters.mutable_at(0) = mesh.order;
    counters.mutable_at(1) = Number(mesh.corner_count);
    counters.mutable_at(2) = mesh.next_node_number;
    counters.mutable_at(3) = mesh.next_element_number;
    arrays["counters"] = counters;
    return arrays;
}

Mesh mesh_from(const py::dict& arrays) {
    Mesh mesh;
    std::vector<Number> counters;
    read<Number>(arrays, "counters", counters);
    if (counters.size() != 4 || (counters[0] != 1 && counters[0] != 2) || counters[1] < 0)
        throw StateError(say<Code::damaged_state>("The saved mesh has damaged counters."));
    mesh.order = int(counters[0]);
    mesh.corner_count = std::size_t(counters[1]);
    mesh.next_node_number = counters[2];
    mesh.next_element_number = counters[3];
    read<double>(arrays, "points", mesh.points);
    read<std::int32_t>(arrays, "entities", mesh.entities);
    read<double>(arrays, "parameters", mesh.parameters);
    read<Number>(arrays, "node_numbers", mesh.node_numbers);
    read<std::int32_t>(arrays, "segments", mesh.segments);
    read<std::int32_t>(arrays, "segment_mids", mesh.segment_mids);
    read<std::int32_t>(arrays, "segment_edges", mesh.segment_edges);
    read<Number>(arrays, "segment_numbers", mesh.segment_numbers);
    read<std::int32_t>(arrays, "triangles", mesh.triangles);
    read<std::int32_t>(arrays, "triangle_mids", mesh.triangle_mids);
    read<std::int32_t>(arrays, "triangle_faces", mesh.triangle_faces);
    read<Number>(arrays, "triangle_numbers", mesh.triangle_numbers);
    read<std::int32_t>(arrays, "tets", mesh.tets);
    read<std::int32_t>(arrays, "tet_mids", mesh.tet_mids);
    read<std::int32_t>(arrays, "tet_solids", mesh.tet_solids);
    read<Number>(arrays, "tet_numbers", mesh.tet_numbers);
    check_sizes(mesh);
    return mesh;
}

MadeFor made_for_from(const py::dict& arrays) {
    MadeFor made_for;
    read<std::int32_t>(arrays, "made_for_nodes", made_for.nodes);
    read<double>(arrays, "made_for_sizes", made_for.sizes);
    if (made_for.nodes.size() != made_for.sizes.size())
        throw StateError(say<Code::damaged_state>("The saved mesh is cut short: its arrays do not fit together."));
    require_lengths(std::all_of(made_for.sizes.begin(), made_for.sizes.end(), is_length));
    return made_for;
}

std::vector<SizeSource> adopted_sizes_from(const py::dict& arrays) {
    std::vector<SizeSource> sizes;
    read<double>(arrays, "adopted_sizes", sizes);
    require_lengths(std::all_of(sizes.begin(), sizes.end(),
                                [](const SizeSource& s) { return is_finite(s.point) && is_length(s.size); }));
    return sizes;
}

MeshOptions options_made_with(const py::dict& arrays, MeshOptions asked) {
    asked.sizing.refines_narrow_faces = read_one<std::uint8_t>(arrays, "refined_narrow_faces") != 0;
    asked.ignored_below = read_one<double>(arrays, "ignored_below");
    require_lengths(is_length(asked.ignored_below));
    return asked;
}

void define_mesh(py::module_& module) {
    py::class_<PartMesh, std::shared_ptr<PartMesh>>(module, "PartMesh", "A part with its mesh; never changes.")
        .def_property_readonly("order", [](const PartMesh& p) { return p.mesh.order; })
        .def_property_readonly("corner_count", [](const PartMesh& p) { return p.mesh.corner_count; })
        .def("arrays", &arrays_of_part,
             "All arrays of the mesh by name, read-only views; points in mm, indices counted from 0.")
        .def(
            "node_origin",
            [](const py::object& self) { return view<std::int32_t>(self.cast<const PartMesh&>().node_origin, self); },
            "(n,) index of the node in the mesh before the update, -1 for a new one.")
        .def(
            "tet_origin",
            [](const py::object& self) { return view<std::int32_t>(self.cast<const PartMesh&>().tet_origin, self); },
            "(m,) index of the tet in the mesh before the update, -1 for a new one.")
        .def(
            "active_points",
            [](const py::object& self) { return view<double>(self.cast<const PartMesh&>().active_points, self); },
            "(k,3) mm: inner nodes that survived the update as start positions only.")
        .def("wanted_sizes", &wanted_sizes, py::arg("points"),
             "(n,) mm: the edge length that the mesh was to have at each of the points, (n,3) mm.")
        .def("owners_of_faces", &owners_of_each_face, "By face of the final shape: names of the features that own it.")
        .def(
            "labels_of_owners", &labels_of_owners_in_mesh, py::arg("names"),
            "Of faces and edges, by their names: the labels of the features that own it; none where that is not known.")
        .def("owners_of_tets", &tets_of_each_feature,
             "(feature name, numbers of the tets that have their middle in one of its volumes).");
}

}  // namespace featuremesh
