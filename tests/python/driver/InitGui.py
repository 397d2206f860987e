# SPDX-License-Identifier: GPL-3.0-or-later
import start_driver  # noqa: F401
