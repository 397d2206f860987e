// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <map>

#include "bindings.h"
#include "core/errors.h"
#include "core/messages.h"
#include "difference/face_owners.h"
#include "update/field_transfer.h"

namespace featuremesh {

namespace {

constexpr std::array<const char*, 4> names_of_dimensions{"from_shape", "edges", "faces", "solids"};

Dimension dimension_from_name(const std::string& name) {
    for (std::size_t i = 0; i < names_of_dimensions.size(); ++i)
        if (name == names_of_dimensions[i]) return Dimension(i);
    throw InputError(say<Code::wrong_call>("The dimension is from_shape, solids, faces or edges, not '" + name + "'."));
}

struct Asked {
    MeshOptions options;
    int threads = 1;
};

template <class T>
T required(const py::dict& values, const char* name) {
    if (!values.contains(name))
        throw InputError(say<Code::wrong_call>(std::string("A zone lacks its '") + name + "'."));
    return values[name].cast<T>();
}

Vec3 vector_from(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

SizeZone zone_from(const py::dict& values) {
    SizeZone zone;
    zone.name = required<std::string>(values, "name");
    zone.inner = required<double>(values, "inner");
    zone.outer = required<double>(values, "outer");
    zone.transition = required<double>(values, "transition");
    const auto shape = required<std::string>(values, "shape");
    if (shape == "near") {
        NearZone near;
        near.entities = entities_from(required<std::vector<std::string>>(values, "entities"));
        near.reach = required<double>(values, "reach");
        zone.shape = std::move(near);
        return zone;
    }
    zone.placement.rotation = required<std::array<double, 9>>(values, "rotation");
    zone.placement.translation = vector_from(required<std::array<double, 3>>(values, "translation"));
    if (shape == "box")
        zone.shape = BoxZone{vector_from(required<std::array<double, 3>>(values, "sides"))};
    else if (shape == "sphere")
        zone.shape = SphereZone{required<double>(values, "radius")};
    else if (shape == "cylinder")
        zone.shape = CylinderZone{required<double>(values, "radius"), required<double>(values, "height")};
    else
        throw InputError(
            say<Code::wrong_call>("A zone is a box, a sphere, a cylinder, or near something, not '" + shape + "'."));
    return zone;
}

SourceBall ball_from(const std::array<double, 5>& values) {
    const auto [x, y, z, radius, size] = values;
    if (!(std::isfinite(x + y + z) && std::isfinite(radius) && radius >= 0 && std::isfinite(size) && size > 0))
        throw InputError(say<Code::wrong_call>("A ball has a centre, a radius that is not negative, and a size."));
    return {{x, y, z}, radius, size};
}

/// Throws InputError for what is negative or no number.
double from_zero(const py::handle& value, const char* option) {
    const double number = value.cast<double>();
    if (!std::isfinite(number) || number < 0)
        throw InputError(
            say<Code::wrong_call>("The mesh option '" + std::string(option) + "' is a number that is not negative."));
    return number;
}

using TakeOption = void (*)(Asked&, const py::handle&);

/// What can be asked for, by its name.
const std::map<std::string, TakeOption>& known_options() {
    static const std::map<std::string, TakeOption> known{
        {"size", [](Asked& a, const py::handle& v) { a.options.sizing.size = v.cast<double>(); }},
        {"min_size", [](Asked& a, const py::handle& v) { a.options.sizing.min_size = v.cast<double>(); }},
        {"elements_per_circle",
         [](Asked& a, const py::handle& v) { a.options.sizing.elements_per_circle = v.cast<double>(); }},
        {"elements_across_gap",
         [](Asked& a, const py::handle& v) { a.options.sizing.elements_across_gap = v.cast<double>(); }},
        {"growth", [](Asked& a, const py::handle& v) { a.options.sizing.growth = v.cast<double>(); }},
        {"order", [](Asked& a, const py::handle& v) { a.options.order = v.cast<int>(); }},
        {"target_dihedral_deg",
         [](Asked& a, const py::handle& v) {
             a.options.volume.target_dihedral_deg = from_zero(v, "target_dihedral_deg");
         }},
        {"keep_margin", [](Asked& a, const py::handle& v) { a.options.keep_margin = from_zero(v, "keep_margin"); }},
        {"most_tets", [](Asked& a, const py::handle& v) { a.options.most_tets = from_zero(v, "most_tets"); }},
        {"ignore_below", [](Asked& a, const py::handle& v) { a.options.ignore_below = v.cast<double>(); }},
        {"dimension",
         [](Asked& a, const py::handle& v) { a.options.dimension = dimension_from_name(v.cast<std::string>()); }},
        {"threads", [](Asked& a, const py::handle& v) { a.threads = v.cast<int>(); }},
        {"local",
         [](Asked& a, const py::handle& v) {
             for (const auto& [name, size] : v.cast<std::vector<std::pair<std::string, double>>>())
                 a.options.sizing.local.push_back({entities_from({name}).front(), size});
         }},
        {"zones",
         [](Asked& a, const py::handle& v) {
             for (const auto& zone : v.cast<std::vector<py::dict>>()) a.options.sizing.zones.push_back(zone_from(zone));
         }},
        {"balls",
         [](Asked& a, const py::handle& v) {
             for (const auto& ball : v.cast<std::vector<std::array<double, 5>>>())
                 a.options.sizing.balls.push_back(ball_from(ball));
         }},
    };
    return known;
}

Asked asked_from(const py::dict& options) {
    Asked asked;
    for (const auto& [key, value] : options) {
        const auto name = key.cast<std::string>();
        const auto known = known_options().find(name);
        if (known == known_options().end())
            throw InputError(say<Code::wrong_call>("Unknown mesh option '" + name + "'."));
        known->second(asked, value);
    }
    if (asked.options.order != 1 && asked.options.order != 2)
        throw InputError(
            say<Code::wrong_call>("The element order is 1 (4-node tetrahedra) or 2 (10-node tetrahedra)."));
    if (asked.threads < 1) throw InputError(say<Code::wrong_call>("The number of threads is at least 1."));
    return asked;
}

py::dict to_dict(const QualityReport& quality) {
    py::dict out;
    out["min_dihedral"] = quality.min_dihedral;
    out["mean_min_dihedral"] = quality.mean_min_dihedral;
    out["max_dihedral"] = quality.max_dihedral;
    out["mean_radius_ratio"] = quality.mean_radius_ratio;
    out["min_radius_ratio"] = quality.min_radius_ratio;
    out["min_scaled_jacobian"] = quality.min_scaled_jacobian;
    out["below_10"] = quality.below_10;
    out["below_20"] = quality.below_20;
    out["below_25"] = quality.below_25;
    out["forced_by_cad"] = quality.forced_by_cad;
    out["min_dihedral_unforced"] = quality.min_dihedral_unforced;
    out["histogram"] = std::vector<std::int64_t>(quality.histogram.begin(), quality.histogram.end());
    return out;
}

py::dict to_dict(const SizeConformity& lengths) {
    py::dict out;
    out["share_within"] = lengths.share_within;
    out["mean"] = lengths.mean;
    out["histogram"] = std::vector<std::int64_t>(lengths.histogram.begin(), lengths.histogram.end());
    return out;
}

py::dict to_dict(const VolumeReport& volume) {
    py::dict out;
    out["new_nodes"] = volume.new_nodes;
    out["new_tets"] = volume.new_tets;
    out["recovered_triangles"] = volume.recovered_triangles;
    out["recovery_points"] = volume.recovery_points;
    out["released_tets"] = volume.released_tets;
    out["released_for_quality"] = volume.released_for_quality;
    out["released_for_shape"] = volume.released_for_shape;
    out["split_wall_tets"] = volume.split_wall_tets;
    out["odt_energy_before"] = volume.odt_energy_before;
    out["odt_energy_after"] = volume.odt_energy_after;
    out["slivers_before"] = volume.slivers_before;
    out["slivers_left"] = volume.slivers_left;
    out["large_cavities"] = volume.large_cavities;
    return out;
}

py::dict kept_dict(const Report& report) {
    py::list motions;
    for (const KeptByMotion& kept : report.kept) {
        py::dict entry;
        entry["motion"] = motion_matrix(kept.motion);
        entry["features"] = kept.features;
        entry["nodes"] = kept.nodes;
        entry["tets"] = kept.tets;
        motions.append(entry);
    }
    py::dict out;
    out["nodes_share"] = report.kept_nodes_share;
    out["tets_share"] = report.kept_tets_share;
    out["active_nodes"] = report.active_nodes;
    out["per_motion"] = motions;
    return out;
}

py::dict to_dict(const Report& report) {
    py::dict out;
    out["nodes"] = report.nodes;
    out["tets"] = report.tets;
    out["triangles"] = report.triangles;
    out["segments"] = report.segments;
    out["dimension"] = names_of_dimensions[std::size_t(report.dimension)];
    out["order"] = report.order;
    out["size"] = report.size;
    out["seconds"] = report.seconds;
    out["peak_memory_mb"] = report.peak_memory_mb;
    out["quality"] = to_dict(report.quality);
    out["lengths"] = to_dict(report.lengths);
    out["kept"] = kept_dict(report);
    out["difference"] = to_dict(report.difference);
    out["volume"] = to_dict(report.volume);
    out["surface"] = py::dict(py::arg("new_nodes") = report.surface.new_nodes,
                              py::arg("new_triangles") = report.surface.new_triangles,
                              py::arg("min_angle") = report.surface.min_angle_deg);
    py::list rounds;
    for (const Round& round : report.rounds)
        rounds.append(py::dict(py::arg("reason") = round.reason, py::arg("place") = names_of_entities(round.place),
                               py::arg("change") = round.change, py::arg("refusal") = to_python(round.refusal)));
    out["rounds"] = rounds;
    out["fallback"] = to_python(several(report.fallbacks));
    out["warnings"] = to_list(report.warnings);
    return out;
}

py::tuple answer(const PartMeshResult& result) {
    return py::make_tuple(std::const_pointer_cast<PartMesh>(result.part_mesh), to_dict(result.report));
}

py::tuple mesh_document(const py::dict& raw, const py::dict& options, const Progress& progress,
                        std::pair<Number, Number> next_numbers) {
    RawDocument document = raw_document_from(raw);
    const Asked asked = asked_from(options);
    const NextNumbers next{next_numbers.first, next_numbers.second};
    if (next.node < 1 || next.element < 1)
        throw InputError(say<Code::wrong_call>("Numbers of nodes and elements start at 1."));
    return answer(run_released(progress, asked.threads, [&](RunContext& context) {
        return mesh_part(std::move(document), asked.options, context, next);
    }));
}

py::tuple update_document(const PartMesh& old, const py::dict& raw, const py::dict& options, const Progress& progress) {
    RawDocument document = raw_document_from(raw);
    const Asked asked = asked_from(options);
    return answer(run_released(progress, asked.threads, [&](RunContext& context) {
        return update_part(old, std::move(document), asked.options, context);
    }));
}

py::tuple adopt_document(const py::dict& raw, const py::dict& options, const py::dict& arrays,
                         const Progress& progress) {
    RawDocument document = raw_document_from(raw);
    const Asked asked = asked_from(options);
    const Mesh foreign = mesh_from(arrays);
    return answer(run_released(progress, asked.threads, [&](RunContext& context) {
        return adopt_part(std::move(document), asked.options, foreign, context);
    }));
}

std::shared_ptr<PartMesh> restore_document(const py::dict& raw, const py::dict& options, const py::dict& arrays,
                                           const Progress& progress) {
    RawDocument document = raw_document_from(raw);
    const Asked asked = asked_from(options);
    const MeshOptions made_with = options_made_with(arrays, asked.options);
    Mesh mesh = mesh_from(arrays);
    MadeFor made_for = made_for_from(arrays);
    std::vector<SizeSource> adopted_sizes = adopted_sizes_from(arrays);
    return std::const_pointer_cast<PartMesh>(run_released(progress, asked.threads, [&](RunContext& context) {
        return restore_part(std::move(document), made_with, std::move(mesh), context, std::move(made_for),
                            std::move(adopted_sizes));
    }));
}

using Table = py::array_t<double, py::array::c_style | py::array::forcecast>;

py::tuple transfer_values(const py::dict& old_arrays, const py::dict& new_arrays, const Table& values,
                          double same_place, int threads) {
    const Mesh old_mesh = mesh_from(old_arrays), new_mesh = mesh_from(new_arrays);
    const bool fits =
        (values.ndim() == 1 || values.ndim() == 2) && std::size_t(values.shape(0)) == old_mesh.node_count();
    if (!fits) throw InputError(say<Code::wrong_call>("Values are (n,) or (n,k) with a row per node of the old mesh."));
    const std::span<const double> rows(values.data(), std::size_t(values.size()));
    const TransferredField field = run_released({}, threads, [&](RunContext& context) {
        return transfer_field(old_mesh, new_mesh, rows, same_place, context);
    });
    std::vector<py::ssize_t> shape{py::ssize_t(new_mesh.node_count())};
    if (values.ndim() == 2) shape.push_back(values.shape(1));
    py::array_t<std::uint8_t> sources(py::ssize_t(field.sources.size()));
    for (std::size_t n = 0; n < field.sources.size(); ++n)
        sources.mutable_at(py::ssize_t(n)) = std::uint8_t(field.sources[n]);
    return py::make_tuple(py::array_t<double>(shape, field.values.data()),
                          py::array_t<double>(shape, field.errors.data()), sources);
}

std::vector<std::vector<std::string>> labels_of_owners_in_document(const py::dict& raw, const py::dict& options,
                                                                   const std::vector<std::string>& names) {
    const RawDocument document = raw_document_from(raw);
    const Dimension dimension = asked_from(options).options.dimension;
    const std::vector<Entity> entities = entities_from(names);
    return run_released({}, 1, [&](RunContext& context) {
        return labels_of_owners(read_part_to_mesh(document, context, nullptr, dimension), entities);
    });
}

double estimate(const py::dict& raw, const py::dict& options) {
    const RawDocument document = raw_document_from(raw);
    const Asked asked = asked_from(options);
    return run_released({}, 1, [&](RunContext& context) { return estimate_part(document, asked.options, context); });
}

}  // namespace

void define_update(py::module_& module) {
    module.def(
        "mesh_part", &mesh_document, py::arg("raw"), py::arg("options"), py::arg("progress") = py::none(),
        py::arg("next_numbers") = std::pair<Number, Number>{1, 1},
        "Meshes the part from scratch, with node and element numbers from `next_numbers` on; (PartMesh, report).");
    module.def("update_part", &update_document, py::arg("old"), py::arg("raw"), py::arg("options"),
               py::arg("progress") = py::none(),
               "Meshes the new state of the part, keeping what did not change; (PartMesh, report). The old PartMesh "
               "stays as it is.");
    module.def("adopt_part", &adopt_document, py::arg("raw"), py::arg("options"), py::arg("arrays"),
               py::arg("progress") = py::none(),
               "Makes another maker's mesh of the part ours, keeping what fits; (PartMesh, report).");
    module.def("restore_part", &restore_document, py::arg("raw"), py::arg("options"), py::arg("arrays"),
               py::arg("progress") = py::none(),
               "The PartMesh whose arrays were saved. Raises StateError when they do not fit the part.");
    module.def("transfer_field", &transfer_values, py::arg("old_arrays"), py::arg("new_arrays"), py::arg("values"),
               py::arg("same_place") = 0.0, py::arg("threads") = 1,
               "Nodal values carried from one mesh to another; (values, error estimates, sources).");
    module.def("labels_of_owners", &labels_of_owners_in_document, py::arg("raw"), py::arg("options"), py::arg("names"),
               "As of a PartMesh, of a part that has no mesh.");
    module.def("estimate_tets", &estimate, py::arg("raw"), py::arg("options"),
               "About how many elements the options ask for: tets, or triangles or segments where those are meshed.");
}

}  // namespace featuremesh
