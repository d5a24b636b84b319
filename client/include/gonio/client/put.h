// Storing measured materials on a server: see Client::put_material. Thread safety: plain values.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace gonio::client {

enum class PutPlace : std::uint8_t {
  folder,  // the server's materials folder: it is there again when the server has been restarted
  memory,  // the server's memory: there is no such folder, or the server may not write to it
};

struct PutReport {
  PutPlace place = PutPlace::memory;
  std::uint64_t cells = 0, invalid_cells = 0;  // of the table; those that hold no measurement
  bool existed = false;                        // the same bytes had been put under this name before
  std::string sha256;                          // of the content, 64 hexadecimal digits
  int retries = 0;                             // times that it was sent again after a pause
};

struct PutWatch {
  std::function<void(double)> progress;               // the part that is sent, 0 to 1
  std::function<bool()> stop;                         // asked between chunks: true ends the upload
  std::optional<std::chrono::milliseconds> deadline;  // in place of ClientOptions::deadline
};

}  // namespace gonio::client
