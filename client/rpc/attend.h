// Waiting in a way that keeps gRPC going. Internal to the client library.
//
// Without a server in the process, gRPC attends to its connections (connects again, finishes and
// gives back what it was writing) only while some thread waits for an event of its; a thread that
// merely sleeps would find nothing changed. Thread safety: functions without state.
#pragma once

#include <chrono>
#include <functional>

namespace gonio::client {

// Returns at `until`, or as soon as `done()`, which is asked every millisecond.
void attend_until(std::chrono::system_clock::time_point until, const std::function<bool()>& done);

// Returns at `until`.
void attend_until(std::chrono::system_clock::time_point until);

}  // namespace gonio::client
