// SPDX-License-Identifier: GPL-3.0-or-later
// What was read from a FreeCAD document, before anybody says what it means.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "core/geometry.h"

namespace featuremesh {

struct RawLink {
    std::string property, object, sub_element;
    bool operator==(const RawLink&) const = default;
};

/// One document object that the part depends on.
struct RawRecord {
    std::string name, label, type;  ///< type is FreeCAD's, e.g. "PartDesign::Pad"; "Python:<Proxy class>" is in `proxy`
    std::string proxy;
    std::vector<RawLink> links;                   ///< every object link property, in the order of its list
    RigidMotion placement;                        ///< of the object within its parent
    RigidMotion global_placement;                 ///< from the object's own frame to the final shape's frame
    std::map<std::string, double> numbers;        ///< numeric and boolean parameters (mm, degrees)
    std::map<std::string, std::string> texts;     ///< enumerations
    std::map<std::string, std::string> measures;  ///< of numbers that are a "length" or an "angle"
    int shape = -1;                               ///< index into the shapes: its Shape, in the final shape's frame
    int own_volume = -1;  ///< index into the shapes: its AddSubShape, in the final shape's frame
    bool suppressed = false;
    std::string error;  ///< FreeCAD's own message when the feature is in error
    bool operator==(const RawRecord&) const = default;
};

/// The records in dependency order (what a record links to comes before it) and their shapes.
struct RawDocument {
    std::vector<RawRecord> records;
    std::string final_object;  ///< name of the record whose shape is meshed
    /// One compound whose i-th child is shape i (an empty compound for null), as FreeCAD's `exportBinary` writes it.
    std::vector<std::byte> shapes;
    bool operator==(const RawDocument&) const = default;
};

}  // namespace featuremesh
