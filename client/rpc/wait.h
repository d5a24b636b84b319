// Waits during which gRPC goes on working. Internal to the client library.
//
// Without a server in the process, gRPC works on its connections (connects again, finishes writes)
// only while some thread polls a completion queue. A thread that sleeps would find nothing changed.
// Thread safety: functions without state.
#pragma once

#include <chrono>
#include <functional>

namespace gonio::client {

// Returns at `until`, or as soon as `done()`, which is asked every millisecond.
void wait_until(std::chrono::system_clock::time_point until, const std::function<bool()>& done);

// Returns at `until`.
void wait_until(std::chrono::system_clock::time_point until);

}  // namespace gonio::client
