// SPDX-License-Identifier: GPL-3.0-or-later
#include "sizing/zone_notes.h"

#include <algorithm>
#include <cmath>

#include "core/errors.h"
#include "core/messages.h"
#include "core/numbers_in_words.h"
#include "sizing/zone_field.h"

namespace featuremesh {
namespace {

/// A zone that has some of the part in it has a node within so many of its inner sizes.
constexpr double sizes_to_a_node = 2;
constexpr double same_length = 1e-9;  // relative

template <Code code, class... Values>
void require(bool holds, const SizeZone& zone, Values... values) {
    if (!holds) throw InputError(say<code>(zone.name, values...));
}

bool is_positive(double x) { return std::isfinite(x) && x > 0; }
bool is_not_negative(double x) { return std::isfinite(x) && x >= 0; }

template <Code code>
void require_positive(double measure, const SizeZone& zone) {
    require<code>(is_positive(measure), zone, Length{measure});
}

void check_shape(const SizeZone& zone) {
    if (const auto* box = std::get_if<BoxZone>(&zone.shape)) {
        require_positive<Code::zone_length_not_positive>(box->extent.x, zone);
        require_positive<Code::zone_width_not_positive>(box->extent.y, zone);
        require_positive<Code::zone_height_not_positive>(box->extent.z, zone);
    } else if (const auto* sphere = std::get_if<SphereZone>(&zone.shape)) {
        require_positive<Code::zone_radius_not_positive>(sphere->radius, zone);
    } else if (const auto* cylinder = std::get_if<CylinderZone>(&zone.shape)) {
        require_positive<Code::zone_radius_not_positive>(cylinder->radius, zone);
        require_positive<Code::zone_height_not_positive>(cylinder->height, zone);
    } else if (const auto* near = std::get_if<NearZone>(&zone.shape)) {
        require<Code::zone_reach_negative>(is_not_negative(near->reach), zone, Length{near->reach});
    }
}

Message note_on(const SizeZone& zone, const Brep& brep, const SizingOptions& options, std::span<const Vec3> nodes) {
    if (zone.inner >= options.size)
        return say<Code::zone_changes_nothing>(zone.name, Length{zone.inner}, Length{options.size});
    const ZoneField field(brep, zone, options.size, options.growth - 1);
    if (!field.asks_for_less_than(options.size)) return say<Code::zone_refers_to_nothing>(zone.name);
    const double near = sizes_to_a_node * zone.inner;
    if (std::none_of(nodes.begin(), nodes.end(), [&](const Vec3& p) { return field.distance(p) <= near; }))
        return say<Code::zone_outside>(zone.name);
    const GradedSize& graded = field.graded();
    if (zone.transition > 0 && std::isfinite(graded.transition) &&
        graded.transition > zone.transition * (1 + same_length))
        return say<Code::zone_grows_slower>(zone.name, Length{rounded(graded.outer, 3)},
                                            Length{rounded(graded.transition, 3)}, Length{rounded(zone.transition, 3)},
                                            rounded(options.growth, 3));
    return {};
}

}  // namespace

void check_zone(const SizeZone& zone) {
    require_positive<Code::zone_inner_not_positive>(zone.inner, zone);
    require<Code::zone_outer_negative>(is_not_negative(zone.outer), zone, Length{zone.outer});
    require<Code::zone_coarser_inside>(zone.outer == 0 || zone.outer >= zone.inner, zone, Length{zone.inner},
                                       Length{zone.outer});
    require<Code::zone_transition_negative>(is_not_negative(zone.transition), zone, Length{zone.transition});
    check_shape(zone);
}

std::vector<Message> notes_on_zones(const Brep& brep, const SizingOptions& options, std::span<const Vec3> nodes) {
    std::vector<Message> notes;
    for (const SizeZone& zone : options.zones)
        if (Message note = note_on(zone, brep, options, nodes); !note.empty()) notes.push_back(std::move(note));
    return notes;
}

}  // namespace featuremesh
