# SPDX-License-Identifier: GPL-3.0-or-later
"""Parameter studies: many variants of one part, each meshed from one base mesh, solved and compared.

`design` says what is varied, `sampling` which cases there are, `folder` and `database` keep them, `runner` has them run by `worker_process`,
each a FreeCAD of its own (`worker_main`) in which `case_run` makes one case. `answers`, `report` and `optimise` use what came out.
Only base.py, worker_main.py, case_run.py, places.py and solving.py run inside FreeCAD.
"""
