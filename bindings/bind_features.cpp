// SPDX-License-Identifier: GPL-3.0-or-later
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <cstring>

#include "bindings.h"
#include "core/errors.h"
#include "core/messages.h"

namespace featuremesh {

namespace {

RigidMotion motion_from(const py::handle& value) {
    const auto m = value.cast<std::vector<double>>();
    if (m.size() != 16) throw InputError(say<Code::wrong_call>("A placement has 16 numbers."));
    RigidMotion motion;
    motion.rotation = {m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]};
    motion.translation = {m[3], m[7], m[11]};
    return motion;
}

RawRecord record_from(const py::dict& raw) {
    RawRecord record;
    record.name = raw["name"].cast<std::string>();
    record.label = raw["label"].cast<std::string>();
    record.type = raw["type"].cast<std::string>();
    record.proxy = raw["proxy"].cast<std::string>();
    for (const py::handle link : raw["links"]) {
        const auto [property, object, sub] = link.cast<std::tuple<std::string, std::string, std::string>>();
        record.links.push_back({property, object, sub});
    }
    record.placement = motion_from(raw["placement"]);
    record.global_placement = motion_from(raw["global_placement"]);
    record.numbers = raw["numbers"].cast<std::map<std::string, double>>();
    record.texts = raw["texts"].cast<std::map<std::string, std::string>>();
    // States of older versions have none.
    if (raw.contains("measures")) record.measures = raw["measures"].cast<std::map<std::string, std::string>>();
    record.shape = raw["shape"].cast<int>();
    record.own_volume = raw["own_volume"].cast<int>();
    record.suppressed = raw["suppressed"].cast<bool>();
    record.error = raw["error"].cast<std::string>();
    return record;
}

double volume_of(const TopoDS_Shape& shape) {
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties);
    return properties.Mass();
}

const char* name_of_effect(Effect effect) {
    return effect == Effect::adds ? "adds" : effect == Effect::removes ? "removes" : "keeps only";
}

struct OwnedCounts {
    std::vector<int> cells, faces;
};

OwnedCounts count_owned(const FeatureTree& tree, const CellModel& cells) {
    OwnedCounts counts{std::vector<int>(tree.features.size(), 0), std::vector<int>(tree.features.size(), 0)};
    const auto count = [](const std::vector<Owner>& owners, std::vector<int>& into) {
        FeatureId last;
        for (const Owner& owner : owners)
            if (owner.feature != last) ++into[(last = owner.feature).index()];
    };
    for (const Cell& cell : cells.cells) count(cell.owners, counts.cells);
    for (const auto& owners : cells.owners_of_final_face) count(owners, counts.faces);
    return counts;
}

py::dict feature_dict(const FeatureTree& tree, const Feature& feature) {
    py::list depends, volumes;
    for (const FeatureId id : feature.depends_on) depends.append(tree[id].name);
    for (const FeatureVolume& volume : feature.volumes) {
        py::dict entry;
        entry["effect"] = name_of_effect(volume.effect);
        entry["volume"] = volume_of(volume.shape);
        entry["instance"] = volume.instance;
        volumes.append(entry);
    }
    py::dict out;
    out["name"] = feature.name;
    out["label"] = feature.label;
    out["type"] = feature.type;
    out["role"] = to_string(feature.role);
    out["suppressed"] = feature.suppressed;
    out["error"] = feature.error;
    out["depends_on"] = depends;
    out["volume_source"] = feature.volume_source;
    out["volumes"] = volumes;
    return out;
}

py::dict read_tree(const py::dict& raw) {
    const RawDocument document = raw_document_from(raw);
    FeatureTree tree;
    CellModel cells;
    run_released({}, 1, [&](RunContext& context) {
        tree = interpret(document, context);
        cells = build_cells(tree, Brep(tree.final_shape, Dimension::from_shape), context);
    });
    const OwnedCounts owned = count_owned(tree, cells);
    py::list features;
    for (std::size_t i = 0; i < tree.features.size(); ++i) {
        py::dict entry = feature_dict(tree, tree.features[i]);
        entry["owns_cells"] = owned.cells[i];
        entry["owns_faces"] = owned.faces[i];
        features.append(entry);
    }
    py::dict out;
    out["object"] = tree.object;
    out["features"] = features;
    out["cells"] = cells.cells.size();
    out["material_volume"] = cells.report.material_volume;
    out["final_volume"] = cells.report.final_volume;
    std::vector<Message> notes = tree.notes;
    for (const std::string& line : cells.report.fallbacks) notes.push_back(say<Code::cells_otherwise>(line));
    notes.insert(notes.end(), cells.report.findings.begin(), cells.report.findings.end());
    out["notes"] = to_list(notes);
    out["fallbacks"] = cells.report.fallbacks;
    py::list untrusted;
    for (const FeatureId id : cells.report.untrusted) untrusted.append(tree[id].name);
    out["untrusted"] = untrusted;
    return out;
}

double seconds_to_interpret(const py::dict& raw, const std::optional<py::dict>& before) {
    const RawDocument document = raw_document_from(raw), earlier = before ? raw_document_from(*before) : RawDocument{};
    return run_released({}, 1, [&](RunContext& context) {
        std::optional<FeatureTree> known;
        if (before) known = interpret(earlier, context);
        FeatureTree tree;
        {
            const RunContext::Step step(context, "read");
            tree = interpret(document, context, known ? &*known : nullptr);
        }
        return context.seconds().at("read");
    });
}

}  // namespace

RawDocument raw_document_from(const py::dict& raw) {
    RawDocument document;
    document.final_object = raw["final_object"].cast<std::string>();
    for (const py::handle record : raw["records"]) document.records.push_back(record_from(record.cast<py::dict>()));
    const py::bytes bytes = raw["shapes"];
    const std::string_view view = bytes;
    document.shapes.resize(view.size());
    std::memcpy(document.shapes.data(), view.data(), view.size());
    return document;
}

py::object motion_matrix(const RigidMotion& motion) {
    const auto& r = motion.rotation;
    const Vec3& t = motion.translation;
    return py::cast(
        std::vector<double>{r[0], r[1], r[2], t.x, r[3], r[4], r[5], t.y, r[6], r[7], r[8], t.z, 0, 0, 0, 1});
}

void define_features(py::module_& module) {
    module.def("read_tree", &read_tree, py::arg("raw"),
               "The feature tree as the engine understands it, with roles, volumes (mm^3) and owners.");
    module.def("seconds_to_interpret", &seconds_to_interpret, py::arg("raw"), py::arg("before") = py::none(),
               "What the engine adds to the reading of a document: seconds from its records to the feature tree, from "
               "nothing or after the state `before`.");
}

}  // namespace featuremesh
