# SPDX-License-Identifier: GPL-3.0-or-later
"""Parameter studies: many variants of one part, each meshed from one base mesh, solved and compared.

`design` says what is varied, `sampling` which cases there are, `folder` and `database` keep them, `runner` has them run by `worker_process`,
each a FreeCAD of its own (`worker_main`) in which `case_run` makes one case. `answers`, `report` and `optimise` use what came out.
`base`, `worker_main` and what that uses (`case_run`, `case_solver`, `subject`, `places`, `responses`, `mass`), and the document's side (`study_object`,
`dimensions`, `window_run`, `run_main`) run inside FreeCAD, all else in plain Python.
"""
