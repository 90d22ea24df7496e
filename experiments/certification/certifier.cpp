// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/certification/certifier.h"

#include <exception>
#include <sstream>
#include <thread>
#include <utility>

#include <ompl/util/Console.h>

#include "experiments/certification/digest.h"
#include "experiments/interrupt.h"

namespace b4p {

std::vector<planar::GridSize> Certifier::standardGrids() { return {{0.02, 128}, {0.01, 256}, {0.005, 512}}; }

Certifier::Certifier(const Scene& scene, const CertificateSettings& settings)
    : scene_(scene),
      settings_(settings),
      examiner_(scene, settings),
      begin_(std::chrono::steady_clock::now()),
      examinations_(examiner_.grasps().size()) {
  ompl::msg::noOutputHandler();
  if (!examiner_.whyNoProof().empty()) settings_.grids.clear();
  settings_.grasps = static_cast<int>(examiner_.grasps().size());
}

Certificate Certifier::run(unsigned threads) {
  std::vector<std::thread> workers;
  for (unsigned i = 0; i < threads; ++i) workers.emplace_back([this] { work(); });
  for (std::thread& worker : workers) worker.join();
  if (failure_) std::rethrow_exception(failure_);
  return assembled();
}

void Certifier::work() {
  for (;;) {
    std::size_t id = 0;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (next_ == examinations_.size() || failure_ || interrupted()) return;
      id = next_++;
    }
    try {
      Examination examination = examiner_.examine(static_cast<int>(id));
      const std::lock_guard<std::mutex> lock(mutex_);
      ++done_;
      if (examination.record.status == GraspStatus::kCompatible) ++compatible_;
      examinations_[id] = std::move(examination);
    } catch (...) {
      const std::lock_guard<std::mutex> lock(mutex_);
      failure_ = std::current_exception();
    }
  }
}

std::string Certifier::progress() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const double spent_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  std::ostringstream line;
  line.precision(0);
  line << std::fixed << done_ << " of " << examinations_.size() << " grasps, " << compatible_
       << " compatible, " << spent_s << " s";
  if (done_ > 0)
    line << ", about "
         << spent_s / static_cast<double>(done_) * static_cast<double>(examinations_.size() - done_)
         << " s left";
  return line.str();
}

Certificate Certifier::assembled() const {
  Certificate certificate;
  certificate.scene = scene_.name;
  certificate.digest = sceneDigest(scene_);
  certificate.settings = settings_;
  for (const Examination& examination : examinations_) {
    certificate.grasps.push_back(examination.record);
    if (!examination.pick_failure.empty()) ++certificate.pick_failures[examination.pick_failure];
    for (const auto& [reason, count] : examination.placement_failures)
      certificate.placement_failures[reason] += count;
    const auto& path = examination.path;
    // The shortest will do, and keeps the file small.
    if (path && (!certificate.witness || path->path.size() < certificate.witness->path.size()))
      certificate.witness = path;
  }
  certificate.numbers = numbersOf(certificate.grasps);
  if (!examiner_.finite()) certificate.bins = binsOf(certificate.grasps, scene_.pickPlace().object);
  return certificate;
}

}  // namespace b4p
