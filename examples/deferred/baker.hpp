#pragma once

#include <atomic>
#include <optional>
#include <thread>

#include "tables.hpp"
#include "world.hpp"

namespace deferred {

/// Bakes tables while something else goes on.
class Baker {
  public:
    Baker() = default;
    ~Baker();
    Baker(const Baker&) = delete;
    Baker& operator=(const Baker&) = delete;

    /// Begins; what was being baked is given up.
    void start(TableKind kind, const World& world);

    bool busy() const {
        return busy_;
    }
    double share() const {
        return share_;
    }  ///< of the work that is done

    /// The tables, once, when they are done.
    std::optional<AirTables> take();

  private:
    void give_up();

    std::thread thread_;
    std::atomic<bool> wanted_{false};
    std::atomic<bool> busy_{false};
    std::atomic<double> share_{0};
    std::optional<AirTables> tables_;  // of the thread while it is busy
};

}  // namespace deferred
