# SPDX-License-Identifier: GPL-3.0-or-later
# Five places of a hole, solved: ./featuremesh run resources/examples/five_variants.py resources/examples/bracket.FCStd
mesh = api.add_mesh(document.Body, size=4)
api.recompute(document)
print("| hole 6 at x | nodes kept | displacement | stress |\n|---|---|---|---|")
for x in (110, 108, 106, 104, 102):
    api.set_parameters(document, ["HoleSketch.Hole6X=%g" % x])
    api.recompute(document)
    found = api.solve_analysis(document.Analysis)["responses"]
    print("| %g mm | %d %% | %.4f mm | %.1f MPa |" % (x, mesh.KeptNodes, found["max_displacement_mm"], found["max_mises_mpa"]))
