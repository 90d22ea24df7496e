# SPDX-License-Identifier: BSD-3-Clause
"""Readers of the files that the b4p command writes and of the scenes and robots it loads."""
