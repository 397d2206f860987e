// SPDX-License-Identifier: GPL-3.0-or-later
// What a mesh is made of.
#pragma once

namespace featuremesh {

/// The elements that fill a part: segments on its edges, triangles on its faces, or tets in its solids. From the shape:
/// its solids with the faces that bound none of them and the edges that bound no face; without solids its faces,
/// without faces its edges.
enum class Dimension { from_shape, edges, faces, solids };

}  // namespace featuremesh
