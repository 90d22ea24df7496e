// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <mutex>
#include <string>
#include <vector>

#include "experiments/certification/certificate.h"
#include "experiments/certification/grasp_examiner.h"

namespace b4p {

/// Measures the certificate of a scene, several grasps at a time. The number of threads changes nothing in
/// it but the times, and what the times decide.
class Certifier {
 public:
  /// The cells that flood fills use, coarse to fine.
  static std::vector<planar::GridSize> standardGrids();

  /// @throws InputError when the robot's files are at fault
  Certifier(const Scene& scene, const CertificateSettings& settings);

  /// Looks at every grasp. @return the certificate, which means nothing when interrupted()
  /// @param threads  >= 1
  Certificate run(unsigned threads);

  /// One line: how far it is, and about how much time is left. Any thread may ask while run() is at work.
  std::string progress() const;

 private:
  void work();
  Certificate assembled() const;

  Scene scene_;
  CertificateSettings settings_;
  GraspExaminer examiner_;
  std::chrono::steady_clock::time_point begin_;

  mutable std::mutex mutex_;  ///< guards what follows
  std::size_t next_ = 0;
  std::size_t done_ = 0;
  std::size_t compatible_ = 0;
  std::vector<Examination> examinations_;
  std::exception_ptr failure_;
};

}  // namespace b4p
