# SPDX-License-Identifier: BSD-3-Clause
"""Plots of benchmark databases and pictures of scenes."""
