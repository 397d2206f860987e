// SPDX-License-Identifier: GPL-3.0-or-later
#include "sizing/zone_notes.h"

#include <algorithm>
#include <cmath>

#include "core/errors.h"
#include "core/numbers_in_words.h"
#include "sizing/zone_field.h"

namespace featuremesh {
namespace {

/// A zone that has some of the part in it has a node within so many of its inner sizes.
constexpr double sizes_to_a_node = 2;
constexpr double same_length = 1e-9;  // relative

struct Measure {
    const char* name;
    double value;
};

std::vector<Measure> measures_of(const SizeZone& zone) {
    if (const auto* box = std::get_if<BoxZone>(&zone.shape))
        return {{"length", box->sides.x}, {"width", box->sides.y}, {"height", box->sides.z}};
    if (const auto* sphere = std::get_if<SphereZone>(&zone.shape)) return {{"radius", sphere->radius}};
    if (const auto* cylinder = std::get_if<CylinderZone>(&zone.shape))
        return {{"radius", cylinder->radius}, {"height", cylinder->height}};
    return {};
}

void require(bool holds, const SizeZone& zone, const std::string& what) {
    if (!holds) throw InputError("The refinement " + zone.name + " " + what);
}

bool is_positive(double x) { return std::isfinite(x) && x > 0; }
bool is_not_negative(double x) { return std::isfinite(x) && x >= 0; }

std::string note_on(const SizeZone& zone, const Brep& brep, const SizingOptions& options, std::span<const Vec3> nodes) {
    const std::string name = "The refinement " + zone.name + " ";
    if (zone.inner >= options.size)
        return name + "changes nothing: its inner size of " + in_words(zone.inner) +
               " mm is not below the mesh size of " + in_words(options.size) + " mm.";
    const ZoneField field(brep, zone, options.size, options.growth - 1);
    if (!field.asks_for_less_than(options.size))
        return name +
               "is left out: the part has nothing of what it refers to. Refer it to a face, an edge or a vertex.";
    const double near = sizes_to_a_node * zone.inner;
    if (std::none_of(nodes.begin(), nodes.end(), [&](const Vec3& p) { return field.distance(p) <= near; }))
        return name + "lies outside the part. Move it into the part, or suppress it.";
    const GradedSize& graded = field.graded();
    if (zone.transition > 0 && std::isfinite(graded.transition) &&
        graded.transition > zone.transition * (1 + same_length))
        return name + "grows to " + in_words(graded.outer, 3) + " mm over " + in_words(graded.transition, 3) +
               " mm, not over " + in_words(zone.transition, 3) +
               " mm: neighbouring elements may differ by a factor of " + in_words(options.growth, 3) +
               " at most (Growth).";
    return {};
}

}  // namespace

void check_zone(const SizeZone& zone) {
    require(is_positive(zone.inner), zone,
            "has an inner size of " + in_words(zone.inner) + " mm; it must be larger than zero.");
    require(is_not_negative(zone.outer), zone,
            "has an outer size of " + in_words(zone.outer) + " mm; it must not be negative (0: the mesh size).");
    require(zone.outer == 0 || zone.outer >= zone.inner, zone,
            "is coarser inside (" + in_words(zone.inner) + " mm) than outside (" + in_words(zone.outer) +
                " mm); exchange the two sizes.");
    require(
        is_not_negative(zone.transition), zone,
        "grows over " + in_words(zone.transition) + " mm; that must not be negative (0: as fast as Growth allows).");
    for (const Measure& measure : measures_of(zone))
        require(is_positive(measure.value), zone,
                std::string("has a ") + measure.name + " of " + in_words(measure.value) +
                    " mm; it must be larger than zero.");
    if (const auto* near = std::get_if<NearZone>(&zone.shape))
        require(is_not_negative(near->reach), zone,
                "reaches " + in_words(near->reach) + " mm; that must not be negative.");
}

std::vector<std::string> notes_on_zones(const Brep& brep, const SizingOptions& options, std::span<const Vec3> nodes) {
    std::vector<std::string> notes;
    for (const SizeZone& zone : options.zones)
        if (std::string note = note_on(zone, brep, options, nodes); !note.empty()) notes.push_back(std::move(note));
    return notes;
}

}  // namespace featuremesh
