// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace b4p {

/// Processor time used so far (s): unlike elapsed time, hardly disturbed by other programs. Only differences
/// mean anything. Any thread may ask; elapsed time on systems that cannot tell.
double threadTime_s();   ///< by the calling thread
double processTime_s();  ///< by all threads of the process

}  // namespace b4p
