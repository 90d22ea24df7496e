// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace b4p {

/// From now on SIGINT and SIGTERM only set a flag; the second of them ends the process at once.
void catchInterrupts();

/// Whether one of them has come.
bool interrupted();

}  // namespace b4p
