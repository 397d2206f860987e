// SPDX-License-Identifier: GPL-3.0-or-later
#include "update/compare_documents.h"

#include <algorithm>

#include "brep/shape_stream.h"
#include "core/dimension.h"
#include "core/errors.h"
#include "core/messages.h"
#include "update/part_mesh.h"

namespace featuremesh {

namespace {

PartState state_of(const RawDocument& document, const PartState* before, bool builds_cells, RunContext& context) {
    return builds_cells ? read_part(document, context, before ? &before->tree : nullptr)
                        : read_part_to_mesh(document, context, before);
}

Brep brep_of(const RawDocument& document, const std::string& object) {
    const auto record = std::find_if(document.records.begin(), document.records.end(),
                                     [&](const RawRecord& r) { return r.name == object; });
    const std::vector<TopoDS_Shape> shapes = read_shapes(document.shapes);
    if (record == document.records.end() || record->shape < 0 || record->shape >= int(shapes.size()))
        throw InputError(say<Code::wrong_call>("The part has no shape of " + object + "."));
    return Brep(shapes[std::size_t(record->shape)], Dimension::from_shape);
}

}  // namespace

DocumentDifference compare_documents(const RawDocument& old_document, const RawDocument& new_document,
                                     const ComparisonOptions& options, RunContext& context) {
    const PartState old_state = state_of(old_document, nullptr, options.builds_cells, context);
    const PartState new_state = state_of(new_document, &old_state, options.builds_cells, context);
    const double resolution = options.resolution > 0 ? options.resolution : new_state.brep.box().diagonal() / 100;
    DocumentDifference found;
    found.difference = compare(old_state, new_state, resolution, context);
    tell_areas(found.difference.faces, old_state.brep, new_state.brep);
    tell_inner_faces(found.difference.faces, old_state.brep, new_state.brep);
    found.edges = edge_changes(found.difference, old_state.brep, new_state.brep);
    tell_inner_edges(found.edges, old_state.brep, new_state.brep);
    return found;
}

std::vector<FollowedFace> follow_faces_of_documents(const RawDocument& old_document, const SketchElements& old_elements,
                                                    const RawDocument& new_document, const SketchElements& new_elements,
                                                    RunContext& context) {
    const PartState old_state = read_part_to_mesh(old_document, context);
    const PartState new_state = read_part_to_mesh(new_document, context, &old_state);
    return follow_faces(old_state, old_elements, new_state, new_elements);
}

PlacePartners partners_on_final_shape(const RawDocument& document, const std::string& object) {
    return partners_in_place(brep_of(document, object), brep_of(document, document.final_object));
}

}  // namespace featuremesh
