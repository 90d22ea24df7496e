// SPDX-License-Identifier: BSD-3-Clause
#include "planners/b4p/publication_log.h"

namespace b4p {

PublicationLog::Effects PublicationLog::record(const std::function<void()>& step) {
  struct Recording {
    explicit Recording(bool& on) : on_(on) { on_ = true; }
    ~Recording() { on_ = false; }
    bool& on_;
  };
  effects_.clear();
  ++step_;
  {
    const Recording recording(recording_);
    step();
  }
  return std::exchange(effects_, {});
}

}  // namespace b4p
