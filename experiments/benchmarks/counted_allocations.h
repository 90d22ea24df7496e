// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace b4p {

/// How often operator new has been called by this thread in a program with counted_allocations.cpp in it.
std::uint64_t allocations();

}  // namespace b4p
