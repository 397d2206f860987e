// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings.h"
#include "core/errors.h"
#include "core/messages.h"
#include "difference/followed_faces.h"
#include "difference/place_partners.h"
#include "update/compare_documents.h"

namespace featuremesh {

namespace {

const char* name_of_verdict(BoundaryVerdict verdict) {
    switch (verdict) {
        case BoundaryVerdict::kept:
            return "kept";
        case BoundaryVerdict::vanished:
            return "vanished";
        case BoundaryVerdict::appeared:
            return "appeared";
        default:
            return "trimmed differently";
    }
}

py::object face_name(FaceId face) {
    return face.is_valid() ? py::object(py::str(name_of(entity_of(face)))) : py::none();
}

py::list face_names(const std::vector<FaceId>& faces) {
    py::list names;
    for (const FaceId face : faces) names.append(face_name(face));
    return names;
}

py::dict feature_dict(const FeatureChange& change) {
    py::dict out;
    out["name"] = change.name;
    out["label"] = change.label;
    out["verdict"] = to_string(change.verdict);
    out["motion"] = motion_matrix(change.motion);
    out["old_volume"] = change.old_volume;
    out["new_volume"] = change.new_volume;
    out["old_faces"] = face_names(change.old_faces);
    out["new_faces"] = face_names(change.new_faces);
    out["detail"] = to_python(change.detail);
    return out;
}

py::dict face_dict(const FaceChange& change) {
    py::dict out;
    out["verdict"] = name_of_verdict(change.verdict);
    out["old_face"] = face_name(change.old_face);
    out["new_face"] = face_name(change.new_face);
    out["old_area"] = change.old_area;
    out["new_area"] = change.new_area;
    out["inner"] = change.inner;
    out["new_faces"] = face_names(change.new_faces);
    return out;
}

py::dict edge_dict(const EdgeChange& change) {
    const auto edge_name = [](EdgeId edge) {
        return edge.is_valid() ? py::object(py::str(name_of(entity_of(edge)))) : py::none();
    };
    py::dict out;
    out["verdict"] = name_of_verdict(change.verdict);
    out["old_edge"] = edge_name(change.old_edge);
    out["new_edge"] = edge_name(change.new_edge);
    out["old_length"] = change.old_length;
    out["new_length"] = change.new_length;
    out["inner"] = change.inner;
    return out;
}

py::dict compare_raw(const py::dict& old_raw, const py::dict& new_raw, double resolution, bool fuse) {
    const RawDocument old_document = raw_document_from(old_raw), new_document = raw_document_from(new_raw);
    const DocumentDifference difference = run_released({}, 1, [&](RunContext& context) {
        return compare_documents(old_document, new_document, {resolution, fuse}, context);
    });
    py::list edges;
    for (const EdgeChange& change : difference.edges) edges.append(edge_dict(change));
    py::dict out = to_dict(difference.difference);
    out["edges"] = edges;
    return out;
}

SketchElement element_from(int id, const std::vector<double>& numbers) {
    if (numbers.size() != 9 && numbers.size() != 12)
        throw InputError(say<Code::wrong_call>("A sketch element has three points and perhaps a centre."));
    const auto point = [&](std::size_t i) { return Vec3{numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]}; };
    SketchElement element{id, {point(0), point(1), point(2)}, std::nullopt};
    if (numbers.size() == 12) element.centre = point(3);
    return element;
}

SketchElements elements_from(const py::dict& raw) {
    SketchElements elements;
    for (const py::handle item : raw["records"]) {
        const auto record = item.cast<py::dict>();
        if (!record.contains("elements")) continue;
        for (const py::handle entry : record["elements"]) {
            const auto [id, numbers] = entry.cast<std::pair<int, std::vector<double>>>();
            elements[record["name"].cast<std::string>()].push_back(element_from(id, numbers));
        }
    }
    return elements;
}

py::list followed_list(const std::vector<FollowedFace>& faces) {
    py::list out;
    for (const FollowedFace& face : faces) {
        py::dict entry;
        entry["old_face"] = face_name(face.old_face);
        entry["new_faces"] = face_names(face.new_faces);
        entry["within"] = face_names(face.within);
        entry["by"] = to_string(face.by);
        out.append(entry);
    }
    return out;
}

py::list followed_faces_of_meshes(const PartMesh& old_mesh, const py::dict& old_raw, const PartMesh& new_mesh,
                                  const py::dict& new_raw) {
    const SketchElements old_elements = elements_from(old_raw), new_elements = elements_from(new_raw);
    return followed_list(run_released(
        {}, 1, [&](RunContext&) { return follow_faces(old_mesh.part, old_elements, new_mesh.part, new_elements); }));
}

py::list followed_faces_of_documents(const py::dict& old_raw, const py::dict& new_raw) {
    const RawDocument old_document = raw_document_from(old_raw), new_document = raw_document_from(new_raw);
    const SketchElements old_elements = elements_from(old_raw), new_elements = elements_from(new_raw);
    return followed_list(run_released({}, 1, [&](RunContext& context) {
        return follow_faces_of_documents(old_document, old_elements, new_document, new_elements, context);
    }));
}

template <class Id>
void add_names(py::dict& names, std::size_t from, const std::vector<Id>& to) {
    py::list found;
    for (const Id id : to)
        if (id.is_valid()) found.append(name_of(entity_of(id)));
    names[py::str(name_of(entity_of(Id(from))))] = found;
}

py::dict trace_sub_elements(const py::dict& raw, const std::string& object) {
    const RawDocument document = raw_document_from(raw);
    const PlacePartners partners =
        run_released({}, 1, [&](RunContext&) { return partners_on_final_shape(document, object); });
    py::dict names;
    for (std::size_t f = 0; f < partners.faces.size(); ++f) add_names(names, f, partners.faces[f]);
    for (std::size_t e = 0; e < partners.edges.size(); ++e) add_names(names, e, partners.edges[e]);
    for (std::size_t v = 0; v < partners.vertices.size(); ++v)
        add_names(names, v, std::vector<VertexId>{partners.vertices[v]});
    return names;
}

}  // namespace

py::dict to_dict(const FeatureDifference& difference) {
    py::list features, faces;
    for (const FeatureChange& change : difference.features) features.append(feature_dict(change));
    for (const FaceChange& change : difference.faces) faces.append(face_dict(change));
    py::dict out;
    out["features"] = features;
    out["faces"] = faces;
    out["notes"] = to_list(difference.notes);
    const std::span<const std::array<Vec3, 3>> triangles = difference.regions.empty()
                                                               ? std::span<const std::array<Vec3, 3>>{}
                                                               : difference.regions.front().changed.triangles();
    py::array_t<double> boundary({triangles.size(), std::size_t{3}, std::size_t{3}});
    if (!triangles.empty()) std::memcpy(boundary.mutable_data(), triangles.data(), triangles.size_bytes());
    out["changed_boundary"] = boundary;
    return out;
}

void define_difference(py::module_& module) {
    module.def("compare", &compare_raw, py::arg("old"), py::arg("new"), py::arg("resolution") = 0.0,
               py::arg("fuse") = true,
               "The feature difference of two states of a part. `resolution` (mm): edge length of the changed "
               "boundary's triangles where a face is "
               "trimmed differently; 0 takes a hundredth of the part's diagonal. Without `fuse` no cells are built: "
               "quicker, and owners of faces are found by points of them.");
    const char* followed =
        "For every face of the old final shape: the faces that it is in the new one, by the feature and what made it.";
    module.def("followed_faces", &followed_faces_of_meshes, py::arg("old"), py::arg("old_raw"), py::arg("new"),
               py::arg("new_raw"), followed);
    module.def("followed_faces", &followed_faces_of_documents, py::arg("old_raw"), py::arg("new_raw"), followed);
    module.def("trace_sub_elements", &trace_sub_elements, py::arg("raw"), py::arg("object"),
               "By name of every face, edge and vertex of an object that the part is made of: the names of what lies "
               "there on the part's final shape.");
}

}  // namespace featuremesh
