// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace b4p {

/// Lends contexts that only one thread may use at a time. Grows to the largest number in use at once.
template <class Context>
class ContextPool {
 public:
  explicit ContextPool(std::function<std::unique_ptr<Context>()> make) : make_(std::move(make)) {}

  /// A context until the lease ends.
  class Lease {
   public:
    Lease(ContextPool& pool, std::unique_ptr<Context> context) : pool_(pool), context_(std::move(context)) {}
    ~Lease() { pool_.giveBack(std::move(context_)); }
    Lease(const Lease&) = delete;
    Lease& operator=(const Lease&) = delete;
    Context* operator->() const { return context_.get(); }
    Context& operator*() const { return *context_; }

   private:
    ContextPool& pool_;
    std::unique_ptr<Context> context_;
  };

  Lease lease() {
    {
      std::lock_guard<std::mutex> lock(mutex_);
      if (!idle_.empty()) {
        auto context = std::move(idle_.back());
        idle_.pop_back();
        return Lease(*this, std::move(context));
      }
    }
    return Lease(*this, make_());
  }

 private:
  void giveBack(std::unique_ptr<Context> context) {
    std::lock_guard<std::mutex> lock(mutex_);
    idle_.push_back(std::move(context));
  }

  std::function<std::unique_ptr<Context>()> make_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Context>> idle_;
};

}  // namespace b4p
