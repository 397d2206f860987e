// SPDX-License-Identifier: GPL-3.0-or-later
#include "sizing/sizing_field.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "core/errors.h"
#include "sizing/source_tree.h"

namespace featuremesh {

struct SizingField::Data {
    double size;
    SourceTree tree;
};

SizingField::SizingField(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

double SizingField::at(const Vec3& p) const {
    return data_->tree.empty() ? data_->size : data_->tree.at(p, data_->size);
}
bool SizingField::is_uniform() const { return data_->tree.empty(); }
double SizingField::smallest() const { return std::min(data_->size, data_->tree.smallest()); }
double SizingField::largest() const { return data_->size; }

namespace {

/// A kept node is a source only where its edges are this much shorter than wanted: the scatter of a good mesh is none of the field's business.
constexpr double scatter_of_edge_lengths = 1.4;
/// Tets per cube of the edge length, as the volume step makes them (measured on parts with 5 000 to 350 000 tets).
constexpr double tets_per_cube = 7.1;

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

double longest_side(const Box& box) {
    const Vec3 size = box.size();
    return std::max({size.x, size.y, size.z});
}

void check_size(double size, const Box& part) {
    const Vec3 s = part.size();
    const std::string part_size = number(s.x) + " x " + number(s.y) + " x " + number(s.z) + " mm";
    if (!std::isfinite(size) || size <= 0)
        throw InputError("The mesh size is " + number(size) + " mm; it must be larger than zero. The part is " + part_size + ".");
    if (size > longest_side(part) * (1 + 1e-9))
        throw InputError("The mesh size of " + number(size) + " mm is larger than the part, which is " + part_size + ". Ask for a smaller size.");
}

void check_options(const SizingOptions& options, const Box& part) {
    check_size(options.size, part);
    if (!std::isfinite(options.min_size) || options.min_size < 0 || options.min_size > options.size)
        throw InputError("The smallest mesh size is " + number(options.min_size) + " mm; it must lie between zero and the mesh size of " +
                         number(options.size) + " mm.");
    if (!std::isfinite(options.growth) || options.growth < 1)
        throw InputError("The growth rate is " + number(options.growth) + "; it must be at least 1 (1.3 is usual).");
    if (!std::isfinite(options.elements_per_circle) || options.elements_per_circle < 0)
        throw InputError("The number of elements per circle is " + number(options.elements_per_circle) + "; it must not be negative (0 turns it off).");
    if (!std::isfinite(options.elements_across_gap) || options.elements_across_gap < 0)
        throw InputError("The number of elements across gaps is " + number(options.elements_across_gap) + "; it must not be negative (0 turns it off).");
    for (const LocalSize& local : options.local)
        if (!std::isfinite(local.size) || local.size <= 0)
            throw InputError("The local mesh size at " + name_of(local.entity) + " is " + number(local.size) + " mm; it must be larger than zero.");
}

/// Adds the kept nodes whose mesh is clearly finer than the field asks for.
void add_kept(std::span<const SizeSource> kept, const SizingField::Data& field, std::vector<SourceBall>& sources) {
    for (const SizeSource& source : kept) {
        if (!(source.size > 0) || source.size * scatter_of_edge_lengths >= field.size) continue;
        if (source.size * scatter_of_edge_lengths < field.tree.at(source.point, field.size)) sources.push_back({source.point, 0, source.size});
    }
}

}  // namespace

SizingField make_sizing(const Brep& brep, const SizingOptions& options, std::span<const SizeSource> kept, RunContext& context) {
    check_options(options, brep.box());
    context.check_cancelled();
    auto data = std::make_shared<SizingField::Data>();
    data->size = options.size;
    std::vector<SourceBall> sources;
    const std::size_t before = sources.size();
    add_kept(kept, *data, sources);
    if (sources.size() > before) data->tree = SourceTree(std::move(sources), options.growth - 1);
    return SizingField(std::move(data));
}

double estimate_tets(const Brep& brep, const SizingField& sizing) {
    double volume = 0;
    for (std::size_t s = 0; s < brep.solid_count(); ++s) volume += brep.volume_of(SolidId(s));
    const double size = sizing.smallest();
    return tets_per_cube * volume / (size * size * size);
}

}  // namespace featuremesh
