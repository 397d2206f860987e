// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/solid_probe.h"
#include "difference/feature_difference.h"

namespace featuremesh {

void tell_inner_faces(std::vector<FaceChange>& faces, const Brep& old_shape, const Brep& new_shape) {
    const SolidProbe old_probe(old_shape.shape()), new_probe(new_shape.shape());
    for (FaceChange& change : faces) {
        const bool vanished = change.verdict == BoundaryVerdict::vanished;
        if (!vanished && change.verdict != BoundaryVerdict::appeared) continue;
        const auto place = point_on(vanished ? old_shape.face(change.old_face) : new_shape.face(change.new_face));
        change.inner = place && (vanished ? new_probe : old_probe).containment_of(place->point) == Containment::inside;
    }
}

}  // namespace featuremesh
