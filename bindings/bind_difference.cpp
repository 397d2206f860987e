// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings.h"

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
    out["detail"] = change.detail;
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

py::dict compare_documents(const py::dict& old_raw, const py::dict& new_raw, double resolution, bool fuse) {
    const RawDocument old_document = raw_document_from(old_raw), new_document = raw_document_from(new_raw);
    std::vector<EdgeChange> edges;
    const FeatureDifference difference = run_released({}, 1, [&](RunContext& context) {
        const auto read = [&](const RawDocument& document, const FeatureTree* known) {
            return fuse ? read_part(document, context, known) : read_part_unfused(document, context, known);
        };
        const PartState old_state = read(old_document, nullptr), new_state = read(new_document, &old_state.tree);
        const double fine = resolution > 0 ? resolution : new_state.brep.box().diagonal() / 100;
        FeatureDifference found = compare(old_state, new_state, fine, context);
        tell_inner_faces(found.faces, old_state.brep, new_state.brep);
        edges = edge_changes(found, old_state.brep, new_state.brep);
        return found;
    });
    py::list edge_list;
    for (const EdgeChange& change : edges) edge_list.append(edge_dict(change));
    py::dict out = to_dict(difference);
    out["edges"] = edge_list;
    return out;
}

}  // namespace

py::dict to_dict(const FeatureDifference& difference) {
    py::list features, faces;
    for (const FeatureChange& change : difference.features) features.append(feature_dict(change));
    for (const FaceChange& change : difference.faces) faces.append(face_dict(change));
    py::dict out;
    out["features"] = features;
    out["faces"] = faces;
    out["notes"] = difference.notes;
    const std::span<const std::array<Vec3, 3>> triangles = difference.regions.empty()
                                                               ? std::span<const std::array<Vec3, 3>>{}
                                                               : difference.regions.front().changed.triangles();
    py::array_t<double> boundary({triangles.size(), std::size_t{3}, std::size_t{3}});
    if (!triangles.empty()) std::memcpy(boundary.mutable_data(), triangles.data(), triangles.size_bytes());
    out["changed_boundary"] = boundary;
    return out;
}

void define_difference(py::module_& module) {
    module.def("compare", &compare_documents, py::arg("old"), py::arg("new"), py::arg("resolution") = 0.0,
               py::arg("fuse") = true,
               "The feature difference of two states of a part. `resolution` (mm): edge length of the changed "
               "boundary's triangles where a face is "
               "trimmed differently; 0 takes a hundredth of the part's diagonal. Without `fuse` no cells are built: "
               "quicker, and owners of faces are found by points of them.");
}

}  // namespace featuremesh
