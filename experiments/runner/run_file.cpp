// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/runner/run_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <utility>

#include "robots/input_error.h"

namespace b4p {
namespace {

constexpr ::mode_t kReadableByAll = 0644;

[[noreturn]] void failWithReason(const std::string& file, const std::string& problem) {
  throw InputError(file, "", problem + " (" + std::strerror(errno) + ")");
}

}  // namespace

RunFile::RunFile(const std::string& file)
    : file_(file),
      descriptor_(::open(file.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, kReadableByAll)) {
  if (descriptor_ < 0) failWithReason(file_, "cannot be opened");
  try {
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0)
      throw InputError(file_, "", "another b4p bench is writing to it");
    read();
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

RunFile::~RunFile() { ::close(descriptor_); }

void RunFile::read() {
  std::ifstream in(file_, std::ios::binary);
  std::size_t whole = 0;  // bytes of complete lines
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    if (in.eof()) break;  // without its end
    const std::string where = file_ + ", line " + std::to_string(++number);
    RunRecord record = recordFrom(line, where);
    if (find(record.scene, record.label, record.run) != nullptr)
      throw InputError(where, "run", "is there twice");
    records_.push_back(std::move(record));
    whole += line.size() + 1;
  }
  if (::ftruncate(descriptor_, static_cast<::off_t>(whole)) != 0)
    failWithReason(file_, "cannot be shortened");
}

void RunFile::append(RunRecord record) {
  const std::string line = recordLine(record) + "\n";
  for (std::size_t written = 0; written < line.size();) {
    const ::ssize_t more = ::write(descriptor_, line.data() + written, line.size() - written);
    if (more < 0 && errno != EINTR) failWithReason(file_, "cannot be written");
    if (more > 0) written += static_cast<std::size_t>(more);
  }
  if (::fsync(descriptor_) != 0) failWithReason(file_, "cannot be written");
  records_.push_back(std::move(record));
}

const RunRecord* RunFile::find(const std::string& scene, const std::string& label, int run) const {
  const auto found = std::find_if(records_.begin(), records_.end(), [&](const RunRecord& record) {
    return record.run == run && record.label == label && record.scene == scene;
  });
  return found == records_.end() ? nullptr : &*found;
}

}  // namespace b4p
